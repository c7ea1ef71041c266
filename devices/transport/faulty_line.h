#pragma once

#include "control/base/random.h"
#include "control/base/result.h"
#include "devices/transport/board_server.h"
#include "devices/transport/pty_server.h"
#include "devices/transport/sxi_codec.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

namespace halbench::devices {

/// What goes wrong on the line of a served board, so that masters can be tried out against it. Shares are of
/// the messages of each direction.
struct LineFaults {
    double drop_ratio = 0.0;    ///< vanish; the counter of the board's messages goes on
    double corrupt_ratio = 0.0; ///< arrive with one bit flipped
    double latency_s = 0.0;     ///< every message arrives so much later

    static constexpr double MaxLatency_s = 10.0;
    bool isAny() const { return drop_ratio > 0.0 || corrupt_ratio > 0.0 || latency_s > 0.0; }
};

/// Errors: NotFinite, OutOfRange (a share outside 0 to 1, a latency outside 0 to 10 s), by the name of the
/// option.
Result<void> checkLineFaults(const LineFaults& faults);

/// What a line was made to do.
struct LineTraffic {
    std::uint64_t messages = 0; ///< that were sent, both ways
    std::uint64_t dropped = 0;
    std::uint64_t corrupted = 0;
};

/// A board behind a line that drops, damages and delays whole messages. What it damages still arrives as a
/// message, as from a faulty gateway: sockets have no checksum that a master could see. Thread: the board's.
class FaultyBoard : public ServedBoard {
public:
    /// More than this on their way to a master stay in the board, whose own queue then overflows.
    static constexpr std::size_t MaxOnTheWay = 16384;

    FaultyBoard(ServedBoard& board, const LineFaults& faults, const Random& random, LineTraffic& traffic);

    void advanceTo(double time_s) override;
    void receive(std::span<const std::uint8_t> packet) override;
    bool transmit(std::vector<std::uint8_t>& packet, std::uint16_t& counter) override;

private:
    struct Message {
        double due_s = 0.0;
        std::uint16_t counter = 0;
        std::vector<std::uint8_t> packet;
    };
    bool arrives(std::vector<std::uint8_t>& packet);
    void collect();

    ServedBoard* m_board;
    LineFaults m_faults;
    Random m_random;
    LineTraffic* m_traffic;
    double m_now_s = 0.0;
    std::deque<Message> m_toBoard;
    std::deque<Message> m_toMaster;
};

/// Flips one bit of some frames on a serial line, header and checksum included: the receivers notice where
/// there is a checksum. A frame from the master begins with SYNC, or without framing behind the one before or
/// a silence. Thread: the server's.
class FaultyFraming : public PacketFraming {
public:
    FaultyFraming(std::unique_ptr<PacketFraming> framing, const SxiProfile& profile, double corrupt_ratio,
                  const Random& random, LineTraffic& traffic);

    std::span<const std::uint8_t> receive(std::uint8_t octet) override;
    void append(std::vector<std::uint8_t>& line, std::uint16_t counter,
                std::span<const std::uint8_t> packet) override;
    void noteSilence() override;

private:
    std::unique_ptr<PacketFraming> m_framing;
    SxiProfile m_profile;
    double m_corrupt_ratio;
    Random m_random;
    LineTraffic* m_traffic;
    bool m_isBetweenFrames = true; ///< without framing
    std::size_t m_untilDamage = 0; ///< octets of the frame that is coming in; 0: it stays whole
};

} // namespace halbench::devices
