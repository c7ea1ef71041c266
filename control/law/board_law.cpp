#include "control/law/board_law.h"

#include "control/law/shaped_controller.h"

#include <cmath>

namespace halbench::control {

Result<BoardLaw<double>> boardLaw(const ShapedLaw& law, const PositionLaw& extras, const LoopTiming& timing,
                                  double currentLimit_A) {
    if (!(std::isfinite(currentLimit_A) && currentLimit_A > 0.0)) {
        return failure(ErrorCode::OutOfRange, "the current limit must be positive");
    }
    if (const auto valid = checkTiming(timing); !valid) {
        return failure(valid.error());
    }
    const auto equation = lawEquation(law, timing.period_s);
    if (!equation) {
        return failure(equation.error());
    }
    BoardLaw<double> board;
    board.kp_A_per_rad = equation->proportional;
    board.ki_A_per_rad_s = equation->integral;
    board.kd_As_per_rad = equation->derivative;
    board.referenceWeight = equation->proportionalWeight;
    board.derivativeReferenceWeight = equation->derivativeWeight;
    board.derivativeFilter_s = equation->derivativeFilter_s;
    board.sections = equation->sections;
    board.inertia_As2_per_rad = extras.inertia_A_s2_rad;
    board.viscous_As_per_rad = extras.viscous_A_s_rad;
    board.coulomb_A = extras.coulomb_A;
    board.coulombSpeed_rad_s = extras.coulombSpeed_rad_s;
    board.stiction_A = extras.stictionCurrent_A;
    board.stictionThreshold_rad = extras.stictionThreshold_rad;
    board.stictionSpeed_rad_s = extras.stictionSpeed_rad_s;
    board.limit_A = currentLimit_A;
    board.period_s = timing.period_s;
    board.delaySamples = timing.delay_samples;
    return board;
}

} // namespace halbench::control
