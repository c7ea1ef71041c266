// The least error within bounds, against a search that shares nothing with it: the law and the motor written
// out sample by sample, the sensitivity from the books' formula, and every gain of a grid.
#include "control/base/units.h"
#include "control/design/design_methods.h"
#include "control/design/optimal_designs.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace halbench::control {
namespace {

constexpr double k = 26.0;
constexpr double a = 1.23e-3 / 5.5e-4;
constexpr double Period_s = 0.01;
constexpr double Limit_A = 4.0;

/// Motor and law, one sample after the other; `load_A` acts beside the law's current.
struct Run {
    double error = 0.0; ///< integral of |e|, or of t |e|
    double peak_A = 0.0;
};
Run run(const PidGains& gains, int delay, double reference_rad, double load_A, bool isWeighed, int samples) {
    const double decay = std::exp(-a * Period_s);
    double angle = 0.0;
    double speed = 0.0;
    double last = 0.0;
    double integral = 0.0;
    std::array<double, 3> asked{}; // newest first
    Run result;
    for (int i = 0; i < samples; ++i) {
        asked = {gains.proportional * (reference_rad - angle) + integral -
                     gains.derivative * (angle - last) / Period_s,
                 asked[0], asked[1]};
        integral += Period_s * gains.integral * (reference_rad - angle);
        last = angle;
        const double law_A = asked[static_cast<std::size_t>(delay)];
        result.error += Period_s * std::abs(angle - reference_rad) * (isWeighed ? i * Period_s : 1.0);
        result.peak_A = std::max(result.peak_A, std::abs(law_A));
        const double final_rad_s = k / a * (law_A + load_A);
        angle += final_rad_s * Period_s + (speed - final_rad_s) * (1.0 - decay) / a;
        speed = final_rad_s + (speed - final_rad_s) * decay;
        if (!(std::abs(angle) < 1e3)) {
            return {std::numeric_limits<double>::infinity(), result.peak_A};
        }
    }
    return result;
}

/// 1/min |1 + L| at 400 frequencies up to Nyquist: never more than the true peak, thus no gains are left out.
double sensitivity(const PidGains& gains, int delay) {
    const double decay = std::exp(-a * Period_s);
    const double b1 = k / (a * a) * (a * Period_s - 1.0 + decay);
    const double b2 = k / (a * a) * (1.0 - decay - a * Period_s * decay);
    constexpr int Points = 400;
    double nearest = 1.0;
    for (int i = 0; i < Points; ++i) {
        const double angle = Pi * std::pow(1e-3, 1.0 - (i + 1.0) / Points);
        const std::complex<double> z = std::polar(1.0, angle);
        const std::complex<double> law = gains.proportional + Period_s * gains.integral / (z - 1.0) +
                                         gains.derivative / Period_s * (z - 1.0) / z;
        const std::complex<double> motor = (b1 * z + b2) / ((z - 1.0) * (z - decay));
        nearest = std::min(nearest, std::abs(1.0 + law * motor * std::pow(z, -delay)));
    }
    return 1.0 / nearest;
}

struct Case {
    const char* name;
    ErrorMeasure measure;
    double mostMs_ratio;
    std::optional<double> step_rad;
    int delay;
    bool isMsActive;
    bool isCurrentActive;
};

double errorOf(const Case& asked, const PidGains& gains) {
    return run(gains, asked.delay, 0.0, 1.0, asked.measure == ErrorMeasure::Itae, 3000).error;
}

bool isWithin(const Case& asked, const PidGains& gains) {
    if (asked.step_rad && run(gains, asked.delay, *asked.step_rad, 0.0, false, 1000).peak_A > Limit_A) {
        return false;
    }
    return sensitivity(gains, asked.delay) <= asked.mostMs_ratio;
}

/// The least error of a grid around a point, `steps` either way, `ratio` from one to the next.
PidGains bestOfGrid(const Case& asked, PidGains middle, int steps, double ratio) {
    PidGains best = middle;
    double least = std::numeric_limits<double>::infinity();
    for (int p = -steps; p <= steps; ++p) {
        for (int i = -steps; i <= steps; ++i) {
            for (int d = -steps; d <= steps; ++d) {
                PidGains gains = middle;
                gains.proportional *= std::pow(ratio, p);
                gains.integral *= std::pow(ratio, i);
                gains.derivative *= std::pow(ratio, d);
                const double error = isWithin(asked, gains) ? errorOf(asked, gains) : least;
                if (error < least) {
                    least = error;
                    best = gains;
                }
            }
        }
    }
    return best;
}

class LeastErrorWithinBounds : public testing::TestWithParam<Case> {};

TEST_P(LeastErrorWithinBounds, isNotBeatenByAnyGainsOfAGrid) {
    const Case& asked = GetParam();
    const LeastErrorTargets targets{asked.measure, asked.mostMs_ratio, asked.step_rad};
    const auto design = designLeastError(published(), {Period_s, asked.delay}, targets, Limit_A);
    ASSERT_TRUE(design.has_value()) << design.error().message;
    const double own = errorOf(asked, design->gains);
    PidGains best; // a wide grid first, around the middle of what this motor can have; then two finer ones
    best.proportional = 20.0;
    best.integral = 60.0;
    best.derivative = 1.0;
    for (const double ratio : {1.6, 1.12, 1.03}) {
        best = bestOfGrid(asked, best, 7, ratio);
    }
    EXPECT_GT(errorOf(asked, best), 0.99 * own)
        << best.proportional << " " << best.integral << " " << best.derivative << " instead of "
        << design->gains.proportional << " " << design->gains.integral << " " << design->gains.derivative;
}

TEST_P(LeastErrorWithinBounds, keepsTheBoundsAndSaysWhichOneCounts) {
    const Case& asked = GetParam();
    const LeastErrorTargets targets{asked.measure, asked.mostMs_ratio, asked.step_rad};
    const auto design = designLeastError(published(), {Period_s, asked.delay}, targets, Limit_A);
    ASSERT_TRUE(design.has_value()) << design.error().message;
    EXPECT_LE(design->assessment.peaks.Ms_ratio, 1.001 * asked.mostMs_ratio);
    EXPECT_LE(sensitivity(design->gains, asked.delay), 1.001 * asked.mostMs_ratio);
    const LeastErrorBounds bounds = boundsOf(design->assessment, targets, Limit_A);
    EXPECT_EQ(bounds.sensitivity.isActive(), asked.isMsActive) << bounds.sensitivity.value;
    ASSERT_EQ(bounds.current.has_value(), asked.step_rad.has_value());
    if (asked.step_rad) {
        const double peak_A = run(design->gains, asked.delay, *asked.step_rad, 0.0, false, 2000).peak_A;
        EXPECT_LE(peak_A, 1.001 * Limit_A);
        EXPECT_NEAR(bounds.current->value, peak_A, 1e-6 * peak_A); // two runs of the same law
        EXPECT_EQ(bounds.current->isActive(), asked.isCurrentActive) << bounds.current->value;
    }
}

// With 0.5 rad K_P stays below 8 A/rad, far less than Ms alone allows; with 0.1 rad of a slow loop the
// board's limit is out of reach.
INSTANTIATE_TEST_SUITE_P(Targets, LeastErrorWithinBounds,
                         testing::Values(Case{"calm", ErrorMeasure::Iae, 1.4, {}, 0, true, false},
                                         Case{"usual", ErrorMeasure::Iae, 1.7, {}, 0, true, false},
                                         Case{"livelyTimed", ErrorMeasure::Itae, 2.0, {}, 0, true, false},
                                         Case{"delayed", ErrorMeasure::Iae, 1.7, 0.035, 1, true, false},
                                         Case{"delayedTwice", ErrorMeasure::Itae, 1.5, 0.035, 2, true, false},
                                         Case{"current", ErrorMeasure::Iae, 1.7, 0.5, 0, false, true},
                                         Case{"currentDelayed", ErrorMeasure::Iae, 2.5, 0.6, 1, false, true},
                                         Case{"currentTimed", ErrorMeasure::Itae, 3.0, 0.5, 0, false, true},
                                         Case{"both", ErrorMeasure::Iae, 1.4, 0.208, 0, true, true}),
                         [](const auto& asked) { return asked.param.name; });

DesignTargets asked(std::optional<double> Ms, std::optional<double> current_A = {},
                    std::optional<double> step_deg = {}) {
    DesignTargets targets;
    targets.mostMs_ratio = Ms;
    targets.currentLimit_A = current_A;
    targets.step_deg = step_deg;
    return targets;
}

// The targets of the method are those of the search, each in its unit.
TEST(LeastErrorMethod, readsItsBounds) {
    const auto law = designLaw("min-iae", published(), NoDelay, asked(1.4, 3.0, 20.0));
    const auto design =
        designLeastError(published(), NoDelay, {ErrorMeasure::Iae, 1.4, degreesToRadians(20.0)}, 3.0);
    ASSERT_TRUE(law && design);
    EXPECT_EQ(law->gains.proportional, design->gains.proportional);
    EXPECT_EQ(law->gains.integral, design->gains.integral);
    EXPECT_LE(law->gains.proportional * degreesToRadians(20.0), 1.001 * 3.0);
    EXPECT_TRUE(readsTarget("min-itae", "current-limit-a"));
    EXPECT_FALSE(readsTarget("recommended", "max-sensitivity"));
}

TEST(LeastErrorMethod, refusesBoundsThatAreNoneWithTheirRangeAndARemedy) {
    const std::pair<DesignTargets, const char*> wrong[] = {{asked(1.0), "1.1 and 3"},
                                                           {asked(3.5), "1.1 and 3"},
                                                           {asked({}, -1.0), "current-limit-a"},
                                                           {asked({}, 4.0, 0.0), "0 and 360"},
                                                           {asked({}, 4.0, 400.0), "0 and 360"},
                                                           {asked({}, {}, 10.0), "step-deg"}};
    for (const auto& [targets, words] : wrong) {
        const auto refused = designLaw("min-iae", published(), NoDelay, targets);
        ASSERT_FALSE(refused.has_value()) << words;
        EXPECT_NE(refused.error().message.find(words), std::string::npos) << refused.error().message;
        EXPECT_FALSE(refused.error().hint.empty()) << words;
    }
    EXPECT_EQ(designLaw("recommended", published(), NoDelay, asked(1.5)).error().code, ErrorCode::Usage);
}

} // namespace
} // namespace halbench::control
