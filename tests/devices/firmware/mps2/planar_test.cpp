#include "tests/devices/firmware/mps2/planar_motion.h"

#include <gtest/gtest.h>

namespace halbench::mps2 {
namespace {

// What single precision leaves: the pose is of 0.03 m (rounded to 2e-9), found from fields of 20 mT (1e-9)
// with slopes of 2.5 T/m and arms of 64 mm; sine and cosine of the two builds differ by a rounding.
constexpr double Pose_m = 2e-8;
constexpr double Pose_rad = 1e-7;
// The speed is the pose's difference over a millisecond through a filter of 2 ms, the current that speed
// times 40 N s/m over 3.1 N/A.
constexpr double Speed_m_s = 2e-5;
constexpr double Current_A = 2e-4;

class Mps2Planar : public testing::Test {
protected:
    static Bench emulated(std::shared_ptr<Readings> readings) {
        return emulatedBench("planar", platenPlant(chipFailsInMotion(), std::move(readings)), PlanarLine);
    }
};

TEST_F(Mps2Planar, itsPoseFaultAndPageSwitchAreThoseOfTheHostBuildInEachTick) {
    const auto readings = std::make_shared<Readings>();
    Bench emulatedBoard = emulated(readings);
    ASSERT_TRUE(emulatedBoard.device);
    const Motion board = moved(emulatedBoard, 0);
    Bench hostBoard = planarHostBench(readings);
    ASSERT_TRUE(hostBoard.device);
    const Motion host = moved(hostBoard, 0);

    ASSERT_GT(board.recording.rows(), 400U);
    ASSERT_EQ(board.recording.rows(), host.recording.rows());
    EXPECT_EQ(board.recording.time_s, host.recording.time_s);
    for (const char* name : {"position.x", "position.y", "reference.x"}) {
        EXPECT_LT(largestDifference(board.recording, host.recording, name), Pose_m) << name;
    }
    EXPECT_LT(largestDifference(board.recording, host.recording, "position.phi"), Pose_rad);
    EXPECT_LT(largestDifference(board.recording, host.recording, "speed.x"), Speed_m_s);
    for (const char* name : {"current.coil1", "current.coil4", "current.coil5", "current.coil6"}) {
        EXPECT_LT(largestDifference(board.recording, host.recording, name), Current_A) << name;
    }
    for (const char* name : {"status", "fault", "chips_left_out", "cell.x", "torn_count"}) {
        EXPECT_EQ(board.recording.column(name), host.recording.column(name)) << name;
    }
    EXPECT_EQ(board.parameters, host.parameters);
    EXPECT_EQ(board.ending, host.ending);

    // It moved, and a dead chip ended that.
    EXPECT_NEAR(board.recording.column("position.x").back() - board.recording.column("position.x").front(),
                Travel_m, 1e-3);
    EXPECT_EQ(board.recording.column("fault").back(), static_cast<double>(HB_FAULT_SENSOR_RANGE));
    EXPECT_EQ(board.recording.column("current.coil5").back(), 0.0);
    EXPECT_EQ(board.recording.column("torn_count").back(), 0.0);

    // A switch one tick later is another run.
    Bench lateBoard = planarHostBench(readings);
    ASSERT_TRUE(lateBoard.device);
    const Motion late = moved(lateBoard, 1);
    ASSERT_EQ(late.switchRow, board.switchRow + 1);
    double difference_A = 0.0;
    for (const char* name : {"current.coil5", "current.coil6"}) {
        difference_A = std::max(difference_A, largestDifference(board.recording, late.recording, name));
    }
    EXPECT_GT(difference_A, 10.0 * Current_A);
}

} // namespace
} // namespace halbench::mps2
