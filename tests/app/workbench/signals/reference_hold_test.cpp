#include "app/workbench/signals/reference_hold.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

class ReferenceHoldTest : public testing::Test {
protected:
    void sample(double reference_rad, double running) {
        SampleBlock block;
        block.layout = std::make_shared<StreamLayout>(
            StreamLayout{{{"reference", "rad"}, {"reference.running", ""}}, 0.001});
        block.time_s = {m_time_s += 0.001};
        block.values = {reference_rad, running};
        m_history.append(block);
        held.look(m_history, true, 60.0, 0.5); // armed at 60 rad, set-point 0.5 rad
    }

    ReferenceHold held;

private:
    control::SampleHistory m_history{1U << 20U};
    double m_time_s = 0.0;
};

TEST_F(ReferenceHoldTest, isWhatTheBoardAddsAndStaysWhenTheReferenceHasEnded) {
    sample(60.5, 0.0);
    EXPECT_FALSE(held.hasRun());
    sample(60.75, 1.0);
    EXPECT_TRUE(held.isRunning());
    sample(61.0, 0.0);
    EXPECT_FALSE(held.isRunning());
    EXPECT_TRUE(held.hasRun());
    EXPECT_DOUBLE_EQ(held.angle_rad(), 0.5);
    sample(61.25, 0.0); // the set-point has moved since: the reference has not
    EXPECT_DOUBLE_EQ(held.angle_rad(), 0.5);
    held.clear();
    EXPECT_EQ(held.angle_rad(), 0.0);
    EXPECT_FALSE(held.hasRun());
}

TEST_F(ReferenceHoldTest, aStartCountsAsRunningForHalfASecondUntilItIsSeen) {
    held.begin();
    EXPECT_TRUE(held.isRunning());
    for (int frame = 0; frame < 15; ++frame) { // of 33 ms
        EXPECT_TRUE(held.isRunning());
        sample(60.5, 0.0);
    }
    EXPECT_FALSE(held.isRunning());
}

TEST(ContinuesReference, isKnownOfTheLibraryFromItsVersion) {
    EXPECT_TRUE(continuesReference("0.2.0-0x95BBD6FF"));
    EXPECT_TRUE(continuesReference("1.0.3-0x95BBD6FF full"));
    EXPECT_FALSE(continuesReference("0.1.0-0x95BBD6FF"));
    EXPECT_FALSE(continuesReference("Aug 12 2026"));
    EXPECT_FALSE(continuesReference(""));
}

} // namespace
} // namespace halbench::app
