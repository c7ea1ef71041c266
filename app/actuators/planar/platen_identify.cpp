#include "app/actuators/planar/platen_identify.h"

#include "app/actuators/planar/platen_estimate.h"
#include "app/procedures/base/axis_choice.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

/// The chips' fit takes every other row.
constexpr std::size_t ChipStride = 2;

GivenPlaten givenOf(const IdentifyConfig& config) {
    GivenPlaten given;
    for (const ParameterValue& constant : config.constants) {
        (constant.name == "m" ? given.mass_kg : given.inertia_kg_m2) = constant.value;
    }
    return given;
}

// Equations of motion with poses that are calibrated from the same motion.
Result<PlatenFit> fitMotion(const PlatenMotion& motion, const PlatenBoard& board) {
    const double gamma = board.waveNumber_per_m();
    std::vector<ChipSample> samples;
    for (std::size_t n = 0; n < motion.samples.size(); n += ChipStride) {
        samples.push_back(motion.samples[n]);
    }
    const auto chips = fitChips(samples, board.chips, gamma);
    if (!chips) {
        return failure(chips.error());
    }
    std::vector<models::PlanarPose> poses;
    poses.reserve(motion.samples.size());
    for (const ChipSample& sample : motion.samples) {
        poses.push_back(poseFrom(chips->calibration, gamma, sample, sample.pose));
    }
    PoseErrors errors;
    errors.covariance = chips->ownCovariance;
    errors.sensitivity = [&](std::size_t row) {
        return poseSensitivity(chips->calibration, gamma, motion.samples[row], poses[row]);
    };
    return fitPlaten(motion, poses, board.geometry, errors);
}

AxesIdentifyResult refused(const Error& error) {
    AxesIdentifyResult result;
    result.quality.verdict = Verdict::Refused;
    result.quality.findings.push_back({"not_determined", error.message, error.hint});
    return result;
}

AxesIdentifyResult estimateFrom(const PlatenMotion& motion, const PlatenBoard& board,
                                const IdentifyConfig& config, const std::vector<devices::AxisSpec>& axes,
                                const MeasuredTiming& timing) {
    const auto fit = fitMotion(motion, board);
    return fit ? platenEstimate(*fit, board, givenOf(config), axes, timing) : refused(fit.error());
}

Result<AxesIdentifyResult> measure(devices::Device& device, const IdentifyConfig& config,
                                   const ProcedureObserver& observer,
                                   const std::vector<devices::AxisSpec>& axes, const MeasuredTiming& timing) {
    const auto board = readBoard(device);
    if (!board) {
        return failure(board.error());
    }
    bool wasHomed = true;
    const auto room = findRoom(device, *board, observer, wasHomed);
    if (!room) {
        return failure(room.error());
    }
    auto motion = recordMotion(device, *board, identificationLegs(*room), observer);
    if (!motion) {
        return failure(motion.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Fit); !entered) {
        return failure(entered.error());
    }
    AxesIdentifyResult result = estimateFrom(*motion, *board, config, axes, timing);
    if (auto entered = enterState(observer, ProcedureState::Judge); !entered) {
        return failure(entered.error());
    }
    if (!wasHomed) {
        result.quality.findings.push_back(
            {"homed_here", "the platen was not homed; the cell where it stood was taken as the first",
             "Nothing to do unless absolute positions matter."});
    }
    nameRowLoss(result.quality, motion->loss);
    result.duration_s = motion->duration_s;
    result.highestTemperature_degC = motion->highestTemperature_degC;
    result.recording = std::move(motion->recording);
    return result;
}

bool hasMotorOptions(const IdentifyConfig& config) {
    const IdentifyConfig plain;
    return config.added || config.directions != plain.directions ||
           config.sweep.from_A != plain.sweep.from_A || config.sweep.to_A != plain.sweep.to_A ||
           config.sweep.step_A != plain.sweep.step_A || config.speedLimit_rad_s != plain.speedLimit_rad_s ||
           config.usableSpeed_rad_s != plain.usableSpeed_rad_s;
}

} // namespace

Result<void> setPlatenConstant(IdentifyConfig& config, std::string_view symbol, double value) {
    if (symbol != "m" && symbol != "Iz") {
        return failure(ErrorCode::UnknownName, fmt::format("the platen has no constant '{}'", symbol),
                       "known are m (kg) and Iz (kg*m^2)");
    }
    if (!std::isfinite(value)) {
        return failure(ErrorCode::NotFinite, fmt::format("{} is not a finite number", symbol), {});
    }
    if (value <= 0.0) {
        return failure(ErrorCode::OutOfRange, fmt::format("{} = {} must be positive", symbol, value), {});
    }
    config.constants.push_back({std::string(symbol), value});
    return {};
}

Result<void> checkPlatenIdentify(const devices::Catalogue& catalogue, const IdentifyConfig& config) {
    if (const auto axes = chosenAxes(catalogue, config.axis); !axes) {
        return failure(axes.error());
    }
    if (hasMotorOptions(config)) {
        return failure(ErrorCode::Usage, "a sweep of currents, directions or added inertia are for a motor",
                       "leave them out; this device takes an axis and a given m or Iz");
    }
    if (config.constants.size() > 1) {
        return failure(ErrorCode::Usage, "one given constant is enough: m or Iz",
                       "give the one that is known better; the other is then measured");
    }
    return {};
}

IdentifyPrediction predictPlatenIdentify(const IdentifyConfig&, double start_degC) {
    // About the middle of the machine; a few seconds more or less elsewhere.
    const PlatenRoom room = *roomWithin({}, {-40e-3, -40e-3}, {40e-3, 40e-3}, models::MagnetMatrix{}.pitch_m);
    constexpr double Ends_s = 1.1, Peak_A = 0.5, Warming_K = 0.5;
    return {durationOf(identificationLegs(room)) + Ends_s, Peak_A, start_degC + Warming_K};
}

Result<IdentifyOutcome> identifyPlaten(devices::Device& device, const IdentifyConfig& config,
                                       const ProcedureObserver& observer) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "identify"); !offered) {
        return failure(offered.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    if (auto checked = checkPlatenIdentify(device.catalogue(), config); !checked) {
        return failure(checked.error());
    }
    auto guard = RestoreGuard::take(device);
    if (!guard) {
        return failure(guard.error());
    }
    const MeasuredTiming timing = timingOf(device.catalogue(), guard->snapshot());
    const auto axes = chosenAxes(device.catalogue(), config.axis);
    auto result = restoredResult(*guard, measure(device, config, observer, *axes, timing));
    if (!result) {
        (void)enterState(observer, ProcedureState::Restored);
        return failure(result.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Done); !entered) {
        return failure(entered.error());
    }
    return IdentifyOutcome(*std::move(result));
}

} // namespace halbench::app
