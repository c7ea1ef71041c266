#pragma once

#include "control/base/result.h"
#include "devices/xcp/octets.h"
#include "devices/xcp/packets.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace halbench::devices::xcp {

/// One value in a sample: where it lives on the board and what its raw number means.
struct DaqEntry {
    Address address;
    DataType type = DataType::UByte;
    std::uint64_t bitMask = ~std::uint64_t{0};
    double factor = 1.0; ///< phys = factor * raw + offset
    double offset = 0.0;
};

/// What the board said about its samples (3.8, 3.9).
struct DaqFormat {
    IdField idField = IdField::Absolute;
    ByteOrder order = ByteOrder::LittleEndian;
    std::size_t timestampSize = 0;
    bool marksOverloadInPid = false;
    std::uint16_t maxDto = 8;
    std::uint8_t maxEntrySize = 1;
    std::uint8_t granularity = 1;
};

/// The entries of each ODT of one list, by index into the entries asked for.
using DaqPlan = std::vector<std::vector<std::size_t>>;

/// First fit in table order (3.8). Errors: OutOfRange when a value or the list is larger than the board
/// takes.
Result<DaqPlan> planDaqList(const std::vector<DaqEntry>& entries, const DaqFormat& format);

/// Puts the packets of one list together to samples. Packets of other lists, other identification and of
/// incomplete samples are dropped and counted, never shown.
class DtoDecoder {
public:
    DtoDecoder(DaqFormat format, std::vector<DaqEntry> entries, DaqPlan plan, std::uint16_t list,
               std::uint8_t firstPid);

    /// True when this packet completed a sample: then timestamp() and row() hold it until the next call.
    bool feed(Octets packet);

    std::uint64_t timestamp() const { return m_timestamp; }
    const std::vector<double>& row() const { return m_row; }
    std::size_t packetsPerRow() const { return m_plan.size(); }
    std::uint64_t incompleteSamples() const { return m_incomplete; }
    std::uint64_t foreignPackets() const { return m_foreign; }

private:
    std::optional<std::size_t> odtOf(Octets packet) const;
    bool decodeOdt(std::size_t odt, Octets packet);
    void dropSample();

    DaqFormat m_format;
    std::vector<DaqEntry> m_entries;
    DaqPlan m_plan;
    std::vector<std::size_t> m_odtOctets;
    std::uint16_t m_list;
    std::uint8_t m_firstPid;
    std::size_t m_nextOdt = 0;
    std::uint64_t m_timestamp = 0;
    std::vector<double> m_row;
    std::uint64_t m_incomplete = 0;
    std::uint64_t m_foreign = 0;
};

/// Counts device ticks beyond the wrap of the time stamp (3.9): nearest difference, with the host's arrival
/// time telling whole turns lost in a pause.
class TickUnwrapper {
public:
    TickUnwrapper(std::size_t timestampSize, double tick_s);

    /// Ticks since the first stamp; smaller than the last when the board's clock stepped back.
    std::int64_t unwrap(std::uint64_t stamp, double arrival_s);

private:
    double m_modulus;
    std::uint64_t m_mask;
    double m_tick_s;
    bool m_hasLast = false;
    std::uint64_t m_last = 0;
    double m_lastArrival_s = 0.0;
    std::int64_t m_total = 0;
};

} // namespace halbench::devices::xcp
