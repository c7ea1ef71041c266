#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/doubtful_source.h"
#include "app/procedures/identify/identify_plan.h"
#include "app/procedures/identify/identify_procedure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

Result<void> setGivenConstant(control::GivenConstants& given, std::string_view symbol, double value) {
    struct Known {
        std::string_view symbol;
        std::optional<double> control::GivenConstants::*place;
        bool mayBeZero;
    };
    constexpr Known All[] = {{"J", &control::GivenConstants::inertia_kg_m2, false},
                             {"c", &control::GivenConstants::viscousDamping_Nm_s, true},
                             {"Kf", &control::GivenConstants::coulombFriction_Nm, true},
                             {"phi", &control::GivenConstants::torqueConstant_Nm_per_A, false}};
    for (const Known& known : All) {
        if (known.symbol != symbol) {
            continue;
        }
        if (!std::isfinite(value)) {
            return failure(ErrorCode::NotFinite, fmt::format("{} is not a finite number", symbol),
                           "give it in SI units, e.g. J=5.5e-4");
        }
        if (value < 0.0 || (value == 0.0 && !known.mayBeZero)) {
            return failure(ErrorCode::OutOfRange, fmt::format("{} = {} is not possible", symbol, value),
                           known.mayBeZero ? "it cannot be negative" : "it must be more than zero");
        }
        given.*known.place = value;
        return {};
    }
    return failure(ErrorCode::UnknownName, fmt::format("'{}' is not a constant of the motor", symbol),
                   "use J, c, Kf or phi");
}

Result<void> setCurrentTolerance(IdentifyConfig& config, double tolerance_percent) {
    if (!std::isfinite(tolerance_percent)) {
        return failure(ErrorCode::NotFinite, "the current tolerance is not a finite number",
                       "give it in per cent, e.g. 3");
    }
    if (tolerance_percent < 0.0 || tolerance_percent > LargestCurrentTolerance_percent) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a current tolerance of {} % is not possible", tolerance_percent),
                       "give 0 to 50 %");
    }
    config.currentTolerance_percent = tolerance_percent;
    return {};
}

Result<std::vector<double>> sweepCurrents_A(const CurrentSweep& sweep, double limit_A) {
    if (!std::isfinite(sweep.from_A) || !std::isfinite(sweep.to_A) || !std::isfinite(sweep.step_A)) {
        return failure(ErrorCode::NotFinite, "the currents of the sweep are not finite numbers",
                       "write e.g. 1.6:4:0.2");
    }
    if (sweep.from_A <= 0.0 || sweep.to_A < sweep.from_A || sweep.step_A <= 0.0) {
        return failure(ErrorCode::OutOfRange, "the sweep needs 0 < FROM <= TO and STEP > 0",
                       "write e.g. 1.6:4:0.2");
    }
    if (sweep.to_A > limit_A + 1e-9) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} A is beyond the device's limit of {} A", sweep.to_A, limit_A),
                       "end the sweep at or below limit.current");
    }
    const double steps = std::floor((sweep.to_A - sweep.from_A) / sweep.step_A + 1e-6);
    // The board's list holds 32: the spin-up, the repeated first point and the coast-down come on top.
    constexpr double MostSteps = 28.0;
    if (steps > MostSteps) {
        return failure(ErrorCode::OutOfRange, "a sweep of more than 29 currents does not fit the board",
                       "use a larger step");
    }
    std::vector<double> currents;
    for (int i = 0; i <= static_cast<int>(steps); ++i) {
        // rounded to 0.1 mA, so that 1.6 + 7 * 0.2 is 3 and not 3.0000000000000004
        currents.push_back(std::round((sweep.from_A + i * sweep.step_A) * 1e4) / 1e4);
    }
    return currents;
}

IdentifyPrediction predictIdentify(const IdentifyConfig& config, double start_degC) {
    const auto currents = sweepCurrents_A(config.sweep, 1e3);
    IdentifyPrediction prediction;
    prediction.highestTemperature_degC = start_degC;
    if (!currents) {
        return prediction;
    }
    const PilotEstimate nominal = nominalMotor();
    const std::vector<PlateauRun> runs = planRuns(config, *currents, nominal);
    models::CoilHeatingConfig coil;
    coil.ambient_degC = std::min(start_degC, 40.0);
    models::CoilHeatingState state{start_degC};
    for (const PlateauRun& run : runs) {
        models::stepCoilHeatingSquare(coil, state, run.meanSquare_A2(), run.duration_s());
        prediction.duration_s += run.duration_s();
        for (const double current : run.currents_A) {
            prediction.peakCurrent_A = std::max(prediction.peakCurrent_A, std::fabs(current));
        }
        prediction.highestTemperature_degC =
            std::max(prediction.highestTemperature_degC, state.temperature_degC);
    }
    return prediction;
}

MotorEstimate motorEstimate(const IdentifyResult& result) {
    MotorEstimate estimate;
    const auto put = [&estimate](const std::string& key, const control::Estimate& value) {
        if (value.value) {
            estimate.values[key] = *value.value;
        }
    };
    put("J", result.inertia);
    put("c", result.viscousDamping);
    put("Kf", result.coulombFriction);
    put("phi", result.torqueConstant);
    for (const auto& [name, ratio] : result.ratios) {
        put(name, ratio);
    }
    estimate.covarianceNames = result.covarianceNames;
    estimate.covariance = result.covariance;
    estimate.timing = result.timing;
    estimate.doubts = doubtsOfModel(result.quality);
    return estimate;
}

} // namespace halbench::app
