#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace halbench::devices {

/// True for CONNECT: a whole frame that begins a session, or begins it anew (resources/help/protocol.md 3.5).
bool beginsSession(std::span<const std::uint8_t> packet);

/// True for the emergency stop (3.11).
bool isStop(std::span<const std::uint8_t> packet);

/// Which master a served board heeds. The first one that sent CONNECT holds the session until it ends it, the
/// board ends it (its watchdog ran out) or the master leaves the line; one that was silent for a time loses
/// it to the next that asks. Pure; no clock, no socket.
class SessionHolder {
public:
    /// Of a master that has set no watchdog. The board ends the session of one that has.
    static constexpr double Timeout_s = 3.0;

    enum class Ruling {
        Begins,        ///< the session is this master's from here
        OfMaster,      ///< a packet within the session
        StrangersStop, ///< obeyed whoever sends it, and not answered (3.11)
        Refused,       ///< CONNECT while another master holds the session
        Ignored        ///< of no session
    };
    /// `peer`: what tells one master from another on this line.
    Ruling judge(const std::string& peer, std::span<const std::uint8_t> packet, double now_s);
    bool isHeldBy(const std::string& peer) const { return m_master == peer; }
    /// What the board says: it may end the session itself.
    void noteSaid(std::span<const std::uint8_t> packet);
    /// The master has left the line.
    void noteLeft(const std::string& peer);

private:
    std::optional<std::string> m_master;
    double m_heard_s = 0.0;
};

/// Answer to a CONNECT that is refused: the board is taken for the time being.
std::span<const std::uint8_t> refusedConnect();
/// The answer to a command, as opposed to samples and events.
bool isAnswer(std::span<const std::uint8_t> packet);

} // namespace halbench::devices
