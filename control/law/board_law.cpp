#include "control/law/board_law.h"

#include "control/law/filtered_controller.h"
#include "control/law/named_filter.h"

#include <cmath>
#include <complex>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;

Complex shiftAt(double frequency_rad_s, double period_s) {
    const double angle = frequency_rad_s * period_s;
    const double half = std::sin(0.5 * angle);
    return {-2.0 * half * half, std::sin(angle)}; // z - 1 keeps its digits where z is near 1
}

Complex filtersAt(const BoardLaw<double>& law, Complex d) {
    Complex product = 1.0;
    for (const LawSection<double>& f : law.sections) {
        product *= f.a1 == 0.0 ? Complex(f.b0) : (f.b0 * d * d + f.b1 * d + f.b2) / (d * d + f.a1 * d + f.a2);
    }
    return product;
}

/// From the rate that the derivative is given to that which it has: T_s z/((T_s + T_f) z - T_f).
Complex derivativeFilterAt(const BoardLaw<double>& law, Complex d) {
    const double filter_s = law.derivativeFilter_s;
    return law.period_s * (d + 1.0) / ((law.period_s + filter_s) * (d + 1.0) - filter_s);
}

} // namespace

Result<BoardLaw<double>> boardLaw(const FilteredLaw& law, const PositionLaw& extras, const LoopTiming& timing,
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

FilteredLaw filteredLaw(const BoardLaw<double>& law) {
    FilteredLaw filtered;
    filtered.gains.proportional = law.kp_A_per_rad;
    filtered.gains.integral = law.ki_A_per_rad_s;
    filtered.gains.derivative = law.kd_As_per_rad;
    if (law.derivativeFilter_s > 0.0) {
        filtered.gains.filter_s = law.derivativeFilter_s;
    }
    filtered.proportionalWeight = law.referenceWeight;
    filtered.derivativeWeight = law.derivativeReferenceWeight;
    for (const LawSection<double>& section : law.sections) {
        if (!(section == LawSection<double>())) {
            filtered.filters.push_back(namedFilter(section, law.period_s));
        }
    }
    return filtered;
}

std::complex<double> feedbackResponse(const BoardLaw<double>& law, double frequency_rad_s) {
    const Complex d = shiftAt(frequency_rad_s, law.period_s);
    const Complex rate = d / (law.period_s * (d + 1.0)) * derivativeFilterAt(law, d);
    return filtersAt(law, d) *
           (law.kp_A_per_rad + law.period_s * law.ki_A_per_rad_s / d + law.kd_As_per_rad * rate);
}

double proportionalAtRest_A_per_rad(const BoardLaw<double>& law) {
    double gain = law.kp_A_per_rad;
    for (const LawSection<double>& f : law.sections) {
        gain *= f.a1 == 0.0 ? f.b0 : f.a2 == 0.0 ? f.b1 / f.a1 : f.b2 / f.a2;
    }
    return gain;
}

} // namespace halbench::control
