#include "models/planar/planar_linear.h"
#include "models/planar/platen_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace halbench::models {
namespace {

TEST(PlanarLinear, axesAreFreeMassesWithTheGivenDamping) {
    const auto axes = linearize({});
    EXPECT_NEAR(axes[0].dampingRate_1_s, 0.15625, 1e-15);
    EXPECT_NEAR(axes[1].accelerationGain, 1.5625, 1e-15);
    EXPECT_NEAR(axes[2].dampingRate_1_s, 0.1, 1e-15);
    EXPECT_NEAR(axes[2].accelerationGain, 1000.0, 1e-12);
    EXPECT_EQ(axes[0].breakawayEffort, 0.0);
}

TEST(PlanarLinear, gainMeetsTheCheckValues) {
    // Section 8: um/N at 1, 5, 10, 50 Hz of the undamped mass, with the hold of 1 ms. The digits printed.
    const PlanarAxisPlant mass{0.0, 1.0 / 0.64, 0.0};
    EXPECT_NEAR(1e6 * axisGain_per_effort(mass, 1.0, 1e-3), 39579.0, 0.6);
    EXPECT_NEAR(1e6 * axisGain_per_effort(mass, 5.0, 1e-3), 1583.0, 0.6);
    EXPECT_NEAR(1e6 * axisGain_per_effort(mass, 10.0, 1e-3), 395.7, 0.06);
    EXPECT_NEAR(1e6 * axisGain_per_effort(mass, 50.0, 1e-3), 15.8, 0.06);
}

TEST(PlanarLinear, theBodyAnswersASineWithTheLinearGain) {
    // Second route: the body under a sampled sine from the steady state of a damped mass, fitted over whole
    // periods.
    PlanarParameters parameters;
    parameters.damping_Ns_per_m = 3.0;
    PlatenConfig config;
    config.damping_Ns_per_m = 3.0;
    config.cableStiffness_N_per_m = 0.0;
    config.cableTorsion_Nm_per_rad = 0.0;
    PlatenState state;
    const double frequency_Hz = 5.0;
    const double period_s = 1e-3;
    std::complex<double> sum = 0.0;
    for (int tick = 0; tick < 6000; ++tick) {
        const double phase = 2.0 * M_PI * frequency_Hz * tick * period_s;
        if (tick >= 5000) { // transients of 0.21 s are gone, five whole periods follow
            sum += state.pose.x_m * std::polar(2.0 / 1000.0, -phase);
        }
        stepPlaten(config, state, {0.2 * std::sin(phase), 0.0, 0.0}, Eigen::Vector2d::Zero(), period_s);
    }
    // The hold's sampled output differs from the hold's fundamental by images at 995 Hz: (5/995)^2 = 2.5e-5.
    const double expected_m = 0.2 * axisGain_per_effort(linearize(parameters)[0], frequency_Hz, period_s);
    EXPECT_NEAR(std::abs(sum), expected_m, 1e-4 * expected_m);
}

} // namespace
} // namespace halbench::models
