#include "app/procedures/frequency/frequency_procedure.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"
#include "app/procedures/base/standstill.h"
#include "app/procedures/excite/guarded_rotation.h"
#include "app/procedures/excite/spin_drive.h"
#include "app/procedures/frequency/frequency_board.h"
#include "app/procedures/frequency/frequency_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {
namespace {

constexpr std::array<std::string_view, 3> ExcitationNames = {"multisine", "stepped-sine", "chirp"};
constexpr double OnTheWay_s = 0.3; // rows that are recorded but not here yet

Result<void> startStage(devices::Device& device, const MoveReference& reference, double duration_s) {
    return startGenerator(device, reference, duration_s + GeneratorSlack_s);
}

/// The excitation as one object, so that its steps share device, observer and watch.
class FrequencyExcitation {
public:
    FrequencyExcitation(devices::Device& device, const ProcedureObserver& observer, const FrequencyPlan& plan,
                        FrequencyRun& run)
        : m_device(device), m_outer(observer), m_plan(plan), m_run(run),
          m_turn(device, observer,
                 {plan.turn_rad_s, 0.0,
                  "use a smaller amplitude or a higher base speed; if the loop oscillates by itself, use "
                  "gains with more damping first"}) {}

    Result<void> drive() {
        Result<Recording> recording = m_turn.record(m_run.config.speedLimit_rad_s, m_run.margins.period_s,
                                                    [this] { return armAndExcite(); });
        if (!recording) {
            return failure(recording.error());
        }
        m_run.recording = *std::move(recording);
        return {};
    }

    bool cameNearStandstill() const { return m_turn.isNearStandstill(); }

private:
    Result<void> armAndExcite() {
        if (auto armed = m_device.arm(); !armed) {
            return armed;
        }
        Result<void> done = startStage(m_device, turning(), m_plan.runUp_s);
        done = done ? wait(m_plan.runUp_s, "running up") : done;
        done = done ? enterState(m_outer, ProcedureState::Record) : done;
        m_turn.beginWatch();
        for (const FrequencyStage& stage : m_plan.stages) {
            done = !done ? done : stage.sweeps > 0 ? sweep(stage) : excite(stage);
        }
        return done ? m_device.disarm() : done;
    }

    MoveReference turning() const {
        MoveReference reference;
        reference.shape = MoveReference::Shape::Ramp;
        reference.rate = m_plan.turn_rad_s;
        return reference;
    }

    /// The board's chirp runs once and then holds its position: before it ends, steady motion takes over.
    Result<void> sweep(const FrequencyStage& stage) {
        MeasuredStage measured{stage, m_turn.rows(), {}};
        Result<void> done;
        for (int i = 0; done && i < stage.sweeps; ++i) {
            // Rows that were late before the sweep before and are not any more: sweeps do not overlap.
            const std::size_t begin =
                measured.sweepRows.empty() ? std::size_t{0} : measured.sweepRows.back() + stage.rowsPerPeriod;
            measured.sweepRows.push_back(std::max(begin, m_turn.rows()));
            done = startStage(m_device, stage.reference, stage.sweep_s);
            const auto text = fmt::format("sweep from {:.3g} to {:.3g} Hz, {} of {}",
                                          stage.reference.frequency_Hz, stage.to_Hz, i + 1, stage.sweeps);
            done = done ? wait(stage.sweep_s, text) : done;
            done = done ? startStage(m_device, turning(), stage.rest_s) : done;
            done = done ? wait(stage.rest_s, text) : done;
        }
        m_run.stages.push_back(std::move(measured));
        return done ? wait(2.0 * OnTheWay_s, "waiting for the last rows") : done;
    }

    Result<void> excite(const FrequencyStage& stage) {
        const double duration_s = stage.settle_s + stage.measured_s + OnTheWay_s;
        if (auto started = startStage(m_device, stage.reference, duration_s); !started) {
            return started;
        }
        const auto settling =
            static_cast<std::size_t>(std::lround((stage.settle_s + OnTheWay_s) / m_run.margins.period_s));
        m_run.stages.push_back({stage, m_turn.rows() + settling, {}});
        return wait(duration_s + OnTheWay_s,
                    fmt::format("excitation from {:.3g} Hz", stage.reference.frequency_Hz));
    }

    Result<void> wait(double duration_s, const std::string& text) {
        const double whole_s = m_plan.duration_s();
        const double from = std::min(1.0, m_done_s / whole_s);
        m_done_s += duration_s;
        return waitObserved(m_device, m_turn.observer(), duration_s, from, std::min(1.0, m_done_s / whole_s),
                            text);
    }

    devices::Device& m_device;
    const ProcedureObserver& m_outer;
    const FrequencyPlan& m_plan;
    FrequencyRun& m_run;
    GuardedRotation m_turn;
    double m_done_s = 0.0;
};

Result<void> prepareBoard(devices::Device& device, const FrequencyConfig& config) {
    if (auto prepared = prepareSpinning(device, config.speedLimit_rad_s); !prepared) {
        return prepared;
    }
    const ParameterValue values[] = {{"reference.start", 0.0},
                                     {"hb.setpoint", 0.0},
                                     {"hb.mode", static_cast<double>(devices::BoardMode::Position)}};
    return device.writeParameters(values);
}

enum class Attempt { Measured, NearStandstill };

/// All stages of the plan. A rotor that answers more than foreseen comes near standstill: the motor is then
/// disarmed, and less may be tried where `mayTryLess`.
Result<Attempt> drive(devices::Device& device, FrequencyRun& run, const FrequencyPlan& plan,
                      const ProcedureObserver& observer, bool mayTryLess) {
    if (auto prepared = prepareBoard(device, run.config); !prepared) {
        return failure(prepared.error());
    }
    if (auto heat = admitHeat(device, observer, plan.meanSquare_A2, plan.duration_s(),
                              run.config.pauseTemperature_degC, run.config.refuseTemperature_degC);
        !heat) {
        return failure(heat.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Excite); !entered) {
        return failure(entered.error());
    }
    const devices::LinkStatistics before = device.statistics();
    run.stages.clear();
    FrequencyExcitation excitation(device, observer, plan, run);
    if (auto driven = excitation.drive(); !driven) {
        // A stop by a limit or by the user is no reason to try again.
        const bool isSlow =
            mayTryLess && driven.error().code == ErrorCode::Refused && excitation.cameNearStandstill();
        const Result<void> disarmed = isSlow ? device.disarm() : driven;
        return disarmed ? Result<Attempt>(Attempt::NearStandstill) : failure(disarmed.error());
    }
    run.rowLoss = causeOfRowLoss(before, device.statistics());
    return Attempt::Measured;
}

/// Before it is armed again: a position loop that is closed on a turning rotor would jerk it to a halt.
Result<void> standStill(devices::Device& device, const ProcedureObserver& observer) {
    const auto axis = chosenAxis(device.catalogue(), {});
    return axis ? awaitStandstill(device, *axis, observer) : failure(axis.error());
}

/// The plan foresees the published motor; a livelier one is measured with less. An amplitude that is asked
/// for stays, and a loop that swings by itself is not helped by any. Errors: of the last attempt.
Result<FrequencyPlan> driveWithin(devices::Device& device, FrequencyRun& run, FrequencyPlan plan,
                                  const ProcedureObserver& observer) {
    constexpr int MostHalvings = 3;
    for (int halvings = run.config.amplitude_rad ? MostHalvings : 0;; ++halvings) {
        const Result<Attempt> attempt = drive(device, run, plan, observer, halvings < MostHalvings);
        if (!attempt) {
            return failure(attempt.error());
        }
        if (*attempt == Attempt::Measured) {
            return plan;
        }
        for (FrequencyStage& stage : plan.stages) {
            stage.reference.amplitude *= 0.5;
        }
        if (auto stood = standStill(device, observer); !stood) {
            return failure(stood.error());
        }
    }
}

Result<FrequencyResult> measure(devices::Device& device, FrequencyRun run, const FrequencyPlan& plan,
                                const ProcedureObserver& observer) {
    const auto before_K = readSensorExcess_K(device);
    if (!before_K) {
        return failure(before_K.error());
    }
    const auto driven = driveWithin(device, run, plan, observer);
    if (!driven) {
        return failure(driven.error());
    }
    run.sensorExcess_K = *before_K;
    if (const auto warmest_degC = highestCoil_degC(device.catalogue(), run.recording)) {
        const CoilTemperatures warmest{*warmest_degC, *warmest_degC};
        run.sensorExcess_K = std::max(run.sensorExcess_K, warmest.sensorExcess_K());
    }
    const double reduced_ratio =
        driven->stages.front().reference.amplitude / plan.stages.front().reference.amplitude;
    if (auto entered = enterState(observer, ProcedureState::Fit); !entered) {
        return failure(entered.error());
    }
    auto result = estimateFrequency(std::move(run));
    if (!result) {
        return result;
    }
    if (auto entered = enterState(observer, ProcedureState::Judge); !entered) {
        return failure(entered.error());
    }
    result->quality = judgeFrequency(*result);
    if (reduced_ratio < 1.0) {
        result->quality.findings.push_back(
            {"amplitude_reduced",
             fmt::format("the rotor came near standstill: measured with {:.3g} of the planned amplitude",
                         reduced_ratio),
             "choose a higher base speed for a larger amplitude"});
    }
    return result;
}

} // namespace

std::string_view excitationName(Excitation excitation) {
    return ExcitationNames[static_cast<std::size_t>(excitation)];
}

Result<Excitation> excitation(std::string_view name) {
    const auto found = std::find(ExcitationNames.begin(), ExcitationNames.end(), name);
    if (found == ExcitationNames.end()) {
        return failure(ErrorCode::UnknownName, fmt::format("unknown excitation '{}'", name),
                       fmt::format("available: {}", fmt::join(ExcitationNames, ", ")));
    }
    return static_cast<Excitation>(found - ExcitationNames.begin());
}

Result<FrequencyResult> runFrequency(devices::Device& device, const FrequencyConfig& config,
                                     const std::optional<StrayField>& stray,
                                     const ProcedureObserver& observer) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "identify"); !offered) {
        return failure(offered.error());
    }
    if (auto turns = checkTurnsForever(device.catalogue()); !turns) {
        return failure(turns.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    if (auto able = checkFrequencyBoard(device.catalogue(), config); !able) {
        return failure(able.error());
    }
    auto margins = readFrequencyMargins(device);
    if (!margins) {
        return failure(margins.error());
    }
    const auto plan = planFrequency(config, *margins);
    if (!plan) {
        return failure(plan.error());
    }
    auto guard = RestoreGuard::take(device);
    if (!guard) {
        return failure(guard.error());
    }
    FrequencyRun run{config, *margins, plan->turn_rad_s, stray, {}, {}};
    auto result = restoredResult(*guard, measure(device, std::move(run), *plan, observer));
    const auto entered = enterState(observer, result ? ProcedureState::Done : ProcedureState::Restored);
    if (result && !entered) {
        return failure(entered.error());
    }
    return result;
}

} // namespace halbench::app
