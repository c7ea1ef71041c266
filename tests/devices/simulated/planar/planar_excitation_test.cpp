#include "tests/devices/simulated/planar/positioner.h"

#include <algorithm>
#include <cmath>
#include <numeric>

// In mode position the generator of an axis can add its shape to the force or torque that the law commands.

namespace halbench::devices {
namespace {

constexpr double Effort = 1.0; // HB_TARGET_EFFORT

class Excited : public Positioner {
public:
    explicit Excited(const std::string& query = "chain=ideal&imperfections=off") : Positioner(query) {
        set("coil.force_constant", WindingsForce_N_per_A);
    }
    /// Written together, as a host does: nothing starts before all of it is there.
    void excite(const std::string& axis, int shape, double amplitude, double frequency_Hz,
                double duration_s = 100.0) {
        const std::string generator = "reference." + axis + ".";
        const ParameterValue values[] = {
            {generator + "target", Effort},       {generator + "shape", static_cast<double>(shape)},
            {generator + "amplitude", amplitude}, {generator + "frequency", frequency_Hz},
            {generator + "duration", duration_s}, {"reference.start", 1.0}};
        const auto written = device().writeParameters(values);
        ASSERT_TRUE(written) << written.error().message;
    }
};

double largest(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0,
                           [](double most, double value) { return std::max(most, std::fabs(value)); });
}

// Slow against the loop, the law answers a force F with the opposite force at -F/kp: 0.1 N over 660.48 N/m
// at 0.2 Hz is 0.151 mm but for the integral, which at 0.2 Hz adds ki/(j w) = -1575j N/m: |1/(660+35j-1575j)|
// (kd 2 pi 0.2 Hz = 50 N/m). The command is what is left for the mass, m (2 pi 0.2 Hz)^2 x = 6e-5 N.
TEST(PlanarExcitation, aSlowForceIsAnsweredByTheLaw) {
    Excited planar;
    planar.arm(HB_PLANAR_POSITION);
    planar.wait(0.5);
    const double start_m = planar.signal("position.x");
    planar.excite("x", HB_SHAPE_SINE, 0.1, 0.2);
    planar.wait(20.0);
    std::vector<double> position_m = planar.samples("position.x", 5.0);
    for (double& value : position_m) {
        value -= start_m;
    }
    const double omega = 2.0 * 3.14159265358979 * 0.2;
    const double stiffness = std::hypot(660.48 - 0.64 * omega * omega, 39.808 * omega - 1267.2 / omega);
    EXPECT_NEAR(largest(position_m), 0.1 / stiffness, 0.03 * 0.1 / stiffness); // damping, set-wise currents
    EXPECT_LT(largest(planar.samples("command.x", 5.0)), 2e-4);
    EXPECT_LT(largest(planar.samples("command.y", 0.1)), 2e-4);
}

// Far above the crossover at 10 Hz the loop adds little: |L| is 0.17 at 50 Hz, so that the command is
// 0.1 |S| with |S| within 1/(1 -+ 0.17).
TEST(PlanarExcitation, aFastForceReachesTheCoils) {
    Excited planar;
    planar.arm(HB_PLANAR_POSITION);
    planar.wait(0.5);
    planar.excite("y", HB_SHAPE_SINE, 0.1, 50.0);
    planar.wait(0.5);
    const double command_N = largest(planar.samples("command.y", 1.0));
    EXPECT_GT(command_N, 0.1 / 1.18);
    EXPECT_LT(command_N, 0.1 / 0.82);
    const double effort_N = largest(planar.samples("effort.y", 1.0));
    EXPECT_NEAR(effort_N, command_N, 0.02 * command_N); // by the board's model of the same coils
}

TEST(PlanarExcitation, theReferenceThatIsHeldStays) {
    Excited planar;
    planar.arm(HB_PLANAR_POSITION);
    planar.set("reference.x.shape", HB_SHAPE_STEP);
    planar.set("reference.x.amplitude", 5e-4);
    planar.set("reference.start", 1.0);
    planar.wait(3.0);
    const double reference_m = planar.signal("reference.x");
    planar.excite("x", HB_SHAPE_SINE, 0.1, 20.0, 1.0);
    planar.wait(0.5);
    EXPECT_EQ(planar.signal("reference.x"), reference_m);
    planar.wait(11.0); // its second is over, and the ten in which the other axes have no shape
    EXPECT_EQ(planar.signal("reference.x"), reference_m);
    EXPECT_EQ(planar.signal("reference.running"), 0.0);
    EXPECT_LT(largest(planar.samples("command.x", 0.1)), 1e-3);
}

TEST(PlanarExcitation, endsWithTheModeAndWithTheReference) {
    Excited planar;
    planar.arm(HB_PLANAR_POSITION);
    planar.excite("phi", HB_SHAPE_SINE, 5e-3, 20.0);
    planar.wait(0.5);
    EXPECT_EQ(planar.signal("reference.running"), 1.0);
    planar.set("reference.start", 0.0);
    planar.wait(0.01);
    EXPECT_EQ(planar.signal("reference.running"), 0.0);
    planar.excite("phi", HB_SHAPE_SINE, 5e-3, 20.0);
    planar.wait(0.5);
    ASSERT_TRUE(planar.device().disarm());
    planar.wait(0.5);
    EXPECT_EQ(planar.signal("command.phi"), 0.0);
    planar.arm(HB_PLANAR_POSITION);
    planar.wait(0.2);
    EXPECT_LT(largest(planar.samples("command.phi", 0.2)), 1e-5); // 0.2 % of the excitation
}

// A multisine of whole periods on one axis, and the others quiet: the same every second.
TEST(PlanarExcitation, aMultisineRepeatsItselfPeriodByPeriod) {
    Excited planar;
    planar.arm(HB_PLANAR_POSITION);
    planar.set("reference.x.frequency_end", 25.0);
    planar.set("reference.x.count", 7.0);
    planar.excite("x", HB_SHAPE_MULTISINE, 0.2, 1.0); // 1, 5, 9 ... 25 Hz
    planar.wait(6.0);
    const std::vector<double> command_N = planar.samples("command.x", 2.0);
    ASSERT_GE(command_N.size(), 2000U);
    double difference = 0.0;
    for (std::size_t n = 0; n < 1000; ++n) {
        difference = std::max(difference, std::fabs(command_N[n] - command_N[n + 1000]));
    }
    EXPECT_LT(difference, 1e-3 * largest(command_N)); // float rounding in pose and law
    EXPECT_GT(largest(command_N), 0.1);
}

} // namespace
} // namespace halbench::devices
