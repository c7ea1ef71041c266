#include "app/actuators/spherical/sensing_calibrate.h"

#include "app/actuators/spherical/sensing_board.h"
#include "app/actuators/spherical/sensing_fit.h"
#include "app/actuators/spherical/sensing_motion.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"

#include <algorithm>

namespace halbench::app {
namespace {

constexpr double Duration_s = 60.0;

Result<void> measure(devices::Device& device, const CalibrateConfig& config,
                     const ProcedureObserver& observer, CalibrateResult& result) {
    const auto board = readSensingBoard(device);
    if (!board) {
        return failure(board.error());
    }
    const bool isStray =
        std::find(config.which.begin(), config.which.end(), Calibration::Stray) != config.which.end();
    const auto motion =
        recordSensedMotion(device, Duration_s, observer, isStray ? config.strayCurrent_A : 0.0);
    if (!motion) {
        return failure(motion.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Fit); !entered) {
        return entered;
    }
    if (auto fitted = concludeSensing(*motion, *board, config, observer.checkAbort, result); !fitted) {
        return fitted;
    }
    return enterState(observer, ProcedureState::Judge);
}

} // namespace

Result<void> checkSensingCalibrate(const devices::Catalogue&, const CalibrateConfig& config) {
    const auto isSensed = [](Calibration which) { return which != Calibration::StaticFriction; };
    if (std::any_of(config.which.begin(), config.which.end(), isSensed)) {
        return {};
    }
    return failure(ErrorCode::Usage, "a device that only senses has no static friction to calibrate",
                   "choose hall, stray or all");
}

CalibratePrediction predictSensingCalibrate(const CalibrateConfig&, double) {
    return {Duration_s, 0.0, 0.0};
}

Result<CalibrateResult> calibrateSensing(devices::Device& device, const CalibrateConfig& config,
                                         const ProcedureObserver& observer) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "calibrate"); !offered) {
        return failure(offered.error());
    }
    if (auto checked = checkSensingCalibrate(device.catalogue(), config); !checked) {
        return failure(checked.error());
    }
    return guardedCalibration(device, config, observer, measure);
}

Result<CalibrateResult> calibrateSensingRecording(const Recording& recording,
                                                  const std::vector<ParameterValue>& noted,
                                                  const CalibrateConfig& config,
                                                  const AbortCheck& checkAbort) {
    if (auto checked = checkSensingCalibrate({}, config); !checked) {
        return failure(checked.error());
    }
    const auto motion = sensedMotion(recording);
    if (!motion) {
        return failure(motion.error());
    }
    const SensingBoard board = notedSensingBoard(noted);
    CalibrateResult result;
    if (auto fitted = concludeSensing(*motion, board, config, checkAbort, result); !fitted) {
        return failure(fitted.error());
    }
    return result;
}

} // namespace halbench::app
