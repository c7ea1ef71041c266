#include "tests/app/procedures/beyond_model/beyond_model.h"

namespace halbench::app {
namespace {

IdentifyResult identified(const RecordedMotor& motor, std::uint64_t seed) {
    IdentifyConfig config;
    config.given.inertia_kg_m2 = motor.inertia_kg_m2;
    auto result = identifyRecording(recordedExcitation(motor, seed, config), config);
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result ? std::move(*result) : IdentifyResult{};
}

std::string findingsOf(const IdentifyResult& result) {
    std::string text;
    for (const Finding& finding : result.quality.findings) {
        text += finding.code + ": " + finding.message + "\n";
    }
    return text;
}

bool hasFinding(const IdentifyResult& result, const std::string& code) {
    return std::any_of(result.quality.findings.begin(), result.quality.findings.end(),
                       [&code](const Finding& finding) { return finding.code == code; });
}

// Three standard errors: 1.53 half widths of 95 %.
void expectHolds(const control::Estimate& estimate, double truth) {
    ASSERT_TRUE(estimate.value && estimate.interval95);
    const double half = 0.5 * (estimate.interval95->second - estimate.interval95->first);
    EXPECT_NEAR(*estimate.value, truth, 1.53 * half);
}

TEST(IdentifyBeyondTheModel, isRightOrNotGoodForTenMotors) {
    EXPECT_EQ(countWrongAndGood(201, 210), 0);
}

TEST(IdentifyBeyondTheModel, findsAndNamesQuadraticDrag) {
    for (const double share : {0.1, 0.5}) { // of the viscous torque at 25 rad/s
        RecordedMotor motor;
        motor.square_Nm_s2 = share * motor.damping_Nm_s / 25.0;
        const IdentifyResult result = identified(motor, 3);
        EXPECT_EQ(result.quality.verdict, Verdict::Doubtful);
        ASSERT_TRUE(hasFinding(result, "quadratic_drag")) << findingsOf(result);
        EXPECT_FALSE(hasFinding(result, "friction_beyond_model"));
        const double low = result.notes.at("quadratic_drag_lo");
        const double high = result.notes.at("quadratic_drag_hi");
        EXPECT_NEAR(result.notes.at("quadratic_drag"), motor.square_Nm_s2, 1.53 * 0.5 * (high - low));
        EXPECT_LT(high - low, 0.5 * motor.square_Nm_s2); // the size is known, not only that it is there
        expectHolds(result.viscousDamping, motor.damping_Nm_s);
        expectHolds(result.coulombFriction, motor.friction_Nm);
        expectHolds(result.torqueConstant, motor.torque_Nm_per_A);
    }
}

TEST(IdentifyBeyondTheModel, findsAndNamesStribeckFriction) {
    RecordedMotor motor;
    motor.stribeck_ratio = 1.8;
    motor.static_ratio = 1.8;
    motor.stribeckSpeed_rad_s = 5.0;
    const IdentifyResult result = identified(motor, 4);
    EXPECT_EQ(result.quality.verdict, Verdict::Doubtful);
    ASSERT_TRUE(hasFinding(result, "stribeck_friction")) << findingsOf(result);
    // steps between the Stribeck speeds that are tried: a third
    EXPECT_NEAR(result.notes.at("stribeck_speed_rad_s"), 5.0, 1.7);
    expectHolds(result.viscousDamping, motor.damping_Nm_s);
    expectHolds(result.coulombFriction, motor.friction_Nm);
    expectHolds(result.torqueConstant, motor.torque_Nm_per_A);
}

TEST(IdentifyBeyondTheModel, aMotorThatTheModelDescribesHasNoFinding) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const IdentifyResult result = identified({}, seed);
        EXPECT_EQ(result.quality.verdict, Verdict::Good) << seed;
        EXPECT_EQ(result.notes.count("quadratic_drag"), 0u);
    }
}

} // namespace
} // namespace halbench::app
