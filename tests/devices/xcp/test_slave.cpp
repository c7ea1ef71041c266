#include "tests/devices/xcp/test_slave.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

namespace halbench::devices::xcp {

namespace {

constexpr std::uint32_t SegmentAddress = 0x4000;
constexpr std::size_t SegmentSize = 64;
constexpr double SamplePeriod_s = 0.010;
constexpr std::uint8_t FirstPid = 3;

std::deque<Packet> ok() {
    return {{0xFF}};
}

std::deque<Packet> error(SlaveError code) {
    return {{0xFE, static_cast<std::uint8_t>(code)}};
}

} // namespace

TestSlave::TestSlave(SlaveTraits traits)
    : m_traits(traits), m_pages{std::vector<std::uint8_t>(SegmentSize, 0),
                                std::vector<std::uint8_t>(SegmentSize, 0)},
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

std::string TestSlave::ownDescription() const {
    const std::string pages =
        !m_traits.hasPages
            ? ""
            : fmt::format("/begin MOD_PAR \"\" /begin MEMORY_SEGMENT cal \"\" DATA RAM INTERN 0x{:X} {} "
                          "-1 -1 -1 -1 -1 /begin IF_DATA XCP /begin SEGMENT 0 2 0 0 0 "
                          "/begin PAGE 0 ECU_ACCESS_DONT_CARE XCP_READ_ACCESS_DONT_CARE "
                          "XCP_WRITE_ACCESS_DONT_CARE /end PAGE /begin PAGE 1 ECU_ACCESS_DONT_CARE "
                          "XCP_READ_ACCESS_DONT_CARE {} /end PAGE /end SEGMENT /end IF_DATA "
                          "/end MEMORY_SEGMENT /end MOD_PAR\n",
                          SegmentAddress, SegmentSize,
                          m_traits.isPage1ReadOnly ? "XCP_WRITE_ACCESS_NOT_ALLOWED"
                                                   : "XCP_WRITE_ACCESS_DONT_CARE");
    const auto parameter = [](const char* name, std::uint32_t offset, const char* layout, const char* max) {
        return fmt::format("/begin CHARACTERISTIC {} \"\" VALUE 0x{:X} {} 0 NO_COMPU_METHOD 0 {} "
                           "/end CHARACTERISTIC\n",
                           name, SegmentAddress + offset, layout, max);
    };
    return "ASAP2_VERSION 1 71 /begin PROJECT test \"\" /begin MODULE slave \"\"\n" + pages +
           "/begin RECORD_LAYOUT f FNC_VALUES 1 FLOAT32_IEEE ROW_DIR DIRECT /end RECORD_LAYOUT\n"
           "/begin RECORD_LAYOUT w FNC_VALUES 1 UWORD ROW_DIR DIRECT /end RECORD_LAYOUT\n" +
           parameter("p.a", 0, "f", "1000") + parameter("p.b", m_traits.hasGap ? 8 : 4, "f", "1000") +
           parameter("p.n", 16, "w", "65535") +
           "/begin MEASUREMENT count \"\" ULONG NO_COMPU_METHOD 0 0 0 4294967295 ECU_ADDRESS 0 /end "
           "MEASUREMENT\n"
           "/begin MEASUREMENT wave \"\" FLOAT32_IEEE NO_COMPU_METHOD 0 0 0 1e9 ECU_ADDRESS 8 /end "
           "MEASUREMENT\n"
           "/begin MEASUREMENT byte \"\" UBYTE NO_COMPU_METHOD 0 0 0 255 ECU_ADDRESS 16 /end MEASUREMENT\n"
           "/begin MEASUREMENT big \"\" FLOAT64_IEEE NO_COMPU_METHOD 0 0 0 1e9 ECU_ADDRESS 24 /end "
           "MEASUREMENT\n"
           "/end MODULE /end PROJECT\n";
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
    return error(SlaveError::CommandUnknown);
}

std::deque<Packet> TestSlave::answerInfo(const Packet& command) {
    switch (static_cast<Command>(command[0])) {
    case Command::Disconnect:
        m_isConnected = false;
        return ok();
    case Command::GetStatus:
        return {response({{m_isSampling ? 0x40U : 0U, 1}, {0, 1}, {0, 1}, {0, 2}})};
    case Command::Synch:
        return error(SlaveError::Synch);
    case Command::GetId:
        if (command[1] == 4) {
            m_extension = 1;
            m_address = 0;
            return {response({{0, 1}, {0, 2}, {m_text.size(), 4}})};
        }
        return {response({{0, 1}, {0, 2}, {0, 4}})};
    default:
        return {};
    }
}

std::deque<Packet> TestSlave::answerMemory(const Packet& command) {
    Packet data = {0xFF};
    switch (static_cast<Command>(command[0])) {
    case Command::SetMta:
        m_extension = command[3];
        m_address = static_cast<std::uint32_t>(word(command, 4, 4));
        return ok();
    case Command::Upload:
        return upload(command[1]);
    case Command::ShortUpload:
        return readMemory(command[3], static_cast<std::uint32_t>(word(command, 4, 4)), command[1], data)
                   ? std::deque<Packet>{data}
                   : error(SlaveError::OutOfRange);
    case Command::Download: {
        const bool isDone = writeMemory(m_extension, m_address, Octets(command).subspan(2, command[1]));
        m_address += command[1];
        return isDone ? ok() : error(SlaveError::WriteProtected);
    }
    case Command::ShortDownload:
        if (!m_traits.hasShortDownload) {
            return {};
        }
        return writeMemory(command[3], static_cast<std::uint32_t>(word(command, 4, 4)),
                           Octets(command).subspan(8, command[1]))
                   ? ok()
                   : error(SlaveError::WriteProtected);
    case Command::BuildChecksum: {
        const std::size_t size = word(command, 4, 4);
        Packet octets;
        if (!m_traits.hasChecksum || !readMemory(m_extension, m_address, size, octets)) {
            return {};
        }
        return {response({{8, 1}, {0, 2}, {crc16(octets), 4}})};
    }
    default:
        return {};
    }
}

std::deque<Packet> TestSlave::upload(std::size_t count) {
    std::deque<Packet> answers;
    while (count > 0) {
        const std::size_t part = std::min<std::size_t>(count, m_traits.maxCto - 1U);
        Packet data = {0xFF};
        if (!readMemory(m_extension, m_address, part, data)) {
            return error(SlaveError::OutOfRange);
        }
        m_address += static_cast<std::uint32_t>(part);
        count -= part;
        answers.push_back(data);
        if (count > 0 && !m_traits.hasBlockMode) {
            return error(SlaveError::OutOfRange);
        }
    }
    return answers;
}

std::vector<std::uint8_t>* TestSlave::memoryAt(std::uint8_t extension, std::uint32_t address,
                                               std::size_t& place) {
    if (extension != 0) {
        return nullptr;
    }
    if (address >= SegmentAddress && address < SegmentAddress + SegmentSize) {
        place = address - SegmentAddress;
        return &m_pages[m_masterPage];
    }
    place = address;
    return address < m_signals.size() ? &m_signals : nullptr;
}

bool TestSlave::readMemory(std::uint8_t extension, std::uint32_t address, std::size_t count, Packet& data) {
    if (extension == 1) {
        if (address + count > m_text.size()) {
            return false;
        }
        data.insert(data.end(), m_text.begin() + address,
                    m_text.begin() + address + static_cast<long>(count));
        return true;
    }
    refreshSignals();
    std::size_t place = 0;
    const std::vector<std::uint8_t>* memory = memoryAt(extension, address, place);
    if (memory == nullptr || place + count > memory->size()) {
        return false;
    }
    const auto begin = memory->begin() + static_cast<long>(place);
    data.insert(data.end(), begin, begin + static_cast<long>(count));
    return true;
}

bool TestSlave::writeMemory(std::uint8_t extension, std::uint32_t address, Octets data) {
    std::size_t place = 0;
    std::vector<std::uint8_t>* memory = memoryAt(extension, address, place);
    const bool isProtected = memory == &m_signals || (m_traits.isPage1ReadOnly && m_masterPage == 1);
    if (memory == nullptr || isProtected || place + data.size() > memory->size()) {
        return false;
    }
    std::copy(data.begin(), data.end(), memory->begin() + static_cast<long>(place));
    return true;
}

std::deque<Packet> TestSlave::answerPages(const Packet& command) {
    if (!m_traits.hasPages) {
        return {};
    }
    switch (static_cast<Command>(command[0])) {
    case Command::SetCalPage:
        if (command[3] > 1) {
            return error(SlaveError::PageNotValid);
        }
        if ((command[1] & 1) != 0) {
            m_runningPage = command[3];
        }
        if ((command[1] & 2) != 0) {
            m_masterPage = command[3];
        }
        return ok();
    case Command::GetCalPage:
        return {response({{0, 1}, {0, 1}, {command[1] == 1 ? m_runningPage : m_masterPage, 1}})};
    case Command::CopyCalPage:
        if (command[2] > 1 || command[4] > 1) {
            return error(SlaveError::PageNotValid);
        }
        m_pages[command[4]] = m_pages[command[2]];
        return ok();
    default:
        return {};
    }
}

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
    case Command::FreeDaq:
    case Command::AllocDaq:
        m_odts.clear();
        m_isSampling = false;
        return ok();
    case Command::AllocOdt:
        m_odts.resize(command[4]);
        return ok();
    case Command::AllocOdtEntry:
        m_odts.at(command[4]).resize(command[5]);
        return ok();
    case Command::SetDaqPtr:
        m_writeOdt = command[4];
        m_writeEntry = command[5];
        return ok();
    case Command::WriteDaq:
        if (m_writeOdt >= m_odts.size() || m_writeEntry >= m_odts[m_writeOdt].size()) {
            return error(SlaveError::Sequence);
        }
        m_odts[m_writeOdt][m_writeEntry++] = {static_cast<std::uint32_t>(word(command, 4, 4)), command[2]};
        return ok();
    case Command::SetDaqListMode:
        m_prescaler = command[6];
        return ok();
    case Command::StartStopDaqList:
        m_isSelected = command[1] == 2;
        return {response({{FirstPid, 1}})};
    case Command::StartStopSynch:
        m_isSampling = command[1] == 1 && m_isSelected;
        return ok();
    default:
        return {};
    }
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
    m_nextSample_s = SamplePeriod_s * static_cast<double>(m_samples + 1);
    if (!m_isSampling || m_samples % m_prescaler != 0) {
        return;
    }
    refreshSignals();
    const double units[] = {1e9, 1e8, 1e7, 1e6, 1e5, 1e4, 1e3};
    const auto ticks = static_cast<std::uint64_t>(
        std::llround(SamplePeriod_s * static_cast<double>(m_samples) * units[m_traits.timestampUnit]));
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
            appendUnsigned(packet, m_traits.firstTick + ticks, m_traits.timestampSize, m_traits.order);
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
