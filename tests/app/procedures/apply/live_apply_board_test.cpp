// Live apply on a board that sends one row per control period, of which some are lost; what is restored when
// a later step leaves its band; and loops whose gain may neither fall nor rise freely.
#include "app/procedures/apply/live_apply_procedure.h"
#include "app/procedures/apply/live_step_judge.h"
#include "tests/app/procedures/simulated_motor.h"
#include "tests/app/procedures/slow_board.h"
#include "tests/app/procedures/uncertain_motor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

LiveApplyConfig toRecommended() {
    LiveApplyConfig config;
    const auto law = control::designLaw("recommended", {1.23e-3 / 5.5e-4, 26.0, 2.05e-2 / 1.43e-2}, {}, {});
    EXPECT_TRUE(law);
    config.target = law.value_or(control::PositionLaw{});
    config.motor = uncertainMotor(0.02);
    return config;
}

std::vector<double> gains(devices::Device& device) {
    std::vector<double> values;
    for (const ParameterValue& value : positionLawValues(device.catalogue(), {})) {
        values.push_back(parameter(device, value.name));
    }
    return values;
}

std::vector<ParameterValue> untouched(std::vector<ParameterValue> values) {
    return values;
}

/// One of twelve: a twelfth of the move is not seen, no gap longer than a period.
bool isTwelfth(std::size_t row) {
    return row % 12 == 7;
}

std::string firstCode(const LiveApplyResult& result) {
    return result.apply.quality.findings.empty() ? "" : result.apply.quality.findings.front().code;
}

TEST(LiveApplyAt100Hz, reachesATargetThoughRowsAreLost) {
    for (const char* query : {"imperfections=off", "seed=1", "seed=2"}) {
        std::size_t lost = 0;
        SlowBoard board(openMotor(query), untouched, 100.0, [&](std::size_t row, double, double&) {
            lost += isTwelfth(row) ? 1 : 0;
            return !isTwelfth(row);
        });
        const auto result = runLiveApply(board, toRecommended(), {});
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_EQ(board.fastest_Hz(), 100.0);
        EXPECT_GT(lost, 100U); // 8 moves of 2 s
        EXPECT_TRUE(result->apply.isKept) << query << ": " << firstCode(*result);
        EXPECT_EQ(result->steps.size(), 8U);
        for (const LiveStepResult& step : result->steps) {
            EXPECT_LE(step.widening_ratio, 1.0) << query;
        }
        EXPECT_FLOAT_EQ(static_cast<float>(parameter(board, "gain.kp")), 40.0F);
        EXPECT_EQ(result->apply.verification->recording.time_s.back(), 2.0) << "as long as it was asked";
    }
}

TEST(LiveApplyAt100Hz, aMotorThatIsNotTheIdentifiedOneGetsItsOldGainsBackThoughRowsAreLost) {
    SlowBoard board(openMotor("imperfections=off&J=1.65e-3"), untouched, 100.0,
                    [](std::size_t row, double, double&) { return !isTwelfth(row); });
    const std::vector<double> before = gains(board);
    const auto result = runLiveApply(board, toRecommended(), {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_FALSE(result->apply.isKept);
    EXPECT_EQ(firstCode(*result), "left_predicted_band");
    EXPECT_EQ(gains(board), before);
    EXPECT_FALSE(board.state().isArmed);
}

// Two rows are missing in a row where the overshoot would be: what was not seen is not taken for good.
TEST(LiveApplyAt100Hz, aMoveOfWhichTooMuchIsLostProvesNothing) {
    SlowBoard board(openMotor("imperfections=off"), untouched, 100.0,
                    [](std::size_t row, double, double&) { return row % 60 < 55; });
    const std::vector<double> before = gains(board);
    const auto result = runLiveApply(board, toRecommended(), {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_FALSE(result->apply.isKept);
    const auto& findings = result->apply.quality.findings;
    EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
        return finding.code == "verification_incomplete";
    }));
    EXPECT_EQ(result->steps.size(), 1U) << "it did not go on";
    EXPECT_EQ(gains(board), before);
}

/// Notes each K_P that is written, and pushes the measured angle aside in the move of one step.
class LiveApplyPushed : public ::testing::Test {
protected:
    LiveApplyResult pushedInStep(int step, double rate_Hz) {
        std::vector<double> positions;
        int verified = 0;
        ProcedureObserver observer;
        observer.onState = [&](ProcedureState state) { verified += state == ProcedureState::Verify ? 1 : 0; };
        SlowBoard board(
            openMotor("imperfections=off"),
            [this](std::vector<ParameterValue> values) {
                for (const ParameterValue& value : values) {
                    if (value.name == "gain.kp") {
                        written.push_back(value.value);
                    }
                }
                return values;
            },
            rate_Hz,
            [&](std::size_t, double time_s, double& position_rad) {
                position_rad += verified == step && time_s > 0.5 ? 0.4 : 0.0;
                return true;
            });
        before = gains(board);
        auto result = runLiveApply(board, toRecommended(), observer);
        EXPECT_TRUE(result) << result.error().message;
        after = gains(board);
        EXPECT_FALSE(board.state().isArmed);
        return result ? *result : LiveApplyResult{};
    }

    std::vector<double> written; ///< K_P
    std::vector<double> before;
    std::vector<double> after;
};

// Not the gains of the first step, which went well, but those from before it.
TEST_F(LiveApplyPushed, theSecondStepTakesTheFirstOneBackToo) {
    for (const double rate_Hz : {1000.0, 100.0}) {
        written.clear();
        const LiveApplyResult result = pushedInStep(2, rate_Hz);
        EXPECT_FALSE(result.apply.isKept) << rate_Hz;
        ASSERT_EQ(result.steps.size(), 2U) << rate_Hz;
        EXPECT_TRUE(result.steps[0].isWithin);
        EXPECT_FALSE(result.steps[1].isWithin);
        EXPECT_EQ(firstCode(result), "left_predicted_band");
        EXPECT_EQ(after, before);
        ASSERT_EQ(written.size(), 3U); // step, step, back
        EXPECT_GT(written[0], 10.0);
        EXPECT_GT(written[1], written[0]);
        EXPECT_EQ(written[2], 10.0);
        ASSERT_FALSE(result.apply.before.empty());
        EXPECT_EQ(result.apply.before.front().value, 10.0);
    }
}

TEST_F(LiveApplyPushed, nothingIsTakenBackWhenNothingIsPushed) {
    const LiveApplyResult result = pushedInStep(99, 100.0);
    EXPECT_TRUE(result.apply.isKept);
    EXPECT_EQ(written.size(), 8U);
    EXPECT_NE(after, before);
}

control::PositionLaw law(double kp, double ki, double kd) {
    control::PositionLaw result;
    result.gains.proportional = kp;
    result.gains.integral = ki;
    result.gains.derivative = kd;
    return result;
}

LiveApplyConfig to(const control::PositionLaw& target) {
    LiveApplyConfig config = toRecommended();
    config.target = target;
    return config;
}

// This integral puts the two limits of the gain at 0.259 and 3.861 times it, equally far in the logarithm: of
// some motors that the data allow the lower one is nearer, of others the upper one.
const control::PositionLaw Balanced = law(40.0, 460.0, 1.6);

TEST(LiveApplyBothWays, aLoopIsJudgedByTheNearerLimitOfItsGainOnWhicheverSide) {
    const auto judged = [](const control::PositionLaw& each) {
        const LiveApplyConfig config = to(each);
        return judgeLiveStep(each, *liveMotors(config), config, {});
    };
    const auto balanced = judged(Balanced);
    ASSERT_TRUE(balanced) << balanced.error().message;
    ASSERT_TRUE(balanced->robust.gainMargin_ratio);
    EXPECT_LT(balanced->robust.gainMargin_ratio->p5, 0.3); // the case is what it says it is
    EXPECT_GT(balanced->robust.gainMargin_ratio->p95, 3.5);
    EXPECT_GT(balanced->robust.gainMarginEitherWay_ratio_p5, 3.5);
    EXPECT_TRUE(judged(law(40.0, 60.0, 1.4))) << "a limit above only";
    EXPECT_TRUE(judged(law(40.0, 1000.0, 1.6))) << "the nearer one below, at 0.63";
    const auto low = judged(law(30.0, 850.0, 1.2)); // below, at 0.97: nothing is left
    ASSERT_FALSE(low);
    EXPECT_NE(low.error().message.find("not safe"), std::string::npos) << low.error().message;
    EXPECT_FALSE(judged(law(150.0, 1725.0, 6.0))) << "above, at 1.03";
}

TEST(LiveApplyBothWays, aLoopWithTwoLimitsIsReached) {
    const auto device = openMotor("imperfections=off");
    const auto result = runLiveApply(*device, to(Balanced), {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->apply.isKept) << firstCode(*result);
    EXPECT_FLOAT_EQ(static_cast<float>(parameter(*device, "gain.ki")), 460.0F);
}

} // namespace
} // namespace halbench::app
