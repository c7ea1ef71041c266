#include "app/procedures/excite/travel_ends.h"
#include "app/procedures/excite/travel_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace halbench::app {
namespace {

MoveReference referenceOf(const std::string& text) {
    const auto reference = parseMoveReference(text);
    EXPECT_TRUE(reference) << text;
    return reference.value_or(MoveReference());
}

// The second route: the point of the reference at many instants. The span holds them all, and for shapes
// whose peaks are exact it is no wider.
TEST(TravelEnds, spanHoldsEveryPointOfTheReference) {
    constexpr double Duration_s = 3.0;
    for (const std::string text :
         {"step,amplitude_mm=-7", "ramp,rate_mm_s=-4", "ramp,rate_mm_s=4,amplitude_mm=5",
          "sine,amplitude_mm=3,frequency_hz=2", "staircase,amplitude_mm=-2,period_s=0.5,count=4",
          "trapezoid,amplitude_mm=9,rate_mm_s=20,acceleration_m_s2=0.5",
          "s-curve,amplitude_mm=-9,rate_mm_s=20,acceleration_m_s2=0.5,jerk_m_s3=20",
          "step,amplitude_mm=2,base_mm_s=-3"}) {
        const MoveReference reference = referenceOf(text);
        const control::PathSpan span = referenceSpan(reference, Duration_s);
        control::PathSpan seen;
        for (int i = 0; i <= 30000; ++i) {
            seen.include(*referenceAt(reference, 1e-4 * i));
        }
        EXPECT_LE(span.least, seen.least + 1e-9) << text;
        EXPECT_GE(span.most, seen.most - 1e-9) << text;
        if (reference.base == 0.0) {
            EXPECT_NEAR(span.least, seen.least, 1e-6) << text;
            EXPECT_NEAR(span.most, seen.most, 1e-6) << text;
        }
    }
}

TEST(TravelEnds, spanOfAPathIsThatOfItsPoints) {
    const std::string limits = ",rate_mm_s=20,acceleration_m_s2=0.5,jerk_m_s3=20";
    for (const std::string text :
         {"circle,radius_mm=2", "circle,radius_mm=-2", "raster,width_mm=-3,lines=4,pitch_um=-300",
          "arc,radius_mm=2,angle_deg=-110,heading_deg=20", "arc,radius_mm=4,angle_deg=250,heading_deg=-75",
          "line,length_mm=4,heading_deg=-130"}) {
        const MoveReference reference = referenceOf(text + limits);
        const auto path = planePath(reference);
        ASSERT_TRUE(path) << text;
        control::PathSpan seen[2];
        for (double time_s = 0.0; time_s <= path->duration_s(); time_s += 1e-4) {
            const control::PlanePoint point = path->at(time_s);
            seen[0].include(point[0].value);
            seen[1].include(point[1].value);
        }
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const control::PathSpan span = referenceSpan(reference, 1.0, axis);
            EXPECT_NEAR(span.least, seen[axis].least, 2e-8) << text << " axis " << axis;
            EXPECT_NEAR(span.most, seen[axis].most, 2e-8) << text << " axis " << axis;
        }
    }
}

TEST(TravelEnds, farthestPlaceBeyondAnEndIsNamedAndTheWayInwardsIsFree) {
    EXPECT_FALSE(placeBeyondEnd({"x", 0.05, 0.006}, {-0.056, 0.044}));
    EXPECT_NEAR(*placeBeyondEnd({"x", 0.05, 0.006}, {0.0, 0.048}), 0.054, 1e-12);
    EXPECT_NEAR(*placeBeyondEnd({"x", 0.05, 0.0}, {-0.06, 0.051}), -0.06, 1e-12);
    EXPECT_NEAR(*placeBeyondEnd({"x", 0.05, 0.0}, {-0.051, 0.06}), 0.06, 1e-12);
    // An axis that reads a little beyond its stop comes away from it.
    EXPECT_FALSE(placeBeyondEnd({"x", 0.05, 0.0502}, {-0.03, 0.0}));
    EXPECT_TRUE(placeBeyondEnd({"x", 0.05, 0.0502}, {0.0, 0.001}));
    const auto kept = checkReferenceEnds({"phi", 0.02, 0.001}, "rad", {0.0, 0.025});
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(kept.error().message, "axis phi would come to 0.026 rad, its travel ends at 0.02 rad");
}

// A key that names the wrong kind of quantity sends the user the wrong way.
TEST(TravelEnds, missingSizeIsNamedInTheQuantityOfTheOtherKeys) {
    const auto hintOf = [](const char* text) {
        const auto reference = parseMoveReference(text);
        EXPECT_FALSE(reference) << text;
        return reference ? std::string() : reference.error().hint;
    };
    EXPECT_EQ(hintOf("step,base_mm_s=1"), "Add amplitude_mm=... to the reference.");
    EXPECT_EQ(hintOf("step,base_deg_s=1"), "Add amplitude_deg=... to the reference.");
    EXPECT_EQ(hintOf("step"), "Add amplitude_deg=... or amplitude_mm=... to the reference.");
    EXPECT_EQ(hintOf("ramp,amplitude_mm=1"), "Add rate_mm_s=... to the reference.");
}

} // namespace
} // namespace halbench::app
