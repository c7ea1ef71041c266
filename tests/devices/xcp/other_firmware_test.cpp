// Names lead to addresses: those of another firmware may lead anywhere (resources/help/protocol.md 3.7).
#include "devices/xcp/xcp_device.h"
#include "tests/devices/xcp/test_slave.h"

#include <gtest/gtest.h>

namespace halbench::devices::xcp {
namespace {

/// The slave's own description with these words about its memory.
std::string descriptionWith(const std::string& words) {
    std::string text = TestSlave().ownDescription();
    const std::string place = "/begin MOD_PAR \"\"";
    const std::size_t found = text.find(place);
    EXPECT_NE(found, std::string::npos);
    return text.insert(found + place.size(), " " + words);
}

/// Reading does no harm whatever the firmware.
ParameterValue firstValue(Device& device) {
    const std::string name = device.catalogue().parameters.front().name;
    const auto values = device.readParameters({&name, 1});
    EXPECT_TRUE(values) << values.error().message;
    return {name, values ? values->front() : 0.0};
}

TEST(OtherFirmware, byADescriptionOfAnotherFirmwareNothingIsWritten) {
    const std::string text = descriptionWith("EPK \"1.0\"");
    for (const char* firmware : {"1.0", "1.1", ""}) {
        SlaveTraits traits;
        traits.epk = firmware;
        auto slave = std::make_unique<TestSlave>(traits);
        slave->descriptionText = text;
        int warnings = 0;
        XcpDeviceOptions options;
        options.onMessage = [&](const std::string& message) {
            warnings +=
                message.find("firmware '1.1' does not match the description of '1.0'") != std::string::npos
                    ? 1
                    : 0;
        };
        const auto device = openXcpDevice(std::move(slave), std::move(options));
        ASSERT_TRUE(device) << device.error().message;
        const bool isOther = std::string(firmware) == "1.1";
        EXPECT_EQ(warnings, isOther ? 1 : 0);
        const ParameterValue same = firstValue(**device);
        const auto written = (*device)->writeParameters({&same, 1});
        EXPECT_EQ(written.has_value(), !isOther);
        EXPECT_EQ((*device)->info().otherFirmware, isOther ? "1.0" : "");
        if (isOther) {
            for (const Result<void>& refused :
                 {written, (*device)->saveParameters(), (*device)->arm(), (*device)->clearStop()}) {
                ASSERT_FALSE(refused);
                EXPECT_EQ(refused.error().code, ErrorCode::DeviceRefused);
                EXPECT_NE(refused.error().message.find("writing is blocked"), std::string::npos);
                EXPECT_FALSE(refused.error().hint.empty());
            }
        }
    }
}

/// A board keeps its text in a field of fixed length.
TEST(OtherFirmware, zerosAndSpacesBehindTheNameAreNoOtherFirmware) {
    for (const std::string& firmware : {std::string("1.0 "), std::string("1.0\0\0", 5)}) {
        SlaveTraits traits;
        traits.epk = firmware;
        auto slave = std::make_unique<TestSlave>(traits);
        slave->descriptionText = descriptionWith("EPK \"1.0\"");
        const auto device = openXcpDevice(std::move(slave), {});
        ASSERT_TRUE(device) << device.error().message;
        EXPECT_EQ((*device)->info().otherFirmware, "");
        EXPECT_EQ((*device)->info().firmware, "1.0");
    }
}

TEST(OtherFirmware, aBoardThatDoesNotTellItsFirmwareIsAskedWhereItsDescriptionKeepsIt) {
    struct Case {
        std::string inMemory; ///< "": the board refuses these octets
        bool canWrite;
        std::string said;
    };
    for (const Case& one :
         {Case{"1.0", true, ""}, Case{"1.1", false, "firmware '1.1' does not match the description of '1.0'"},
          Case{{"\xFF\x00\x01", 3}, false, "firmware '?"}, Case{{"1.0\0", 4}, true, ""},
          Case{{"1.0 \xFF", 5}, true, ""},
          Case{{"1.0\xFF\x37", 5}, true, ""}, // erased memory behind the text
          Case{{"1.0_beta\0", 9}, false, "firmware '1.0_beta' does not match the description of '1.0'"},
          Case{"1.0.1", false, "firmware '1.0.1' does not match the description of '1.0'"},
          Case{"1.05", false, "firmware '1.05' does not match the description of '1.0'"},
          Case{"", true, "it is unknown whether they match"}}) {
        auto slave = std::make_unique<TestSlave>();
        slave->descriptionText = descriptionWith("EPK \"1.0\" ADDR_EPK 0x9000");
        slave->bendAnswers = [&](const Packet& command, std::deque<Packet>& answers) {
            const bool isAsked = command.size() >= 8 &&
                                 command[0] == static_cast<std::uint8_t>(Command::ShortUpload) &&
                                 command[5] == 0x90;
            const std::size_t offset = isAsked ? command[4] : 0;
            const std::size_t size = isAsked ? command[1] : 0;
            if (isAsked && offset + size <= one.inMemory.size()) {
                const std::string octets = one.inMemory.substr(offset, size);
                answers = {{0xFF}};
                answers[0].insert(answers[0].end(), octets.begin(), octets.end());
            } else if (isAsked) {
                answers = slaveError(SlaveError::AccessDenied);
            }
        };
        std::string said;
        XcpDeviceOptions options;
        options.onMessage = [&](const std::string& message) { said += message + "\n"; };
        const auto device = openXcpDevice(std::move(slave), std::move(options));
        ASSERT_TRUE(device) << device.error().message;
        EXPECT_NE(said.find(one.said), std::string::npos) << said;
        const ParameterValue same = firstValue(**device);
        EXPECT_EQ((*device)->writeParameters({&same, 1}).has_value(), one.canWrite) << one.inMemory;
    }
}

} // namespace
} // namespace halbench::devices::xcp
