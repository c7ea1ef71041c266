#include "app/procedures/relay/relay_procedure.h"

#include "app/procedures/apply/gain_transaction.h"
#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"
#include "app/procedures/excite/guarded_rotation.h"
#include "app/procedures/excite/move_reference.h"
#include "app/procedures/excite/spin_drive.h"
#include "app/procedures/frequency/frequency_board.h"
#include "app/procedures/relay/relay_judge.h"
#include "app/procedures/relay/relay_plan.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double OnTheWay_s = 0.3; // rows that are recorded but not here yet

/// Steady motion whose speed goes up and down slowly, so that the cycle cannot stay in step with the turn.
MoveReference weaving(const RelayPlan& plan) {
    MoveReference reference;
    reference.shape = MoveReference::Shape::Sine;
    reference.base = plan.turn_rad_s;
    reference.frequency_Hz = plan.weave_Hz;
    reference.amplitude = plan.weave_ratio * plan.turn_rad_s / (2.0 * Pi * plan.weave_Hz);
    return reference;
}

/// The experiment's motion as one object, so that its steps share device, observer and watch.
class RelayMotion {
public:
    RelayMotion(devices::Device& device, const ProcedureObserver& observer, RelayRun& run)
        : m_device(device), m_outer(observer), m_run(run),
          m_turn(device, observer,
                 {run.plan.turn_rad_s, run.plan.predicted.highest_rad_s,
                  "calibrate the sensors and apply the calibration, use the model of this motor, or a "
                  "smaller relay amplitude"}) {}

    Result<void> drive(double speedWindow_rad_s) {
        Result<Recording> recording =
            m_turn.record(speedWindow_rad_s, m_run.period_s, [this] { return armAndSwing(); });
        if (!recording) {
            return failure(recording.error());
        }
        m_run.recording = *std::move(recording);
        return {};
    }

private:
    Result<void> armAndSwing() {
        if (auto armed = m_device.arm(); !armed) {
            return armed;
        }
        const RelayPlan& plan = m_run.plan;
        Result<void> done = startGenerator(m_device, weaving(plan), plan.duration_s() + 2.0 * OnTheWay_s);
        const double share = plan.runUp_s / plan.duration_s();
        done = done ? waitObserved(m_device, m_turn.observer(), plan.runUp_s + OnTheWay_s, 0.0, share,
                                   "running up")
                    : done;
        done = done ? enterState(m_outer, ProcedureState::Record) : done;
        m_turn.beginWatch();
        m_run.firstRow = m_turn.rows();
        done = done ? waitObserved(m_device, m_turn.observer(), plan.measured_s + OnTheWay_s, share, 1.0,
                                   "oscillation around a steady motion")
                    : done;
        m_run.endRow = m_turn.rows();
        return done ? m_device.disarm() : done;
    }

    devices::Device& m_device;
    const ProcedureObserver& m_outer;
    RelayRun& m_run;
    GuardedRotation m_turn;
};

/// Proportional control that saturates, in mode position; everything else of the law is nothing.
Result<void> prepareBoard(devices::Device& device, const RelayPlan& plan, double speedWindow_rad_s) {
    if (auto prepared = prepareSpinning(device, speedWindow_rad_s); !prepared) {
        return prepared;
    }
    control::SampledPositionLaw law;
    law.kp_A_per_rad = plan.gain_A_per_rad;
    law.ki_A_per_rad_s = 0.0;
    std::vector<ParameterValue> values = positionLawValues(device.catalogue(), law);
    values.push_back({device.catalogue().parameterForRole("limit.current"), plan.limit_A});
    values.push_back({"reference.start", 0.0});
    values.push_back({"hb.setpoint", 0.0});
    values.push_back({"hb.mode", static_cast<double>(devices::BoardMode::Position)});
    if (auto checked = checkValues(device.catalogue(), values); !checked) {
        return checked;
    }
    if (auto written = device.writeParameters(values); !written) {
        return written;
    }
    const auto found = readBack(device, values); // nothing is armed with another limit than was foreseen
    return found ? compareValues(values, *found) : failure(found.error());
}

Result<void> checkRelayBoard(const devices::Catalogue& catalogue) {
    FrequencyConfig any;
    any.excitation = Excitation::SteppedSine; // no generator beyond that of a sine is needed
    if (auto able = checkFrequencyBoard(catalogue, any); !able) {
        return able;
    }
    for (const char* role : {"gain.kp", "limit.current"}) {
        if (catalogue.parameterForRole(role).empty()) {
            return failure(ErrorCode::DeviceRefused, fmt::format("the device has no parameter for {}", role),
                           "the relay experiment needs a position loop with a gain and a current limit");
        }
    }
    return {};
}

Result<void> checkRotor(const devices::Catalogue& catalogue) {
    const auto turns = checkTurnsForever(catalogue);
    return turns ? turns
                 : failure(turns.error().code, turns.error().message,
                           "measure the frequency response of its axes instead (identify --frequency)");
}

Result<RelayBoard> readBoard(devices::Device& device) {
    if (auto able = checkRelayBoard(device.catalogue()); !able) {
        return failure(able.error());
    }
    const auto margins = readFrequencyMargins(device);
    if (!margins) {
        return failure(margins.error());
    }
    return RelayBoard{margins->period_s, margins->law.delaySamples, margins->law.limit_A};
}

Result<RelayResult> measure(devices::Device& device, RelayRun run, const ProcedureObserver& observer) {
    // The board itself ends what gets faster than was foreseen.
    const double speedWindow_rad_s =
        std::min(run.config.speedLimit_rad_s, TurnWatch::Surprise_ratio * run.plan.predicted.peak_rad_s);
    if (auto prepared = prepareBoard(device, run.plan, speedWindow_rad_s); !prepared) {
        return failure(prepared.error());
    }
    if (auto heat = admitHeat(device, observer, run.plan.meanSquare_A2, run.plan.duration_s(),
                              run.config.pauseTemperature_degC, run.config.refuseTemperature_degC);
        !heat) {
        return failure(heat.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Excite); !entered) {
        return failure(entered.error());
    }
    const devices::LinkStatistics before = device.statistics();
    if (auto driven = RelayMotion(device, observer, run).drive(speedWindow_rad_s); !driven) {
        return failure(driven.error());
    }
    run.rowLoss = causeOfRowLoss(before, device.statistics());
    if (auto entered = enterState(observer, ProcedureState::Fit); !entered) {
        return failure(entered.error());
    }
    auto result = estimateRelay(std::move(run));
    if (!result) {
        return result;
    }
    if (auto entered = enterState(observer, ProcedureState::Judge); !entered) {
        return failure(entered.error());
    }
    result->plan.predicted.gain95 =
        foreseenGain95(result->config, {result->period_s, result->delaySamples, result->plan.limit_A});
    judgeRelay(*result);
    return result;
}

control::Estimate estimate(const std::optional<control::UltimateEstimate>& ultimate, const char* unit,
                           double value, std::pair<double, double> interval95) {
    control::Estimate result;
    result.unit = unit;
    if (ultimate) {
        result.value = value;
        result.interval95 = interval95;
        result.source = control::EstimateSource::Identified;
    }
    return result;
}

} // namespace

control::Estimate ultimateGainOf(const RelayResult& result) {
    const auto told = result.ultimate.value_or(control::UltimateEstimate{});
    return estimate(result.ultimate, "A/rad", told.at.gain, told.gain95);
}

control::Estimate ultimatePeriodOf(const RelayResult& result) {
    const auto told = result.ultimate.value_or(control::UltimateEstimate{});
    return estimate(result.ultimate, "s", 2.0 * Pi / told.at.frequency_rad_s, told.period95_s);
}

Result<RelayPlan> planRelayOn(devices::Device& device, const RelayConfig& config) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "identify"); !offered) {
        return failure(offered.error());
    }
    if (auto turns = checkRotor(device.catalogue()); !turns) {
        return failure(turns.error());
    }
    const auto board = readBoard(device);
    return board ? planRelay(config, *board) : failure(board.error());
}

Result<RelayResult> runRelay(devices::Device& device, const RelayConfig& config,
                             const ProcedureObserver& observer) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "identify"); !offered) {
        return failure(offered.error());
    }
    if (auto turns = checkRotor(device.catalogue()); !turns) {
        return failure(turns.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    const auto board = readBoard(device);
    if (!board) {
        return failure(board.error());
    }
    const auto plan = planRelay(config, *board);
    if (!plan) {
        return failure(plan.error());
    }
    auto guard = RestoreGuard::take(device);
    if (!guard) {
        return failure(guard.error());
    }
    RelayRun run{config, *plan, board->period_s, board->delaySamples, 0, 0, {}};
    auto result = restoredResult(*guard, measure(device, std::move(run), observer));
    const auto entered = enterState(observer, result ? ProcedureState::Done : ProcedureState::Restored);
    if (result && !entered) {
        return failure(entered.error());
    }
    return result;
}

} // namespace halbench::app
