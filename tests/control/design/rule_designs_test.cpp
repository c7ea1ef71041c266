// The rules of the books as methods: what reaches the board is what the rule says, by its own formula or a
// second route.
#include "control/analysis/margins.h"
#include "control/base/units.h"
#include "control/design/design_methods.h"
#include "control/design/rule_designs.h"
#include "tests/control/published_motor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::control {
namespace {

constexpr double k = 26.0;
constexpr double a = 1.23e-3 / 5.5e-4;

Result<PositionLaw> design(std::string_view method, const DesignTargets& targets = {},
                           const LoopTiming& timing = NoDelay) {
    return designLaw(method, published(), timing, targets);
}

PidGains gainsOf(std::string_view method, const DesignTargets& targets = {},
                 const LoopTiming& timing = NoDelay) {
    const auto law = design(method, targets, timing);
    EXPECT_TRUE(law.has_value()) << method << ": " << law.error().message;
    return law ? law->gains : PidGains{};
}

StabilityMargins marginsOf(const PidGains& gains) {
    return smallestMargins(*sampledOpenLoop(published(), gains, NoDelay));
}

// In the words of the motor (k/(s (s + a)), dead time t = T + delay): K_P = (2 l + t + 1/a) a/(k (l + t)^2)
// ...
TEST(Lambda, isItsFormulaOnTheMotor) {
    DesignTargets targets;
    targets.bandwidth_Hz = 1.0 / (2.0 * Pi * 0.04); // lambda = 0.04 s
    for (const int delay : {0, 1, 2}) {
        const double t = 0.01 * (1 + delay);
        const double scale = a / (k * (0.04 + t) * (0.04 + t));
        const PidGains gains = gainsOf("lambda", targets, {0.01, delay});
        EXPECT_NEAR(gains.proportional, (0.08 + t + 1.0 / a) * scale, 1e-12);
        EXPECT_NEAR(gains.integral, scale, 1e-12);
        EXPECT_NEAR(gains.derivative, (0.08 + t) / a * scale, 1e-12);
    }
}

// Skogestad's rule for a double integrator, t = closed-loop time + dead time, in parallel form:
// K_P = 1/(2 k t^2), K_I = K_P/(8 t), K_D = 2 t K_P.
TEST(Simc, isItsFormulaOnTheMotor) {
    const double t = 0.03;
    DesignTargets targets;
    targets.bandwidth_Hz = 1.0 / (2.0 * Pi * (t - 0.01));
    const PidGains gains = gainsOf("simc", targets);
    EXPECT_NEAR(gains.proportional, 1.0 / (2.0 * k * t * t), 1e-10);
    EXPECT_NEAR(gains.integral, gains.proportional / (8.0 * t), 1e-9);
    EXPECT_NEAR(gains.derivative, gains.proportional * 2.0 * t, 1e-10);
}

// Second route to the ultimate point: the stability limit of K_P, and the angle of the poles there.
TEST(ZieglerNichols, startsFromWhereTheSampledLoopSwings) {
    for (const int delay : {0, 1}) {
        const LoopTiming timing{0.01, delay};
        PidGains swinging;
        swinging.proportional = proportionalLimit_A_per_rad(published(), timing);
        double angle = 0.0;
        for (const auto& pole : closedLoopPoles(*sampledOpenLoop(published(), swinging, timing))) {
            angle = std::abs(std::abs(pole) - 1.0) < 1e-6 ? std::abs(std::arg(pole)) : angle;
        }
        const double period_s = 2.0 * Pi / (angle / 0.01);
        const PidGains pid = gainsOf("ziegler-nichols", {}, timing);
        // Both are bisected; the period is that of a pole found on the circle to 1e-6.
        EXPECT_NEAR(pid.proportional, 0.6 * swinging.proportional, 1e-6);
        EXPECT_NEAR(pid.integral, 1.2 * swinging.proportional / period_s, 1e-4);
        EXPECT_NEAR(pid.derivative, 0.075 * swinging.proportional * period_s, 1e-6);
        EXPECT_NEAR(gainsOf("ziegler-nichols-p", {}, timing).proportional, 0.5 * swinging.proportional, 1e-6);
    }
}

// As the relay experiment found it, which knows the amplifier's lag: the rule is of that and not of the
// model.
TEST(ZieglerNichols, takesTheUltimatePointThatWasMeasured) {
    DesignTargets measured;
    measured.ultimateGain_A_per_rad = 16.3;
    measured.ultimatePeriod_s = 0.307;
    const PidGains pid = gainsOf("ziegler-nichols", measured);
    EXPECT_NEAR(pid.proportional, 0.6 * 16.3, 1e-12);
    EXPECT_NEAR(pid.integral, 1.2 * 16.3 / 0.307, 1e-9);
    EXPECT_NEAR(pid.derivative, 0.075 * 16.3 * 0.307, 1e-12);
    measured.ultimatePeriod_s.reset();
    EXPECT_EQ(design("ziegler-nichols", measured).error().code, ErrorCode::Usage);
    measured.ultimatePeriod_s = -1.0;
    EXPECT_EQ(design("ziegler-nichols", measured).error().code, ErrorCode::OutOfRange);
    measured.ultimatePeriod_s = 0.307;
    EXPECT_EQ(design("recommended", measured).error().code, ErrorCode::Usage); // does not read it
}

// c/J damps too little for the phase that PI costs at half of the ultimate gain.
TEST(ZieglerNichols, refusesPiOnAMotorThatItMakesUnstable) {
    const auto refused = design("ziegler-nichols-pi");
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    EXPECT_NE(refused.error().message.find("pole radius"), std::string::npos);
    EXPECT_FALSE(refused.error().hint.empty());
}

// The regulator of k/s^2 has w^4 = k^2 q/r: K_P k -> w^2 for a loop much slower than its sampling.
TEST(Lqr, hasTheAskedFrequencyWhereSamplingIsFast) {
    DesignTargets targets;
    targets.omega_rad_s = 20.0;
    const LoopTiming fast{1e-4, 0};
    const auto law = designLaw("lqr", {0.0, k, 0.0}, fast, targets);
    ASSERT_TRUE(law.has_value());
    // What a sample of 1e-4 s takes of 20 rad/s: w T = 0.002 of it.
    EXPECT_NEAR(std::sqrt(k * law->gains.proportional), 20.0, 0.05);
    EXPECT_NEAR(k * law->gains.derivative / 40.0, std::sqrt(0.5), 0.005); // damping
    EXPECT_EQ(law->gains.integral, 0.0);
}

// The default is one degree of error for half an ampere: what designRegulator makes of it is what is given.
TEST(Lqr, givesTheBoardTheRegulatorsGains) {
    const auto regulator = designRegulator(published(), NoDelay, {degreesToRadians(2.0), {}, 1.0}, 4.0);
    const PidGains gains = gainsOf("lqr");
    EXPECT_EQ(gains.proportional, regulator->gains.proportional);
    EXPECT_EQ(gains.derivative, regulator->gains.derivative);
}

TEST(LeastError, staysWithinMs) {
    for (const char* method : {"min-iae", "min-itae"}) {
        const PidGains gains = gainsOf(method);
        EXPECT_LE(sensitivityPeaks(*sampledOpenLoop(published(), gains, NoDelay)).Ms_ratio, 1.7 * 1.01);
        EXPECT_GT(gains.integral, 60.0) << method; // more than the recommended one: it holds a load better
    }
}

TEST(Lead, hasTheAskedMarginAndNoIntegral) {
    DesignTargets targets;
    targets.phaseMargin_deg = 50.0;
    const PidGains gains = gainsOf("lead", targets);
    EXPECT_EQ(gains.integral, 0.0);
    EXPECT_NEAR(marginsOf(gains).phaseMargin_deg, 50.0, 0.01); // what the method bisects to
    targets.omega_rad_s = 20.0;
    EXPECT_NEAR(marginsOf(gainsOf("lead", targets)).gainCrossover_rad_s.value(), 20.0, 1e-6); // ten digits
}

TEST(Lag, crossesWhereItWasAskedTo) {
    DesignTargets targets;
    targets.omega_rad_s = 6.0;
    const PidGains gains = gainsOf("lag", targets);
    EXPECT_NEAR(marginsOf(gains).gainCrossover_rad_s.value(), 6.0, 1e-6); // ten digits
    EXPECT_NEAR(gains.integral / gains.proportional, 0.6, 1e-12);
    EXPECT_EQ(gains.derivative, 0.0);
    targets.omega_rad_s = 60.0; // the motor's own damping is long past its phase there
    EXPECT_EQ(design("lag", targets).error().code, ErrorCode::Refused);
}

TEST(Rules, refuseAMotorWithoutDampingWhereTheyNeedIt) {
    const PositionPlant free{0.0, k, 0.0};
    for (const char* method : {"simc", "lambda", "lag"}) {
        const auto refused = designLaw(method, free, NoDelay, {});
        ASSERT_FALSE(refused.has_value()) << method;
        EXPECT_EQ(refused.error().code, ErrorCode::OutOfRange) << method;
        EXPECT_NE(refused.error().hint.find("lqr"), std::string::npos) << method;
    }
    EXPECT_TRUE(designLaw("lqr", free, NoDelay, {}).has_value());
}

TEST(Filters, areNoMethodsOfABoardWithoutAStageForThem) {
    for (const char* method : {"notch", "low-pass"}) {
        EXPECT_EQ(design(method).error().code, ErrorCode::InvalidInput) << method;
    }
}

// A loop that no rule may leave worse than it found: the proof of each default on the published motor.
TEST(Rules, giveStableLoopsByDefault) {
    for (const char* method : {"simc", "lambda", "ziegler-nichols", "ziegler-nichols-p", "lqr", "min-iae",
                               "min-itae", "lead", "lag"}) {
        for (const int delay : {0, 1}) {
            const LoopTiming timing{0.01, delay};
            const auto loop = sampledOpenLoop(published(), gainsOf(method, {}, timing), timing);
            ASSERT_TRUE(loop.has_value()) << method;
            EXPECT_LT(poleRadius(*loop), 1.0) << method << " " << delay;
        }
    }
}

} // namespace
} // namespace halbench::control
