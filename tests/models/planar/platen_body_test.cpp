#include "models/planar/platen_body.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace halbench::models {
namespace {

using Eigen::Vector2d;

constexpr double Step_s = 0.25e-3;

PlatenConfig freePlaten() {
    PlatenConfig config;
    config.damping_Ns_per_m = 0.0;
    config.damping_Nms_per_rad = 0.0;
    config.cableStiffness_N_per_m = 0.0;
    config.cableTorsion_Nm_per_rad = 0.0;
    return config;
}

void run(const PlatenConfig& config, PlatenState& state, const PlanarWrench& wrench, double time_s,
         double step_s = Step_s) {
    const auto count = static_cast<int>(std::lround(time_s / step_s));
    for (int i = 0; i < count; ++i) {
        stepPlaten(config, state, wrench, Vector2d::Zero(), step_s);
    }
}

TEST(PlatenBody, constantForceGivesTheParabola) {
    PlatenState state;
    run(freePlaten(), state, {0.064, -0.032, 1e-5}, 0.2);
    EXPECT_NEAR(state.pose.x_m, 0.5 * 0.1 * 0.04, 1e-15);
    EXPECT_NEAR(state.pose.y_m, -0.5 * 0.05 * 0.04, 1e-15);
    EXPECT_NEAR(state.pose.angle_rad, 0.5 * 0.01 * 0.04, 1e-15);
    EXPECT_NEAR(state.velocity.x_m_s, 0.02, 1e-15);
}

TEST(PlatenBody, dampedSpeedFallsExponentially) {
    PlatenConfig config = freePlaten();
    config.damping_Ns_per_m = 2.0;
    config.damping_Nms_per_rad = 3e-3;
    PlatenState state;
    state.velocity = {0.05, -0.02, 0.01};
    run(config, state, {}, 0.3);
    EXPECT_NEAR(state.velocity.x_m_s, 0.05 * std::exp(-0.3 * 2.0 / 0.64), 1e-15);
    EXPECT_NEAR(state.velocity.angle_rad_s, 0.01 * std::exp(-0.3 * 3.0), 1e-15);
}

TEST(PlatenBody, forceBesideTheCentreOfMassTurnsAndTheCentreGoesStraight) {
    PlatenConfig config = freePlaten();
    config.massCentre_m = {5e-3, -4e-3};
    PlatenState state;
    run(config, state, {0.0, 0.1, 0.0}, 0.05);
    // Torque about G: -(r x F) = -(5 mm x 0.1 N); the arm turns by 0.6 mrad, which changes it by 0.6 mrad x 4
    // mm, a third of that on average: 1.7e-4.
    EXPECT_NEAR(state.velocity.angle_rad_s, -5e-4 / 1e-3 * 0.05, 5e-6);
    const double c = std::cos(state.pose.angle_rad);
    const double s = std::sin(state.pose.angle_rad);
    EXPECT_NEAR(state.pose.x_m + c * 5e-3 + s * 4e-3, 5e-3, 1e-15);
    EXPECT_NEAR(state.pose.y_m + s * 5e-3 - c * 4e-3, -4e-3 + 0.5 * 0.1 / 0.64 * 0.0025, 1e-15);
}

TEST(PlatenBody, aFreePlatenTurnsAboutItsCentreOfMass) {
    PlatenConfig config = freePlaten();
    config.travel_rad = 10.0;
    config.massCentre_m = {8e-3, 6e-3};
    PlatenState state;
    // C moves so that G rests: v_C = -omega x r.
    state.velocity = {2.0 * 6e-3, -2.0 * 8e-3, 2.0};
    run(config, state, {}, 1.0);
    EXPECT_NEAR(state.pose.angle_rad, 2.0, 1e-12);
    const Vector2d arm_m = Eigen::Rotation2Dd(2.0) * config.massCentre_m;
    EXPECT_NEAR(state.pose.x_m, 8e-3 - arm_m.x(), 1e-13);
    EXPECT_NEAR(state.pose.y_m, 6e-3 - arm_m.y(), 1e-13);
}

TEST(PlatenBody, cableSwingsWithTheFrequencyOfItsSpring) {
    PlatenConfig config = freePlaten();
    config.cableStiffness_N_per_m = 2.0;
    PlatenState state;
    state.pose.x_m = 10e-3;
    const double omega = std::sqrt(2.0 / 0.64);
    run(config, state, {}, 1.3);
    // Drift-kick-drift shortens the period by (omega h)^2/24 = 8e-9 of 2.3 rad: amplitude times that.
    EXPECT_NEAR(state.pose.x_m, 10e-3 * std::cos(omega * 1.3), 1e-9);
    EXPECT_NEAR(state.velocity.x_m_s, -10e-3 * omega * std::sin(omega * 1.3), 1e-9);
}

TEST(PlatenBody, slowForceActsAtTheAnchor) {
    PlatenConfig config = freePlaten();
    config.anchor_m = {0.0, -20e-3};
    PlatenState state;
    stepPlaten(config, state, {}, Vector2d(1e-3, 0.0), Step_s);
    EXPECT_NEAR(state.velocity.angle_rad_s, 20e-6 / 1e-3 * Step_s, 1e-15);
    EXPECT_NEAR(state.velocity.x_m_s, 1e-3 / 0.64 * Step_s, 1e-15);
}

TEST(PlatenBody, energyStaysInSpringsStopsAndMotion) {
    PlatenConfig config;
    config.damping_Ns_per_m = 0.0;
    config.damping_Nms_per_rad = 0.0;
    config.massCentre_m = {0.8e-3, -0.6e-3};
    config.anchor_m = {0.0, -20e-3};
    PlatenState state;
    state.velocity = {0.2, -0.13, 0.1};
    const double before_J = kineticEnergy_J(config, state) + springEnergy_J(config, state);
    double worst_J = 0.0;
    for (int i = 0; i < 8000; ++i) { // 2 s: several bounces at each stop
        stepPlaten(config, state, {}, Vector2d::Zero(), Step_s);
        worst_J = std::fmax(
            worst_J, std::fabs(kineticEnergy_J(config, state) + springEnergy_J(config, state) - before_J));
    }
    // The stops' springs have omega h = 0.05: the scheme's energy swings by (omega h)^2/8 of the kinetic
    // energy in contact and gains or loses omega h/2 of it in the step that meets the stop's edge, here at
    // random.
    EXPECT_LT(worst_J, 0.02 * before_J);
    EXPECT_LT(std::fabs(state.pose.x_m), config.travel_m + 2e-3);
}

TEST(PlatenBody, dampedStopsTakeEnergyAndHoldTheTravel) {
    PlatenConfig config = freePlaten();
    config.stopDamping_Ns_per_m = 2.0 * 0.3 * std::sqrt(config.stopStiffness_N_per_m * config.mass_kg);
    PlatenState state;
    state.pose.x_m = 49e-3;
    state.velocity.x_m_s = 0.5;
    double deepest_m = 0.0;
    for (int i = 0; i < 200; ++i) {
        stepPlaten(config, state, {}, Vector2d::Zero(), Step_s);
        deepest_m = std::fmax(deepest_m, state.pose.x_m - config.travel_m);
    }
    // Undamped depth v sqrt(m/k) = 2.8 mm; restitution of a spring and damper with zeta = 0.3 whose contact
    // ends when the force would pull: exp(-zeta/sqrt(1 - zeta^2) acos-like angle), between 0.35 and 0.65.
    EXPECT_GT(deepest_m, 1e-3);
    EXPECT_LT(deepest_m, 2.8e-3);
    EXPECT_LT(state.velocity.x_m_s, -0.35 * 0.5);
    EXPECT_GT(state.velocity.x_m_s, -0.65 * 0.5);
}

TEST(PlatenBody, halvingTheStepQuartersTheError) {
    PlatenConfig config;
    config.massCentre_m = {5e-3, -3e-3};
    config.anchor_m = {0.0, -20e-3};
    config.cableStiffness_N_per_m = 400.0;
    config.travel_rad = 1.0;
    const auto end = [&](double step_s) {
        PlatenState state;
        state.pose = {10e-3, -4e-3, 5e-3};
        run(config, state, {0.05, 0.02, 1e-4}, 0.5, step_s);
        return Vector2d(state.pose.x_m, state.pose.angle_rad);
    };
    const Vector2d exact = end(0.05e-3 / 4.0);
    const double coarse = (end(1e-3) - exact).norm();
    const double fine = (end(0.5e-3) - exact).norm();
    EXPECT_NEAR(coarse / fine, 4.0, 0.2);
}

} // namespace
} // namespace halbench::models
