#include "tests/devices/xcp/test_slave.h"

#include <fmt/format.h>

namespace halbench::devices::xcp {

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
                          TestSegmentAddress, TestSegmentSize,
                          m_traits.isPage1ReadOnly ? "XCP_WRITE_ACCESS_NOT_ALLOWED"
                                                   : "XCP_WRITE_ACCESS_DONT_CARE");
    const auto parameter = [](const char* name, std::uint32_t offset, const char* layout, const char* max) {
        return fmt::format("/begin CHARACTERISTIC {} \"\" VALUE 0x{:X} {} 0 NO_COMPU_METHOD 0 {} "
                           "/end CHARACTERISTIC\n",
                           name, TestSegmentAddress + offset, layout, max);
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

std::deque<Packet> TestSlave::answerMemory(const Packet& command) {
    Packet data = {0xFF};
    switch (static_cast<Command>(command[0])) {
    case Command::SetMta:
        m_extension = command[3];
        m_address = static_cast<std::uint32_t>(word(command, 4, 4));
        return slaveOk();
    case Command::Upload:
        return upload(command[1]);
    case Command::ShortUpload:
        return readMemory(command[3], static_cast<std::uint32_t>(word(command, 4, 4)), command[1], data)
                   ? std::deque<Packet>{data}
                   : slaveError(SlaveError::OutOfRange);
    case Command::Download: {
        const bool isDone = writeMemory(m_extension, m_address, Octets(command).subspan(2, command[1]));
        m_address += command[1];
        return isDone ? slaveOk() : slaveError(SlaveError::WriteProtected);
    }
    case Command::ShortDownload:
        if (!m_traits.hasShortDownload) {
            return {};
        }
        return writeMemory(command[3], static_cast<std::uint32_t>(word(command, 4, 4)),
                           Octets(command).subspan(8, command[1]))
                   ? slaveOk()
                   : slaveError(SlaveError::WriteProtected);
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
            return slaveError(SlaveError::OutOfRange);
        }
        m_address += static_cast<std::uint32_t>(part);
        count -= part;
        answers.push_back(data);
        if (count > 0 && !m_traits.hasBlockMode) {
            return slaveError(SlaveError::OutOfRange);
        }
    }
    return answers;
}

std::vector<std::uint8_t>* TestSlave::memoryAt(std::uint8_t extension, std::uint32_t address,
                                               std::size_t& place) {
    if (extension != 0) {
        return nullptr;
    }
    if (address >= TestSegmentAddress && address < TestSegmentAddress + TestSegmentSize) {
        place = address - TestSegmentAddress;
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
            return slaveError(SlaveError::PageNotValid);
        }
        if ((command[1] & 1) != 0) {
            m_runningPage = command[3];
        }
        if ((command[1] & 2) != 0) {
            m_masterPage = command[3];
        }
        return slaveOk();
    case Command::GetCalPage:
        return {response({{0, 1}, {0, 1}, {command[1] == 1 ? m_runningPage : m_masterPage, 1}})};
    case Command::CopyCalPage:
        if (command[2] > 1 || command[4] > 1) {
            return slaveError(SlaveError::PageNotValid);
        }
        m_pages[command[4]] = m_pages[command[2]];
        return slaveOk();
    default:
        return {};
    }
}

} // namespace halbench::devices::xcp
