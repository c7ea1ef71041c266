#pragma once

#include "control/assess/loop_assessment.h"
#include "control/base/result.h"
#include "control/design/design_methods.h"

#include <optional>
#include <string_view>

namespace halbench::control {

struct ProvenDesign {
    PidGains gains; ///< parallel, per radian
    LoopAssessment assessment;
};

/// What the linear-quadratic regulator may spend (Bryson's rule: each weight is one over its square).
struct RegulatorTargets {
    double angle_rad = 0.01;
    std::optional<double> integral_rad_s = {}; ///< of the error; absent: no integral action
    double current_A = 1.0;
};

/// LQR on the held motor's state (angle, speed, integral of the error), its three gains given to K_P, K_D and
/// K_I. The board takes the speed from the difference of two angles, half a sample late, and knows nothing of
/// its own computing delay; the proof is that of the board's loop, and a design that is unstable there is
/// refused. Errors: of the inputs; OutOfRange (targets), Refused.
Result<ProvenDesign> designRegulator(const PositionPlant& plant, const LoopTiming& timing,
                                     const RegulatorTargets& targets, double currentLimit_A);

/// What is to be small after a step of the load.
enum class ErrorMeasure {
    Iae, ///< integral of |e|
    Itae ///< integral of t |e|: forgives the beginning, punishes what lasts
};

namespace least_error {
constexpr double LeastMs_ratio = 1.1; ///< below it hardly any position loop is left
constexpr double MostMs_ratio = 3.0;  ///< above it a loop rings
constexpr double UsualMs_ratio =
    1.7; ///< 1.4 calm ... 2.0 lively (Astrom, Hagglund, "Advanced PID Control", ch. 7)
/// Large for a correction at rest, and far below the verification step, which any fast loop saturates.
constexpr double UsualStep_deg = 2.0;
} // namespace least_error

struct LeastErrorTargets {
    ErrorMeasure measure = ErrorMeasure::Iae;
    double mostMs_ratio = least_error::UsualMs_ratio;
    /// A step of the reference of this height must not ask for more than the current limit; absent: any may.
    std::optional<double> step_rad = {};
};

/// "min-iae" and "min-itae"; nothing for another method.
std::optional<ErrorMeasure> leastErrorMeasure(std::string_view method);
/// Of the targets of a method, with the defaults above; without a current limit the current is not bounded.
LeastErrorTargets leastErrorTargets(ErrorMeasure measure, const DesignTargets& targets);

/// PID gains with the least error after a load step (of current) among all whose sensitivity stays below Ms
/// and whose linear reference step of `step_rad` stays below the current limit, by a direct search over the
/// logarithms of the three gains from the recommended shape. Found to about 1 % of the measure, both bounds
/// kept to 0.1 %, deterministic. Errors: of the inputs; OutOfRange (targets); Refused when no gains meet
/// them.
Result<ProvenDesign> designLeastError(const PositionPlant& plant, const LoopTiming& timing,
                                      const LeastErrorTargets& targets, double currentLimit_A);

/// What a design has of something that is bounded. Active: the bound is what keeps the error from being less.
struct BoundUse {
    double value = 0.0;
    double bound = 0.0;

    bool isActive() const;
};
struct LeastErrorBounds {
    BoundUse sensitivity;            ///< Ms
    std::optional<BoundUse> current; ///< A, in a reference step of the next line
    double step_rad = 0.0;
};
LeastErrorBounds boundsOf(const LoopAssessment& assessment, const LeastErrorTargets& targets,
                          double currentLimit_A);

/// The measure itself, in rad s or rad s^2 per A of load, of the linear sampled loop over `duration_s`.
Result<double> loadError(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                         ErrorMeasure measure, double duration_s);

} // namespace halbench::control
