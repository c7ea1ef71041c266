#include "app/actuators/planar/platen_identify.h"

#include "app/actuators/planar/platen_estimate.h"
#include "app/procedures/base/axis_zero.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/identify/axes_run.h"

#include <fmt/format.h>

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
    auto motion = recordMotion(device, *board, *room, identificationLegs, observer);
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
        result.quality.findings.push_back(homedHere());
    }
    nameRowLoss(result.quality, motion->loss);
    result.duration_s = motion->duration_s;
    result.recording = std::move(motion->recording);
    return result;
}

std::vector<std::string> nothingFurther(const devices::Catalogue&) {
    return {};
}

} // namespace

Result<void> setPlatenConstant(IdentifyConfig& config, std::string_view symbol, double value) {
    if (symbol != "m" && symbol != "Iz") {
        return failure(ErrorCode::UnknownName, fmt::format("the platen has no constant '{}'", symbol),
                       "known are m (kg) and Iz (kg*m^2)");
    }
    if (const auto valid = checkGivenInertia(symbol, value); !valid) {
        return valid;
    }
    config.constants.push_back({std::string(symbol), value});
    return {};
}

Result<void> checkPlatenIdentify(const devices::Catalogue& catalogue, const IdentifyConfig& config) {
    if (const auto fits = checkAxesOptions(catalogue, config,
                                           "leave them out; this device takes an axis and a given m or Iz");
        !fits) {
        return fits;
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
    return runAxes({checkPlatenIdentify, nothingFurther, measure}, device, config, observer);
}

} // namespace halbench::app
