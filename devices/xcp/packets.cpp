#include "devices/xcp/packets.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace halbench::devices::xcp {

namespace {

struct CommandEntry {
    Command command;
    const char* name;
};

constexpr std::array CommandNames = {
    CommandEntry{Command::Connect, "CONNECT"},
    CommandEntry{Command::Disconnect, "DISCONNECT"},
    CommandEntry{Command::GetStatus, "GET_STATUS"},
    CommandEntry{Command::Synch, "SYNCH"},
    CommandEntry{Command::GetCommModeInfo, "GET_COMM_MODE_INFO"},
    CommandEntry{Command::GetId, "GET_ID"},
    CommandEntry{Command::SetRequest, "SET_REQUEST"},
    CommandEntry{Command::SetMta, "SET_MTA"},
    CommandEntry{Command::Upload, "UPLOAD"},
    CommandEntry{Command::ShortUpload, "SHORT_UPLOAD"},
    CommandEntry{Command::BuildChecksum, "BUILD_CHECKSUM"},
    CommandEntry{Command::UserCommand, "USER_CMD"},
    CommandEntry{Command::Download, "DOWNLOAD"},
    CommandEntry{Command::ShortDownload, "SHORT_DOWNLOAD"},
    CommandEntry{Command::SetCalPage, "SET_CAL_PAGE"},
    CommandEntry{Command::GetCalPage, "GET_CAL_PAGE"},
    CommandEntry{Command::GetPagProcessorInfo, "GET_PAG_PROCESSOR_INFO"},
    CommandEntry{Command::CopyCalPage, "COPY_CAL_PAGE"},
    CommandEntry{Command::SetDaqPtr, "SET_DAQ_PTR"},
    CommandEntry{Command::WriteDaq, "WRITE_DAQ"},
    CommandEntry{Command::SetDaqListMode, "SET_DAQ_LIST_MODE"},
    CommandEntry{Command::StartStopDaqList, "START_STOP_DAQ_LIST"},
    CommandEntry{Command::StartStopSynch, "START_STOP_SYNCH"},
    CommandEntry{Command::GetDaqClock, "GET_DAQ_CLOCK"},
    CommandEntry{Command::GetDaqProcessorInfo, "GET_DAQ_PROCESSOR_INFO"},
    CommandEntry{Command::GetDaqResolutionInfo, "GET_DAQ_RESOLUTION_INFO"},
    CommandEntry{Command::GetDaqEventInfo, "GET_DAQ_EVENT_INFO"},
    CommandEntry{Command::FreeDaq, "FREE_DAQ"},
    CommandEntry{Command::AllocDaq, "ALLOC_DAQ"},
    CommandEntry{Command::AllocOdt, "ALLOC_ODT"},
    CommandEntry{Command::AllocOdtEntry, "ALLOC_ODT_ENTRY"},
};

struct SlaveErrorEntry {
    SlaveError error;
    const char* text;
};

constexpr std::array SlaveErrorTexts = {
    SlaveErrorEntry{SlaveError::Synch, "the command queue was cleared"},
    SlaveErrorEntry{SlaveError::Busy, "the board is busy"},
    SlaveErrorEntry{SlaveError::DaqActive, "not possible while samples are streaming"},
    SlaveErrorEntry{SlaveError::ProgrammingActive, "not possible while the board is being programmed"},
    SlaveErrorEntry{SlaveError::CommandUnknown, "the board does not know the command"},
    SlaveErrorEntry{SlaveError::CommandSyntax, "the board found the command malformed"},
    SlaveErrorEntry{SlaveError::OutOfRange, "the value is out of range"},
    SlaveErrorEntry{SlaveError::WriteProtected, "the memory is write protected"},
    SlaveErrorEntry{SlaveError::AccessDenied, "access is denied"},
    SlaveErrorEntry{SlaveError::AccessLocked, "access is locked"},
    SlaveErrorEntry{SlaveError::PageNotValid, "the page does not exist"},
    SlaveErrorEntry{SlaveError::ModeNotValid, "the mode does not exist"},
    SlaveErrorEntry{SlaveError::SegmentNotValid, "the segment does not exist"},
    SlaveErrorEntry{SlaveError::Sequence, "the commands came in the wrong order"},
    SlaveErrorEntry{SlaveError::DaqConfiguration, "the list of samples is not valid"},
    SlaveErrorEntry{SlaveError::MemoryOverflow, "the board has no memory left"},
    SlaveErrorEntry{SlaveError::Generic, "the device rejects the command"},
    SlaveErrorEntry{SlaveError::Verify, "verification failed"},
    SlaveErrorEntry{SlaveError::ResourceBusy, "the resource is not accessible now"},
};

Result<void> needOctets(Octets packet, std::size_t size, Command command) {
    if (packet.size() < size) {
        return failure(ErrorCode::Protocol,
                       fmt::format("the answer to {} has {} bytes ({}), {} are required",
                                   commandName(static_cast<std::uint8_t>(command)), packet.size(),
                                   hexText(packet), size),
                       "update the board's firmware or check the line");
    }
    return {};
}

} // namespace

std::string commandName(std::uint8_t code) {
    for (const CommandEntry& entry : CommandNames) {
        if (static_cast<std::uint8_t>(entry.command) == code) {
            return entry.name;
        }
    }
    return fmt::format("command {:02X}", code);
}

std::string slaveErrorText(std::uint8_t code) {
    for (const SlaveErrorEntry& entry : SlaveErrorTexts) {
        if (static_cast<std::uint8_t>(entry.error) == code) {
            return entry.text;
        }
    }
    return fmt::format("unknown error {:02X}", code);
}

PacketKind kindOf(Octets packet) {
    if (packet.empty()) {
        return PacketKind::Empty;
    }
    switch (packet[0]) {
    case 0xFF:
        return PacketKind::Response;
    case 0xFE:
        return PacketKind::Error;
    case 0xFD:
        return PacketKind::Event;
    case 0xFC:
        return PacketKind::Service;
    default:
        return PacketKind::Data;
    }
}

Result<ConnectResponse> decodeConnect(Octets packet) {
    if (Result<void> size = needOctets(packet, 8, Command::Connect); !size) {
        return failure(size.error());
    }
    ConnectResponse response;
    response.resource = packet[1];
    response.commMode = packet[2];
    response.order = (packet[2] & 0x01) != 0 ? ByteOrder::BigEndian : ByteOrder::LittleEndian;
    response.maxCto = packet[3];
    response.maxDto = static_cast<std::uint16_t>(readUnsigned(packet.subspan(4, 2), response.order));
    response.protocolVersion = packet[6];
    response.transportVersion = packet[7];
    if ((packet[2] & 0x06) != 0) {
        return failure(ErrorCode::Protocol, "the device counts addresses in words, not bytes",
                       "only byte granularity is supported");
    }
    if (response.maxCto < 8 || response.maxDto < 8) {
        return failure(ErrorCode::Protocol,
                       fmt::format("the device announces packets of {} and {} bytes, at least 8 are required",
                                   response.maxCto, response.maxDto),
                       "the device does not use a supported protocol");
    }
    return response;
}

Result<StatusResponse> decodeStatus(Octets packet) {
    if (Result<void> size = needOctets(packet, 6, Command::GetStatus); !size) {
        return failure(size.error());
    }
    return StatusResponse{packet[1], packet[2]};
}

Result<IdResponse> decodeId(Octets packet, ByteOrder order) {
    if (Result<void> size = needOctets(packet, 8, Command::GetId); !size) {
        return failure(size.error());
    }
    IdResponse response;
    response.length = static_cast<std::uint32_t>(readUnsigned(packet.subspan(4, 4), order));
    response.isInline = (packet[1] & 0x01) != 0;
    if (response.isInline) {
        if (response.length > packet.size() - 8) {
            return failure(ErrorCode::Protocol,
                           fmt::format("the answer to GET_ID announces {} bytes and contains {}",
                                       response.length, packet.size() - 8),
                           "update the board's firmware or check the line");
        }
        const Octets text = packet.subspan(8, response.length);
        response.text.assign(text.begin(), text.end());
    }
    return response;
}

Result<ChecksumResponse> decodeChecksum(Octets packet, ByteOrder order) {
    if (Result<void> size = needOctets(packet, 8, Command::BuildChecksum); !size) {
        return failure(size.error());
    }
    return ChecksumResponse{packet[1], static_cast<std::uint32_t>(readUnsigned(packet.subspan(4, 4), order))};
}

Result<std::uint8_t> decodeCalPage(Octets packet) {
    if (Result<void> size = needOctets(packet, 4, Command::GetCalPage); !size) {
        return failure(size.error());
    }
    return packet[3];
}

std::size_t sizeOf(IdField field) {
    constexpr std::array<std::size_t, 4> Sizes = {1, 2, 3, 4};
    return Sizes[static_cast<std::size_t>(field)];
}

Result<DaqProcessorResponse> decodeDaqProcessor(Octets packet, ByteOrder order) {
    if (Result<void> size = needOctets(packet, 8, Command::GetDaqProcessorInfo); !size) {
        return failure(size.error());
    }
    DaqProcessorResponse response;
    response.properties = packet[1];
    response.maxDaq = static_cast<std::uint16_t>(readUnsigned(packet.subspan(2, 2), order));
    response.maxEvent = static_cast<std::uint16_t>(readUnsigned(packet.subspan(4, 2), order));
    response.minDaq = packet[6];
    response.idField = static_cast<IdField>(packet[7] >> 6);
    return response;
}

Result<DaqResolutionResponse> decodeDaqResolution(Octets packet, ByteOrder order) {
    if (Result<void> size = needOctets(packet, 8, Command::GetDaqResolutionInfo); !size) {
        return failure(size.error());
    }
    DaqResolutionResponse response;
    response.granularity = packet[1];
    response.maxEntrySize = packet[2];
    const std::uint8_t mode = packet[5];
    response.timestampSize = mode & 0x07;
    response.isTimestampFixed = (mode & 0x08) != 0;
    const Result<double> unit = unitSeconds(static_cast<std::uint8_t>(mode >> 4));
    const double ticks = static_cast<double>(readUnsigned(packet.subspan(6, 2), order));
    const bool isSizeKnown = response.timestampSize <= 2 || response.timestampSize == 4;
    if (response.granularity == 0 || response.maxEntrySize == 0 || !isSizeKnown ||
        (response.timestampSize != 0 && (!unit || ticks == 0.0))) {
        return failure(ErrorCode::Protocol, fmt::format("invalid sampling resolution ({})", hexText(packet)),
                       "update the board's firmware");
    }
    if (response.timestampSize != 0) {
        response.tick_s = *unit * ticks;
        const double perSecond = std::round(1.0 / *unit) / ticks;
        response.ticksPerSecond = perSecond == std::floor(perSecond) ? perSecond : 0.0;
    }
    return response;
}

Result<std::uint32_t> decodeDaqClock(Octets packet, ByteOrder order) {
    if (Result<void> size = needOctets(packet, 8, Command::GetDaqClock); !size) {
        return failure(size.error());
    }
    return static_cast<std::uint32_t>(readUnsigned(packet.subspan(4, 4), order));
}

Result<DaqEventResponse> decodeDaqEvent(Octets packet) {
    if (Result<void> size = needOctets(packet, 7, Command::GetDaqEventInfo); !size) {
        return failure(size.error());
    }
    DaqEventResponse response;
    response.properties = packet[1];
    response.maxLists = packet[2];
    response.nameLength = packet[3];
    if (packet[4] != 0) {
        const Result<double> unit = unitSeconds(packet[5]);
        if (!unit) {
            return failure(unit.error());
        }
        response.cycle_s = *unit * packet[4];
    }
    return response;
}

Result<double> unitSeconds(std::uint8_t code) {
    constexpr std::array Seconds = {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0};
    if (code >= Seconds.size()) {
        return failure(ErrorCode::Protocol, fmt::format("time unit {} does not exist", code),
                       "update the board's firmware");
    }
    return Seconds[code];
}

} // namespace halbench::devices::xcp
