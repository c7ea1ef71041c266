#include "app/actuators/axes/axes_actuator.h"

#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/identify/axes_procedure.h"

#include <array>

namespace halbench::app {
namespace {

constexpr std::array AxesConstants = {KnownConstant{"m", "kg", "Moving mass"}};

Error nothingToCalibrate() {
    return {ErrorCode::Usage, "the sensors of this device need no calibration", "use identify or record"};
}

Result<void> checkNothing(const devices::Catalogue& catalogue, const CalibrateConfig&) {
    const auto offered = checkProcedureOffered(catalogue, "calibrate");
    return failure(offered ? nothingToCalibrate() : offered.error());
}

CalibratePrediction predictNothing(const CalibrateConfig&, double) {
    return {};
}

Result<CalibrateResult> calibrateNothing(devices::Device& device, const CalibrateConfig& config,
                                         const ProcedureObserver&) {
    return failure(checkNothing(device.catalogue(), config).error());
}

} // namespace

Actuator independentAxes(std::string_view model, std::string_view title) {
    return {model,   title, axesIdentification(), {nullptr, checkNothing, predictNothing, calibrateNothing},
            nullptr, {},    AxesConstants};
}

} // namespace halbench::app
