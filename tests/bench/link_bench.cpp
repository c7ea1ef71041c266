// What a fast board costs: decoding, 32 signals at 20 kHz over a socket and over bulk transfers, how soon a
// stop reaches it at full stream, and how long a large description takes.
#include "devices/link_orders.h"
#include "devices/transport/framed_transport.h"
#include "devices/transport/stream_codec.h"
#include "devices/transport/tcp_server.h"
#include "devices/transport/tcp_transport.h"
#include "devices/xcp/a2l.h"
#include "devices/xcp/stream_assembler.h"
#include "devices/xcp/xcp_device.h"
#include "tests/bench/fast_board.h"
#include "tests/bench/goal.h"
#include "tests/bench/stream_rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <future>
#include <thread>

namespace halbench::bench {
namespace {

using namespace devices;
using Clock = std::chrono::steady_clock;

constexpr double ParseGoal_per_s = 2.5e6;
/// Decoding checks identity, length and type of every value and keeps its time; a loop that only widens
/// floats does not, and runs as fast as the cache and the vector unit let it: 23 times ours where both are
/// fast. Twice that is a mistake of ours, whatever the machine.
constexpr double MaxTimesNaive = 45.0;

/// Samples as they lie on the line, one after the other.
std::vector<std::vector<std::uint8_t>> samples(std::size_t count) {
    std::vector<std::vector<std::uint8_t>> packets(count);
    for (std::size_t i = 0; i < count; ++i) {
        FastBoard::writeSample(packets[i], i);
    }
    return packets;
}

xcp::StreamAssembler assembler() {
    xcp::DaqAbility ability;
    ability.format.timestampSize = 4;
    ability.format.maxDto = 508;
    ability.format.maxEntrySize = 8;
    ability.tick_s = 5e-5;
    ability.ticksPerSecond = FastBoard::Rate_Hz;
    xcp::SamplingPlan plan;
    auto layout = std::make_shared<StreamLayout>();
    layout->period_s = 1.0 / FastBoard::Rate_Hz;
    std::vector<xcp::DaqEntry> entries;
    for (std::size_t i = 0; i < FastBoard::Signals; ++i) {
        layout->columns.push_back({FastBoard::signalName(i), "A"});
        entries.push_back({{static_cast<std::uint32_t>(4 * i), 0}, xcp::DataType::Float32});
    }
    plan.layout = layout;
    plan.boardPeriod_s = layout->period_s;
    plan.hostDivider = 1;
    const xcp::DaqPlan odts = *xcp::planDaqList(entries, ability.format);
    return xcp::StreamAssembler(plan, ability, xcp::DtoDecoder(ability.format, entries, odts, 0, 3));
}

void benchParsing(Goals& goals) {
    constexpr std::size_t Count = 20000;
    const auto packets = samples(Count);
    std::uint64_t rows = 0;
    const double ours_s = processorTime_s(
        [&] {
            xcp::StreamAssembler stream = assembler();
            double arrival_s = 0.0;
            for (const auto& packet : packets) {
                stream.feed(packet, arrival_s += 5e-5);
                if (stream.isBlockDue()) {
                    for (const SampleBlockPtr& block : stream.takeBlocks()) {
                        rows += block->rows();
                    }
                }
            }
        },
        9);
    std::vector<double> values(Count * FastBoard::Signals);
    const double naive_s = processorTime_s(
        [&] {
            double* place = values.data();
            for (const auto& packet : packets) {
                for (std::size_t i = 0; i < FastBoard::Signals; ++i) {
                    float value = 0.0F;
                    std::memcpy(&value, &packet[5 + 4 * i], sizeof value);
                    *place++ = static_cast<double>(value);
                }
            }
        },
        9);
    if (rows < 9 * Count || values.back() < 1.0) {
        return goals.failed("decoding", "rows are missing");
    }
    goals.atLeast("decoding of samples into blocks", static_cast<double>(values.size()) / ours_s,
                  ParseGoal_per_s, "values/s");
    goals.below("the same against widening floats alone", ours_s / naive_s, MaxTimesNaive, "times");
}

void benchDescription(Goals& goals) {
    const std::string text = FastBoard::description(10000);
    std::size_t signals = 0;
    const double time_s = processorTime_s(
        [&] {
            const auto description = xcp::parseA2l(text);
            signals = description ? description->measurements.size() : 0;
        },
        5);
    if (signals != 10000) {
        return goals.failed("a description of 10 000 signals", "it was not read");
    }
    goals.below("a description of 10 000 signals", 1e3 * time_s, 200.0, "ms");
}

/// Bulk transfers of at least 4 kB, as a high-speed controller makes them, without the bus: a thread of the
/// port's own hands them over as libusb's does.
class BulkPort : public OctetPort {
public:
    static constexpr std::size_t Transfer = 4096;

    explicit BulkPort(FastBoard& board) : m_board(&board) {}
    ~BulkPort() override { close(); }
    BulkPort(const BulkPort&) = delete;
    BulkPort& operator=(const BulkPort&) = delete;

    Result<void> open(OctetInbox& inbox) override {
        m_isEnding = false;
        m_thread = std::thread([this, &inbox] { run(inbox); });
        return {};
    }
    void close() noexcept override {
        m_isEnding = true;
        if (m_thread.joinable()) {
            m_thread.join();
        }
    }
    Result<void> write(std::span<const std::uint8_t> octets) override {
        const std::lock_guard lock(m_mutex);
        m_parser.feed(octets);
        return {};
    }
    std::string description() const override { return "bulk"; }

private:
    void run(OctetInbox& inbox) {
        const auto start = Clock::now();
        std::vector<std::uint8_t> transfer;
        std::vector<std::uint8_t> packet;
        std::uint16_t counter = 0;
        while (!m_isEnding) {
            (void)std::promise<void>().get_future().wait_for(std::chrono::microseconds(500));
            m_board->advanceTo(std::chrono::duration<double>(Clock::now() - start).count());
            bool hasAnswered = false;
            {
                const std::lock_guard lock(m_mutex);
                for (auto message = m_parser.next(); message && *message; message = m_parser.next()) {
                    m_board->receive((*message)->packet);
                    hasAnswered = true;
                }
            }
            while (m_board->transmit(packet, counter)) {
                appendMessage(transfer, counter, packet);
            }
            if (transfer.size() >= Transfer || hasAnswered) { // a short transfer only behind an answer
                inbox.put(transfer);
                transfer.clear();
            }
        }
    }

    FastBoard* m_board;
    std::mutex m_mutex;
    MessageParser m_parser{0xFFFF};
    std::atomic<bool> m_isEnding{false};
    std::thread m_thread;
};

/// The board behind one of both lines.
class Line {
public:
    static std::unique_ptr<Line> overTcp() {
        auto server = TcpServer::listen({"127.0.0.1", 0});
        if (!server) {
            return nullptr;
        }
        auto line = std::make_unique<Line>();
        line->m_address = *parseNetworkAddress(server->address().substr(4));
        line->m_thread = std::thread([raw = line.get(), port = *std::move(server)]() mutable {
            serveBoard(port, raw->board, raw->m_interrupt);
        });
        return line;
    }
    static std::unique_ptr<Line> overBulk() { return std::make_unique<Line>(); }
    ~Line() {
        m_interrupt = 2;
        if (m_thread.joinable()) {
            m_thread.join();
        }
    }
    Result<std::unique_ptr<Device>> open(const std::shared_ptr<LinkOrders>& orders) {
        XcpDeviceOptions options;
        options.orders = orders;
        if (m_thread.joinable()) {
            return openXcpDevice(std::make_unique<TcpTransport>(m_address), std::move(options));
        }
        FramedTransport::Codecs codecs;
        codecs.push_back(std::make_unique<StreamCodec>());
        return openXcpDevice(
            std::make_unique<FramedTransport>(std::make_unique<BulkPort>(board), std::move(codecs), 1.8),
            std::move(options));
    }

    FastBoard board;

private:
    std::atomic<int> m_interrupt{0};
    NetworkAddress m_address;
    std::thread m_thread;
};

BoardLine boardLine(const std::string& name, Line& line) {
    return {name,
            &line.board,
            [&line](const std::shared_ptr<LinkOrders>& orders) { return line.open(orders); },
            {}};
}

void benchLines(Goals& goals, double duration_s) {
    for (const bool isTcp : {true, false}) {
        const std::string over = isTcp ? "over TCP" : "over bulk transfers of 4 kB";
        const auto streamed = isTcp ? Line::overTcp() : Line::overBulk();
        const auto stopped = isTcp ? Line::overTcp() : Line::overBulk();
        if (!streamed || !stopped) {
            goals.failed(over, "no port could be opened");
            continue;
        }
        printLoad();
        benchStream(goals, boardLine(over, *streamed), duration_s);
        benchStop(goals, boardLine(over, *stopped));
    }
}

} // namespace
} // namespace halbench::bench

/// An argument is the seconds of a stream instead of 60; 0 leaves out all that is timed by the wall clock, as
/// the tests of every day do.
int main(int count, char** arguments) {
    const double duration_s = count > 1 ? std::strtod(arguments[1], nullptr) : 60.0;
    halbench::bench::Goals goals;
    halbench::bench::benchParsing(goals);
    halbench::bench::benchDescription(goals);
    if (duration_s > 0.0) {
        halbench::bench::benchLines(goals, duration_s);
    }
    return goals.exitCode();
}
