#include "devices/simulated/fault_transport.h"
#include "devices/simulated/htm/simulated_htm.h"
#include "devices/simulated/loopback_transport.h"
#include "devices/xcp/xcp_device.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

/// Counts what the master sends and pulls the plug before one of them.
class CountingTransport : public Transport {
public:
    CountingTransport(std::unique_ptr<Transport> transport, std::shared_ptr<LinkFaults> faults,
                      std::shared_ptr<std::size_t> sent, std::shared_ptr<std::size_t> unplugAt)
        : m_transport(std::move(transport)), m_faults(std::move(faults)), m_sent(std::move(sent)),
          m_unplugAt(std::move(unplugAt)) {}

    Result<void> open() override { return m_transport->open(); }
    void close() noexcept override { m_transport->close(); }
    Result<void> send(std::span<const std::uint8_t> packet) override {
        if (*m_sent == *m_unplugAt) {
            m_faults->isUnplugged = true;
        }
        ++*m_sent;
        return m_transport->send(packet);
    }
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override {
        return m_transport->receive(packet, timeout_s);
    }
    double now_s() const override { return m_transport->now_s(); }
    TransportStatistics statistics() const override { return m_transport->statistics(); }
    std::string description() const override { return m_transport->description(); }

private:
    std::unique_ptr<Transport> m_transport;
    std::shared_ptr<LinkFaults> m_faults;
    std::shared_ptr<std::size_t> m_sent;
    std::shared_ptr<std::size_t> m_unplugAt;
};

constexpr std::size_t Never = ~std::size_t{0};

class AtomicSet : public testing::Test {
protected:
    void SetUp() override {
        auto board = makeSimulatedHtm({}, 1);
        ASSERT_TRUE(board);
        m_board = *std::move(board);
    }

    std::unique_ptr<Device> connect() {
        m_faults = std::make_shared<LinkFaults>();
        auto faulty = std::make_unique<FaultTransport>(std::make_unique<LoopbackTransport>(m_board, false),
                                                       m_faults, 1);
        auto device = openXcpDevice(
            std::make_unique<CountingTransport>(std::move(faulty), m_faults, m_sent, m_unplugAt), {});
        EXPECT_TRUE(device) << device.error().message;
        return device ? *std::move(device) : nullptr;
    }

    static std::vector<ParameterValue> setOf(double number) {
        return {{"gain.kp", number}, {"gain.ki", 2.0 * number}, {"errormap.sin6", number / 10000.0}};
    }

    const hb_htm_calibration& running() const {
        return htmFirmware(*m_board).pages[m_board->firmware().xcp.active_page];
    }

    std::shared_ptr<SimulatedBoard> m_board;
    std::shared_ptr<LinkFaults> m_faults;
    std::shared_ptr<std::size_t> m_sent = std::make_shared<std::size_t>(0);
    std::shared_ptr<std::size_t> m_unplugAt = std::make_shared<std::size_t>(Never);
};

TEST_F(AtomicSet, thousandSwitchesNeverMixInOneCycle) {
    const auto device = connect();
    ASSERT_TRUE(device);
    for (int i = 1; i <= 1000; ++i) {
        ASSERT_TRUE(device->writeParameters(setOf(i)));
        // A different distance to the control cycle each time: 0 to 2 ms.
        ASSERT_TRUE(device->clock().waitFor(0.001 * (i % 3)));
        m_board->tick();
        ASSERT_EQ(running().kp, static_cast<float>(i));
        ASSERT_EQ(running().ki, static_cast<float>(2 * i));
    }
    EXPECT_EQ(htmFirmware(*m_board).signals.board.torn_count, 0U);
    EXPECT_GE(running().set_first, 1000U) << "every transaction has its own number";
    EXPECT_EQ(running().set_first, running().set_last);
}

TEST_F(AtomicSet, theTornCounterWouldSeeAMixture) {
    // The proof that the counter of the test above can count: a set whose marks differ.
    auto torn = makeSimulatedHtm({}, 1);
    ASSERT_TRUE(torn);
    auto& pages = const_cast<hb_htm&>(htmFirmware(**torn)).pages;
    pages[0].set_first = pages[1].set_first = 5;
    for (int i = 0; i < 10; ++i) {
        (*torn)->tick();
    }
    EXPECT_GE(htmFirmware(**torn).signals.board.torn_count, 9U);
}

TEST_F(AtomicSet, aLinkThatDiesBetweenAnyTwoCommandsLeavesTheOldSetOrTheNewOne) {
    std::size_t commands = 0;
    { // how many commands a transaction has
        const auto device = connect();
        ASSERT_TRUE(device);
        ASSERT_TRUE(device->writeParameters(setOf(1.0)));
        ASSERT_TRUE(device->clock().waitFor(0.002));
        *m_sent = 0;
        ASSERT_TRUE(device->writeParameters(setOf(2.0)));
        commands = *m_sent;
        ASSERT_GT(commands, 6U);
        m_board->tick(); // the control loop takes the page at its next cycle
    }
    std::size_t changed = 0;
    for (std::size_t at = 0; at < commands; ++at) {
        *m_unplugAt = Never;
        const auto device = connect(); // also shows that a reconnect reads the running page
        ASSERT_TRUE(device);
        const std::vector<std::string> names = {"gain.kp", "gain.ki"};
        const float old = running().kp;
        ASSERT_EQ((*device->readParameters(names))[0], static_cast<double>(old)) << at;
        const auto next = static_cast<float>(10 + at);
        *m_sent = 0;
        *m_unplugAt = at;
        const auto written = device->writeParameters(setOf(static_cast<double>(next)));
        ASSERT_FALSE(written) << at;
        EXPECT_EQ(written.error().code, ErrorCode::DeviceLost);
        for (int i = 0; i < 5; ++i) {
            m_board->tick();
        }
        const bool isOld = running().kp == old && running().ki == 2.0F * old;
        const bool isNew = running().kp == next && running().ki == 2.0F * next;
        EXPECT_TRUE(isOld || isNew) << "link lost before command " << at << ": kp " << running().kp;
        changed += isNew ? 1 : 0;
        EXPECT_EQ(htmFirmware(*m_board).signals.board.torn_count, 0U);
    }
    EXPECT_GE(changed, 1U) << "the last losses come after the switch";
    EXPECT_LE(changed, 3U) << "before the switch nothing may change";
}

TEST_F(AtomicSet, noiseOnTheLinkNeverPutsAWrongValueIntoAction) {
    const auto device = connect();
    ASSERT_TRUE(device);
    m_faults->dropReceived_ratio = 0.02;
    m_faults->dropSent_ratio = 0.02;
    for (int i = 1; i <= 200; ++i) {
        const float old = running().kp;
        const auto written = device->writeParameters(setOf(i));
        m_board->tick();
        if (written) {
            ASSERT_EQ(running().kp, static_cast<float>(i));
        } else {
            ASSERT_TRUE(running().kp == old || running().kp == static_cast<float>(i));
        }
        ASSERT_EQ(running().ki, 2.0F * running().kp);
    }
    EXPECT_EQ(htmFirmware(*m_board).signals.board.torn_count, 0U);
    EXPECT_GT(device->statistics().commandsRepeated, 0U);
}

} // namespace
} // namespace halbench::devices
