#include "app/procedures/calibrate/calibrate_procedure.h"

#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/restored_result.h"
#include "app/procedures/calibrate/calibrate_runs.h"
#include "app/procedures/excite/spin_drive.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {
namespace {

Result<void> checkConfig(const CalibrateConfig& config) {
    if (config.which.empty()) {
        return failure(ErrorCode::Usage, "no calibration selected",
                       "choose hall, stray, static-friction or all");
    }
    const double largest = std::max({std::fabs(config.spinCurrent_A), std::fabs(config.strayCurrent_A),
                                     std::fabs(config.frictionCurrent_A), std::fabs(config.mapCurrent_A)});
    constexpr double BoardLimit_A = 4.0;
    if (!(largest <= BoardLimit_A) || config.spinCurrent_A <= 0.0 || config.mapCurrent_A <= 0.0 ||
        config.strayCurrent_A <= 0.0 || config.frictionCurrent_A <= 0.0) {
        return failure(ErrorCode::OutOfRange, "the currents of a calibration must lie in (0, 4] A", {});
    }
    if (config.frictionStarts < 2 || config.frictionStarts > 50) {
        return failure(ErrorCode::OutOfRange, "2 to 50 starts in each direction are possible", {});
    }
    return {};
}

bool isChosen(const CalibrateConfig& config, Calibration calibration) {
    return std::find(config.which.begin(), config.which.end(), calibration) != config.which.end();
}

// A demand above the board's own limit would latch its fault.
Result<CalibrateConfig> withinCurrentLimit(devices::Device& device, CalibrateConfig config) {
    const std::string limit[] = {"limit.current"};
    const auto limit_A = device.readParameters(limit);
    if (!limit_A) {
        return failure(limit_A.error());
    }
    for (double* current_A :
         {&config.spinCurrent_A, &config.mapCurrent_A, &config.strayCurrent_A, &config.frictionCurrent_A}) {
        *current_A = std::min(*current_A, limit_A->front());
    }
    return config;
}

// The stray field first: the ellipse needs it.
Result<void> measure(devices::Device& device, const CalibrateConfig& asked, const ProcedureObserver& observer,
                     CalibrateResult& result) {
    using Run = Result<void> (*)(devices::Device&, const CalibrateConfig&, const ProcedureObserver&,
                                 CalibrateResult&);
    constexpr std::array<std::pair<Calibration, Run>, 3> All{
        {{Calibration::Stray, calibrateStray},
         {Calibration::Hall, calibrateHall},
         {Calibration::StaticFriction, calibrateStaticFriction}}};
    const auto limited = withinCurrentLimit(device, asked);
    if (!limited) {
        return failure(limited.error());
    }
    const CalibrateConfig& config = *limited;
    if (auto prepared = prepareSpinning(device, config.speedLimit_rad_s); !prepared) {
        return prepared;
    }
    if (auto entered = enterState(observer, ProcedureState::Excite); !entered) {
        return entered;
    }
    for (const auto& [calibration, run] : All) {
        if (!isChosen(config, calibration)) {
            continue;
        }
        if (auto done = run(device, config, observer, result); !done) {
            return done;
        }
    }
    return {};
}

Result<void> readBefore(devices::Device& device, CalibrateResult& result) {
    std::vector<std::string> names;
    for (const ParameterValue& value : result.proposed) {
        names.push_back(value.name);
    }
    if (names.empty()) {
        return {};
    }
    const auto values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        result.before.push_back({names[i], (*values)[i]});
    }
    return {};
}

// One transaction, read back by the device layer; nothing is written when a figure was refused. The guard
// takes the values back when the procedure or its program ends before they are complete.
Result<void> apply(devices::Device& device, const ProcedureObserver& observer, CalibrateResult& result) {
    if (result.proposed.empty() || result.quality.verdict == Verdict::Refused) {
        return {};
    }
    auto guard = RestoreGuard::take(device);
    if (!guard) {
        return failure(guard.error());
    }
    const auto written = [&]() -> Result<void> {
        if (auto entered = enterState(observer, ProcedureState::Apply); !entered) {
            return entered;
        }
        if (auto done = device.writeParameters(result.proposed); !done) {
            return done;
        }
        if (auto entered = enterState(observer, ProcedureState::Verify); !entered) {
            return entered;
        }
        guard->keep();
        result.isApplied = true;
        return {};
    };
    return restoredResult(*guard, written());
}

} // namespace

std::string_view calibrationName(Calibration calibration) {
    switch (calibration) {
    case Calibration::Hall:
        return "hall";
    case Calibration::Stray:
        return "stray";
    case Calibration::StaticFriction:
        break;
    }
    return "static-friction";
}

Result<CalibrateResult> runCalibrate(devices::Device& device, const CalibrateConfig& config,
                                     const ProcedureObserver& observer) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "calibrate"); !offered) {
        return failure(offered.error());
    }
    if (auto turns = checkTurnsForever(device.catalogue()); !turns) {
        return failure(turns.error());
    }
    if (auto checked = checkConfig(config); !checked) {
        return failure(checked.error());
    }
    return guardedCalibration(device, config, observer, measure);
}

Result<CalibrateResult> guardedCalibration(devices::Device& device, const CalibrateConfig& config,
                                           const ProcedureObserver& observer,
                                           CalibrationMeasurement measureIt) {
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    auto guard = RestoreGuard::take(device);
    if (!guard) {
        return failure(guard.error());
    }
    CalibrateResult result;
    const double start_s = device.clock().now_s();
    const auto measured = restoredResult(*guard, measureIt(device, config, observer, result));
    if (!measured) {
        (void)enterState(observer, ProcedureState::Restored);
        return failure(measured.error());
    }
    result.duration_s = device.clock().now_s() - start_s;
    if (auto entered = enterState(observer, ProcedureState::Propose); !entered) {
        return failure(entered.error());
    }
    if (auto read = readBefore(device, result); !read) {
        return failure(read.error());
    }
    if (config.apply) {
        if (auto applied = apply(device, observer, result); !applied) {
            (void)enterState(observer, ProcedureState::Restored);
            return failure(applied.error());
        }
    }
    if (auto entered = enterState(observer, ProcedureState::Done); !entered && !result.isApplied) {
        return failure(entered.error()); // an abort after the values were applied comes too late to undo them
    }
    return result;
}

} // namespace halbench::app
