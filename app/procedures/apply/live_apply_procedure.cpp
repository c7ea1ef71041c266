#include "app/procedures/apply/live_apply_procedure.h"

#include "app/procedures/apply/gain_transaction.h"
#include "app/procedures/apply/live_step_judge.h"
#include "app/procedures/apply/prediction_monitor.h"
#include "app/procedures/apply/verify_move.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "control/law/board_law.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <utility>

namespace halbench::app {
namespace {

using control::PositionLaw;

/// The gains of now by the names of the law; `values` are those of the device.
Result<PositionLaw> lawOf(const PositionLaw& target, const devices::Catalogue& catalogue,
                          const std::vector<ParameterValue>& values) {
    std::map<std::string, double> byName;
    for (const ParameterValue& canonical : lawParameters(target)) {
        const std::string byRole = catalogue.parameterForRole(canonical.name);
        const std::string& name = byRole.empty() ? canonical.name : byRole;
        for (const ParameterValue& value : values) {
            if (value.name == name) {
                byName[canonical.name] = value.value;
            }
        }
    }
    return lawFromParameters(byName);
}

ApplyVerification verificationOf(const LiveApplyConfig& config, double direction) {
    ApplyVerification verification = stepVerification(config.motor);
    verification.draws = config.draws;
    verification.reference.amplitude = direction * config.amplitude_rad;
    verification.duration_s = config.duration_s;
    return verification;
}

MotionEnvelope mirrored(const MotionEnvelope& band) {
    MotionEnvelope result = band;
    for (std::size_t i = 0; i < band.time_s.size(); ++i) {
        result.angle_rad.p5[i] = -band.angle_rad.p95[i];
        result.angle_rad.p95[i] = -band.angle_rad.p5[i];
    }
    return result;
}

/// One way from snapshot to target; what it holds is for one device and one run.
class Walk {
public:
    Walk(devices::Device& device, const LiveApplyConfig& config, const ProcedureObserver& observer)
        : m_device(device), m_config(config), m_observer(observer) {}

    Result<LiveApplyResult> run();

private:
    Result<std::vector<LiveStep>> plan(const std::vector<ParameterValue>& targetValues);
    Result<LiveApplyResult> runInside(const std::vector<LiveStep>& steps, RestoreGuard& guard);
    Result<bool> goStep(const LiveStep& step, double direction);
    Result<std::vector<ParameterValue>> write(const PositionLaw& law);
    Result<bool> prove(const LiveStep& step, double direction, LiveStepResult& done);
    Result<void> confirmRestored();
    ProcedureObserver counting(const ProcedureObserver& of) const;

    devices::Device& m_device;
    const LiveApplyConfig& m_config;
    const ProcedureObserver& m_observer;
    LiveApplyResult m_result;
};

Result<std::vector<LiveStep>> Walk::plan(const std::vector<ParameterValue>& targetValues) {
    const auto before = readBack(m_device, targetValues);
    if (!before) {
        return failure(before.error());
    }
    m_result.apply.before = *before;
    const auto from = lawOf(m_config.target, m_device.catalogue(), *before);
    if (!from) {
        return failure(from.error());
    }
    // To compute takes seconds on a slow machine; a board that hears nothing for one takes its master for
    // lost.
    constexpr double Service_s = 0.01;
    return planLiveApply(*from, m_config, [this] { return waitObserved(m_device, m_observer, Service_s); });
}

Result<std::vector<ParameterValue>> Walk::write(const PositionLaw& law) {
    auto values = lawForDevice(LoopLaw(law), m_device.catalogue()); // finite and within the device's limits
    if (!values) {
        return values;
    }
    if (auto written = m_device.writeParameters(*values); !written) {
        return failure(written.error());
    }
    auto found = readBack(m_device, *values);
    if (!found) {
        return found;
    }
    if (auto same = compareValues(*values, *found); !same) {
        return failure(same.error());
    }
    return found;
}

/// How far the whole is: a step is its share of it.
ProcedureObserver Walk::counting(const ProcedureObserver& of) const {
    ProcedureObserver counted = of;
    counted.onProgress = [this, of](double fraction, const std::string& text) {
        if (of.onProgress) {
            const auto done = static_cast<double>(m_result.steps.size());
            of.onProgress(
                (done + fraction) / static_cast<double>(m_result.plannedSteps),
                fmt::format("step {} of {}: {}", m_result.steps.size() + 1, m_result.plannedSteps, text));
        }
    };
    return counted;
}

Result<bool> Walk::prove(const LiveStep& step, double direction, LiveStepResult& done) {
    const MotionEnvelope band = direction > 0.0 ? step.band : mirrored(step.band);
    PredictionMonitor watch(m_observer, band);
    ApplyVerification verification = verificationOf(m_config, direction);
    verification.band = band;
    ApplyResult verified;
    const auto moved = verifyMove(m_device, verification, counting(watch.observer()), verified);
    const bool isEndedByWatch = !moved && watch.hasLeft() && moved.error().code == ErrorCode::Refused;
    if (!moved && !isEndedByWatch) {
        return failure(moved.error()); // also when a limit of the board or the link came first
    }
    ApplyResult& whole = m_result.apply;
    whole.predicted.reset(); // a move that was ended is not the one of the step before
    whole.verification.reset();
    whole.band.reset();
    whole.quality = {};
    if (moved) {
        done.widening_ratio = verified.band->widening_ratio;
        whole.predicted = std::move(verified.predicted);
        whole.verification = std::move(verified.verification);
        whole.band = std::move(verified.band);
        whole.quality = std::move(verified.quality);
    }
    if (watch.hasLeft() && whole.quality.verdict != Verdict::Refused) {
        const Error why = watch.departure();
        whole.quality = {Verdict::Refused, {{"left_predicted_band", why.message, why.hint}}};
    }
    return whole.quality.verdict != Verdict::Refused;
}

Result<bool> Walk::goStep(const LiveStep& step, double direction) {
    if (auto entered = enterState(m_observer, ProcedureState::Apply); !entered) {
        return failure(entered.error());
    }
    const auto written = write(step.law);
    if (!written) {
        return failure(written.error());
    }
    m_result.apply.after = *written;
    LiveStepResult done{*written, step.robust, 0.0, false};
    const auto isWithin = prove(step, direction, done);
    if (!isWithin) {
        return isWithin;
    }
    done.isWithin = *isWithin;
    m_result.steps.push_back(std::move(done));
    return isWithin;
}

Result<LiveApplyResult> Walk::runInside(const std::vector<LiveStep>& steps, RestoreGuard& guard) {
    double direction = 1.0;
    for (const LiveStep& step : steps) {
        const auto isWithin = goStep(step, direction);
        if (!isWithin) {
            return failure(isWithin.error());
        }
        if (!*isWithin) {
            return m_result;
        }
        direction = -direction;
    }
    if (auto goOn = m_observer.checkAbort ? m_observer.checkAbort() : Result<void>(); !goOn) {
        return failure(goOn.error());
    }
    if (auto kept = keepValues(m_device, guard, m_result.apply.after); !kept) {
        return failure(kept.error());
    }
    guard.keep();
    m_result.apply.isKept = true;
    return m_result;
}

/// That the board confirmed the writing is not taken for it: the old gains are read.
Result<void> Walk::confirmRestored() {
    const auto found = readBack(m_device, m_result.apply.before);
    if (!found) {
        return failure(found.error());
    }
    return compareValues(m_result.apply.before, *found);
}

/// Steps lead from plain gains to plain gains: what a filter makes of the way between is not judged.
Result<void> checkPlainLaw(devices::Device& device) {
    const auto law = readPositionLaw(device);
    if (!law) {
        return failure(law.error());
    }
    return control::isBoardLaw(control::filteredLaw(*law))
               ? Result<void>()
               : failure(ErrorCode::Refused, "the device's control law has set-point weights or filters",
                         "apply the gains in one step: this removes them");
}

Result<LiveApplyResult> Walk::run() {
    if (auto offered = checkProcedureOffered(m_device.catalogue(), "apply"); !offered) {
        return failure(offered.error());
    }
    if (auto single = checkSingleLoop(m_device.catalogue(), "apply"); !single) {
        return failure(single.error());
    }
    if (auto entered = enterState(m_observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    if (auto plain = checkPlainLaw(m_device); !plain) {
        return failure(plain.error());
    }
    const auto target = lawForDevice(LoopLaw(m_config.target), m_device.catalogue());
    if (!target) {
        return failure(target.error());
    }
    auto guard = RestoreGuard::take(m_device, namesOf(*target));
    if (!guard) {
        return failure(guard.error());
    }
    if (auto entered = enterState(m_observer, ProcedureState::Propose); !entered) {
        return failure(entered.error());
    }
    const auto steps = plan(*target);
    if (!steps) {
        return restoredResult(*guard, Result<LiveApplyResult>(failure(steps.error())));
    }
    m_result.plannedSteps = steps->size();
    const auto result = runInside(*steps, *guard);
    const bool isKept = result && result->apply.isKept;
    const Result<void> restored = guard->restore();
    const Result<void> confirmed = restored && !isKept ? confirmRestored() : restored;
    if (confirmed) {
        return result;
    }
    if (isKept) {
        return failure(confirmed.error());
    }
    const Error cause =
        result ? Error{ErrorCode::DeviceRefused, "the new gains were not kept", {}} : result.error();
    return failure(unconfirmedRestore(cause, confirmed.error()));
}

} // namespace

Result<LiveApplyResult> runLiveApply(devices::Device& device, const LiveApplyConfig& config,
                                     const ProcedureObserver& observer) {
    auto result = Walk(device, config, observer).run();
    const bool isKept = result && result->apply.isKept;
    // As of an apply: an abort that comes now finds it done or undone, never half.
    (void)enterState(observer, isKept ? ProcedureState::Done : ProcedureState::Restored);
    return result;
}

MoveOutlook liveStepOutlook(const LiveApplyConfig& config, const devices::Catalogue& catalogue) {
    return moveOutlook(moveOf(verificationOf(config, 1.0)), catalogue);
}

} // namespace halbench::app
