#include "app/experiments/experiment.h"
#include "app/experiments/experiment_keys.h"
#include "app/experiments/experiment_validation.h"
#include "app/experiments/step_configs.h"

#include <gtest/gtest.h>

#include <set>

namespace halbench::app {
namespace {

const std::string Good = R"(schema = "halbench.experiment/1"
title = "A sweep and a step"
device = "sim:htm?seed=1"

[[step]]
kind = "identify"
name = "sweep"
currents_A = { from = 1.6, to = 4.0, step = 0.2 }
given = { J = 5.5e-4 }

[[step]]
kind = "move"
name = "step100"
reference = { shape = "step", amplitude_deg = 100 }
duration_s = 3

[[check]]
quantity = "step100.overshoot_percent"
max = 12
)";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t place = text.find(what);
    EXPECT_NE(place, std::string::npos) << what;
    return text.replace(place, what.size(), with);
}

Error mistakeIn(const std::string& text, const std::vector<std::string>& assignments = {}) {
    const Result<Experiment> experiment = parseExperiment(text, "e.toml", assignments);
    EXPECT_FALSE(experiment.has_value()) << text;
    return experiment ? Error{} : experiment.error();
}

TEST(Experiment, isReadAsWritten) {
    const Result<Experiment> experiment = parseExperiment(Good, "e.toml", {});
    ASSERT_TRUE(experiment.has_value()) << experiment.error().message;
    EXPECT_EQ(experiment->device, "sim:htm?seed=1");
    ASSERT_EQ(experiment->steps.size(), 2U);
    EXPECT_EQ(experiment->steps[0].number("currents_A.to"), 4.0);
    EXPECT_EQ(experiment->steps[0].numbers("given").front(), (std::pair<std::string, double>{"J", 5.5e-4}));
    EXPECT_EQ(experiment->steps[1].text("reference.shape"), "step");
    EXPECT_FALSE(experiment->steps[1].number("reference.frequency_hz").has_value());
    ASSERT_EQ(experiment->checks.size(), 1U);
    EXPECT_EQ(experiment->checks[0].step, "step100");
    EXPECT_EQ(experiment->checks[0].quantity, "overshoot_percent");
    EXPECT_EQ(experiment->checks[0].max, 12.0);
    EXPECT_FALSE(experiment->checks[0].min.has_value());
}

struct Mistake {
    const char* name;
    const char* right;
    const char* wrong;
    const char* place; ///< file and line
    const char* word;  ///< what the message or hint must name
};

class ExperimentMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(ExperimentMistake, isToldWithItsPlaceAndWhatIsAllowed) {
    const Error error = mistakeIn(replaced(Good, GetParam().right, GetParam().wrong));
    EXPECT_EQ(error.code, ErrorCode::InvalidInput);
    EXPECT_NE(error.message.find(GetParam().place), std::string::npos) << error.message;
    EXPECT_NE((error.message + error.hint).find(GetParam().word), std::string::npos)
        << error.message << "; " << error.hint;
}

const Mistake Mistakes[] = {
    {"schema", "experiment/1", "experiment/2", "e.toml:1:", "halbench.experiment/1"},
    {"kind", "\"identify\"", "\"dance\"", "e.toml:6:", "calibrate"},
    {"key", "duration_s", "duration_ms", "e.toml:", "duration_s"},
    {"type", "duration_s = 3", "duration_s = \"3\"", "e.toml:15:", "duration_s"},
    {"range", "duration_s = 3", "duration_s = -3", "e.toml:15:", "duration_s"},
    {"notFinite", "duration_s = 3", "duration_s = inf", "e.toml:15:", "duration_s"},
    {"choice", "\"step\"", "\"spiral\"", "e.toml:14:", "sine"},
    {"nestedKey", "amplitude_deg", "amplitude_inch", "e.toml:14:", "amplitude_deg"},
    {"settledOfOne", "duration_s = 3", "duration_s = 3\nsettled_deg = 1", "e.toml:16:", "repeat"},
    {"alternateOfOne", "duration_s = 3", "duration_s = 3\nalternate = true", "e.toml:16:", "repeat"},
    {"settledInTwoUnits", "duration_s = 3", "duration_s = 3\nrepeat = 2\nsettled_deg = 1\nsettled_um = 1",
     "e.toml:", "exclude each other"},
    {"sameName", "\"step100\"", "\"sweep\"", "e.toml:", "sweep"},
    {"unknownStep", "step100.overshoot", "step200.overshoot", "e.toml:18:", "step200"},
    {"noLimit", "max = 12", "reason = \"x\"", "e.toml:", "max"},
    {"syntax", "title =", "title", "e.toml:2:", "e.toml"},
};

INSTANTIATE_TEST_SUITE_P(OfEveryKind, ExperimentMistake, ::testing::ValuesIn(Mistakes),
                         [](const auto& mistake) { return std::string(mistake.param.name); });

TEST(Experiment, anAnalysisTakesTheKeysOfItsSubjectOnly) {
    const std::string analysis = "schema = \"halbench.experiment/1\"\n[[step]]\nkind = \"analyse\"\n"
                                 "name = \"motor\"\nwhat = \"torque\"\n";
    EXPECT_TRUE(parseExperiment(analysis + "speed_rpm = 270\n", "e.toml", {}).has_value());
    const Error error = mistakeIn(analysis + "pitch_mm = 0.7\n");
    EXPECT_NE(error.message.find("e.toml:6:"), std::string::npos) << error.message;
    EXPECT_NE(error.hint.find("coil"), std::string::npos) << error.hint;
}

TEST(Experiment, aRecordingMayWaitForATriggerAndSaysWhereThatIsWrong) {
    const std::string record = "schema = \"halbench.experiment/1\"\n[[step]]\nkind = \"record\"\n"
                               "name = \"knock\"\nduration_s = 1\n";
    const auto good =
        parseExperiment(record + "trigger = \"hall.a>0.1\"\npre_trigger_s = 0.5\nwait_s = 3\n", "e.toml", {});
    ASSERT_TRUE(good) << good.error().message;
    const RecordConfig config = recordConfigOf(good->steps.front());
    ASSERT_TRUE(config.trigger);
    EXPECT_EQ(config.trigger->event.signal, "hall.a");
    EXPECT_EQ(config.trigger->event.level, 0.1);
    EXPECT_TRUE(config.trigger->event.isRising);
    EXPECT_EQ(config.trigger->preTrigger_s, 0.5);
    EXPECT_EQ(config.trigger->patience_s, 3.0);
    EXPECT_FALSE(recordConfigOf(parseExperiment(record, "e.toml", {})->steps.front()).trigger);
    const std::pair<const char*, const char*> wrong[] = {
        {"pre_trigger_s = 1\n", "'pre_trigger_s' needs a 'trigger'"},
        {"wait_s = 1\n", "'wait_s' needs a 'trigger'"},
        {"trigger = \"soon\"\n", "\"soon\" is no level of a signal"},
        {"trigger = \"reference\"\n", "\"reference\" is no level of a signal"},
        {"trigger = \"speed>\"\n", "\"speed>\" is no level"},
        {"trigger = \"speed>inf\"\n", "\"speed>inf\" is no level"},
        {"pre_trigger_s = -1\ntrigger = \"speed>1\"\n", "'pre_trigger_s' = -1 is out of range"},
        {"reconnect = true\ntrigger = \"speed>1\"\n", "'reconnect' does not go with 'trigger'"}};
    for (const auto& [line, message] : wrong) {
        const Error error = mistakeIn(record + line);
        EXPECT_NE(error.message.find("e.toml:6:"), std::string::npos) << error.message;
        EXPECT_NE(error.message.find(message), std::string::npos) << error.message;
        EXPECT_FALSE(error.hint.empty());
    }
}

TEST(Experiment, settingsFromTheCommandLineReplaceValues) {
    const Result<Experiment> experiment =
        parseExperiment(Good, "e.toml", {"step.sweep.given.J=6e-4", "step.step100.duration_s=4"});
    ASSERT_TRUE(experiment.has_value()) << experiment.error().message;
    EXPECT_EQ(experiment->steps[0].numbers("given").front().second, 6e-4);
    EXPECT_EQ(experiment->steps[1].number("duration_s"), 4.0);
}

TEST(Experiment, settingsFromTheCommandLineAreJudgedLikeTheFile) {
    EXPECT_EQ(mistakeIn(Good, {"step.none.duration_s=4"}).code, ErrorCode::UnknownName);
    EXPECT_EQ(mistakeIn(Good, {"duration"}).code, ErrorCode::Usage);
    EXPECT_EQ(mistakeIn(Good, {"step.step100.duration_s=-4"}).code, ErrorCode::InvalidInput);
    EXPECT_NE(mistakeIn(Good, {"step.step100.duration_s=-4"}).message.find("step.step100.duration_s"),
              std::string::npos);
}

TEST(ExperimentKeys, areNamedOncePerSectionAndHaveHelp) {
    std::set<std::pair<std::string_view, std::string_view>> seen;
    for (const KeySpec& key : experimentKeys()) {
        EXPECT_TRUE(seen.insert({key.section, key.key}).second) << key.section << "." << key.key;
        EXPECT_FALSE(key.help.empty()) << key.section << "." << key.key;
        EXPECT_LE(key.min, key.max);
    }
    for (const std::string& kind : stepKinds()) {
        const bool isKnown = kind == "identify" || kind == "calibrate" || kind == "tune" || kind == "apply" ||
                             kind == "move" || kind == "record" || kind == "set" || kind == "wait";
        EXPECT_TRUE(isKnown || !keysOf(kind, "").empty()) << kind;
    }
}

TEST(ConfigNode, remembersWhereItStands) {
    const Result<ConfigNode> root = parseToml("a = 1\nb = { c = \"x\" }\n", "f.toml");
    ASSERT_TRUE(root.has_value());
    EXPECT_EQ(root->find("b")->find("c")->text, "x");
    EXPECT_EQ(root->find("b")->find("c")->where().rfind("f.toml:2:", 0), 0U);
    EXPECT_EQ(root->find("a")->kind, ConfigNode::Kind::Integer);
    EXPECT_EQ(root->find("none"), nullptr);
}

TEST(ConfigNode, syntaxErrorsNameLineAndColumn) {
    const Result<ConfigNode> root = parseToml("a = 1\nb = = 2\n", "f.toml");
    ASSERT_FALSE(root.has_value());
    EXPECT_EQ(root.error().message.rfind("f.toml:2:", 0), 0U) << root.error().message;
}

} // namespace
} // namespace halbench::app
