#pragma once

#include "widgets/actuators/actuator_view.h"

namespace halbench::widgets {

class HallTraceView;
class RotorView;

/// The rotor's cross-section as a live picture, with the choice of the field's model, and beside it, where
/// the picture is wide, the Hall readings over a turn (resources/help/monitor.md, "Field").
class RotorPicture final : public ActuatorPicture {
    Q_OBJECT
public:
    explicit RotorPicture(QWidget* parent = nullptr);

    void showSettings(const ActuatorValues& values) override;
    void showSamples(const ActuatorValues& values) override;
    void setStale(bool isStale) override;
    void clear() override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    RotorView* m_view;
    HallTraceView* m_trace;
};

ActuatorView rotorActuatorView();

} // namespace halbench::widgets
