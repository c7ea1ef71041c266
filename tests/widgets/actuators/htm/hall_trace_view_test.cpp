#include "control/base/units.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/actuators/htm/hall_trace_view.h"
#include "widgets/actuators/htm/rotor_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::widgets {
namespace {

class HallTraceViewTest : public GuiTest {
protected:
    void turn(double from_deg, double to_deg, double amplitude_T) {
        for (double angle_deg = from_deg + 1.0; angle_deg < to_deg; angle_deg += 2.0) {
            const double angle_rad = degreesToRadians(angle_deg);
            view.add(angle_rad, amplitude_T * std::cos(angle_rad), amplitude_T * std::sin(angle_rad));
        }
    }

    HallTraceView view;
};

TEST_F(HallTraceViewTest, keepsOneReadingForEachAngleHoweverManyTurns) {
    turn(0.0, 180.0, 0.157);
    EXPECT_EQ(view.angles(), 90);
    turn(-720.0, 360.0, 0.157);
    EXPECT_EQ(view.angles(), 180);
    view.clear();
    EXPECT_EQ(view.angles(), 0);
}

TEST_F(HallTraceViewTest, theScaleHoldsAllReadings) {
    EXPECT_DOUBLE_EQ(view.fullScale_T(), 0.2);
    turn(0.0, 360.0, 0.157);
    EXPECT_DOUBLE_EQ(view.fullScale_T(), 0.2);
    turn(0.0, 10.0, 0.21);
    EXPECT_DOUBLE_EQ(view.fullScale_T(), 0.25);
    turn(0.0, 10.0, 3.0);
    EXPECT_NEAR(view.fullScale_T(), 3.2, 1e-9); // circles of 0.4 T
    EXPECT_FALSE(view.grab().isNull());
}

TEST_F(HallTraceViewTest, leavesOutReadingsThatAreNotFinite) {
    view.add(std::numeric_limits<double>::quiet_NaN(), 0.1, 0.1);
    view.add(0.0, std::numeric_limits<double>::infinity(), 0.1);
    EXPECT_EQ(view.angles(), 0);
}

TEST_F(HallTraceViewTest, standsBesideTheCrossSectionWhereThePictureIsWide) {
    RotorPicture picture;
    picture.resize(1200, 600);
    picture.show();
    const auto* trace = picture.findChild<HallTraceView*>();
    EXPECT_TRUE(trace->isVisible());
    picture.resize(700, 600);
    EXPECT_FALSE(trace->isVisible());
}

} // namespace
} // namespace halbench::widgets
