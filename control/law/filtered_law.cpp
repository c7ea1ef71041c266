#include "control/law/filtered_law.h"

#include "control/law/filters.h"
#include "control/lti/discretize.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::control {

namespace {

/// Turn of the slowest root over one sample: nearer to z = 1 it cannot be told from an integrator.
constexpr double LeastTurn_rad = 1e-6;

Result<void> checkWeight(double weight, const char* name) {
    if (!std::isfinite(weight)) {
        return failure(ErrorCode::NotFinite, "a set-point weight is not a finite number");
    }
    if (weight < 0.0 || weight > 1.0) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("the set-point weight {} = {:.4g} is not between 0 and 1", name, weight));
    }
    return {};
}

Result<void> checkWeights(const FilteredLaw& law, const PidGains& gains) {
    for (const auto& valid :
         {checkWeight(law.proportionalWeight, "b"), checkWeight(law.derivativeWeight, "c")}) {
        if (!valid) {
            return valid;
        }
    }
    if (law.proportionalWeight < 1.0 && gains.integral == 0.0) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("without integral action the set-point weight b = {:.4g} gives a final "
                                   "value of {:.4g} times the reference",
                                   law.proportionalWeight, law.proportionalWeight),
                       "add integral action, or use b = 1");
    }
    return {};
}

Result<TransferFunction> seriesOf(const Result<TransferFunction>& first,
                                  const Result<TransferFunction>& second) {
    if (!first || !second) {
        return first ? second : first;
    }
    return series(*first, *second);
}

/// F (b K_P + I + c D); a term that is zero adds no pole.
Result<TransferFunction> weighted(const FilteredLaw& law, double period_s, double b, double c) {
    const auto gains = checkedGains(law, period_s);
    if (!gains) {
        return failure(gains.error());
    }
    const TimeBase base = TimeBase::sampled(period_s);
    Result<TransferFunction> sum = TransferFunction::gain(b * gains->proportional, base);
    if (gains->integral != 0.0) {
        const auto integral = TransferFunction::make({period_s * gains->integral}, {1.0, -1.0}, base);
        sum = integral ? parallel(*sum, *integral) : integral;
    }
    if (sum && c * gains->derivative != 0.0) {
        const double span_s = period_s + gains->filter_s.value_or(0.0);
        const double slope = c * gains->derivative / span_s;
        const auto derivative =
            TransferFunction::make({slope, -slope}, {1.0, (period_s - span_s) / span_s}, base);
        sum = derivative ? parallel(*sum, *derivative) : derivative;
    }
    return law.filters.empty() ? sum : seriesOf(sum, filtersInSeries(law.filters, period_s));
}

/// Both roots of d^2 + a1 d + a2 within the circle of radius 1 around -1 (Jury), or no memory at all.
bool isStable(const LawSection<double>& section) {
    const double a1 = section.a1;
    const double a2 = section.a2;
    const bool hasOneRoot = a2 == 0.0 && section.b2 == 0.0;
    return a1 == 0.0 ||
           (hasOneRoot ? a1 > 0.0 && a1 < 2.0 : a2 > 0.0 && a2 < a1 && 4.0 - 2.0 * a1 + a2 > 0.0);
}

Result<TransferFunction> sampledSection(const LawSection<double>& section, double period_s) {
    for (const double number : {section.b0, section.b1, section.b2, section.a1, section.a2}) {
        if (!std::isfinite(number)) {
            return failure(ErrorCode::NotFinite, "a coefficient of a filter is not a finite number",
                           "correct the coefficients of the section");
        }
    }
    if (!isStable(section)) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("the filter with a1 = {:.6g}, a2 = {:.6g} is not stable", section.a1, section.a2),
            "choose a1 and a2 with 0 < a2 < a1 and 4 - 2 a1 + a2 > 0");
    }
    const auto base = TimeBase::sampledChecked(period_s);
    if (!base) {
        return failure(base.error());
    }
    if (section.a1 == 0.0) {
        return TransferFunction::gain(section.b0, *base);
    }
    if (section.a2 == 0.0) {
        return TransferFunction::make({section.b0, section.b1 - section.b0}, {1.0, section.a1 - 1.0}, *base);
    }
    return TransferFunction::make(
        {section.b0, section.b1 - 2.0 * section.b0, section.b2 - section.b1 + section.b0},
        {1.0, section.a1 - 2.0, section.a2 - section.a1 + 1.0}, *base);
}

Result<void> checkLoop(const PositionPlant& plant, const LoopTiming& timing) {
    const auto valid = checkPlant(plant);
    return valid ? checkTiming(timing) : valid;
}

} // namespace

bool isBoardLaw(const FilteredLaw& law) {
    const bool isFiltered = law.gains.derivative != 0.0 && law.gains.filter_s.value_or(0.0) != 0.0;
    return !isFiltered && law.proportionalWeight == 1.0 && law.derivativeWeight == 0.0 && law.filters.empty();
}

Result<PidGains> checkedGains(const FilteredLaw& law, double period_s) {
    if (const auto base = TimeBase::sampledChecked(period_s); !base) {
        return failure(base.error());
    }
    auto gains = convert(law.gains, PidForm::Parallel, GainUnit::PerRadian);
    if (!gains) {
        return gains;
    }
    if (const auto valid = checkWeights(law, *gains); !valid) {
        return failure(valid.error());
    }
    if (law.filters.size() > MostFilters) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} filters exceed the maximum of {}", law.filters.size(), MostFilters),
                       "leave some of them out");
    }
    for (const LoopFilter& filter : law.filters) {
        if (const auto sampled = sampledFilter(filter, period_s); !sampled) {
            return failure(sampled.error());
        }
    }
    return gains;
}

Result<TransferFunction> continuousFilter(const LoopFilter& filter) {
    struct Kinds {
        Result<TransferFunction> operator()(const LeadFilter& f) const {
            return leadFilter(f.frequency_rad_s, f.phase_deg);
        }
        Result<TransferFunction> operator()(const LagFilter& f) const {
            return lagFilter(f.frequency_rad_s, f.ratio);
        }
        Result<TransferFunction> operator()(const NotchFilter& f) const {
            return notchFilter(f.frequency_rad_s, f.depth_ratio, f.damping_ratio);
        }
        Result<TransferFunction> operator()(const LowPassFilter& f) const {
            return lowPassFilter(f.corner_rad_s, f.order);
        }
        Result<TransferFunction> operator()(const SectionFilter& /*f*/) const {
            return failure(ErrorCode::InvalidInput, "a section is defined by its sampled coefficients");
        }
    };
    return std::visit(Kinds{}, filter);
}

double frequencyOf_rad_s(const LoopFilter& filter) {
    struct Kinds {
        double operator()(const LeadFilter& f) const { return f.frequency_rad_s; }
        double operator()(const LagFilter& f) const { return f.frequency_rad_s; }
        double operator()(const NotchFilter& f) const { return f.frequency_rad_s; }
        double operator()(const LowPassFilter& f) const { return f.corner_rad_s; }
        double operator()(const SectionFilter& /*f*/) const { return 0.0; }
    };
    return std::visit(Kinds{}, filter);
}

Result<TransferFunction> sampledFilter(const LoopFilter& filter, double period_s) {
    if (const auto* given = std::get_if<SectionFilter>(&filter)) {
        return sampledSection(given->section, period_s);
    }
    const auto* lag = std::get_if<LagFilter>(&filter);
    const double slowest_rad_s = frequencyOf_rad_s(filter) / (lag != nullptr ? lag->ratio : 1.0);
    if (slowest_rad_s * period_s < LeastTurn_rad) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("invalid filter: {} is out of range", slowest_rad_s));
    }
    const auto continuous = continuousFilter(filter);
    return continuous ? discretize(*continuous, period_s, Hold::Tustin{frequencyOf_rad_s(filter)})
                      : continuous;
}

Result<TransferFunction> filtersInSeries(const std::vector<LoopFilter>& filters, double period_s) {
    const auto base = TimeBase::sampledChecked(period_s);
    if (!base) {
        return failure(base.error());
    }
    Result<TransferFunction> product = TransferFunction::gain(1.0, *base);
    for (const LoopFilter& filter : filters) {
        product = seriesOf(product, sampledFilter(filter, period_s));
    }
    return product;
}

Result<TransferFunction> filteredController(const FilteredLaw& law, double period_s) {
    return weighted(law, period_s, 1.0, 1.0);
}

Result<TransferFunction> filteredReferencePath(const FilteredLaw& law, double period_s) {
    return weighted(law, period_s, law.proportionalWeight, law.derivativeWeight);
}

Result<TransferFunction> filteredOpenLoop(const PositionPlant& plant, const FilteredLaw& law,
                                          const LoopTiming& timing) {
    if (const auto valid = checkLoop(plant, timing); !valid) {
        return failure(valid.error());
    }
    const auto delayed = seriesOf(filteredController(law, timing.period_s),
                                  TransferFunction::delay(timing.delay_samples, timing.period_s));
    return seriesOf(delayed, sampledPlant(plant, timing.period_s));
}

// The two paths have their poles in common but for terms that a weight of zero takes out: numerator over
// numerator would leave them twice. C_r G/(1 + C_y G) = (C_r/C_y) T is put together over C_y's denominator.
Result<TransferFunction> filteredClosedLoop(const PositionPlant& plant, const FilteredLaw& law,
                                            const LoopTiming& timing) {
    const auto loop = filteredOpenLoop(plant, law, timing);
    const auto path = filteredReferencePath(law, timing.period_s);
    const auto controller = filteredController(law, timing.period_s);
    if (!loop || !path || !controller) {
        return failure(!loop ? loop.error() : !path ? path.error() : controller.error());
    }
    // With D in the controller and c = 0, the path lacks D's denominator.
    Polynomial missing = {1.0};
    if (degree(controller->denominator()) > degree(path->denominator())) {
        const auto gains = checkedGains(law, timing.period_s);
        const double filter_s = gains->filter_s.value_or(0.0);
        missing = {1.0, -filter_s / (timing.period_s + filter_s)};
    }
    const TransferFunction held = sampledPlant(plant, timing.period_s);
    return TransferFunction::make(multiply(multiply(path->numerator(), missing), held.numerator()),
                                  add(loop->numerator(), loop->denominator()),
                                  TimeBase::sampled(timing.period_s));
}

} // namespace halbench::control
