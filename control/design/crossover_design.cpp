#include "control/design/crossover_design.h"

#include "control/analysis/margins.h"
#include "control/base/units.h"
#include "control/law/filtered_delta.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace halbench::control {

namespace {

using namespace crossover;

bool isFinite(const PidGains& gains) {
    return std::isfinite(gains.proportional) && std::isfinite(gains.integral) &&
           std::isfinite(gains.derivative);
}

PidGains times(PidGains gains, double factor) {
    gains.proportional *= factor;
    gains.integral *= factor;
    gains.derivative *= factor;
    return gains;
}

Result<DeltaSystem> openLoop(const PositionPlant& plant, const LoopTiming& timing, const PidGains& gains,
                             const FilteredLaw& around) {
    FilteredLaw law;
    law.gains = gains;
    law.gains.filter_s = around.gains.filter_s;
    law.filters = around.filters;
    return deltaOpenLoop(plant, law, timing);
}

bool isStable(const PositionPlant& plant, const LoopTiming& timing, const PidGains& gains,
              const FilteredLaw& around) {
    const auto loop = openLoop(plant, timing, gains, around);
    return loop && isStableClosed(*loop, 1.0);
}

/// A motor in its loop, with what stands around the gains.
struct Surroundings {
    const PositionPlant& plant;
    const LoopTiming& timing;
    const FilteredLaw& around;
};

/// Two equations leave K_D of a PI loop at some rounding of zero.
PidGains withoutRounding(PidGains gains, double period_s) {
    constexpr double Rounding_ratio = 1e-9;
    if (std::abs(gains.derivative) < Rounding_ratio * std::abs(gains.proportional) * period_s) {
        gains.derivative = 0.0;
    }
    return gains;
}

/// One crossover of one motor: which margins it can have.
class AtCrossover {
public:
    AtCrossover(const Surroundings& loop, const CrossoverAim& aim) : m_loop(loop), m_aim(aim) {}

    PidGains gains(double phaseMargin_deg) const {
        CrossoverAim aim = m_aim;
        aim.phaseMargin_deg = phaseMargin_deg;
        return withoutRounding(gainsAtCrossover(m_loop.plant, m_loop.timing, aim, m_loop.around),
                               m_loop.timing.period_s);
    }

    CrossoverLimit limit(double phaseMargin_deg) const {
        const bool isInRange = m_aim.crossover_rad_s >= slowestCrossover_rad_s(m_loop.timing) &&
                               m_aim.crossover_rad_s <= fastestCrossover_rad_s(m_loop.timing) &&
                               phaseMargin_deg >= LeastMargin_deg && phaseMargin_deg <= MostMargin_deg;
        if (!isInRange) {
            return CrossoverLimit::Range;
        }
        const PidGains asked = gains(phaseMargin_deg);
        const double stiffness_ratio = asked.proportional * m_loop.plant.accelerationGain_rad_s2_A /
                                       (m_aim.crossover_rad_s * m_aim.crossover_rad_s);
        if (!isFinite(asked) || !(stiffness_ratio >= LeastStiffness_ratio)) {
            return CrossoverLimit::Stiffness;
        }
        if (asked.derivative < 0.0) {
            return CrossoverLimit::Derivative;
        }
        const auto& [plant, timing, around] = m_loop;
        const bool isSafe = isStable(plant, timing, asked, around) &&
                            isStable(plant, timing, times(asked, LeastGainMargin_ratio), around);
        return isSafe ? CrossoverLimit::None : CrossoverLimit::Stability;
    }

    bool isPossible(double phaseMargin_deg) const { return limit(phaseMargin_deg) == CrossoverLimit::None; }

    /// The nearest possible margin; only larger ones unless it may fall.
    std::optional<double> nearest(double wanted_deg, bool mayFall) const {
        const double start_deg = std::clamp(wanted_deg, LeastMargin_deg, MostMargin_deg);
        if (isPossible(start_deg)) {
            return start_deg;
        }
        constexpr double Step_deg = 3.0;
        for (double off_deg = Step_deg; off_deg < MostMargin_deg; off_deg += Step_deg) {
            if (isPossible(start_deg + off_deg)) {
                return narrowed(start_deg + off_deg - Step_deg, start_deg + off_deg);
            }
            if (mayFall && isPossible(start_deg - off_deg)) {
                return narrowed(start_deg - off_deg + Step_deg, start_deg - off_deg);
            }
        }
        return std::nullopt;
    }

private:
    double narrowed(double impossible_deg, double possible_deg) const {
        for (int i = 0; i < 14; ++i) { // to a few ten-thousandths of a degree
            const double middle_deg = 0.5 * (impossible_deg + possible_deg);
            (isPossible(middle_deg) ? possible_deg : impossible_deg) = middle_deg;
        }
        return possible_deg;
    }

    Surroundings m_loop;
    CrossoverAim m_aim;
};

/// An aim that is possible, searched from one that is not.
class Search {
public:
    Search(const Surroundings& loop, const CrossoverAim& wanted, bool mayFall)
        : m_loop(loop), m_wanted(wanted), m_mayFall(mayFall) {}

    std::optional<CrossoverAim> nearest() const {
        if (const auto here = at(m_wanted.crossover_rad_s)) {
            return here;
        }
        constexpr double Step_ratio = 1.05;
        const double slowest_rad_s = slowestCrossover_rad_s(m_loop.timing);
        const double fastest_rad_s = fastestCrossover_rad_s(m_loop.timing);
        const double start_rad_s = std::clamp(m_wanted.crossover_rad_s, slowest_rad_s, fastest_rad_s);
        for (double ratio = 1.0; ratio <= fastest_rad_s / slowest_rad_s; ratio *= Step_ratio) {
            for (const double beside_rad_s : {start_rad_s / ratio, start_rad_s * ratio}) {
                if (const auto found = at(beside_rad_s)) {
                    const double before_rad_s =
                        beside_rad_s < start_rad_s ? beside_rad_s * Step_ratio : beside_rad_s / Step_ratio;
                    return ratio == 1.0 ? found : narrowed(before_rad_s, *found);
                }
            }
        }
        return std::nullopt;
    }

private:
    std::optional<CrossoverAim> at(double crossover_rad_s) const {
        CrossoverAim aim = m_wanted;
        aim.crossover_rad_s = crossover_rad_s;
        const auto margin_deg = AtCrossover(m_loop, aim).nearest(m_wanted.phaseMargin_deg, m_mayFall);
        if (!margin_deg) {
            return std::nullopt;
        }
        aim.phaseMargin_deg = *margin_deg;
        return aim;
    }

    CrossoverAim narrowed(double impossible_rad_s, CrossoverAim possible) const {
        for (int i = 0; i < 14; ++i) { // 5 % to some millionths: whoever pulls further sees no trembling
            const double middle_rad_s = std::sqrt(impossible_rad_s * possible.crossover_rad_s);
            if (const auto found = at(middle_rad_s)) {
                possible = *found;
            } else {
                impossible_rad_s = middle_rad_s;
            }
        }
        return possible;
    }

    Surroundings m_loop;
    CrossoverAim m_wanted;
    bool m_mayFall;
};

} // namespace

double slowestCrossover_rad_s(const LoopTiming& timing) {
    return 0.005 / timing.period_s;
}

double fastestCrossover_rad_s(const LoopTiming& timing) {
    return 0.9 * Pi / timing.period_s;
}

PidGains gainsAtCrossover(const PositionPlant& plant, const LoopTiming& timing, const CrossoverAim& aim,
                          const FilteredLaw& around) {
    using Complex = std::complex<double>;
    const double T = timing.period_s;
    const Complex z = std::polar(1.0, aim.crossover_rad_s * T);
    const double filter_s = around.gains.filter_s.value_or(0.0);
    Complex withoutController = sampledPlant(plant, T).at(z) * std::pow(z, -timing.delay_samples);
    for (const LoopFilter& filter : around.filters) {
        const auto sampled = sampledFilter(filter, T);
        withoutController *= sampled ? sampled->at(z) : Complex(1.0);
    }
    const Complex wanted =
        std::polar(1.0, degreesToRadians(aim.phaseMargin_deg - 180.0)) / withoutController; // C(z) asked for
    const double integralRate_1_s = aim.integralRate_ratio * aim.crossover_rad_s;
    const Complex perProportional = 1.0 + T * integralRate_1_s / (z - 1.0);
    const Complex perDerivative = (z - 1.0) / ((T + filter_s) * z - filter_s);
    const double determinant =
        perProportional.real() * perDerivative.imag() - perProportional.imag() * perDerivative.real();
    PidGains gains;
    gains.proportional =
        (wanted.real() * perDerivative.imag() - wanted.imag() * perDerivative.real()) / determinant;
    gains.derivative =
        (perProportional.real() * wanted.imag() - perProportional.imag() * wanted.real()) / determinant;
    gains.integral = integralRate_1_s * gains.proportional;
    return gains;
}

std::optional<CrossoverAim> crossoverAimOf(const PositionPlant& plant, const LoopTiming& timing,
                                           const PidGains& gains, const FilteredLaw& around) {
    const auto loop = openLoop(plant, timing, gains, around);
    if (!loop || !(gains.proportional > 0.0)) {
        return std::nullopt;
    }
    const StabilityMargins margins = smallestMargins(*loop);
    if (!margins.gainCrossover_rad_s) {
        return std::nullopt;
    }
    return CrossoverAim{*margins.gainCrossover_rad_s, margins.phaseMargin_deg,
                        gains.integral / (gains.proportional * *margins.gainCrossover_rad_s)};
}

Result<CrossoverDesign> designCrossover(const PositionPlant& plant, const LoopTiming& timing,
                                        const CrossoverAim& wanted, CrossoverPriority priority,
                                        const FilteredLaw& around) {
    const auto filters = filtersInSeries(around.filters, timing.period_s);
    const Result<void> filtered = filters ? Result<void>() : failure(filters.error());
    for (const auto& valid : {checkPlant(plant), checkTiming(timing), filtered}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    if (!std::isfinite(wanted.crossover_rad_s) || !std::isfinite(wanted.phaseMargin_deg) ||
        !std::isfinite(wanted.integralRate_ratio)) {
        return failure(ErrorCode::NotFinite, "the crossover or margin asked for is not a finite number");
    }
    const Surroundings loop{plant, timing, around};
    CrossoverAim aim = wanted;
    aim.integralRate_ratio = std::max(0.0, aim.integralRate_ratio);
    const CrossoverLimit limit = AtCrossover(loop, aim).limit(aim.phaseMargin_deg);
    if (limit == CrossoverLimit::None) {
        return CrossoverDesign{AtCrossover(loop, aim).gains(aim.phaseMargin_deg), aim, limit};
    }
    auto reached = Search(loop, aim, priority == CrossoverPriority::Crossover).nearest();
    if (!reached) { // the margin is nowhere to be had
        reached = Search(loop, aim, true).nearest();
    }
    if (!reached) {
        return failure(ErrorCode::Refused, "no crossover gives a stable position loop for this motor",
                       "identify the motor again, or choose a design method");
    }
    return CrossoverDesign{AtCrossover(loop, *reached).gains(reached->phaseMargin_deg), *reached, limit};
}

double stableFactor(const PositionPlant& plant, const LoopTiming& timing, const PidGains& gains,
                    double factor, const FilteredLaw& around) {
    if (isStable(plant, timing, times(gains, factor), around) || !isStable(plant, timing, gains, around)) {
        return factor;
    }
    double stable = 1.0;
    for (int i = 0; i < 30; ++i) {
        const double middle = std::sqrt(stable * factor);
        (isStable(plant, timing, times(gains, middle), around) ? stable : factor) = middle;
    }
    return stable;
}

} // namespace halbench::control
