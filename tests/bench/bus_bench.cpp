// What a fast board costs over USB bulk endpoints, with the real libusb, on a bus that umockdev plays: 32
// signals at 20 kHz in transfers of 4 kB and more, and how soon a stop reaches the board at full stream.
#include "devices/open/port_address.h"
#include "devices/transport/message_stream.h"
#include "devices/xcp/xcp_device.h"
#include "tests/bench/stream_rig.h"
#include "tests/conformance/ports/mock_usb.h"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <optional>
#include <thread>

namespace halbench::bench {
namespace {

using namespace devices;
using Clock = std::chrono::steady_clock;

/// The endpoints, with the clock of the thread in which umockdev plays the kernel.
class MeasuredEndpoints : public MockBulkBoard {
public:
    using MockBulkBoard::MockBulkBoard;
    double kernel_s() {
        const std::lock_guard lock(m_clockMutex);
        return m_clock ? clockTime_s(*m_clock) : 0.0;
    }

protected:
    bool onIoctl(UMockdevIoctlClient* client) override {
        {
            const std::lock_guard lock(m_clockMutex);
            clockid_t clock{};
            if (!m_clock && pthread_getcpuclockid(pthread_self(), &clock) == 0) {
                m_clock = clock;
            }
        }
        return MockBulkBoard::onIoctl(client);
    }

private:
    std::mutex m_clockMutex;
    std::optional<clockid_t> m_clock;
};

/// The board behind the endpoints while this lives.
class BusLine {
public:
    static constexpr std::size_t Transfer_octets = 4096;

    BusLine() : m_endpoints(m_machine, 4, "HB-17"), m_thread([this] { run(); }) {}
    ~BusLine() {
        m_isEnding = true;
        m_thread.join();
    }
    BusLine(const BusLine&) = delete;
    BusLine& operator=(const BusLine&) = delete;

    BoardLine line() {
        return {"over libusb", &m_board,
                [](const std::shared_ptr<LinkOrders>& orders) -> Result<std::unique_ptr<Device>> {
                    auto transport = makeUsbTransport(*parseDeviceUri("usb:1209:0001:HB-17"));
                    if (!transport) {
                        return tl::make_unexpected(transport.error());
                    }
                    XcpDeviceOptions options;
                    options.orders = orders;
                    return openXcpDevice(std::move(*transport), std::move(options));
                },
                // All of this process but the board and the kernel: what umockdev costs the caller of a
                // system call is in it.
                [this] {
                    return clockTime_s(CLOCK_PROCESS_CPUTIME_ID) - threadTime_s(m_thread.native_handle()) -
                           m_endpoints.kernel_s();
                }};
    }

private:
    void run() {
        const auto start = Clock::now();
        MessageParser parser(0xFFFF);
        Octets transfer;
        std::vector<std::uint8_t> packet;
        std::uint16_t counter = 0;
        while (!m_isEnding) {
            parser.feed(m_endpoints.takenWithin(0.0005));
            m_board.advanceTo(std::chrono::duration<double>(Clock::now() - start).count());
            bool hasAnswered = false;
            for (auto message = parser.next(); message && *message; message = parser.next()) {
                m_board.receive((*message)->packet);
                hasAnswered = true;
            }
            while (m_board.transmit(packet, counter)) {
                appendMessage(transfer, counter, packet);
            }
            if (transfer.size() >= Transfer_octets || hasAnswered) { // a short transfer only behind an answer
                m_endpoints.deliver(transfer);
                transfer.clear();
            }
        }
    }

    MockMachine m_machine;
    MeasuredEndpoints m_endpoints;
    FastBoard m_board;
    std::atomic<bool> m_isEnding{false};
    std::thread m_thread;
};

} // namespace
} // namespace halbench::bench

/// An argument is the seconds of the stream instead of 60.
int main(int count, char** arguments) {
    halbench::bench::Goals goals;
    halbench::bench::printLoad();
    {
        halbench::bench::BusLine bus;
        halbench::bench::benchStream(goals, bus.line(),
                                     count > 1 ? std::strtod(arguments[1], nullptr) : 60.0);
    }
    halbench::bench::BusLine bus;
    halbench::bench::benchStop(goals, bus.line());
    return goals.exitCode();
}
