#include "widgets/actuators/planar/platen_drawing.h"

#include "control/base/units.h"
#include "widgets/language/display_units.h"
#include "widgets/theme/theme_style.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace halbench::widgets {

namespace {

using models::PlanarPose;

constexpr double FieldLength_m_per_T = 0.8; ///< 16 mm for the usual 20 mT
constexpr double ForceLength_m_per_N = 0.03;
constexpr double LongestForce_m = 0.09;
constexpr double BodyMargin_m = 6e-3; ///< of the platen about its coils and chips
constexpr double ChipSide_m = 4e-3;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(halbench::widgets::PlatenDrawing)
};

QPen pen(const QColor& colour, double width_px, Qt::PenStyle style = Qt::SolidLine) {
    QPen result(colour, width_px, style, Qt::FlatCap, Qt::MiterJoin);
    result.setCosmetic(true);
    return result;
}

/// Platen axes in metres to logical pixels.
QTransform placed(const MapScale& scale, const PlanarPose& pose) {
    const QPointF at = scale.at({pose.x_m, pose.y_m});
    QTransform transform;
    transform.translate(at.x(), at.y());
    transform.rotate(-radiansToDegrees(pose.angle_rad));
    transform.scale(scale.pixels_per_m, -scale.pixels_per_m);
    return transform;
}

QRectF coilOutline_m(const models::PlanarGeometry& geometry, const models::PlanarCoil& coil) {
    const double along_m = geometry.longStraight_m() + 2.0 * geometry.winding.width_m;
    const double across_m = geometry.shortStraight_m() + 2.0 * geometry.winding.width_m;
    QRectF outline(0.0, 0.0, coil.isAcross ? across_m : along_m, coil.isAcross ? along_m : across_m);
    outline.moveCenter({coil.centre_m.x(), coil.centre_m.y()});
    return outline;
}

QRectF bodyOutline_m(const PlatenSettings& settings) {
    QRectF body;
    for (const models::PlanarCoil& coil : settings.geometry.coils()) {
        body |= coilOutline_m(settings.geometry, coil);
    }
    for (const Eigen::Vector2d& place_m : settings.sensing.place_m) {
        body |=
            QRectF(place_m.x() - ChipSide_m / 2.0, place_m.y() - ChipSide_m / 2.0, ChipSide_m, ChipSide_m);
    }
    return body.adjusted(-BodyMargin_m, -BodyMargin_m, BodyMargin_m, BodyMargin_m);
}

QPainterPath coilPath(const models::PlanarGeometry& geometry, const models::PlanarCoil& coil) {
    const double width_m = geometry.winding.width_m;
    const QRectF outline = coilOutline_m(geometry, coil);
    QPainterPath path;
    path.addRoundedRect(outline, width_m, width_m);
    path.addRect(outline.adjusted(width_m, width_m, -width_m, -width_m));
    return path;
}

void drawArrow(QPainter& painter, const QPointF& from, const QPointF& to, double head_px) {
    const QPointF along = to - from;
    const double length = std::hypot(along.x(), along.y());
    if (length < 1.0) {
        return;
    }
    const QPointF back = along * (std::min(head_px, 0.6 * length) / length);
    const QPointF side(-0.45 * back.y(), 0.45 * back.x());
    painter.drawLine(from, to);
    painter.drawLine(to, to - back + side);
    painter.drawLine(to, to - back - side);
}

/// Arrow heads on both long sides: which way the current runs around, seen from above.
void drawDirection(QPainter& painter, const QRectF& outline, double width_m, bool isCounterClockwise,
                   bool isAcross) {
    const double head_m = 0.35 * width_m;
    for (const double side : {-1.0, 1.0}) {
        // Counter-clockwise: along +x' on the lower side, along +y' on the right one.
        const double way = (isAcross ? side : -side) * (isCounterClockwise ? 1.0 : -1.0);
        const double reach_m = 0.5 * ((isAcross ? outline.width() : outline.height()) - width_m);
        const QPointF c = outline.center();
        const QPointF tip = isAcross ? QPointF(c.x() + side * reach_m, c.y() + way * head_m)
                                     : QPointF(c.x() + way * head_m, c.y() + side * reach_m);
        const QPointF back = isAcross ? QPointF(0.0, -2.0 * way * head_m) : QPointF(-2.0 * way * head_m, 0.0);
        const QPointF wing = isAcross ? QPointF(head_m, 0.0) : QPointF(0.0, head_m);
        painter.drawPolygon(QPolygonF({tip, tip + back + wing, tip + back - wing}));
    }
}

} // namespace

void PlatenDrawing::platen(const PlatenReadings& readings) const {
    const PlanarPose& pose = *readings.pose;
    painter.save();
    painter.setTransform(placed(scale, pose), true);
    QColor body = theme.panel;
    body.setAlphaF(0.55);
    painter.setPen(pen(theme.text, 1.5));
    painter.setBrush(body);
    painter.drawRoundedRect(bodyOutline_m(settings), BodyMargin_m, BodyMargin_m);
    const auto coils = settings.geometry.coils();
    for (std::size_t k = 0; k < coils.size(); ++k) {
        const double current_A =
            readings.current_A ? (*readings.current_A)(static_cast<Eigen::Index>(k)) : 0.0;
        const double share = std::clamp(std::abs(current_A) / settings.currentLimit_A, 0.0, 1.0);
        const QColor& full = theme.curves[current_A >= 0.0 ? 1 : 0];
        painter.setPen(pen(mixed(theme.muted, full, share), 1.0));
        painter.setBrush(mixed(theme.raised, isStale ? theme.muted : full, std::sqrt(share)));
        painter.drawPath(coilPath(settings.geometry, coils[k]));
        if (readings.current_A && share > 1e-3) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(theme.text);
            drawDirection(painter, coilOutline_m(settings.geometry, coils[k]),
                          settings.geometry.winding.width_m, coils[k].sense * current_A > 0.0,
                          coils[k].isAcross);
        }
    }
    painter.restore();
    const QFontMetricsF metrics(painter.font());
    const double room_px = settings.geometry.shortStraight_m() * scale.pixels_per_m;
    if (room_px < metrics.height()) {
        return;
    }
    painter.setPen(theme.text);
    for (std::size_t k = 0; k < coils.size(); ++k) {
        QString text = QString::number(k + 1);
        if (readings.current_A && room_px > 2.2 * metrics.height() &&
            room_px > metrics.horizontalAdvance(QStringLiteral("−0.00 A")) * 0.6) {
            const double current_A = (*readings.current_A)(static_cast<Eigen::Index>(k));
            text += QLatin1Char('\n') + fixedText(current_A, 2) + QStringLiteral(" A");
        }
        QRectF box(0.0, 0.0, 200.0, 100.0);
        box.moveCenter(scale.at(inLattice_m(pose, coils[k].centre_m)));
        painter.drawText(box, Qt::AlignCenter, text);
    }
}

void PlatenDrawing::ghost(const PlanarPose& pose) const {
    painter.save();
    painter.setTransform(placed(scale, pose), true);
    painter.setPen(pen(theme.accent, 1.5, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(bodyOutline_m(settings), BodyMargin_m, BodyMargin_m);
    painter.restore();
    const QPointF at = scale.at({pose.x_m, pose.y_m});
    painter.setPen(pen(theme.accent, 1.5));
    painter.drawLine(at - QPointF(9.0, 0.0), at + QPointF(9.0, 0.0));
    painter.drawLine(at - QPointF(0.0, 9.0), at + QPointF(0.0, 9.0));
}

void PlatenDrawing::truth(const PlanarPose& pose) const {
    const QPointF at = scale.at({pose.x_m, pose.y_m});
    painter.setPen(pen(theme.simulated, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, 5.0, 5.0);
}

void PlatenDrawing::chips(const PlatenReadings& readings) const {
    const PlanarPose& pose = *readings.pose;
    const Eigen::Rotation2Dd turn(pose.angle_rad);
    const auto arrow = [&](const Eigen::Vector2d& place_m, const Eigen::Vector2d& field_T, double magnified) {
        const Eigen::Vector2d way_m = turn * (FieldLength_m_per_T * magnified * field_T);
        drawArrow(painter, scale.at(place_m), scale.at(place_m + way_m), 7.0);
    };
    const bool areExplained = readings.field_T && readings.current_A;
    const models::ChipFields_T residual_T =
        areExplained ? fieldResidual_T(settings, pose, *readings.field_T, *readings.current_A)
                     : models::ChipFields_T(models::ChipFields_T::Zero());
    const double half_px = std::max(4.0, 0.5 * ChipSide_m * scale.pixels_per_m);
    for (std::size_t j = 0; j < settings.sensing.place_m.size(); ++j) {
        const auto row = 2 * static_cast<Eigen::Index>(j);
        const Eigen::Vector2d place_m = inLattice_m(pose, settings.sensing.place_m[j]);
        const QPointF at = scale.at(place_m);
        const QColor ink = readings.used[j] ? theme.curves[2] : theme.bad;
        painter.setPen(pen(ink, 1.5));
        painter.setBrush(theme.panel);
        painter.drawRect(QRectF(at.x() - half_px, at.y() - half_px, 2.0 * half_px, 2.0 * half_px));
        if (!readings.used[j]) { // crossed out
            painter.drawLine(at - QPointF(half_px, half_px), at + QPointF(half_px, half_px));
            painter.drawLine(at - QPointF(half_px, -half_px), at + QPointF(half_px, -half_px));
        }
        if (areExplained) {
            painter.setPen(pen(isStale ? theme.muted : ink, 2.0));
            arrow(place_m, readings.field_T->segment<2>(row), 1.0);
            painter.setPen(pen(theme.warn, 2.0));
            arrow(place_m, residual_T.segment<2>(row), ResidualMagnification);
        }
        // Outside, where no coil's number stands.
        const QString name = Words::tr("H%1").arg(j + 1);
        const bool isLeft = settings.sensing.place_m[j].x() < 0.0;
        const double width_px = QFontMetricsF(painter.font()).horizontalAdvance(name);
        painter.setPen(theme.text);
        painter.drawText(at + QPointF(isLeft ? -half_px - 3.0 - width_px : half_px + 3.0, -half_px - 3.0),
                         name);
    }
}

void PlatenDrawing::forces(const PlatenForces& forces) const {
    const auto arrow = [&](const PlacedForce& force, const QColor& ink, double width_px) {
        Eigen::Vector2d way_m = ForceLength_m_per_N * force.force_N;
        if (way_m.norm() > LongestForce_m) {
            way_m *= LongestForce_m / way_m.norm();
        }
        painter.setPen(pen(isStale ? theme.muted : ink, width_px));
        drawArrow(painter, scale.at(force.place_m), scale.at(force.place_m + way_m), 4.0 * width_px);
    };
    for (const PlacedForce& set : forces.sets) {
        arrow(set, theme.curves[3], 2.5);
    }
    arrow(forces.sum, theme.text, 4.0);
    const QPointF middle = scale.at(forces.sum.place_m);
    painter.setPen(pen(theme.text, 1.0));
    painter.setBrush(theme.panel);
    painter.drawEllipse(middle, 3.5, 3.5);
}

void PlatenDrawing::cell(const PlanarPose& pose) const {
    const double pitch_m = settings.geometry.matrix.pitch_m;
    const std::array<int, 2> cell = pitchCell(pose, pitch_m);
    const Eigen::Vector2d middle_m = pitch_m * Eigen::Vector2d(cell[0], cell[1]);
    const Eigen::Vector2d half_m = Eigen::Vector2d::Constant(0.5 * pitch_m);
    painter.setPen(pen(theme.text, 1.0, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(scale.at(middle_m - half_m), scale.at(middle_m + half_m)).normalized());
}

void PlatenDrawing::window(const PlanarPose& origin) const {
    const Eigen::Vector2d middle_m(origin.x_m, origin.y_m);
    const Eigen::Vector2d half_m = settings.window->head<2>();
    painter.setPen(pen(theme.armed, 1.0, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(scale.at(middle_m - half_m), scale.at(middle_m + half_m)).normalized());
}

void PlatenDrawing::path(const std::vector<Eigen::Vector2d>& places_m) const {
    QPolygonF line;
    line.reserve(static_cast<int>(places_m.size()));
    for (const Eigen::Vector2d& place_m : places_m) {
        const QPointF at = scale.at(place_m);
        if (line.isEmpty() || (at - line.back()).manhattanLength() > 1.0) {
            line << at;
        }
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false); // long lines: the quick way
    painter.setPen(pen(theme.curves[6], 1.0));
    painter.drawPolyline(line);
    painter.restore();
}

double roundLength(double longest) {
    const double decade = std::pow(10.0, std::floor(std::log10(longest)));
    const double share = longest / decade;
    return decade * (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0);
}

namespace {

QString lengthText(double length_m) {
    if (length_m >= 0.9999e-3) {
        return numberText(length_m * 1e3, 3) + QStringLiteral(" mm");
    }
    return length_m >= 0.9999e-6 ? numberText(length_m * 1e6, 3) + QStringLiteral(" µm")
                                 : numberText(length_m * 1e9, 3) + QStringLiteral(" nm");
}

/// A measured line with its length above it.
void drawScale(QPainter& painter, const Theme& theme, const QPointF& left, double pixels_per_m,
               double longest_px) {
    const double length_m = roundLength(longest_px / pixels_per_m);
    const double length_px = length_m * pixels_per_m;
    painter.setPen(pen(theme.text, 1.5));
    const QPointF right = left + QPointF(length_px, 0.0);
    painter.drawLine(left, right);
    for (const QPointF& end : {left, right}) {
        painter.drawLine(end - QPointF(0.0, 3.0), end + QPointF(0.0, 3.0));
    }
    painter.drawText(left + QPointF(0.0, -6.0), lengthText(length_m));
}

} // namespace

void drawErrorInset(QPainter& painter, const Theme& theme, const QRectF& place, const ErrorInset& inset,
                    bool isStale) {
    painter.save();
    painter.setPen(pen(theme.line, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRect(place);
    painter.setClipRect(place);
    const QPointF c = place.center();
    if (inset.error) {
        painter.setPen(pen(theme.accent, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(place.left(), c.y()), QPointF(place.right(), c.y()));
        painter.drawLine(QPointF(c.x(), place.top()), QPointF(c.x(), place.bottom()));
    }
    const double pixels_per_m = ErrorMagnification * inset.pixels_per_m;
    const auto at = [&](const Eigen::Vector3d& error) { // the platen lies where its reference is not
        return c + pixels_per_m * QPointF(-error.x(), error.y());
    };
    const double half_px = 0.5 * place.width();
    QPolygonF recent;
    for (const Eigen::Vector3d& error : inset.recent) {
        recent << at(error);
    }
    painter.setPen(pen(theme.curves[6], 1.0));
    painter.drawPolyline(recent);
    const QRectF texts = place.adjusted(6.0, 4.0, -6.0, -4.0);
    painter.setPen(theme.muted);
    painter.drawText(texts, Qt::AlignTop | Qt::AlignLeft, Words::tr("error ×1000"));
    if (inset.error) {
        QPointF middle = at(*inset.error);
        const QPointF away = middle - c;
        const double farthest = std::max(std::abs(away.x()), std::abs(away.y()));
        const bool isOutside = farthest > half_px - 6.0;
        if (isOutside) {
            middle = c + away * ((half_px - 6.0) / farthest);
            painter.drawText(texts, Qt::AlignTop | Qt::AlignRight, Words::tr("outside"));
        }
        const double turn_rad = std::clamp(-ErrorMagnification * inset.error->z(), -Pi / 2.0, Pi / 2.0);
        const QPointF arm(10.0 * std::cos(turn_rad), -10.0 * std::sin(turn_rad));
        painter.setPen(pen(isStale ? theme.muted : isOutside ? theme.warn : theme.text, 2.0));
        painter.drawLine(middle - arm, middle + arm);
        painter.drawLine(middle - QPointF(arm.y(), -arm.x()) * 0.5,
                         middle + QPointF(arm.y(), -arm.x()) * 0.5);
    } else {
        painter.drawText(texts, Qt::AlignCenter | Qt::TextWordWrap, Words::tr("no position is controlled"));
    }
    drawScale(painter, theme, place.bottomLeft() + QPointF(8.0, -9.0), pixels_per_m, 0.4 * place.width());
    painter.restore();
}

void drawMapKey(QPainter& painter, const Theme& theme, const QRectF& place, const PlatenReadings& readings) {
    struct Entry {
        QString text;
        QPen line;
    };
    std::vector<Entry> entries = {
        {Words::tr("Field at a chip"), pen(theme.curves[2], 2.0)},
        {Words::tr("Residual ×%1").arg(ResidualMagnification), pen(theme.warn, 2.0)},
        {Words::tr("Force of a pair"), pen(theme.curves[3], 2.5)},
        {Words::tr("Sum of the forces"), pen(theme.text, 4.0)},
        {Words::tr("Path"), pen(theme.curves[6], 1.0)},
    };
    if (readings.reference) {
        entries.push_back({Words::tr("Reference"), pen(theme.accent, 1.5, Qt::DashLine)});
        entries.push_back({Words::tr("Window"), pen(theme.armed, 1.0, Qt::DashLine)});
    }
    if (readings.truth) {
        entries.push_back({Words::tr("True place"), pen(theme.simulated, 1.5)});
    }
    const QFontMetricsF metrics(painter.font());
    constexpr double Sample_px = 22.0;
    double width_px = 0.0;
    for (const Entry& entry : entries) {
        width_px = std::max(width_px, metrics.horizontalAdvance(entry.text));
    }
    width_px += Sample_px + 18.0;
    const double height_px = static_cast<double>(entries.size()) * metrics.height() + 8.0;
    if (height_px > place.height() || width_px > place.width()) {
        return; // it would hide what it explains
    }
    const QRectF box(place.right() - width_px, place.top(), width_px, height_px);
    QColor ground = theme.panel;
    ground.setAlphaF(0.85);
    painter.fillRect(box, ground);
    double y = box.top() + 4.0;
    for (const Entry& entry : entries) {
        painter.setPen(entry.line);
        const double middle = y + 0.5 * metrics.height();
        painter.drawLine(QPointF(box.left() + 6.0, middle), QPointF(box.left() + 6.0 + Sample_px, middle));
        painter.setPen(theme.text);
        painter.drawText(QRectF(box.left() + 12.0 + Sample_px, y, width_px, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, entry.text);
        y += metrics.height();
    }
}

void drawMapLegend(QPainter& painter, const Theme& theme, const QRectF& map, const MapScale& scale,
                   const models::PlanarGeometry& geometry) {
    const QFontMetricsF metrics(painter.font());
    const double bar_px = 8.0 * metrics.averageCharWidth();
    const QString field = fixedText(largestField_T(geometry), 2);
    const QString text =
        Words::tr("Bz −%1 … %1 T at z = %2 mm").arg(field, fixedText(1e3 * coilPlane_m(geometry), 1));
    const double width_px = std::max(metrics.horizontalAdvance(text), bar_px) + 12.0;
    const double height_px = 3.6 * metrics.height() + 8.0;
    const QRectF box(map.left() + 8.0, map.bottom() - height_px - 8.0, width_px, height_px);
    QColor ground = theme.panel;
    ground.setAlphaF(0.85);
    painter.fillRect(box, ground);
    constexpr int Steps = 16;
    for (int i = 0; i < Steps; ++i) {
        const QRectF patch(box.left() + 6.0 + bar_px * i / Steps, box.bottom() - 6.0 - 0.7 * metrics.height(),
                           bar_px / Steps + 0.5, 0.7 * metrics.height());
        painter.fillRect(patch, fieldColour(theme, 2.0 * (i + 0.5) / Steps - 1.0));
    }
    painter.setPen(theme.text);
    painter.drawText(QPointF(box.left() + 6.0, box.bottom() - 10.0 - 0.9 * metrics.height()), text);
    drawScale(painter, theme, {box.left() + 6.0, box.top() + metrics.height() + 8.0}, scale.pixels_per_m,
              bar_px);
}

} // namespace halbench::widgets
