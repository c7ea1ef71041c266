#pragma once

#include "devices/xcp/a2l.h"
#include "devices/xcp/xcp_master.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace halbench::devices::xcp {

/// New octets at a place of a segment.
struct SegmentChange {
    std::uint32_t offset = 0; ///< from the segment's start
    Packet octets;
};

/// Where the transaction marks of our boards lie in the segment (3.16).
struct TransactionMarks {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
};

/// The place of the first octet the board did not take as sent, for a message that names the parameter.
struct PageMismatch {
    std::uint32_t offset = 0;
};

/// Changes a set of values in one control cycle (resources/help/protocol.md 3.10): the idle page gets a copy
/// of the running one and the changes, is verified by checksum, and becomes the running one by one command.
/// On an error before that the running page is untouched. Errors: DeviceRefused (the board keeps other values
/// than sent; `mismatch` says where), DeviceLost, Protocol.
Result<void> switchPages(XcpMaster& master, XcpLink& link, const A2lSegment& segment,
                         const std::vector<SegmentChange>& changes,
                         const std::optional<TransactionMarks>& marks, std::optional<PageMismatch>& mismatch);

/// The running page as the one the master reads: after connecting and after every failed transaction.
Result<void> readRunningPage(XcpMaster& master, const A2lSegment& segment);

} // namespace halbench::devices::xcp
