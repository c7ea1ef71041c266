#include "tests/devices/xcp/test_slave.h"

namespace halbench::devices::xcp {

TestSlave::TestSlave(SlaveTraits traits)
    : m_traits(traits), m_pages{std::vector<std::uint8_t>(TestSegmentSize, 0),
                                std::vector<std::uint8_t>(TestSegmentSize, 0)},
      m_signals(64, 0) {
    m_text = ownDescription();
}

std::uint64_t TestSlave::word(const Packet& packet, std::size_t place, std::size_t size) const {
    return place + size <= packet.size() ? readUnsigned(Octets(packet).subspan(place, size), m_traits.order)
                                         : 0;
}

Packet TestSlave::response(std::initializer_list<std::pair<std::uint64_t, std::size_t>> fields) const {
    Packet packet = {0xFF};
    for (const auto& [value, size] : fields) {
        appendUnsigned(packet, value, size, m_traits.order);
    }
    return packet;
}

bool TestSlave::isUnplugged() const {
    return unplugAt_s && m_now_s >= *unplugAt_s;
}

Result<void> TestSlave::open() {
    if (descriptionText) {
        m_text = *descriptionText;
    }
    return {};
}

Result<void> TestSlave::send(std::span<const std::uint8_t> packet) {
    if (unplugAtCommand && commands.size() >= *unplugAtCommand) {
        unplugAt_s = m_now_s;
    }
    if (isUnplugged()) {
        return failure(ErrorCode::DeviceLost, "unplugged", "plug it in");
    }
    commands.emplace_back(packet.begin(), packet.end());
    std::deque<Packet> answers = answer(commands.back());
    if (bendAnswers) {
        bendAnswers(commands.back(), answers);
    }
    for (Packet& one : answers) {
        m_outgoing.push_back({m_now_s + answerDelay_s, std::move(one)});
    }
    return {};
}

Result<bool> TestSlave::receive(std::vector<std::uint8_t>& packet, double timeout_s) {
    const double end_s = m_now_s + timeout_s;
    for (;;) {
        if (isUnplugged()) {
            return failure(ErrorCode::DeviceLost, "unplugged", "plug it in");
        }
        if (!m_outgoing.empty() && m_outgoing.front().due_s <= m_now_s) {
            packet = std::move(m_outgoing.front().packet);
            m_outgoing.pop_front();
            m_now_s += 1e-7; // nothing is free: a flood of packets takes time
            return true;
        }
        const double due_s = std::min(m_outgoing.empty() ? end_s : m_outgoing.front().due_s, m_nextSample_s);
        if (due_s > end_s) {
            m_now_s = end_s;
            return false;
        }
        m_now_s = std::max(m_now_s, due_s);
        if (m_now_s >= m_nextSample_s) {
            sample();
        } else if (m_now_s >= end_s) {
            return false;
        }
    }
}

std::size_t TestSlave::count(Command command) const {
    std::size_t number = 0;
    for (const Packet& one : commands) {
        number += one[0] == static_cast<std::uint8_t>(command) ? 1 : 0;
    }
    return number;
}

float TestSlave::parameter(std::size_t page, std::size_t offset) const {
    return static_cast<float>(
        decodeRaw(Octets(m_pages[page]).subspan(offset, 4), DataType::Float32, m_traits.order));
}

std::deque<Packet> TestSlave::answer(const Packet& command) {
    const auto code = static_cast<Command>(command[0]);
    if (code == Command::Connect) {
        m_isConnected = true;
        m_isSampling = false;
        const auto mode = static_cast<std::uint8_t>((m_traits.order == ByteOrder::BigEndian ? 1 : 0) |
                                                    (m_traits.hasBlockMode ? 0x40 : 0));
        return {response({{0x05, 1}, {mode, 1}, {m_traits.maxCto, 1}, {m_traits.maxDto, 2}, {1, 1}, {1, 1}})};
    }
    if (!m_isConnected) {
        return {};
    }
    for (const auto& part :
         {&TestSlave::answerInfo, &TestSlave::answerMemory, &TestSlave::answerPages, &TestSlave::answerDaq}) {
        std::deque<Packet> answers = (this->*part)(command);
        if (!answers.empty()) {
            return answers;
        }
    }
    return slaveError(SlaveError::CommandUnknown);
}

/// The name (1) and the EPK (5) come with the answer; the slave has no other texts.
Packet TestSlave::identity(std::uint8_t type) const {
    const std::string text = type == 1 ? m_traits.name : type == 5 ? m_traits.epk : "";
    Packet packet = response({{text.empty() ? 0U : 1U, 1}, {0, 2}, {text.size(), 4}});
    packet.insert(packet.end(), text.begin(), text.end());
    return packet;
}

std::deque<Packet> TestSlave::answerInfo(const Packet& command) {
    switch (static_cast<Command>(command[0])) {
    case Command::Disconnect:
        m_isConnected = false;
        return slaveOk();
    case Command::GetStatus:
        return {response({{m_isSampling ? 0x40U : 0U, 1}, {0, 1}, {0, 1}, {0, 2}})};
    case Command::Synch:
        return slaveError(SlaveError::Synch);
    case Command::GetId:
        if (command[1] == 4) {
            m_extension = 1;
            m_address = 0;
            return {response({{0, 1}, {0, 2}, {m_text.size(), 4}})};
        }
        return {identity(command[1])};
    default:
        return {};
    }
}

} // namespace halbench::devices::xcp
