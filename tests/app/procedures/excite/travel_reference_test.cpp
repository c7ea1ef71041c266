#include "app/procedures/excite/move_reference_keys.h"
#include "app/procedures/excite/travel_reference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

TEST(TravelReference, isReadWithItsUnits) {
    const auto travel =
        parseMoveReference("s-curve,amplitude_um=500,rate_mm_s=5,acceleration_mm_s2=20,jerk_m_s3=2");
    ASSERT_TRUE(travel) << travel.error().message;
    EXPECT_EQ(travel->shape, MoveReference::Shape::SCurve);
    EXPECT_DOUBLE_EQ(travel->amplitude, 500e-6);
    EXPECT_DOUBLE_EQ(travel->rate, 5e-3);
    EXPECT_DOUBLE_EQ(travel->acceleration, 20e-3);
    EXPECT_DOUBLE_EQ(travel->jerk.value_or(0.0), 2.0);
    const auto raster =
        parseMoveReference("raster,width_mm=1,lines=3,pitch_um=-50,rate_mm_s=5,acceleration_m_s2=1");
    ASSERT_TRUE(raster) << raster.error().message;
    EXPECT_DOUBLE_EQ(raster->amplitude, 1e-3);
    EXPECT_EQ(raster->count, 3);
    EXPECT_DOUBLE_EQ(raster->pitch, -50e-6);
    EXPECT_FALSE(raster->jerk);
    EXPECT_NEAR(referenceExcursion(*raster, 10.0), 1e-3, 1e-15);
}

TEST(TravelReference, refusesAnAngleThatTheShapeDoesNotHave) {
    const std::string limits = ",rate_mm_s=5,acceleration_m_s2=1";
    for (const char* unused : {"line,length_mm=5,angle_deg=30", "circle,radius_mm=2,heading_deg=45",
                               "circle,radius_mm=2,angle_deg=90", "raster,width_mm=2,heading_rad=1",
                               "step,amplitude_mm=1,angle_deg=5", "arc,radius_mm=-2,angle_deg=90"}) {
        EXPECT_EQ(parseMoveReference(unused + limits).error().code, ErrorCode::InvalidInput) << unused;
    }
    EXPECT_TRUE(parseMoveReference("arc,radius_mm=2,angle_deg=-90,heading_deg=0" + limits));
}

TEST(TravelReference, saysWhichKeyIsMissing) {
    for (const auto& [text, key] :
         {std::pair{"trapezoid,rate_mm_s=5,acceleration_m_s2=1", "amplitude_m"},
          {"trapezoid,amplitude_mm=5,acceleration_m_s2=1", "rate_m_s"},
          {"trapezoid,amplitude_mrad=5,rate_mrad_s=1", "acceleration_rad_s2"},
          {"s-curve,amplitude_mm=5,rate_mm_s=5,acceleration_m_s2=1", "jerk_m_s3"},
          {"circle,rate_mm_s=5,acceleration_m_s2=1", "radius_m"},
          {"raster,width_mm=5,lines=2,rate_mm_s=5,acceleration_m_s2=1", "pitch_m"}}) {
        const auto reference = parseMoveReference(text);
        ASSERT_FALSE(reference) << text;
        EXPECT_EQ(reference.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(reference.error().message.find(key), std::string::npos) << reference.error().message;
    }
    EXPECT_FALSE(parseMoveReference("circle,radius_mm=5,rate_mrad_s=5,acceleration_m_s2=1")); // mixed units
    EXPECT_FALSE(parseMoveReference("trapezoid,amplitude_mm=5,rate_mm_s=-5,acceleration_m_s2=1"));
}

TEST(TravelReference, endsByItself) {
    const auto travel = parseMoveReference("trapezoid,amplitude_mm=50,rate_m_s=0.1,acceleration_m_s2=0.5");
    ASSERT_TRUE(travel);
    EXPECT_NEAR(travelTime_s(*travel).value_or(0.0), 0.5 + 0.2, 1e-12); // d/v + v/a
    EXPECT_NEAR(defaultDuration_s(*travel).value_or(0.0), 1.7, 1e-12);
    EXPECT_NEAR(referenceAt(*travel, 0.35).value_or(0.0), 25e-3, 1e-12); // half the way in half the time
    EXPECT_FALSE(defaultDuration_s(*parseMoveReference("step,amplitude_mm=1")));
    EXPECT_FALSE(idealReference(*travel));
    EXPECT_EQ(referenceAt(*parseMoveReference("rest"), 2.0), 0.0);
}

} // namespace
} // namespace halbench::app
