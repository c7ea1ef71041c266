#pragma once

#include "control/base/result.h"
#include "devices/transport/board_server.h"
#include "devices/transport/descriptor.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace halbench::devices {

/// How packets are told apart on a line of octets.
class PacketFraming {
public:
    virtual ~PacketFraming() = default;
    /// One octet from the line; the packet it completed, empty otherwise. Valid until the next call.
    virtual std::span<const std::uint8_t> receive(std::uint8_t octet) = 0;
    /// Appends the packet's frame to the line; a packet that is too long for it is left out.
    virtual void append(std::vector<std::uint8_t>& line, std::uint16_t counter,
                        std::span<const std::uint8_t> packet) = 0;
    /// Nothing came for a while: what had begun will not be completed.
    virtual void noteSilence() {}
};

/// A pseudo terminal that any program opens like a serial port. Its own end of the slave stays open, so that
/// the line stays raw and alive while masters come and go. CONNECT discards what is still on its way to a
/// master before.
class PtyServer : public ServerPort {
public:
    /// Errors: DeviceLost with the cause in words.
    static Result<PtyServer> open(std::unique_ptr<PacketFraming> framing);

    std::string address() const override { return "pty:" + m_path; }
    void waitForTraffic(int timeout_ms) const override;
    void exchange(ServedBoard& board) override;

private:
    PtyServer(std::unique_ptr<PacketFraming> framing, Descriptor line, Descriptor slave, std::string path);
    void takePacket(ServedBoard& board, std::span<const std::uint8_t> packet);
    void discard(ServedBoard& board);
    void collectPackets(ServedBoard& board);
    void writeLine();

    std::unique_ptr<PacketFraming> m_framing;
    Descriptor m_line;
    Descriptor m_slave;
    std::string m_path;
    std::vector<std::uint8_t> m_outgoing;
    std::vector<std::uint8_t> m_packet;
    std::chrono::steady_clock::time_point m_lastOctet;
};

} // namespace halbench::devices
