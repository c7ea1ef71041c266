#include "app/actuators/planar/platen_board.h"
#include "app/actuators/planar/platen_legs.h"
#include "tests/app/actuators/planar/simulated_platen.h"

#include <cmath>

namespace halbench::app {
namespace {

constexpr double Pitch_m = 50.8e-3;

PlatenRoom publishedRoom() {
    const auto room = roomWithin({6.35e-3, -6.35e-3, 0.0}, {-38.65e-3, -40e-3}, {40e-3, 38.65e-3}, Pitch_m);
    EXPECT_TRUE(room) << room.error().message;
    return *room;
}

// How much the outer chips and the third one show of the rotation: cosines of section 7 of the help page.
double worstSight(double x_m, double y_m) {
    const double gamma = 2.0 * std::acos(-1.0) / Pitch_m;
    const double outer = std::fabs(std::cos(gamma * (y_m - 19.05e-3)));
    const double third = std::fabs(std::sin(2.0 * gamma * x_m)); // both of its slopes against those of x
    return std::max(outer, third);
}

class Legs : public testing::TestWithParam<bool> {};

TEST_P(Legs, stayInTheRoomAndWhereTheChipsShowTheRotation) {
    const PlatenRoom room = publishedRoom();
    const auto legs = GetParam() ? identificationLegs(room) : calibrationLegs(room);
    std::array<double, 3> place = {room.start.x_m, room.start.y_m, room.start.angle_rad};
    constexpr double Beside_m = 4e-3;
    for (const MotionLeg& leg : legs) {
        const std::array<double, 3> from = place;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const AxisWave& wave = leg.waves[axis];
            place[axis] += wave.distance;
            if (wave.shape == AxisWave::Shape::Chirp) {
                // Of a chirp the mean frequency times its duration are its cycles.
                const double cycles = 0.5 * (wave.from_Hz + wave.to_Hz) * (leg.duration_s - 0.03);
                EXPECT_NEAR(cycles, std::round(cycles), 1e-9);
                EXPECT_GT(cycles, 0.5);
            }
        }
        for (int step = 0; step <= 20; ++step) {
            const double s = step / 20.0;
            const double x = from[0] + s * (place[0] - from[0]);
            const double y = from[1] + s * (place[1] - from[1]);
            EXPECT_LE(std::fabs(x), 40e-3);
            EXPECT_LE(std::fabs(y), 40e-3 + Beside_m);
            // 4 mm beside a line of y leave cos(gamma 4 mm) = 0.88.
            EXPECT_GT(worstSight(x, y), 0.85) << leg.text << " " << x << " " << y;
        }
        EXPECT_LE(std::fabs(place[2]), 10e-3);
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        EXPECT_GE(room.high(axis) - room.low(axis), 0.999 * Pitch_m);
    }
    // Back where it stood: the next procedure finds the same room.
    EXPECT_NEAR(place[0], room.start.x_m, 1e-12);
    EXPECT_NEAR(place[1], room.start.y_m, 1e-12);
    EXPECT_NEAR(place[2], room.start.angle_rad, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Planned, Legs, testing::Bool(),
                         [](const auto& each) { return each.param ? "identification" : "calibration"; });

TEST(PlatenRoom, hasTheLinesOfTheLatticeAndRefusesLessThanAPitch) {
    const PlatenRoom room = publishedRoom();
    EXPECT_NEAR(room.low(0), -31.75e-3, 1e-9);
    EXPECT_NEAR(room.high(0), 31.75e-3, 1e-9);
    EXPECT_NEAR(room.low(1), -31.75e-3, 1e-9);
    EXPECT_NEAR(room.high(1), 19.05e-3, 1e-9);
    EXPECT_EQ(room.lines[0].size(), 6U);
    EXPECT_EQ(room.lines[1].size(), 3U);
    const auto small = roomWithin({}, {-20e-3, -40e-3}, {20e-3, 40e-3}, Pitch_m);
    ASSERT_FALSE(small);
    EXPECT_EQ(small.error().code, ErrorCode::Refused);
}

TEST(PlatenBoardValues, areThoseOfTheDevice) {
    const auto device = openPlaten("");
    ASSERT_NE(device, nullptr);
    const ParameterValue changes[] = {
        {"chip.gain_y_2", 0.03}, {"chip.crosstalk_8", 2e-4}, {"platen.centre_y", 1e-3}};
    ASSERT_TRUE(device->writeParameters(changes));
    const auto board = readBoard(*device);
    ASSERT_TRUE(board);
    // Single precision of the board.
    EXPECT_NEAR(board->chips.gain[1].y(), 0.03, 1e-8);
    EXPECT_NEAR(board->chips.crosstalk_T_per_A(1, 1), 2e-4, 1e-10); // row after row, six coils each
    EXPECT_NEAR(board->centreY_m, 1e-3, 1e-9);
    EXPECT_NEAR(board->forceConstant_N_per_A, -3.09772, 1e-6);
    EXPECT_NEAR(board->waveNumber_per_m(), 123.68475, 1e-4);
}

} // namespace
} // namespace halbench::app
