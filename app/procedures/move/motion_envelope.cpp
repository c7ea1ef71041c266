#include "app/procedures/move/motion_envelope.h"

#include "control/base/random.h"
#include "control/robustness/percentiles.h"
#include "models/htm/htm_ideal_loop.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::app {

Result<std::vector<RunMotor>> drawRuns(const MotorEstimate& estimate, const UncertaintyDraws& draws,
                                       double scatter_ratio) {
    if (estimate.covarianceNames.empty()) {
        return failure(ErrorCode::Refused, "the model has no covariance: its uncertainty is unknown",
                       "identify the motor to get its uncertainty");
    }
    const auto uncertain = uncertainPlantFromEstimate(estimate);
    if (!uncertain) {
        return failure(uncertain.error());
    }
    const auto plants = control::drawPlants(*uncertain, draws.count, Random(draws.seed));
    if (!plants) {
        return failure(plants.error());
    }
    constexpr std::uint64_t FrictionStream = 1;
    constexpr double LeastFriction_ratio = 0.1; // a draw beyond the edge is little friction, not a drive
    Random random = Random(draws.seed).fork(FrictionStream);
    std::vector<RunMotor> motors;
    for (const control::PositionPlant& plant : *plants) {
        const double scattered = std::max(LeastFriction_ratio, 1.0 + scatter_ratio * random.gaussian());
        const double atRest = 1.0 + (MostStatic_ratio - 1.0) * random.uniform();
        if (control::checkPlant(plant)) {
            motors.push_back({plant, scattered, atRest});
        }
    }
    if (motors.empty()) {
        return failure(ErrorCode::Refused, "no valid motor within the model's uncertainty",
                       "identify the motor again");
    }
    return motors;
}

Result<std::vector<RunMotor>> bandMotors(const MotorEstimate& estimate, const UncertaintyDraws& draws) {
    constexpr std::size_t MostMotors = 300;
    auto motors = drawRuns(estimate, draws);
    if (motors) {
        motors->resize(std::min(motors->size(), MostMotors));
    }
    return motors;
}

control::LoopReplay replayRun(const RunMotor& motor, const control::LoopReplayConfig& config) {
    models::RotorConfig rotor;
    rotor.inertia_kg_m2 = 1.0;
    rotor.viscousDamping_Nm_s = motor.plant.dampingRate_1_s;
    rotor.coulombFriction_Nm = motor.plant.breakawayCurrent_A * motor.plant.accelerationGain_rad_s2_A;
    rotor.staticFriction_ratio = motor.static_ratio;
    return control::replayLoop(
        config, models::rotorAtRest(rotor, motor.plant.accelerationGain_rad_s2_A, motor.friction_ratio));
}

MotionEnvelope motionEnvelope(const std::vector<RunMotor>& motors, std::size_t rows,
                              const std::function<std::vector<double>(const RunMotor&)>& run) {
    const std::size_t points = (rows + MotionEnvelopeStride - 1) / MotionEnvelopeStride;
    const auto lanes = static_cast<Eigen::Index>(motors.size());
    Eigen::ArrayXXd angles(lanes, static_cast<Eigen::Index>(points)); // a column a point
    for (Eigen::Index lane = 0; lane < lanes; ++lane) {
        const std::vector<double> angle_rad = run(motors[static_cast<std::size_t>(lane)]);
        for (std::size_t point = 0; point < points; ++point) {
            angles(lane, static_cast<Eigen::Index>(point)) = angle_rad[point * MotionEnvelopeStride];
        }
    }
    MotionEnvelope band;
    for (std::size_t point = 0; point < points; ++point) {
        Eigen::ArrayXd column = angles.col(static_cast<Eigen::Index>(point));
        const control::MiddleNineTenths middle = control::middleNineTenths(column);
        band.time_s.push_back(1e-3 * static_cast<double>(point * MotionEnvelopeStride));
        band.angle_rad.p5.push_back(middle.p5);
        band.angle_rad.p95.push_back(middle.p95);
    }
    return band;
}

MotionEnvelope expectedMotion(const std::vector<RunMotor>& motors, const control::SampledPositionLaw& law,
                              std::span<const control::ReferencePoint> reference, std::size_t rows,
                              double tolerance_rad) {
    constexpr double Widening_ratio = 2.0; // about its middle: one motion in a thousand leaves it
    const MotionEnvelope band = motionEnvelope(motors, rows, [&](const RunMotor& motor) {
        return replayRun(motor, {law, reference, {}, rows}).angle_rad;
    });
    return widened(band, Widening_ratio, tolerance_rad);
}

MotionEnvelope hullOf(const MotionEnvelope& one, const MotionEnvelope& other) {
    MotionEnvelope result = one;
    for (std::size_t i = 0; i < one.time_s.size(); ++i) {
        result.angle_rad.p5[i] = std::min(one.angle_rad.p5[i], other.angle_rad.p5[i]);
        result.angle_rad.p95[i] = std::max(one.angle_rad.p95[i], other.angle_rad.p95[i]);
    }
    return result;
}

MotionEnvelope widened(const MotionEnvelope& band, double factor, double more_rad) {
    MotionEnvelope result = band;
    for (std::size_t i = 0; i < band.time_s.size(); ++i) {
        const double middle_rad = 0.5 * (band.angle_rad.p5[i] + band.angle_rad.p95[i]);
        const double half_rad = 0.5 * (band.angle_rad.p95[i] - band.angle_rad.p5[i]);
        result.angle_rad.p5[i] = middle_rad - factor * half_rad - more_rad;
        result.angle_rad.p95[i] = middle_rad + factor * half_rad + more_rad;
    }
    return result;
}

double neededWidening_ratio(const MotionEnvelope& band, std::span<const double> angle_rad, double more_rad) {
    std::vector<double> needed;
    for (std::size_t i = 0; i < band.time_s.size() && i * MotionEnvelopeStride < angle_rad.size(); ++i) {
        const double seen_rad = angle_rad[i * MotionEnvelopeStride];
        if (!std::isfinite(seen_rad)) {
            return std::numeric_limits<double>::infinity();
        }
        const double middle_rad = 0.5 * (band.angle_rad.p5[i] + band.angle_rad.p95[i]);
        const double half_rad = 0.5 * (band.angle_rad.p95[i] - band.angle_rad.p5[i]);
        const double beyond_rad = std::max(0.0, std::fabs(seen_rad - middle_rad) - more_rad);
        needed.push_back(beyond_rad == 0.0 ? 0.0
                         : half_rad > 0.0  ? beyond_rad / half_rad
                                           : std::numeric_limits<double>::infinity());
    }
    if (needed.empty()) {
        return std::numeric_limits<double>::infinity();
    }
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.95 * static_cast<double>(needed.size()))) - 1;
    std::nth_element(needed.begin(), needed.begin() + rank, needed.end());
    return needed[static_cast<std::size_t>(rank)];
}

} // namespace halbench::app
