#include "app/documents/document_parts.h"
#include "app/documents/filtered_gains.h"

#include <gtest/gtest.h>

#include <string>

namespace halbench::app {
namespace {

std::string
gainsWith(const std::string& shaping, const std::string& form = "parallel",
          const std::string& numbers = R"("kp": {"value": 12}, "ki": {"value": 20}, "kd": {"value": 0.8})") {
    return R"({"schema": "halbench.gains/1", "form": ")" + form +
           R"(", "sample_period_s": 0.01, "delay_samples": 1, "gains": {)" + numbers +
           (shaping.empty() ? "" : ", " + shaping) + "}}";
}

constexpr const char* Everything = R"("filter_s": {"value": 0.004}, "setpoint_weights": {"b": 0.6, "c": 0.25},
  "filters": [{"kind": "notch", "frequency_rad_s": 180, "depth_ratio": 0.1, "damping_ratio": 0.5},
              {"kind": "low-pass", "corner_rad_s": 250, "order": 2},
              {"kind": "lead", "frequency_rad_s": 40, "phase_deg": 15},
              {"kind": "lag", "frequency_rad_s": 2, "ratio": 1.5}])";

TEST(FilteredGains, readWhatTheFileAsksFor) {
    const auto file = parseFilteredGains(gainsWith(Everything), "g.json");
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_TRUE(file->filtered);
    EXPECT_EQ(file->filtered->proportionalWeight, 0.6);
    EXPECT_EQ(file->filtered->derivativeWeight, 0.25);
    EXPECT_EQ(file->filtered->gains.filter_s, 0.004);
    const std::vector<control::LoopFilter> expected = {
        control::NotchFilter{180.0, 0.1, 0.5}, control::LowPassFilter{250.0, 2},
        control::LeadFilter{40.0, 15.0}, control::LagFilter{2.0, 1.5}};
    EXPECT_EQ(file->filtered->filters, expected);
    EXPECT_EQ(file->law.gains.proportional, 12.0);
    EXPECT_FALSE(file->law.gains.filter_s);
    EXPECT_EQ(file->timing.delay_samples, 1);
}

TEST(FilteredGains, whatTheyWriteReadsBack) {
    const auto file = parseFilteredGains(gainsWith(Everything), "g.json");
    ASSERT_TRUE(file && file->filtered);
    JsonValue document = *parseJson(gainsWith(R"("filter_s": {"value": 0.004})"), "g.json");
    setShaping(document, *file->filtered);
    const auto again = parseFilteredGains(*toJsonText(document), "g.json");
    ASSERT_TRUE(again && again->filtered);
    EXPECT_EQ(*again->filtered, *file->filtered);
    const std::string lines = shapingLines(*file->filtered);
    for (const char* word : {"b 0.6, c 0.25", "0.004 s", "notch", "corner_rad_s 250", "ratio 1.5"}) {
        EXPECT_NE(lines.find(word), std::string::npos) << word << "\n" << lines;
    }
}

// Where the file asks for nothing more, the gains are the board's and may be applied.
TEST(FilteredGains, theBoardsLawIsNotFiltered) {
    for (const char* shaping : {"", R"("filter_s": null)", R"("filter_s": {"value": 0}, "filters": [])",
                                R"("setpoint_weights": {"b": 1, "c": 0})"}) {
        const auto file = parseFilteredGains(gainsWith(shaping), "g.json");
        ASSERT_TRUE(file) << shaping;
        EXPECT_FALSE(file->filtered) << shaping;
        EXPECT_EQ(file->law.gains, parseGains(gainsWith(""), "g.json")->law.gains);
    }
}

// K (1 + 1/(T_i s))(1 + T_d s/(1 + T_f s)): K_D = K T_d (1 - T_f/T_i).
TEST(FilteredGains, inTheSeriesFormTheFilterReachesIntoTheGains) {
    const auto file =
        parseFilteredGains(gainsWith(R"("filter_s": {"value": 0.1})", "series",
                                     R"("k": {"value": 10}, "ti": {"value": 0.5}, "td": {"value": 0.06})"),
                           "g.json");
    ASSERT_TRUE(file && file->filtered);
    EXPECT_NEAR(file->filtered->gains.derivative, 10.0 * 0.06 * (1.0 - 0.1 / 0.5), 1e-12);
    EXPECT_NEAR(file->law.gains.derivative, file->filtered->gains.derivative, 1e-15);
}

TEST(FilteredGains, mistakesNameFileAndKey) {
    struct Wrong {
        const char* shaping;
        const char* word;
    };
    for (const Wrong& wrong :
         {Wrong{R"("filters": {})", "gains.filters"},
          Wrong{R"("filters": [{"kind": "comb"}])", "gains.filters[0].kind"},
          Wrong{R"("filters": [{"kind": "lag", "ratio": 2}])", "gains.filters[0].frequency_rad_s"},
          Wrong{R"("filters": [{"kind": "lag", "frequency_rad_s": 2, "ratio": 2, "q": 1}])", "filters[0].q"},
          Wrong{R"("filters": [{"kind": "low-pass", "corner_rad_s": 20, "order": 1.5}])", "g.json: gains"},
          Wrong{R"("filters": [{"kind": "low-pass", "corner_rad_s": "x", "order": 1}])", "corner_rad_s"},
          Wrong{R"("setpoint_weights": {"a": 1})", "gains.setpoint_weights.a"},
          Wrong{R"("setpoint_weights": 1)", "gains.setpoint_weights"},
          Wrong{R"("setpoint_weights": {"b": 2})", "g.json: gains"},
          Wrong{R"("filter_s": {"value": "x"})", "gains.filter_s.value"},
          Wrong{R"("setpoint": {"b": 1})", "gains.setpoint"}}) {
        const auto file = parseFilteredGains(gainsWith(wrong.shaping), "g.json");
        ASSERT_FALSE(file) << wrong.shaping;
        EXPECT_NE(file.error().message.find(wrong.word), std::string::npos) << file.error().message;
        EXPECT_NE(file.error().message.find("g.json"), std::string::npos) << file.error().message;
    }
}

// The window and every reader that knows the board's law only refuse such a file.
TEST(FilteredGains, areRefusedWhereOnlyTheBoardsLawIsKnown) {
    for (const char* shaping : {R"("filter_s": {"value": 0.004})", R"("setpoint_weights": {"b": 0.6})",
                                R"("filters": [{"kind": "lag", "frequency_rad_s": 2, "ratio": 2}])"}) {
        EXPECT_FALSE(parseGains(gainsWith(shaping), "g.json")) << shaping;
    }
    // Written again by tune, the file would ask for the same.
    const Error weights = parseGains(gainsWith(R"("setpoint_weights": {"b": 0.6})"), "g.json").error();
    EXPECT_NE(weights.hint.find("halbench analyse"), std::string::npos) << weights.hint;
    EXPECT_EQ(weights.hint.find("--out"), std::string::npos) << weights.hint;
}

} // namespace
} // namespace halbench::app
