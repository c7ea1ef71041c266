#include "widgets/figure/figure_probe.h"

#include "control/base/unit_text.h"
#include "widgets/figure/figure_scales.h"
#include "widgets/language/display_units.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

/// The words of this file for the translator.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::widgets::FigureProbe)
};

/// Pixel places of one panel's samples.
struct PanelMaps {
    QwtScaleMap x;
    QwtScaleMap y;
    QRectF canvas;

    PanelMaps(const Figure& figure, const FigureLayout& layout, std::size_t panel)
        : x(horizontalScale(figure, layout.panels[panel].canvas.width())
                .map(layout.panels[panel].canvas.left(), layout.panels[panel].canvas.right())),
          y(verticalScale(figure.panels[panel], layout.panels[panel].canvas.height())
                .map(layout.panels[panel].canvas.bottom(), layout.panels[panel].canvas.top())),
          canvas(layout.panels[panel].canvas) {}

    std::optional<QPointF> place(const Curve& curve, std::size_t index) const {
        const QPointF point(x.transform(curve.x[index]), y.transform(curve.y[index]));
        constexpr double Rim_px = 1.0; // a crest that touches the frame is still seen
        const bool isSeen = std::isfinite(point.x()) && std::isfinite(point.y()) &&
                            canvas.adjusted(-Rim_px, -Rim_px, Rim_px, Rim_px).contains(point);
        return isSeen ? std::optional(point) : std::nullopt;
    }
};

QString amountText(const Axis& axis, double value) {
    const QString unit = QString::fromStdString(unitText(axis.unit));
    const QString number = numberText(value, 4);
    return unit.isEmpty() ? number : number + QLatin1Char(' ') + unit;
}

QString curveText(const Curve& curve) {
    return QString::fromStdString(curve.label);
}

bool isReadable(const Panel& panel, const Curve& curve) {
    const auto lines = std::count_if(panel.curves.begin(), panel.curves.end(),
                                     [](const Curve& each) { return each.style != CurveStyle::Band; });
    return curve.style != CurveStyle::Band && (!curve.label.empty() || lines == 1);
}

QString panelSummary(const Panel& panel) {
    double low = INFINITY;
    double high = -INFINITY;
    QStringList curves;
    for (const Curve& curve : panel.curves) {
        for (const double value : curve.style == CurveStyle::Band ? std::vector<double>() : curve.y) {
            low = std::isfinite(value) ? std::min(low, value) : low;
            high = std::isfinite(value) ? std::max(high, value) : high;
        }
        if (!curve.label.empty()) {
            curves << curveText(curve);
        }
    }
    QString text = QString::fromStdString(panel.y.quantity);
    if (low <= high) {
        text = Words::tr("%1 from %2 to %3").arg(text, amountText(panel.y, low), amountText(panel.y, high));
    }
    return curves.isEmpty() ? text : text + QStringLiteral(" (") + curves.join(QStringLiteral(", ")) + ')';
}

} // namespace

std::optional<QPointF> placeOf(const Figure& figure, const FigureLayout& layout, const FigurePoint& point) {
    const Curve& curve = figure.panels[point.panel].curves[point.curve];
    return PanelMaps(figure, layout, point.panel).place(curve, point.index);
}

std::optional<FigurePoint> nearestPoint(const Figure& figure, const FigureLayout& layout, const QPointF& at,
                                        double reach_px) {
    std::optional<FigurePoint> nearest;
    double distance2 = reach_px * reach_px;
    for (std::size_t panel = 0; panel < figure.panels.size(); ++panel) {
        const PanelMaps maps(figure, layout, panel);
        const std::vector<Curve>& curves = figure.panels[panel].curves;
        for (std::size_t curve = 0; curve < curves.size(); ++curve) {
            const std::size_t count =
                isReadable(figure.panels[panel], curves[curve]) ? curves[curve].x.size() : 0;
            for (std::size_t i = 0; i < count; ++i) {
                const auto place = maps.place(curves[curve], i);
                const QPointF away = place.value_or(QPointF(1e9, 1e9)) - at;
                const double found2 = QPointF::dotProduct(away, away);
                if (found2 <= distance2) {
                    distance2 = found2;
                    nearest = FigurePoint{panel, curve, i};
                }
            }
        }
    }
    return nearest;
}

FigurePoint neighbour(const Figure& figure, const FigureLayout& layout, const FigurePoint& point, int steps) {
    const Curve& curve = figure.panels[point.panel].curves[point.curve];
    const PanelMaps maps(figure, layout, point.panel);
    const auto last = static_cast<std::ptrdiff_t>(curve.x.size()) - 1;
    for (auto i = static_cast<std::ptrdiff_t>(point.index) + steps; i >= 0 && i <= last; i += steps) {
        if (maps.place(curve, static_cast<std::size_t>(i))) {
            return {point.panel, point.curve, static_cast<std::size_t>(i)};
        }
    }
    return point;
}

QString pointText(const Figure& figure, const FigurePoint& point) {
    const Panel& panel = figure.panels[point.panel];
    const Curve& curve = panel.curves[point.curve];
    const QString place =
        QStringLiteral("%1 %2, %3 %4")
            .arg(QString::fromStdString(figure.x.quantity), amountText(figure.x, curve.x[point.index]),
                 QString::fromStdString(panel.y.quantity), amountText(panel.y, curve.y[point.index]));
    return curve.label.empty() ? place : curveText(curve) + QStringLiteral(": ") + place;
}

QString figureSummary(const Figure& figure) {
    QStringList parts;
    for (const Panel& panel : figure.panels) {
        parts << panelSummary(panel);
    }
    return Words::tr("Against %1: %2")
        .arg(QString::fromStdString(figure.x.quantity), parts.join(QStringLiteral("; ")));
}

} // namespace halbench::widgets
