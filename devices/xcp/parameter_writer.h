#pragma once

#include "devices/device.h"
#include "devices/xcp/value_reader.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace halbench::devices::xcp {

/// Writes of parameters to a board: all at once where its pages can be switched, else by the best method that
/// it has (resources/help/protocol.md, 3.10), and read back. Nothing is written by the description of another
/// firmware. All that it is given outlives it. Thread: the connection's.
class ParameterWriter {
public:
    struct Options {
        const DeviceInfo* identity = nullptr; ///< tells whether the description is of another firmware
        bool useVendorBrackets = false;
        std::function<void(const std::string&)> onMessage; ///< never empty
    };

    ParameterWriter(XcpMaster& master, XcpLink& link, const BoardDescription& board, Options options);

    /// Errors: UnknownName, InvalidInput (outside its limits), DeviceRefused (read back another value; other
    /// firmware), Protocol (the start of a motion was not confirmed, and was ended), those of the link.
    Result<void> write(std::span<const ParameterValue> values);
    /// Stores the active parameters on the board.
    Result<void> save();
    /// DeviceRefused when the description is of another firmware: its names may lead anywhere.
    Result<void> checkFirmware() const;

private:
    /// A parameter to be written, in octets.
    struct RawChange {
        const A2lCharacteristic* target = nullptr;
        Packet octets;
        std::optional<XcpMaster::Repetition> command; ///< the write is an act
    };

    Result<std::vector<RawChange>> checkedChanges(std::span<const ParameterValue> values);
    double nextOrder();
    Result<void> writeSegment(const A2lSegment& segment, const std::vector<RawChange>& changes);
    Result<void> writePlain(const std::vector<RawChange>& changes);
    Result<bool> writeAdjacent(const std::vector<RawChange>& changes);
    Result<void> commandOnce(const RawChange& change);
    Result<void> writeOneByOne(const std::vector<RawChange>& changes);
    Result<void> readBack(const std::vector<RawChange>& changes) const;

    XcpMaster* m_master;
    XcpLink* m_link;
    const BoardDescription* m_board;
    ValueReader m_reader;
    Options m_options;
    double m_lastOrder = 1.0; ///< number of the last start sent to a board that knows repetitions by it
    bool m_hasWarnedOneByOne = false;
};

} // namespace halbench::devices::xcp
