#include "app/procedures/identify/axes_run.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::app {
namespace {

bool hasMotorOptions(const IdentifyConfig& config) {
    const IdentifyConfig plain;
    return config.added || config.directions != plain.directions ||
           config.sweep.from_A != plain.sweep.from_A || config.sweep.to_A != plain.sweep.to_A ||
           config.sweep.step_A != plain.sweep.step_A || config.speedLimit_rad_s != plain.speedLimit_rad_s ||
           config.usableSpeed_rad_s != plain.usableSpeed_rad_s || config.currentTolerance_percent;
}

} // namespace

Result<void> checkAxesOptions(const devices::Catalogue& catalogue, const IdentifyConfig& config,
                              const std::string& hint) {
    if (const auto axes = chosenAxes(catalogue, config.axis); !axes) {
        return failure(axes.error());
    }
    if (hasMotorOptions(config)) {
        return failure(ErrorCode::Usage,
                       "a sweep of currents, directions, current tolerance or added inertia are for a motor",
                       hint);
    }
    return {};
}

Result<void> checkGivenInertia(std::string_view symbol, double value) {
    if (!std::isfinite(value)) {
        return failure(ErrorCode::NotFinite, fmt::format("{} is not a finite number", symbol), {});
    }
    if (value <= 0.0) {
        return failure(ErrorCode::OutOfRange, fmt::format("{} = {} must be positive", symbol, value), {});
    }
    return {};
}

Result<IdentifyOutcome> runAxes(const AxesRun& run, devices::Device& device, const IdentifyConfig& config,
                                const ProcedureObserver& observer) {
    const devices::Catalogue& catalogue = device.catalogue();
    if (auto offered = checkProcedureOffered(catalogue, "identify"); !offered) {
        return failure(offered.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    if (auto checked = run.check(catalogue, config); !checked) {
        return failure(checked.error());
    }
    const auto axes = chosenAxes(catalogue, config.axis);
    if (!axes) {
        return failure(axes.error());
    }
    auto guard = RestoreGuard::take(device, run.restored(catalogue));
    if (!guard) {
        return failure(guard.error());
    }
    const MeasuredTiming timing = timingOf(catalogue, guard->snapshot());
    auto result = restoredResult(*guard, run.measure(device, config, observer, *axes, timing));
    if (!result) {
        (void)enterState(observer, ProcedureState::Restored);
        return failure(result.error());
    }
    result->highestTemperature_degC = highestCoil_degC(catalogue, result->recording);
    if (auto entered = enterState(observer, ProcedureState::Done); !entered) {
        return failure(entered.error());
    }
    return IdentifyOutcome(*std::move(result));
}

} // namespace halbench::app
