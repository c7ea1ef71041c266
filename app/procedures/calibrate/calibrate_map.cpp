#include "app/procedures/calibrate/calibrate_runs.h"
#include "app/procedures/excite/spin_recording.h"
#include "app/procedures/identify/identify_estimate.h"
#include "control/base/distributions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// Angle error that the ellipse leaves (resources/help/identification.md section 6.1). The rotor is its own
// reference: at high speed it turns too evenly to follow ripple of torque and friction, so what comes with
// the angle there is the sensors' error.

namespace halbench::app {
namespace {

const std::string Enabled = "errormap.enabled";

std::string mapName(std::size_t place) {
    return fmt::format("errormap.{}{}", place % 2 == 0 ? "cos" : "sin", place / 2 + 1);
}

// Run-ups and coast-downs of both directions, each recorded by itself.
Result<std::vector<Recording>> spinBothWays(devices::Device& device, const CalibrateConfig& config,
                                            const ProcedureObserver& observer, const PilotEstimate& motor) {
    std::vector<Recording> recordings;
    for (const PlateauRun& run : angleMapRuns(config, motor)) {
        auto recording = recordSpin(device, observer, {&run, 1}, config.speedLimit_rad_s,
                                    {"position", "speed", "current_command", "reference.segment"});
        if (!recording) {
            return failure(recording.error());
        }
        recordings.push_back(std::move(*recording));
    }
    return recordings;
}

// The second recording behind the first: both begin and end at rest.
Recording joined(const Recording& first, const Recording& second) {
    Recording both = first;
    constexpr double Step_s = 0.01;
    const double shift_s = first.time_s.back() + Step_s - second.time_s.front();
    for (const double time_s : second.time_s) {
        both.time_s.push_back(time_s + shift_s);
    }
    both.values.insert(both.values.end(), second.values.begin(), second.values.end());
    return both;
}

/// Fourier coefficients of the angle error, cos 1, sin 1, cos 2, ...
struct AngleMap {
    std::vector<double> value_rad;
    std::vector<double> error_rad; ///< 1 sigma
    double freedom = 0.0;
};

std::optional<AngleMap> mapOf(const Recording& recording) {
    const auto fits = fitRecording(recording, {});
    if (!fits || !fits->motion || fits->motion->angleErrorSpread_rad.empty()) {
        return std::nullopt;
    }
    const control::MotionFit& motion = *fits->motion;
    return AngleMap{motion.angleError_rad, motion.angleErrorSpread_rad,
                    static_cast<double>(motion.balances.size()) - 1.0};
}

double rms(const std::vector<double>& coefficients) {
    double squares = 0.0;
    for (const double value : coefficients) {
        squares += value * value;
    }
    return std::sqrt(0.5 * squares);
}

// What is not the sensors': ripple of friction changes its sign with the direction, and ripple that the fit
// does not know (orders 3 and up) differs between them too.
double directionGap_rad(const AngleMap& forward, const AngleMap& reverse) {
    std::vector<double> half;
    for (std::size_t i = 0; i < std::min(forward.value_rad.size(), reverse.value_rad.size()); ++i) {
        half.push_back(0.5 * (forward.value_rad[i] - reverse.value_rad[i]));
    }
    return rms(half);
}

// Of one recording the error is that of its own direction and current: phase currents that differ from what
// the board compensates turn the readings by up to 0.01 degrees twice per turn, with the sign of the current.
// The mean of both directions is right for neither, and each coefficient lies off by at least half the
// difference.
AngleMap withDirections(AngleMap map, const AngleMap& forward, const AngleMap& reverse) {
    for (std::size_t i = 0; i < std::min(forward.value_rad.size(), reverse.value_rad.size()); ++i) {
        map.error_rad[i] = std::hypot(map.error_rad[i], 0.5 * (forward.value_rad[i] - reverse.value_rad[i]));
    }
    return map;
}

void remark(CalibrateResult& result, Verdict verdict, const char* code, std::string message,
            const char* hint) {
    result.quality.verdict = std::max(result.quality.verdict, verdict);
    result.quality.findings.push_back({code, std::move(message), hint});
}

void addFigure(CalibrateResult& result, std::string name, double value, double half) {
    result.figures.push_back({std::move(name), "rad",
                              control::Estimate{value, std::pair(value - half, value + half),
                                                control::EstimateSource::Identified, "rad"}});
}

void addMap(CalibrateResult& result, const AngleMap& map) {
    const double factor = control::studentQuantile(0.975, map.freedom);
    addFigure(result, "angle_error.rms", rms(map.value_rad), factor * rms(map.error_rad));
    for (std::size_t i = 0; i < map.value_rad.size(); ++i) {
        addFigure(result, mapName(i), map.value_rad[i], factor * map.error_rad[i]);
    }
}

// Only a map that leaves less than half of the error is worth having.
constexpr double WorstRest_ratio = 0.5;

bool judgeMap(CalibrateResult& result, const AngleMap& map, double gap_rad) {
    constexpr double ToDegrees = 57.29577951308232;
    const double size_rad = rms(map.value_rad);
    const double rest_rad = std::hypot(rms(map.error_rad), gap_rad);
    if (rest_rad < WorstRest_ratio * size_rad) {
        return true;
    }
    remark(result, Verdict::Good, "angle_map_not_proposed",
           fmt::format("the residual angle error of the ellipse, {:.3f} degrees rms, is too uncertain "
                       "({:.3f} degrees from speed ripple and scatter)",
                       ToDegrees * size_rad, ToDegrees * rest_rad),
           "use the ellipse without the map");
    return false;
}

// An older map belongs to an older ellipse.
void proposeNoMap(CalibrateResult& result) {
    result.proposed.push_back({Enabled, 0.0});
}

void evaluate(CalibrateResult& result, const std::vector<Recording>& recordings) {
    std::optional<AngleMap> map;
    std::optional<AngleMap> forward;
    std::optional<AngleMap> reverse;
    if (recordings[0].rows() > 0 && recordings[1].rows() > 0) {
        map = mapOf(joined(recordings[0], recordings[1]));
        forward = mapOf(recordings[0]);
        reverse = mapOf(recordings[1]);
    }
    if (!map || !forward || !reverse) {
        remark(
            result, Verdict::Good, "angle_map_not_found",
            "the rotor did not turn fast and long enough to measure the residual angle error of the ellipse",
            "allow a higher current or speed");
        proposeNoMap(result);
        return;
    }
    addMap(result, withDirections(*map, *forward, *reverse));
    const double gap_rad = directionGap_rad(*forward, *reverse);
    if (!judgeMap(result, *map, gap_rad)) {
        proposeNoMap(result);
        return;
    }
    for (std::size_t i = 0; i < map->value_rad.size(); ++i) {
        result.proposed.push_back({mapName(i), map->value_rad[i]});
    }
    result.proposed.push_back({Enabled, 1.0});
}

} // namespace

std::vector<PlateauRun> angleMapRuns(const CalibrateConfig& config, const PilotEstimate& motor) {
    constexpr int Pairs = 8; // stretches are the clusters of the errors: 16 of each direction
    constexpr double Dwell_s = 1.0;
    std::vector<PlateauRun> runs;
    for (const double sign : {1.0, -1.0}) {
        PlateauRun run = coastRun(motor, config.mapCurrent_A, Pairs, Dwell_s, config.speedLimit_rad_s);
        for (double& current : run.currents_A) {
            current *= sign;
        }
        run.text = "turning fast (angle error)";
        runs.push_back(std::move(run));
    }
    return runs;
}

Result<void> calibrateAngleMap(devices::Device& device, const CalibrateConfig& config,
                               const ProcedureObserver& observer, const PilotEstimate& motor,
                               CalibrateResult& result) {
    if (device.catalogue().findParameter(Enabled) == nullptr) {
        return {};
    }
    // The board decodes with the ellipse just found and without a map meanwhile; the caller's guard takes
    // both back.
    std::vector<ParameterValue> meanwhile{{Enabled, 0.0}};
    std::copy_if(result.proposed.begin(), result.proposed.end(), std::back_inserter(meanwhile),
                 [](const ParameterValue& value) { return value.name.starts_with("hall."); });
    if (auto written = device.writeParameters(meanwhile); !written) {
        return written;
    }
    const auto recordings = spinBothWays(device, config, observer, motor);
    if (!recordings) {
        return failure(recordings.error());
    }
    evaluate(result, *recordings);
    return {};
}

} // namespace halbench::app
