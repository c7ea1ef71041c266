#include "app/procedures/calibrate_procedure.h"

namespace halbench::app {

// Weak: only until the calibrations are part of this build; the caller then gets an honest refusal.

__attribute__((weak)) std::string_view calibrationName(Calibration calibration) {
    switch (calibration) {
    case Calibration::Hall:
        return "hall";
    case Calibration::Stray:
        return "stray";
    case Calibration::StaticFriction:
        return "static-friction";
    }
    return "hall";
}

__attribute__((weak)) Result<CalibrateResult> runCalibrate(devices::Device&, const CalibrateConfig&,
                                                           const ProcedureObserver&) {
    return failure(ErrorCode::Usage, "calibrate is not built in this version", "leave the step out");
}

} // namespace halbench::app
