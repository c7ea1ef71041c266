#include "tests/devices/xcp/test_slave.h"

#include <cmath>

namespace halbench::devices::xcp {

namespace {

constexpr std::uint8_t FirstPid = 3;

} // namespace

std::deque<Packet> TestSlave::answerDaq(const Packet& command) {
    const auto key = static_cast<std::uint8_t>(static_cast<unsigned>(m_traits.idField) << 6);
    const auto properties = static_cast<std::uint8_t>(0x13 | (m_traits.marksOverload ? 0x40 : 0));
    switch (static_cast<Command>(command[0])) {
    case Command::GetDaqProcessorInfo:
        return {response({{properties, 1}, {m_traits.maxDaq, 2}, {1, 2}, {0, 1}, {key, 1}})};
    case Command::GetDaqResolutionInfo:
        return {response({{1, 1},
                          {8, 1},
                          {1, 1},
                          {8, 1},
                          {m_traits.timestampSize | (m_traits.timestampUnit << 4), 1},
                          {1, 2}})};
    case Command::GetDaqEventInfo:
        return {response({{4, 1}, {1, 1}, {0, 1}, {10, 1}, {6, 1}, {0, 1}})};
    case Command::GetDaqClock:
        return clockAnswer();
    case Command::FreeDaq:
    case Command::AllocDaq:
        m_odts.clear();
        m_isSampling = false;
        return slaveOk();
    case Command::AllocOdt:
        m_odts.resize(command[4]);
        return slaveOk();
    case Command::AllocOdtEntry:
        m_odts.at(command[4]).resize(command[5]);
        return slaveOk();
    case Command::SetDaqPtr:
        m_writeOdt = command[4];
        m_writeEntry = command[5];
        return slaveOk();
    case Command::WriteDaq:
        if (m_writeOdt >= m_odts.size() || m_writeEntry >= m_odts[m_writeOdt].size()) {
            return slaveError(SlaveError::Sequence);
        }
        m_odts[m_writeOdt][m_writeEntry++] = {static_cast<std::uint32_t>(word(command, 4, 4)), command[2]};
        return slaveOk();
    case Command::SetDaqListMode:
        m_prescaler = command[6];
        return slaveOk();
    case Command::StartStopDaqList:
        m_isSelected = command[1] == 2;
        return {response({{FirstPid, 1}})};
    case Command::StartStopSynch:
        m_isSampling = command[1] == 1 && m_isSelected;
        return slaveOk();
    default:
        return {};
    }
}

/// The slave's own clock, which may start anywhere and run fast or slow.
std::uint64_t TestSlave::ticksAt(double time_s) const {
    const double units[] = {1e9, 1e8, 1e7, 1e6, 1e5, 1e4, 1e3};
    return m_traits.firstTick + static_cast<std::uint64_t>(std::llround(time_s * m_traits.clockRatio *
                                                                        units[m_traits.timestampUnit]));
}

std::deque<Packet> TestSlave::clockAnswer() {
    if (!m_traits.hasClockCommand) {
        return {};
    }
    return {response({{0, 1}, {0, 1}, {1, 1}, {ticksAt(m_now_s + answerDelay_s / 2.0) & 0xFFFFFFFFU, 4}})};
}

void TestSlave::refreshSignals() {
    m_signals.clear();
    const auto number = static_cast<double>(m_samples);
    const auto put = [this](std::size_t address, double value, DataType type) {
        m_signals.resize(address);
        appendRaw(m_signals, value, type, m_traits.order);
    };
    put(0, number, DataType::ULong);
    put(8, number / 4.0, DataType::Float32);
    put(16, static_cast<double>(m_samples % 256), DataType::UByte);
    put(24, number / 8.0, DataType::Float64);
    m_signals.resize(64);
}

void TestSlave::sample() {
    ++m_samples;
    m_nextSample_s = TestSamplePeriod_s * static_cast<double>(m_samples + 1);
    if (!m_isSampling || m_samples % m_prescaler != 0) {
        return;
    }
    refreshSignals();
    const std::uint64_t ticks = ticksAt(TestSamplePeriod_s * static_cast<double>(m_samples));
    for (std::size_t odt = 0; odt < m_odts.size(); ++odt) {
        Packet packet;
        const std::size_t pid = m_traits.idField == IdField::Absolute ? FirstPid + odt : odt;
        packet.push_back(static_cast<std::uint8_t>(pid));
        if (m_traits.idField == IdField::RelativeWordAligned) {
            packet.push_back(0xAA);
        }
        if (m_traits.idField != IdField::Absolute) {
            appendUnsigned(packet, 0, m_traits.idField == IdField::RelativeByte ? 1 : 2, m_traits.order);
        }
        if (odt == 0 && m_traits.timestampSize != 0) {
            appendUnsigned(packet, ticks, m_traits.timestampSize, m_traits.order);
        }
        for (const Entry& entry : m_odts[odt]) {
            packet.insert(packet.end(), m_signals.begin() + entry.address,
                          m_signals.begin() + entry.address + entry.size);
        }
        while (packet.size() % m_traits.dtoAlignment != 0) {
            packet.push_back(0xEE);
        }
        if (bendSample) {
            bendSample(packet);
        }
        if (!packet.empty()) {
            m_outgoing.push_back({m_now_s, std::move(packet)});
        }
    }
}

} // namespace halbench::devices::xcp
