#pragma once

#include "widgets/actuators/actuator_view.h"

namespace halbench::widgets {

class RotorView;

/// The rotor's cross-section as a live picture, with the choice of the field's model
/// (resources/help/monitor.md, "Field").
class RotorPicture final : public ActuatorPicture {
    Q_OBJECT
public:
    explicit RotorPicture(QWidget* parent = nullptr);

    void showSettings(const ActuatorValues& values) override;
    void showSamples(const ActuatorValues& values) override;
    void setStale(bool isStale) override;
    void clear() override;

private:
    RotorView* m_view;
};

ActuatorView rotorActuatorView();

} // namespace halbench::widgets
