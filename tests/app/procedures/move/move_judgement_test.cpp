#include "app/procedures/move/move_judgement.h"
#include "tests/app/procedures/faulty_motor.h"
#include "tests/app/procedures/simulated_motor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

/// A rotor that does what the board's reference says, which the test may bend.
template <typename Bend>
MoveResponse perfectResponse(const MoveConfig& config, Bend bend) {
    MoveResponse response;
    for (int i = 0; i <= std::lround(config.duration_s * 1000.0); ++i) {
        const double sampled_s = 0.01 * (i / 10); // held for a period of the loop
        response.time_s.push_back(i * 1e-3);
        response.reference.push_back(bend(sampled_s, referenceAt(config.reference, sampled_s).value_or(0.0)));
        response.position.push_back(response.reference.back());
    }
    return response;
}

std::string codesOf(const DataQuality& quality) {
    std::string codes;
    for (const Finding& finding : quality.findings) {
        codes += finding.code + ' ';
    }
    return codes;
}

const char* const References[] = {"step,amplitude_deg=60",
                                  "step,amplitude_deg=-0.5,base_deg_s=10",
                                  "ramp,rate_deg_s=-90,amplitude_deg=45",
                                  "ramp,rate_deg_s=720",
                                  "sine,amplitude_deg=360,frequency_hz=3",
                                  "staircase,amplitude_deg=30,period_s=0.3,count=4"};

TEST(MoveJudgement, findsNothingAgainstABoardThatDoesWhatItIsTold) {
    for (const char* reference : References) {
        const MoveConfig config = move(reference, 2.0);
        const auto asCommanded = [](double, double value_rad) { return value_rad; };
        const DataQuality quality = judgeMotion(perfectResponse(config, asCommanded), config, 0, 0.0);
        EXPECT_EQ(quality.verdict, Verdict::Good) << reference << ": " << codesOf(quality);
    }
}

TEST(MoveJudgement, refusesAReferenceThatBeganTwice) {
    // As a start that came twice: from half a second on it counts anew from where it was.
    for (const char* reference : References) {
        const MoveConfig config = move(reference, 2.0);
        const auto twice = [&config](double time_s, double value_rad) {
            return time_s < 0.5
                       ? value_rad
                       : *referenceAt(config.reference, 0.5) + *referenceAt(config.reference, time_s - 0.5);
        };
        // The endless ramp goes on as before: nothing differs, and nothing went wrong.
        const bool goesOn = std::string(reference) == "ramp,rate_deg_s=720";
        // The sine of 3 Hz is 1.5 periods old then, so that it goes the other way.
        const DataQuality quality = judgeMotion(perfectResponse(config, twice), config, 0, 0.0);
        EXPECT_EQ(quality.verdict, goesOn ? Verdict::Good : Verdict::Refused) << reference;
        EXPECT_EQ(codesOf(quality).find("reference_differs") == std::string::npos, goesOn) << reference;
    }
}

TEST(MoveJudgement, doubtsARotorThatEndedFarFromItsReference) {
    const MoveConfig config = move("step,amplitude_deg=60", 1.0);
    MoveResponse response = perfectResponse(config, [](double, double value_rad) { return value_rad; });
    response.position.back() = degreesToRadians(35.0);
    EXPECT_EQ(judgeMotion(response, config, 0, 0.0).verdict, Verdict::Good) << "friction may be strong";
    for (const double end_deg : {0.0, 29.0, 91.0, 120.0}) {
        response.position.back() = degreesToRadians(end_deg);
        const DataQuality quality = judgeMotion(response, config, 0, 0.0);
        EXPECT_EQ(quality.verdict, Verdict::Doubtful) << end_deg;
        EXPECT_EQ(codesOf(quality), "ended_elsewhere ");
    }
}

TEST(MoveJudgement, allowsForAFloatFarFromZeroAndForLostRows) {
    const MoveConfig config = move("step,amplitude_deg=60", 1.0);
    const auto coarse = [](double, double value_rad) { return value_rad + 0.003; };
    EXPECT_EQ(judgeMotion(perfectResponse(config, coarse), config, 0, 50000.0).verdict, Verdict::Good);
    EXPECT_EQ(judgeMotion(perfectResponse(config, coarse), config, 0, 1.0).verdict, Verdict::Refused);
    const MoveConfig stairs = move("staircase,amplitude_deg=30,period_s=0.3,count=4", 1.0);
    const auto late = [&stairs](double time_s, double) {
        return *referenceAt(stairs.reference, std::max(0.0, time_s - 0.05));
    };
    EXPECT_EQ(codesOf(judgeMotion(perfectResponse(stairs, late), stairs, 50, 0.0)), "rows_lost ");
    EXPECT_EQ(codesOf(judgeMotion(perfectResponse(stairs, late), stairs, 0, 0.0)), "reference_differs ");
}

TEST(MoveJudgement, aMoveOnALineThatLosesOneMessageInFiftyEndsWhereItShould) {
    int repeated = 0;
    // Seeds of lines that lose no message three times in a row, which ends a session: once in 16000 messages.
    for (const int seed : {1, 3, 4, 5, 6}) {
        FaultyMotor motor("imperfections=off&seed=" + std::to_string(seed), static_cast<std::uint64_t>(seed));
        const auto device = motor.connect();
        ASSERT_TRUE(device);
        motor.faults().dropReceived_ratio = motor.faults().dropSent_ratio = 0.02;
        const auto result = runMove(*device, move("step,amplitude_deg=60", 2.0), {});
        ASSERT_TRUE(result) << seed << ": " << result.error().message;
        EXPECT_EQ(codesOf(result->quality), "rows_lost ") << seed;
        // friction holds these gains up to 8 degrees away; a second start would end 60 degrees away
        EXPECT_LT(std::fabs(radiansToDegrees(result->figures().finalError)), 8.0) << seed;
        repeated += static_cast<int>(device->statistics().commandsRepeated);
        motor.repair();
    }
    EXPECT_GT(repeated, 5) << "else nothing was shown";
}

} // namespace
} // namespace halbench::app
