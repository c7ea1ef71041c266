#pragma once

#include "devices/xcp/board_description.h"
#include "devices/xcp/xcp_device.h"
#include "devices/xcp/xcp_master.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices::xcp {

/// The connection of a board: session, identity, description, active pages and the values that it has
/// (resources/help/protocol.md, 3.5 to 3.7 and 3.10). The options are completed by what the board says of
/// itself: identity and profile. All that it is given outlives it. Thread: the connection's.
class BoardOpener {
public:
    /// `options.onMessage` is never empty.
    BoardOpener(XcpMaster& master, XcpLink& link, XcpDeviceOptions& options)
        : m_master(&master), m_link(&link), m_options(&options) {}

    /// Errors: DeviceLost (no answer), Protocol (answers that make no sense), InvalidInput (description).
    Result<void> open(BoardDescription& board, std::optional<DaqAbility>& ability);

private:
    Result<void> connect();
    Result<void> readIdentity();
    Result<A2lDescription> readDescription();
    Result<A2lDescription> givenOrUploaded();
    Result<A2lDescription> cachedOrUploaded();
    Result<void> compareFirmware(const A2lDescription& description);
    Result<void> findFirmware(const A2lDescription& description);
    Result<void> readLongerFirmware(std::uint32_t address);
    Result<void> findModelProfile();
    Result<void> choosePages(BoardDescription& board);
    Result<void> readDefaults(BoardDescription& board);
    Result<void> readWhatCanBeRead(BoardDescription& board, const std::vector<std::string>& names);

    XcpMaster* m_master;
    XcpLink* m_link;
    XcpDeviceOptions* m_options;
};

} // namespace halbench::devices::xcp
