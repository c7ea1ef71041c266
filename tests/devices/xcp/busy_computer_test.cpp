#include "devices/xcp/xcp_device.h"
#include "tests/devices/xcp/test_slave.h"

#include <gtest/gtest.h>

namespace halbench::devices::xcp {
namespace {

/// A slave that answers at once, on a computer that is held up after every command that it sends: the answer
/// has long come when it looks.
class BusyComputer : public Transport {
public:
    explicit BusyComputer(double held_s) : m_held_s(held_s) {}

    Result<void> open() override { return m_slave.open(); }
    void close() noexcept override {}
    Result<void> send(std::span<const std::uint8_t> packet) override {
        auto sent = m_slave.send(packet);
        m_late_s += m_held_s;
        return sent;
    }
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override {
        return m_slave.receive(packet, timeout_s);
    }
    double now_s() const override { return m_slave.now_s() + m_late_s; }
    TransportStatistics statistics() const override { return {}; }
    std::string description() const override { return "busy computer"; }

private:
    TestSlave m_slave;
    double m_held_s;
    double m_late_s = 0.0;
};

// A command has half a second for its answer and 1.8 s with all its repetitions.
TEST(BusyComputerTest, takesTheAnswersThatCameInTimeHoweverLateItLooks) {
    for (const double held_s : {0.0, 0.4, 0.6, 2.0}) {
        auto device = openXcpDevice(std::make_unique<BusyComputer>(held_s), {});
        ASSERT_TRUE(device) << held_s << ": " << device.error().message;
        const ParameterValue change[] = {{"p.a", 12.5}};
        const auto written = (*device)->writeParameters(change);
        ASSERT_TRUE(written) << held_s << ": " << written.error().message;
        const std::string names[] = {"p.a"};
        const auto read = (*device)->readParameters(names);
        ASSERT_TRUE(read) << held_s << ": " << read.error().message;
        EXPECT_EQ(read->front(), 12.5);
    }
}

} // namespace
} // namespace halbench::devices::xcp
