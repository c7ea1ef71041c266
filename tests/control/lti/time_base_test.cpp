#include "control/lti/time_base.h"

#include <gtest/gtest.h>

#include <limits>

namespace halbench::control {
namespace {

TEST(TimeBase, aPeriodMakesItSampledAndNothingElseDoes) {
    EXPECT_TRUE(TimeBase::continuous().isContinuous());
    EXPECT_TRUE(TimeBase::sampled(0.01).isSampled());
    EXPECT_EQ(TimeBase::sampled(0.01).period_s(), 0.01);
    EXPECT_FALSE(TimeBase::sampled(0.01) == TimeBase::continuous());
}

TEST(TimeBase, refusesPeriodsThatAreNone) {
    EXPECT_EQ(TimeBase::sampledChecked(0.0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(TimeBase::sampledChecked(-0.01).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(TimeBase::sampledChecked(std::numeric_limits<double>::infinity()).error().code,
              ErrorCode::NotFinite);
    EXPECT_EQ(TimeBase::sampledChecked(0.01)->period_s(), 0.01);
}

TEST(TimeBase, mixingNamesBothSides) {
    const auto mixed = commonTimeBase(TimeBase::continuous(), TimeBase::sampled(0.01));
    ASSERT_FALSE(mixed.has_value());
    EXPECT_NE(mixed.error().message.find("continuous"), std::string::npos);
    EXPECT_NE(mixed.error().message.find("0.01"), std::string::npos);
    EXPECT_TRUE(commonTimeBase(TimeBase::sampled(0.01), TimeBase::sampled(0.01)).has_value());
}

} // namespace
} // namespace halbench::control
