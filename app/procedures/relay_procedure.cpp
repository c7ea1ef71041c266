#include "app/procedures/relay_procedure.h"

#include "app/procedures/coil_forecast.h"
#include "app/procedures/excitation_limits.h"
#include "app/procedures/frequency_board.h"
#include "app/procedures/gain_transaction.h"
#include "app/procedures/move_reference.h"
#include "app/procedures/position_law_parameters.h"
#include "app/procedures/procedure_steps.h"
#include "app/procedures/relay_judge.h"
#include "app/procedures/relay_plan.h"
#include "app/procedures/restored_result.h"
#include "app/procedures/spin_drive.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double OnTheWay_s = 0.3;       // rows that are recorded but not here yet
constexpr double Surprise_ratio = 1.5;   // of the speed that was foreseen
constexpr double LeastShare_ratio = 0.1; // of the base speed

std::vector<std::string> recordedSignals() {
    return {"position",           "speed",      "reference",      "current_command", "coil_temperature.a",
            "coil_temperature.b", "torn_count", "truth.position", "truth.speed"};
}

/// Ends the run when the speed leaves what was foreseen: near standstill friction would change its sign, and
/// what swings more than it should is not the loop of the plan.
class SwingWatch {
public:
    explicit SwingWatch(const RelayPlan& plan)
        : m_turn_rad_s(plan.turn_rad_s),
          m_most_ratio(Surprise_ratio * plan.predicted.highest_rad_s / std::abs(plan.turn_rad_s)) {}

    void take(const SampleBlock& block) {
        const int column = block.layout->indexOf("speed");
        for (std::size_t row = 0; m_isOn && column >= 0 && row < block.rows(); ++row) {
            const double share = block.value(row, static_cast<std::size_t>(column)) / m_turn_rad_s;
            m_lowest_ratio = std::min(m_lowest_ratio, share);
            m_highest_ratio = std::max(m_highest_ratio, share);
        }
    }
    void begin() { m_isOn = true; }
    Result<void> check() const {
        if (m_lowest_ratio < LeastShare_ratio) {
            return failure(
                ErrorCode::Refused,
                fmt::format("the rotor came down to {:.3g} rad/s on a base of {:.3g} rad/s: near "
                            "standstill friction is no plain offset",
                            m_lowest_ratio * m_turn_rad_s, m_turn_rad_s),
                "calibrate the sensors and apply it, use the model of this motor, or a lower relay");
        }
        if (m_highest_ratio > m_most_ratio) {
            return failure(ErrorCode::Refused,
                           fmt::format("the rotor reached {:.3g} rad/s, foreseen were {:.3g}",
                                       m_highest_ratio * std::abs(m_turn_rad_s),
                                       m_most_ratio / Surprise_ratio * std::abs(m_turn_rad_s)),
                           "identify the motor and give its model: the plan was made for another one");
        }
        return {};
    }

private:
    double m_turn_rad_s;
    double m_most_ratio;
    double m_lowest_ratio = 1.0;
    double m_highest_ratio = 1.0;
    bool m_isOn = false;
};

/// Steady motion whose speed goes up and down slowly, so that the cycle cannot stay in step with the turn.
MoveReference weaving(const RelayPlan& plan) {
    MoveReference reference;
    reference.shape = MoveReference::Shape::Sine;
    reference.base_rad_s = plan.turn_rad_s;
    reference.frequency_Hz = plan.weave_Hz;
    reference.amplitude_rad = plan.weave_ratio * plan.turn_rad_s / (2.0 * Pi * plan.weave_Hz);
    return reference;
}

/// The experiment's motion as one object, so that its steps share device, observer and watch.
class RelayMotion {
public:
    RelayMotion(devices::Device& device, const ProcedureObserver& observer, RelayRun& run)
        : m_device(device), m_outer(observer), m_observer(observer), m_watch(run.plan), m_run(run),
          m_recorder(device, m_observer) {
        m_observer.onBlock = [this](const SampleBlockPtr& block) {
            m_watch.take(*block);
            if (m_outer.onBlock) {
                m_outer.onBlock(block);
            }
        };
        m_observer.checkAbort = [this]() -> Result<void> {
            const Result<void> goOn = m_outer.checkAbort ? m_outer.checkAbort() : Result<void>();
            const Result<void> isSound = goOn ? m_recorder.check() : goOn;
            return isSound ? m_watch.check() : isSound;
        };
    }

    Result<void> drive(double speedWindow_rad_s) {
        m_recorder.guardBy(excitationLimits(m_device.catalogue(), speedWindow_rad_s));
        if (auto started = m_recorder.start(withWatchedSignals(m_device.catalogue(), recordedSignals()),
                                            1.0 / m_run.period_s);
            !started) {
            return started;
        }
        if (auto done = armAndSwing(); !done) {
            return failure(m_recorder.causeOf(done.error()));
        }
        Result<Recording> recording = m_recorder.finish();
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
        Result<void> done = startReference();
        const double share = plan.runUp_s / plan.duration_s();
        done = done ? waitObserved(m_device, m_observer, plan.runUp_s + OnTheWay_s, 0.0, share, "runs up")
                    : done;
        done = done ? enterState(m_outer, ProcedureState::Record) : done;
        m_watch.begin();
        m_run.firstRow = m_recorder.rows();
        done = done ? waitObserved(m_device, m_observer, plan.measured_s + OnTheWay_s, share, 1.0,
                                   "swings around a steady motion")
                    : done;
        m_run.endRow = m_recorder.rows();
        return done ? m_device.disarm() : done;
    }

    Result<void> startReference() {
        std::vector<ParameterValue> values =
            generatorParameters(weaving(m_run.plan), m_run.plan.duration_s() + 2.0 * OnTheWay_s);
        std::erase_if(values, [this](const ParameterValue& value) {
            return m_device.catalogue().findParameter(value.name) == nullptr;
        });
        values.push_back({"reference.start", 1.0});
        return m_device.writeParameters(values);
    }

    devices::Device& m_device;
    const ProcedureObserver& m_outer;
    ProcedureObserver m_observer; ///< the outer one, listened in
    SwingWatch m_watch;
    RelayRun& m_run;
    StreamRecorder m_recorder;
};

/// Proportional control that saturates, in mode position; everything else of the law is nothing.
Result<void> prepareBoard(devices::Device& device, const RelayPlan& plan, double speedWindow_rad_s) {
    if (auto prepared = prepareSpinning(device, speedWindow_rad_s); !prepared) {
        return prepared;
    }
    models::PositionLaw law;
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
        std::min(run.config.speedLimit_rad_s, Surprise_ratio * run.plan.predicted.peak_rad_s);
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
    if (auto driven = RelayMotion(device, observer, run).drive(speedWindow_rad_s); !driven) {
        return failure(driven.error());
    }
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
    const auto board = readBoard(device);
    return board ? planRelay(config, *board) : failure(board.error());
}

Result<RelayResult> runRelay(devices::Device& device, const RelayConfig& config,
                             const ProcedureObserver& observer) {
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
