#include "app/procedures/apply/apply_procedure.h"
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

MotorEstimate motor(double inertia_kg_m2 = 5.5e-4) {
    MotorEstimate estimate;
    estimate.values = {{"J", inertia_kg_m2}, {"c", 1.23e-3}, {"Kf", 2.05e-2}, {"phi", 1.43e-2}};
    return estimate;
}

ApplyConfig recommendedWith(devices::Device& device, const MotorEstimate& estimate) {
    ApplyConfig config;
    config.values =
        positionLawValues(device.catalogue(), models::recommendedLaw(models::RotorConfig{}, 1.43e-2));
    config.verification.emplace();
    config.verification->reference.amplitude = degreesToRadians(100);
    config.verification->motor = estimate;
    return config;
}

TEST(Apply, keepsGainsThatMoveAsPredicted) {
    for (const char* query : {"imperfections=off", "seed=1", "seed=2", "seed=3"}) {
        const auto device = openMotor(query);
        const auto result = runApply(*device, recommendedWith(*device, motor()), {});
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_TRUE(result->isKept) << query;
        ASSERT_TRUE(result->predicted);
        EXPECT_NEAR(result->predicted->overshoot_percent.value_or(0), 7.5, 1.0); // section 8.4
        EXPECT_FLOAT_EQ(static_cast<float>(parameter(*device, "gain.kp")), 40.0F);
        EXPECT_EQ(parameter(*device, "window.position_enabled"), 0.0);
        EXPECT_FALSE(device->state().isArmed);
    }
}

// What is told before the move is what the board is given.
TEST(Apply, saysBeforehandHowFarItsMoveMayGo) {
    const auto device = openMotor("imperfections=off");
    ApplyConfig config = recommendedWith(*device, motor());
    config.verification = stepVerification(motor());
    const MoveOutlook outlook = verificationOutlook(*config.verification, device->catalogue());
    double window_rad = 0.0;
    double speed_rad_s = 0.0;
    double farthest_rad = 0.0;
    ProcedureObserver observer;
    observer.onProgress = [&](double, const std::string& text) {
        if (text == "move running") {
            window_rad =
                parameter(*device, "window.position_enabled") * parameter(*device, "window.position");
            speed_rad_s = parameter(*device, "window.speed");
        }
    };
    const auto result = runApply(*device, config, observer);
    ASSERT_TRUE(result && result->verification) << result.error().message;
    const Recording& seen = result->verification->recording;
    for (const double reference_rad : seen.column("reference")) {
        farthest_rad = std::max(farthest_rad, std::abs(reference_rad - seen.column("position").front()));
    }
    EXPECT_NEAR(outlook.excursion_rad, farthest_rad, 2e-3); // the angle's noise at its start
    EXPECT_NEAR(outlook.window_rad, window_rad, 1e-6);      // single precision on the board
    EXPECT_NEAR(outlook.speedLimit_rad_s, speed_rad_s, 1e-6);
    EXPECT_GE(outlook.armed_s, seen.time_s.back());
    EXPECT_LE(outlook.armed_s, seen.time_s.back() + 0.1);
}

// The same numbers from the curves themselves, on the samples that both have.
TEST(Apply, saysHowFarTheMoveWasFromItsPrediction) {
    const auto device = openMotor("imperfections=off");
    const auto result = runApply(*device, recommendedWith(*device, motor()), {});
    ASSERT_TRUE(result && result->band) << result.error().message;
    const VerificationBand& band = *result->band;
    // 1.15 K_f/phi less the 0.9 K_f/phi of the assist, over 40 A/rad: 0.25 1.434/40 rad.
    EXPECT_NEAR(band.friction_rad, 0.25 * 2.05e-2 / 1.43e-2 / 40.0, 1e-4);
    EXPECT_NEAR(band.allowed_rad, 0.02 + std::max(band.friction_rad, std::abs(result->predicted->finalError)),
                1e-12);
    EXPECT_NEAR(*band.allowedOvershoot_percent, *result->predicted->overshoot_percent + 8.0, 1e-12);
    const std::vector<double> position = result->verification->recording.column("position");
    double largest = 0.0;
    for (std::size_t i = 0; i < position.size(); ++i) {
        const auto row =
            static_cast<std::size_t>(std::lround(1000.0 * result->verification->recording.time_s[i]));
        if (row < band.predicted.angle_rad.size()) {
            largest = std::max(largest, std::abs(position[i] - position[0] - band.predicted.angle_rad[row]));
        }
    }
    // A millisecond at the fastest, some 15 rad/s, is between the two ways to compare.
    EXPECT_NEAR(std::abs(band.largestOff_rad), largest, 0.015);
    EXPECT_LT(std::abs(band.largestOff_rad), 0.2); // of a step of 1.75 rad, on a motor as predicted
    EXPECT_GT(band.largestOffTime_s, 0.0);
    EXPECT_EQ(band.predicted.reference_rad.back(), degreesToRadians(100));
}

TEST(Apply, restoresTheOldGainsWhenTheMotorMovesUnlikeThePrediction) {
    // The estimate says less than a quarter of the true inertia: the real step overshoots far more than
    // predicted.
    const auto device = openMotor("imperfections=off&J=2.5e-3");
    const auto result = runApply(*device, recommendedWith(*device, motor()), {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_FALSE(result->isKept);
    EXPECT_EQ(result->quality.verdict, Verdict::Refused);
    ASSERT_FALSE(result->quality.findings.empty());
    EXPECT_EQ(result->quality.findings[0].code, "verification_failed");
    EXPECT_EQ(parameter(*device, "gain.kp"), 10.0);
    EXPECT_EQ(parameter(*device, "gain.kd"), 0.0);
}

/// As `tune --apply` does with the gains that are recommended for the model.
ApplyConfig tunedWith(devices::Device& device, const MotorEstimate& estimate) {
    ApplyConfig config = recommendedWith(device, estimate);
    config.verification = stepVerification(estimate);
    return config;
}

bool hasLeftBand(const ApplyResult& result) {
    const auto& findings = result.quality.findings;
    return std::any_of(findings.begin(), findings.end(),
                       [](const Finding& finding) { return finding.code == "left_predicted_band"; });
}

// The step of each ends near its prediction; on its way it is what its acceleration 4 A phi/J and its
// friction make of it. With 0.15 of the inertia the largest pole of the loop lies at 1.2.
TEST(Apply, aMotorThatIsNotTheModelGetsItsOldGainsBack) {
    for (const char* query :
         {"imperfections=off&J=2.75e-4", "imperfections=off&J=8.25e-5", "imperfections=off&J=1.1e-3",
          "imperfections=off&phi=2.2e-2", "imperfections=off&phi=0.9e-2", "imperfections=off&Kf=3.5e-2",
          "seed=2&J=2.75e-4", "seed=3&J=8.25e-5", "seed=4&phi=2.2e-2"}) {
        for (const MotorEstimate& estimate : {uncertainMotor(0.02), motor()}) {
            const auto device = openMotor(query);
            const auto result = runApply(*device, tunedWith(*device, estimate), {});
            ASSERT_TRUE(result) << query << ": " << result.error().message;
            EXPECT_FALSE(result->isKept) << query;
            EXPECT_TRUE(hasLeftBand(*result)) << query;
            EXPECT_EQ(result->quality.verdict, Verdict::Refused) << query;
            ASSERT_TRUE(result->band) << query;
            EXPECT_EQ(parameter(*device, "gain.kp"), 10.0) << query;
            EXPECT_EQ(parameter(*device, "gain.kd"), 0.0) << query;
        }
    }
}

// A model that is as wrong as it says is one whose motor moves within its band: two of its sigma here.
TEST(Apply, aHealthyMotorKeepsItsGains) {
    for (int seed = 1; seed <= 8; ++seed) {
        for (const MotorEstimate& estimate : {uncertainMotor(0.02, {2.0, -2.0, 2.0}), uncertainMotor(0.005),
                                              uncertainMotor(0.02, {-2.0, 2.0, -2.0}), motor()}) {
            const auto device = openMotor("seed=" + std::to_string(seed));
            const auto result = runApply(*device, tunedWith(*device, estimate), {});
            ASSERT_TRUE(result) << seed << ": " << result.error().message;
            EXPECT_TRUE(result->isKept)
                << seed << ": "
                << (result->quality.findings.empty() ? std::string()
                                                     : result->quality.findings.front().message);
            EXPECT_LE(result->band->widening_ratio, 1.0) << seed;
        }
    }
}

/// Applies while the samples between two shares of the move do not arrive.
Result<ApplyResult> applyUnseen(double from_ratio, double to_ratio) {
    FaultyMotor motorAndLink("imperfections=off");
    const auto device = motorAndLink.connect();
    ProcedureObserver observer;
    observer.onProgress = [&](double share, const std::string& text) {
        if (text != "move running") {
            return;
        }
        motorAndLink.faults().alterReceived = nullptr;
        if (share < from_ratio || share > to_ratio) {
            return;
        }
        motorAndLink.faults().alterReceived = [](std::vector<std::uint8_t>& packet) {
            constexpr std::uint8_t FirstAnswer = 0xFC;
            if (packet.front() < FirstAnswer) { // samples: a service packet comes in their place
                packet = {FirstAnswer, 0x01, 0x20, 0x00};
            }
        };
    };
    auto result = runApply(*device, recommendedWith(*device, motor()), observer);
    EXPECT_EQ(parameter(*device, "gain.kp"), result && result->isKept ? 40.0 : 10.0);
    return result;
}

TEST(Apply, aMoveOfWhichMuchWasNotSeenVerifiesNothing) {
    for (const auto& [from_ratio, to_ratio] : {std::pair{0.6, 1.0}, std::pair{0.05, 0.2}}) {
        const auto result = applyUnseen(from_ratio, to_ratio);
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_FALSE(result->isKept) << from_ratio;
        const auto& findings = result->quality.findings;
        EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
            return finding.code == "verification_incomplete";
        })) << from_ratio;
    }
    const auto seen = applyUnseen(2.0, 2.0);
    ASSERT_TRUE(seen) << seen.error().message;
    EXPECT_TRUE(seen->isKept) << "the same with nothing missing";
}

TEST(Apply, restoresTheOldGainsWhenTheNewOnesAreUnstable) {
    const auto device = openMotor("imperfections=off&Kf=0&delay_samples=2");
    ApplyConfig config = recommendedWith(*device, motor());
    config.values = {{"gain.kp", 100.0}};
    const auto result = runApply(*device, config, {});
    EXPECT_FALSE(result && result->isKept);
    EXPECT_EQ(parameter(*device, "gain.kp"), 10.0);
    EXPECT_FALSE(device->state().isArmed);
}

TEST(Apply, withoutVerificationWritesAndReadsBack) {
    const auto device = openMotor("");
    ApplyConfig config;
    config.values = {{"gain.kp", 8.684}, {"gain.ki", 3.776}};
    const auto result = runApply(*device, config, {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->isKept);
    EXPECT_EQ(result->before[0].value, 10.0);
    EXPECT_NEAR(result->after[0].value, 8.684, 1e-6); // single precision
    EXPECT_NEAR(parameter(*device, "gain.ki"), 3.776, 1e-6);
}

TEST(Apply, refusesBadValuesBeforeTheFirstOneIsWritten) {
    const auto device = openMotor("");
    const std::pair<ParameterValue, ErrorCode> cases[] = {
        {{"gain.ki", std::numeric_limits<double>::quiet_NaN()}, ErrorCode::NotFinite},
        {{"gain.ki", -1.0}, ErrorCode::OutOfRange},
        {{"limit.current", 5.0}, ErrorCode::OutOfRange},
        {{"gain.kx", 1.0}, ErrorCode::UnknownName}};
    for (const auto& [bad, code] : cases) {
        ApplyConfig config;
        config.values = {{"gain.kp", 20.0}, bad};
        const auto result = runApply(*device, config, {});
        ASSERT_FALSE(result) << bad.name;
        EXPECT_EQ(result.error().code, code);
        EXPECT_EQ(parameter(*device, "gain.kp"), 10.0);
    }
}

TEST(Apply, abortRestoresTheOldGains) {
    const auto device = openMotor("");
    bool isVerifying = false;
    ProcedureObserver observer;
    observer.onState = [&](ProcedureState state) {
        isVerifying = isVerifying || state == ProcedureState::Verify;
    };
    observer.checkAbort = [&]() -> Result<void> {
        return isVerifying ? Result<void>(failure(ErrorCode::Interrupted, "aborted")) : Result<void>();
    };
    const auto result = runApply(*device, recommendedWith(*device, motor()), observer);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Interrupted);
    EXPECT_EQ(parameter(*device, "gain.kp"), 10.0);
    EXPECT_FALSE(device->state().isArmed);
}

TEST(Apply, anAbortWhoseRestoreTheBoardDoesNotConfirmIsNotOnlyAnAbort) {
    FaultyMotor board("seed=1");
    const auto device = board.connect();
    bool isVerifying = false;
    ProcedureObserver observer;
    observer.onState = [&](ProcedureState state) {
        isVerifying = isVerifying || state == ProcedureState::Verify;
    };
    observer.checkAbort = [&]() -> Result<void> {
        if (!isVerifying) {
            return {};
        }
        board.faults().isUnplugged = true; // the cable is pulled in the same moment
        return failure(ErrorCode::Interrupted, "cancelled by the user", "old gains restored");
    };
    const auto result = runApply(*device, recommendedWith(*device, motor()), observer);
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().code, ErrorCode::Interrupted);
    EXPECT_NE(result.error().message.find("not confirmed"), std::string::npos) << result.error().message;
    EXPECT_EQ(result.error().hint.find("restored"), std::string::npos) << result.error().hint;
}

TEST(RestoreGuard, putsEveryTransactionalParameterBack) {
    const auto device = openMotor("");
    {
        const auto guard = RestoreGuard::take(*device);
        ASSERT_TRUE(guard);
        EXPECT_GT(guard->snapshot().size(), 30U);
        setParameter(*device, "gain.kp", 33.0);
        setParameter(*device, "window.speed", 5.0);
    }
    EXPECT_EQ(parameter(*device, "gain.kp"), 10.0);
    EXPECT_EQ(parameter(*device, "window.speed"), 40.0);
}

TEST(RestoreGuard, keepsWhatIsToBeKeptButDisarms) {
    const auto device = openMotor("");
    {
        auto guard = RestoreGuard::take(*device);
        ASSERT_TRUE(guard);
        setParameter(*device, "gain.kp", 33.0);
        setParameter(*device, "hb.mode", 2.0);
        ASSERT_TRUE(device->arm());
        guard->keep();
    }
    EXPECT_EQ(parameter(*device, "gain.kp"), 33.0);
    EXPECT_FALSE(device->state().isArmed);
}

/// Counts how often the gains are read.
class CountingBoard final : public RogueBoard {
public:
    explicit CountingBoard(std::unique_ptr<devices::Device> device)
        : RogueBoard(std::move(device), [](std::vector<ParameterValue> values) { return values; }) {}

    Result<std::vector<double>> readParameters(std::span<const std::string> names) override {
        m_reads += std::find(names.begin(), names.end(), "gain.kp") != names.end() ? 1 : 0;
        return RogueBoard::readParameters(names);
    }
    int reads() const { return m_reads; }

private:
    int m_reads = 0;
};

TEST(Apply, readsTheGainsOnceBeforeAndOnceAfterItWrites) {
    CountingBoard board(openMotor("imperfections=off"));
    ApplyConfig config = recommendedWith(board, motor());
    config.verification.reset(); // its move is a procedure of its own
    const auto result = runApply(board, config, {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->isKept);
    EXPECT_EQ(board.reads(), 2);
    ASSERT_EQ(result->before.size(), config.values.size());
    for (std::size_t i = 0; i < config.values.size(); ++i) {
        EXPECT_EQ(result->before[i].name, config.values[i].name);
    }
}

} // namespace
} // namespace halbench::app
