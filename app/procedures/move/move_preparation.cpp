#include "app/procedures/move/move_preparation.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/tune/position_law_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::app {
namespace {

// A bounded axis stays within the windows that the board has: those are its travel.
Result<MoveTask> withinBoardWindows(devices::Device& device, const MoveConfig& config, MoveTask task) {
    const devices::Catalogue& catalogue = device.catalogue();
    const std::vector<std::string> names = {parameterOf(catalogue, task.axis.roles.positionWindow),
                                            parameterOf(catalogue, task.axis.roles.speedWindow)};
    const auto values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    const double asked = referenceExcursion(config.reference, config.duration_s);
    if (asked >= values->front()) {
        const std::string& unit = task.axis.positionUnit;
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a move of {:.4g} {} leaves the window of {:.4g} {} of axis {}", asked,
                                   unit, values->front(), unit, task.axis.id),
                       fmt::format("Move less, or set {} on the device. Nothing was armed.", names.front()));
    }
    task.window = std::min(task.window, values->front());
    task.speedLimit = values->back();
    return task;
}

// Without a shape the reference of an axis stays where it is.
void holdOthers(const devices::Catalogue& catalogue, const devices::AxisSpec& moved,
                std::vector<ParameterValue>& values) {
    for (const devices::AxisSpec& axis : catalogue.axes) {
        if (axis.id != moved.id) {
            values.push_back({axis.generator + ".shape", 0.0});
            values.push_back({axis.generator + ".base", 0.0});
        }
    }
}

// A motor that is still coasting from its last move would give the reference a moving origin. One that does
// not stop (no friction) is taken as it is; the figures then speak for themselves.
Result<void> awaitRest(devices::Device& device, const devices::AxisSpec& axis,
                       const ProcedureObserver& observer) {
    constexpr double Still_rad_s = 0.15; // one count that flickers looks like 0.11 rad/s
    constexpr double Patience_s = 10.0;
    constexpr double Piece_s = 0.1;
    const std::string names[] = {signalOf(device.catalogue(), axis.roles.speed)};
    if (device.catalogue().findSignal(names[0]) == nullptr) {
        return {};
    }
    int still = 0;
    for (double waited_s = 0.0; waited_s < Patience_s && still < 2; waited_s += Piece_s) {
        const auto speed_rad_s = device.readSignals(names);
        if (!speed_rad_s) {
            return failure(speed_rad_s.error());
        }
        still = std::fabs(speed_rad_s->front()) < Still_rad_s ? still + 1 : 0;
        if (still < 2) {
            if (auto waited = waitObserved(device, observer, Piece_s, 0.0, 0.0, "waits for standstill");
                !waited) {
                return waited;
            }
        }
    }
    return {};
}

Result<bool> hasZero(devices::Device& device, const std::string& signal) {
    const std::string names[] = {signal};
    const auto values = device.readSignals(names);
    return values ? Result<bool>(values->front() > 0.5) : failure(values.error());
}

// Positions count from a zero that a board may not know after power-on. Homing moves nothing: it only says
// where the count begins, so it is done here.
Result<void> awaitZero(devices::Device& device, const ProcedureObserver& observer) {
    constexpr double Homing_s = 0.05;
    const std::string signal = device.catalogue().signalForRole("homed");
    const std::string order = device.catalogue().parameterForRole("home");
    if (signal.empty()) {
        return {};
    }
    auto isKnown = hasZero(device, signal);
    if (isKnown && !*isKnown && !order.empty()) {
        const ParameterValue home[] = {{order, 1.0}};
        if (auto written = device.writeParameters(home); !written) {
            return written;
        }
        if (auto waited = waitObserved(device, observer, Homing_s, 0.0, 0.0, "homes"); !waited) {
            return waited;
        }
        isKnown = hasZero(device, signal);
    }
    if (!isKnown) {
        return failure(isKnown.error());
    }
    return *isKnown ? Result<void>()
                    : failure(ErrorCode::Refused, "the device knows no zero of its axes and does not find it",
                              "Check its sensors, home it, and move again. Nothing was armed.");
}

} // namespace

// Room for overshoot without friction (68 % of the step, resources/help/htm-theory.md 8.1) and then some.
double excursionWindow(const devices::Catalogue& catalogue, const MoveConfig& config,
                       const devices::AxisSpec& axis) {
    const double asked = referenceExcursion(config.reference, config.duration_s);
    const ParameterSpec* spec = catalogue.findParameter(parameterOf(catalogue, axis.roles.positionWindow));
    const double largest = spec == nullptr ? 10000.0 : spec->max;
    return std::min(2.0 * asked + axis.windowMargin, largest);
}

Result<MoveTask> moveTask(devices::Device& device, const MoveConfig& config) {
    const auto axis = chosenAxis(device.catalogue(), config.axis);
    if (!axis) {
        return failure(axis.error());
    }
    if (auto isMeant = checkQuantity(config.reference, *axis); !isMeant) {
        return failure(isMeant.error());
    }
    const MoveTask task{*axis, excursionWindow(device.catalogue(), config, *axis), config.speedLimit_rad_s};
    return axis->turnsForever ? Result<MoveTask>(task) : withinBoardWindows(device, config, task);
}

Result<void> setMoveWindows(devices::Device& device, const MoveTask& task) {
    const devices::Catalogue& catalogue = device.catalogue();
    const ParameterValue windows[] = {{parameterOf(catalogue, task.axis.roles.positionWindow), task.window},
                                      {parameterOf(catalogue, "window.position_enabled"), 1.0},
                                      {parameterOf(catalogue, task.axis.roles.speedWindow), task.speedLimit},
                                      {parameterOf(catalogue, "window.speed_enabled"), 1.0}};
    return device.writeParameters(windows);
}

Result<void> setMoveGenerator(devices::Device& device, const MoveConfig& config,
                              const devices::AxisSpec& axis) {
    std::vector<ParameterValue> values =
        generatorParameters(config.reference, config.duration_s, axis.generator);
    holdOthers(device.catalogue(), axis, values);
    values.push_back({"hb.mode", static_cast<double>(devices::BoardMode::Position)});
    // A small board leaves out what only chirp and multisine need, and refuses these shapes.
    std::erase_if(values, [&device](const ParameterValue& value) {
        return value.name.starts_with("reference.") &&
               device.catalogue().findParameter(value.name) == nullptr;
    });
    return device.writeParameters(values);
}

// What the coils will be heated by is known where the effort is their current; a bounded axis is brought to
// rest by its own loop, so that it need not rest before.
Result<void> prepareMove(devices::Device& device, const MoveConfig& config, const devices::AxisSpec& axis,
                         const ProcedureObserver& observer) {
    MovePrediction prediction{config.duration_s, 0.0, 0.0};
    if (axis.effortUnit == "A") {
        const auto law = readPositionLaw(device);
        if (!law) {
            return failure(law.error());
        }
        prediction = predictMove(config, *law, models::RotorConfig{}, 1.43e-2);
    }
    const auto heat = admitHeat(device, observer, prediction.meanSquare_A2, prediction.duration_s,
                                config.pauseTemperature_degC, config.refuseTemperature_degC);
    if (!heat) {
        return failure(heat.error());
    }
    return axis.turnsForever ? awaitRest(device, axis, observer) : awaitZero(device, observer);
}

} // namespace halbench::app
