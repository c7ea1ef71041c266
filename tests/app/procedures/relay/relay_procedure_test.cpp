#include "app/procedures/relay/relay_judge.h"
#include "app/procedures/relay/relay_plan.h"
#include "app/procedures/relay/relay_procedure.h"
#include "tests/app/procedures/relay/relay_truth.h"
#include "tests/app/procedures/rogue_board.h"
#include "tests/app/procedures/simulated_motor.h"
#include "tests/app/procedures/uncertain_motor.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace halbench::app {
namespace {

constexpr double Period_s = RelayPeriod_s;

// The amplifier's lag costs 6 % of the textbook's 17.27 A/rad (0.3 ms of 5.3 ms).
TEST(RelayExperiment, findsTheUltimateGainOfTheMotorWithoutImperfections) {
    auto device = openMotor("imperfections=off");
    const RelayResult result = measured(*device, {});
    ASSERT_TRUE(result.ultimate);
    EXPECT_NEAR(trueUltimateGain(0), 16.29, 0.02);
    EXPECT_NEAR(result.ultimate->at.gain, trueUltimateGain(0), 0.03 * 16.29);
    EXPECT_TRUE(holds(result, trueUltimateGain(0)));
    EXPECT_NEAR(*ultimatePeriodOf(result).value, 0.307, 0.005);
    EXPECT_NEAR(result.ultimate->phase_deg, -180.0, 3.0);
    EXPECT_FALSE(device->state().isArmed);
}

TEST(RelayExperiment, oneSampleOfDelayIsPartOfTheLoop) {
    for (int delay = 1; delay <= 2; ++delay) {
        auto device = openMotor("imperfections=off");
        setParameter(*device, "delay.samples", delay);
        const RelayResult result = measured(*device, {});
        ASSERT_TRUE(result.ultimate);
        EXPECT_NEAR(result.ultimate->at.gain, trueUltimateGain(delay), 0.05 * trueUltimateGain(delay));
        EXPECT_TRUE(holds(result, trueUltimateGain(delay)));
        EXPECT_EQ(result.delaySamples, delay);
        EXPECT_EQ(parameter(*device, "delay.samples"), delay);
    }
}

// What was said beforehand is what happens: speeds within 15 %, time and travel within a tenth.
TEST(RelayExperiment, doesWhatThePlanForesees) {
    auto device = openMotor("imperfections=off");
    const auto plan = planRelayOn(*device, {});
    ASSERT_TRUE(plan) << plan.error().message;
    const RelayResult result = measured(*device, {});
    EXPECT_GE(plan->turn_rad_s, 3.0);
    EXPECT_GE(plan->predicted.lowest_rad_s, 0.4 * 0.9 * plan->turn_rad_s);
    EXPECT_NEAR(result.lowestSpeed_rad_s, plan->predicted.lowest_rad_s, 0.5);
    EXPECT_NEAR(result.highestSpeed_rad_s, plan->predicted.highest_rad_s,
                0.15 * plan->predicted.highest_rad_s);
    EXPECT_NEAR(result.cycle.amplitude, plan->predicted.amplitude_rad, 0.15 * plan->predicted.amplitude_rad);
    EXPECT_NEAR(result.duration_s, plan->duration_s(), 0.1 * plan->duration_s());
    const std::vector<double> position = result.recording.column("position");
    EXPECT_NEAR(position.back() - position.front(), plan->travel_rad(), 0.1 * plan->travel_rad());
    EXPECT_NEAR(plan->predicted.at.gain, trueUltimateGain(0), 0.01 * trueUltimateGain(0));
    EXPECT_FALSE(plan->predicted.isOfThisMotor);
    EXPECT_EQ(result.agreement, RelayAgreement::Unknown);
}

TEST(RelayExperiment, turnsBackwardsAsWell) {
    auto device = openMotor("imperfections=off");
    RelayConfig config;
    config.base_rad_s = -7.0;
    const RelayResult result = measured(*device, config);
    EXPECT_EQ(result.plan.turn_rad_s, -7.0);
    EXPECT_TRUE(holds(result, trueUltimateGain(0)));
    const std::vector<double> position = result.recording.column("position");
    EXPECT_LT(position.back(), position.front() - 100.0);
}

// A model that is right to 1 % agrees; one whose damping is half of the truth, and sure of it, does not.
TEST(RelayExperiment, saysWhetherItAgreesWithTheModel) {
    auto device = openMotor("imperfections=off");
    RelayConfig config;
    config.motor = uncertainMotor(0.01);
    RelayResult result = measured(*device, config);
    EXPECT_EQ(result.agreement, RelayAgreement::Agrees);
    EXPECT_TRUE(result.plan.predicted.isOfThisMotor);
    ASSERT_TRUE(result.plan.predicted.gain95);
    EXPECT_LT(result.plan.predicted.gain95->first, trueUltimateGain(0));
    EXPECT_GT(result.plan.predicted.gain95->second, trueUltimateGain(0));
    EXPECT_EQ(result.quality.verdict, Verdict::Good);
    config.motor = uncertainMotor(0.01, {20.0, 0.0, 0.0}); // damping 20 % too large
    result = measured(*device, config);
    EXPECT_EQ(result.agreement, RelayAgreement::Disagrees);
    EXPECT_EQ(result.quality.verdict, Verdict::Doubtful);
    EXPECT_TRUE(holds(result, trueUltimateGain(0))); // the measurement does not depend on the model
}

/// The gains that ran before.
void expectAsBefore(devices::Device& device) {
    EXPECT_FALSE(device.state().isArmed);
    EXPECT_EQ(parameter(device, "gain.kp"), 10.0);
    EXPECT_EQ(parameter(device, "limit.current"), 4.0);
    EXPECT_EQ(parameter(device, "window.speed"), 40.0);
}

TEST(RelayExperiment, refusesWhatCannotBeDoneSafely) {
    auto device = openMotor("imperfections=off");
    const auto error = [&](const RelayConfig& config) {
        const auto result = runRelay(*device, config, {});
        return result ? Error{} : result.error();
    };
    RelayConfig config;
    config.base_rad_s = 2.5;
    EXPECT_EQ(error(config).code, ErrorCode::OutOfRange);
    config.base_rad_s = 4.0;
    config.limit_A = 4.0; // swings by more than that speed
    EXPECT_NE(error(config).message.find("standstill"), std::string::npos) << error(config).message;
    config = {};
    config.limit_A = 1.0; // less than friction needs
    EXPECT_EQ(error(config).code, ErrorCode::OutOfRange);
    config = {};
    config.cycles = 10;
    EXPECT_EQ(error(config).code, ErrorCode::OutOfRange);
    config = {};
    config.speedLimit_rad_s = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(error(config).code, ErrorCode::NotFinite);
    config = {};
    config.motor = uncertainMotor(0.01);
    config.motor->values["c_over_J"] = 0.0;
    EXPECT_EQ(error(config).code, ErrorCode::Refused); // proportional control swings at any gain
    expectAsBefore(*device);
}

// A gain below the limit: the loop comes to rest on the ramp and nothing is concluded.
TEST(RelayExperiment, aLoopThatDoesNotSwingIsRefused) {
    auto device = openMotor("imperfections=off");
    RelayConfig config;
    config.motor =
        uncertainMotor(0.01, {-45.0, 0.0, 0.0}); // foresees half the limit, and swings at 1.5 times it
    const auto result = runRelay(*device, config, {});
    const bool isTold = result && result->ultimate;
    EXPECT_FALSE(isTold);
    expectAsBefore(*device);
}

// The plan was made for a motor with three times the damping: the real one swings far more. It is stopped.
TEST(RelayExperiment, endsWhenTheRotorDoesNotDoWhatWasForeseen) {
    auto device = openMotor("imperfections=off");
    RelayConfig config;
    config.motor = uncertainMotor(0.1, {20.0, 0.0, 0.0});
    config.gain_A_per_rad = 400.0;
    const auto result = runRelay(*device, config, {});
    ASSERT_FALSE(result);
    EXPECT_FALSE(result.error().hint.empty());
    expectAsBefore(*device);
}

// A board that keeps its old current limit although it was told another is never armed.
TEST(RelayExperiment, aBoardThatDoesNotTakeTheLimitIsNotArmed) {
    RogueBoard device(openMotor("imperfections=off"), [](std::vector<ParameterValue> values) {
        std::erase_if(values, [](const ParameterValue& value) { return value.name == "limit.current"; });
        return values;
    });
    RelayConfig config;
    config.limit_A = 3.0;
    ProcedureObserver observer;
    bool wasExcited = false;
    observer.onState = [&](ProcedureState state) { wasExcited |= state == ProcedureState::Excite; };
    const auto result = runRelay(device, config, observer);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::DeviceRefused);
    EXPECT_NE(result.error().message.find("limit.current"), std::string::npos);
    EXPECT_FALSE(wasExcited);
}

// Every finding of the judgement, from a good result that is spoilt.
TEST(RelayExperiment, isJudgedRightOrRefused) {
    auto device = openMotor("imperfections=off");
    const RelayResult good = measured(*device, {});
    const auto verdictOf = [&good](const std::function<void(RelayResult&)>& spoil) {
        RelayResult result = good;
        result.quality = {};
        spoil(result);
        judgeRelay(result);
        EXPECT_EQ(result.ultimate.has_value(), result.quality.verdict != Verdict::Refused);
        EXPECT_EQ(ultimateGainOf(result).value.has_value(), result.ultimate.has_value());
        return std::pair(result.quality.verdict, result.quality.findings.front().code);
    };
    using Judged = std::pair<Verdict, std::string>;
    EXPECT_EQ(verdictOf([](RelayResult& r) { r.cycle.frequencyScatter_ratio = 0.06; }),
              Judged(Verdict::Refused, "cycle_follows_turn"));
    EXPECT_EQ(verdictOf([](RelayResult& r) { r.cycle.growth_ratio = 1.3; }),
              Judged(Verdict::Refused, "cycle_not_settled"));
    EXPECT_EQ(verdictOf([](RelayResult& r) {
                  r.ultimate->gain95 = {5.0, 40.0};
              }),
              Judged(Verdict::Refused, "ultimate_gain_uncertain"));
    EXPECT_EQ(verdictOf([](RelayResult& r) {
                  r.ultimate->gain95 = {14.0, 19.0};
              }),
              Judged(Verdict::Doubtful, "ultimate_gain_uncertain"));
    EXPECT_EQ(verdictOf([](RelayResult& r) { r.plan.predicted.gain95 = std::pair(20.0, 22.0); }),
              Judged(Verdict::Doubtful, "disagrees_with_model"));
    RelayRun torn{good.config, good.plan, Period_s, 0, 100, 400, good.recording};
    torn.recording.time_s[399] += 0.05;
    torn.rowLoss = {"2 % of the frames were damaged on the line", "shorten the cable"};
    const Error error = estimateRelay(std::move(torn)).error();
    EXPECT_EQ(error.code, ErrorCode::Refused);
    EXPECT_NE(error.message.find("2 % of the frames were damaged on the line"), std::string::npos)
        << error.message;
    EXPECT_EQ(error.hint, "shorten the cable");
}

} // namespace
} // namespace halbench::app
