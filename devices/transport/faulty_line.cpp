#include "devices/transport/faulty_line.h"

#include <fmt/format.h>

#include <cmath>

namespace halbench::devices {

namespace {

/// Octets that follow the first one of every frame (resources/help/protocol.md 3.3).
std::size_t octetsBehindFirst(const SxiProfile& profile) {
    const std::size_t shortest = SxiCodec(profile).shortestMessage();
    return profile.isFramed ? shortest : shortest - 1;
}

bool happens(Random& random, double ratio) {
    return ratio > 0.0 && random.uniform() < ratio;
}

void flipBit(Random& random, std::span<std::uint8_t> octets) {
    const std::uint64_t bit = random.below(octets.size() * 8);
    octets[bit / 8] = static_cast<std::uint8_t>(octets[bit / 8] ^ (1U << (bit % 8)));
}

Result<void> checkWithin(const char* option, double value, double highest, const char* hint) {
    if (!std::isfinite(value)) {
        return failure(ErrorCode::NotFinite, fmt::format("{}: {} is not a finite number", option, value),
                       hint);
    }
    if (value < 0.0 || value > highest) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{}: {} is not from 0 to {}", option, value, highest), hint);
    }
    return {};
}

} // namespace

Result<void> checkLineFaults(const LineFaults& faults) {
    constexpr const char* ShareHint = "give the share of messages, e.g. 0.01 for 1 %";
    if (Result<void> checked = checkWithin("--drop", faults.drop_ratio, 1.0, ShareHint); !checked) {
        return checked;
    }
    if (Result<void> checked = checkWithin("--corrupt", faults.corrupt_ratio, 1.0, ShareHint); !checked) {
        return checked;
    }
    return checkWithin("--latency-ms", 1e3 * faults.latency_s, 1e3 * LineFaults::MaxLatency_s,
                       "give milliseconds, e.g. 20");
}

FaultyBoard::FaultyBoard(ServedBoard& board, const LineFaults& faults, const Random& random,
                         LineTraffic& traffic)
    : m_board(&board), m_faults(faults), m_random(random), m_traffic(&traffic) {}

bool FaultyBoard::arrives(std::vector<std::uint8_t>& packet) {
    ++m_traffic->messages;
    if (happens(m_random, m_faults.drop_ratio)) {
        ++m_traffic->dropped;
        return false;
    }
    if (happens(m_random, m_faults.corrupt_ratio)) {
        ++m_traffic->corrupted;
        flipBit(m_random, packet);
    }
    return true;
}

void FaultyBoard::advanceTo(double time_s) {
    while (!m_toBoard.empty() && m_toBoard.front().due_s <= time_s) {
        m_board->advanceTo(m_toBoard.front().due_s);
        m_board->receive(m_toBoard.front().packet);
        m_toBoard.pop_front();
    }
    m_board->advanceTo(time_s);
    m_now_s = time_s;
}

void FaultyBoard::receive(std::span<const std::uint8_t> packet) {
    std::vector<std::uint8_t> copy(packet.begin(), packet.end());
    if (!arrives(copy)) {
        return;
    }
    if (m_faults.latency_s > 0.0) {
        m_toBoard.push_back({m_now_s + m_faults.latency_s, 0, std::move(copy)});
    } else {
        m_board->receive(copy);
    }
}

void FaultyBoard::collect() {
    Message message;
    while (m_toMaster.size() < MaxOnTheWay && m_board->transmit(message.packet, message.counter)) {
        if (arrives(message.packet)) {
            message.due_s = m_now_s + m_faults.latency_s;
            m_toMaster.push_back(message);
        }
    }
}

bool FaultyBoard::transmit(std::vector<std::uint8_t>& packet, std::uint16_t& counter) {
    collect();
    if (m_toMaster.empty() || m_toMaster.front().due_s > m_now_s) {
        return false;
    }
    packet.swap(m_toMaster.front().packet);
    counter = m_toMaster.front().counter;
    m_toMaster.pop_front();
    return true;
}

FaultyFraming::FaultyFraming(std::unique_ptr<PacketFraming> framing, const SxiProfile& profile,
                             double corrupt_ratio, const Random& random, LineTraffic& traffic)
    : m_framing(std::move(framing)), m_profile(profile), m_corrupt_ratio(corrupt_ratio), m_random(random),
      m_traffic(&traffic) {}

std::span<const std::uint8_t> FaultyFraming::receive(std::uint8_t octet) {
    if (m_profile.isFramed ? octet == m_profile.sync : m_isBetweenFrames) {
        const bool isDamaged = happens(m_random, m_corrupt_ratio);
        m_untilDamage = isDamaged ? 1 + m_random.below(octetsBehindFirst(m_profile)) : 0;
        m_traffic->corrupted += isDamaged ? 1 : 0;
    } else if (m_untilDamage > 0 && --m_untilDamage == 0) {
        flipBit(m_random, {&octet, 1});
    }
    const std::span<const std::uint8_t> packet = m_framing->receive(octet);
    m_isBetweenFrames = !packet.empty();
    return packet;
}

void FaultyFraming::noteSilence() {
    m_isBetweenFrames = true;
    m_framing->noteSilence();
}

void FaultyFraming::append(std::vector<std::uint8_t>& line, std::uint16_t counter,
                           std::span<const std::uint8_t> packet) {
    const std::size_t begin = line.size();
    m_framing->append(line, counter, packet);
    if (line.size() > begin && happens(m_random, m_corrupt_ratio)) {
        ++m_traffic->corrupted;
        flipBit(m_random, std::span(line).subspan(begin));
    }
}

} // namespace halbench::devices
