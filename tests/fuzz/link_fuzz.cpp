// The whole link against a board that answers anything: opened, streamed, written, armed, stopped. The first
// octets of each record say how many answers a command gets; time always goes on.
#include "devices/xcp/xcp_device.h"

#include <algorithm>

using namespace halbench;
using namespace halbench::devices;

namespace {

class FuzzTransport : public Transport {
public:
    FuzzTransport(const std::uint8_t* data, std::size_t size) : m_data(data), m_size(size) {}

    Result<void> open() override { return {}; }
    void close() noexcept override {}
    Result<void> send(std::span<const std::uint8_t> packet) override {
        m_waiting = m_place < m_size ? m_data[m_place++] % 4U : 0;
        m_command = packet[0];
        return {};
    }
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override {
        if (m_place >= m_size) {
            return failure(ErrorCode::DeviceLost, "the end of the data", "");
        }
        if (m_waiting == 0) {
            m_now_s += timeout_s;
            return false;
        }
        --m_waiting;
        m_now_s += 1e-4;
        const std::size_t head = m_data[m_place++];
        const std::size_t length = std::min<std::size_t>(head & 0x7F, m_size - m_place);
        packet.assign(m_data + m_place, m_data + m_place + length);
        m_place += length;
        if ((head & 0x80) != 0) { // most records are answers, so that the fuzzer gets far
            packet.insert(packet.begin(), m_command == 0xFC ? 0xFE : 0xFF);
            if (m_command == 0xFC) {
                packet.insert(packet.begin() + 1, 0x00);
            }
        }
        return true;
    }
    double now_s() const override { return m_now_s; }
    TransportStatistics statistics() const override { return {}; }
    std::string description() const override { return "fuzz"; }

private:
    const std::uint8_t* m_data;
    std::size_t m_size;
    std::size_t m_place = 0;
    unsigned m_waiting = 0;
    std::uint8_t m_command = 0;
    double m_now_s = 0.0;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    auto opened = openXcpDevice(std::make_unique<FuzzTransport>(data, size), {});
    if (!opened) {
        return 0;
    }
    Device& device = **opened;
    StreamRequest request;
    for (const auto& spec : device.catalogue().signals) {
        request.signals.push_back(spec.name);
        request.rate_Hz = spec.maxRate_Hz;
    }
    (void)device.startStream(request, [](const SampleBlockPtr&) {});
    (void)device.clock().waitFor(1.0);
    std::vector<ParameterValue> changes;
    for (const auto& spec : device.catalogue().parameters) {
        changes.push_back({spec.name, spec.max});
    }
    (void)device.writeParameters(changes);
    (void)device.arm();
    device.stop();
    (void)device.readCapture();
    return 0;
}
