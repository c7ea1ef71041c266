#include "app/cli/tuning_apply.h"
#include "app/cli/tuning_source.h"
#include "app/cli/tuning_text.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/output_file.h"
#include "app/tuning/gains_judgement.h"
#include "tests/app/documents/published_estimate.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

namespace halbench::app {
namespace {

TuneResult designed(const std::string& method) {
    TuneConfig config;
    config.method = method;
    return *runTune(published(), config);
}

ResultHeader ofGains() {
    ResultHeader header;
    header.schema = "halbench.gains/1";
    return header;
}

/// As it would be read again.
GainsFile asFile(const TuneResult& result) {
    const auto text = toJsonText(gainsDocument(ofGains(), result));
    EXPECT_TRUE(text);
    const auto file = parseGains(*text, "g.json");
    EXPECT_TRUE(file) << file.error().message;
    return *file;
}

// A file of tune's own, judged in the loop it was found for, promises what was promised when it was written.
TEST(GainsJudgement, gainsOfAFileAreJudgedAsWhenTheyWereDesigned) {
    const TuneResult own = designed("recommended");
    const auto judged = judgeGains(asFile(own), published(), own.conditions, {});
    ASSERT_TRUE(judged) << judged.error().message;
    EXPECT_EQ(*toJsonText(gainsBody(*judged)), *toJsonText(gainsBody(own)));
    EXPECT_TRUE(checkJudgement(*judged));
}

TEST(GainsJudgement, anUnstableLoopIsRefusedWhateverItsFileCallsIt) {
    GainsFile file = asFile(designed("published"));
    const LoopConditions conditions;
    file.law.gains.proportional = 100.0; // the sampled limit is 17.27 A/rad
    const auto judged = judgeGains(file, published(), conditions, {});
    ASSERT_TRUE(judged);
    EXPECT_EQ(judged->quality.verdict, Verdict::Refused);
    const auto allowed = checkJudgement(*judged);
    ASSERT_FALSE(allowed);
    EXPECT_EQ(allowed.error().code, ErrorCode::Refused);
    EXPECT_NE(allowed.error().message.find("nothing was written"), std::string::npos);
    // The preset itself, asked for by name, shows what the theory says of it: as tune --method does.
    const auto preset = judgeGains(asFile(designed("published-degrees")), published(), conditions, {});
    ASSERT_TRUE(preset);
    EXPECT_FALSE(preset->predicted.isStable);
    EXPECT_EQ(preset->quality.verdict, Verdict::Doubtful);
}

TEST(GainsJudgement, theDeviceThatTheGainsAreForIsCompared) {
    GainsFile file;
    devices::DeviceInfo here;
    here.model = "htm";
    here.id = "A7";
    EXPECT_FALSE(foreignGains(file, here)); // a file that names none
    file.device = here;
    EXPECT_FALSE(foreignGains(file, here));
    file.device->id = "B2";
    const auto found = foreignGains(file, here);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->code, "other_device");
    EXPECT_EQ(found->message, "the gains were found for the htm 'B2', this device is the htm 'A7'");
}

TEST(GainsJudgement, anotherTimingIsTold) {
    EXPECT_FALSE(otherTiming({0.01, 1}, {0.01, 1}));
    const auto found = otherTiming({0.01, 0}, {0.01, 2});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->code, "other_timing");
    TuneResult result;
    addOtherTiming(result, *found);
    EXPECT_EQ(result.warnings.size(), 1U);
    EXPECT_EQ(result.quality.findings.size(), 1U);
    EXPECT_EQ(result.quality.verdict, Verdict::Doubtful);
    result.quality.verdict = Verdict::Refused;
    addOtherTiming(result, *found);
    EXPECT_EQ(result.quality.verdict, Verdict::Refused);
    EXPECT_FALSE(otherTiming({0.01F, 1}, {0.01, 1})); // single precision on the board
}

TEST(GainsJudgement, gainsOfAnotherPeriodAreNotForTheDevice) {
    EXPECT_TRUE(checkPeriodOfGains({0.01F, 0}, {0.01, 2}));
    for (const double period_s : {0.001, 0.005, 0.0101, 0.02, 1.0}) {
        const auto fits = checkPeriodOfGains({period_s, 0}, {0.01, 0});
        ASSERT_FALSE(fits) << period_s;
        EXPECT_EQ(fits.error().code, ErrorCode::Refused);
    }
}

TEST(GainsJudgement, aNumberThatIsNoneNeverBecomesAGain) {
    const auto text = toJsonText(gainsDocument(ofGains(), designed("recommended")));
    ASSERT_TRUE(text);
    const std::size_t at = text->find("\"value\": ", text->find("\"kp\"")) + 9;
    const std::size_t end = text->find_first_of(",}\n", at);
    for (const char* number : {"NaN", "Infinity", "1e999", "null", "\"40\"", "-1e999"}) {
        std::string wrong = *text;
        wrong.replace(at, end - at, number);
        const auto file = parseGains(wrong, "g.json");
        ASSERT_FALSE(file) << number;
        EXPECT_EQ(file.error().code, ErrorCode::InvalidInput) << number;
        EXPECT_NE(file.error().message.find("g.json"), std::string::npos) << file.error().message;
    }
}

TEST(TuningText, namesTheMethodTheGainsAndTheMargins) {
    const std::string text = gainsText(designed("recommended"));
    EXPECT_EQ(text.rfind("method recommended\nkp ", 0), 0U) << text;
    EXPECT_NE(text.find("stable, gain margin"), std::string::npos);
    EXPECT_NE(text.find("in standard form           K "), std::string::npos) << text;
    EXPECT_EQ(agreementLine({}), ""); // nothing was verified
    TuneResult complex;
    complex.law.gains.proportional = 40.0;
    complex.law.gains.integral = 400.0; // T_i = 0.1 s < 4 T_d = 0.2 s
    complex.law.gains.derivative = 2.0;
    EXPECT_NE(gainsText(complex).find("in series form             none: the series form has real zeros"),
              std::string::npos);
}

class TuningParts : public testing::Test {
protected:
    Console console{ConsoleStyle{}};
    std::atomic<int> signal = 0;
    CommandContext context{{}, console, signal};
};

TEST_F(TuningParts, theSourceIsAModelFileOrNothing) {
    const auto source = sourceFromFile(context, "nowhere/m.json");
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().code, ErrorCode::FileSystem);
}

TEST_F(TuningParts, withoutApplyNoDeviceIsOpened) {
    TuningSource source;
    TuneResult result;
    EXPECT_TRUE(openToApply(context, {}, source, result));
    EXPECT_EQ(source.device, nullptr);
}

// A loop that waits two samples longer than the gains were designed for is another loop.
TEST_F(TuningParts, whatIsDesignedForNoDelayIsJudgedWithThatOfTheDevice) {
    TuningSource source;
    source.estimate = published();
    TuneResult result = designed("recommended");
    TuneOptions options;
    options.applyDevice = "sim:htm?delay_samples=2";
    const auto opened = openToApply(context, options, source, result);
    const auto has = [&](const char* code) {
        return std::any_of(result.warnings.begin(), result.warnings.end(),
                           [code](const Finding& finding) { return finding.code == code; });
    };
    EXPECT_TRUE(has("other_timing"));
    EXPECT_EQ(result.conditions.timing.delay_samples, 2);
    EXPECT_EQ(bool(opened), result.quality.verdict != Verdict::Refused);
}

// A motor that was measured with another delay: its model is not taken for this board without a word.
TEST_F(TuningParts, aModelOfAnotherTimingIsRefusedByTheDevice) {
    for (const auto& [measured, device, isSame] :
         {std::tuple(MeasuredTiming{0.01, 1}, "sim:htm?delay_samples=1", true),
          std::tuple(MeasuredTiming{0.01, 1}, "sim:htm", false),
          std::tuple(MeasuredTiming{0.01, 0}, "sim:htm?delay_samples=2", false),
          std::tuple(MeasuredTiming{0.005, 0}, "sim:htm", false),
          std::tuple(MeasuredTiming{std::nullopt, 0}, "sim:htm", true)}) {
        TuningSource source;
        source.estimate = published();
        source.estimate.timing = measured;
        TuneResult result = designed("recommended");
        TuneOptions options;
        options.applyDevice = device;
        const auto opened = openToApply(context, options, source, result);
        EXPECT_EQ(bool(opened), isSame) << device;
        if (!opened) {
            EXPECT_EQ(opened.error().code, ErrorCode::Refused);
            EXPECT_NE(opened.error().message.find("samples of delay"), std::string::npos)
                << opened.error().message;
        }
    }
}

} // namespace
} // namespace halbench::app
