#include "tests/conformance/transport/far_end.h"

namespace halbench::devices {

void TransportConformance::SetUp() {
    m_far = GetParam().make();
    m_traits = m_far->traits();
    m_transport = m_far->makeTransport();
    m_codec = m_far->makeCodec();
}

void TransportConformance::connect(Transport& transport) {
    const Result<void> opened = transport.open();
    ASSERT_TRUE(opened) << opened.error().message;
    ASSERT_TRUE(transport.send(Hello));
    m_codec = m_far->makeCodec();
    ASSERT_EQ(packetsTaken(1), std::vector<Octets>{Hello});
    m_delivered = transport.statistics().octetsReceived;
}

Octets TransportConformance::framed(std::uint16_t counter, const Octets& packet) const {
    Octets line;
    m_far->makeCodec()->append(line, static_cast<std::uint16_t>(counter & m_traits.counterMask), packet);
    return line;
}

std::vector<Octets> TransportConformance::packetsTaken(std::size_t count) {
    std::vector<Octets> packets;
    while (packets.size() < count) {
        const Octets octets = m_far->taken();
        if (octets.empty()) {
            break;
        }
        m_codec->feed(octets);
        for (auto frame = m_codec->next(); frame && *frame; frame = m_codec->next()) {
            packets.emplace_back((*frame)->packet.begin(), (*frame)->packet.end());
        }
    }
    return packets;
}

void TransportConformance::deliverAlone(Transport& transport, const Octets& octets) {
    m_far->deliver(octets);
    m_delivered += octets.size();
    const double end_s = transport.now_s() + Patience_s;
    Octets packet;
    // Ports with a thread of their own count octets; sockets have them at once.
    do {
        const auto taken = transport.receive(packet, 0.0);
        ASSERT_TRUE(taken) << taken.error().message;
        ASSERT_FALSE(*taken) << "nothing is whole yet";
    } while (transport.statistics().octetsReceived != 0 &&
             transport.statistics().octetsReceived < m_delivered && transport.now_s() < end_s);
}

std::vector<Octets> TransportConformance::received(Transport& transport, std::size_t count) {
    std::vector<Octets> packets;
    Octets packet;
    while (packets.size() < count) {
        const auto taken = transport.receive(packet, Patience_s);
        if (!taken || !*taken) {
            break;
        }
        packets.push_back(packet);
    }
    return packets;
}

bool TransportConformance::isToldLost(Transport& transport, Error& error) const {
    const double end_s = transport.now_s() + Patience_s;
    Octets packet;
    while (transport.now_s() < end_s) {
        const double wait_s = m_traits.tellsUnplugByItself ? end_s - transport.now_s() : 0.01;
        const auto taken = transport.receive(packet, wait_s);
        const auto sent = taken && !m_traits.tellsUnplugByItself ? transport.send(Hello) : Result<void>{};
        if (!taken || !sent) {
            error = !taken ? taken.error() : sent.error();
            return true;
        }
    }
    return false;
}

} // namespace halbench::devices
