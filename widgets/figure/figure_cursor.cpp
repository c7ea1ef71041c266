#include "widgets/figure/figure_cursor.h"

#include "control/base/unit_text.h"
#include "widgets/figure/figure_scales.h"
#include "widgets/language/display_units.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double MarkerReach_px = 4.0;
constexpr double Row_px = 15.0;
constexpr double Swatch_px = 14.0;

QString amountText(const Axis& axis, double value) {
    const QString unit = QString::fromStdString(unitText(axis.unit));
    const QString number = numberText(value, 4);
    return unit.isEmpty() ? number : number + QLatin1Char(' ') + unit;
}

bool isNamedIn(const Panel& panel, const std::string& label) {
    return std::any_of(panel.curves.begin(), panel.curves.end(),
                       [&](const Curve& each) { return each.label == label; });
}

/// A panel may leave its curves to the legend of another.
std::string nameOf(const Figure& figure, const Panel& panel, const Curve& curve) {
    if (!curve.label.empty()) {
        return curve.label;
    }
    for (const Panel& other : figure.panels) {
        for (const Curve& each : other.curves) {
            if (!each.label.empty() && each.colour == curve.colour && each.style == curve.style) {
                return isNamedIn(panel, each.label) ? std::string() : each.label;
            }
        }
    }
    return {};
}

bool isRead(const Figure& figure, std::size_t panel, std::size_t curve) {
    const Panel& in = figure.panels[panel];
    const Curve& each = in.curves[curve];
    const auto isOther = [](const Curve& one) { return one.style != CurveStyle::Band; };
    const bool isAlone = std::count_if(in.curves.begin(), in.curves.end(), isOther) == 1;
    const bool hasPlace = figure.isLinked || each.parameter.size() == each.x.size();
    return isOther(each) && hasPlace && !each.x.empty() &&
           (isAlone || !figure.isLinked || !nameOf(figure, in, each).empty());
}

const std::vector<double>& alongIn(const Figure& figure, const Curve& curve) {
    return figure.isLinked ? curve.x : curve.parameter;
}

/// A logarithmic axis measures in ratios.
double measure(const Axis& axis, double value) {
    return axis.isLogarithmic ? std::log(value) : value;
}

std::size_t nearestSample(const std::vector<double>& values, const Axis& axis, double value) {
    std::size_t nearest = 0;
    double least = INFINITY;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double away = std::abs(measure(axis, values[i]) - measure(axis, value));
        if (away < least) {
            least = away;
            nearest = i;
        }
    }
    return nearest;
}

/// On the straight line between its neighbours; not a number beyond the curve and in its gaps.
double between(const Curve& curve, const Axis& axis, double x) {
    const auto after = std::lower_bound(curve.x.begin(), curve.x.end(), x);
    if (after == curve.x.end()) {
        return NAN;
    }
    const auto i = static_cast<std::size_t>(after - curve.x.begin());
    if (*after == x || i == 0) {
        return *after == x ? curve.y[i] : NAN;
    }
    const double from = measure(axis, curve.x[i - 1]);
    const double share = (measure(axis, x) - from) / (measure(axis, curve.x[i]) - from);
    return curve.y[i - 1] + share * (curve.y[i] - curve.y[i - 1]);
}

std::optional<CursorReading> readingOf(const Figure& figure, const QwtScaleMap& map, const Curve& curve,
                                       double along) {
    if (figure.isLinked && !isMarkers(curve.style)) {
        const double y = between(curve, figure.x, along);
        return std::isfinite(y) ? std::optional(CursorReading{0, along, y, {}}) : std::nullopt;
    }
    const std::vector<double>& values = alongIn(figure, curve);
    const std::size_t i = nearestSample(values, *alongAxis(figure), along);
    const bool isNear =
        !figure.isLinked || std::abs(map.transform(values[i]) - map.transform(along)) <= MarkerReach_px;
    const bool isNumber = std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]);
    return isNear && isNumber ? std::optional(CursorReading{0, curve.x[i], curve.y[i], {}}) : std::nullopt;
}

QString valueText(const Figure& figure, const Panel& panel, const CursorReading& reading) {
    const QString y = amountText(panel.y, reading.y);
    return figure.isLinked
               ? y
               : QStringLiteral("%1 %2, %3 %4")
                     .arg(QString::fromStdString(figure.x.quantity), amountText(figure.x, reading.x),
                          QString::fromStdString(panel.y.quantity), y);
}

QString alongText(const Figure& figure, double along) {
    const Axis& axis = *alongAxis(figure);
    return QString::fromStdString(axis.quantity) + QLatin1Char(' ') + amountText(axis, along);
}

QColor colourOf(const Panel& panel, std::size_t curve, const Theme& theme) {
    const auto role = static_cast<std::size_t>(panel.curves[curve].colour.value_or(static_cast<int>(curve)));
    return theme.curves[role % theme.curves.size()];
}

/// Beside the line, on the side that has room; no more rows than the panel has.
void drawBox(QPainter& painter, const Panel& panel, const QRectF& canvas, double x_px, QString heading,
             const std::vector<CursorReading>& readings, const Theme& theme) {
    const QFontMetricsF metrics(figureFont());
    double width_px = heading.isEmpty() ? 0.0 : metrics.horizontalAdvance(heading);
    for (const CursorReading& reading : readings) {
        width_px = std::max(width_px, Swatch_px + metrics.horizontalAdvance(reading.text));
    }
    const std::size_t most = std::max<std::size_t>(1, static_cast<std::size_t>(canvas.height() / Row_px));
    const std::size_t rows = std::min(most, readings.size() + (heading.isEmpty() ? 0U : 1U));
    if (rows == 0 || width_px == 0.0) {
        return;
    }
    const QSizeF size(width_px + 10.0, Row_px * static_cast<double>(rows) + 4.0);
    const bool fitsRight = x_px + 6.0 + size.width() <= canvas.right();
    const double left_px = fitsRight ? x_px + 6.0 : std::max(canvas.left(), x_px - 6.0 - size.width());
    const QRectF box(QPointF(left_px, canvas.bottom() - size.height() - 3.0), size);
    painter.setPen(QPen(theme.line, 1.0));
    painter.setBrush(theme.raised);
    painter.drawRoundedRect(box, 3.0, 3.0);
    double baseline_px = box.top() + Row_px - 2.0;
    std::size_t row = 0;
    if (!heading.isEmpty()) {
        painter.setPen(theme.text);
        painter.drawText(QPointF(box.left() + 5.0, baseline_px), heading);
        baseline_px += Row_px;
        ++row;
    }
    for (auto reading = readings.begin(); reading != readings.end() && row < rows; ++reading, ++row) {
        painter.setPen(QPen(colourOf(panel, reading->curve, theme), 2.0));
        painter.drawLine(QPointF(box.left() + 5.0, baseline_px - 4.0),
                         QPointF(box.left() + 1.0 + Swatch_px, baseline_px - 4.0));
        painter.setPen(theme.text);
        painter.drawText(QPointF(box.left() + 5.0 + Swatch_px, baseline_px), reading->text);
        baseline_px += Row_px;
    }
}

void drawRing(QPainter& painter, const QPointF& centre, const Theme& theme) {
    painter.setPen(QPen(theme.text, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre, 4.5, 4.5);
}

} // namespace

const Axis* alongAxis(const Figure& figure) {
    return figure.isLinked ? &figure.x : figure.parameter ? &*figure.parameter : nullptr;
}

std::optional<double> alongOf(const Figure& figure, const FigurePoint& point) {
    if (alongAxis(figure) == nullptr || point.panel >= figure.panels.size() ||
        point.curve >= figure.panels[point.panel].curves.size()) {
        return std::nullopt;
    }
    const std::vector<double>& values = alongIn(figure, figure.panels[point.panel].curves[point.curve]);
    return point.index < values.size() ? std::optional(values[point.index]) : std::nullopt;
}

std::optional<FigurePoint> pointAlong(const Figure& figure, double value, const FigurePoint& wanted) {
    if (alongAxis(figure) == nullptr || figure.panels.empty()) {
        return std::nullopt;
    }
    const std::size_t panel = std::min(wanted.panel, figure.panels.size() - 1);
    const std::vector<Curve>& curves = figure.panels[panel].curves;
    std::vector<std::size_t> order = {wanted.curve};
    for (std::size_t curve = 0; curve < curves.size(); ++curve) {
        order.push_back(curve);
    }
    for (const std::size_t curve : order) {
        if (curve < curves.size() && isRead(figure, panel, curve)) {
            return FigurePoint{panel, curve,
                               nearestSample(alongIn(figure, curves[curve]), *alongAxis(figure), value)};
        }
    }
    return std::nullopt;
}

std::vector<CursorReading> readingsAt(const Figure& figure, const FigureLayout& layout, std::size_t panel,
                                      double along) {
    std::vector<CursorReading> readings;
    const QRectF& canvas = layout.panels[panel].canvas;
    const QwtScaleMap map = horizontalScale(figure, canvas.width()).map(canvas.left(), canvas.right());
    const Panel& in = figure.panels[panel];
    for (std::size_t i = 0; i < in.curves.size(); ++i) {
        auto reading = isRead(figure, panel, i) ? readingOf(figure, map, in.curves[i], along) : std::nullopt;
        if (reading) {
            const QString name = QString::fromStdString(nameOf(figure, in, in.curves[i]));
            const QString value = valueText(figure, in, *reading);
            reading->curve = i;
            reading->text = name.isEmpty() ? value : name + QStringLiteral(": ") + value;
            readings.push_back(std::move(*reading));
        }
    }
    return readings;
}

QString cursorText(const Figure& figure, const FigureLayout& layout, double along) {
    QStringList parts = {alongText(figure, along)};
    for (std::size_t panel = 0; panel < figure.panels.size(); ++panel) {
        QStringList values;
        for (const CursorReading& reading : readingsAt(figure, layout, panel, along)) {
            values << reading.text;
        }
        if (!values.isEmpty()) {
            const QString all = values.join(QStringLiteral(", "));
            parts << (figure.isLinked
                          ? QString::fromStdString(figure.panels[panel].y.quantity) + QLatin1Char(' ') + all
                          : all);
        }
    }
    return parts.join(QStringLiteral("; "));
}

void drawCursor(QPainter& painter, const Figure& figure, const FigureLayout& layout, double along,
                const Theme& theme) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(figureFont());
    QString heading = alongText(figure, along);
    for (std::size_t panel = 0; panel < figure.panels.size(); ++panel) {
        const QRectF& canvas = layout.panels[panel].canvas;
        const Panel& in = figure.panels[panel];
        const QwtScaleMap x = horizontalScale(figure, canvas.width()).map(canvas.left(), canvas.right());
        const QwtScaleMap y = verticalScale(in, canvas.height()).map(canvas.bottom(), canvas.top());
        const std::vector<CursorReading> readings = readingsAt(figure, layout, panel, along);
        double line_px = figure.isLinked ? x.transform(along) : canvas.left();
        if (figure.isLinked) {
            painter.setPen(QPen(theme.text, 1.0));
            painter.drawLine(QPointF(line_px, canvas.top()), QPointF(line_px, canvas.bottom()));
        }
        for (const CursorReading& reading : readings) {
            const QPointF place(x.transform(reading.x), y.transform(reading.y));
            if (canvas.contains(place)) {
                drawRing(painter, place, theme);
            }
        }
        drawBox(painter, in, canvas, line_px, heading, readings, theme);
        heading.clear(); // once
    }
}

} // namespace halbench::widgets
