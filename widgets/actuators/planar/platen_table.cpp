#include "widgets/actuators/planar/platen_table.h"

#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace halbench::widgets {

namespace {

constexpr double Width_characters = 34.0;
constexpr double Heading_rows = 1.6; ///< with the space above it
constexpr int AllRows = 20;          ///< of the five groups
constexpr int Groups = 5;
constexpr double Warm_ratio = 0.8; ///< of a limit: from here on it is said in the colour of warnings
constexpr double Ambient_degC = 25.0;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::widgets::PlatenTable)
};

/// Rows from top to bottom: a name, then columns of equal width that end at the right border.
class Rows {
public:
    Rows(QPainter& painter, const Theme& theme, const QRectF& place, bool isStale)
        : m_painter(painter), m_theme(theme), m_place(place), m_metrics(painter.font()), m_top(place.top()),
          m_ink(isStale ? theme.muted : theme.text) {
        const double column_px = platenTableWidth_px(m_metrics);
        if (place.width() > 1.5 * column_px) {
            m_place.setWidth(0.5 * place.width() - PanelMargin_px);
            m_next = m_place.translated(0.5 * place.width() + PanelMargin_px, 0.0);
        }
    }

    /// Whether a group of so many rows finds room; begins it with its heading.
    bool begin(int rows, const QString& heading, const QString& first, const QString& second) {
        const double needed = (rows + Heading_rows) * height();
        if (m_top + needed > m_place.bottom() && m_next.width() > 1.0) {
            m_place = std::exchange(m_next, QRectF());
            m_top = m_place.top();
        }
        if (m_top + needed > m_place.bottom()) {
            m_top = m_place.bottom();
            return false;
        }
        m_top += 0.4 * height();
        m_painter.setPen(m_theme.muted);
        m_painter.drawText(line(), Qt::AlignLeft | Qt::AlignVCenter, heading);
        m_painter.drawText(cell(0), Qt::AlignRight | Qt::AlignVCenter, first);
        m_painter.drawText(cell(1), Qt::AlignRight | Qt::AlignVCenter, second);
        m_top += height();
        m_painter.setPen(QPen(m_theme.line, 1.0));
        m_painter.drawLine(QPointF(m_place.left(), m_top), QPointF(m_place.right(), m_top));
        return true;
    }
    void name(const QString& text) {
        m_painter.setPen(m_theme.muted);
        m_painter.drawText(line(), Qt::AlignLeft | Qt::AlignVCenter, text);
    }
    void value(int column, const QString& text, const QColor& ink) {
        m_painter.setPen(ink);
        m_painter.drawText(cell(column), Qt::AlignRight | Qt::AlignVCenter, text);
    }
    void value(int column, const QString& text) { value(column, text, m_ink); }
    /// A bar behind the next value: -1 to 1 from the middle, or 0 to 1 from the left.
    void bar(int column, double share, bool hasSign, const QColor& ink) {
        const QRectF full = cell(column).adjusted(6.0, 3.0, 2.0, -3.0);
        m_painter.fillRect(full, m_theme.raised);
        const double part = std::clamp(share, -1.0, 1.0);
        const double zero = hasSign ? full.center().x() : full.left();
        const double end = zero + part * (hasSign ? 0.5 : 1.0) * full.width();
        m_painter.fillRect(QRectF(QPointF(zero, full.top()), QPointF(end, full.bottom())).normalized(),
                           mixed(m_theme.raised, ink, 0.45));
    }
    void next() { m_top += height(); }

private:
    double height() const { return m_metrics.height() + 2.0; }
    QRectF line() const { return {m_place.left(), m_top, m_place.width(), height()}; }
    QRectF cell(int column) const {
        const double width = 0.39 * m_place.width();
        return {m_place.right() - (2 - column) * width, m_top, width, height()};
    }

    QPainter& m_painter;
    const Theme& m_theme;
    QRectF m_place; ///< of the column
    QRectF m_next;  ///< of another one, if there is room
    QFontMetricsF m_metrics;
    double m_top;
    QColor m_ink;
};

QString withUnit(double value, int decimals, const char* unit) {
    return fixedText(value, decimals) + QLatin1Char(' ') + QString::fromUtf8(unit);
}

QString withUnit(const std::optional<double>& value, int decimals, const char* unit) {
    return value ? withUnit(*value, decimals, unit) : fixedText(std::nullopt, decimals);
}

void poseRows(Rows& rows, const PlatenReadings& readings) {
    if (!rows.begin(3, Words::tr("Pose"), {}, Words::tr("error"))) {
        return;
    }
    const QString unknown = fixedText(std::nullopt, 0);
    const auto row = [&](const char* name, auto member, const char* unit, const char* fineUnit) {
        rows.name(QString::fromUtf8(name));
        const bool isKnown = readings.pose.has_value();
        const double pose = isKnown ? (*readings.pose).*member : 0.0;
        rows.value(0, isKnown ? withUnit(1e3 * pose, 3, unit) : unknown);
        const bool isControlled = isKnown && readings.reference;
        const double reference = isControlled ? (*readings.reference).*member : 0.0;
        rows.value(1, isControlled ? withUnit(1e6 * (reference - pose), 1, fineUnit) : unknown);
        rows.next();
    };
    row("x", &models::PlanarPose::x_m, "mm", "µm");
    row("y", &models::PlanarPose::y_m, "mm", "µm");
    row("φ", &models::PlanarPose::angle_rad, "mrad", "µrad");
}

void coilRows(Rows& rows, const Theme& theme, const PlatenNumbers& numbers) {
    const PlatenSettings& settings = numbers.settings;
    const PlatenReadings& readings = numbers.readings;
    const QString currents = Words::tr("±%1 A").arg(numberText(settings.currentLimit_A, 3));
    const QString heats = Words::tr("to %1 °C").arg(numberText(settings.temperatureLimit_degC, 3));
    if (!rows.begin(models::CoilCount, Words::tr("Coil"), currents, heats)) {
        return;
    }
    for (int k = 0; k < models::CoilCount; ++k) {
        rows.name(QString::number(k + 1));
        const double current_A = readings.current_A ? (*readings.current_A)(k) : 0.0;
        const double share = current_A / settings.currentLimit_A;
        rows.bar(0, share, true, theme.curves[share >= 0.0 ? 1 : 0]);
        rows.value(0, readings.current_A ? withUnit(current_A, 3, "A") : fixedText(std::nullopt, 0));
        const auto heat_degC = readings.temperature_degC[static_cast<std::size_t>(k)];
        const double heat = (heat_degC.value_or(Ambient_degC) - Ambient_degC) /
                            std::max(settings.temperatureLimit_degC - Ambient_degC, 1.0);
        rows.bar(1, std::max(heat, 0.0), false, heat > Warm_ratio ? theme.warn : theme.curves[5]);
        rows.value(1, withUnit(heat_degC, 1, "°C"));
        rows.next();
    }
}

void chipRows(Rows& rows, const Theme& theme, const PlatenNumbers& numbers) {
    const PlatenReadings& readings = numbers.readings;
    if (!rows.begin(models::ChipCount + 1, Words::tr("Residual"), QStringLiteral("x'"),
                    QStringLiteral("y'"))) {
        return;
    }
    const bool areKnown = readings.pose && readings.field_T && readings.current_A;
    const models::ChipFields_T residual_T =
        areKnown ? fieldResidual_T(numbers.settings, *readings.pose, *readings.field_T, *readings.current_A)
                 : models::ChipFields_T(models::ChipFields_T::Zero());
    for (int j = 0; j < models::ChipCount; ++j) {
        rows.name(Words::tr("Chip %1").arg(j + 1));
        if (!readings.used[static_cast<std::size_t>(j)]) {
            rows.value(1, Words::tr("excluded"), theme.bad);
        } else {
            for (int i = 0; i < 2; ++i) {
                rows.value(i, areKnown ? withUnit(1e6 * residual_T(2 * j + i), 0, "µT")
                                       : fixedText(std::nullopt, 0));
            }
        }
        rows.next();
    }
    rows.name(Words::tr("Chi-square"));
    rows.value(1, fixedText(readings.chiSquare, 1));
    rows.next();
}

void forceRows(Rows& rows, const Theme& theme, const PlatenNumbers& numbers) {
    if (!rows.begin(3, Words::tr("Force"), QStringLiteral("x"), QStringLiteral("y"))) {
        return;
    }
    const bool areKnown = numbers.forces.has_value();
    const PlatenForces forces = numbers.forces.value_or(PlatenForces{});
    const auto show = [&](int column, double value, int decimals, const char* unit) {
        rows.value(column, areKnown ? withUnit(value, decimals, unit) : fixedText(std::nullopt, 0));
    };
    rows.name(Words::tr("Sum"));
    show(0, forces.sum.force_N.x(), 3, "N");
    show(1, forces.sum.force_N.y(), 3, "N");
    rows.next();
    rows.name(Words::tr("Torque"));
    show(1, 1e3 * forces.torque_Nm, 2, "mN·m");
    rows.next();
    const auto& lift_N = numbers.readings.lift_N;
    const bool isHigh = std::abs(lift_N.value_or(0.0)) > Warm_ratio * numbers.settings.liftLimit_N;
    rows.name(Words::tr("Lift"));
    if (numbers.readings.currentScale.value_or(1.0) < 1.0) {
        rows.value(0, Words::tr("limited"), theme.warn);
    }
    const QString lift = withUnit(lift_N, 3, "N");
    isHigh ? rows.value(1, lift, theme.warn) : rows.value(1, lift);
    rows.next();
}

void reachRows(Rows& rows, const Theme& theme, const PlatenNumbers& numbers) {
    if (!rows.begin(3, Words::tr("Reach left"), QStringLiteral("−"), QStringLiteral("+"))) {
        return;
    }
    constexpr std::array Names = {"x", "y", "φ"};
    constexpr std::array Units = {"mm", "mm", "mrad"};
    for (int axis = 0; axis < 3; ++axis) {
        const auto index = static_cast<std::size_t>(axis);
        rows.name(QString::fromUtf8(Names[index]));
        const double window = numbers.settings.window ? (*numbers.settings.window)(axis) : 0.0;
        const auto show = [&](int column, const Eigen::Vector3d* left) {
            if (left == nullptr) {
                rows.value(column, fixedText(std::nullopt, 0));
                return;
            }
            const QString text = withUnit(1e3 * (*left)(axis), 2, Units[index]);
            const bool isNear = (*left)(axis) < (1.0 - Warm_ratio) * window;
            isNear ? rows.value(column, text, theme.warn) : rows.value(column, text);
        };
        show(0, numbers.reach ? &numbers.reach->down : nullptr);
        show(1, numbers.reach ? &numbers.reach->up : nullptr);
        rows.next();
    }
}

} // namespace

double platenTableWidth_px(const QFontMetricsF& metrics) {
    return Width_characters * metrics.horizontalAdvance(QLatin1Char('0'));
}

double platenTableHeight_px(const QFontMetricsF& metrics) {
    return (AllRows + Groups * Heading_rows) * (metrics.height() + 2.0) + GridStep_px;
}

void drawPlatenTable(QPainter& painter, const Theme& theme, const QRectF& place,
                     const PlatenNumbers& numbers) {
    painter.fillRect(place, theme.panel);
    Rows rows(painter, theme, place.adjusted(PanelMargin_px, 0.0, -PanelMargin_px, -GridStep_px),
              numbers.isStale);
    poseRows(rows, numbers.readings);
    coilRows(rows, theme, numbers);
    chipRows(rows, theme, numbers);
    forceRows(rows, theme, numbers);
    reachRows(rows, theme, numbers);
}

} // namespace halbench::widgets
