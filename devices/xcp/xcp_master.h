#pragma once

#include "devices/xcp/daq_list.h"
#include "devices/xcp/packets.h"
#include "devices/xcp/xcp_link.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halbench::devices::xcp {

/// What the board can sample, as it says itself (never as its description says, 3.8).
struct DaqAbility {
    DaqFormat format;
    bool hasPrescaler = false;
    bool hasTimestamp = false;
    double tick_s = 0.0;
    double ticksPerSecond = 0.0;       ///< 0 when not a whole number
    std::vector<double> eventCycles_s; ///< by event number; 0 = sporadic; empty when the board does not say
};

/// The commands of the protocol as functions: each is sent, repeated and recovered as 3.6 says, and leaves
/// the board in one defined state or the link lost. Thread: the connection's.
class XcpMaster {
public:
    explicit XcpMaster(XcpLink& link) : m_link(&link) {}

    /// CONNECT every 300 ms until the board answers or the patience ends. Errors: DeviceLost, Protocol.
    Result<void> connect(double patience_s);
    void disconnect() noexcept;
    const ConnectResponse& session() const { return m_session; }

    Result<StatusResponse> status();
    /// Identity texts: name, EPK. Empty when the board has none.
    Result<std::string> identity(IdType type);
    /// A description of this many octets that need not be read; nothing when it must be.
    using KnownDescription = std::function<std::optional<std::string>(std::size_t octets)>;
    /// The whole description (GET_ID 4, and UPLOAD unless it is known, 3.7).
    Result<std::string> description(const KnownDescription& known);

    Result<Packet> read(Address address, std::size_t size);
    Result<void> write(Address address, Octets data);
    enum class Repetition {
        Known, ///< the board does nothing when it gets the same again
        Unknown
    };
    /// A write that is an act. Sent again only where that cannot act twice, and never after a stop. Gives
    /// the trouble after which nobody knows whether it was taken; the link is in step then.
    Result<std::optional<Error>> writeOnce(Address address, Octets data, Repetition repetition);
    /// True when one command can carry this many octets, so that they change together.
    bool fitsOneDownload(std::size_t size) const;
    Result<void> writeInOneDownload(Address address, Octets data);

    Result<std::uint8_t> page(PageAccess access, std::uint8_t segment);
    Result<void> setPage(PageAccess access, std::uint8_t segment, std::uint8_t page);
    /// False while the control loop has not yet left the target page: the board protects it until then.
    Result<bool> copyPage(std::uint8_t segment, std::uint8_t from, std::uint8_t to);
    /// Nothing when the board cannot build checksums.
    Result<std::optional<ChecksumResponse>> checksum(Address address, std::uint32_t size);

    /// SET_REQUEST 0: store the active parameters; returns when the board's session status shows it done.
    Result<void> storeCalibration();
    Result<void> userCommand(std::uint8_t sub);
    /// Clears what has latched (3.11). Sent once: between a release whose answer was lost and its repetition
    /// a stop of somebody else or a fault may latch, which nobody has seen yet. Gives the trouble after which
    /// nobody knows whether it was taken; the link is in step then. Errors: Interrupted when a stop was sent
    /// meanwhile.
    Result<std::optional<Error>> releaseStop();

    /// Nothing when the board cannot sample.
    Result<std::optional<DaqAbility>> daqAbility();
    /// Ticks of the board's clock; nothing when it does not tell them.
    Result<std::optional<std::uint32_t>> clockTicks();
    struct ListRequest {
        const std::vector<DaqEntry>* entries = nullptr;
        const DaqPlan* plan = nullptr;
        std::uint16_t event = 0;
        std::uint8_t prescaler = 1;
        bool hasTimestamp = true;
    };
    /// Builds list 0; gives its first PID. Nothing is sampled yet.
    Result<std::uint8_t> configureList(const ListRequest& request);
    Result<void> startList();
    Result<void> stopLists();

private:
    template <typename Decoder>
    auto query(const Packet& command, Decoder decode);
    Reply<ConnectResponse> connectOnce();
    Result<void> order(const Packet& command);
    Reply<Packet> exchangeSized(const Packet& command, std::size_t size);
    Reply<void> moveTo(Address address);
    Reply<Packet> uploadHere(std::size_t size);
    Result<Packet> shortUpload(Address address, std::size_t size);
    Result<std::string> uploadDescription(std::size_t length);
    Result<bool> deliversAt(const std::string& text);
    Reply<std::string> identityOnce(IdType type);
    Reply<void> downloadAt(Address address, Octets data);
    Reply<void> tryWrite(Address address, Octets data);
    Reply<void> allocateList(const DaqPlan& plan);
    Reply<void> writeEntry(const DaqEntry& entry, std::uint8_t odt, std::uint8_t place);
    Result<void> readEventCycles(std::uint16_t count, DaqAbility& ability);

    XcpLink* m_link;
    CommandEncoder m_encoder;
    ConnectResponse m_session;
    bool m_hasConnected = false;  ///< a session was begun and is to be ended
    std::optional<Address> m_mta; ///< where the board's transfer pointer stands, when known
    std::optional<std::pair<std::uint8_t, std::uint8_t>> m_daqPtr; ///< ODT and entry, likewise
    bool m_hasShortDownload = true;
};

} // namespace halbench::devices::xcp
