#include "control/assess/filtered_loop.h"

#include "control/assess/open_loop_assessment.h"
#include "control/law/filtered_controller.h"
#include "control/law/filtered_delta.h"
#include "control/law/gain_limit.h"
#include "control/lti/riccati.h"
#include "control/lti/state_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {

namespace {

/// The law's parts as states of their own: one polynomial would put all slow roots into one row.
Result<StateSpace> controllerStates(const FilteredLaw& law, const LoopTiming& timing) {
    FilteredLaw bare = law;
    bare.filters.clear();
    const auto controller = filteredController(bare, timing.period_s);
    if (!controller) {
        return failure(controller.error());
    }
    const auto delayed = series(*controller, TransferFunction::delay(timing.delay_samples, timing.period_s));
    if (!delayed) {
        return failure(delayed.error());
    }
    Result<StateSpace> states = toStateSpace(*delayed);
    for (const LoopFilter& filter : law.filters) {
        const auto sampled = sampledFilter(filter, timing.period_s);
        if (!sampled) {
            return failure(sampled.error());
        }
        states = states ? series(*states, toStateSpace(*sampled)) : states;
    }
    return states;
}

/// H2 norm of C F z^-d/(1 + L), from the measured angle to the current, of a stable loop.
Result<double> noiseGain(const PositionPlant& plant, const FilteredLaw& law, const LoopTiming& timing) {
    const auto controller = controllerStates(law, timing);
    if (!controller) {
        return failure(controller.error());
    }
    const auto noise = feedback(*controller, toStateSpace(sampledPlant(plant, timing.period_s)));
    if (!noise) {
        return failure(noise.error());
    }
    const Eigen::MatrixXd X = solveLyapunov(noise->A, noise->B * noise->B.transpose());
    return std::sqrt((noise->C * X * noise->C.transpose() + noise->D * noise->D.transpose()).value());
}

/// In the parallel form, so that single gains may be changed.
Result<FilteredLaw> inParallelForm(FilteredLaw law, double period_s) {
    const auto gains = checkedGains(law, period_s);
    if (!gains) {
        return failure(gains.error());
    }
    law.gains = *gains;
    return law;
}

} // namespace

// The integral's part stays for ever and is no fast one.
Result<double> filteredFastGain_A_per_rad(const FilteredLaw& law, double period_s) {
    auto fast = inParallelForm(law, period_s);
    if (!fast) {
        return failure(fast.error());
    }
    fast->gains.integral = 0.0;
    fast->proportionalWeight = 1.0; // the angle's path has no weights
    auto controller = FilteredController::make(*fast, period_s);
    if (!controller) {
        return failure(controller.error());
    }
    constexpr int Samples = 200; // the answer of a slow low-pass is largest within its first samples
    double largest = std::abs(controller->step(0.0, -1.0));
    for (int i = 1; i < Samples; ++i) {
        largest = std::max(largest, std::abs(controller->step(0.0, 0.0)));
    }
    return largest;
}

Result<double> filteredProportionalLimit_A_per_rad(const PositionPlant& plant, const FilteredLaw& law,
                                                   const LoopTiming& timing) {
    auto plain = inParallelForm(law, timing.period_s);
    if (!plain) {
        return failure(plain.error());
    }
    plain->gains.integral = 0.0;
    plain->proportionalWeight = 1.0;
    const auto radius = filteredPoleRadiusOfProportional(plant, *plain, timing);
    if (!radius) {
        return failure(radius.error());
    }
    return largestStableGain(plant, timing, [&](double proportional) {
        const auto of = (*radius)(proportional);
        return of && *of < 1.0;
    });
}

Result<LoopAssessment> assessFilteredDesign(const PositionPlant& plant, const FilteredLaw& law,
                                            const LoopTiming& timing, double currentLimit_A,
                                            double duration_s) {
    if (!(std::isfinite(currentLimit_A) && currentLimit_A > 0.0)) {
        return failure(ErrorCode::OutOfRange, "the current limit must be positive");
    }
    const auto loop = deltaOpenLoop(plant, law, timing);
    const LoopTiming oneLater{timing.period_s, timing.delay_samples + 1};
    const auto radius = filteredPoleRadius(plant, law, timing);
    const auto later = filteredPoleRadius(plant, law, oneLater);
    const auto fast_A = filteredFastGain_A_per_rad(law, timing.period_s);
    const auto limit_A = filteredProportionalLimit_A_per_rad(plant, law, timing);
    if (!loop || !radius || !later || !fast_A || !limit_A) {
        return failure(!loop     ? loop.error()
                       : !radius ? radius.error()
                       : !later  ? later.error()
                       : !fast_A ? fast_A.error()
                                 : limit_A.error());
    }
    auto step = filteredStep(plant, law, timing, 1.0, duration_s);
    if (!step) {
        return failure(step.error());
    }
    LoopAssessment assessment = assessOpenLoop(*loop, *radius, *later, *std::move(step), currentLimit_A);
    assessment.noiseGain_A_per_rad = std::numeric_limits<double>::infinity();
    if (assessment.isStable) {
        const auto noise = noiseGain(plant, law, timing);
        if (!noise) {
            return failure(noise.error());
        }
        assessment.noiseGain_A_per_rad = *noise;
    }
    assessment.fastGain_A_per_rad = *fast_A;
    assessment.proportionalLimit_A_per_rad = *limit_A;
    return assessment;
}

} // namespace halbench::control
