#include "app/actuators/planar/platen_calibrate.h"

#include "app/actuators/planar/crosstalk_fit.h"
#include "app/actuators/planar/platen_motion.h"
#include "app/procedures/base/axis_zero.h"
#include "app/procedures/base/offered_procedure.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

using models::ChipCount;
using models::CoilCount;
using models::FieldCount;

constexpr std::size_t Stride = 2;
constexpr std::size_t PulseStride = 1;

bool isChosen(const CalibrateConfig& config, Calibration calibration) {
    return std::find(config.which.begin(), config.which.end(), calibration) != config.which.end();
}

void addSamples(std::vector<ChipSample>& samples, const PlatenMotion& motion, std::size_t stride) {
    for (std::size_t n = 0; n < motion.samples.size(); n += stride) {
        samples.push_back(motion.samples[n]);
    }
}

struct Named {
    const char* figure;
    const char* parameter;
    const char* unit;
};
constexpr std::array<Named, ChipParameters> ChipNames = {{{"amplitude", "amplitude", "T"},
                                                          {"gain_x", "gain_x", ""},
                                                          {"gain_y", "gain_y", ""},
                                                          {"cross_xy", "cross_xy", ""},
                                                          {"cross_yx", "cross_yx", ""},
                                                          {"offset_x", "offset_x", "T"},
                                                          {"offset_y", "offset_y", "T"},
                                                          {"place_x", "place_x", "m"},
                                                          {"place_y", "place_y", "m"}}};

// In the order of the covariance.
std::vector<double> valuesOf(const ChipCalibration& chips) {
    std::vector<double> values;
    for (std::size_t j = 0; j < ChipCount; ++j) {
        values.insert(values.end(), {chips.amplitude_T[j], chips.gain[j].x(), chips.gain[j].y(),
                                     chips.cross[j].x(), chips.cross[j].y(), chips.offset_T[j].x(),
                                     chips.offset_T[j].y(), chips.place_m[j].x(), chips.place_m[j].y()});
    }
    for (int i = 0; i < FieldCount * CoilCount; ++i) {
        values.push_back(chips.crosstalk_T_per_A(i / CoilCount, i % CoilCount));
    }
    return values;
}

void addFigure(CalibrateResult& result, std::string name, const char* unit, double value, double deviation) {
    constexpr double Quantile = 1.96;
    result.figures.push_back({std::move(name),
                              unit,
                              {value, std::pair(value - Quantile * deviation, value + Quantile * deviation),
                               control::EstimateSource::Identified, unit}});
}

void propose(CalibrateResult& result, const ChipFit& fit, const CalibrateConfig& config) {
    const std::vector<double> values = valuesOf(fit.calibration);
    const auto deviation = [&fit](std::size_t i) {
        const auto at = static_cast<Eigen::Index>(i);
        return std::sqrt(std::max(fit.covariance(at, at), 0.0));
    };
    std::size_t i = 0;
    for (int j = 1; j <= ChipCount; ++j) {
        for (const Named& named : ChipNames) {
            if (isChosen(config, Calibration::Hall)) {
                addFigure(result, fmt::format("chip{}.{}", j, named.figure), named.unit, values[i],
                          deviation(i));
                result.proposed.push_back({fmt::format("chip.{}_{}", named.parameter, j), values[i]});
            }
            ++i;
        }
    }
    for (int k = 1; k <= FieldCount * CoilCount && isChosen(config, Calibration::Stray); ++k, ++i) {
        addFigure(result, fmt::format("crosstalk.{}", k), "T/A", values[i], deviation(i));
        result.proposed.push_back({fmt::format("chip.crosstalk_{}", k), values[i]});
    }
}

// What remains: two fits of one half of the samples each differ by twice the error of the fit to all.
Result<Eigen::Vector3d> remainingError(const std::vector<ChipSample>& samples, const ChipCalibration& start,
                                       double waveNumber_per_m) {
    std::array<std::vector<ChipSample>, 2> halves;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        halves[n % 2].push_back(samples[n]);
    }
    const auto even = fitChips(halves[0], start, waveNumber_per_m);
    const auto odd = fitChips(halves[1], start, waveNumber_per_m);
    if (!even || !odd) {
        return failure(!even ? even.error() : odd.error());
    }
    return Eigen::Vector3d(0.5 * periodicError(even->calibration, odd->calibration, waveNumber_per_m));
}

void addErrors(CalibrateResult& result, const char* when, const Eigen::Vector3d& error) {
    const std::array<std::pair<const char*, const char*>, 3> axes = {
        {{"x", "m"}, {"y", "m"}, {"phi", "rad"}}};
    for (std::size_t i = 0; i < axes.size(); ++i) {
        control::Estimate estimate;
        estimate.value = error(static_cast<Eigen::Index>(i));
        estimate.source = control::EstimateSource::Identified;
        estimate.unit = axes[i].second;
        result.figures.push_back({fmt::format("error_{}_{}", axes[i].first, when), axes[i].second, estimate});
    }
}

void judgeNoise(CalibrateResult& result, const ChipFit& fit) {
    constexpr double Healthy_T = 1e-4; // five times the usual noise
    if (fit.noise_T > Healthy_T) {
        result.quality.verdict = Verdict::Refused;
        result.quality.findings.push_back(
            {"chips_disagree",
             fmt::format("the readings differ from the calibrated model by {:.3g} T rms", fit.noise_T),
             "Check the chips: one may be damaged or loose, or iron is near."});
    }
}

void loseRows(CalibrateResult& result, const PlatenMotion& motion) {
    if (motion.recording.lostRows > 0) {
        result.quality.verdict = std::max(result.quality.verdict, Verdict::Doubtful);
        result.quality.findings.push_back(
            {"rows_lost", fmt::format("{} rows are missing", motion.recording.lostRows), "measure again"});
        nameRowLoss(result.quality, motion.loss);
    }
}

void refuse(CalibrateResult& result, const Error& error) {
    result.quality.verdict = Verdict::Refused;
    result.quality.findings.push_back({"not_determined", error.message, error.hint});
}

// `start`: the present calibration, with the crosstalk that the pulses showed.
void conclude(CalibrateResult& result, const std::vector<ChipSample>& samples, const PlatenBoard& board,
              const ChipCalibration& start, const CalibrateConfig& config) {
    const double gamma = board.waveNumber_per_m();
    const auto fit = fitChips(samples, start, gamma);
    if (!fit) {
        refuse(result, fit.error());
        return;
    }
    propose(result, *fit, config);
    judgeNoise(result, *fit);
    if (!isChosen(config, Calibration::Hall)) {
        return;
    }
    addErrors(result, "before", periodicError(fit->calibration, board.chips, gamma));
    if (const auto remaining = remainingError(samples, start, gamma)) {
        addErrors(result, "after", *remaining);
    } else {
        refuse(result, remaining.error());
    }
}

// The field of the currents closes a loop of its own around the law, which can be unstable: it is measured
// without a law and compensated before anything moves. The caller's guard takes the values back.
Result<void> pulse(devices::Device& device, const ProcedureObserver& observer, CalibrateResult& result,
                   PlatenBoard& board, std::vector<ChipSample>& samples) {
    const auto pulses = recordPulses(device, board, observer);
    if (!pulses) {
        return failure(pulses.error());
    }
    const auto crosstalk = fitCrosstalk_T_per_A(*pulses);
    if (!crosstalk) {
        return failure(crosstalk.error());
    }
    board.chips.crosstalk_T_per_A = *crosstalk;
    std::vector<ParameterValue> values;
    for (int i = 0; i < FieldCount * CoilCount; ++i) {
        values.push_back(
            {fmt::format("chip.crosstalk_{}", i + 1), (*crosstalk)(i / CoilCount, i % CoilCount)});
    }
    addSamples(samples, *pulses, PulseStride);
    loseRows(result, *pulses);
    return device.writeParameters(values);
}

Result<void> measure(devices::Device& device, const CalibrateConfig& config,
                     const ProcedureObserver& observer, CalibrateResult& result) {
    const auto board = readBoard(device);
    if (!board) {
        return failure(board.error());
    }
    result.residualBefore_rad = std::numeric_limits<double>::quiet_NaN(); // of a motor's angle
    result.residualAfter_rad = result.residualBefore_rad;
    bool wasHomed = true;
    std::vector<ChipSample> samples;
    PlatenBoard compensated = *board;
    if (isChosen(config, Calibration::Stray)) {
        const auto gains = softenLaw(device);
        if (!gains) {
            return failure(gains.error());
        }
        if (auto moved = moveWhereRotationIsVisible(device, *board, observer, wasHomed); !moved) {
            return moved;
        }
        if (auto pulsed = pulse(device, observer, result, compensated, samples); !pulsed) {
            return pulsed;
        }
        if (auto stiff = device.writeParameters(*gains); !stiff) {
            return stiff;
        }
    }
    const auto room = findRoom(device, *board, observer, wasHomed);
    if (!room) {
        return failure(room.error());
    }
    const auto motion = recordMotion(device, *board, *room, calibrationLegs, observer);
    if (!motion) {
        return failure(motion.error());
    }
    addSamples(samples, *motion, Stride);
    loseRows(result, *motion);
    if (auto entered = enterState(observer, ProcedureState::Fit); !entered) {
        return entered;
    }
    conclude(result, samples, *board, compensated.chips, config);
    if (!wasHomed) {
        result.quality.findings.push_back(homedHere());
    }
    return enterState(observer, ProcedureState::Judge);
}

} // namespace

Result<void> checkPlatenCalibrate(const devices::Catalogue&, const CalibrateConfig& config) {
    if (isChosen(config, Calibration::Hall) || isChosen(config, Calibration::Stray)) {
        return {};
    }
    return failure(ErrorCode::Usage, "a platen on air has no static friction to calibrate",
                   "choose hall, stray or all; identify gives a bound of the friction");
}

CalibratePrediction predictPlatenCalibrate(const CalibrateConfig& config, double) {
    const PlatenRoom room = *roomWithin({}, {-40e-3, -40e-3}, {40e-3, 40e-3}, models::MagnetMatrix{}.pitch_m);
    // Of each coil its pulses and at most one way back; a platen that is brought to the middle takes longer.
    constexpr double Ends_s = 1.1, Pulses_s = 6 * (0.2 + 0.9), Peak_A = 0.5, MeanSquare_A2 = 0.02;
    const double pulses_s = isChosen(config, Calibration::Stray) ? Pulses_s : 0.0;
    return {durationOf(calibrationLegs(room)) + Ends_s + pulses_s, Peak_A, MeanSquare_A2};
}

Result<CalibrateResult> calibratePlaten(devices::Device& device, const CalibrateConfig& config,
                                        const ProcedureObserver& observer) {
    if (auto offered = checkProcedureOffered(device.catalogue(), "calibrate"); !offered) {
        return failure(offered.error());
    }
    if (auto checked = checkPlatenCalibrate(device.catalogue(), config); !checked) {
        return failure(checked.error());
    }
    return guardedCalibration(device, config, observer, measure);
}

} // namespace halbench::app
