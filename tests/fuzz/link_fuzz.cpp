// The whole link against a board whose answers and samples are disturbed as the data say: opened, streamed,
// written, armed, stopped. The first octets choose what kind of board it is; then one octet per answer or
// sample says what happens to it. Whatever happens, a value that is given is one the board had.
#include "devices/xcp/xcp_device.h"
#include "tests/devices/xcp/test_slave.h"

#include <algorithm>

using namespace halbench;
using namespace halbench::devices;
using namespace halbench::devices::xcp;

namespace {

class Data {
public:
    Data(const std::uint8_t* data, std::size_t size) : m_octets(data, size) {}
    std::uint8_t next() { return m_place < m_octets.size() ? m_octets[m_place++] : std::uint8_t{0}; }
    Packet packet() {
        Packet octets(next() % 16);
        std::generate(octets.begin(), octets.end(), [this] { return next(); });
        return octets;
    }

private:
    Octets m_octets;
    std::size_t m_place = 0;
};

SlaveTraits traitsFrom(Data& data) {
    SlaveTraits traits;
    const std::uint8_t kind = data.next();
    traits.order = (kind & 1) != 0 ? ByteOrder::BigEndian : ByteOrder::LittleEndian;
    traits.idField = static_cast<IdField>((kind >> 1) & 3);
    traits.hasShortDownload = (kind & 8) == 0;
    traits.hasPages = (kind & 16) == 0;
    traits.hasChecksum = (kind & 32) == 0;
    traits.hasBlockMode = (kind & 64) != 0;
    traits.marksOverload = (kind & 128) != 0;
    traits.maxCto = static_cast<std::uint8_t>(std::max<int>(data.next(), 8));
    traits.maxDto = static_cast<std::uint16_t>(16 + data.next());
    constexpr std::uint8_t Sizes[] = {4, 0, 1, 2};
    traits.timestampSize = Sizes[data.next() % 4];
    return traits;
}

void disturb(Data& data, std::deque<Packet>& packets) {
    switch (data.next()) {
    case 1:
        packets.clear();
        break;
    case 2:
        packets.push_front(data.packet());
        break;
    case 3:
        packets.push_back(data.packet());
        break;
    case 4:
        if (!packets.empty()) {
            packets.push_back(packets[0]);
        }
        break;
    case 5:
        if (!packets.empty()) {
            packets[0].resize(data.next() % (packets[0].size() + 4));
        }
        break;
    case 6:
        if (!packets.empty() && !packets[0].empty()) {
            packets[0][data.next() % packets[0].size()] = data.next();
        }
        break;
    case 7:
        packets = {data.packet()};
        break;
    default:
        break;
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
    Data data(octets, size);
    auto slave = std::make_unique<TestSlave>(traitsFrom(data));
    slave->bendAnswers = [&](const Packet&, std::deque<Packet>& answers) { disturb(data, answers); };
    slave->bendSample = [&](Packet& sample) {
        std::deque<Packet> samples = {sample};
        disturb(data, samples);
        sample = samples.empty() ? Packet{} : samples.front();
    };
    auto opened = openXcpDevice(std::move(slave), {});
    if (!opened) {
        return 0;
    }
    Device& device = **opened;
    double last_s = -1.0;
    (void)device.startStream({{"count", "wave", "byte", "big"}, 100.0}, [&](const SampleBlockPtr& block) {
        for (const double time_s : block->time_s) {
            if (!(time_s > last_s)) {
                __builtin_trap();
            }
            last_s = time_s;
        }
    });
    (void)device.clock().waitFor(0.3);
    const std::vector<ParameterValue> changes = {{"p.a", 1.0}, {"p.b", 2.0}, {"p.n", 3.0}};
    (void)device.writeParameters(changes);
    (void)device.arm();
    device.stop();
    (void)device.readCapture();
    device.stopStream();
    return 0;
}
