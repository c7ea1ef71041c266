#include "widgets/actuators/spherical/placement_view.h"

#include "control/base/units.h"
#include "widgets/theme/theme_style.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double Reach_px = 14.0; ///< around a sensor
constexpr double Ring_px = 9.0;
constexpr double KeyStep_rad = Pi / 180.0;

} // namespace

PlacementView::PlacementView(QWidget* parent) : SphereView(parent) {}

void PlacementView::choose(std::size_t sensor) {
    if (sensor < sensors().size() && sensor != m_chosen) {
        m_chosen = sensor;
        update();
        Q_EMIT sensorChosen(sensor);
    }
}

/// Those in front first: they cover the others.
std::optional<std::size_t> PlacementView::sensorAt(const QPointF& at) const {
    std::optional<std::size_t> found;
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < sensors().size(); ++i) {
        const Eigen::Vector3d& place_m = sensors()[i].place_m;
        const QPointF away = placeOf(place_m) - at;
        const double distance = std::hypot(away.x(), away.y());
        const double rank = distance + (isBehind(place_m) ? Reach_px : 0.0);
        if (distance <= Reach_px && rank < least) {
            least = rank;
            found = i;
        }
    }
    return found;
}

void PlacementView::turnChosen(double azimuth_rad, double elevation_rad) {
    const Eigen::Vector3d& place_m = sensors()[m_chosen].place_m;
    const double phi_rad = std::atan2(place_m.y(), place_m.x()) + azimuth_rad;
    const double height_rad = std::clamp(
        std::atan2(place_m.z(), std::hypot(place_m.x(), place_m.y())) + elevation_rad, -Pi / 2.0, Pi / 2.0);
    const double across = std::cos(height_rad);
    Q_EMIT sensorMoved(m_chosen,
                       {across * std::cos(phi_rad), across * std::sin(phi_rad), std::sin(height_rad)});
}

void PlacementView::paintEvent(QPaintEvent* event) {
    SphereView::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.setPen(QPen(currentTheme().accent, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(placeOf(sensors()[m_chosen].place_m), Ring_px, Ring_px);
}

void PlacementView::mousePressEvent(QMouseEvent* event) {
    const std::optional<std::size_t> sensor =
        event->button() == Qt::LeftButton ? sensorAt(event->localPos()) : std::nullopt;
    m_isDragging = sensor.has_value();
    if (sensor) {
        m_isBehind = isBehind(sensors()[*sensor].place_m);
        choose(*sensor);
        return;
    }
    SphereView::mousePressEvent(event);
}

void PlacementView::mouseMoveEvent(QMouseEvent* event) {
    if (!m_isDragging || (event->buttons() & Qt::LeftButton) == 0) {
        return SphereView::mouseMoveEvent(event);
    }
    const double radius_m = sensors()[m_chosen].place_m.norm();
    Q_EMIT sensorMoved(m_chosen, directionAt(event->localPos(), radius_m, m_isBehind));
}

void PlacementView::mouseReleaseEvent(QMouseEvent* event) {
    m_isDragging = false;
    SphereView::mouseReleaseEvent(event);
}

void PlacementView::keyPressEvent(QKeyEvent* event) {
    if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        return SphereView::keyPressEvent(event);
    }
    switch (event->key()) {
    case Qt::Key_Left:
        return turnChosen(-KeyStep_rad, 0.0);
    case Qt::Key_Right:
        return turnChosen(KeyStep_rad, 0.0);
    case Qt::Key_Up:
        return turnChosen(0.0, KeyStep_rad);
    case Qt::Key_Down:
        return turnChosen(0.0, -KeyStep_rad);
    case Qt::Key_0:
    case Qt::Key_1:
    case Qt::Key_2:
        return choose(static_cast<std::size_t>(event->key() - Qt::Key_0));
    default:
        SphereView::keyPressEvent(event);
    }
}

} // namespace halbench::widgets
