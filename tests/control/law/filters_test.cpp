#include "control/base/units.h"
#include "control/law/filters.h"
#include "control/lti/discretize.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

TEST(Filters, leadGivesItsPhaseAtItsFrequencyAndNowhereMore) {
    for (const double phase : {-30.0, 20.0, 60.0}) {
        const auto lead = leadFilter(25.0, phase);
        ASSERT_TRUE(lead.has_value());
        EXPECT_NEAR(std::abs(lead->atFrequency(25.0)), 1.0, 1e-14);
        EXPECT_NEAR(radiansToDegrees(std::arg(lead->atFrequency(25.0))), phase, 1e-12);
        for (const double w : {24.0, 26.0}) {
            EXPECT_LT(std::abs(radiansToDegrees(std::arg(lead->atFrequency(w)))), std::abs(phase));
        }
        const double r =
            (1.0 + std::sin(degreesToRadians(phase))) / (1.0 - std::sin(degreesToRadians(phase)));
        EXPECT_NEAR(lead->dcGain(), 1.0 / std::sqrt(r), 1e-14);
    }
}

TEST(Filters, lagRaisesTheGainAtRestOnly) {
    const auto lag = lagFilter(2.0, 10.0);
    ASSERT_TRUE(lag.has_value());
    EXPECT_NEAR(lag->dcGain(), 10.0, 1e-13);
    EXPECT_NEAR(std::abs(lag->atFrequency(2e6)), 1.0, 1e-9);
    // A decade above: atan(10) - atan(100).
    EXPECT_NEAR(std::arg(lag->atFrequency(20.0)), std::atan(10.0) - std::atan(100.0), 1e-13);
}

TEST(Filters, notchTakesItsDepthOutAndLeavesTheRest) {
    const auto notch = notchFilter(300.0, 0.05, 0.2);
    ASSERT_TRUE(notch.has_value());
    EXPECT_NEAR(std::abs(notch->atFrequency(300.0)), 0.05, 1e-14);
    EXPECT_NEAR(notch->dcGain(), 1.0, 1e-15);
    EXPECT_NEAR(std::abs(notch->atFrequency(3e7)), 1.0, 1e-9);
    const auto sampled = discretize(*notch, 1e-3, Hold::Tustin{300.0});
    EXPECT_NEAR(std::abs(sampled->atFrequency(300.0)), 0.05, 1e-11);
    EXPECT_EQ(std::abs(notchFilter(300.0, 0.0, 0.2)->atFrequency(300.0)), 0.0);
}

TEST(Filters, lowPassIsAtMinusThreeDecibelsAtItsCorner) {
    for (const int order : {1, 2}) {
        const auto filter = lowPassFilter(50.0, order);
        ASSERT_TRUE(filter.has_value());
        EXPECT_NEAR(std::abs(filter->atFrequency(50.0)), std::sqrt(0.5), 1e-14);
        EXPECT_NEAR(filter->dcGain(), 1.0, 1e-15);
        EXPECT_NEAR(std::abs(filter->atFrequency(5e4)) * std::pow(1e3, order), 1.0, 1e-5); // 1e-6: w^2
    }
}

TEST(Filters, refuseWhatIsNotPossible) {
    EXPECT_EQ(leadFilter(10.0, 90.0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(leadFilter(std::nan(""), 30.0).error().code, ErrorCode::NotFinite);
    EXPECT_EQ(lagFilter(10.0, 1.0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(notchFilter(-1.0, 0.1, 0.1).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(lowPassFilter(10.0, 3).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
