#include "app/headless/recording_integrity.h"
#include "devices/formats/recording_units.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(RecordingIntegrity, aWarningMakesAResultDoubtfulAndNoneLeavesItAsItIs) {
    DataQuality quality;
    noteWarnings(quality, {});
    EXPECT_EQ(quality.verdict, Verdict::Good);
    noteWarnings(quality, {"2499 of 5000 rows"});
    EXPECT_EQ(quality.verdict, Verdict::Doubtful);
    ASSERT_EQ(quality.findings.size(), 1U);
    EXPECT_EQ(quality.findings[0].code, RecordingIntegrityCode);
    EXPECT_EQ(quality.findings[0].message, "2499 of 5000 rows");
    DataQuality refused;
    refused.verdict = Verdict::Refused;
    noteWarnings(refused, {"changed"});
    EXPECT_EQ(refused.verdict, Verdict::Refused) << "no better for it";
}

TEST(RecordingIntegrity, aUnitThatIsAssumedHasACodeOfItsOwn) {
    devices::RecordedFile file;
    file.recording.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"position", ""}}, 0.01});
    ASSERT_TRUE(devices::convertToSi(file, {false}, "folder/run.csv"));
    DataQuality quality;
    noteWarnings(quality, file.warnings);
    ASSERT_EQ(quality.findings.size(), 1U);
    EXPECT_EQ(quality.findings[0].code, "unit_assumed");
    EXPECT_EQ(quality.findings[0].message.find("folder"), std::string::npos) << "no path in a result";
    EXPECT_EQ(quality.verdict, Verdict::Doubtful);
}

TEST(RecordingIntegrity, aDescriptionOfAnotherFirmwareHasACodeOfItsOwn) {
    devices::DeviceInfo device;
    device.firmware = "1.1";
    device.otherFirmware = "1.0";
    DataQuality quality;
    noteWarnings(quality, {devices::otherFirmwareWarning(device)});
    ASSERT_EQ(quality.findings.size(), 1U);
    EXPECT_EQ(quality.findings[0].code, "other_firmware");
    EXPECT_EQ(quality.verdict, Verdict::Doubtful);
}

TEST(RecordingIntegrity, theWorseVerdictHoldsAndAllFindingsStay) {
    DataQuality known;
    noteWarnings(known, {"changed"});
    DataQuality result;
    addQuality(known, result);
    EXPECT_EQ(known.verdict, Verdict::Doubtful);
    result.verdict = Verdict::Refused;
    result.findings.push_back({"gap", "rows are missing", ""});
    addQuality(known, result);
    EXPECT_EQ(known.verdict, Verdict::Refused);
    EXPECT_EQ(known.findings.size(), 2U);
}

} // namespace
} // namespace halbench::app
