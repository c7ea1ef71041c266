#include "app/documents/configuration_file.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <array>

namespace halbench::app {
namespace {

Configuration configuration() {
    Configuration made;
    made.device.model = "htm";
    made.device.id = "board \"7\"";
    made.device.firmware = "1.2";
    made.device.overrides = {{"c", "0.002"}, {"chain", "ideal"}};
    made.written = "2026-05-04T03:02:01Z";
    made.values = {{"gain.kp", {12.5, "A/rad", false}},
                   {"stray.coefficient", {0.0025, "T/A", true}},
                   {"tiny", {-4.9406564584124654e-324, "", false}}, // the smallest number there is
                   {"large", {1.7976931348623157e308, "", false}}};
    return made;
}

TEST(ConfigurationFile, whatWasWrittenIsReadBackExactly) {
    const std::string text = configurationText(configuration());
    const Result<Configuration> read = parseConfiguration(text, "c.toml");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->values, configuration().values);
    EXPECT_EQ(read->device.id, configuration().device.id);
    EXPECT_EQ(read->device.overrides, configuration().device.overrides);
    EXPECT_EQ(configurationText(*read), text);
}

TEST(ConfigurationFile, aNumberStandsInOneLineInItsShortestForm) {
    EXPECT_NE(configurationText(configuration()).find(" = { value = 0.0025, unit = "), std::string::npos);
}

TEST(ConfigurationFile, holdsSettingsOnly) {
    devices::Catalogue catalogue;
    ParameterSpec gain;
    gain.name = "gain.kp";
    gain.unit = "A/rad";
    ParameterSpec order = gain;
    order.name = "hb.arm";
    order.group = "hb";
    ParameterSpec fixed = gain;
    fixed.name = "serial";
    fixed.access = ParameterAccess::ReadOnly;
    catalogue.parameters = {gain, order, fixed};
    EXPECT_EQ(settingNames(catalogue), std::vector<std::string>{"gain.kp"});
    const Configuration made = configurationOf(
        {}, catalogue, {{"gain.kp", 1.0}, {"hb.arm", 1.0}, {"serial", 7.0}, {"unknown", 2.0}}, "");
    ASSERT_EQ(made.values.size(), 1U);
    EXPECT_EQ(made.values.begin()->second.unit, "A/rad");
}

TEST(ConfigurationFile, aDamagedFileIsRefusedAtItsLine) {
    const std::string head = "schema = 'halbench.configuration/1'\n";
    struct Case {
        std::string text;
        const char* place;
        const char* says;
    };
    const std::array cases = {
        Case{"written = ''\n", "c.toml", "schema"},
        Case{"schema = 'halbench.configuration/2'\n", "c.toml:1", "newer"},
        Case{"schema = 'halbench.preset/1'\n", "c.toml:1", "not a configuration"},
        Case{head + "colour = 1\n", "c.toml:2", "unknown key"},
        Case{head + "[parameters]\n'gain.kp' = 3\n", "c.toml:3", "must be a table"},
        Case{head + "[parameters]\n'gain.kp' = { unit = 'A' }\n", "c.toml:3", "no value"},
        Case{head + "[parameters]\n'gain.kp' = { value = nan }\n", "c.toml:3", "finite"},
        Case{head + "[parameters]\n'gain.kp' = { value = -inf }\n", "c.toml:3", "finite"},
        Case{head + "[parameters]\n'gain.kp' = { value = '3' }\n", "c.toml:3", "finite"},
        Case{head + "[parameters]\n'gain.kp' = { value = 1, volume = 2 }\n", "c.toml:3", "unknown"},
        Case{head + "[parameters]\n'a' = { value = 1 }\n[calibration]\n'a' = { value = 1 }\n", "c.toml:3",
             "twice"},
        Case{head + "[device]\nid = 7\n", "c.toml:3", "must be a text"},
        Case{head + "[parameters\n", "c.toml:2", ""},
    };
    for (const Case& wrong : cases) {
        const Result<Configuration> read = parseConfiguration(wrong.text, "c.toml");
        ASSERT_FALSE(read) << wrong.text;
        EXPECT_EQ(read.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(read.error().message.find(wrong.place), std::string::npos) << read.error().message;
        EXPECT_NE(read.error().message.find(wrong.says), std::string::npos) << read.error().message;
        EXPECT_FALSE(read.error().hint.empty());
    }
}

TEST(ConfigurationFile, aBackupNeverReplacesAnother) {
    const QTemporaryDir folder;
    const std::string root = folder.path().toStdString();
    Configuration second = configuration();
    second.values["gain.kp"].value = 99.0;
    const Result<std::string> first = backUpConfiguration(configuration(), root);
    const Result<std::string> later = backUpConfiguration(second, root);
    ASSERT_TRUE(first && later);
    EXPECT_NE(*first, *later);
    EXPECT_EQ(first->find(root + "/board__7_/2026-05-04T03_02_01Z"), 0U) << *first;
    EXPECT_EQ(readConfiguration(*first)->values, configuration().values);
    EXPECT_EQ(readConfiguration(*later)->values, second.values);
}

TEST(ConfigurationFile, aBackupThatCannotBeWrittenIsSaid) {
    const Result<std::string> kept = backUpConfiguration(configuration(), "/dev/null/x");
    ASSERT_FALSE(kept);
    EXPECT_EQ(kept.error().code, ErrorCode::FileSystem);
}

} // namespace
} // namespace halbench::app
