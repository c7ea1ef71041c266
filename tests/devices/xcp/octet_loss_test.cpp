#include "control/base/random.h"
#include "devices/firmware/xcp/hb_sxi.h"
#include "devices/simulated/htm/simulated_htm.h"
#include "devices/simulated/loopback_transport.h"
#include "devices/transport/sxi_codec.h"
#include "devices/xcp/xcp_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace halbench::devices {
namespace {

using Octets = std::vector<std::uint8_t>;

struct LineRecord {
    double loss_ratio = 0.0; ///< of the octets, both ways
    std::uint64_t octetsLost = 0;
    std::uint64_t samplesSent = 0; ///< by the board, while octets were lost
    std::uint64_t samplesLost = 0; ///< of these, by their frames
    std::uint64_t wronglyBelieved = 0;
};

/// A serial line that loses octets, below the framing: the board's own code frames at one end, the program's
/// at the other. Time is the embedded board's. Thread: the connection's.
class LosingLine : public Transport {
public:
    LosingLine(std::shared_ptr<SimulatedBoard> board, std::shared_ptr<LineRecord> record, std::uint64_t seed)
        : m_board(board), m_loop(std::move(board), false), m_record(std::move(record)), m_random(seed) {
        hb_sxi_receiver_init(&m_receiver);
    }

    Result<void> open() override { return m_loop.open(); }
    void close() noexcept override { m_loop.close(); }
    double now_s() const override { return m_loop.now_s(); }
    TransportStatistics statistics() const override { return m_loop.statistics(); }
    std::string description() const override { return "losing line"; }

    Result<void> send(std::span<const std::uint8_t> packet) override {
        Octets line;
        m_codec.append(line, m_counter++, packet);
        lose(line);
        for (const std::uint8_t octet : line) {
            const std::uint16_t length = hb_sxi_receive(&m_receiver, octet);
            if (length == 0) {
                continue;
            }
            if (Result<void> sent = m_loop.send({hb_sxi_packet(&m_receiver), length}); !sent) {
                return sent;
            }
        }
        return {};
    }

    Result<bool> receive(Octets& packet, double timeout_s) override {
        const double deadline_s = now_s() + timeout_s;
        for (;;) {
            if (const auto frame = m_codec.next(); frame && *frame) {
                packet.assign((*frame)->packet.begin(), (*frame)->packet.end());
                note((*frame)->counter.value_or(0), packet);
                return true;
            }
            const Result<bool> received = m_loop.receive(m_packet, std::max(deadline_s - now_s(), 0.0));
            if (!received || !*received) {
                return received;
            }
            frame();
        }
    }

private:
    static bool isSample(const Octets& packet) { return packet[0] < 0xFC; }

    void lose(Octets& line) {
        const auto isLost = [&](std::uint8_t) {
            return m_record->loss_ratio > 0.0 && m_random.uniform() < m_record->loss_ratio;
        };
        m_record->octetsLost += std::erase_if(line, isLost);
    }

    void frame() {
        const std::uint16_t counter = m_board->messageCounter();
        hb_sxi_sender sender{};
        hb_sxi_send(&sender, m_packet.data(), static_cast<std::uint16_t>(m_packet.size()), counter);
        Octets line;
        for (std::uint8_t octet = 0; hb_sxi_next(&sender, &octet) != 0;) {
            line.push_back(octet);
        }
        lose(line);
        m_codec.feed(line);
        m_sent[static_cast<std::uint8_t>(counter)] = m_packet;
        if (isSample(m_packet) && m_record->loss_ratio > 0.0) {
            ++m_record->samplesSent;
            ++m_record->samplesLost; // until it arrives
        }
    }

    void note(std::uint16_t counter, const Octets& packet) {
        m_record->wronglyBelieved += packet != m_sent[static_cast<std::uint8_t>(counter)] ? 1 : 0;
        m_record->samplesLost -= isSample(packet) && m_record->loss_ratio > 0.0 ? 1 : 0;
    }

    std::shared_ptr<SimulatedBoard> m_board;
    LoopbackTransport m_loop;
    std::shared_ptr<LineRecord> m_record;
    Random m_random;
    SxiCodec m_codec{SxiProfile{}};
    hb_sxi_receiver m_receiver{};
    Octets m_packet;
    std::array<Octets, 256> m_sent; ///< by counter
    std::uint16_t m_counter = 0;
};

struct Motion {
    std::map<std::int64_t, std::array<double, 2>> rows; ///< by hundredths of a second of the board
    std::uint64_t rowsLost = 0;
};

/// A sine, armed, with octets lost all the time once it moves.
void move(double loss_ratio, double duration_s, std::uint64_t seed, const std::shared_ptr<LineRecord>& line,
          Motion& motion) {
    auto made = makeSimulatedHtm({}, 1, {nullptr, HB_SXI_LONGEST_PACKET});
    ASSERT_TRUE(made);
    auto device = openXcpDevice(
        std::make_unique<LosingLine>(std::shared_ptr<SimulatedBoard>(*std::move(made)), line, seed), {});
    ASSERT_TRUE(device) << device.error().message;
    const auto set = [&](const std::string& name, double value) {
        const ParameterValue change{name, value};
        const auto written = (*device)->writeParameters({&change, 1});
        ASSERT_TRUE(written) << name << ": " << written.error().message;
    };
    set("hb.mode", static_cast<double>(BoardMode::Position));
    ASSERT_TRUE(
        (*device)->startStream({{"position", "truth.position"}, 100.0}, [&](const SampleBlockPtr& block) {
            motion.rowsLost += block->lostRows;
            for (std::size_t row = 0; row < block->time_s.size(); ++row) {
                motion.rows[std::llround(block->time_s[row] * 100.0)] = {block->value(row, 0),
                                                                         block->value(row, 1)};
            }
        }));
    ASSERT_TRUE((*device)->arm());
    set("reference.shape", 3.0);
    set("reference.amplitude", 3.14);
    set("reference.frequency", 0.1);
    set("reference.duration", 9000.0);
    set("reference.start", 1.0);
    ASSERT_TRUE((*device)->clock().waitFor(0.5)); // what was sent without loss has arrived
    line->loss_ratio = loss_ratio;
    const auto waited = (*device)->clock().waitFor(duration_s);
    line->loss_ratio = 0.0;
    ASSERT_TRUE(waited) << waited.error().message;
    ASSERT_TRUE((*device)->clock().waitFor(0.5));
    EXPECT_TRUE((*device)->state().isArmed) << "the watchdog of 1 s was fed all the time";
    (*device)->stopStream();
    EXPECT_TRUE((*device)->disarm());
}

/// Gate 4 of resources/help/protocol.md, below the framing: one sample in five is hit, and one exchange in
/// six. A session ends when nine tries of a command fail in 1.8 s, (1/6)^9 = 1e-7 for each of the minute's
/// 240 commands, or when none of ten commands and SYNCHs reaches the board in its watchdog's second: 0.08^10.
constexpr double Loss_ratio = 0.01;
constexpr double Minute_s = 60.0;

class OctetLoss : public testing::TestWithParam<std::uint64_t> {};

TEST_P(OctetLoss, aMinuteOfMotionKeepsTheSessionEveryGapIsCountedAndNoValueIsWrong) {
    const auto good = std::make_shared<LineRecord>();
    Motion known;
    // Longer, because the other one's commands take their time to be repeated.
    ASSERT_NO_FATAL_FAILURE(move(0.0, Minute_s + 10.0, GetParam(), good, known));
    EXPECT_EQ(known.rowsLost, 0U);
    const auto bad = std::make_shared<LineRecord>();
    Motion seen;
    ASSERT_NO_FATAL_FAILURE(move(Loss_ratio, Minute_s, GetParam(), bad, seen));

    // A sample's frame has some 23 octets: 1 % of 6000 of them are 1380, in 1 - 0.99^23 = 21 % of the frames.
    EXPECT_GT(bad->octetsLost, 1200U);
    EXPECT_GT(bad->samplesLost, 1000U);
    EXPECT_EQ(bad->wronglyBelieved, 0U) << "the checksum found every hit frame";
    EXPECT_EQ(seen.rowsLost, bad->samplesLost) << "of " << bad->samplesSent;
    std::size_t wrong = 0;
    for (const auto& [time, values] : seen.rows) {
        const auto same = known.rows.find(time);
        wrong += same == known.rows.end() || same->second != values ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0U) << "the same motor makes the same motion, to the last bit, whatever its line does";
    EXPECT_GE(seen.rows.size() + seen.rowsLost, 6000U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, OctetLoss, testing::Range<std::uint64_t>(1, 21));

} // namespace
} // namespace halbench::devices
