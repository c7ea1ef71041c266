#include "devices/simulated/fault_transport.h"
#include "devices/simulated/htm/simulated_htm.h"
#include "devices/simulated/loopback_transport.h"
#include "devices/xcp/xcp_device.h"
#include "devices/xcp/xcp_master.h"
#include "tests/devices/xcp/spoiled_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::devices::xcp {
namespace {

// A start is an act: what the line loses must not make it happen twice (resources/help/protocol.md 3.15).

constexpr double Late_s = 0.3; // longer than an armed master waits: a tenth of its watchdog's second
constexpr double Step_rad = 1.0;

/// A write of one octet to the address.
SpoiledLine::IsMeant writeTo(std::uint32_t address) {
    return [address](std::span<const std::uint8_t> packet) {
        return packet.size() == 9 && packet[0] == 0xED &&
               packet[4] + 256U * packet[5] + 65536U * packet[6] + 16777216U * packet[7] == address;
    };
}

enum class Firmware { Now, Before0_3 };

struct Bench {
    std::shared_ptr<SimulatedBoard> board;
    std::shared_ptr<LinkOrders> orders = std::make_shared<LinkOrders>();
    SpoiledLine* line = nullptr;
    std::unique_ptr<Device> device;

    std::uint32_t live(std::size_t offset) const { return 0x8000U + static_cast<std::uint32_t>(offset); }
    Result<void> write(const std::string& name, double value) {
        const ParameterValue change[] = {{name, value}};
        return device->writeParameters(change);
    }
    double signal(const std::string& name) {
        const auto values = device->readSignals(std::vector<std::string>{name});
        EXPECT_TRUE(values) << values.error().message;
        return values ? values->front() : NAN;
    }
    bool isRunning() const { return htmFirmware(*board).reference.running != 0; }
};

std::string descriptionOf(const std::shared_ptr<SimulatedBoard>& board) {
    XcpLink link(std::make_unique<LoopbackTransport>(board, false));
    XcpMaster master(link);
    EXPECT_TRUE(link.transport().open());
    EXPECT_TRUE(master.connect(1.0));
    const auto text = master.description([](std::size_t) { return std::nullopt; });
    master.disconnect();
    return text.value_or("");
}

/// Up to 0.2.0 the upper limit of a start was 1, and each write of it started.
std::string withoutOrders(std::string text) {
    for (const char* name : {"reference.start", "capture.start"}) {
        const std::size_t begin = text.find(std::string("CHARACTERISTIC ") + name);
        const std::size_t place = text.rfind(" 255", text.find("/end CHARACTERISTIC", begin));
        EXPECT_NE(place, std::string::npos);
        text.replace(place, 4, " 1");
    }
    return text;
}

Bench openBench(Firmware firmware) {
    Bench bench;
    auto board = makeSimulatedHtm({}, 1);
    EXPECT_TRUE(board);
    bench.board = std::shared_ptr<SimulatedBoard>(std::move(*board));
    XcpDeviceOptions options;
    options.orders = bench.orders;
    if (firmware == Firmware::Before0_3) {
        options.description = withoutOrders(descriptionOf(bench.board));
    }
    auto line = std::make_unique<SpoiledLine>(bench.board, Late_s);
    bench.line = line.get();
    auto device = openXcpDevice(std::move(line), std::move(options));
    EXPECT_TRUE(device) << device.error().message;
    bench.device = std::move(*device);
    return bench;
}

/// In mode position, about to make a step that is over before its start could be repeated.
Bench readyToStep(Firmware firmware) {
    Bench bench = openBench(firmware);
    for (const auto& [name, value] : {std::pair{"hb.mode", 2.0},
                                      {"reference.shape", 1.0},
                                      {"reference.amplitude", Step_rad},
                                      {"reference.duration", 0.1}}) {
        EXPECT_TRUE(bench.write(name, value)) << name;
    }
    EXPECT_TRUE(bench.device->arm());
    EXPECT_TRUE(bench.device->clock().waitFor(0.05));
    bench.line->isMeant = writeTo(bench.live(offsetof(hb_htm_live, board.reference_start)));
    return bench;
}

class CommandOnce : public testing::TestWithParam<Loss> {};

TEST_P(CommandOnce, aStartMovesByOneStepWhateverIsLost) {
    Bench bench = readyToStep(Firmware::Now);
    const double before_rad = bench.signal("reference");
    for (int step = 1; step <= 3; ++step) {
        bench.line->loss = GetParam();
        const auto started = bench.write("reference.start", 1.0);
        ASSERT_TRUE(started) << started.error().message;
        ASSERT_TRUE(bench.device->clock().waitFor(1.0));
        // a float near 3 rad
        EXPECT_NEAR(bench.signal("reference") - before_rad, step * Step_rad, 1e-6) << step;
    }
    EXPECT_EQ(bench.line->sent, GetParam() == Loss::None ? 3 : 6) << "each loss costs a repetition";
}

TEST_P(CommandOnce, aStartWhileItRunsBeginsAnewOnceWhateverIsLost) {
    Bench bench = readyToStep(Firmware::Now);
    const double before_rad = bench.signal("reference");
    ASSERT_TRUE(bench.write("reference.duration", 100.0));
    for (int start = 1; start <= 2; ++start) {
        bench.line->loss = GetParam();
        ASSERT_TRUE(bench.write("reference.start", 1.0));
        ASSERT_TRUE(bench.device->clock().waitFor(0.5));
        EXPECT_TRUE(bench.isRunning());
        EXPECT_NEAR(bench.signal("reference") - before_rad, start * Step_rad, 1e-6) << start;
    }
}

TEST_P(CommandOnce, aStopStopsWhateverIsLost) {
    for (const Firmware firmware : {Firmware::Now, Firmware::Before0_3}) {
        Bench bench = readyToStep(firmware);
        ASSERT_TRUE(bench.write("reference.duration", 100.0));
        ASSERT_TRUE(bench.write("reference.start", 1.0));
        ASSERT_TRUE(bench.device->clock().waitFor(0.1));
        bench.line->loss = GetParam();
        ASSERT_TRUE(bench.write("reference.start", 0.0));
        EXPECT_FALSE(bench.isRunning());
    }
}

TEST_P(CommandOnce, aCaptureBeginsOnceWhateverIsLost) {
    Bench bench = openBench(Firmware::Now);
    bench.line->isMeant = writeTo(bench.live(offsetof(hb_htm_live, capture.start)));
    bench.line->loss = GetParam();
    const double sent_s = bench.board->time_s();
    ASSERT_TRUE(bench.write("capture.start", 1.0));
    ASSERT_TRUE(bench.device->clock().waitFor(0.1));
    // Triggered at once: at the next tick, or, when the command was lost, after the time-out of 0.5 s at
    // most; a repetition that began anew would show there, too.
    const double began_s = bench.signal("capture.time") - sent_s;
    if (GetParam() == Loss::Command) {
        EXPECT_GT(began_s, 0.1);
    } else {
        EXPECT_NEAR(began_s, 0.001, 0.0015);
    }
    ASSERT_TRUE(bench.device->clock().waitFor(5.0));
    EXPECT_EQ(bench.signal("capture.state"), 4.0) << "full, and not begun again";
}

TEST_P(CommandOnce, anOlderBoardIsStoppedWhenNobodyKnowsWhetherItStarted) {
    Bench bench = readyToStep(Firmware::Before0_3);
    ASSERT_TRUE(bench.write("reference.duration", 100.0));
    const double before_rad = bench.signal("reference");
    bench.line->loss = GetParam();
    const auto started = bench.write("reference.start", 1.0);
    ASSERT_TRUE(bench.device->clock().waitFor(0.5));
    if (GetParam() == Loss::None) {
        ASSERT_TRUE(started) << started.error().message;
        EXPECT_TRUE(bench.isRunning());
        return;
    }
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().code, ErrorCode::Protocol);
    EXPECT_NE(started.error().message.find("reference.start"), std::string::npos) << started.error().message;
    EXPECT_NE(started.error().message.find("its start was not confirmed"), std::string::npos)
        << started.error().message;
    EXPECT_FALSE(bench.isRunning());
    const double moved_rad = bench.signal("reference") - before_rad;
    EXPECT_NEAR(moved_rad, GetParam() == Loss::Command ? 0.0 : Step_rad, 1e-6) << "at most once";
    EXPECT_TRUE(bench.device->state().isConnected) << "one lost answer is no lost board";
    EXPECT_TRUE(bench.write("reference.start", 1.0)) << "the next one goes through";
}

INSTANTIATE_TEST_SUITE_P(Lost, CommandOnce,
                         testing::Values(Loss::None, Loss::Command, Loss::Answer, Loss::AnswerLate),
                         nameOfLoss);

TEST(CommandOnceStopped, aStartIsNotRepeatedAfterAStop) {
    for (const Firmware firmware : {Firmware::Now, Firmware::Before0_3}) {
        for (const Loss loss : {Loss::Command, Loss::Answer}) {
            Bench bench = readyToStep(firmware);
            bench.line->loss = loss;
            bench.line->onSpoiling = [orders = bench.orders] { ++orders->stops; }; // another thread
            const auto started = bench.write("reference.start", 1.0);
            ASSERT_FALSE(started);
            EXPECT_EQ(started.error().code, ErrorCode::Interrupted) << started.error().message;
            EXPECT_EQ(bench.line->sent, 2) << "the start once, then its end";
            EXPECT_FALSE(bench.isRunning());
            EXPECT_EQ(bench.board->firmware().safety.armed, 0);
        }
    }
}

TEST(CommandOnceRefused, aRefusalIsToldAsItIs) {
    for (const Firmware firmware : {Firmware::Now, Firmware::Before0_3}) {
        Bench bench = openBench(firmware);
        const auto started = bench.write("reference.start", 1.0); // not armed
        ASSERT_FALSE(started);
        EXPECT_EQ(started.error().code, ErrorCode::DeviceRefused);
        EXPECT_EQ(started.error().hint, "check the value and the board's state") << "the line was good";
    }
}

TEST(CommandOnceRefused, aLineThatSpoiledSomethingIsASuspectToo) {
    for (const Loss loss : {Loss::Command, Loss::Answer}) {
        Bench bench = openBench(Firmware::Now);
        bench.line->isMeant = writeTo(bench.live(offsetof(hb_htm_live, capture.start)));
        bench.line->loss = loss;
        ASSERT_TRUE(bench.write("capture.start", 1.0));
        const auto started = bench.write("reference.start", 1.0); // not armed
        ASSERT_FALSE(started);
        EXPECT_EQ(started.error().hint, "the line has lost or damaged packets (so far 1): check the line, "
                                        "then the value and the board's state");
    }
}

TEST(CommandOnceNoisy, aHundredSmallStepsAddUpOnALineThatLosesOneMessageInFifty) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        auto made = makeSimulatedHtm({}, seed);
        ASSERT_TRUE(made);
        const auto board = std::shared_ptr<SimulatedBoard>(std::move(*made));
        const auto faults = std::make_shared<LinkFaults>();
        auto device = openXcpDevice(
            std::make_unique<FaultTransport>(std::make_unique<LoopbackTransport>(board, false), faults, seed),
            {});
        ASSERT_TRUE(device);
        const ParameterValue generator[] = {{"hb.mode", 2.0},
                                            {"reference.shape", 1.0},
                                            {"reference.amplitude", 0.01},
                                            {"reference.duration", 0.02}};
        ASSERT_TRUE((*device)->writeParameters(generator));
        ASSERT_TRUE((*device)->arm());
        ASSERT_TRUE((*device)->clock().waitFor(0.05));
        const float before_rad = htmFirmware(*board).signals.reference;
        faults->dropReceived_ratio = faults->dropSent_ratio = 0.02;
        for (int i = 0; i < 100; ++i) {
            const ParameterValue start[] = {{"reference.start", 1.0}};
            const auto started = (*device)->writeParameters(start);
            ASSERT_TRUE(started) << i << ": " << started.error().message;
            ASSERT_TRUE((*device)->clock().waitFor(0.05));
        }
        EXPECT_GT((*device)->statistics().commandsRepeated, 0U);
        // 100 additions of float steps near 1 rad: less than 1e-5
        EXPECT_NEAR(static_cast<double>(htmFirmware(*board).signals.reference - before_rad), 1.0, 1e-5)
            << seed;
    }
}

} // namespace
} // namespace halbench::devices::xcp
