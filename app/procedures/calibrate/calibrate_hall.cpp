#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/calibrate/calibrate_runs.h"
#include "app/procedures/excite/excitation_limits.h"
#include "app/procedures/excite/spin_recording.h"
#include "app/procedures/identify/pilot_motion.h"
#include "control/base/distributions.h"
#include "control/base/units.h"
#include "control/identify/ellipse_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

struct HallReadings {
    std::vector<double> a_T;
    std::vector<double> b_T;
};

// Rows in motion, without the field of the phase currents.
HallReadings movingReadings(const Recording& recording, double stray_T_per_A) {
    constexpr double Slowest_rad_s = 2.0;
    const std::vector<double> speed = recording.column("speed");
    const std::vector<double> hallA = recording.column("hall.a");
    const std::vector<double> hallB = recording.column("hall.b");
    const std::vector<double> currentA = recording.column("current.a");
    const std::vector<double> currentB = recording.column("current.b");
    HallReadings readings;
    if (speed.empty() || hallA.empty() || hallB.empty() || currentA.empty() || currentB.empty()) {
        return readings;
    }
    for (std::size_t i = 0; i < recording.rows(); ++i) {
        if (std::fabs(speed[i]) > Slowest_rad_s) {
            readings.a_T.push_back(hallA[i] - stray_T_per_A * currentA[i]);
            readings.b_T.push_back(hallB[i] - stray_T_per_A * currentB[i]);
        }
    }
    return readings;
}

void addFigure(CalibrateResult& result, const char* name, const char* unit, double value, double error,
               int parts) {
    const double half = control::studentQuantile(0.975, std::max(parts - 1, 1)) * error;
    result.figures.push_back({name, unit,
                              control::Estimate{value, std::pair(value - half, value + half),
                                                control::EstimateSource::Identified, unit}});
}

Result<control::HallEllipse> presentCalibration(devices::Device& device) {
    const std::string names[] = {"hall.offset_a", "hall.offset_b", "hall.gain_ratio", "hall.quadrature",
                                 "hall.amplitude"};
    const auto values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    return control::HallEllipse{(*values)[0], (*values)[1], (*values)[2], (*values)[3], (*values)[4]};
}

// What the ellipse leaves: harmonics of sensors and magnets. More than this spoils the decoding.
constexpr double WorstResidual_ratio = 0.02;

// For the picture: evenly out of all.
std::vector<HallPoint> some(const HallReadings& readings) {
    constexpr std::size_t Most = 360;
    const std::size_t step = readings.a_T.size() / Most + 1;
    std::vector<HallPoint> points;
    for (std::size_t i = 0; i < readings.a_T.size(); i += step) {
        points.push_back({readings.a_T[i], readings.b_T[i]});
    }
    return points;
}

void judgeEllipse(CalibrateResult& result, const control::HallEllipseFit& fit) {
    if (fit.residual_ratio > WorstResidual_ratio) {
        result.quality.verdict = std::max(result.quality.verdict, Verdict::Doubtful);
        result.quality.findings.push_back(
            {"hall_not_an_ellipse",
             fmt::format("distance of the readings from the ellipse: {:.1f} % of the amplitude",
                         100.0 * fit.residual_ratio),
             "check for saturated sensors or a loose magnet"});
    }
}

// Fast enough to turn evenly, well below the speed window.
double spinCurrent_A(const CalibrateConfig& config, const PilotEstimate& motor) {
    constexpr double LeastShare = 0.1;
    constexpr double MostShare = 0.6;
    constexpr double WantedShare = 0.25;
    const double speed_rad_s = motor.steadySpeed_rad_s(config.spinCurrent_A);
    if (speed_rad_s >= LeastShare * config.speedLimit_rad_s &&
        speed_rad_s <= MostShare * config.speedLimit_rad_s) {
        return config.spinCurrent_A;
    }
    const double wanted_rad_s = WantedShare * config.speedLimit_rad_s;
    return std::min((motor.friction_rad_s2 + motor.damping_per_s * wanted_rad_s) / motor.torque_rad_s2_A,
                    std::max(config.spinCurrent_A, config.mapCurrent_A));
}

// The published motor where this one does not turn: what follows says so.
Result<PilotEstimate> firstMotion(devices::Device& device, const CalibrateConfig& config,
                                  const ProcedureObserver& observer) {
    IdentifyConfig pilot;
    pilot.speedLimit_rad_s = config.speedLimit_rad_s;
    PilotMotion motion(device, observer, pilot);
    const ProcedureObserver listening =
        listeningIn(observer, [&](const SampleBlock& block) { motion.take(block); });
    StreamRecorder recorder(device, listening);
    recorder.guardBy(excitationLimits(device.catalogue(), config.speedLimit_rad_s));
    if (auto started =
            recorder.start(withWatchedSignals(device.catalogue(),
                                              {"position", "speed", "current_command", "reference.segment"}),
                           100.0);
        !started) {
        return failure(started.error());
    }
    const auto motor = motion.find({config.spinCurrent_A, config.mapCurrent_A});
    if (!motor) {
        return failure(recorder.causeOf(motor.error()));
    }
    if (auto whole = recorder.check(); !whole) {
        return failure(whole.error());
    }
    return motor->value_or(nominalMotor());
}

} // namespace

Result<double> proposedOrPresent(devices::Device& device, const CalibrateResult& result,
                                 const std::string& name) {
    for (const ParameterValue& value : result.proposed) {
        if (value.name == name) {
            return value.value;
        }
    }
    const std::string names[] = {name};
    const auto values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    return values->front();
}

std::vector<PlateauRun> hallRuns(const CalibrateConfig& config, const PilotEstimate& motor) {
    const double current_A = spinCurrent_A(config, motor);
    std::vector<PlateauRun> runs;
    for (const double sign : {1.0, -1.0}) {
        PlateauRun run;
        run.currents_A = {sign * current_A, sign * current_A, 0.0};
        run.dwell_s = 4.0;
        run.mayReach_rad_s = 0.9 * config.speedLimit_rad_s;
        run.text = "turning slowly (Hall sensors)";
        runs.push_back(std::move(run));
    }
    return runs;
}

Result<void> calibrateHall(devices::Device& device, const CalibrateConfig& config,
                           const ProcedureObserver& observer, CalibrateResult& result) {
    const auto stray = proposedOrPresent(device, result, "stray.coefficient");
    const auto before = presentCalibration(device);
    if (!stray || !before) {
        return failure(stray ? before.error() : stray.error());
    }
    const auto motor = firstMotion(device, config, observer);
    if (!motor) {
        return failure(motor.error());
    }
    const auto recording = recordSpin(device, observer, hallRuns(config, *motor), config.speedLimit_rad_s,
                                      {"position", "speed", "hall.a", "hall.b", "current.a", "current.b"});
    if (!recording) {
        return failure(recording.error());
    }
    const HallReadings readings = movingReadings(*recording, *stray);
    const auto fit = control::fitHallEllipse(readings.a_T, readings.b_T);
    if (!fit) {
        result.quality.verdict = std::max(result.quality.verdict, Verdict::Refused);
        result.quality.findings.push_back({"hall_not_calibrated", fit.error().message,
                                           "use a rotation current above the breakaway current"});
        return {};
    }
    result.hallPoints = some(readings);
    const control::HallEllipse& e = fit->ellipse;
    addFigure(result, "hall.offset_a", "T", e.offsetA_T, fit->error.offsetA_T, fit->parts);
    addFigure(result, "hall.offset_b", "T", e.offsetB_T, fit->error.offsetB_T, fit->parts);
    addFigure(result, "hall.gain_ratio", "", e.gain_ratio, fit->error.gain_ratio, fit->parts);
    addFigure(result, "hall.quadrature", "rad", e.quadrature_rad, fit->error.quadrature_rad, fit->parts);
    addFigure(result, "hall.amplitude", "T", e.amplitude_T, fit->error.amplitude_T, fit->parts);
    for (const CalibrationFigure& figure : result.figures) {
        if (figure.name.starts_with("hall.")) {
            result.proposed.push_back({figure.name, *figure.estimate.value});
        }
    }
    result.residualBefore_rad = control::hallAngleError_rad(*before, e);
    result.residualAfter_rad = fit->residual_ratio;
    judgeEllipse(result, *fit);
    return calibrateAngleMap(device, config, observer, *motor, result);
}

} // namespace halbench::app
