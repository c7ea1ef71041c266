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
        m_pilot.reset();
        if (!pilot) {
            return failure(recorder.causeOf(pilot.error()));
        }
        if (*pilot) {
            if (auto done = runAll(planRuns(m_config, currents_A, **pilot)); !done) {
                return failure(recorder.causeOf(done.error()));
            }
        }
        return recorder.finish();
    }

private:
    Result<void> runAll(const std::vector<PlateauRun>& runs) {
        if (auto entered = enterState(m_outer, ProcedureState::Record); !entered) {
            return entered;
        }
        for (const PlateauRun& run : runs) {
            if (auto done = runPlateaus(m_device, m_observer, run, m_heat, m_watch); !done) {
                return done;
            }
        }
        return {};
    }

    devices::Device& m_device;
    const IdentifyConfig& m_config;
    const ProcedureObserver& m_outer;
    ProcedureObserver m_observer; ///< the outer one, listened in
    SpeedWatch m_watch;
    HeatLimits m_heat;
    std::optional<PilotMotion> m_pilot; ///< while it runs
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
