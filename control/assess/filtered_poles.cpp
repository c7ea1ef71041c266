// Poles of a filtered loop from states in d = z - 1: slow filters beside integrators lie close to z = 1
// together, where one polynomial keeps the n-th root of its rounding of them. In d nothing cancels: each part
// is put together from positive terms, and the matrix is graded, so that balancing keeps the digits of slow
// poles.
#include "control/assess/filtered_loop.h"
#include "control/law/filtered_delta.h"
#include "control/lti/eigenvalues.h"
#include "control/lti/state_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::control {

namespace {

/// What is rational in d; states follow it as those of a continuous system follow s.
StateSpace statesOf(Polynomial numerator, Polynomial denominator) {
    return toStateSpace(
        *TransferFunction::make(std::move(numerator), std::move(denominator), TimeBase::continuous()));
}

StateSpace statesOf(const DeltaFactor& factor) {
    return statesOf(factor.numerator, factor.denominator);
}

Result<StateSpace> filterStates(const LoopFilter& filter, double period_s) {
    const auto factor = deltaFilter(filter, period_s);
    return factor ? Result<StateSpace>(statesOf(*factor)) : failure(factor.error());
}

/// K_P + T K_I/d + K_D/(T + T_f) d/(d + T/(T + T_f)).
Result<StateSpace> controllerStates(const PidGains& gains, double period_s) {
    const double span_s = period_s + gains.filter_s.value_or(0.0);
    Result<StateSpace> sum = statesOf({gains.proportional}, {1.0});
    if (gains.integral != 0.0) {
        sum = parallel(*sum, statesOf({period_s * gains.integral}, {1.0, 0.0}));
    }
    if (sum && gains.derivative != 0.0) {
        sum = parallel(*sum, statesOf({gains.derivative / span_s, 0.0}, {1.0, period_s / span_s}));
    }
    return sum;
}

/// What stands behind the PID part of a law with filters, in series.
Result<StateSpace> statesBehind(const PositionPlant& plant, const FilteredLaw& law,
                                const LoopTiming& timing) {
    Result<StateSpace> states = filterStates(law.filters.front(), timing.period_s);
    for (std::size_t i = 1; states && i < law.filters.size(); ++i) {
        const auto section = filterStates(law.filters[i], timing.period_s);
        states = section ? series(*states, *section) : section;
    }
    for (int i = 0; states && i < timing.delay_samples; ++i) {
        states = series(*states, statesOf({1.0}, {1.0, 1.0}));
    }
    return states ? series(*states, statesOf(deltaRotor(plant, timing.period_s))) : states;
}

/// Of the loop that these gains close.
Result<std::vector<std::complex<double>>> closedPoles(const PidGains& gains, const StateSpace& behind,
                                                      double period_s) {
    Result<StateSpace> states = controllerStates(gains, period_s);
    states = states ? series(*states, behind) : states;
    if (!states) {
        return failure(states.error());
    }
    const Eigen::MatrixXd closed = states->A - states->B * states->C; // the rotor has no direct way
    std::vector<std::complex<double>> found = eigenvalues(closed);
    for (std::complex<double>& pole : found) {
        pole += 1.0;
    }
    return found;
}

double largest(const std::vector<std::complex<double>>& poles) {
    double radius = 0.0;
    for (const std::complex<double>& pole : poles) {
        radius = std::max(radius, std::abs(pole));
    }
    return radius;
}

/// The gains in parallel form, when all that makes the loop is possible.
Result<PidGains> checkedLoop(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing) {
    for (const auto& valid : {checkPlant(plant), checkTiming(timing)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    return checkedGains(law, timing.period_s);
}

} // namespace

Result<std::vector<std::complex<double>>> filteredPoles(const PositionPlant& plant, const FilteredLaw& law,
                                                        const LoopTiming& timing) {
    if (law.filters.empty()) { // as of the board's own, whose few roots a polynomial keeps
        const auto loop = filteredOpenLoop(plant, law, timing);
        return loop ? closedLoopPoles(*loop)
                    : Result<std::vector<std::complex<double>>>(failure(loop.error()));
    }
    const auto gains = checkedLoop(plant, law, timing);
    const auto behind = gains ? statesBehind(plant, law, timing) : failure(gains.error());
    return behind ? closedPoles(*gains, *behind, timing.period_s)
                  : Result<std::vector<std::complex<double>>>(failure(behind.error()));
}

Result<double> filteredPoleRadius(const PositionPlant& plant, const FilteredLaw& law,
                                  const LoopTiming& timing) {
    const auto poles = filteredPoles(plant, law, timing);
    return poles ? Result<double>(largest(*poles)) : failure(poles.error());
}

Result<std::function<Result<double>(double)>> filteredPoleRadiusOfProportional(const PositionPlant& plant,
                                                                               const FilteredLaw& law,
                                                                               const LoopTiming& timing) {
    using Radius = std::function<Result<double>(double)>;
    const auto gains = checkedLoop(plant, law, timing);
    if (!gains) {
        return failure(gains.error());
    }
    FilteredLaw other = law;
    other.gains = *gains;
    if (law.filters.empty()) {
        return Radius([plant, other, timing](double proportional) mutable {
            other.gains.proportional = proportional;
            return filteredPoleRadius(plant, other, timing);
        });
    }
    auto behind = statesBehind(plant, law, timing);
    if (!behind) {
        return failure(behind.error());
    }
    return Radius([behind = *std::move(behind), now = *gains, timing](double proportional) mutable {
        now.proportional = proportional;
        const auto poles = closedPoles(now, behind, timing.period_s);
        return poles ? Result<double>(largest(*poles)) : failure(poles.error());
    });
}

} // namespace halbench::control
