#include "control/law/filtered_delta.h"

#include "control/base/assert.h"
#include "control/law/sampled_axis.h"

#include <cmath>

namespace halbench::control {

namespace {

/// Of d^power; zero outside the polynomial.
double coefficient(const Polynomial& polynomial, int power) {
    const auto size = static_cast<int>(polynomial.size());
    return power < 0 || power >= size ? 0.0 : polynomial[static_cast<std::size_t>(size - 1 - power)];
}

/// Without roots that numerator and denominator share at d = 0.
DeltaFactor factorOf(const LawSection<double>& section) {
    if (section.a1 == 0.0) {
        return {{section.b0}, {1.0}};
    }
    if (section.a2 == 0.0) {
        return {{section.b0, section.b1}, {1.0, section.a1}};
    }
    return {{section.b0, section.b1, section.b2}, {1.0, section.a1, section.a2}};
}

/// sum c_j s^j with s = rate d/(d + 2), times (d + 2)^order: Tustin's rule, put together from its terms.
Polynomial bilinear(const Polynomial& polynomial, int order, double rate_1_s) {
    Polynomial sum = {0.0};
    const int highest = degree(polynomial);
    for (int power = 0; power <= highest; ++power) {
        Polynomial term = {polynomial[static_cast<std::size_t>(highest - power)]};
        for (int i = 0; i < order; ++i) {
            term = multiply(term, i < power ? Polynomial{rate_1_s, 0.0} : Polynomial{1.0, 2.0});
        }
        sum = add(sum, term);
    }
    return sum;
}

/// K_P + T K_I/d + K_D/(T + T_f) d/(d + T/(T + T_f)) over one denominator; a term that is zero adds no pole.
DeltaFactor pidFactor(const PidGains& gains, double period_s) {
    const double span_s = period_s + gains.filter_s.value_or(0.0);
    const bool hasIntegral = gains.integral != 0.0;
    const bool hasDerivative = gains.derivative != 0.0;
    const Polynomial slow = hasIntegral ? Polynomial{1.0, 0.0} : Polynomial{1.0};
    const Polynomial fast = hasDerivative ? Polynomial{1.0, period_s / span_s} : Polynomial{1.0};
    Polynomial numerator = scale(multiply(slow, fast), gains.proportional);
    if (hasIntegral) {
        numerator = add(numerator, scale(fast, period_s * gains.integral));
    }
    if (hasDerivative) {
        numerator = add(numerator, multiply({gains.derivative / span_s, 0.0}, slow));
    }
    return {numerator, multiply(slow, fast)};
}

Result<DeltaSystem> seriesOf(const Result<DeltaSystem>& first, const Result<DeltaSystem>& second) {
    if (!first || !second) {
        return first ? second : first;
    }
    return series(*first, *second);
}

Result<DeltaSystem> systemOf(const DeltaFactor& factor, double period_s) {
    return DeltaSystem::factor(factor.numerator, factor.denominator, TimeBase::sampled(period_s));
}

} // namespace

Result<DeltaFactor> deltaFilter(const LoopFilter& filter, double period_s) {
    if (const auto* given = std::get_if<SectionFilter>(&filter)) {
        const auto sampled = sampledFilter(filter, period_s); // which knows what is possible
        return sampled ? Result<DeltaFactor>(factorOf(given->section)) : failure(sampled.error());
    }
    const auto continuous = continuousFilter(filter);
    if (!continuous) {
        return failure(continuous.error());
    }
    const double frequency_rad_s = frequencyOf_rad_s(filter);
    const double rate_1_s = frequency_rad_s / std::tan(0.5 * frequency_rad_s * period_s);
    const int order = continuous->order();
    return DeltaFactor{bilinear(continuous->numerator(), order, rate_1_s),
                       bilinear(continuous->denominator(), order, rate_1_s)};
}

Result<std::vector<LawSection<double>>> filterSections(const std::vector<LoopFilter>& filters,
                                                       double period_s) {
    std::vector<LawSection<double>> sections;
    for (const LoopFilter& filter : filters) {
        const auto sampled = sampledFilter(filter, period_s); // which knows its range
        const auto factor = sampled ? deltaFilter(filter, period_s) : failure(sampled.error());
        if (!factor) {
            return failure(factor.error());
        }
        const auto order = static_cast<int>(factor->denominator.size()) - 1;
        HB_ASSERT(order <= 2);
        const double lead = coefficient(factor->denominator, order);
        // A filter of the first order is one of the second with a root at d = 0 in both.
        const auto b = [&](int i) { return coefficient(factor->numerator, order - i) / lead; };
        const auto a = [&](int i) { return coefficient(factor->denominator, order - i) / lead; };
        sections.push_back({b(0), b(1), b(2), a(1), a(2)});
    }
    return sections;
}

DeltaFactor deltaRotor(const PositionPlant& plant, double period_s) {
    const double x = plant.dampingRate_1_s * period_s;
    const double scale = plant.accelerationGain_rad_s2_A * period_s * period_s;
    return {{scale * heldAngleShare(x), scale * heldSpeedShare(x)}, {1.0, -std::expm1(-x), 0.0}};
}

Result<DeltaSystem> deltaController(const FilteredLaw& law, double period_s) {
    const auto gains = checkedGains(law, period_s);
    if (!gains) {
        return failure(gains.error());
    }
    Result<DeltaSystem> controller = systemOf(pidFactor(*gains, period_s), period_s);
    for (const LoopFilter& filter : law.filters) {
        const auto factor = deltaFilter(filter, period_s);
        controller = factor ? seriesOf(controller, systemOf(*factor, period_s))
                            : Result<DeltaSystem>(failure(factor.error()));
    }
    return controller;
}

Result<DeltaSystem> deltaOpenLoop(const PositionPlant& plant, const FilteredLaw& law,
                                  const LoopTiming& timing) {
    for (const auto& valid : {checkPlant(plant), checkTiming(timing)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    const DeltaSystem::Roots late(static_cast<std::size_t>(timing.delay_samples), -1.0);
    const auto delay = DeltaSystem::make({}, late, 1.0, TimeBase::sampled(timing.period_s));
    return seriesOf(seriesOf(deltaController(law, timing.period_s), delay),
                    systemOf(deltaRotor(plant, timing.period_s), timing.period_s));
}

Result<double> filterGainAtRest(const std::vector<LoopFilter>& filters) {
    double gain = 1.0; // Tustin's rule keeps it
    for (const LoopFilter& filter : filters) {
        if (const auto* given = std::get_if<SectionFilter>(&filter)) {
            const DeltaFactor factor = factorOf(given->section);
            gain *= factor.numerator.back() / factor.denominator.back(); // at d = 0
            continue;
        }
        const auto continuous = continuousFilter(filter);
        if (!continuous) {
            return failure(continuous.error());
        }
        gain *= continuous->dcGain();
    }
    return gain;
}

} // namespace halbench::control
