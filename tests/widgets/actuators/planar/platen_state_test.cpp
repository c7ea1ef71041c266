#include "control/base/units.h"
#include "models/fields/magnet_matrix.h"
#include "models/planar/hall_chip.h"
#include "widgets/actuators/planar/platen_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

namespace halbench::widgets {
namespace {

using models::CoilCurrents_A;
using models::PlanarPose;

/// A device that plays these roles.
struct Device {
    std::map<std::string, double> signals;
    std::map<std::string, double> parameters;

    ActuatorValues values() const {
        const auto find = [](const std::map<std::string, double>& table) {
            return [&table](const std::string& role) -> std::optional<double> {
                const auto found = table.find(role);
                return found == table.end() ? std::nullopt : std::optional(found->second);
            };
        };
        return {find(signals), find(parameters)};
    }
    void pose(const std::string& role, const PlanarPose& pose) {
        signals[role + ".x"] = pose.x_m;
        signals[role + ".y"] = pose.y_m;
        signals[role + ".phi"] = pose.angle_rad;
    }
};

// resources/help/planar-theory.md section 5.5: the published rows at (2, -3 mm, 0), printed to 7 decimals.
TEST(PlatenState, forcesOfTheSetsAreThoseOfThePublishedModel) {
    const PlatenSettings settings = platenSettings(Device().values());
    CoilCurrents_A current_A;
    current_A << 0.3, -0.2, 0.5, 0.1, -0.4, 0.25;
    const PlatenForces forces = platenForces(settings, {2e-3, -3e-3, 0.0}, current_A);
    const double y12_N = 2.8432530 * 0.3 + 1.2295505 * 0.2;
    const double y34_N = -1.2295505 * 0.5 + 2.8432530 * 0.1;
    const double x56_N = 2.6089033 * 0.4 + 1.6701813 * 0.25;
    EXPECT_NEAR(forces.sets[0].force_N.y(), y12_N, 1e-6);
    EXPECT_NEAR(forces.sets[1].force_N.y(), y34_N, 1e-6);
    EXPECT_NEAR(forces.sets[2].force_N.x(), x56_N, 1e-6);
    EXPECT_NEAR(forces.sum.force_N.x(), x56_N, 1e-6);
    EXPECT_NEAR(forces.sum.force_N.y(), y12_N + y34_N, 1e-6);
    const double torque_Nm = -0.1083279 * 0.3 - 0.0468459 * 0.2 - 0.0468459 * 0.5 + 0.1083279 * 0.1 -
                             0.1158353 * 0.4 - 0.0741561 * 0.25;
    EXPECT_NEAR(forces.torque_Nm, torque_Nm, 1e-6);
    // The sets act in the middle of their coils: 1-2 at x' = -3L/4, y' = -(6.4 + 44.5)/2 mm.
    EXPECT_NEAR(forces.sets[0].place_m.x(), 2e-3 - 38.1e-3, 1e-9);
    EXPECT_NEAR(forces.sets[0].place_m.y(), -3e-3 - 25.45e-3, 1e-9);
}

TEST(PlatenState, aPlatenThatIsTurnedCarriesItsChipsAlong) {
    const Eigen::Vector2d place_m = inLattice_m({1e-3, 2e-3, Pi / 2.0}, {10e-3, 0.0});
    EXPECT_NEAR(place_m.x(), 1e-3, 1e-12); // a quarter turn counter-clockwise: x' becomes y
    EXPECT_NEAR(place_m.y(), 12e-3, 1e-12);
}

// A reading that is as the chips' errors make it has no residual; what is added to it is all of the residual.
TEST(PlatenState, residualIsWhatPoseAndCalibrationDoNotExplain) {
    Device device;
    device.parameters = {{"chip.gain_x_2", 0.02},
                         {"chip.cross_yx_2", 0.01},
                         {"chip.offset_y_2", 1e-4},
                         {"chip.crosstalk_7", 2e-5},
                         {"chip.amplitude_2", 0.021}};
    const PlatenSettings settings = platenSettings(device.values());
    const PlanarPose pose{7e-3, -4e-3, 5e-3};
    CoilCurrents_A current_A = CoilCurrents_A::Zero();
    current_A(0) = 0.5;
    models::ChipFields_T field_T;
    for (int j = 0; j < 3; ++j) {
        const double amplitude_T = j == 1 ? 0.021 : 0.020;
        field_T.segment<2>(2 * j) = models::chipField_T(
            2.0 * Pi / 50.8e-3, amplitude_T, settings.sensing.place_m[static_cast<std::size_t>(j)], pose);
    }
    const Eigen::Vector2d second_T = field_T.segment<2>(2);
    field_T(2) = 1.02 * second_T.x();
    field_T(3) = second_T.y() + 0.01 * second_T.x() + 1e-4;
    field_T(1) += 2e-5 * 0.5; // row 2 of the crosstalk, coil 1
    EXPECT_LT(fieldResidual_T(settings, pose, field_T, current_A).norm(), 1e-15); // rounding
    field_T(4) += 30e-6;
    const models::ChipFields_T residual_T = fieldResidual_T(settings, pose, field_T, current_A);
    EXPECT_NEAR(residual_T(4), 30e-6, 1e-15);
    EXPECT_NEAR(residual_T.norm(), 30e-6, 1e-15);
}

TEST(PlatenState, cellsAreCentredOnTheMaximaOfTheField) {
    EXPECT_EQ(pitchCell({0.0, 0.0, 0.0}, 50.8e-3), (std::array<int, 2>{0, 0}));
    EXPECT_EQ(pitchCell({25.0e-3, -26.0e-3, 0.0}, 50.8e-3), (std::array<int, 2>{0, -1}));
    EXPECT_EQ(pitchCell({77.0e-3, 51.0e-3, 0.0}, 50.8e-3), (std::array<int, 2>{2, 1}));
}

TEST(PlatenState, reachIsTheWayToBothEdgesOfTheWindow) {
    const PlatenReach left = reachLeft({50e-3, 40e-3, 30e-3}, {1e-3, 2e-3, 1e-3}, {11e-3, -3e-3, 4e-3});
    EXPECT_TRUE(left.down.isApprox(Eigen::Vector3d(60e-3, 35e-3, 33e-3), 1e-12));
    EXPECT_TRUE(left.up.isApprox(Eigen::Vector3d(40e-3, 45e-3, 27e-3), 1e-12));
}

// The field above the blocks decides: B_z has the sign of the magnetisation, and the flux that leaves a pole
// above returns below, against B_x and B_y.
TEST(PlatenState, blocksPointAsTheirFieldDemands) {
    const models::MagnetMatrix matrix;
    for (int column = -5; column <= 5; ++column) {
        for (int row = -5; row <= 5; ++row) {
            const Eigen::Vector3d block = blockDirection(column, row);
            const Eigen::Vector3d above_T = models::matrixField_T(
                matrix, {0.25 * matrix.pitch_m * column, 0.25 * matrix.pitch_m * row, 5e-3}, 1);
            const Eigen::Vector3d expected =
                Eigen::Vector3d(-above_T.x(), -above_T.y(), above_T.z()); // of one length at first order
            if (expected.norm() < 1e-9) {
                EXPECT_TRUE(block.isZero()) << column << ' ' << row; // both arrays cancel
            } else {
                EXPECT_TRUE(block.isApprox(expected.normalized(), 1e-9)) << column << ' ' << row;
            }
        }
    }
}

TEST(PlatenState, referenceIsShownOnlyWhileThePositionIsControlled) {
    Device device;
    device.pose("position", {1e-3, 2e-3, 0.0});
    device.pose("reference", {1.1e-3, 2e-3, 0.0});
    device.signals["status"] = 1.0;
    device.parameters["hb.mode"] = 3.0; // mode wrench: the reference is a force
    EXPECT_FALSE(platenReadings(device.values(), platenSettings(device.values())).reference);
    device.parameters["hb.mode"] = 2.0;
    EXPECT_TRUE(platenReadings(device.values(), platenSettings(device.values())).reference);
    device.signals["status"] = 0.0; // not armed: the board sends zero
    EXPECT_FALSE(platenReadings(device.values(), platenSettings(device.values())).reference);
}

TEST(PlatenState, chipsThatTheBoardLeavesOutAreMarked) {
    Device device;
    device.signals["chips_left_out"] = 5.0; // 1 + 4: the first and the third
    const PlatenReadings readings = platenReadings(device.values(), PlatenSettings());
    EXPECT_EQ(readings.used, (models::ChipMask{false, true, false}));
    EXPECT_FALSE(readings.pose); // and what is not sent is not known
    EXPECT_FALSE(readings.current_A);
    EXPECT_FALSE(readings.field_T);
}

} // namespace
} // namespace halbench::widgets
