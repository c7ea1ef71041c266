#include "app/documents/model_file.h"
#include "app/documents/result_documents.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

const std::string Model = R"({"schema": "halbench.identification/1", "seed": 7,
  "device": {"model": "htm", "id": "sim-htm-1", "firmware": "x", "simulated": true, "overrides": {}},
  "data_quality": {"verdict": "good", "findings": []},
  "parameters": {"viscous_damping": {"value": 1.23e-3}, "coulomb_friction": {"value": null},
                 "torque_constant": {"value": null}, "inertia": {"value": 5.5e-4}},
  "ratios": {"c_over_J": {"value": 2.236}, "Kf_over_J": {"value": 37.0}, "phi_over_J": {"value": 26.0},
             "c_over_phi": {"value": 0.08}, "Kf_over_phi": {"value": 1.4}},
  "covariance": {"names": ["a", "b"], "matrix": [[1, 0.5], [0.5, 2]]}})";

const std::string Gains = R"({"schema": "halbench.gains/1", "form": "parallel", "sample_period_s": 0.01,
  "delay_samples": 1,
  "gains": {"kp": {"value": 40}, "ki": {"value": 60}, "kd": {"value": 1.4}, "filter_s": null,
            "feedforward_inertia": {"value": 0.04}}})";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t place = text.find(what);
    EXPECT_NE(place, std::string::npos) << what;
    return text.replace(place, what.size(), with);
}

TEST(ModelFile, keepsWhatIsKnownAndLeavesOutWhatIsNot) {
    const Result<ModelFile> model = parseModel(Model, "m.json");
    ASSERT_TRUE(model.has_value()) << model.error().message;
    EXPECT_EQ(model->estimate.values.at("J"), 5.5e-4);
    EXPECT_EQ(model->estimate.values.at("phi_over_J"), 26.0);
    EXPECT_EQ(model->estimate.values.count("Kf"), 0U);
    EXPECT_EQ(model->estimate.covariance.at(0).at(1), 0.5);
    EXPECT_EQ(model->seed, 7U);
    EXPECT_EQ(model->device->model, "htm");
}

TEST(ModelFile, mistakesNameFileAndKey) {
    struct Wrong {
        const char* what;
        const char* with;
        const char* word;
    };
    for (const Wrong& wrong :
         {Wrong{"identification/1", "identification/2", "schema"},
          Wrong{"identification/1", "gains/1", "schema"},
          Wrong{"\"inertia\"", "\"inertias\"", "parameters.inertia"},
          Wrong{"5.5e-4", "\"5.5e-4\"", "parameters.inertia.value"},
          Wrong{"[[1, 0.5], ", "[[1], ", "covariance"}, Wrong{"[\"a\", \"b\"]", "[\"a\"]", "covariance"},
          Wrong{"\"seed\": 7", "\"seed\": \"x\"", "seed"}}) {
        const Result<ModelFile> model = parseModel(replaced(Model, wrong.what, wrong.with), "m.json");
        ASSERT_FALSE(model.has_value()) << wrong.with;
        EXPECT_EQ(model.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(model.error().message.find("m.json"), std::string::npos);
        EXPECT_NE(model.error().message.find(wrong.word), std::string::npos) << model.error().message;
        EXPECT_FALSE(model.error().hint.empty());
    }
}

TEST(ModelFile, theTimingIsReadWhereTheFileHasIt) {
    const Result<ModelFile> old = parseModel(Model, "m.json");
    ASSERT_TRUE(old.has_value()) << old.error().message;
    EXPECT_EQ(old->estimate.timing, MeasuredTiming{}); // of an older version
    const auto with = [](const std::string& more) {
        return parseModel(replaced(Model, "\"seed\": 7,", "\"seed\": 7, " + more + ","), "m.json");
    };
    EXPECT_EQ(with(R"("sample_period_s": 0.005, "delay_samples": 2)")->estimate.timing,
              (MeasuredTiming{0.005, 2}));
    EXPECT_EQ(with(R"("sample_period_s": null, "delay_samples": null)")->estimate.timing, MeasuredTiming{});
    for (const auto& [wrong, key] : {std::pair(R"("sample_period_s": 0)", "sample_period_s"),
                                     std::pair(R"("sample_period_s": "10 ms")", "sample_period_s"),
                                     std::pair(R"("delay_samples": 3)", "delay_samples"),
                                     std::pair(R"("delay_samples": 0.5)", "delay_samples"),
                                     std::pair(R"("delay_samples": -1)", "delay_samples")}) {
        const auto model = with(wrong);
        ASSERT_FALSE(model.has_value()) << wrong;
        EXPECT_EQ(model.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(model.error().message.find(key), std::string::npos) << model.error().message;
    }
}

TEST(ModelFile, constantsBelowZeroAreNoMotor) {
    struct Wrong {
        const char* what;
        const char* with;
        const char* word;
    };
    for (const Wrong& wrong : {Wrong{"1.23e-3", "-1.23e-3", "parameters.viscous_damping.value"},
                               Wrong{"5.5e-4", "-5.5e-4", "parameters.inertia.value"},
                               Wrong{"{\"value\": 26.0}", "{\"value\": -26.0}", "ratios.phi_over_J.value"},
                               Wrong{"{\"value\": 26.0}", "{\"value\": 0}", "ratios.phi_over_J.value"},
                               Wrong{"{\"value\": 1.4}", "{\"value\": -1.4}", "ratios.Kf_over_phi.value"},
                               Wrong{"{\"value\": 1.4}", "{\"value\": -1.4, \"ci95\": [-1.5, -1.3]}",
                                     "ratios.Kf_over_phi.value"}}) {
        const Result<ModelFile> model = parseModel(replaced(Model, wrong.what, wrong.with), "m.json");
        ASSERT_FALSE(model) << wrong.with;
        EXPECT_EQ(model.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(model.error().message.find(wrong.word), std::string::npos) << model.error().message;
    }
    // All four with the other sign have the same ratios.
    std::string all = replaced(Model, "1.23e-3", "-1.23e-3");
    all = replaced(all, "5.5e-4", "-5.5e-4");
    EXPECT_FALSE(parseModel(all, "m.json"));
    // A frictionless motor is estimated a little below zero now and then.
    EXPECT_TRUE(parseModel(replaced(Model, "{\"value\": 1.4}", "{\"value\": -2e-7, \"ci95\": [-1e-4, 1e-4]}"),
                           "m.json"));
}

TEST(ModelFile, intervalsAreInOrderAndHoldTheirValue) {
    for (const char* interval : {"[26.3, 25.9]", "[40, 50]", "[1, 2]", "[-5, 57]", "[0, 57]", "[25]",
                                 "[25, null]", "[\"25\", 27]", "26"}) {
        const Result<ModelFile> model =
            parseModel(replaced(Model, "{\"value\": 26.0}",
                                "{\"value\": 26.0, \"ci95\": " + std::string(interval) + "}"),
                       "m.json");
        ASSERT_FALSE(model) << interval;
        EXPECT_NE(model.error().message.find("ratios.phi_over_J.ci95"), std::string::npos)
            << model.error().message;
    }
    for (const char* interval : {"null", "[26, 26]", "[25.9, 26.3]"}) {
        EXPECT_TRUE(parseModel(replaced(Model, "{\"value\": 26.0}",
                                        "{\"value\": 26.0, \"ci95\": " + std::string(interval) + "}"),
                               "m.json"))
            << interval;
    }
}

TEST(ModelFile, whatMustBePositiveIsKnownToBe) {
    const std::string inertia = "\"value\": 5.5e-4";
    for (const char* interval : {"[-1, 60]", "[0, 1]", "[-1e-9, 1e-3]"}) {
        const Result<ModelFile> model =
            parseModel(replaced(Model, inertia, inertia + ", \"ci95\": " + std::string(interval)), "m.json");
        ASSERT_FALSE(model) << interval;
        EXPECT_NE(model.error().message.find("parameters.inertia.ci95"), std::string::npos)
            << model.error().message;
    }
    EXPECT_TRUE(parseModel(replaced(Model, inertia, inertia + ", \"ci95\": [5e-4, 6e-4]"), "m.json"));
}

TEST(ModelFile, aDoubtfulModelKeepsItsDoubt) {
    EXPECT_TRUE(parseModel(Model, "m.json")->estimate.doubts.empty());
    const auto doubtful =
        parseModel(replaced(Model, "\"good\", \"findings\": []",
                            "\"doubtful\", \"findings\": [{\"code\": \"noisy\", \"message\": \"m\"}]"),
                   "m.json");
    ASSERT_TRUE(doubtful) << doubtful.error().message;
    ASSERT_EQ(doubtful->estimate.doubts.size(), 1U);
    EXPECT_EQ(doubtful->estimate.doubts[0].code, "doubtful_model");
    EXPECT_NE(doubtful->estimate.doubts[0].message.find("noisy"), std::string::npos);
    const auto wide = parseModel(
        replaced(Model, "{\"value\": 2.236}", "{\"value\": 2.236, \"ci95\": [-1.0, 5.5]}"), "m.json");
    ASSERT_TRUE(wide) << wide.error().message;
    EXPECT_EQ(wide->estimate.doubts.size(), 1U) << "the damping may be negative";
}

TEST(ModelFile, refusedEstimateIsNotUsed) {
    const Result<ModelFile> model = parseModel(replaced(Model, "good", "refused"), "m.json");
    ASSERT_FALSE(model.has_value());
    EXPECT_EQ(model.error().code, ErrorCode::Refused);
}

TEST(GainsFile, isReadWithDefaultsForWhatIsAbsent) {
    const Result<GainsFile> gains = parseGains(Gains, "g.json");
    ASSERT_TRUE(gains.has_value()) << gains.error().message;
    EXPECT_EQ(gains->law.gains.proportional, 40.0);
    EXPECT_EQ(gains->law.gains.derivative, 1.4);
    EXPECT_FALSE(gains->law.gains.filter_s.has_value());
    EXPECT_EQ(gains->law.inertia_A_s2_rad, 0.04);
    EXPECT_EQ(gains->law.coulomb_A, 0.0);
    EXPECT_EQ(gains->timing.delay_samples, 1);
}

TEST(GainsFile, mistakesAreRefused) {
    for (const auto& [what, with] :
         {std::pair("\"kp\": {\"value\": 40}", "\"kp\": {}"), std::pair("\"value\": 60", "\"value\": null"),
          std::pair("parallel", "ideal"), std::pair("parallel", "series"), std::pair("0.01", "-0.01"),
          std::pair("0.01", "0"), std::pair("\"delay_samples\": 1", "\"delay_samples\": -1"),
          std::pair("\"delay_samples\": 1", "\"delay_samples\": 1e99")}) {
        const Result<GainsFile> gains = parseGains(replaced(Gains, what, with), "g.json");
        ASSERT_FALSE(gains.has_value()) << with;
        EXPECT_EQ(gains.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(gains.error().message.find("g.json"), std::string::npos);
    }
}

/// K = 40, T_i = 0.5 s, T_d = 0.05 s: in standard form K_I = 80, K_D = 2; in series form K_P = 40 (1 + 0.1),
/// K_I = 80, K_D = 2.
TEST(GainsFile, timesOfTheStandardAndTheSeriesFormAreTheSameControllerInThatNotation) {
    const std::string timed =
        replaced(replaced(replaced(Gains, "\"kp\": {\"value\": 40}", "\"k\": {\"value\": 40}"),
                          "\"ki\": {\"value\": 60}", "\"ti\": {\"value\": 0.5}"),
                 "\"kd\": {\"value\": 1.4}", "\"td\": {\"value\": 0.05}");
    const auto standard = parseGains(replaced(timed, "parallel", "standard"), "g.json");
    ASSERT_TRUE(standard) << standard.error().message;
    EXPECT_EQ(standard->law.gains.form, control::PidForm::Parallel);
    EXPECT_DOUBLE_EQ(standard->law.gains.proportional, 40.0);
    EXPECT_DOUBLE_EQ(standard->law.gains.integral, 80.0);
    EXPECT_DOUBLE_EQ(standard->law.gains.derivative, 2.0);
    const auto series = parseGains(replaced(timed, "parallel", "series"), "g.json");
    ASSERT_TRUE(series) << series.error().message;
    EXPECT_DOUBLE_EQ(series->law.gains.proportional, 44.0);
    EXPECT_DOUBLE_EQ(series->law.gains.integral, 80.0);
    EXPECT_DOUBLE_EQ(series->law.gains.derivative, 2.0);
    const auto without = parseGains(
        replaced(replaced(timed, "parallel", "standard"), "{\"value\": 0.5}", "{\"value\": null}"), "g.json");
    ASSERT_TRUE(without) << without.error().message;
    EXPECT_EQ(without->law.gains.integral, 0.0);
    const auto zero = parseGains(
        replaced(replaced(timed, "parallel", "standard"), "{\"value\": 0.5}", "{\"value\": 0}"), "g.json");
    ASSERT_FALSE(zero); // an integral time of zero
    EXPECT_NE(zero.error().message.find("g.json: gains"), std::string::npos) << zero.error().message;
}

TEST(GainsFile, whatTheBoardsLawHasNotIsRefusedAndNotLeftOut) {
    const auto weighted =
        parseGains(replaced(Gains, "\"filter_s\": null", "\"setpoint_b\": {\"value\": 0.5}"), "g.json");
    ASSERT_FALSE(weighted);
    EXPECT_EQ(weighted.error().code, ErrorCode::InvalidInput);
    EXPECT_NE(weighted.error().message.find("gains.setpoint_b"), std::string::npos);
    EXPECT_TRUE(parseGains(replaced(Gains, "\"filter_s\": null", "\"setpoint_b\": null"), "g.json"));
}

TEST(GainsFile, aFilterThatTheBoardHasNotIsRefusedAndNotLeftOut) {
    const Result<GainsFile> gains =
        parseGains(replaced(Gains, "\"filter_s\": null", "\"filter_s\": {\"value\": 0.02}"), "g.json");
    ASSERT_FALSE(gains.has_value());
    EXPECT_EQ(gains.error().code, ErrorCode::InvalidInput);
    EXPECT_NE(gains.error().message.find("g.json: gains.filter_s"), std::string::npos);
}

TEST(ResultDocuments, notIdentifiableIsNullAndNeverAnAbsoluteValue) {
    const JsonValue none = toJson(control::Estimate{});
    EXPECT_TRUE(none.find("value")->isNull());
    EXPECT_TRUE(none.find("ci95")->isNull());
    EXPECT_EQ(none.find("source")->text(), "not identifiable");
}

} // namespace
} // namespace halbench::app
