#pragma once

#include "app/actuators/spherical/sensing_board.h"
#include "app/analyses/spherical/coverage_slice.h"
#include "models/spherical/coverage/placed_sensor.h"

#include <QWidget>

#include <vector>

class QBoxLayout;
class QComboBox;
class QLabel;

namespace halbench::widgets {
class PlacementView;
class QuantityEdit;
} // namespace halbench::widgets

namespace halbench::app {

/// Places of the three field sensors about a rotor: dragged on its picture, moved by keys or typed as angles.
/// Begins with those of the board; other ones are for trial and change nothing on the board. Thread: GUI.
class PlacementEditor : public QWidget {
    Q_OBJECT
public:
    explicit PlacementEditor(QWidget* parent = nullptr);

    /// The sensors that the board knows; another placement on trial stays.
    void setBoard(const SensingBoard& board);
    /// Whether the placement is another one than the board's.
    bool isOnTrial() const { return m_isOnTrial; }
    const models::SensorTriple& placement() const { return m_placement; }
    models::SensorPoses poses() const;
    /// The device that the placement on trial is judged for.
    models::PlacementDevice device(models::SphericalDevice model) const;

    void tryRecommended();
    /// To the board's placement.
    void goBack();

    /// The rotor in a pose, with what the sensors read there.
    void showPose(const models::OrientationAngles& angles, const models::SphericalReadings& readings_T);
    /// Dots at the shafts of poses that are not covered.
    void showUncovered(const std::vector<UncoveredShaft>& shafts);

Q_SIGNALS:
    void placementChanged();

private:
    void buildAngles(QBoxLayout& column);
    void tryPlacement(const models::SensorTriple& placement);
    void moveSensor(std::size_t sensor, const Eigen::Vector3d& direction);
    void takeAngles();
    void showSensors();
    void showAngles();

    SensingBoard m_board;
    models::SensorTriple m_placement;
    bool m_isOnTrial = false;
    widgets::PlacementView* m_view = nullptr;
    QComboBox* m_sensor = nullptr;
    std::array<widgets::QuantityEdit*, 3> m_angles{};
    QLabel* m_order = nullptr; ///< of the rotations by them
};

} // namespace halbench::app
