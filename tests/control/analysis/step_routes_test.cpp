// Step figures of random systems: from the library's samples against the sum of exponentials, whose crossings
// are bisected.
#include "control/analysis/step_metrics.h"
#include "control/lti/responses.h"
#include "tests/control/random_systems.h"
#include "tests/control/routes/partial_fractions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace halbench::control {
namespace {

using Curve = std::function<double(double)>;

/// The last place in (low, high] at which a curve that is positive at `high` was not: halved 60 times.
double edge(const Curve& excess, double low, double high) {
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (excess(middle) >= 0.0 ? high : low) = middle;
    }
    return high;
}

/// Looks 8 times closer than the samples are.
std::optional<double> firstAt(const Curve& excess, double step_s, double end_s) {
    for (double t = step_s; t < end_s; t += step_s) {
        if (excess(t) >= 0.0) {
            return edge(excess, t - step_s, t);
        }
    }
    return {};
}
std::optional<double> lastOutside(const Curve& excess, double step_s, double end_s) {
    for (double t = end_s; t > step_s; t -= step_s) {
        if (excess(t - step_s) < 0.0) {
            return edge(excess, t - step_s, t);
        }
    }
    return {};
}

/// Straight lines between samples miss a curve by h^2/8 of its second derivative: so much on the slope there,
/// and a share of a sample where it is flat.
double timeTolerance_s(const PartialFractions& exact, double time_s, double step_s, double height) {
    double curvature = 0.0;
    for (int i = -8; i <= 8; ++i) {
        const double t = std::max(0.0, time_s + 0.25 * i * step_s);
        curvature = std::max(curvature, std::abs(exact.impulse(t, 1)));
    }
    const double miss = step_s * step_s / 8.0 * curvature + 1e-12 * std::abs(height);
    const double slope = std::abs(exact.impulse(time_s));
    return std::min(2.0 * miss / slope, 2.0 * std::sqrt(2.0 * miss / std::max(curvature, 1e-300))) + 1e-9;
}

TEST(StepRoutes, figuresOfRandomSystemsAreThoseOfTheirExponentials) {
    Random random(121);
    int risen = 0;
    int overshot = 0;
    for (int round = 0; round < 80; ++round) {
        const auto system = randomSystem(random, 1 + static_cast<int>(random.below(5)), true);
        const double to = system.dcGain();
        double slowest = HUGE_VAL;
        for (const auto& pole : poles(system)) {
            slowest = std::min(slowest, -pole.real());
        }
        const double duration_s = 12.0 / slowest;
        const double step_s = duration_s / 4000.0;
        const auto response = stepResponse(system, duration_s, step_s);
        ASSERT_TRUE(response.has_value());
        const auto metrics = measureStep(response->time_s, response->value, 0.0, to);
        ASSERT_TRUE(metrics.has_value());

        const PartialFractions exact(system);
        const double end_s = response->time_s.back();
        const auto above = [&](double level) {
            return [&exact, to, level](double t) { return exact.step(t) / to - level; };
        };
        const auto low = firstAt(above(0.1), step_s / 8.0, end_s);
        const auto high = firstAt(above(0.9), step_s / 8.0, end_s);
        ASSERT_EQ(metrics->riseTime_s.has_value(), low && high) << round;
        if (low && high) {
            const double tolerance_s =
                timeTolerance_s(exact, *low, step_s, to) + timeTolerance_s(exact, *high, step_s, to);
            EXPECT_NEAR(*metrics->riseTime_s, *high - *low, tolerance_s) << round;
            ++risen;
        }
        const auto inside = [&](double t) { return 0.02 - std::abs(exact.step(t) / to - 1.0); };
        if (const auto settled = lastOutside(inside, step_s / 8.0, end_s)) {
            ASSERT_TRUE(metrics->settlingTime_s.has_value()) << round;
            EXPECT_NEAR(*metrics->settlingTime_s, *settled, timeTolerance_s(exact, *settled, step_s, to))
                << round;
        }
        double peak = 0.0;
        double curvature = 0.0;
        for (double t = 0.0; t <= end_s; t += step_s / 8.0) {
            peak = std::max(peak, exact.step(t) / to);
            curvature = std::max(curvature, std::abs(exact.impulse(t, 1) / to));
        }
        // The farthest sample is at most half a sample beside the peak.
        EXPECT_NEAR(metrics->overshoot_percent, std::max(0.0, 100.0 * (peak - 1.0)),
                    100.0 * step_s * step_s / 8.0 * curvature + 1e-9)
            << round;
        overshot += peak > 1.01 ? 1 : 0;
        EXPECT_NEAR(metrics->finalError_rad, to - exact.step(end_s), 1e-10 * exact.size()) << round;
    }
    EXPECT_GT(risen, 60);
    EXPECT_GT(overshot, 20);
}

} // namespace
} // namespace halbench::control
