#include "devices/simulated/fault_transport.h"
#include "devices/simulated/htm/simulated_htm.h"
#include "devices/simulated/loopback_transport.h"
#include "devices/simulated/registry/simulated_device.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace halbench::devices {
namespace {

const std::vector<std::uint8_t> Connect = {0xFF, 0x00};
const std::vector<std::uint8_t> GetStatus = {0xFD};

std::shared_ptr<SimulatedBoard> board(std::uint64_t seed = 1) {
    return *makeSimulatedHtm(models::HtmParameters{}, seed);
}

TEST(Loopback, answersWithoutLettingTimePass) {
    LoopbackTransport link(board(), false);
    ASSERT_TRUE(link.open());
    ASSERT_TRUE(link.send(Connect));
    std::vector<std::uint8_t> packet;
    ASSERT_TRUE(*link.receive(packet, 1.0));
    EXPECT_EQ(packet[0], 0xFF);
    EXPECT_EQ(link.now_s(), 0.0);
    EXPECT_EQ(link.statistics().packetsReceived, 1U);
    EXPECT_EQ(link.statistics().packetsSent, 1U);
}

TEST(Loopback, timePassesOnlyWhileSomebodyWaits) {
    const auto simulated = board();
    LoopbackTransport link(simulated, false);
    ASSERT_TRUE(link.open());
    std::vector<std::uint8_t> packet;
    EXPECT_FALSE(*link.receive(packet, 0.0));
    EXPECT_EQ(simulated->time_s(), 0.0);
    EXPECT_FALSE(*link.receive(packet, 0.0254));
    EXPECT_NEAR(link.now_s(), 0.0254, 1e-12);
    EXPECT_NEAR(simulated->time_s(), 0.025, 1e-12); // whole ticks
    for (int i = 0; i < 10; ++i) {
        EXPECT_FALSE(*link.receive(packet, 0.0004)); // pieces of a tick add up
    }
    EXPECT_NEAR(simulated->time_s(), 0.029, 1e-12);
}

TEST(Loopback, isDeadWhenClosed) {
    LoopbackTransport link(board(), false);
    std::vector<std::uint8_t> packet;
    EXPECT_EQ(link.send(Connect).error().code, ErrorCode::DeviceLost);
    ASSERT_TRUE(link.open());
    link.close();
    EXPECT_EQ(link.receive(packet, 1.0).error().code, ErrorCode::DeviceLost);
}

TEST(Loopback, dropsWhatWasMeantForTheMasterBefore) {
    const auto simulated = board();
    LoopbackTransport first(simulated, false);
    ASSERT_TRUE(first.open());
    ASSERT_TRUE(first.send(Connect));
    LoopbackTransport second(simulated, false);
    ASSERT_TRUE(second.open());
    std::vector<std::uint8_t> packet;
    EXPECT_FALSE(*second.receive(packet, 0.01));
}

TEST(Loopback, pacedByTheWallClockItTakesAsLong) {
    LoopbackTransport link(board(), true);
    ASSERT_TRUE(link.open());
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::uint8_t> packet;
    EXPECT_FALSE(*link.receive(packet, 0.05));
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    EXPECT_GE(wall.count(), 0.049); // never ahead of the wall clock; a loaded machine may take longer
}

class Faults : public ::testing::Test {
protected:
    Faults() : faults(std::make_shared<LinkFaults>()), link(loopback(), faults, 7) {
        EXPECT_TRUE(link.open());
        EXPECT_TRUE(link.send(Connect));
        EXPECT_TRUE(*link.receive(packet, 0.1));
    }

    static std::unique_ptr<Transport> loopback() {
        return std::make_unique<LoopbackTransport>(board(), false);
    }

    int answersOf(int commands) {
        int answers = 0;
        for (int i = 0; i < commands; ++i) {
            EXPECT_TRUE(link.send(GetStatus));
            const auto received = link.receive(packet, 0.002);
            answers += received && *received;
        }
        return answers;
    }

    std::shared_ptr<LinkFaults> faults;
    FaultTransport link;
    std::vector<std::uint8_t> packet;
};

TEST_F(Faults, noneChangesNothing) {
    EXPECT_EQ(answersOf(100), 100);
}

TEST_F(Faults, unpluggedAtItsTimeEverythingFails) {
    faults->unplugAt_s = link.now_s() + 0.5;
    EXPECT_FALSE(*link.receive(packet, 0.4));
    EXPECT_TRUE(link.send(GetStatus));
    EXPECT_TRUE(*link.receive(packet, 0.01));
    (void)link.receive(packet, 0.2);
    EXPECT_EQ(link.send(GetStatus).error().code, ErrorCode::DeviceLost);
    EXPECT_EQ(link.receive(packet, 0.2).error().code, ErrorCode::DeviceLost);
}

TEST_F(Faults, mutedAndStalledLinksStaySilentWhileTimePasses) {
    for (bool LinkFaults::*silence : {&LinkFaults::isMute, &LinkFaults::isStalled}) {
        *faults = {};
        (*faults).*silence = true;
        const double before_s = link.now_s();
        EXPECT_EQ(answersOf(10), 0);
        EXPECT_NEAR(link.now_s() - before_s, 0.020, 1e-9);
    }
}

TEST_F(Faults, dropsAsManyAsAskedFor) {
    faults->dropReceived_ratio = 0.3;
    EXPECT_NEAR(answersOf(1000), 700, 45); // three standard deviations of the binomial
}

TEST_F(Faults, flipsOneBitOfAPacket) {
    ASSERT_TRUE(link.send(GetStatus));
    ASSERT_TRUE(*link.receive(packet, 0.01));
    const std::vector<std::uint8_t> good = packet;
    faults->corruptReceived_ratio = 1.0;
    ASSERT_TRUE(link.send(GetStatus));
    ASSERT_TRUE(*link.receive(packet, 0.01));
    int flipped = 0;
    for (std::size_t i = 0; i < good.size(); ++i) {
        flipped += __builtin_popcount(static_cast<unsigned>(good[i] ^ packet[i]));
    }
    EXPECT_EQ(flipped, 1);
}

TEST(SimulatedDevice, opensWithTruthAndTellsWhoItIs) {
    const auto uri = parseDeviceUri("sim:htm?seed=7&c=2e-3");
    OpenOptions options;
    options.seed = 3;
    const auto device = openSimulatedDevice(*uri, options);
    ASSERT_TRUE(device) << device.error().message;
    const DeviceInfo& info = (*device)->info();
    EXPECT_EQ(info.model, "htm");
    EXPECT_EQ(info.id, "sim-htm-3");
    EXPECT_TRUE(info.isSimulated);
    EXPECT_EQ(info.transport, "loopback");
    EXPECT_EQ(info.overrides.size(), 2U);
    EXPECT_NE((*device)->catalogue().findSignal("truth.position"), nullptr);
    EXPECT_NE((*device)->catalogue().findSignal("truth.speed"), nullptr);
}

TEST(SimulatedDevice, hasSampledItsSensorsBeforeAnybodyAsks) {
    const auto device = openSimulatedDevice(*parseDeviceUri("sim:htm?imperfections=off&psi0=0.5"), {});
    ASSERT_TRUE(device) << device.error().message;
    EXPECT_EQ((*device)->clock().now_s(), 0.0);
    const std::string names[] = {"hall.a", "hall.b", "position", "coil_temperature.a", "truth.position"};
    const std::vector<double> values = *(*device)->readSignals(names);
    constexpr double Step_T = 0.39e-3; // of the converter; half of it is the largest rounding
    EXPECT_NEAR(values[0], 0.157 * std::cos(0.5), 0.51 * Step_T);
    EXPECT_NEAR(values[1], 0.157 * std::sin(0.5), 0.51 * Step_T);
    EXPECT_NEAR(values[2], 0.5, Step_T / 0.157);
    EXPECT_NEAR(values[3], 25.0, 0.25); // half a count of 0.488 degC
    EXPECT_EQ(values[4], 0.5);
}

TEST(SimulatedDevice, startsWithWhatItsBoardWasBuiltFor) {
    const auto value = [](const char* text, const std::string& name) {
        const auto device = openSimulatedDevice(*parseDeviceUri(text), {});
        const std::string names[] = {name};
        return (*device)->readParameters(names)->front();
    };
    EXPECT_EQ(value("sim:htm", "gain.kp"), 10.0); // preset "published"
    EXPECT_NEAR(value("sim:htm", "stray.coefficient"), 2.5e-3, 1e-9);
    EXPECT_EQ(value("sim:htm?imperfections=off", "stray.coefficient"), 0.0);
    EXPECT_NEAR(value("sim:htm?stray_mT_per_A=4", "stray.coefficient"), 2.5e-3, 1e-9); // to be calibrated
    EXPECT_EQ(value("sim:htm?Imax=3", "limit.current"), 3.0);
    EXPECT_EQ(value("sim:htm?delay_samples=2", "delay.samples"), 2.0);
}

} // namespace
} // namespace halbench::devices
