#pragma once

#include "devices/transport/frame_codec.h"
#include "devices/transport/transport.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace halbench::devices {

using Octets = std::vector<std::uint8_t>;

/// What the program sends so that the far end knows of it.
const Octets Hello{0xFF, 0x00};
/// Nobody waits longer for a line that is dead.
constexpr double Patience_s = 2.0;

/// What a line is by its nature; the suite expects the rest of all alike.
struct LineTraits {
    bool isDatagram = false;         ///< whole messages arrive together or not at all
    bool hasChecksum = false;        ///< damage is noticed and costs a frame, never the line
    bool isExclusive = false;        ///< a second open is refused while the first lasts
    bool canStall = true;            ///< the far end can refuse to take any more
    bool tellsUnplugByItself = true; ///< without anything being sent
    std::uint16_t counterMask = 0xFFFF;
};

/// The other end of a transport's line, as a test drives it. Thread: deliver(), unplug() and setStalled()
/// any, the others the test's.
class FarEnd {
public:
    virtual ~FarEnd() = default;

    virtual LineTraits traits() const = 0;
    /// A transport to this end; several may live at a time.
    virtual std::unique_ptr<Transport> makeTransport() = 0;
    /// How packets lie on this line.
    virtual std::unique_ptr<FrameCodec> makeCodec() const = 0;

    /// Hands octets to the program as one read of them, or a datagram.
    virtual void deliver(const Octets& octets) = 0;
    /// What the program sent; waits up to 2 s for the first octet.
    virtual Octets taken() = 0;
    virtual void setStalled(bool isStalled) = 0;
    /// The cable is pulled, the board switched off. plug() brings it back, under the same address.
    virtual void unplug() = 0;
    virtual void plug() = 0;
};

/// A kind of line under its name.
struct LineKind {
    std::string name;
    std::function<std::unique_ptr<FarEnd>()> make;
};
inline void PrintTo(const LineKind& kind, std::ostream* stream) {
    *stream << kind.name;
}
inline std::string lineName(const testing::TestParamInfo<LineKind>& info) {
    return info.param.name;
}

/// One suite for all transports; the cases are in transport_conformance.cpp, the kinds of line where they
/// can be had.
class TransportConformance : public testing::TestWithParam<LineKind> {
protected:
    void SetUp() override;

    /// Opens the transport; the far end has heard of it afterwards.
    void connect(Transport& transport);
    /// A message as it lies on the line.
    Octets framed(std::uint16_t counter, const Octets& packet) const;
    /// What the far end understands of what was sent, this many packets or what came within 2 s.
    std::vector<Octets> packetsTaken(std::size_t count);
    /// Delivers, and lets the transport take it in as a read of its own.
    void deliverAlone(Transport& transport, const Octets& octets);
    /// Everything that is whole, this many packets or what came within 2 s.
    static std::vector<Octets> received(Transport& transport, std::size_t count);
    /// Receives until the line is lost; false after 2 s. For lines that do not tell, sends meanwhile.
    bool isToldLost(Transport& transport, Error& error) const;

    LineTraits m_traits;
    std::unique_ptr<FarEnd> m_far;
    std::unique_ptr<Transport> m_transport;
    std::unique_ptr<FrameCodec> m_codec;
    std::uint64_t m_delivered = 0; ///< octets since connect()
};

/// Lines whose reads are cut anywhere.
class StreamConformance : public TransportConformance {};
/// Lines that carry whole messages or none.
class DatagramConformance : public TransportConformance {};
/// Streams without a checksum.
class UncheckedStreamConformance : public TransportConformance {};
/// Lines whose far end can refuse to take any more.
class StallConformance : public TransportConformance {};

} // namespace halbench::devices
