#include "app/procedures/identify/identify_procedure.h"

#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"
#include "app/procedures/base/row_loss.h"
#include "app/procedures/excite/excitation_limits.h"
#include "app/procedures/excite/spin_drive.h"
#include "app/procedures/identify/identify_estimate.h"
#include "app/procedures/identify/identify_plan.h"
#include "app/procedures/identify/pilot_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double Rate_Hz = 100.0;

std::vector<std::string> wantedSignals(const devices::Catalogue& catalogue) {
    std::vector<std::string> signals = catalogue.defaultSignals;
    for (const char* name : {"position", "speed", "current_command", "reference.segment",
                             "coil_temperature.a", "coil_temperature.b"}) {
        if (std::find(signals.begin(), signals.end(), name) == signals.end()) {
            signals.emplace_back(name);
        }
    }
    return signals;
}

Result<double> currentLimit_A(devices::Device& device) {
    const std::string name[] = {"limit.current"};
    const auto values = device.readParameters(name);
    if (!values) {
        return failure(values.error());
    }
    return values->front();
}

Result<void> checkConfig(const IdentifyConfig& config) {
    if (!std::isfinite(config.speedLimit_rad_s) || config.speedLimit_rad_s <= config.usableSpeed_rad_s) {
        return failure(ErrorCode::OutOfRange, "the speed limit leaves no usable speed",
                       "allow e.g. 40 rad/s");
    }
    if (config.coastDownsPerDirection < 0 || config.coastDownsPerDirection > 16) {
        return failure(ErrorCode::OutOfRange, "0 to 16 coast-downs in each direction are possible", {});
    }
    return {};
}

/// The currents of a sweep, brought below the highest of a run that got too fast.
std::vector<double> belowCurrent(std::vector<double> currents_A, const PlateauRun& run) {
    constexpr double Share = 0.9; // of that current
    double highest_A = 0.0;
    for (const double current_A : run.currents_A) {
        highest_A = std::max(highest_A, std::fabs(current_A));
    }
    const double scale = std::min(1.0, Share * highest_A / currents_A.back());
    for (double& current_A : currents_A) {
        current_A *= scale;
    }
    return currents_A;
}

/// The excitation as one object, so that its steps share device, observer and limits.
class Excitation {
public:
    Excitation(devices::Device& device, const IdentifyConfig& config, const ProcedureObserver& observer)
        : m_device(device), m_config(config), m_outer(observer),
          m_watch("speed"), m_heat{config.pauseTemperature_degC, config.refuseTemperature_degC} {
        m_observer = listeningIn(observer, [this](const SampleBlock& block) {
            m_watch.take(block);
            if (m_pilot) {
                m_pilot->take(block);
            }
        });
    }

    /// Everything from the pilot to the last coast-down; gives the recording.
    Result<Recording> run(const std::vector<double>& currents_A) {
        StreamRecorder recorder(m_device, m_observer);
        recorder.guardBy(excitationLimits(m_device.catalogue(), m_config.speedLimit_rad_s));
        if (auto started = recorder.start(wantedSignals(m_device.catalogue()), Rate_Hz); !started) {
            return failure(started.error());
        }
        m_pilot.emplace(m_device, m_observer, m_config);
        const auto pilot = m_pilot->find(currents_A);
        if (!pilot) {
            return failure(recorder.causeOf(pilot.error()));
        }
        if (*pilot) {
            if (auto done = runAll(currents_A, **pilot); !done) {
                return failure(recorder.causeOf(done.error()));
            }
        }
        return recorder.finish();
    }

private:
    /// A run that had to end because it got too fast shows that the pilot took the motor for a slower one,
    /// e.g. where friction falls with speed: what is left is planned anew by all that was seen, below that
    /// current.
    Result<void> runAll(std::vector<double> currents_A, const PilotEstimate& pilot) {
        constexpr int MostPlans = 8;
        if (auto entered = enterState(m_outer, ProcedureState::Record); !entered) {
            return entered;
        }
        std::vector<PlateauRun> runs = planRuns(m_config, currents_A, pilot);
        int plans = 1;
        for (std::size_t i = 0; i < runs.size();) {
            const auto ended = runPlateaus(m_device, m_observer, runs[i], m_heat, m_watch);
            if (!ended) {
                return failure(ended.error());
            }
            if (*ended == RunEnd::Complete || plans == MostPlans) {
                ++i;
                continue;
            }
            const std::size_t before = runs.size();
            currents_A = belowCurrent(currents_A, runs[i]);
            runs = planRuns(m_config, currents_A, m_pilot->estimate().value_or(pilot));
            i = runs.size() == before ? i : 0;
            ++plans;
        }
        return {};
    }

    devices::Device& m_device;
    const IdentifyConfig& m_config;
    const ProcedureObserver& m_outer;
    ProcedureObserver m_observer; ///< the outer one, listened in
    SpeedWatch m_watch;
    HeatLimits m_heat;
    std::optional<PilotMotion> m_pilot; ///< sees all runs
};

Result<IdentifyResult> excite(devices::Device& device, const IdentifyConfig& config,
                              const ProcedureObserver& observer, const std::vector<double>& currents_A) {
    if (auto prepared = prepareSpinning(device, config.speedLimit_rad_s); !prepared) {
        return failure(prepared.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Excite); !entered) {
        return failure(entered.error());
    }
    const devices::LinkStatistics before = device.statistics();
    auto recording = Excitation(device, config, observer).run(currents_A);
    if (!recording) {
        return failure(recording.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Fit); !entered) {
        return failure(entered.error());
    }
    auto result = identifyRecording(*recording, config, observer.checkAbort);
    if (!result) {
        return failure(result.error());
    }
    nameRowLoss(result->quality, causeOfRowLoss(before, device.statistics()));
    result->recording = std::move(*recording);
    if (auto entered = enterState(observer, ProcedureState::Judge); !entered) {
        return failure(entered.error());
    }
    return result;
}

} // namespace

Result<IdentifyResult> runIdentify(devices::Device& device, const IdentifyConfig& config,
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
    if (auto checked = checkConfig(config); !checked) {
        return failure(checked.error());
    }
    const auto limit_A = currentLimit_A(device);
    if (!limit_A) {
        return failure(limit_A.error());
    }
    const auto currents_A = sweepCurrents_A(config.sweep, *limit_A);
    if (!currents_A) {
        return failure(currents_A.error());
    }
    auto guard = RestoreGuard::take(device);
    if (!guard) {
        return failure(guard.error());
    }
    const MeasuredTiming timing = timingOf(device.catalogue(), guard->snapshot());
    auto result = restoredResult(*guard, excite(device, config, observer, *currents_A));
    if (!result) {
        (void)enterState(observer, ProcedureState::Restored);
        return result;
    }
    result->timing = timing;
    if (auto entered = enterState(observer, ProcedureState::Done); !entered) {
        return failure(entered.error());
    }
    return result;
}

} // namespace halbench::app
