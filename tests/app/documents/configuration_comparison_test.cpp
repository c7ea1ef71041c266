#include "app/documents/configuration_comparison.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::app {
namespace {

using Values = std::map<std::string, double>;

ParameterSpec spec(const std::string& name, bool isCalibration = false) {
    ParameterSpec made;
    made.name = name;
    made.unit = "A";
    made.max = 10.0;
    made.isCalibration = isCalibration;
    return made;
}

devices::Catalogue catalogue() {
    devices::Catalogue made;
    made.parameters = {spec("b.gain"), spec("a.limit"), spec("hall.offset", true), spec("c.other")};
    return made;
}

devices::DeviceInfo board(const std::string& id) {
    devices::DeviceInfo info;
    info.model = "htm";
    info.id = id;
    info.firmware = "1";
    return info;
}

Configuration file(const Values& values, const std::string& id = "seven") {
    Configuration made;
    made.device = board(id);
    for (const auto& [name, value] : values) {
        made.values[name] = {value, "A", false};
    }
    return made;
}

ConfigurationComparison compared(const Configuration& configuration, const Values& device,
                                 const std::string& id = "seven") {
    return compareConfiguration(configuration, board(id), catalogue(), device).value();
}

const ComparedRow& row(const ConfigurationComparison& comparison, const std::string& name) {
    return *std::find_if(comparison.rows.begin(), comparison.rows.end(),
                         [&](const ComparedRow& each) { return each.name == name; });
}

TEST(ConfigurationComparison, everyRowSaysWhatItIs) {
    const auto comparison =
        compared(file({{"b.gain", 2.0}, {"a.limit", 11.0}, {"hall.offset", 1.0}, {"gone", 1.0}}),
                 {{"b.gain", 1.0}, {"a.limit", 5.0}, {"hall.offset", 1.0}, {"c.other", 3.0}});
    ASSERT_EQ(comparison.rows.size(), 5U);
    EXPECT_EQ(comparison.rows.front().name, "b.gain"); // the board's order
    EXPECT_EQ(comparison.rows.back().name, "gone");
    EXPECT_EQ(row(comparison, "b.gain").state, RowState::Differs);
    EXPECT_EQ(row(comparison, "a.limit").state, RowState::Refused); // above its greatest value, 10
    EXPECT_FALSE(row(comparison, "a.limit").reason.empty());
    EXPECT_EQ(row(comparison, "hall.offset").state, RowState::Same);
    EXPECT_EQ(row(comparison, "c.other").state, RowState::OnlyOnDevice);
    EXPECT_EQ(row(comparison, "gone").state, RowState::OnlyInFile);
    EXPECT_EQ(proposedRows(comparison, true), std::vector<std::string>{"b.gain"});
}

TEST(ConfigurationComparison, aValueInAnotherUnitIsConverted) {
    Configuration saved = file({{"b.gain", 2.0}, {"a.limit", 2500.0}, {"c.other", 1.0}});
    saved.values["a.limit"].unit = "mA";
    saved.values["c.other"].unit = "V";
    const auto comparison = compared(saved, {{"b.gain", 1.0}, {"a.limit", 2.5}, {"c.other", 1.0}});
    EXPECT_EQ(row(comparison, "a.limit").state, RowState::Same) << row(comparison, "a.limit").reason;
    EXPECT_EQ(row(comparison, "a.limit").file, 2.5);
    EXPECT_EQ(row(comparison, "a.limit").unit, "A");
    EXPECT_EQ(row(comparison, "c.other").state, RowState::Refused);
    saved.values["a.limit"].value = 11000.0;
    EXPECT_EQ(row(compared(saved, {{"a.limit", 2.5}}), "a.limit").state, RowState::Refused) << "above 10 A";
}

TEST(ConfigurationComparison, calibrationStaysWithItsDeviceUnlessAskedFor) {
    const Values device = {{"b.gain", 1.0}, {"hall.offset", 0.0}};
    const Configuration saved = file({{"b.gain", 2.0}, {"hall.offset", 1.0}});
    const auto own = compared(saved, device);
    EXPECT_TRUE(own.isSameDevice);
    EXPECT_TRUE(own.findings.empty());
    EXPECT_EQ(proposedRows(own, false), (std::vector<std::string>{"b.gain", "hall.offset"}));
    const auto other = compared(saved, device, "eight");
    EXPECT_FALSE(other.isSameDevice);
    EXPECT_EQ(other.findings.at(0).code, "other_device");
    EXPECT_EQ(proposedRows(other, false), std::vector<std::string>{"b.gain"});
    EXPECT_EQ(proposedRows(other, true), (std::vector<std::string>{"b.gain", "hall.offset"}));
    EXPECT_FALSE(compared(file({}, ""), device, "").isSameDevice); // nobody knows which boards these are
}

// A file that says so of a value is believed, also when this board's profile does not.
TEST(ConfigurationComparison, whatTheFileCallsCalibrationIsOne) {
    Configuration saved = file({{"b.gain", 2.0}}, "eight");
    saved.values["b.gain"].isCalibration = true;
    EXPECT_TRUE(proposedRows(compared(saved, {{"b.gain", 1.0}}), false).empty());
}

TEST(ConfigurationComparison, aUnitOfAnotherQuantityIsNeverTakenAsANumber) {
    Configuration saved = file({{"b.gain", 2.0}});
    saved.values["b.gain"].unit = "V";
    const auto comparison = compared(saved, {{"b.gain", 2.0}});
    EXPECT_EQ(row(comparison, "b.gain").state, RowState::Refused);
    EXPECT_NE(row(comparison, "b.gain").reason.find("V"), std::string::npos);
}

TEST(ConfigurationComparison, aFileOfAnotherModelIsRefusedWhole) {
    Configuration saved = file({{"b.gain", 2.0}});
    saved.device.model = "planar";
    const auto comparison = compareConfiguration(saved, board("seven"), catalogue(), {});
    ASSERT_FALSE(comparison);
    EXPECT_EQ(comparison.error().code, ErrorCode::InvalidInput);
    EXPECT_NE(comparison.error().message.find("planar"), std::string::npos);
}

TEST(ConfigurationComparison, anotherFirmwareIsSaid) {
    Configuration saved = file({{"b.gain", 2.0}});
    saved.device.firmware = "2";
    EXPECT_EQ(compared(saved, {{"b.gain", 1.0}}).findings.at(0).code, "other_firmware");
}

// 0.1 is kept as the nearest float; the next float above is another number.
TEST(ConfigurationComparison, aNumberIsTheSameWhenTheBoardKeepsItTheSame) {
    EXPECT_TRUE(isSameValue(0.1, static_cast<double>(0.1F)));
    EXPECT_FALSE(isSameValue(0.1, static_cast<double>(0.1F) + 1e-8));
    EXPECT_TRUE(isSameValue(1e300, 1e300));
}

class RestoreTest : public ::testing::Test {
protected:
    std::unique_ptr<devices::Device> device = devices::openDevice("sim:htm", {}).value();

    ConfigurationComparison comparison(const Values& wanted) {
        Configuration saved = configurationOf(device->info(), device->catalogue(), wanted, "");
        return compareConfiguration(saved, device->info(), device->catalogue(), *readSettings(*device))
            .value();
    }

    Result<std::vector<RowOutcome>> restore(const ConfigurationComparison& with,
                                            const std::vector<std::string>& names) {
        const Result<std::vector<ParameterValue>> values = chosenValues(with, names);
        if (!values) {
            return failure(values.error());
        }
        return restoreValues(*device, *values);
    }
};

TEST_F(RestoreTest, whatWasSavedComesBack) {
    const Values before = *readSettings(*device);
    const ParameterValue changed[] = {{"gain.kp", 20.0}, {"hall.offset_a", 0.001}, {"window.speed", 12.0}};
    ASSERT_TRUE(device->writeParameters(changed));
    const auto with = comparison(before);
    const auto outcomes = restore(with, proposedRows(with, false));
    ASSERT_TRUE(outcomes);
    EXPECT_EQ(outcomes->size(), 3U);
    EXPECT_TRUE(
        std::all_of(outcomes->begin(), outcomes->end(), [](const auto& each) { return each.isRestored; }));
    EXPECT_EQ(*readSettings(*device), before);
}

TEST_F(RestoreTest, onlyTheTickedRowsAreWritten) {
    const auto with = comparison({{"gain.kp", 20.0}, {"gain.ki", 3.0}});
    ASSERT_TRUE(restore(with, {"gain.ki"}));
    const Values now = *readSettings(*device);
    EXPECT_EQ(now.at("gain.ki"), 3.0);
    EXPECT_EQ(now.at("gain.kp"), 10.0); // preset published
}

TEST_F(RestoreTest, nothingIsWrittenWhileArmedOrForARowThatCannotBe) {
    const auto with = comparison({{"gain.kp", 20.0}});
    EXPECT_EQ(restore(with, {"gain.kp", "gain.kd"}).error().code, ErrorCode::Usage);
    ASSERT_TRUE(device->arm());
    EXPECT_EQ(restore(with, {"gain.kp"}).error().code, ErrorCode::DeviceRefused);
    ASSERT_TRUE(device->disarm());
    EXPECT_EQ(readSettings(*device)->at("gain.kp"), 10.0);
}

} // namespace
} // namespace halbench::app
