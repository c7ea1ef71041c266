#include "app/procedures/move/move_preparation.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/axis_zero.h"
#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/standstill.h"
#include "app/procedures/excite/table_reference.h"
#include "app/procedures/excite/travel_reference.h"
#include "app/procedures/move/leave_end.h"
#include "app/procedures/tune/position_law_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::app {
namespace {

Result<void> checkExcursion(const devices::AxisSpec& axis, double asked, double window,
                            const std::string& parameter) {
    if (asked < window) {
        return {};
    }
    const std::string& unit = axis.positionUnit;
    return failure(
        ErrorCode::OutOfRange,
        fmt::format("a move of {:.4g} {} leaves the window of {:.4g} {} of axis {}", asked, unit, window,
                    unit, axis.id),
        fmt::format("Use a shorter distance, or set {} on the device. Nothing was armed.", parameter));
}

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
    if (auto fits = checkExcursion(task.axis, asked, values->front(), names.front()); !fits) {
        return failure(fits.error());
    }
    task.window = std::min(task.window, values->front());
    task.speedLimit = values->back();
    return task;
}

// As the window of the first axis.
Result<MoveTask> withSecondAxis(devices::Device& device, const MoveConfig& config, MoveTask task,
                                const devices::AxisSpec& second) {
    const std::string names[] = {parameterOf(device.catalogue(), second.roles.positionWindow)};
    const auto window = device.readParameters(names);
    if (!window) {
        return failure(window.error());
    }
    const double asked = referenceExcursion(config.reference, config.duration_s);
    if (auto fits = checkExcursion(second, asked, window->front(), names[0]); !fits) {
        return failure(fits.error());
    }
    task.window = std::min(task.window, window->front());
    task.partners = {{second, task.window}};
    return task;
}

Result<MoveTask> pathTask(devices::Device& device, const MoveConfig& config) {
    if (!config.axis.empty() && config.axis != "all") {
        return failure(ErrorCode::Usage,
                       fmt::format("a {} moves two axes", moveShapeName(config.reference.shape)),
                       "Name no axis.");
    }
    const auto axes = pathAxes(device.catalogue());
    if (!axes) {
        return failure(axes.error());
    }
    const auto& [first, second] = *axes;
    if (auto isMeant = checkQuantity(config.reference, first); !isMeant) {
        return failure(isMeant.error());
    }
    const MoveTask task{
        first, {}, excursionWindow(device.catalogue(), config, first), config.speedLimit_rad_s};
    auto within = withinBoardWindows(device, config, task);
    return within ? withSecondAxis(device, config, *within, second) : failure(within.error());
}

/// Windows of an axis, and what its largest force gives its inertia; by the parameters of the board.
Result<TableAxisLimits> limitsOf(devices::Device& device, const devices::AxisSpec& axis) {
    const devices::Catalogue& catalogue = device.catalogue();
    const std::string inertia = "feedforward." + axis.id + ".inertia";
    std::vector<std::string> names = {parameterOf(catalogue, axis.roles.positionWindow),
                                      parameterOf(catalogue, axis.roles.speedWindow)};
    const bool hasForce = axis.effortLimit > 0.0 && catalogue.findParameter(inertia) != nullptr;
    if (hasForce) {
        names.push_back(inertia);
    }
    const auto values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    TableAxisLimits limits{axis.id, (*values)[0], names[0], (*values)[1], names[1]};
    if (hasForce && values->back() > 0.0) {
        limits.acceleration = axis.effortLimit / values->back();
    }
    return limits;
}

/// Every row and the way between them, before anything moves.
Result<MoveTask> tableTask(devices::Device& device, const MoveConfig& config) {
    if (!config.axis.empty() && config.axis != "all") {
        return failure(ErrorCode::Usage, "a table moves the axes of its columns", "Name no axis.");
    }
    const auto axes = tableAxes(device.catalogue(), config.reference);
    if (!axes) {
        return failure(axes.error());
    }
    MoveTask task;
    std::vector<TableAxisLimits> all;
    for (const devices::AxisSpec& axis : *axes) {
        const auto limits = limitsOf(device, axis);
        if (!limits) {
            return failure(limits.error());
        }
        const double window = std::min(excursionWindow(device.catalogue(), config, axis), limits->window);
        if (all.empty()) {
            task.axis = axis;
            task.window = window;
            task.speedLimit = limits->speed;
        } else {
            task.partners.push_back({axis, window});
        }
        all.push_back(*limits);
    }
    const auto kept = checkTableLimits(config.reference, all);
    return kept ? Result<MoveTask>(std::move(task)) : failure(kept.error());
}

/// Where an axis stands that moves within its travel.
Result<AxisTravel> travelNow(devices::Device& device, const devices::AxisSpec& axis, double travel) {
    const std::string names[] = {signalOf(device.catalogue(), axis.roles.position)};
    const auto position = device.readSignals(names);
    if (!position) {
        return failure(position.error());
    }
    return AxisTravel{axis.id, travel, position->front()};
}

/// From where the axes stand now the reference leads none beyond the end of its travel.
Result<void> checkEnds(devices::Device& device, const MoveConfig& config, const MoveTask& task) {
    // A ramp goes on until the last rows have come and the board has braked.
    constexpr double RunOn_s = 0.05;
    std::vector<devices::AxisSpec> moved = {task.axis};
    for (const PartnerAxis& partner : task.partners) {
        moved.push_back(partner.axis);
    }
    std::vector<AxisTravel> ends;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const auto travel = travelOf(device.catalogue(), moved[i]);
        if (!travel) { // without ends
            continue;
        }
        auto now = travelNow(device, moved[i], *travel);
        if (!now) {
            return failure(now.error());
        }
        ends.push_back(*std::move(now));
        if (isTable(config.reference)) {
            continue;
        }
        const control::PathSpan span = referenceSpan(config.reference, config.duration_s + RunOn_s, i);
        if (auto within = checkReferenceEnds(ends.back(), moved[i].positionUnit, span); !within) {
            return within;
        }
    }
    return isTable(config.reference) ? checkTableEnds(config.reference, ends) : Result<void>();
}

// An end that was counted from a guessed cell may be none.
Error afterHoming(Error error) {
    const Finding guessed = homedHere();
    error.hint += fmt::format(" And {}. {}", guessed.message, guessed.hint);
    return error;
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

} // namespace

// Room for overshoot without friction (68 % of the step, resources/help/htm-theory.md 8.1) and then some.
double excursionWindow(const devices::Catalogue& catalogue, const MoveConfig& config,
                       const devices::AxisSpec& axis) {
    const double asked = referenceExcursion(config.reference, config.duration_s, axis.id);
    const ParameterSpec* spec = catalogue.findParameter(parameterOf(catalogue, axis.roles.positionWindow));
    const double largest = spec == nullptr ? 10000.0 : spec->max;
    return std::min(2.0 * asked + axis.windowMargin, largest);
}

Result<MoveTask> moveTask(devices::Device& device, const MoveConfig& config) {
    if (isPath(config.reference)) {
        return pathTask(device, config);
    }
    if (isTable(config.reference)) {
        return tableTask(device, config);
    }
    const auto axis = chosenAxis(device.catalogue(), config.axis);
    if (!axis) {
        return failure(axis.error());
    }
    if (auto isMeant = checkQuantity(config.reference, *axis); !isMeant) {
        return failure(isMeant.error());
    }
    if (auto isOffered = checkGenerator(device.catalogue(), *axis, config.reference); !isOffered) {
        return failure(isOffered.error());
    }
    const MoveTask task{
        *axis, {}, excursionWindow(device.catalogue(), config, *axis), config.speedLimit_rad_s};
    return axis->turnsForever ? Result<MoveTask>(task) : withinBoardWindows(device, config, task);
}

Result<void> setMoveWindows(devices::Device& device, const MoveTask& task) {
    const devices::Catalogue& catalogue = device.catalogue();
    std::vector<ParameterValue> windows = {
        {parameterOf(catalogue, task.axis.roles.positionWindow), task.window},
        {parameterOf(catalogue, "window.position_enabled"), 1.0},
        {parameterOf(catalogue, task.axis.roles.speedWindow), task.speedLimit},
        {parameterOf(catalogue, "window.speed_enabled"), 1.0}};
    for (const PartnerAxis& partner : task.partners) {
        windows.push_back({parameterOf(catalogue, partner.axis.roles.positionWindow), partner.window});
    }
    // A board whose windows are always on has no switch for them.
    std::erase_if(windows, [&catalogue](const ParameterValue& value) {
        return value.name.ends_with("_enabled") && catalogue.findParameter(value.name) == nullptr;
    });
    return device.writeParameters(windows);
}

Result<void> setMoveGenerator(devices::Device& device, const MoveConfig& config,
                              const devices::AxisSpec& axis, const ProcedureObserver& observer) {
    if (isTable(config.reference)) {
        if (auto written = writeTable(device, config.reference, observer.checkAbort); !written) {
            return written;
        }
    }
    std::vector<ParameterValue> values =
        generatorParameters(config.reference, config.duration_s, axis.generator);
    holdOthers(device.catalogue(), axis, values);
    // An excitation that was cut off may have left it where a reference becomes a force.
    for (const devices::AxisSpec& each : axesOf(device.catalogue())) {
        values.push_back({each.generator + ".target", 0.0});
    }
    if (!movesSeveralAxes(config.reference) && device.catalogue().findParameter("path.shape") != nullptr) {
        values.push_back({"path.shape", 0.0});
    }
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
Result<bool> prepareMove(devices::Device& device, const MoveConfig& config, const MoveTask& task,
                         const ProcedureObserver& observer) {
    const devices::AxisSpec& axis = task.axis;
    MovePrediction prediction{config.duration_s, 0.0, 0.0};
    if (axis.effortUnit == "A" && device.catalogue().axes.size() < 2) {
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
    if (axis.turnsForever) {
        const auto rests = awaitStandstill(device, axis, observer);
        return rests ? Result<bool>(false) : failure(rests.error());
    }
    const auto homed = awaitZero(device, observer);
    if (!homed) {
        return failure(homed.error());
    }
    const auto within = checkEnds(device, config, task);
    return within ? homed : failure(*homed ? afterHoming(within.error()) : within.error());
}

bool MoveTask::moves(const devices::AxisSpec& other) const {
    return other.id == axis.id || std::any_of(partners.begin(), partners.end(), [&](const PartnerAxis& each) {
               return each.axis.id == other.id;
           });
}

} // namespace halbench::app
