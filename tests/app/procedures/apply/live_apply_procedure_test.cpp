#include "app/procedures/apply/live_apply_procedure.h"
#include "devices/simulated/htm/simulated_htm.h"
#include "tests/app/procedures/faulty_motor.h"
#include "tests/app/procedures/rogue_board.h"
#include "tests/app/procedures/simulated_motor.h"
#include "tests/app/procedures/uncertain_motor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

control::PositionLaw recommended() {
    const auto law = control::designLaw("recommended", {1.23e-3 / 5.5e-4, 26.0, 2.05e-2 / 1.43e-2}, {}, {});
    EXPECT_TRUE(law);
    return law ? *law : control::PositionLaw{};
}

LiveApplyConfig toRecommended() {
    LiveApplyConfig config;
    config.target = recommended();
    config.motor = uncertainMotor(0.02);
    return config;
}

/// Everything that the law has on a board.
std::vector<double> gains(devices::Device& device) {
    std::vector<double> values;
    for (const ParameterValue& value : positionLawValues(device.catalogue(), {})) {
        values.push_back(parameter(device, value.name));
    }
    return values;
}

TEST(LiveApply, reachesATargetThatMovesAsPredicted) {
    for (const char* query : {"imperfections=off", "seed=1", "seed=2"}) {
        const auto device = openMotor(query);
        std::vector<double> written;
        const auto result = runLiveApply(*device, toRecommended(), {});
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_TRUE(result->apply.isKept)
            << query << ": "
            << (result->apply.quality.findings.empty() ? "" : result->apply.quality.findings[0].message);
        EXPECT_EQ(result->steps.size(), result->plannedSteps);
        EXPECT_FLOAT_EQ(static_cast<float>(parameter(*device, "gain.kp")), 40.0F);
        EXPECT_FLOAT_EQ(static_cast<float>(parameter(*device, "gain.kd")), 1.4F);
        EXPECT_EQ(parameter(*device, "window.position_enabled"), 0.0);
        EXPECT_FALSE(device->state().isArmed);
        ASSERT_FALSE(result->apply.before.empty());
        EXPECT_EQ(result->apply.before[0].value, 10.0);
        ASSERT_TRUE(result->apply.verification && result->apply.band);
    }
}

// From 10 to 180 A/rad at once by factors of 1.5: ln 18/ln 1.5 = 7.1, eight steps, none larger.
TEST(LiveApply, everyStepIsSmall) {
    const auto device = openMotor("imperfections=off");
    const auto result = runLiveApply(*device, toRecommended(), {});
    ASSERT_TRUE(result && result->apply.isKept);
    EXPECT_EQ(result->steps.size(), 8U);
    double kp = 10.0;
    double atOnce = 10.0;
    for (const LiveStepResult& step : result->steps) {
        const double nextKp = step.values[0].value;
        const double nextAtOnce = nextKp + step.values[2].value / 0.01;
        EXPECT_LE(nextKp / kp, 1.5 + 1e-5); // single precision on the board
        EXPECT_LE(nextAtOnce / atOnce, 1.5 + 1e-5);
        EXPECT_TRUE(step.isWithin);
        EXPECT_LE(step.widening_ratio, 1.0);
        EXPECT_LT(step.robust.unstable_fraction, 0.01);
        kp = nextKp;
        atOnce = nextAtOnce;
    }
}

TEST(LiveApply, aMotorThatIsNotTheIdentifiedOneGetsItsOldGainsBack) {
    for (const char* query :
         {"imperfections=off&J=1.65e-3", "imperfections=off&phi=7.15e-3", "seed=1&J=1.65e-3"}) {
        const auto device = openMotor(query);
        const std::vector<double> before = gains(*device);
        const auto result = runLiveApply(*device, toRecommended(), {});
        ASSERT_TRUE(result) << query << ": " << result.error().message;
        EXPECT_FALSE(result->apply.isKept) << query;
        EXPECT_EQ(result->apply.quality.verdict, Verdict::Refused);
        ASSERT_FALSE(result->apply.quality.findings.empty()) << query;
        EXPECT_EQ(result->apply.quality.findings.front().code, "left_predicted_band") << "the reason first";
        EXPECT_LT(result->steps.size(), result->plannedSteps) << "it did not go on";
        EXPECT_EQ(gains(*device), before) << query;
        EXPECT_FALSE(device->state().isArmed);
    }
}

TEST(LiveApply, theMoveEndsWhenItLeavesItsBand) {
    const auto device = openMotor("imperfections=off&J=1.65e-3");
    double verifying_s = 0.0;
    ProcedureObserver observer;
    observer.onState = [&](ProcedureState state) {
        if (state == ProcedureState::Verify) {
            verifying_s = device->clock().now_s();
        }
    };
    const auto result = runLiveApply(*device, toRecommended(), observer);
    ASSERT_TRUE(result && !result->apply.isKept);
    EXPECT_LT(device->clock().now_s() - verifying_s, 1.0) << "of a move of 2 s";
    EXPECT_FALSE(result->apply.verification) << "it has no move that was made to its end";
    EXPECT_NE(result->apply.quality.findings.back().message.find("outside the predicted band at"),
              std::string::npos)
        << result->apply.quality.findings.back().message;
}

TEST(LiveApply, nothingIsWrittenWhenAStepOfTheWayIsNotSafe) {
    int writes = 0;
    RogueBoard board(openMotor("imperfections=off"), [&writes](std::vector<ParameterValue> values) {
        writes += std::any_of(values.begin(), values.end(),
                              [](const ParameterValue& value) {
                                  return value.name == "gain.kp" && value.value != 10.0;
                              })
                      ? 1
                      : 0;
        return values;
    });
    LiveApplyConfig config = toRecommended();
    config.target = {};
    config.target.gains.proportional = 40.0; // 17.27 A/rad is the limit without derivative
    const auto result = runLiveApply(board, config, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Refused);
    EXPECT_NE(result.error().message.find("not safe"), std::string::npos);
    EXPECT_EQ(writes, 0);
    EXPECT_EQ(parameter(board, "gain.kp"), 10.0);
}

TEST(LiveApply, whatIsNoNumberOrNoGainIsRefusedBeforeAnythingIsWritten) {
    const auto device = openMotor("imperfections=off");
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1.0, 1e9}) {
        LiveApplyConfig config = toRecommended();
        config.target.gains.integral = bad;
        EXPECT_FALSE(runLiveApply(*device, config, {})) << bad;
        config = toRecommended();
        config.target.coulomb_A = bad;
        EXPECT_FALSE(runLiveApply(*device, config, {})) << bad;
        EXPECT_EQ(parameter(*device, "gain.kp"), 10.0);
    }
    LiveApplyConfig exact = toRecommended();
    exact.motor.covarianceNames.clear();
    exact.motor.covariance.clear();
    EXPECT_FALSE(runLiveApply(*device, exact, {})) << "nothing is known of its uncertainty";
    EXPECT_EQ(parameter(*device, "gain.kp"), 10.0);
}

/// Something happens in the third step.
class LiveApplyLater : public ::testing::Test {
protected:
    ProcedureObserver inThirdStep(std::function<void()> what) {
        ProcedureObserver observer;
        observer.onState = [this, what = std::move(what)](ProcedureState state) {
            verified += state == ProcedureState::Verify ? 1 : 0;
            if (verified == 3 && state == ProcedureState::Verify) {
                what();
            }
        };
        observer.checkAbort = [this]() -> Result<void> {
            return isAborted ? Result<void>(failure(ErrorCode::Interrupted, "stopped by the test", ""))
                             : Result<void>();
        };
        return observer;
    }

    int verified = 0;
    bool isAborted = false;
};

TEST_F(LiveApplyLater, anAbortRestoresWhatWasBeforeAllSteps) {
    const auto device = openMotor("seed=1");
    const std::vector<double> before = gains(*device);
    const auto result = runLiveApply(*device, toRecommended(), inThirdStep([this] { isAborted = true; }));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Interrupted);
    EXPECT_EQ(gains(*device), before);
    EXPECT_FALSE(device->state().isArmed);
}

TEST_F(LiveApplyLater, aLostLinkLeavesTheBoardWithItsOldGainsAndSaysThatItIsNotConfirmed) {
    FaultyMotor board("seed=1");
    auto device = board.connect();
    const std::vector<double> before = gains(*device);
    const auto result =
        runLiveApply(*device, toRecommended(), inThirdStep([&] { board.faults().isUnplugged = true; }));
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("not confirmed"), std::string::npos) << result.error().message;
    device.reset();
    board.board().advanceTo(board.board().time_s() + 2.0); // its watchdog is set to one second
    EXPECT_FALSE(board.isArmed());
    board.repair();
    const auto later = board.connect();
    ASSERT_NE(later, nullptr);
    EXPECT_EQ(gains(*later), before);
}

TEST_F(LiveApplyLater, aFaultOfTheBoardRestores) {
    FaultyMotor board("seed=1");
    const auto device = board.connect();
    const std::vector<double> before = gains(*device);
    const auto result =
        runLiveApply(*device, toRecommended(),
                     inThirdStep([&] { board.board().breakReading(devices::HtmHallReading, 1023.0); }));
    EXPECT_FALSE(result && result->apply.isKept);
    EXPECT_EQ(gains(*device), before);
    EXPECT_FALSE(board.isArmed());
}

// It confirms that the old gains are written, and has others.
TEST(LiveApply, gainsThatAreNotBackAreNotSaidToBeBack) {
    bool isDeaf = false;
    RogueBoard board(openMotor("imperfections=off&J=1.65e-3"), [&](std::vector<ParameterValue> values) {
        const bool isOld = std::any_of(values.begin(), values.end(), [](const ParameterValue& value) {
            return value.name == "gain.kp" && value.value == 10.0;
        });
        isDeaf = isDeaf || isOld;
        if (isOld) {
            std::erase_if(values, [](const ParameterValue& value) { return value.name == "gain.kp"; });
        }
        return values;
    });
    const auto result = runLiveApply(board, toRecommended(), {});
    ASSERT_TRUE(isDeaf);
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("not confirmed"), std::string::npos) << result.error().message;
}

} // namespace
} // namespace halbench::app
