#include "devices/simulated/fault_transport.h"
#include "devices/simulated/htm/simulated_htm.h"
#include "devices/simulated/loopback_transport.h"
#include "devices/simulated/simulated_board.h"
#include "devices/xcp/xcp_device.h"
#include "tests/devices/xcp/test_slave.h"

#include <gtest/gtest.h>

namespace halbench::devices::xcp {
namespace {

constexpr std::uint8_t UserCommand = 0xF1;
constexpr std::uint8_t Stop = 0x45;

/// Loses the answer of one command and asks for a stop a while later, as another thread would.
class LossyLine : public Transport {
public:
    LossyLine(std::unique_ptr<Transport> transport, std::shared_ptr<LinkFaults> faults,
              std::shared_ptr<LinkOrders> orders)
        : m_transport(std::move(transport)), m_faults(std::move(faults)), m_orders(std::move(orders)) {}

    std::optional<std::uint8_t> loses; ///< the next answer of this command
    double asked_s = 0.0;
    std::optional<double> sent_s; ///< when the stop went out

    Result<void> open() override { return m_transport->open(); }
    void close() noexcept override { m_transport->close(); }
    double now_s() const override { return m_transport->now_s(); }
    TransportStatistics statistics() const override { return m_transport->statistics(); }
    std::string description() const override { return m_transport->description(); }

    Result<void> send(std::span<const std::uint8_t> packet) override {
        if (packet[0] == UserCommand && packet[1] == Stop && !sent_s) {
            sent_s = now_s();
            m_faults->isStalled = false;
        } else if (loses == packet[0]) {
            loses.reset();
            m_faults->isStalled = true;
            asked_s = now_s() + 0.1;
        }
        return m_transport->send(packet);
    }
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override {
        if (m_faults->isStalled && now_s() >= asked_s) {
            m_orders->stops = 1;
        }
        return m_transport->receive(packet, timeout_s);
    }

private:
    std::unique_ptr<Transport> m_transport;
    std::shared_ptr<LinkFaults> m_faults;
    std::shared_ptr<LinkOrders> m_orders;
};

class StopOvertakes : public testing::Test {
protected:
    void SetUp() override {
        auto board = makeSimulatedHtm({}, 1);
        ASSERT_TRUE(board);
        const auto faults = std::make_shared<LinkFaults>();
        auto loopback =
            std::make_unique<LoopbackTransport>(std::shared_ptr<SimulatedBoard>(std::move(*board)), false);
        auto transport = std::make_unique<LossyLine>(
            std::make_unique<FaultTransport>(std::move(loopback), faults, 1), faults, orders);
        line = transport.get();
        XcpDeviceOptions options;
        options.orders = orders;
        auto opened = openXcpDevice(std::move(transport), std::move(options));
        ASSERT_TRUE(opened) << opened.error().message;
        device = std::move(*opened);
    }

    std::shared_ptr<LinkOrders> orders = std::make_shared<LinkOrders>();
    LossyLine* line = nullptr;
    std::unique_ptr<Device> device;
    const std::vector<std::string> names = {"gain.kp", "gain.ki", "window.speed", "hb.mode"};
};

TEST_F(StopOvertakes, aReadWhoseAnswerIsLost) {
    const auto before = device->readParameters(names);
    ASSERT_TRUE(before);
    ASSERT_TRUE(device->arm());
    line->loses = static_cast<std::uint8_t>(Command::ShortUpload);
    const auto after = device->readParameters(names);
    ASSERT_TRUE(after) << after.error().message;
    EXPECT_EQ(*after, *before) << "the answer of the stop was taken for a value";
    ASSERT_TRUE(line->sent_s);
    EXPECT_LE(*line->sent_s - line->asked_s, 0.050); // of the time-out of 0.5 s
    device->stop();
    EXPECT_TRUE(device->state().isStopLatched);
    EXPECT_FALSE(device->state().isArmed);
}

TEST_F(StopOvertakes, aReleaseWhichIsNotRepeatedThen) {
    device->stop();
    ASSERT_TRUE(device->state().isStopLatched);
    line->sent_s.reset();
    line->loses = UserCommand; // R, whose answer is lost: its repetition would undo the stop
    const auto released = device->clearStop();
    ASSERT_FALSE(released);
    EXPECT_EQ(released.error().code, ErrorCode::Interrupted);
    ASSERT_TRUE(line->sent_s);
    EXPECT_LE(*line->sent_s - line->asked_s, 0.050);
    ASSERT_TRUE(device->clock().waitFor(0.01)); // it latches in the next control cycle
    EXPECT_EQ(device->readSignals(std::vector<std::string>{"status"})->front(), 2.0); // stopped by command
}

TEST_F(StopOvertakes, aWaitWhileSamplesArrive) {
    ASSERT_TRUE(device->arm());
    std::optional<double> ordered_s;
    ASSERT_TRUE(device->startStream({{"position"}, 1000.0}, [&](const SampleBlockPtr&) {
        if (!ordered_s && device->clock().now_s() > 0.5) {
            ordered_s = device->clock().now_s();
            orders->stops = 1; // as another thread would
        }
    }));
    ASSERT_FALSE(device->clock().waitFor(2.0)) << "a motor that was stopped is told";
    ASSERT_TRUE(ordered_s && line->sent_s);
    EXPECT_LE(*line->sent_s - *ordered_s, 0.002) << "with the next sample, not at the end of the wait";
    EXPECT_TRUE(device->state().isStopLatched);
    EXPECT_FALSE(device->state().isArmed);
}

TEST(Orders, leavingGivesUpABoardThatIsBeingOpened) {
    auto slave = std::make_unique<TestSlave>();
    TestSlave& raw = *slave;
    XcpDeviceOptions options;
    const auto orders = std::make_shared<LinkOrders>();
    options.orders = orders;
    constexpr std::size_t Early = 5; // of the description alone there are more commands
    std::size_t commands = 0;
    raw.bendAnswers = [&](const Packet&, std::deque<Packet>&) {
        ++commands;
        orders->isLeaving = commands >= Early;
    };
    const auto device = openXcpDevice(std::move(slave), options);
    ASSERT_FALSE(device);
    EXPECT_EQ(device.error().code, ErrorCode::Interrupted);
    EXPECT_EQ(commands, Early);
}

} // namespace
} // namespace halbench::devices::xcp
