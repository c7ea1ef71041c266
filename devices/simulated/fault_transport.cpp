#include "devices/simulated/fault_transport.h"

namespace halbench::devices {
namespace {

tl::unexpected<Error> unplugged() {
    return failure(ErrorCode::DeviceLost, "the device was unplugged", "Connect it and open it again.");
}

} // namespace

FaultTransport::FaultTransport(std::unique_ptr<Transport> transport, std::shared_ptr<LinkFaults> faults,
                               std::uint64_t seed)
    : m_transport(std::move(transport)), m_faults(std::move(faults)), m_random(seed) {}

bool FaultTransport::isUnplugged() {
    if (m_faults->unplugAt_s && m_transport->now_s() >= *m_faults->unplugAt_s) {
        m_faults->isUnplugged = true;
    }
    return m_faults->isUnplugged;
}

bool FaultTransport::happens(double probability) {
    return probability > 0.0 && m_random.uniform() < probability;
}

void FaultTransport::corrupt(std::vector<std::uint8_t>& packet) {
    const std::uint64_t bit = m_random.below(packet.size() * 8);
    packet[bit / 8] = static_cast<std::uint8_t>(packet[bit / 8] ^ (1U << (bit % 8)));
    ++m_faults->corrupted;
}

Result<void> FaultTransport::open() {
    if (isUnplugged()) {
        return unplugged();
    }
    return m_transport->open();
}

Result<void> FaultTransport::send(std::span<const std::uint8_t> packet) {
    if (isUnplugged()) {
        return unplugged();
    }
    if (m_faults->isMute) {
        return {};
    }
    if (happens(m_faults->dropSent_ratio)) {
        ++m_faults->dropped;
        return {};
    }
    std::vector<std::uint8_t> copy(packet.begin(), packet.end());
    if (!copy.empty() && happens(m_faults->corruptSent_ratio)) {
        corrupt(copy);
    }
    return m_transport->send(copy);
}

bool FaultTransport::reachesMaster(std::vector<std::uint8_t>& packet) {
    if (m_faults->isMute || m_faults->isStalled) {
        return false;
    }
    if (happens(m_faults->dropReceived_ratio)) {
        ++m_faults->dropped;
        return false;
    }
    if (!packet.empty() && happens(m_faults->corruptReceived_ratio)) {
        corrupt(packet);
    }
    if (m_faults->alterReceived) {
        m_faults->alterReceived(packet);
    }
    return true;
}

Result<bool> FaultTransport::receive(std::vector<std::uint8_t>& packet, double timeout_s) {
    const double deadline_s = m_transport->now_s() + timeout_s;
    for (;;) {
        if (isUnplugged()) {
            return unplugged();
        }
        const double left_s = deadline_s - m_transport->now_s();
        Result<bool> received = m_transport->receive(packet, left_s > 0.0 ? left_s : 0.0);
        if (!received || !*received) {
            return received;
        }
        if (reachesMaster(packet)) {
            return true;
        }
    }
}

} // namespace halbench::devices
