#pragma once

#include "widgets/actuators/spherical/sphere_view.h"

#include <optional>

namespace halbench::widgets {

/// The picture of a spherical rotor in which the sensors are moved about the centre: by mouse, or the chosen
/// one by the arrow keys, a degree of azimuth or elevation each; 0, 1 and 2 choose. Beside the sensors the
/// mouse turns the view, as do the arrow keys with Shift.
class PlacementView : public SphereView {
    Q_OBJECT
public:
    explicit PlacementView(QWidget* parent = nullptr);

    void choose(std::size_t sensor);
    std::size_t chosen() const { return m_chosen; }

Q_SIGNALS:
    /// Towards this unit vector in stator axes.
    void sensorMoved(std::size_t sensor, const Eigen::Vector3d& direction);
    void sensorChosen(std::size_t sensor);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    std::optional<std::size_t> sensorAt(const QPointF& at) const;
    void turnChosen(double azimuth_rad, double elevation_rad);

    std::size_t m_chosen = 0;
    bool m_isDragging = false;
    bool m_isBehind = false; ///< the sensor that is dragged: it stays on its side of the sphere
};

} // namespace halbench::widgets
