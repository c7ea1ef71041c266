#include "control/analysis/measured_margins.h"
#include "control/base/random.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

using Withheld = MeasuredMargin::Withheld;

// 2/(s (s+1)(s+2)): gain margin 3 at sqrt(2) rad/s.
const TransferFunction& thirdOrder() {
    static const auto loop = *TransferFunction::make({2.0}, {1.0, 3.0, 2.0, 0.0}, TimeBase::continuous());
    return loop;
}

MeasuredLoop measured(int points, double error_ratio, double from = 0.1, double to = 10.0) {
    MeasuredLoop loop;
    loop.response = *frequencyResponse(thirdOrder(), logarithmicFrequencies(from, to, points));
    for (const auto& value : loop.response.value) {
        loop.radius.push_back(error_ratio * std::abs(value));
    }
    return loop;
}

// What lies between the points is a straight line of the logarithms; the interval counts it in.
TEST(MeasuredMargins, intervalsOfExactPointsHoldTheMarginsOfTheModel) {
    const StabilityMargins expected = smallestMargins(thirdOrder());
    for (const int points : {12, 25, 60}) {
        const MeasuredMargins margins = measuredMargins(measured(points, 0.0), {20.0, 20.0});
        ASSERT_EQ(margins.phase_deg.withheld, Withheld::No) << points;
        ASSERT_EQ(margins.gain_dB.withheld, Withheld::No) << points;
        EXPECT_LE(margins.phase_deg.interval->first, expected.phaseMargin_deg);
        EXPECT_GE(margins.phase_deg.interval->second, expected.phaseMargin_deg);
        EXPECT_LE(margins.gain_dB.interval->first, 20.0 * std::log10(3.0));
        EXPECT_GE(margins.gain_dB.interval->second, 20.0 * std::log10(3.0));
    }
    const MeasuredMargins dense = measuredMargins(measured(400, 0.0), {});
    // 400 points: steps of 0.0115 in log frequency, straight to 0.0115^2/8 of a curvature of about one.
    EXPECT_NEAR(*dense.phase_deg.value, expected.phaseMargin_deg, 1e-2);
    EXPECT_NEAR(*dense.gain_dB.value, 20.0 * std::log10(3.0), 1e-3);
    EXPECT_NEAR(*dense.gain_dB.frequency_rad_s, std::sqrt(2.0), 1e-3);
}

// At sqrt(2) the slopes are m = -1 - 2/3 - 1/3 = -2 and f = -(sqrt2/3 + sqrt2 2/6) = -2 sqrt2/3: an error of
// 1 % is 0.0869 dB times sqrt(1 + (m/f)^2) = 2.345. At the phase margin likewise, from the same formulas.
TEST(MeasuredMargins, halfWidthsFollowFromTheSlopes) {
    const MeasuredMargins margins = measuredMargins(measured(400, 0.01), {});
    const double m = -2.0;
    const double f = -2.0 * std::sqrt(2.0) / 3.0;
    const double half_dB = 0.5 * (margins.gain_dB.interval->second - margins.gain_dB.interval->first);
    // The slopes are differences over a step: 1 % of them.
    EXPECT_NEAR(half_dB, 20.0 / std::log(10.0) * 0.01 * std::hypot(1.0, m / f), 0.01 * half_dB);
    const double w = *margins.phase_deg.frequency_rad_s;
    const double slope = -1.0 - w * w / (1.0 + w * w) - w * w / (4.0 + w * w);
    const double turn = -w / (1.0 + w * w) - 2.0 * w / (4.0 + w * w);
    const double half_deg = 0.5 * (margins.phase_deg.interval->second - margins.phase_deg.interval->first);
    EXPECT_NEAR(half_deg, radiansToDegrees(0.01 * std::hypot(1.0, turn / slope)), 0.01 * half_deg);
}

// Errors within the circles at every point, neighbours against each other: the margins move, and stay inside.
TEST(MeasuredMargins, anyErrorWithinTheCirclesStaysWithinTheIntervals) {
    const StabilityMargins expected = smallestMargins(thirdOrder());
    Random random(7);
    for (int run = 0; run < 500; ++run) {
        MeasuredLoop loop = measured(30, 0.02);
        for (std::size_t i = 0; i < loop.radius.size(); ++i) {
            loop.response.value[i] +=
                std::polar(loop.radius[i] * random.uniform(), 2.0 * Pi * random.uniform());
        }
        const MeasuredMargins margins = measuredMargins(loop, {90.0, 90.0});
        ASSERT_TRUE(margins.phase_deg.interval && margins.gain_dB.interval) << run;
        EXPECT_LE(margins.phase_deg.interval->first, expected.phaseMargin_deg) << run;
        EXPECT_GE(margins.phase_deg.interval->second, expected.phaseMargin_deg) << run;
        EXPECT_LE(margins.gain_dB.interval->first, 20.0 * std::log10(3.0)) << run;
        EXPECT_GE(margins.gain_dB.interval->second, 20.0 * std::log10(3.0)) << run;
    }
}

TEST(MeasuredMargins, withholdsWhatIsTooUncertainAndSaysBetweenWhatItLies) {
    const MeasuredMargins margins = measuredMargins(measured(60, 0.2), {});
    EXPECT_EQ(margins.phase_deg.withheld, Withheld::Uncertain);
    EXPECT_FALSE(margins.phase_deg.value);
    EXPECT_TRUE(margins.phase_deg.interval);
    EXPECT_EQ(margins.gain_dB.withheld, Withheld::Uncertain);
    EXPECT_FALSE(margins.gain_dB.value);
}

TEST(MeasuredMargins, withholdsWhatWasNotMeasured) {
    const MeasuredMargins low = measuredMargins(measured(20, 0.0, 0.1, 0.4), {});
    EXPECT_EQ(low.phase_deg.withheld, Withheld::NoCrossing);
    EXPECT_EQ(low.gain_dB.withheld, Withheld::NoCrossing);
    // Without the points from 0.5 to 2.5 rad/s, where both crossings lie, neighbours are not joined.
    MeasuredLoop gap = measured(60, 0.0);
    MeasuredLoop thinned;
    for (std::size_t i = 0; i < gap.radius.size(); ++i) {
        const double w = gap.response.frequency_rad_s[i];
        if (w < 0.5 || w > 2.5) {
            thinned.response.frequency_rad_s.push_back(w);
            thinned.response.value.push_back(gap.response.value[i]);
            thinned.radius.push_back(0.0);
        }
    }
    const MeasuredMargins margins = measuredMargins(thinned, {});
    EXPECT_EQ(margins.phase_deg.withheld, Withheld::Gap);
    EXPECT_EQ(margins.gain_dB.withheld, Withheld::Gap);
    EXPECT_EQ(measuredMargins({}, {}).phase_deg.withheld, Withheld::NoCrossing);
}

} // namespace
} // namespace halbench::control
