#include "app/procedures/move/move_procedure.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/axis_zero.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"
#include "app/procedures/base/row_loss.h"
#include "app/procedures/excite/excitation_limits.h"
#include "app/procedures/excite/table_reference.h"
#include "app/procedures/excite/travel_reference.h"
#include "app/procedures/move/move_preparation.h"
#include "app/procedures/move/move_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::app {
namespace {

/// The board begins at its next position sample (10 ms); one more period for the last rows on their way.
constexpr double Tail_s = 0.03;

Result<void> checkMove(const MoveConfig& config) {
    if (auto complete = checkMoveReference(config.reference); !complete) {
        return complete;
    }
    constexpr double Longest_s = 3600.0;
    if (!std::isfinite(config.duration_s) || config.duration_s < 0.05 || config.duration_s > Longest_s) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a move of {} s is out of range", config.duration_s),
                       "Allowed: 0.05 to 3600 s.");
    }
    const auto travel_s = travelTime_s(config.reference);
    if (travel_s && *travel_s > config.duration_s + 1e-9) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("the {} takes {:.4g} s, the move ends after {:.4g} s",
                                   moveShapeName(config.reference.shape), *travel_s, config.duration_s),
                       "Move for longer, or leave the duration out.");
    }
    return {};
}

// A small board has no event as fast as that, and its line would not carry it: then once each position loop.
MoveConfig atPossibleRate(const devices::Device& device, const devices::AxisSpec& axis, MoveConfig config) {
    const SignalSpec* position =
        device.catalogue().findSignal(signalOf(device.catalogue(), axis.roles.position));
    if (position != nullptr && position->maxRate_Hz < config.rate_Hz) {
        config.rate_Hz = 1.0 / loopPeriod_s(device.catalogue());
    }
    return config;
}

// From arming to the last sample.
Result<void> follow(devices::Device& device, const MoveConfig& config, const devices::AxisSpec& axis,
                    const ProcedureObserver& observer) {
    if (auto armed = device.arm(); !armed) {
        return armed;
    }
    // At rest before the reference starts: gives the origin.
    if (auto settled = waitObserved(device, observer, axis.settle_s, 0.0, 0.0, "position hold"); !settled) {
        return settled;
    }
    const ParameterValue start[] = {{"reference.start", 1.0}};
    if (auto started = device.writeParameters(start); !started) {
        return started;
    }
    if (auto entered = enterState(observer, ProcedureState::Record); !entered) {
        return entered;
    }
    if (auto moved = waitObserved(device, observer, config.duration_s + Tail_s, 0.05, 0.95, "move running");
        !moved) {
        return moved;
    }
    return device.disarm();
}

Result<MoveResult> runGuarded(devices::Device& device, const MoveConfig& config,
                              const ProcedureObserver& observer) {
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    auto guard = RestoreGuard::take(device);
    if (!guard) {
        return failure(guard.error());
    }
    return restoredResult(*guard, performMove(device, config, observer));
}

/// Of a path or table the first one.
Result<devices::AxisSpec> axisOfMove(const MoveConfig& config, const devices::Catalogue& catalogue) {
    if (isTable(config.reference)) {
        const auto axes = tableAxes(catalogue, config.reference);
        return axes ? Result<devices::AxisSpec>(axes->front()) : failure(axes.error());
    }
    if (!isPath(config.reference)) {
        return chosenAxis(catalogue, config.axis);
    }
    const auto pair = pathAxes(catalogue);
    return pair ? Result<devices::AxisSpec>(pair->front()) : failure(pair.error());
}

} // namespace

MoveOutlook moveOutlook(const MoveConfig& config, const devices::Catalogue& catalogue) {
    const auto axis = axisOfMove(config, catalogue).value_or(devices::AxisSpec{});
    return {referenceExcursion(config.reference, config.duration_s, axis.id),
            excursionWindow(catalogue, config, axis), config.speedLimit_rad_s,
            axis.settle_s + config.duration_s + Tail_s, travelTime_s(config.reference)};
}

MovePrediction predictMove(const MoveConfig& config, const control::SampledPositionLaw& law,
                           const models::RotorConfig& motor, double torqueConstant_Nm_per_A) {
    constexpr double Margin_ratio =
        1.25; // of the current: friction scatter and a motor that is not quite this one
    const double limit_A = law.limit_A;
    const auto reference = idealReference(config.reference);
    if (!reference) {
        return {config.duration_s, limit_A, limit_A * limit_A};
    }
    models::IdealLoopConfig loop;
    loop.rotor = motor;
    loop.torqueConstant_Nm_per_A = torqueConstant_Nm_per_A;
    loop.law = law;
    loop.reference = *reference;
    loop.duration_s = config.duration_s;
    const models::IdealTrace trace = models::runIdealLoop(loop);
    double square = 0.0;
    double peak_A = 0.0;
    for (const double current_A : trace.current_A) {
        peak_A = std::max(peak_A, std::fabs(current_A));
        square += current_A * current_A / static_cast<double>(trace.current_A.size());
    }
    const double withMargin = std::min(square * Margin_ratio * Margin_ratio, limit_A * limit_A);
    return {config.duration_s, peak_A, withMargin};
}

Result<MoveResult> performMove(devices::Device& device, const MoveConfig& wanted,
                               const ProcedureObserver& observer) {
    if (auto checked = checkMove(wanted); !checked) {
        return failure(checked.error());
    }
    const Result<MoveTask> task = moveTask(device, wanted);
    if (!task) {
        return failure(task.error());
    }
    const MoveConfig config = atPossibleRate(device, task->axis, wanted);
    const auto homed = prepareMove(device, config, *task, observer);
    if (!homed) {
        return failure(homed.error());
    }
    if (auto set = setMoveWindows(device, *task); !set) {
        return failure(set.error());
    }
    if (auto set = setMoveGenerator(device, config, task->axis, observer); !set) {
        return failure(set.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Excite); !entered) {
        return failure(entered.error());
    }
    const devices::LinkStatistics before = device.statistics();
    StreamRecorder recorder(device, observer);
    recorder.guardBy(excitationLimits(device.catalogue(), task->speedLimit, task->window, task->axis));
    if (auto started = recorder.start(moveSignals(device.catalogue()), config.rate_Hz); !started) {
        return failure(started.error());
    }
    if (auto followed = follow(device, config, task->axis, observer); !followed) {
        return failure(recorder.causeOf(followed.error()));
    }
    Result<Recording> recording = recorder.finish();
    if (!recording) {
        return failure(recording.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Judge); !entered) {
        return failure(entered.error());
    }
    Result<MoveResult> result = judgeRecording(*std::move(recording), config, *task, device.catalogue());
    if (result) {
        result->travel_s = travelTime_s(config.reference);
        if (*homed) {
            result->quality.findings.push_back(homedHere());
        }
        nameRowLoss(result->quality, causeOfRowLoss(before, device.statistics()));
    }
    return result;
}

Result<MoveResult> runMove(devices::Device& device, const MoveConfig& config,
                           const ProcedureObserver& observer) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "move"); !offered) {
        return failure(offered.error());
    }
    Result<MoveResult> result = runGuarded(device, config, observer);
    const auto entered = enterState(observer, result ? ProcedureState::Done : ProcedureState::Restored);
    if (result && !entered) {
        return failure(entered.error());
    }
    return result;
}

} // namespace halbench::app
