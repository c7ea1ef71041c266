#include "devices/xcp/xcp_device.h"
#include "tests/devices/xcp/test_slave.h"

#include <gtest/gtest.h>

namespace halbench::devices::xcp {
namespace {

using Bend = std::function<void(const Packet&, std::deque<Packet>&)>;

struct Disturbance {
    const char* name;
    std::function<void(std::deque<Packet>&)> spoil;
};

void PrintTo(const Disturbance& disturbance, std::ostream* out) {
    *out << disturbance.name;
}

/// Opens, streams, writes a set and reads it back; values must be right whatever was disturbed.
void doTheWork(Device& device) {
    Recording recording;
    const auto started = device.startStream({{"count", "wave", "big"}, 100.0},
                                            [&](const SampleBlockPtr& block) { recording.append(*block); });
    ASSERT_TRUE(started) << started.error().message;
    ASSERT_TRUE(device.clock().waitFor(0.5));
    for (int i = 1; i <= 20; ++i) {
        const std::vector<ParameterValue> change = {{"p.a", 1.0 * i}, {"p.b", 2.0 * i}, {"p.n", 3.0 * i}};
        const auto written = device.writeParameters(change);
        ASSERT_TRUE(written) << written.error().message;
        const std::vector<std::string> names = {"p.a", "p.b", "p.n"};
        const auto values = device.readParameters(names);
        ASSERT_TRUE(values);
        ASSERT_EQ(*values, (std::vector<double>{1.0 * i, 2.0 * i, 3.0 * i}));
    }
    device.stopStream();
    ASSERT_GT(recording.rows(), 45U);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        ASSERT_EQ(recording.values[3 * row + 1], recording.values[3 * row] / 4.0);
        ASSERT_EQ(recording.values[3 * row + 2], recording.values[3 * row] / 8.0);
    }
}

class Recovery : public testing::TestWithParam<Disturbance> {};

TEST_P(Recovery, everySeventhAnswerDisturbedChangesNoValue) {
    for (const std::size_t phase : {0U, 1U, 2U, 3U, 4U, 5U, 6U}) {
        auto slave = std::make_unique<TestSlave>(SlaveTraits{});
        std::size_t number = phase;
        slave->bendAnswers = [&](const Packet& command, std::deque<Packet>& answers) {
            const bool isSynch = command[0] == static_cast<std::uint8_t>(Command::Synch);
            if (++number % 7 == 0 && !answers.empty() && !isSynch) {
                GetParam().spoil(answers);
            }
        };
        const auto device = openXcpDevice(std::move(slave), {});
        ASSERT_TRUE(device) << phase << ": " << device.error().message;
        doTheWork(**device);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Answers, Recovery,
    testing::Values(Disturbance{"lost", [](std::deque<Packet>& answers) { answers.clear(); }},
                    Disturbance{"repeated",
                                [](std::deque<Packet>& answers) { answers.push_back(answers[0]); }},
                    Disturbance{"cutShort", [](std::deque<Packet>& answers) { answers[0].resize(1); }},
                    Disturbance{"busy",
                                [](std::deque<Packet>& answers) {
                                    answers = {{0xFE, 0x10}};
                                }},
                    Disturbance{"precededByEvents",
                                [](std::deque<Packet>& answers) {
                                    answers.push_front({0xFD, 0x06});
                                    answers.push_front({0xFD, 0x05});
                                    answers.push_front({0xFC, 0x01, 'l', 'o', 'g', 0});
                                }}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(Recovery, aLateAnswerIsNotTakenForTheNextCommands) {
    auto slave = std::make_unique<TestSlave>();
    TestSlave& raw = *slave;
    const auto device = openXcpDevice(std::move(slave), {});
    ASSERT_TRUE(device);
    // One answer comes after the time-out: SYNCH discards it.
    raw.answerDelay_s = 0.6;
    std::size_t number = 0;
    raw.bendAnswers = [&](const Packet&, std::deque<Packet>&) {
        if (++number == 2) {
            raw.answerDelay_s = 0.0;
        }
    };
    doTheWork(**device);
    EXPECT_GT((*device)->statistics().commandsRepeated, 0U);
}

// A board that is held up answers every SYNCH of that time, one after the other on a slow line: the last ones
// come after the next command and are not its answers. A single one was allowed for, a longer hold was called
// a refusal ("the command queue was cleared").
TEST(Recovery, answersToOldSynchronisationsAreNotTakenForTheNextCommands) {
    constexpr double LinePeriod_s = 0.02;
    for (const double hold_s : {0.6, 1.1, 1.6}) {
        for (const std::size_t heldCommand : {1U, 2U, 3U, 4U, 5U, 6U, 9U, 14U}) {
            SCOPED_TRACE(testing::Message() << hold_s << " s, command " << heldCommand);
            auto slave = std::make_unique<TestSlave>();
            TestSlave& raw = *slave;
            const auto device = openXcpDevice(std::move(slave), {});
            ASSERT_TRUE(device);
            std::size_t number = 0;
            double due_s = 0.0;
            raw.bendAnswers = [&](const Packet&, std::deque<Packet>&) {
                ++number;
                due_s = std::max(due_s, raw.now_s()) + LinePeriod_s + (number == heldCommand ? hold_s : 0.0);
                raw.answerDelay_s = due_s - raw.now_s();
            };
            const std::vector<ParameterValue> change = {{"p.a", 3.0}, {"p.b", 4.0}, {"p.n", 5.0}};
            const auto written = (*device)->writeParameters(change);
            ASSERT_TRUE(written) << written.error().message;
            const std::vector<std::string> names = {"p.a", "p.b", "p.n"};
            const auto values = (*device)->readParameters(names);
            ASSERT_TRUE(values) << values.error().message;
            EXPECT_EQ(*values, (std::vector<double>{3.0, 4.0, 5.0}));
        }
    }
}

// What a board said of an earlier session may still be on its way when the next one begins: a line that was
// put back, an event of the watchdog behind it.
TEST(Recovery, theEndOfAnEarlierSessionEndsNoNewOne) {
    for (const bool isBeforeAnswer : {false, true}) {
        SCOPED_TRACE(isBeforeAnswer ? "between request and answer" : "before the request");
        auto slave = std::make_unique<TestSlave>();
        const Packet sessionTerminated = {0xFD, 0x07};
        if (isBeforeAnswer) {
            slave->bendAnswers = [&](const Packet& command, std::deque<Packet>& answers) {
                if (command[0] == static_cast<std::uint8_t>(Command::Connect)) {
                    answers.push_front(sessionTerminated);
                }
            };
        } else {
            slave->say(sessionTerminated);
        }
        const auto device = openXcpDevice(std::move(slave), {});
        ASSERT_TRUE(device) << device.error().message;
        doTheWork(**device);
    }
}

TEST(Recovery, repeatedDownloadsStartFromTheirAddress) {
    // An answer lost after DOWNLOAD leaves the transfer pointer moved: the repetition must set it again
    // (3.6).
    SlaveTraits traits;
    traits.hasShortDownload = false;
    auto slave = std::make_unique<TestSlave>(traits);
    TestSlave& raw = *slave;
    const auto device = openXcpDevice(std::move(slave), {});
    ASSERT_TRUE(device);
    std::size_t downloads = 0;
    raw.bendAnswers = [&](const Packet& command, std::deque<Packet>& answers) {
        if (command[0] == static_cast<std::uint8_t>(Command::Download) && ++downloads % 2 == 1) {
            answers.clear();
        }
    };
    doTheWork(**device);
}

TEST(Recovery, unpluggedAtAnyCommandIsDeviceLostAndNeverACrash) {
    std::size_t total = 0;
    {
        auto slave = std::make_unique<TestSlave>();
        TestSlave& raw = *slave;
        const auto device = openXcpDevice(std::move(slave), {});
        ASSERT_TRUE(device);
        const ParameterValue change{"p.a", 1.0};
        ASSERT_TRUE((*device)->writeParameters({&change, 1}));
        ASSERT_TRUE((*device)->startStream({{"count"}, 100.0}, [](const SampleBlockPtr&) {}));
        ASSERT_TRUE((*device)->clock().waitFor(0.5));
        total = raw.commands.size();
    }
    for (std::size_t at = 0; at < total; ++at) {
        auto slave = std::make_unique<TestSlave>();
        slave->unplugAtCommand = at;
        const auto device = openXcpDevice(std::move(slave), {});
        Result<void> result;
        if (!device) {
            result = failure(device.error());
        }
        if (device) {
            const ParameterValue change{"p.a", 1.0};
            result = (*device)->writeParameters({&change, 1});
            if (result) {
                result = (*device)->startStream({{"count"}, 100.0}, [](const SampleBlockPtr&) {});
            }
            if (result) {
                result = (*device)->clock().waitFor(5.0);
            }
            EXPECT_FALSE((*device)->state().isConnected) << at;
            (*device)->stop();
        }
        ASSERT_FALSE(result) << at;
        EXPECT_EQ(result.error().code, ErrorCode::DeviceLost) << at << ": " << result.error().message;
    }
}

} // namespace
} // namespace halbench::devices::xcp
