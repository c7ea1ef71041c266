#include "devices/transport/session_holder.h"

#include <array>

namespace halbench::devices {

namespace {

constexpr std::uint8_t Connect = 0xFF;
constexpr std::uint8_t Disconnect = 0xFE;
constexpr std::uint8_t UserCommand = 0xF1;
constexpr std::uint8_t Stop = 0x45; // "E"
constexpr std::uint8_t Answer = 0xFF;
constexpr std::uint8_t ErrorAnswer = 0xFE;
constexpr std::uint8_t Event = 0xFD;
constexpr std::uint8_t SessionTerminated = 0x07;
constexpr std::uint8_t NotAccessibleNow = 0x33; // ERR_RESOURCE_TEMPORARY_NOT_ACCESSIBLE

} // namespace

bool isStop(std::span<const std::uint8_t> packet) {
    return packet.size() >= 2 && packet[0] == UserCommand && packet[1] == Stop;
}

bool beginsSession(std::span<const std::uint8_t> packet) {
    return packet.size() >= 2 && packet[0] == Connect && packet[1] == 0;
}

bool isAnswer(std::span<const std::uint8_t> packet) {
    return !packet.empty() && (packet[0] == Answer || packet[0] == ErrorAnswer);
}

std::span<const std::uint8_t> refusedConnect() {
    static constexpr std::array<std::uint8_t, 2> Packet = {ErrorAnswer, NotAccessibleNow};
    return Packet;
}

SessionHolder::Ruling SessionHolder::judge(const std::string& peer, std::span<const std::uint8_t> packet,
                                           double now_s) {
    const bool isConnect = beginsSession(packet);
    if (m_master == peer) {
        m_heard_s = now_s;
        if (!packet.empty() && packet[0] == Disconnect) {
            m_master.reset();
        }
        return isConnect ? Ruling::Begins : Ruling::OfMaster;
    }
    if (isConnect) {
        if (m_master && now_s - m_heard_s <= Timeout_s) {
            return Ruling::Refused;
        }
        m_master = peer;
        m_heard_s = now_s;
        return Ruling::Begins;
    }
    return isStop(packet) ? Ruling::StrangersStop : Ruling::Ignored;
}

void SessionHolder::noteSaid(std::span<const std::uint8_t> packet) {
    if (packet.size() >= 2 && packet[0] == Event && packet[1] == SessionTerminated) {
        m_master.reset();
    }
}

void SessionHolder::noteLeft(const std::string& peer) {
    if (m_master == peer) {
        m_master.reset();
    }
}

} // namespace halbench::devices
