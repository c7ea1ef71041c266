#pragma once

#include "devices/transport/frame_codec.h"
#include "devices/transport/octet_port.h"
#include "devices/transport/transport.h"

#include <chrono>
#include <memory>
#include <vector>

namespace halbench::devices {

/// Packets over a port that moves octets: serial, USB bulk, HID. Time is the host's steady clock. Thread:
/// one, the connection's; the port has its own.
class FramedTransport : public Transport {
public:
    using Codecs = std::vector<std::unique_ptr<FrameCodec>>;
    /// The first codec is tried longest, then the others in turn (resources/help/protocol.md 3.6).
    FramedTransport(std::unique_ptr<OctetPort> port, Codecs codecs, double connectPatience_s);
    ~FramedTransport() override { close(); }
    FramedTransport(const FramedTransport&) = delete;
    FramedTransport& operator=(const FramedTransport&) = delete;

    Result<void> open() override;
    void close() noexcept override;
    Result<void> send(std::span<const std::uint8_t> packet) override;
    Result<bool> receive(std::vector<std::uint8_t>& packet, double timeout_s) override;
    double now_s() const override;
    TransportStatistics statistics() const override;
    std::string description() const override { return m_port->description(); }
    double connectPatience_s() const override { return m_connectPatience_s; }
    void noteUnansweredConnect() override;

private:
    FrameCodec& codec() const { return *m_codecs[m_current]; }
    void selectCodec(std::size_t index);
    Result<bool> takeFrame(std::vector<std::uint8_t>& packet);
    void followCounter(const Frame& frame);
    void takeOctets();
    Error notOpen() const;
    Error lost(Error error);

    std::unique_ptr<OctetPort> m_port;
    Codecs m_codecs;
    std::size_t m_current = 0;
    std::size_t m_unanswered = 0;
    double m_connectPatience_s;
    OctetInbox m_inbox;
    bool m_isOpen = false;
    TransportStatistics m_statistics;
    std::vector<std::uint8_t> m_incoming;
    std::vector<std::uint8_t> m_outgoing;
    std::uint16_t m_sendCounter = 0;
    std::optional<std::uint16_t> m_lastCounter;
    double m_lastOctet_s = 0.0;
    std::chrono::steady_clock::time_point m_start;
};

} // namespace halbench::devices
