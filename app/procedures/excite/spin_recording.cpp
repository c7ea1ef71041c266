#include "app/procedures/excite/spin_recording.h"

#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/excite/excitation_limits.h"

namespace halbench::app {

Result<Recording> recordSpin(devices::Device& device, const ProcedureObserver& observer,
                             std::span<const PlateauRun> runs, double speedLimit_rad_s,
                             const std::vector<std::string>& signals) {
    SpeedWatch watch("speed");
    const ProcedureObserver listening =
        listeningIn(observer, [&watch](const SampleBlock& block) { watch.take(block); });
    StreamRecorder recorder(device, listening);
    recorder.guardBy(excitationLimits(device.catalogue(), speedLimit_rad_s));
    if (auto started = recorder.start(withWatchedSignals(device.catalogue(), signals), 100.0); !started) {
        return failure(started.error());
    }
    for (const PlateauRun& run : runs) {
        if (auto done = runPlateaus(device, listening, run, {}, watch); !done) {
            return failure(recorder.causeOf(done.error()));
        }
    }
    return recorder.finish();
}

} // namespace halbench::app
