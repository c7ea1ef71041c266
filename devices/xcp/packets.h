#pragma once

#include "control/base/result.h"
#include "devices/xcp/octets.h"

#include <cstdint>
#include <string>

namespace halbench::devices::xcp {

// Pure bytes: commands out, answers in. Nothing here knows a device, a time or a transport.
// Codes, layouts and bits: resources/help/protocol.md 3.5.

enum class Command : std::uint8_t {
    Connect = 0xFF,
    Disconnect = 0xFE,
    GetStatus = 0xFD,
    Synch = 0xFC,
    GetCommModeInfo = 0xFB,
    GetId = 0xFA,
    SetRequest = 0xF9,
    SetMta = 0xF6,
    Upload = 0xF5,
    ShortUpload = 0xF4,
    BuildChecksum = 0xF3,
    UserCommand = 0xF1,
    Download = 0xF0,
    ShortDownload = 0xED,
    SetCalPage = 0xEB,
    GetCalPage = 0xEA,
    GetPagProcessorInfo = 0xE9,
    CopyCalPage = 0xE4,
    SetDaqPtr = 0xE2,
    WriteDaq = 0xE1,
    SetDaqListMode = 0xE0,
    StartStopDaqList = 0xDE,
    StartStopSynch = 0xDD,
    GetDaqClock = 0xDC,
    GetDaqProcessorInfo = 0xDA,
    GetDaqResolutionInfo = 0xD9,
    GetDaqEventInfo = 0xD7,
    FreeDaq = 0xD6,
    AllocDaq = 0xD5,
    AllocOdt = 0xD4,
    AllocOdtEntry = 0xD3
};

/// "SET_CAL_PAGE", or "command 12" for an unknown code.
std::string commandName(std::uint8_t code);

/// Error codes of an ERR packet (3.6).
enum class SlaveError : std::uint8_t {
    Synch = 0x00,
    Busy = 0x10,
    DaqActive = 0x11,
    ProgrammingActive = 0x12,
    CommandUnknown = 0x20,
    CommandSyntax = 0x21,
    OutOfRange = 0x22,
    WriteProtected = 0x23,
    AccessDenied = 0x24,
    AccessLocked = 0x25,
    PageNotValid = 0x26,
    ModeNotValid = 0x27,
    SegmentNotValid = 0x28,
    Sequence = 0x29,
    DaqConfiguration = 0x2A,
    MemoryOverflow = 0x30,
    Generic = 0x31,
    Verify = 0x32,
    ResourceBusy = 0x33
};

/// In words, e.g. "the value is out of range".
std::string slaveErrorText(std::uint8_t code);

enum class PacketKind { Response, Error, Event, Service, Data, Empty };
PacketKind kindOf(Octets packet);

enum class Event : std::uint8_t {
    StoreCalibrationDone = 0x03,
    CommandPending = 0x05,
    DaqOverload = 0x06,
    SessionTerminated = 0x07,
    User = 0xFE,
    Transport = 0xFF
};

enum class IdType : std::uint8_t { Text = 0, Name = 1, Upload = 4, Epk = 5 };

struct Address {
    std::uint32_t offset = 0;
    std::uint8_t extension = 0;
    bool operator==(const Address&) const = default;
};

/// Bits of SET_CAL_PAGE: which access the page is meant for.
enum class PageAccess : std::uint8_t { ControlLoop = 1, Master = 2 };

/// Makes command packets in the byte order the slave announced.
class CommandEncoder {
public:
    explicit CommandEncoder(ByteOrder order = ByteOrder::LittleEndian) : m_order(order) {}

    Packet connect() const;
    /// A command without arguments.
    Packet plain(Command command) const;
    Packet getId(IdType type) const;
    Packet setRequest(std::uint8_t mode) const;
    Packet setMta(Address address) const;
    Packet upload(std::uint8_t count) const;
    Packet shortUpload(Address address, std::uint8_t count) const;
    Packet buildChecksum(std::uint32_t size) const;
    Packet userCommand(std::uint8_t sub) const;
    Packet download(Octets data) const;
    Packet shortDownload(Address address, Octets data) const;
    Packet setCalPage(std::uint8_t access, std::uint8_t segment, std::uint8_t page) const;
    Packet getCalPage(PageAccess access, std::uint8_t segment) const;
    Packet copyCalPage(std::uint8_t segment, std::uint8_t from, std::uint8_t to) const;
    Packet allocDaq(std::uint16_t count) const;
    Packet allocOdt(std::uint16_t list, std::uint8_t count) const;
    Packet allocOdtEntry(std::uint16_t list, std::uint8_t odt, std::uint8_t count) const;
    Packet setDaqPtr(std::uint16_t list, std::uint8_t odt, std::uint8_t entry) const;
    Packet writeDaq(Address address, std::uint8_t size) const;
    Packet setDaqListMode(std::uint8_t mode, std::uint16_t list, std::uint16_t event,
                          std::uint8_t prescaler) const;
    Packet startStopDaqList(std::uint8_t mode, std::uint16_t list) const;
    Packet startStopSynch(std::uint8_t mode) const;
    Packet getDaqEventInfo(std::uint16_t event) const;

private:
    ByteOrder m_order;
};

// Answers. Each decoder takes a whole RES packet and refuses one that is too short: Protocol.

struct ConnectResponse {
    std::uint8_t resource = 0;
    std::uint8_t commMode = 0;
    std::uint8_t maxCto = 8;
    std::uint16_t maxDto = 8;
    std::uint8_t protocolVersion = 1;
    std::uint8_t transportVersion = 1;
    ByteOrder order = ByteOrder::LittleEndian;

    bool hasDaq() const { return (resource & 0x04) != 0; }
    bool hasBlockMode() const { return (commMode & 0x40) != 0; }
};
/// Refuses MAX_CTO below 8, MAX_DTO below 8 and word or long granularity.
Result<ConnectResponse> decodeConnect(Octets packet);

struct StatusResponse {
    std::uint8_t session = 0;
    std::uint8_t protection = 0;

    bool isStoring() const { return (session & 0x01) != 0; }
    bool isDaqRunning() const { return (session & 0x40) != 0; }
};
Result<StatusResponse> decodeStatus(Octets packet);

struct IdResponse {
    std::uint32_t length = 0;
    bool isInline = false; ///< `text` came with the answer; otherwise it waits at the MTA
    std::string text;
};
Result<IdResponse> decodeId(Octets packet, ByteOrder order);

struct ChecksumResponse {
    std::uint8_t type = 0;
    std::uint32_t checksum = 0;
};
Result<ChecksumResponse> decodeChecksum(Octets packet, ByteOrder order);

Result<std::uint8_t> decodeCalPage(Octets packet);

enum class IdField { Absolute = 0, RelativeByte = 1, RelativeWord = 2, RelativeWordAligned = 3 };
/// Octets before the time stamp (3.8).
std::size_t sizeOf(IdField field);

struct DaqProcessorResponse {
    std::uint8_t properties = 0;
    std::uint16_t maxDaq = 0; ///< 0 happens and means nothing (3.8)
    std::uint16_t maxEvent = 0;
    std::uint8_t minDaq = 0;
    IdField idField = IdField::Absolute;

    bool isDynamic() const { return (properties & 0x01) != 0; }
    bool hasPrescaler() const { return (properties & 0x02) != 0; }
    bool hasTimestamp() const { return (properties & 0x10) != 0; }
    bool marksOverloadInPid() const { return (properties >> 6) == 1; }
};
Result<DaqProcessorResponse> decodeDaqProcessor(Octets packet, ByteOrder order);

struct DaqResolutionResponse {
    std::uint8_t granularity = 1;
    std::uint8_t maxEntrySize = 1;
    std::uint8_t timestampSize = 0; ///< 0, 1, 2 or 4 octets
    bool isTimestampFixed = false;
    double tick_s = 0.0; ///< unit times ticks
    /// Ticks in a second where that is a whole number, so that times divide exactly; 0 otherwise.
    double ticksPerSecond = 0.0;
};
Result<DaqResolutionResponse> decodeDaqResolution(Octets packet, ByteOrder order);

struct DaqEventResponse {
    std::uint8_t properties = 0;
    std::uint8_t maxLists = 0;
    std::uint8_t nameLength = 0;
    double cycle_s = 0.0; ///< 0 = sporadic
};
Result<DaqEventResponse> decodeDaqEvent(Octets packet);

/// Ticks of the board's clock now (GET_DAQ_CLOCK).
Result<std::uint32_t> decodeDaqClock(Octets packet, ByteOrder order);

/// Seconds of a time stamp or event cycle unit: 0 = 1 ns, 1 = 10 ns ... 9 = 1 s (3.9).
Result<double> unitSeconds(std::uint8_t code);

} // namespace halbench::devices::xcp
