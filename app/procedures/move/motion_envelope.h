#pragma once

#include "app/procedures/tune/loop_uncertainty.h"
#include "control/assess/loop_replay.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace halbench::app {

/// A motor as one run of a move may find it: from what the identification allows, with the friction of that
/// run and of rest.
struct RunMotor {
    control::PositionPlant plant;
    double friction_ratio = 1.0; ///< of this run over K_f
    double static_ratio = 1.0;   ///< K_s / K_f
};

/// Assumed where nobody measured it (resources/help/htm-theory.md section 9).
constexpr double RunScatter_ratio = 0.033;      ///< of K_f from run to run, 1 sigma
constexpr double MostStatic_ratio = 1.15;       ///< K_s is drawn between K_f and this
constexpr std::size_t MotionEnvelopeStride = 5; ///< rows of a band, in rows of a motion: 5 ms

/// Deterministic for a seed; draws that are no motor are left out. Errors: Refused (a motor without
/// covariance); of plantFromEstimate.
Result<std::vector<RunMotor>> drawRuns(const MotorEstimate& estimate, const UncertaintyDraws& draws,
                                       double scatter_ratio = RunScatter_ratio);

/// As many of them as a band of motions is made of. Errors: as of drawRuns().
Result<std::vector<RunMotor>> bandMotors(const MotorEstimate& estimate, const UncertaintyDraws& draws);

/// The motor at rest in the loop of `config`: only its ratios count.
control::LoopReplay replayRun(const RunMotor& motor, const control::LoopReplayConfig& config);

/// Band of nine tenths of the motions, point by point, MotionEnvelopeStride milliseconds apart.
struct MotionEnvelope {
    std::vector<double> time_s;
    control::Band angle_rad;
};
/// `run` gives the angle of one motor, `rows` milliseconds of it. At least one motor.
MotionEnvelope motionEnvelope(const std::vector<RunMotor>& motors, std::size_t rows,
                              const std::function<std::vector<double>(const RunMotor&)>& run);

constexpr double MotionTolerance_rad = 0.03; ///< what no model holds: resolution, stray field, a count

/// Band of the motion of a healthy motor: that of the motors, twice as wide, and a tolerance for effects that
/// no model has. `reference` as of replayLoop().
MotionEnvelope expectedMotion(const std::vector<RunMotor>& motors, const control::SampledPositionLaw& law,
                              std::span<const control::ReferencePoint> reference, std::size_t rows,
                              double tolerance_rad = MotionTolerance_rad);

/// What holds both.
MotionEnvelope hullOf(const MotionEnvelope& one, const MotionEnvelope& other);

/// By `factor` about its middle, and by `more_rad` at both sides.
MotionEnvelope widened(const MotionEnvelope& band, double factor, double more_rad);

/// The least such factor with which nineteen of twenty points of a motion lie inside; 0: all are within
/// `more_rad` of the middle. Infinite for a motion that holds a value which is no number.
double neededWidening_ratio(const MotionEnvelope& band, std::span<const double> angle_rad, double more_rad);

} // namespace halbench::app
