#include "tests/devices/simulated/planar/positioner.h"

#include <algorithm>

// Each axis of the positioner runs the one position law (hb_law.h) with its own weights, filters and
// sections.

namespace halbench::devices {
namespace {

class Holding : public Positioner {
public:
    Holding() : Positioner("chain=ideal&imperfections=off") {
        set("coil.force_constant", WindingsForce_N_per_A);
    }
    void begin() {
        arm(HB_PLANAR_POSITION);
        wait(0.01);
    }
};

TEST(PlanarAxisLaw, isTheOneLawToTheBit) {
    Holding planar;
    planar.set("gain.y.derivative_reference_weight", 0.3);
    for (const auto& [name, value] : {std::pair{"filter.y.2.b0", 0.9},
                                      {"filter.y.2.b1", 0.2},
                                      {"filter.y.2.b2", 0.01},
                                      {"filter.y.2.a1", 0.3},
                                      {"filter.y.2.a2", 0.02}}) {
        planar.set(name, value);
    }
    planar.arm(HB_PLANAR_POSITION);
    const hb_planar& board = planar.firmware();
    const hb_planar_gains& gains = board.pages[board.board.xcp.active_page].gains[1];
    hb_law_config config{};
    config.kp_A_per_rad = gains.kp;
    config.ki_A_per_rad_s = gains.ki;
    config.kd_As_per_rad = gains.kd;
    config.reference_weight = gains.reference_weight;
    config.derivative_reference_weight = gains.derivative_reference_weight;
    config.derivative_filter_s = gains.derivative_filter_s;
    std::copy(std::begin(gains.sections), std::end(gains.sections), std::begin(config.sections));
    config.limit_A = 3.4e38F;
    config.period_s = 1e-3F;
    planar.wait(0.005);
    planar.set("hb.setpoint.y", 2e-5);
    planar.wait(0.001);
    hb_law law = board.law[1];
    for (int tick = 0; tick < 300; ++tick) {
        planar.wait(0.001);
        hb_law_input input{};
        input.position_rad = board.signals.position[1] - board.origin[1];
        input.reference_rad = board.live.setpoint[1];
        hb_law_step(&law, &config, &input);
        ASSERT_EQ(law.integral_A, board.law[1].integral_A) << tick;
        ASSERT_EQ(law.rate_rad_s, board.law[1].rate_rad_s) << tick;
        ASSERT_EQ(law.filtered[1][0], board.law[1].filtered[1][0]) << tick;
    }
    EXPECT_NE(law.filtered[1][0], 0.0F);
}

TEST(PlanarAxisLaw, aSectionScalesTheForceOfItsAxisAlone) {
    const auto firstForce_N = [](double b0, const std::string& axis) {
        Holding planar;
        planar.set("filter.x.1.b0", b0);
        planar.begin();
        planar.set("hb.setpoint." + axis, 1e-3);
        const std::vector<double> effort_N = planar.samples("effort." + axis, 0.02);
        return *std::max_element(effort_N.begin(), effort_N.end());
    };
    // kp b of 1 mm, 0.49206 N, and in the next tick ki Ts of it, 0.00127 N, before the platen has moved.
    EXPECT_NEAR(firstForce_N(1.0, "x"), 0.49333, 0.0001);
    EXPECT_NEAR(firstForce_N(0.5, "x"), 0.49333 / 2.0, 0.0001);
    EXPECT_NEAR(firstForce_N(0.5, "y"), 0.49333, 0.0001);
}

TEST(PlanarAxisLaw, integralStandsStillWhileTheCurrentsAreScaled) {
    Holding planar;
    planar.set("limit.current", 0.02);
    planar.begin();
    const double before_N = static_cast<double>(planar.firmware().law[0].integral_A);
    planar.set("hb.setpoint.x", 0.01);
    planar.wait(0.05);
    ASSERT_LT(planar.signal("current_scale"), 1.0);
    // ki Ts e = 0.0127 N is the step of one tick, before the law knows; 50 of them would be 0.6 N.
    EXPECT_LT(static_cast<double>(planar.firmware().law[0].integral_A) - before_N, 0.03);
}

} // namespace
} // namespace halbench::devices
