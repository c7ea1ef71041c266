#include "devices/xcp/xcp_device.h"
#include "tests/devices/xcp/test_slave.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::devices::xcp {
namespace {

struct Opened {
    TestSlave* slave = nullptr;
    std::unique_ptr<Device> device;
    std::shared_ptr<std::vector<std::string>> messages = std::make_shared<std::vector<std::string>>();
};

Opened openSlave(const SlaveTraits& traits, bool useVendorBrackets = false) {
    Opened opened;
    auto slave = std::make_unique<TestSlave>(traits);
    opened.slave = slave.get();
    XcpDeviceOptions options;
    options.useVendorBrackets = useVendorBrackets;
    options.onMessage = [messages = opened.messages](const std::string& text) { messages->push_back(text); };
    auto device = openXcpDevice(std::move(slave), std::move(options));
    if (!device) {
        ADD_FAILURE() << device.error().message;
        return opened;
    }
    opened.device = *std::move(device);
    return opened;
}

struct Variant {
    const char* name;
    SlaveTraits traits;
};

void PrintTo(const Variant& variant, std::ostream* out) {
    *out << variant.name;
}

SlaveTraits with(const std::function<void(SlaveTraits&)>& change) {
    SlaveTraits traits;
    change(traits);
    return traits;
}

class ForeignSlave : public testing::TestWithParam<Variant> {};

TEST_P(ForeignSlave, itsSamplesAndParametersAreRight) {
    const Opened opened = openSlave(GetParam().traits);
    ASSERT_TRUE(opened.device);
    Device& device = *opened.device;
    std::vector<double> counts;
    Recording recording;
    ASSERT_TRUE(device.startStream({{"count", "wave", "byte", "big"}, 100.0},
                                   [&](const SampleBlockPtr& block) { recording.append(*block); }));
    ASSERT_TRUE(device.clock().waitFor(4.0)); // more than 256 samples: the octet counter wraps
    device.stopStream();
    ASSERT_GT(recording.rows(), 390U);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        const double number = recording.values[4 * row];
        EXPECT_EQ(number, recording.values[0] + static_cast<double>(row));
        EXPECT_EQ(recording.values[4 * row + 1], number / 4.0);
        EXPECT_EQ(recording.values[4 * row + 2], std::fmod(number, 256.0));
        EXPECT_EQ(recording.values[4 * row + 3], number / 8.0);
        EXPECT_NEAR(recording.time_s[row], static_cast<double>(row) / 100.0, 1e-9);
    }
    EXPECT_EQ(recording.lostRows, 0U);

    const std::vector<ParameterValue> change = {{"p.a", 1.5}, {"p.b", -0.0}, {"p.n", 1234.0}};
    const auto written = device.writeParameters(change);
    ASSERT_TRUE(written) << written.error().message;
    const std::vector<std::string> names = {"p.n", "p.a", "p.b"};
    EXPECT_EQ(*device.readParameters(names), (std::vector<double>{1234.0, 1.5, 0.0}));
}

INSTANTIATE_TEST_SUITE_P(
    Variants, ForeignSlave,
    testing::Values(
        Variant{"likeOurs", {}},
        Variant{"bigEndian", with([](SlaveTraits& foreign) { foreign.order = ByteOrder::BigEndian; })},
        Variant{"idFieldByte", with([](SlaveTraits& foreign) { foreign.idField = IdField::RelativeByte; })},
        Variant{"idFieldWord", with([](SlaveTraits& foreign) { foreign.idField = IdField::RelativeWord; })},
        Variant{"idFieldWordAligned",
                with([](SlaveTraits& foreign) { foreign.idField = IdField::RelativeWordAligned; })},
        Variant{"idFieldWordAlignedBigEndian", with([](SlaveTraits& foreign) {
                    foreign.idField = IdField::RelativeWordAligned;
                    foreign.order = ByteOrder::BigEndian;
                })},
        Variant{"maxDaqZero", with([](SlaveTraits& foreign) { foreign.maxDaq = 0; })},
        Variant{"paddedSamples", with([](SlaveTraits& foreign) { foreign.dtoAlignment = 4; })},
        Variant{"smallPackets", with([](SlaveTraits& foreign) {
                    foreign.maxCto = 8;
                    foreign.maxDto = 14; // several packets a sample, FLOAT64 just fits
                })},
        Variant{"blockMode", with([](SlaveTraits& foreign) {
                    foreign.maxCto = 32;
                    foreign.hasBlockMode = true;
                })},
        Variant{"noShortDownload", with([](SlaveTraits& foreign) { foreign.hasShortDownload = false; })},
        Variant{"noChecksum", with([](SlaveTraits& foreign) { foreign.hasChecksum = false; })},
        Variant{"noPages", with([](SlaveTraits& foreign) { foreign.hasPages = false; })},
        Variant{"readOnlyPage", with([](SlaveTraits& foreign) { foreign.isPage1ReadOnly = true; })},
        Variant{"overloadBit", with([](SlaveTraits& foreign) { foreign.marksOverload = true; })},
        Variant{"noTimestamp", with([](SlaveTraits& foreign) { foreign.timestampSize = 0; })},
        Variant{"oneOctetMilliseconds", with([](SlaveTraits& foreign) {
                    foreign.timestampSize = 1; // wraps every 0.256 s
                    foreign.timestampUnit = 6;
                })},
        Variant{"nanosecondsAboutToWrap", with([](SlaveTraits& foreign) {
                    foreign.timestampUnit = 0;
                    foreign.firstTick = 0xFFFFFFFFU - 500000000U;
                })}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(ForeignSlaveParameters, adjacentValuesWithoutPagesGoInOneDownload) {
    const Opened opened = openSlave(with([](SlaveTraits& foreign) { foreign.hasPages = false; }));
    ASSERT_TRUE(opened.device);
    const std::size_t before = opened.slave->count(Command::Download);
    const std::vector<ParameterValue> change = {{"p.b", 2.0}, {"p.a", 1.0}};
    ASSERT_TRUE(opened.device->writeParameters(change));
    EXPECT_EQ(opened.slave->count(Command::Download), before + 1);
    EXPECT_EQ(opened.slave->count(Command::ShortDownload), 0U);
    EXPECT_EQ(opened.slave->parameter(0, 0), 1.0F);
    EXPECT_EQ(opened.slave->parameter(0, 4), 2.0F);
    EXPECT_TRUE(opened.messages->empty());
}

TEST(ForeignSlaveParameters, scatteredValuesWithoutPagesAreWarnedAbout) {
    const Opened opened = openSlave(with([](SlaveTraits& foreign) {
        foreign.hasPages = false;
        foreign.hasGap = true;
    }));
    ASSERT_TRUE(opened.device);
    const std::vector<ParameterValue> change = {{"p.a", 1.0}, {"p.b", 2.0}};
    ASSERT_TRUE(opened.device->writeParameters(change));
    ASSERT_EQ(opened.messages->size(), 1U);
    EXPECT_NE(opened.messages->front().find("one by one"), std::string::npos);
}

TEST(ForeignSlaveParameters, vendorBracketsAreUsedOnlyWhenAsked) {
    const auto traits = with([](SlaveTraits& foreign) {
        foreign.hasPages = false;
        foreign.hasGap = true;
    });
    const Opened plain = openSlave(traits);
    const std::vector<ParameterValue> change = {{"p.a", 1.0}, {"p.b", 2.0}};
    ASSERT_TRUE(plain.device->writeParameters(change));
    EXPECT_EQ(plain.slave->count(Command::UserCommand), 0U);
    const Opened bracketed = openSlave(traits, true);
    bracketed.slave->bendAnswers = [](const Packet& command, std::deque<Packet>& answers) {
        if (command[0] == 0xF1) {
            answers = {{0xFF}};
        }
    };
    ASSERT_TRUE(bracketed.device->writeParameters(change));
    EXPECT_EQ(bracketed.slave->count(Command::UserCommand), 2U);
}

TEST(ForeignSlaveParameters, withPagesTheSetChangesByOneSwitch) {
    const Opened opened = openSlave({});
    ASSERT_TRUE(opened.device);
    const std::uint8_t before = opened.slave->runningPage();
    const std::vector<ParameterValue> change = {{"p.a", 1.0}, {"p.n", 7.0}};
    ASSERT_TRUE(opened.device->writeParameters(change));
    EXPECT_EQ(opened.slave->runningPage(), 1 - before);
    EXPECT_EQ(opened.slave->parameter(before, 0), 0.0F) << "the page that ran stays as it was";
}

TEST(ForeignSlaveParameters, whatLiesOnARunningPageWithoutWritesCanOnlyBeRead) {
    auto slave =
        std::make_unique<TestSlave>(with([](SlaveTraits& foreign) { foreign.isPage1ReadOnly = true; }));
    slave->bendAnswers = [](const Packet& command, std::deque<Packet>& answers) {
        if (command[0] == static_cast<std::uint8_t>(Command::GetCalPage)) {
            answers = {{0xFF, 0, 0, 1}};
        }
    };
    std::vector<std::string> messages;
    XcpDeviceOptions options;
    options.onMessage = [&](const std::string& text) { messages.push_back(text); };
    const auto device = openXcpDevice(std::move(slave), std::move(options));
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_EQ((*device)->catalogue().findParameter("p.a")->access, ParameterAccess::ReadOnly);
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_NE(messages[0].find("read-only"), std::string::npos) << messages[0];
    const ParameterValue change{"p.a", 1.0};
    const auto written = (*device)->writeParameters({&change, 1});
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().message.find("read only"), std::string::npos) << written.error().message;
    EXPECT_EQ((*device)->readParameters({&change.name, 1}).value()[0], 0.0);
}

TEST(ForeignSlaveParameters, whatTheBoardKeepsToItselfIsLeftOutByName) {
    auto slave = std::make_unique<TestSlave>();
    slave->bendAnswers = [](const Packet& command, std::deque<Packet>& answers) {
        const bool isRead = command[0] == static_cast<std::uint8_t>(Command::ShortUpload);
        if (isRead && command[4] == 16 && command[5] == 0x40) { // p.n, at 0x4010
            answers = slaveError(SlaveError::AccessDenied);
        }
    };
    std::vector<std::string> messages;
    XcpDeviceOptions options;
    options.onMessage = [&](const std::string& text) { messages.push_back(text); };
    const auto device = openXcpDevice(std::move(slave), std::move(options));
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_EQ((*device)->catalogue().parameters.size(), 2U);
    EXPECT_EQ((*device)->catalogue().findParameter("p.n"), nullptr);
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_NE(messages[0].find("'p.n' was skipped"), std::string::npos) << messages[0];
}

TEST(ForeignSlaveDescription, aGivenOneStandsForTheBoardsOwn) {
    auto slave = std::make_unique<TestSlave>();
    XcpDeviceOptions options;
    options.description = slave->ownDescription();
    slave->bendAnswers = [](const Packet& command, std::deque<Packet>& answers) {
        if (command[0] == static_cast<std::uint8_t>(Command::GetId) && command[1] == 4) {
            answers = slaveError(SlaveError::CommandUnknown);
        }
    };
    TestSlave without;
    without.bendAnswers = slave->bendAnswers;
    const auto device = openXcpDevice(std::move(slave), std::move(options));
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_NE((*device)->catalogue().findSignal("wave"), nullptr);
    EXPECT_EQ((*device)->catalogue().findSignal("wave")->events, std::vector<int>{0});
    const auto refused = openXcpDevice(std::make_unique<TestSlave>(std::move(without)), {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "the device has no built-in description");
    EXPECT_NE(refused.error().hint.find("?a2l=FILE"), std::string::npos);
}

TEST(ForeignSlaveStream, slowerRatesComeFromThePrescalerAndTheHost) {
    const Opened opened = openSlave({});
    ASSERT_TRUE(opened.device);
    for (const double rate_Hz :
         {50.0, 10.0, 1.0, 0.2}) { // 0.2 Hz: 100 Hz / 500, beyond one octet of prescaler
        Recording recording;
        ASSERT_TRUE(opened.device->startStream(
            {{"count"}, rate_Hz}, [&](const SampleBlockPtr& block) { recording.append(*block); }));
        ASSERT_TRUE(opened.device->clock().waitFor(10.5 / rate_Hz));
        opened.device->stopStream();
        ASSERT_GE(recording.rows(), 10U) << rate_Hz;
        for (std::size_t row = 0; row < recording.rows(); ++row) {
            EXPECT_NEAR(recording.time_s[row], static_cast<double>(row) / rate_Hz, 1e-9);
        }
        EXPECT_EQ(recording.lostRows, 0U);
    }
}

TEST(ForeignSlaveStream, impossibleRatesNameTheNearest) {
    const Opened opened = openSlave({});
    const auto started = opened.device->startStream({{"count"}, 30.0}, [](const SampleBlockPtr&) {});
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().code, ErrorCode::OutOfRange);
    EXPECT_NE(started.error().hint.find("25 Hz"), std::string::npos) << started.error().hint;
    EXPECT_NE(started.error().hint.find("33.3"), std::string::npos) << started.error().hint;
    for (const double rate_Hz : {0.0, -1.0, 200.0, std::nan(""), 1e300}) {
        EXPECT_FALSE(opened.device->startStream({{"count"}, rate_Hz}, [](const SampleBlockPtr&) {}));
    }
}

TEST(ForeignSlaveStream, lostSamplesAreCountedExactly) {
    const Opened opened = openSlave({});
    std::size_t number = 0;
    std::size_t dropped = 0;
    opened.slave->bendSample = [&](Packet& packet) {
        if (++number % 7 == 3) {
            packet.clear();
            ++dropped;
        }
    };
    Recording recording;
    ASSERT_TRUE(opened.device->startStream({{"count"}, 100.0},
                                           [&](const SampleBlockPtr& block) { recording.append(*block); }));
    ASSERT_TRUE(opened.device->clock().waitFor(3.005));
    EXPECT_EQ(recording.rows() + dropped, number);
    // a loss after the last row cannot be seen yet
    EXPECT_GE(recording.lostRows + 1, dropped);
    EXPECT_LE(recording.lostRows, dropped);
}

TEST(ForeignSlaveStream, halfSamplesAreDroppedAndNeverMixed) {
    const Opened opened =
        openSlave(with([](SlaveTraits& foreign) { foreign.maxDto = 14; })); // several packets a sample
    std::size_t number = 0;
    opened.slave->bendSample = [&](Packet& packet) {
        if (++number % 11 == 4) {
            packet.clear();
        }
    };
    Recording recording;
    ASSERT_TRUE(opened.device->startStream({{"count", "wave", "big"}, 100.0},
                                           [&](const SampleBlockPtr& block) { recording.append(*block); }));
    ASSERT_TRUE(opened.device->clock().waitFor(3.0));
    ASSERT_GT(recording.rows(), 100U);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        const double count = recording.values[3 * row];
        EXPECT_EQ(recording.values[3 * row + 1], count / 4.0);
        EXPECT_EQ(recording.values[3 * row + 2], count / 8.0);
    }
    EXPECT_GT(recording.lostRows, 0U);
    EXPECT_GT(opened.device->statistics().packetsDamaged, 0U);
}

} // namespace
} // namespace halbench::devices::xcp
