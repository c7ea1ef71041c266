#pragma once

#include "widgets/actuators/actuator_view.h"

#include <Eigen/Core>
#include <optional>

namespace halbench::widgets {

class SphereView;

/// A rotor that turns in all directions as a live picture: as its board measures it, with the field at each
/// sensor, and the true one beside it when it is simulated (resources/help/monitor.md, "Orientation").
class SpherePicture final : public ActuatorPicture {
    Q_OBJECT
public:
    explicit SpherePicture(QWidget* parent = nullptr);

    void showSettings(const ActuatorValues& values) override;
    void showSamples(const ActuatorValues& values) override;
    void setStale(bool isStale) override;
    void clear() override;
    void showWanted(const std::vector<WantedShaft>& shafts) override;
    QString numbers() const override { return m_numbers; }
    Drawing drawing() const override;

private:
    void describe(const ActuatorValues& values, const Eigen::Matrix3d& rotation);
    void countImages(const Eigen::Matrix3d& rotation);
    void showTruth(const std::optional<Eigen::Matrix3d>& truth, const Eigen::Matrix3d& rotation);

    SphereView* m_view;
    QString m_numbers;
    std::optional<Eigen::Matrix3d> m_last; ///< that the readings determined
    int m_imageChanges = 0; ///< of four orientations with the same field the device shows another one
};

ActuatorView sphereActuatorView();

} // namespace halbench::widgets
