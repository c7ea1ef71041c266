#include "app/cli/relay_options.h"
#include "app/documents/relay_document.h"

#include <gtest/gtest.h>

namespace halbench::app {

namespace {

RelayResult result() {
    RelayResult result;
    result.delaySamples = 1;
    result.plan.predicted.at = {16.3, 20.5};
    result.plan.predicted.gain95 = std::pair(15.0, 17.5);
    result.agreement = RelayAgreement::Agrees;
    result.cycle.plant = {-0.06, 0.001};
    result.ultimate.emplace();
    result.ultimate->at = {16.25, 20.48};
    result.ultimate->gain95 = {15.9, 16.6};
    result.ultimate->period95_s = {0.305, 0.309};
    return result;
}

std::string written(const RelayResult& result) {
    ResultHeader header;
    header.schema = "halbench.relay/1";
    return *toJsonText(relayDocument(header, result));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

} // namespace

TEST(RelayFile, readsBackWhatWasWritten) {
    const auto file = parseRelay(written(result()), "r.json");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_DOUBLE_EQ(file->ultimateGain_A_per_rad, 16.25);
    EXPECT_NEAR(file->ultimatePeriod_s, 2.0 * 3.14159265358979 / 20.48, 1e-12);
    EXPECT_EQ(file->timing.delay_samples, 1);
    EXPECT_EQ(file->timing.period_s, 0.01);
    EXPECT_NE(written(result()).find("\"agreement\": \"agrees\""), std::string::npos);
}

TEST(RelayFile, refusesWhatIsNoExperimentAndNamesThePlace) {
    const std::string good = written(result());
    const auto place = [](const std::string& text) {
        const auto file = parseRelay(text, "r.json");
        return file ? std::string() : file.error().message;
    };
    EXPECT_NE(place("{").find("r.json"), std::string::npos);
    EXPECT_NE(place(replaced(good, "halbench.relay/1", "halbench.gains/1")).find("schema"),
              std::string::npos);
    EXPECT_NE(place(replaced(good, "\"value\": 16.25", "\"value\": -1")).find("ultimate_gain"),
              std::string::npos);
    EXPECT_NE(place(replaced(good, "\"delay_samples\": 1", "\"delay\": 1")).find("delay_samples"),
              std::string::npos);
    RelayResult refused = result();
    refused.ultimate.reset();
    refused.quality.verdict = Verdict::Refused;
    EXPECT_EQ(parseRelay(written(refused), "r.json").error().code, ErrorCode::Refused);
    EXPECT_EQ(readRelayFile("no-such-file.json").error().code, ErrorCode::FileSystem);
}

TEST(RelayOptions, readsEveryOption) {
    IdentifyOptions options;
    const Result<RelayConfig> plain = relayConfigFrom(options);
    ASSERT_TRUE(plain);
    EXPECT_EQ(plain->cycles, 100);
    EXPECT_FALSE(plain->base_rad_s || plain->limit_A || plain->gain_A_per_rad || plain->motor);
    options.base = "-6";
    options.relay.current = "3.2";
    options.relay.gain = "24";
    options.relay.cycles = "60";
    const Result<RelayConfig> config = relayConfigFrom(options);
    ASSERT_TRUE(config) << config.error().message;
    EXPECT_EQ(config->base_rad_s, -6.0);
    EXPECT_EQ(config->limit_A, 3.2);
    EXPECT_EQ(config->gain_A_per_rad, 24.0);
    EXPECT_EQ(config->cycles, 60);
    options.relay.cycles = "60.5";
    EXPECT_EQ(relayConfigFrom(options).error().code, ErrorCode::Usage);
    options.relay.cycles = "60";
    options.relay.model = "no-such-file.json";
    EXPECT_EQ(relayConfigFrom(options).error().code, ErrorCode::FileSystem);
}

TEST(RelayOptions, belongToTheRelayAlone) {
    IdentifyOptions options;
    EXPECT_TRUE(checkRelayOptions(options));
    options.relay.cycles = "60";
    EXPECT_EQ(checkRelayOptions(options).error().code, ErrorCode::Usage);
    options.isRelay = true;
    EXPECT_TRUE(checkRelayOptions(options));
    options.base = "6";
    EXPECT_TRUE(checkRelayOptions(options));
    options.frequency.to = "20";
    const Result<void> mixed = checkRelayOptions(options);
    ASSERT_FALSE(mixed);
    EXPECT_NE(mixed.error().message.find("--to-hz"), std::string::npos);
    options.frequency = {};
    options.frequency.effortRatio = "0.2";
    EXPECT_EQ(checkRelayOptions(options).error().code, ErrorCode::Usage);
}

TEST(RelayOptions, thePlanSaysWhatMovesHowFarAndHowLong) {
    RelayPlan plan;
    plan.turn_rad_s = 6.0;
    plan.runUp_s = 5.0;
    plan.measured_s = 35.0;
    plan.limit_A = 3.2;
    const std::string text = relayPlanText(plan);
    for (const char* part : {"6 rad/s", "40 s", "38.2 turns", "3.2 A"}) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    }
}

} // namespace halbench::app
