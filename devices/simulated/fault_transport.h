#pragma once

#include "control/base/random.h"
#include "devices/transport/transport.h"

#include <functional>
#include <memory>
#include <optional>

namespace halbench::devices {

/// What goes wrong on the way, shared between a test and the transport it broke. Probabilities are per
/// packet.
struct LinkFaults {
    bool isUnplugged = false; ///< every call fails with DeviceLost
    bool isMute = false;      ///< packets of the master vanish, nothing arrives: the master was killed
    bool isStalled = false;   ///< nothing arrives from the board; the master's packets still reach it
    std::optional<double> unplugAt_s; ///< isUnplugged becomes true at this time
    double dropReceived_ratio = 0.0;
    double dropSent_ratio = 0.0;
    double corruptReceived_ratio = 0.0; ///< one bit of the packet flips
    double corruptSent_ratio = 0.0;
    std::uint64_t corrupted = 0; ///< counts of what was done
    std::uint64_t dropped = 0;
    std::function<void(std::vector<std::uint8_t>&)> alterReceived; ///< may rewrite a packet; may be empty
};

/// Puts faults of the link between a master and any transport; for tests of what must survive them.
/// Thread: the wrapped transport's.
class FaultTransport : public Transport {
public:
    FaultTransport(std::unique_ptr<Transport> transport, std::shared_ptr<LinkFaults> faults,
                   std::uint64_t seed);

    Result<void> open() override;
    void close() noexcept override { m_transport->close(); }
    Result<void> send(std::span<const std::uint8_t> packet) override;
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override;
    double now_s() const override { return m_transport->now_s(); }
    TransportStatistics statistics() const override { return m_transport->statistics(); }
    std::string description() const override { return m_transport->description(); }
    double connectPatience_s() const override { return m_transport->connectPatience_s(); }
    void noteUnansweredConnect() override { m_transport->noteUnansweredConnect(); }

private:
    bool isUnplugged();
    bool happens(double probability);
    void corrupt(std::vector<std::uint8_t>& packet);
    bool reachesMaster(std::vector<std::uint8_t>& packet);

    std::unique_ptr<Transport> m_transport;
    std::shared_ptr<LinkFaults> m_faults;
    Random m_random;
};

} // namespace halbench::devices
