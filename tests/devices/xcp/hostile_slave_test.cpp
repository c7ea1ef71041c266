#include "devices/xcp/xcp_device.h"
#include "tests/devices/xcp/test_slave.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::devices::xcp {
namespace {

/// Nobody waits longer for a board that does not do its part (resources/help/protocol.md, gate 6), plus the
/// time it took to notice.
constexpr double Patience_s = 2.0;

struct Attempt {
    TestSlave* slave = nullptr; ///< lives as long as the device
    Result<std::unique_ptr<Device>> device;
};

Attempt attempt(const std::function<void(TestSlave&)>& prepare, const SlaveTraits& traits = {}) {
    auto slave = std::make_unique<TestSlave>(traits);
    TestSlave* raw = slave.get();
    prepare(*raw);
    return {raw, openXcpDevice(std::move(slave), {})};
}

bool isCommand(const Packet& packet, Command command) {
    return packet[0] == static_cast<std::uint8_t>(command);
}

/// What each answer may become: every octet count, every first octet.
TEST(HostileSlave, noAnswerCutShortIsBelievedOrCrashes) {
    for (const Command victim : {Command::Connect, Command::GetStatus, Command::GetId, Command::Upload,
                                 Command::ShortUpload, Command::GetCalPage, Command::GetDaqProcessorInfo,
                                 Command::GetDaqResolutionInfo, Command::GetDaqEventInfo}) {
        for (std::size_t size = 0; size < 8; ++size) {
            const Attempt opened = attempt([&](TestSlave& slave) {
                slave.bendAnswers = [=](const Packet& command, std::deque<Packet>& answers) {
                    if (isCommand(command, victim) && !answers.empty()) {
                        answers[0].resize(std::min(size, answers[0].size()));
                    }
                };
            });
            if (!opened.device) {
                EXPECT_FALSE(opened.device.error().message.empty());
                EXPECT_FALSE(opened.device.error().hint.empty());
            }
        }
    }
}

TEST(HostileSlave, anAnswerThatIsTooShortIsAProtocolErrorThatNamesTheCommand) {
    const Attempt opened = attempt([](TestSlave& slave) {
        slave.bendAnswers = [](const Packet& command, std::deque<Packet>& answers) {
            if (isCommand(command, Command::GetStatus)) {
                answers = {{0xFF, 0x00}};
            }
        };
    });
    ASSERT_FALSE(opened.device);
    EXPECT_EQ(opened.device.error().code, ErrorCode::Protocol);
    EXPECT_NE(opened.device.error().message.find("GET_STATUS"), std::string::npos);
}

TEST(HostileSlave, silenceEndsAsDeviceLostWithinTwoSeconds) {
    for (const Command victim :
         {Command::Connect, Command::GetStatus, Command::Upload, Command::ShortUpload}) {
        TestSlave* slave = nullptr;
        double silentSince_s = -1.0;
        double openedAt_s = 0.0;
        {
            auto owned = std::make_unique<TestSlave>();
            slave = owned.get();
            slave->bendAnswers = [&](const Packet& command, std::deque<Packet>& answers) {
                if (silentSince_s < 0.0 && isCommand(command, victim)) {
                    silentSince_s = slave->now_s();
                }
                if (silentSince_s >= 0.0) {
                    answers.clear();
                    openedAt_s = slave->now_s();
                }
            };
            const auto device = openXcpDevice(std::move(owned), {});
            ASSERT_FALSE(device);
            EXPECT_EQ(device.error().code, ErrorCode::DeviceLost);
        }
        EXPECT_LE(openedAt_s - silentSince_s, Patience_s) << commandName(static_cast<std::uint8_t>(victim));
    }
}

TEST(HostileSlave, aFloodOfEventsNeitherHangsNorHidesTheAnswer) {
    const Attempt opened = attempt([](TestSlave& slave) {
        slave.bendAnswers = [](const Packet&, std::deque<Packet>& answers) {
            for (int i = 0; i < 2000; ++i) {
                answers.push_front({0xFD, static_cast<std::uint8_t>(i % 2 == 0 ? 0x06 : 0xFE), 0x01});
                answers.push_front({0xFC, 0x01, 'h', 'i'});
            }
        };
    });
    EXPECT_TRUE(opened.device);
}

TEST(HostileSlave, askingForMoreTimeForEverEndsWithinTwoSeconds) {
    TestSlave* slave = nullptr;
    auto owned = std::make_unique<TestSlave>();
    slave = owned.get();
    double last_s = 0.0;
    slave->bendAnswers = [&](const Packet& command, std::deque<Packet>& answers) {
        last_s = slave->now_s();
        if (isCommand(command, Command::GetStatus)) {
            answers.assign(3000000, {0xFD, 0x05}); // 0.3 s of them on the slave's clock, again and again
        } else if (isCommand(command, Command::Synch)) {
            answers.clear();
        }
    };
    const auto device = openXcpDevice(std::move(owned), {});
    ASSERT_FALSE(device);
    EXPECT_LE(last_s, Patience_s + 1.0);
}

TEST(HostileSlave, aDescriptionThatIsNonsenseIsADeviceErrorWithItsPlace) {
    for (const char* text :
         {"x", "/begin PROJECT", "/begin PROJECT p \"\" /end MODULE", "\"", "/begin /begin"}) {
        const Attempt opened = attempt([&](TestSlave& slave) { slave.descriptionText = text; });
        ASSERT_FALSE(opened.device) << text;
        EXPECT_EQ(opened.device.error().code, ErrorCode::Protocol);
        EXPECT_NE(opened.device.error().message.find("description"), std::string::npos);
    }
}

/// The slave's own description, as it uploads it.
std::string wholeDescription() {
    std::string text;
    const Attempt opened = attempt([&](TestSlave& slave) {
        slave.bendAnswers = [&](const Packet& command, std::deque<Packet>& answers) {
            if (isCommand(command, Command::Upload) && !answers.empty()) {
                text.append(answers[0].begin() + 1, answers[0].end());
            }
        };
    });
    EXPECT_TRUE(opened.device);
    return text;
}

TEST(HostileSlave, halfADescriptionIsCalledSoWhereverItEnds) {
    const std::string whole = wholeDescription();
    const std::size_t first = whole.find("/begin MODULE");
    ASSERT_NE(first, std::string::npos);
    const std::size_t end = whole.find_last_not_of(" \r\n") + 1; // the line's end may be missing
    for (std::size_t size = first; size < end; ++size) {
        const Attempt opened =
            attempt([&](TestSlave& slave) { slave.descriptionText = whole.substr(0, size); });
        ASSERT_FALSE(opened.device) << size;
        EXPECT_EQ(opened.device.error().code, ErrorCode::Protocol);
        EXPECT_NE(opened.device.error().message.find("ends after " + std::to_string(size) + " bytes"),
                  std::string::npos)
            << opened.device.error().message;
        EXPECT_NE(opened.device.error().hint.find("connect again"), std::string::npos);
    }
}

TEST(HostileSlave, anUploadThatEndsInTheMiddleIsALostDeviceThatNamesTheCommand) {
    int uploads = 0;
    const Attempt opened = attempt([&](TestSlave& slave) {
        slave.bendAnswers = [&](const Packet& command, std::deque<Packet>& answers) {
            uploads += isCommand(command, Command::Upload) ? 1 : 0;
            if (uploads > 5) {
                answers.clear();
            }
        };
    });
    ASSERT_FALSE(opened.device);
    EXPECT_EQ(opened.device.error().code, ErrorCode::DeviceLost);
    EXPECT_NE(opened.device.error().message.find("does not answer"), std::string::npos)
        << opened.device.error().message;
}

TEST(HostileSlave, aDescriptionLongerThanAnyoneReadsIsRefusedBeforeItIsRead) {
    std::size_t uploads = 0;
    const Attempt opened = attempt([&](TestSlave& slave) {
        slave.bendAnswers = [&](const Packet& command, std::deque<Packet>& answers) {
            uploads += isCommand(command, Command::Upload) ? 1 : 0;
            if (isCommand(command, Command::GetId) && command[1] == 4) {
                answers = {{0xFF, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0x7F}};
            }
        };
    });
    ASSERT_FALSE(opened.device);
    EXPECT_NE(opened.device.error().message.find("2147483647"), std::string::npos);
    EXPECT_EQ(uploads, 0U);
}

TEST(HostileSlave, timeStampsThatGoBackOrStandAreDropped) {
    std::size_t number = 0;
    const Attempt opened = attempt([&](TestSlave& slave) {
        slave.bendSample = [&](Packet& packet) {
            if (++number % 3 == 0) {
                for (std::size_t i = 1; i < 5; ++i) { // after the one octet identification
                    packet[i] = static_cast<std::uint8_t>(number % 2 == 0 ? 0x00 : 0x01);
                }
            }
        };
    });
    ASSERT_TRUE(opened.device);
    Recording recording;
    ASSERT_TRUE((*opened.device)->startStream({{"count"}, 100.0}, [&](const SampleBlockPtr& block) {
        recording.append(*block);
    }));
    ASSERT_TRUE((*opened.device)->clock().waitFor(1.0));
    EXPECT_GE(recording.rows(), 66U) << "two of three stamps are right";
    for (std::size_t row = 1; row < recording.rows(); ++row) {
        EXPECT_GT(recording.time_s[row], recording.time_s[row - 1]);
        EXPECT_TRUE(std::isfinite(recording.time_s[row]));
    }
}

TEST(HostileSlave, samplesOfListsThatDoNotExistAreIgnored) {
    const Attempt opened = attempt([](TestSlave& slave) {
        slave.bendSample = [&slave](Packet&) {
            slave.say({0x7F, 1, 2, 3, 4, 5, 6, 7, 8});
            slave.say({0x03});
            slave.say({});
        };
    });
    ASSERT_TRUE(opened.device);
    Recording recording;
    ASSERT_TRUE((*opened.device)->startStream({{"count"}, 100.0}, [&](const SampleBlockPtr& block) {
        recording.append(*block);
    }));
    ASSERT_TRUE((*opened.device)->clock().waitFor(1.0));
    EXPECT_GE(recording.rows(), 99U);
    EXPECT_EQ(recording.lostRows, 0U);
}

TEST(HostileSlave, aStreamThatStopsIsNoticedWithinTwoSeconds) {
    const Attempt opened = attempt([](TestSlave&) {});
    ASSERT_TRUE(opened.device);
    Device& device = **opened.device;
    ASSERT_TRUE(device.startStream({{"count"}, 100.0}, [](const SampleBlockPtr&) {}));
    ASSERT_TRUE(device.clock().waitFor(0.5));
    opened.slave->bendSample = [](Packet& packet) { packet.clear(); };
    const double start_s = device.clock().now_s();
    const auto waited = device.clock().waitFor(60.0);
    ASSERT_FALSE(waited);
    EXPECT_EQ(waited.error().code, ErrorCode::DeviceLost);
    EXPECT_LE(device.clock().now_s() - start_s, Patience_s + 0.1);
    EXPECT_FALSE(device.state().isConnected);
}

TEST(HostileSlave, aSessionEndedByTheBoardIsDeviceLostAtOnce) {
    const Attempt opened = attempt([](TestSlave&) {});
    ASSERT_TRUE(opened.device);
    opened.slave->say({0xFD, 0x07});
    const auto waited = (*opened.device)->clock().waitFor(10.0);
    ASSERT_FALSE(waited);
    EXPECT_EQ(waited.error().code, ErrorCode::DeviceLost);
    EXPECT_LT((*opened.device)->clock().now_s(), 0.1 + Patience_s);
    const std::string name = "p.a";
    EXPECT_EQ((*opened.device)->readParameters({&name, 1}).error().code, ErrorCode::DeviceLost);
}

TEST(HostileSlave, aPageOfTheFutureIsRefused) {
    const Attempt opened = attempt([](TestSlave&) {});
    ASSERT_TRUE(opened.device);
    opened.slave->bendAnswers = [](const Packet& command, std::deque<Packet>& answers) {
        if (isCommand(command, Command::GetCalPage)) {
            answers = {{0xFF, 0, 0, 17}};
        }
    };
    const ParameterValue change{"p.a", 1.0};
    const auto written = (*opened.device)->writeParameters({&change, 1});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::Protocol);
    EXPECT_EQ(opened.slave->parameter(0, 0), 0.0F);
}

TEST(HostileSlave, aPageOfTheFutureIsRefusedWhenConnectingToo) {
    const Attempt opened = attempt([](TestSlave& slave) {
        slave.bendAnswers = [](const Packet& command, std::deque<Packet>& answers) {
            if (isCommand(command, Command::GetCalPage)) {
                answers = {{0xFF, 0, 0, 223}};
            }
        };
    });
    ASSERT_FALSE(opened.device);
    EXPECT_EQ(opened.device.error().code, ErrorCode::Protocol);
}

TEST(HostileSlave, valuesTheBoardChangesAreNamedAndTheOldOnesStay) {
    const Attempt opened = attempt([](TestSlave&) {});
    ASSERT_TRUE(opened.device);
    TestSlave& slave = *opened.slave;
    const std::uint8_t before = slave.runningPage();
    slave.bendAnswers = [](const Packet& command, std::deque<Packet>& answers) {
        if (isCommand(command, Command::BuildChecksum)) { // what a board that clamped a value would answer
            answers[0][4] = static_cast<std::uint8_t>(answers[0][4] ^ 0x01);
        }
        if (isCommand(command, Command::Upload) || isCommand(command, Command::ShortUpload)) {
            const bool isSegment = answers[0].size() > 40;
            if (isSegment) {
                answers[0][6] = static_cast<std::uint8_t>(answers[0][6] ^ 0x10); // inside p.b
            }
        }
    };
    const ParameterValue change{"p.a", 1.0};
    const auto written = (*opened.device)->writeParameters({&change, 1});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::DeviceRefused);
    EXPECT_EQ(slave.runningPage(), before);
}

TEST(BadValues, areRefusedBeforeTheFirstOctetIsSent) {
    const Attempt opened = attempt([](TestSlave&) {});
    ASSERT_TRUE(opened.device);
    const std::size_t before = opened.slave->commands.size();
    const auto code = [&](const ParameterValue& bad) {
        const std::vector<ParameterValue> set = {{"p.b", 1.0}, bad};
        return (*opened.device)->writeParameters(set).error().code;
    };
    EXPECT_EQ(code({"p.a", std::nan("")}), ErrorCode::NotFinite);
    EXPECT_EQ(code({"p.a", std::numeric_limits<double>::infinity()}), ErrorCode::NotFinite);
    EXPECT_EQ(code({"p.a", 1000.5}), ErrorCode::OutOfRange);
    EXPECT_EQ(code({"p.n", 1.5}), ErrorCode::OutOfRange);
    EXPECT_EQ(code({"p.x", 1.0}), ErrorCode::UnknownName);
    EXPECT_EQ(opened.slave->commands.size(), before);
}

} // namespace
} // namespace halbench::devices::xcp
