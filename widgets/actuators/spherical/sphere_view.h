#pragma once

#include "widgets/theme/theme.h"

#include <QPointF>
#include <QWidget>

#include <Eigen/Core>
#include <array>
#include <deque>
#include <optional>
#include <vector>

namespace halbench::widgets {

/// A field sensor on the stator: place and axes (R, Theta, Phi as columns) in the stator frame.
struct SphereSensor {
    Eigen::Vector3d place_m = Eigen::Vector3d(0.05, 0.0, 0.0);
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
};

/// The sensor that the placement angles describe. `frames`: 0 S = Rz Ry Rx, 1 Rx Ry Rz, 2 the first without a
/// roll about the radius; e_R = S e_x, e_Theta = -S e_z, e_Phi = S e_y.
SphereSensor sphereSensorAt(const std::array<double, 3>& angles_rad, int frames, double radius_m);

/// How far the orientation shown can be believed.
enum class SphereVerdict {
    Unknown,
    Fresh,
    Doubtful, ///< the residuals are too large
    Held      ///< the readings determine none: the last one
};

/// A direction of the shaft and how much data with it are wanted, or how much of it fails: 0 ... 1.
struct SphereWanted {
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
    double share = 0.0;
    bool isFailing = false; ///< drawn in the colour of an error, however small the share
};

/// A spherical rotor in its stator from any side: poles in two colours, shaft with its 95 % cone and the way
/// it went, true shaft, sensors with the field that each reads, stator axes. Orthographic; turned by mouse
/// and arrow keys, Home turns it back. Source: resources/help/spherical-theory.md sections 2 and 3.
class SphereView : public QWidget {
    Q_OBJECT
public:
    explicit SphereView(QWidget* parent = nullptr);

    void setSensors(const std::array<SphereSensor, 3>& sensors);
    const std::array<SphereSensor, 3>& sensors() const { return m_sensors; }
    void setReadings(const std::array<double, 9>& readings_T);
    /// Rotation from rotor to stator; `cone_rad`: half-angle about the shaft.
    void setOrientation(const Eigen::Matrix3d& rotation, double cone_rad, SphereVerdict verdict);
    void setTruth(const std::optional<Eigen::Matrix3d>& rotation);
    /// Dots about the rotor, larger and in the colour of a warning where the shaft is wanted; none: empty.
    void setWanted(std::vector<SphereWanted> wanted);
    void setStale(bool isStale); ///< the values are the last ones known
    void clear();                ///< nothing is known
    void clearPath();

    /// Direction of sight: from X towards Y, and above the plane of X and Y.
    void setSight(double azimuth_rad, double elevation_rad);
    /// Where a point of the stator is in the widget.
    QPointF placeOf(const Eigen::Vector3d& point_m) const;
    /// The direction, a unit vector in stator axes, whose point at this radius is seen at `at`, on the side
    /// of the eye or behind; beside the sphere the nearest one on its edge.
    Eigen::Vector3d directionAt(const QPointF& at, double radius_m, bool isBehind) const;
    /// Whether the point is behind the middle of the rotor.
    bool isBehind(const Eigen::Vector3d& point_m) const;
    /// Paints the picture into a rectangle of this size, also for files.
    void draw(QPainter& painter, const Theme& theme, const QSizeF& size) const;

    QSize sizeHint() const override { return {420, 420}; }
    QSize minimumSizeHint() const override { return {200, 200}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Sight; ///< projection of one frame
    Sight sight(const QSizeF& size) const;
    void drawRotor(QPainter& painter, const Theme& theme, const Sight& sight) const;
    void drawAxes(QPainter& painter, const Theme& theme, const Sight& sight, bool areInFront) const;
    void drawSensors(QPainter& painter, const Theme& theme, const Sight& sight, bool areInFront) const;
    void drawShaft(QPainter& painter, const Theme& theme, const Sight& sight, bool isInFront) const;
    void drawWanted(QPainter& painter, const Theme& theme, const Sight& sight, bool areInFront) const;
    void drawWords(QPainter& painter, const Theme& theme, const QSizeF& size) const;
    QString verdictText() const;
    void describe();

    std::array<SphereSensor, 3> m_sensors;
    std::optional<std::array<double, 9>> m_readings_T;
    std::optional<Eigen::Matrix3d> m_rotation;
    std::optional<Eigen::Matrix3d> m_truth;
    double m_cone_rad = 0.0;
    SphereVerdict m_verdict = SphereVerdict::Unknown;
    std::deque<Eigen::Vector3d> m_path; ///< tips of the shaft, oldest first
    std::vector<SphereWanted> m_wanted;
    double m_azimuth_rad;
    double m_elevation_rad;
    QPointF m_dragged;
    bool m_isStale = false;
};

} // namespace halbench::widgets
