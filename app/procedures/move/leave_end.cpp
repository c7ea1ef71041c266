#include "app/procedures/move/leave_end.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/move/move_procedure.h"
#include "app/procedures/tune/loop_axis.h"

#include <cmath>

namespace halbench::app {
namespace {

Result<double> positionOf(devices::Device& device, const devices::AxisSpec& axis) {
    const std::string names[] = {signalOf(device.catalogue(), axis.roles.position)};
    const auto position = device.readSignals(names);
    return position ? Result<double>(position->front()) : failure(position.error());
}

} // namespace

std::optional<double> travelOf(const devices::Catalogue& catalogue, const devices::AxisSpec& axis) {
    const ParameterSpec* window = catalogue.findParameter(parameterOf(catalogue, axis.roles.positionWindow));
    if (axis.turnsForever || window == nullptr || !std::isfinite(window->max)) {
        return std::nullopt;
    }
    return 0.5 * window->max;
}

Result<void> leaveEnd(devices::Device& device, const devices::AxisSpec& axis,
                      const ProcedureObserver& observer) {
    constexpr int MostSteps = 5;
    constexpr double Room_steps = 1.5; // one step, and the error of a pose that is not calibrated
    constexpr double Step_s = 1.0;
    const auto travel = travelOf(device.catalogue(), axis);
    if (!travel) {
        return {};
    }
    ProcedureObserver quiet = observer;
    quiet.onState = nullptr; // part of the preparation
    const double step = loopAxisOf(axis).testStep;
    for (int done = 0; done < MostSteps; ++done) {
        const auto position = positionOf(device, axis);
        if (!position) {
            return failure(position.error());
        }
        if (!(*travel - std::fabs(*position) < Room_steps * step)) { // a pose that is not known is no end
            return {};
        }
        MoveConfig nearer;
        nearer.axis = axis.id;
        nearer.duration_s = Step_s;
        nearer.reference.shape = MoveReference::Shape::Step;
        nearer.reference.amplitude = *position > 0.0 ? -step : step;
        if (auto moved = performMove(device, nearer, quiet); !moved) {
            return failure(moved.error());
        }
    }
    return {};
}

} // namespace halbench::app
