#include "app/procedures/identify/identify_estimate.h"

#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/recorded_values.h"
#include "app/procedures/identify/identify_motion.h"
#include "control/base/units.h"
#include "control/identify/angle_column.h"
#include "control/identify/motion_shape.h"
#include "control/identify/plateau.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <span>

namespace halbench::app {
namespace {

struct Columns {
    std::vector<double> angle_rad;
    std::vector<double> current_A;
    std::vector<double> marker;
};

std::vector<double> firstColumn(const Recording& recording, std::initializer_list<const char*> names) {
    for (const char* name : names) {
        std::vector<double> values = recording.column(name);
        if (!values.empty()) {
            return values;
        }
    }
    return {};
}

/// Time between neighbours that most of them have: lost rows do not change it.
double usualPeriod_s(const std::vector<double>& time_s) {
    std::vector<double> periods_s;
    for (std::size_t row = 1; row < time_s.size(); ++row) {
        periods_s.push_back(time_s[row] - time_s[row - 1]);
    }
    const auto middle = periods_s.begin() + static_cast<std::ptrdiff_t>(periods_s.size() / 2);
    std::nth_element(periods_s.begin(), middle, periods_s.end());
    return *middle;
}

Result<void> checkRows(const std::vector<double>& time_s) {
    constexpr double LowestRate_Hz = 99.0; // of 100, with the rounding of a file's times
    constexpr double MostLost_ratio = 0.1;
    const double period_s = usualPeriod_s(time_s);
    if (!(period_s * LowestRate_Hz <= 1.0)) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("the recording has {:.3g} rows per second, less than 100", 1.0 / period_s),
                       "record at 100 Hz or more");
    }
    const double expected = (time_s.back() - time_s.front()) / period_s + 1.0;
    const double lost_ratio = 1.0 - static_cast<double>(time_s.size()) / expected;
    if (!(lost_ratio <= MostLost_ratio)) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{:.0f} % of the rows of the recording are missing", 1e2 * lost_ratio),
                       "record again; allowed loss: one row in ten");
    }
    return {};
}

/// A board may measure its position in what is no angle; readers of files convert what can be.
Result<void> checkUnits(const StreamLayout& layout) {
    for (const auto& [name, unit] : {std::pair("position", "rad"), std::pair("current_command", "A")}) {
        const int index = layout.indexOf(name);
        const std::string& written = index < 0 ? "" : layout.columns[static_cast<std::size_t>(index)].unit;
        if (!written.empty() && written != unit) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{} of the recording is in {}, not in {}", name, written, unit),
                           "a motor is identified from its angle and its current");
        }
    }
    return {};
}

std::string namesOf(const StreamLayout& layout) {
    std::vector<std::string> names;
    for (const StreamLayout::Column& column : layout.columns) {
        names.push_back(column.name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

Result<Columns> takeColumns(const Recording& recording) {
    constexpr std::size_t FewestRows = 50;
    if (recording.rows() < FewestRows) {
        return failure(ErrorCode::InvalidInput, "the recording has too few rows",
                       "record at least several seconds of motion");
    }
    Columns columns;
    columns.angle_rad = firstColumn(recording, {"position", "position_rad"});
    columns.current_A = firstColumn(recording, {"current_command", "current_command_A"});
    columns.marker = firstColumn(recording, {"reference.segment", "reference_segment"});
    if (columns.angle_rad.empty() || columns.current_A.empty()) {
        return failure(
            ErrorCode::InvalidInput, "signals position or current_command missing in the recording",
            fmt::format("required columns: time_s, position_rad and current_command_A; present: {}",
                        namesOf(*recording.layout)));
    }
    if (Result<void> inSi = checkUnits(*recording.layout); !inSi) {
        return failure(inSi.error());
    }
    for (const auto& checked :
         {checkRows(recording.time_s), checkRecordedValues(recording, "position", columns.angle_rad),
          checkRecordedValues(recording, "current_command", columns.current_A)}) {
        if (!checked) {
            return failure(checked.error());
        }
    }
    return columns;
}

void takeTemperatures(const Recording& recording, IdentifyFits& fits) {
    const std::string coils[] = {"coil_temperature.a", "coil_temperature.b"};
    bool isFirst = true;
    for (const std::string& name : coils) {
        const std::vector<double> values = recording.column(name);
        if (values.empty()) {
            continue;
        }
        const double start = values.front();
        fits.startTemperature_degC = isFirst ? start : std::min(fits.startTemperature_degC, start);
        isFirst = false;
    }
    fits.highestTemperature_degC = highestCoil_degC(coils, recording);
}

// The same for the forces that the model lacks: g(omega)/a, of which one sigma is an error of all points.
double missingSpeed_rad_s(const IdentifyFits& fits, const SweepPoint& point, bool isError) {
    double speed = 0.0;
    if (fits.missing.isTaken) {
        for (const control::ExtraForceTerm& term : fits.missing.terms) {
            const double force_rad_s2 =
                control::extraForceAtSpeed_rad_s2(term, point.speed_rad_s, point.current_A);
            speed -= force_rad_s2 * (isError ? term.error : term.value) / fits.motion->damping_per_s;
        }
    }
    return speed;
}

constexpr double PlateauWindow_s = 2.0;

struct PlateauEnd {
    control::PlateauSpeed speed;
    bool isSteady = false;
};

// Mean speed of the last two seconds, steady or not.
std::optional<PlateauEnd> plateauEnd(std::span<const double> time_s, std::span<const double> angle_rad) {
    const double begin_s = time_s.back() - PlateauWindow_s - 1e-6;
    const auto begin =
        static_cast<std::size_t>(std::lower_bound(time_s.begin(), time_s.end(), begin_s) - time_s.begin());
    const auto speed = control::fitRippledSpeed(time_s.subspan(begin), angle_rad.subspan(begin));
    const auto steadiness = control::testSteadiness(time_s, angle_rad, {});
    if (!speed || !steadiness) {
        return std::nullopt;
    }
    return PlateauEnd{*speed, steadiness->isSteady};
}

// The same of the steady motion that the plateau settles to. With the damping a known, the angle is that
// straight line and alpha0 (e^{-a t} - 1)/a^2 (resources/help/identification.md section 3); what is left of
// the settling must be small beside the speed, for it was not seen to end.
std::optional<PlateauEnd> settledEnd(std::span<const double> time_s, std::span<const double> angle_rad,
                                     double current_A, const IdentifyConfig& config, double damping_per_s) {
    const control::CurrentPlateau all[] = {{0, time_s.size(), current_A}};
    const auto stretches = control::findMotion(time_s, angle_rad, all, segmentConfigOf(config));
    if (stretches.empty() || !(damping_per_s > 0.0)) {
        return std::nullopt;
    }
    const control::MotionSegment& stretch = stretches.front();
    const auto rows = static_cast<Eigen::Index>(stretch.angle_rad.size());
    const Eigen::Vector3d local =
        control::localShape(stretch, damping_per_s)
            .householderQr()
            .solve(Eigen::Map<const Eigen::VectorXd>(stretch.angle_rad.data(), rows));
    constexpr double LargestRest_ratio = 0.1;
    const double settling_rad_s = local(2) / damping_per_s;
    const double duration_s = stretch.time_s.back() - stretch.time_s.front();
    const double left_rad_s = settling_rad_s * std::exp(-damping_per_s * duration_s);
    if (!(std::fabs(left_rad_s) < LargestRest_ratio * std::fabs(local(1) + settling_rad_s))) {
        return std::nullopt;
    }
    std::vector<double> settled_rad(angle_rad.begin(), angle_rad.end());
    for (std::size_t row = 0; row < settled_rad.size(); ++row) {
        const double since_s = time_s[row] - stretch.time_s.front();
        settled_rad[row] -= settling_rad_s / damping_per_s * std::exp(-damping_per_s * since_s);
    }
    return plateauEnd(time_s, settled_rad);
}

// Speed of one plateau, settled or settling.
std::optional<SweepPoint> measurePlateau(std::span<const double> time_s, std::span<const double> angle_rad,
                                         double current_A, const IdentifyConfig& config, IdentifyFits& fits,
                                         double& error_rad_s) {
    if (current_A == 0.0 || time_s.back() - time_s.front() < PlateauWindow_s + 0.02) {
        return std::nullopt;
    }
    auto end = plateauEnd(time_s, angle_rad);
    if (!end) {
        return std::nullopt;
    }
    SweepPoint point;
    point.current_A = current_A;
    if (!end->isSteady && fits.motion) {
        const auto settled = settledEnd(time_s, angle_rad, current_A, config, fits.motion->damping_per_s);
        if (settled && settled->isSteady) {
            end = settled;
            point.note = "settling; final speed extrapolated";
        }
    }
    point.speed_rad_s = end->speed.speed_rad_s;
    error_rad_s = end->speed.speedError_rad_s;
    const double along_rad_s = point.speed_rad_s * std::copysign(1.0, current_A);
    if (along_rad_s < -config.usableSpeed_rad_s) {
        point.note = "turns against its current";
        ++fits.againstPlateaus;
    } else if (along_rad_s < 0.1 * config.usableSpeed_rad_s) {
        point.note = "the rotor stopped";
        ++fits.stoppedPlateaus;
    } else if (std::fabs(point.speed_rad_s) < config.usableSpeed_rad_s) {
        point.note = fmt::format("slower than {} rad/s", config.usableSpeed_rad_s);
        ++fits.slowPlateaus;
    } else if (!end->isSteady) {
        point.note = "not steady at its end";
        ++fits.unsteadyPlateaus;
    } else {
        point.isUsed = true;
    }
    return point;
}

// What a loss of torque at speed takes off a steady speed: (phi/c) I L omega^2. Without it the sweep would
// be no straight line.
double lostSpeed_rad_s(const IdentifyFits& fits, const SweepPoint& point, double loss_s2) {
    if (!fits.motion || !fits.balance || !(fits.motion->damping_per_s > 0.0)) {
        return 0.0;
    }
    const double gain = fits.balance->torque_rad_s2_A.value_or(0.0) / fits.motion->damping_per_s;
    return gain * point.current_A * loss_s2 * point.speed_rad_s * point.speed_rad_s;
}

// What one sigma of the converters' bow does to a steady speed. The bow c sin(pi i/5 A) of each phase, c even
// in
// +-2 codes of 2.44 mA, makes the torque of (c_a + c_b) J1(pi I/5 A) over a turn
// (resources/help/htm-theory.md sections 3.3 and 9).
double bowedSpeed_rad_s(const IdentifyFits& fits, const SweepPoint& point) {
    if (!fits.motion || !fits.balance || !(fits.motion->damping_per_s > 0.0)) {
        return 0.0;
    }
    constexpr double Code_A = 10.0 / 4096.0;
    constexpr double FullScale_A = 5.0;
    const double bow_A = 2.0 * Code_A * std::sqrt(2.0 / 3.0);
    const double share = std::cyl_bessel_j(1.0, Pi * std::fabs(point.current_A) / FullScale_A);
    const double gain = fits.balance->torque_rad_s2_A.value_or(0.0) / fits.motion->damping_per_s;
    return gain * bow_A * std::copysign(share, point.current_A);
}

Result<void> askedToEnd(const AbortCheck& check) {
    return check ? check() : Result<void>();
}

Result<void> fitSteadySweep(const Recording& recording, const Columns& columns,
                            const std::vector<control::CurrentPlateau>& plateaus,
                            const IdentifyConfig& config, const AbortCheck& checkAbort, IdentifyFits& fits) {
    std::vector<control::SteadyPoint> steady;
    const double loss_s2 = fits.motion ? fits.motion->torqueLoss_s2 : 0.0;
    const double lossError_s2 = fits.motion ? fits.motion->torqueLossError_s2 : 0.0;
    for (const control::CurrentPlateau& plateau : plateaus) {
        if (auto goesOn = askedToEnd(checkAbort); !goesOn) {
            return goesOn;
        }
        const std::size_t count = plateau.end - plateau.begin;
        double error_rad_s = 0.0;
        const auto point = measurePlateau(std::span(recording.time_s).subspan(plateau.begin, count),
                                          std::span(columns.angle_rad).subspan(plateau.begin, count),
                                          plateau.current_A, config, fits, error_rad_s);
        if (!point) {
            continue;
        }
        fits.points.push_back(*point);
        if (point->isUsed) {
            const double speed_rad_s = point->speed_rad_s;
            steady.push_back(
                {point->current_A,
                 speed_rad_s + lostSpeed_rad_s(fits, *point, loss_s2) +
                     missingSpeed_rad_s(fits, *point, false),
                 error_rad_s,
                 lostSpeed_rad_s(fits, *point, lossError_s2) + missingSpeed_rad_s(fits, *point, true),
                 bowedSpeed_rad_s(fits, *point)});
        }
    }
    auto sweep = control::fitFrictionSweep(steady, config.seed);
    if (!sweep) {
        fits.sweepProblem = sweep.error().message;
        return {};
    }
    std::size_t row = 0;
    for (SweepPoint& point : fits.points) {
        if (point.isUsed) {
            point.weight = sweep->robustWeights[row++];
        }
    }
    fits.sweep = std::move(*sweep);
    return {};
}

} // namespace

Result<IdentifyFits> fitRecording(const Recording& recording, const IdentifyConfig& config,
                                  const AbortCheck& checkAbort) {
    auto columns = takeColumns(recording);
    if (!columns) {
        return failure(columns.error());
    }
    const auto plateaus =
        control::findPlateaus(recording.time_s, columns->current_A, columns->marker, segmentConfigOf(config));
    if (!plateaus) {
        return failure(plateaus.error());
    }
    IdentifyFits fits;
    fits.lostRows = recording.lostRows;
    for (const double current_A : columns->current_A) {
        fits.largestCurrent_A = std::max(fits.largestCurrent_A, std::fabs(current_A));
    }
    fits.slowest_rad_s = config.usableSpeed_rad_s;
    fits.isSpeedColumn = control::looksLikeSpeed(columns->angle_rad, *plateaus);
    if (auto unwrapped = control::unwrapAngle(columns->angle_rad); unwrapped.period_rad) {
        fits.wrap_rad = unwrapped.period_rad;
        columns->angle_rad = std::move(unwrapped.angle_rad);
    }
    takeTemperatures(recording, fits);
    if (auto done = fitTransients(recording.time_s, columns->angle_rad, *plateaus, config, checkAbort, fits);
        !done) {
        return failure(done.error());
    }
    if (fits.motion) {
        columns->angle_rad = control::correctedAngle_rad(*fits.motion, columns->angle_rad);
    }
    if (auto done = fitSteadySweep(recording, *columns, *plateaus, config, checkAbort, fits); !done) {
        return failure(done.error());
    }
    return fits;
}

Result<IdentifyResult> identifyRecording(const Recording& recording, const IdentifyConfig& config,
                                         const AbortCheck& checkAbort) {
    const auto fits = fitRecording(recording, config, checkAbort);
    if (!fits) {
        return failure(fits.error());
    }
    IdentifyResult result = judgeFits(*fits, config);
    result.duration_s = recording.time_s.back() - recording.time_s.front();
    return result;
}

} // namespace halbench::app
