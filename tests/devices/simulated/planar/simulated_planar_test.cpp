#include "devices/simulated/planar/simulated_planar.h"
#include "models/planar/windings_wrench.h"
#include "tests/devices/simulated/planar/positioner.h"

#include <gtest/gtest.h>

#include <cmath>

// Plant, firmware and link of the positioner together; figures of resources/help/planar-theory.md.

namespace halbench::devices {
namespace {

double rms(const std::vector<double>& values, double mean) {
    double sum = 0.0;
    for (const double value : values) {
        sum += (value - mean) * (value - mean);
    }
    return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(Planar, describesItselfAndShowsEveryTick) {
    Positioner planar("seed=3");
    for (const char* name : {"position.x", "position.y", "position.phi", "speed.x", "hall.x1", "hall.y3",
                             "current.coil6", "coil_temperature.coil1", "truth.position.phi"}) {
        EXPECT_NE(planar.device().catalogue().findSignal(name), nullptr) << name;
    }
    EXPECT_EQ(planar.device().catalogue().findSignal("position.x")->unit, "m");
    EXPECT_EQ(planar.device().catalogue().findSignal("effort.phi")->unit, "N*m");
    EXPECT_NEAR(static_cast<double>(planar.samples("position.x", 0.5).size()), 500.0, 1.0);
}

TEST(Planar, knowsItsPoseAtPowerOn) {
    Positioner planar("imperfections=off");
    EXPECT_EQ(planar.device().clock().now_s(), 0.0);
    // Half a step of the converter, 0.15 um at the largest slope and more at others: 1 um and 20 urad.
    EXPECT_NEAR(planar.signal("position.x"), 6.35e-3, 1e-6);
    EXPECT_NEAR(planar.signal("position.y"), -6.35e-3, 1e-6);
    EXPECT_NEAR(planar.signal("position.phi"), 0.0, 20e-6);
    EXPECT_EQ(planar.signal("chips_left_out"), 0.0);
    EXPECT_NEAR(planar.signal("coil_temperature.coil4"), 25.0, 0.1);
}

TEST(Planar, measuresWithTheNoiseOfItsChips) {
    // Cramer-Rao bound at the start pose: 5.99 um, 5.15 um, 73.3 urad. 2000 samples spread by 1.6 %, three
    // times that; the converter adds 0.3 % in squares.
    Positioner planar("imperfections=off&hall_noise_uT=18");
    const std::vector<double> x_m = planar.samples("position.x", 2.0);
    EXPECT_NEAR(rms(x_m, 6.35e-3), 5.99e-6, 0.3e-6);
    const std::vector<double> y_m = planar.samples("position.y", 2.0);
    EXPECT_NEAR(rms(y_m, -6.35e-3), 5.15e-6, 0.26e-6);
    const std::vector<double> phi_rad = planar.samples("position.phi", 2.0);
    EXPECT_NEAR(rms(phi_rad, 0.0), 73.3e-6, 3.7e-6);
}

TEST(Planar, drivesTheCoilsThatAreAskedFor) {
    Positioner planar("chain=ideal");
    planar.arm(HB_PLANAR_CURRENTS);
    planar.set("hb.current_5", 0.1);
    planar.set("hb.current_1", -0.2);
    planar.wait(0.005);
    const models::WindingsWrench windings{models::PlanarGeometry{}};
    models::CoilCurrents_A current_A = models::CoilCurrents_A::Zero();
    current_A(4) = 0.1;
    current_A(0) = -0.2;
    const models::PlanarWrench expected =
        models::wrenchOf(windings.at(planar.truth().platen.pose).wrench * current_A);
    // It moves by less than 1 um in a sub-step, which changes the force by 1e-4 of it.
    EXPECT_NEAR(planar.truth().wrench.forceX_N, expected.forceX_N, 1e-4);
    EXPECT_NEAR(planar.truth().wrench.forceY_N, expected.forceY_N, 1e-4);
    EXPECT_NEAR(planar.truth().wrench.torque_Nm, expected.torque_Nm, 1e-5);
    EXPECT_FALSE(planar.canSet("hb.current_3", 1.01)); // beyond the limit of 1 A
    EXPECT_NEAR(planar.signal("current.coil5"), 0.1, 1e-6);
    planar.device().stop();
    planar.board().advanceTo(planar.board().time_s() + 0.4);
    EXPECT_EQ(planar.firmware().signals.current_A[4], 0.0F);
}

TEST(Planar, turnsADemandedWrenchIntoThatWrench) {
    // Section 5.4, windings at small headings: at most 12.9 mN per newton along x, 9.7 along y and 0.95 mN m.
    Positioner planar("chain=ideal");
    planar.set("coil.force_constant", WindingsForce_N_per_A);
    planar.arm(HB_PLANAR_WRENCH);
    planar.set("hb.setpoint.x", 0.2);
    planar.wait(0.01);
    EXPECT_NEAR(planar.truth().wrench.forceX_N, 0.2, 0.2 * 12.9e-3);
    EXPECT_NEAR(planar.truth().wrench.forceY_N, 0.0, 0.2 * 4.2e-3);
    EXPECT_NEAR(planar.truth().wrench.torque_Nm, 0.0, 0.2 * 1.13e-3);
    EXPECT_NEAR(planar.signal("effort.x"), 0.2, 1e-5); // by the board's own model, which moves on by a tick
    planar.set("hb.setpoint.x", 20.0);                 // more than the coils can do
    planar.wait(0.005);
    EXPECT_LT(planar.signal("current_scale"), 0.5);
    EXPECT_LE(std::fabs(planar.signal("current.coil5")), 1.0001);
}

TEST(Planar, allocatesWithTheHeadingWhenAskedTo) {
    // At 10 mrad with 1 N along x the published model errs by up to 14.1 mN, all harmonics by nothing.
    Positioner planar("chain=ideal&phi0_mrad=10");
    planar.set("coil.force_constant", WindingsForce_N_per_A);
    planar.set("coil.allocation", HB_ALLOCATION_FULL);
    planar.arm(HB_PLANAR_WRENCH);
    planar.set("hb.setpoint.x", 0.3);
    planar.wait(0.01);
    // The pose moves on by 5 um between the computation and the middle of the tick: 0.6 mrad of phase, of
    // which the torque's arm of 44 mm makes nothing and the quadrature 0.2 mN.
    EXPECT_NEAR(planar.truth().wrench.forceX_N, 0.3, 0.4e-3);
    EXPECT_NEAR(planar.truth().wrench.forceY_N, 0.0, 0.4e-3);
    EXPECT_NEAR(planar.truth().wrench.torque_Nm, 0.0, 0.02e-3);
}

TEST(Planar, countsPitchesAndHomes) {
    // The start cell is cell 0, whatever cell that is: 40 mm are shown as -10.8 mm.
    Positioner planar("imperfections=off&x0_mm=40");
    EXPECT_NEAR(planar.signal("position.x"), 40e-3 - 50.8e-3, 1e-6);
    planar.arm(HB_PLANAR_POSITION);
    for (const auto& [name, value] : {std::pair{"reference.x.shape", 2.0},
                                      {"reference.x.rate", -0.1},
                                      {"reference.x.amplitude", 0.045},
                                      {"reference.x.duration", 10.0}}) {
        planar.set(name, value);
    }
    planar.set("reference.start", 1.0);
    planar.wait(2.0);
    EXPECT_NEAR(planar.signal("position.x"), planar.truth().platen.pose.x_m - 50.8e-3, 1e-6);
    EXPECT_NEAR(planar.signal("position.x"), -10.8e-3 - 45e-3, 20e-6);
    EXPECT_EQ(planar.signal("cell.x"), -1.0);
    EXPECT_FALSE(planar.canSet("hb.home", 1.0)); // while it drives
    ASSERT_TRUE(planar.device().disarm());
    planar.wait(0.4);
    planar.set("hb.home", 1.0);
    planar.wait(0.002);
    EXPECT_EQ(planar.signal("cell.x"), 0.0);
    EXPECT_EQ(planar.signal("homed"), 1.0);
    EXPECT_NEAR(planar.signal("position.x"), planar.truth().platen.pose.x_m, 1e-6);
}

/// A line on which each packet takes a tick, as on a real one.
class TickingLine : public LoopbackTransport {
public:
    explicit TickingLine(std::shared_ptr<SimulatedBoard> board)
        : LoopbackTransport(board, false), m_board(std::move(board)) {}
    Result<void> send(std::span<const std::uint8_t> packet) override {
        m_board->tick();
        return LoopbackTransport::send(packet);
    }

private:
    std::shared_ptr<SimulatedBoard> m_board;
};

TEST(Planar, homesAlsoWhenTheBoardHasDoneItBeforeTheValueIsReadBack) {
    auto made = makeSimulatedBoard(*parseDeviceUri("sim:planar"), {});
    ASSERT_TRUE(made) << made.error().message;
    std::shared_ptr<SimulatedBoard> board = std::move(*made);
    auto device = openXcpDevice(std::make_unique<TickingLine>(board), {});
    ASSERT_TRUE(device) << device.error().message;
    const ParameterValue home[] = {{"hb.home", 1.0}};
    const auto written = (*device)->writeParameters(home);
    EXPECT_TRUE(written) << written.error().message;
    board->tick();
    EXPECT_EQ(planarFirmware(*board).signals.homed, 1);
}

// The stops stand 50 mm and 20 mrad from the middle: 100 mm and 40 mrad from one to the other.
TEST(Planar, refusesAWindowWiderThanItsTravel) {
    Positioner planar("imperfections=off");
    EXPECT_TRUE(planar.canSet("window.x", 0.0999));
    EXPECT_FALSE(planar.canSet("window.x", 0.1001));
    EXPECT_FALSE(planar.canSet("window.y", 1.0));
    EXPECT_TRUE(planar.canSet("window.phi", 0.0399));
    EXPECT_FALSE(planar.canSet("window.phi", 0.0401));
}

TEST(Planar, refusesOverridesThatMakeNoMachine) {
    EXPECT_EQ(makeSimulatedBoard(*parseDeviceUri("sim:planar?mass=1"), {}).error().code,
              ErrorCode::UnknownName);
    EXPECT_EQ(makeSimulatedBoard(*parseDeviceUri("sim:planar?m=-1"), {}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(makeSimulatedBoard(*parseDeviceUri("sim:planar?chain=perfect"), {}).error().code,
              ErrorCode::InvalidInput);
}

} // namespace
} // namespace halbench::devices
