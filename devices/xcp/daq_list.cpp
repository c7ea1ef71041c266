#include "devices/xcp/daq_list.h"

#include "control/base/assert.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::devices::xcp {

namespace {

constexpr std::size_t MaxOdtEntries = 255;
constexpr std::size_t MaxOdts = 0xFC; // identifications FC..FF are taken by SERV, EV, ERR and RES
constexpr std::uint8_t OverloadBit = 0x80;

} // namespace

Result<DaqPlan> planDaqList(const std::vector<DaqEntry>& entries, const DaqFormat& format) {
    DaqPlan plan(1);
    const std::size_t room = format.maxDto - std::min<std::size_t>(sizeOf(format.idField), format.maxDto);
    std::size_t left = room - std::min(format.timestampSize, room);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::size_t size = sizeOf(entries[i].type);
        if (size > format.maxEntrySize || size % format.granularity != 0 || size > room) {
            return failure(
                ErrorCode::OutOfRange,
                fmt::format(
                    "signal {} has {} bytes; the device samples values of up to {} bytes in steps of {}",
                    i + 1, size, format.maxEntrySize, format.granularity),
                "leave this signal out");
        }
        if (size > left || plan.back().size() == MaxOdtEntries) {
            plan.emplace_back();
            left = room;
        }
        plan.back().push_back(i);
        left -= size;
    }
    const std::size_t maxOdts = format.marksOverloadInPid ? MaxOdts / 2 : MaxOdts;
    if (plan.size() > maxOdts) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} signals do not fit into one sample of this device", entries.size()),
                       "use fewer signals");
    }
    return plan;
}

DtoDecoder::DtoDecoder(DaqFormat format, std::vector<DaqEntry> entries, DaqPlan plan, std::uint16_t list,
                       std::uint8_t firstPid)
    : m_format(format), m_entries(std::move(entries)), m_plan(std::move(plan)), m_list(list),
      m_firstPid(firstPid), m_row(m_entries.size(), 0.0) {
    for (std::size_t odt = 0; odt < m_plan.size(); ++odt) {
        std::size_t octets = sizeOf(m_format.idField) + (odt == 0 ? m_format.timestampSize : 0);
        for (const std::size_t index : m_plan[odt]) {
            HB_ASSERT(index < m_entries.size());
            octets += sizeOf(m_entries[index].type);
        }
        m_odtOctets.push_back(octets);
    }
}

bool DtoDecoder::feed(Octets packet) {
    const std::optional<std::size_t> odt = odtOf(packet);
    if (!odt || packet.size() < m_odtOctets[*odt]) {
        ++m_foreign;
        return false;
    }
    if (*odt != m_nextOdt) {
        dropSample();
        if (*odt != 0) {
            return false;
        }
    }
    return decodeOdt(*odt, packet);
}

std::optional<std::size_t> DtoDecoder::odtOf(Octets packet) const {
    if (packet.size() < sizeOf(m_format.idField)) {
        return std::nullopt;
    }
    const std::uint8_t first =
        m_format.marksOverloadInPid ? static_cast<std::uint8_t>(packet[0] & ~OverloadBit) : packet[0];
    std::uint64_t list = m_list;
    std::size_t odt = first;
    switch (m_format.idField) {
    case IdField::Absolute:
        odt = static_cast<std::uint8_t>(first - m_firstPid);
        break;
    case IdField::RelativeByte:
        list = packet[1];
        break;
    case IdField::RelativeWord:
        list = readUnsigned(packet.subspan(1, 2), m_format.order);
        break;
    case IdField::RelativeWordAligned:
        list = readUnsigned(packet.subspan(2, 2), m_format.order);
        break;
    }
    if (list != m_list || odt >= m_plan.size()) {
        return std::nullopt;
    }
    return odt;
}

bool DtoDecoder::decodeOdt(std::size_t odt, Octets packet) {
    std::size_t place = sizeOf(m_format.idField);
    if (odt == 0 && m_format.timestampSize != 0) {
        m_timestamp = readUnsigned(packet.subspan(place, m_format.timestampSize), m_format.order);
        place += m_format.timestampSize;
    }
    for (const std::size_t index : m_plan[odt]) {
        const DaqEntry& entry = m_entries[index];
        const std::size_t size = sizeOf(entry.type);
        double raw = decodeRaw(packet.subspan(place, size), entry.type, m_format.order);
        if (entry.bitMask != ~std::uint64_t{0} && !isFloat(entry.type)) {
            raw = static_cast<double>(readUnsigned(packet.subspan(place, size), m_format.order) &
                                      entry.bitMask);
        }
        m_row[index] = entry.factor * raw + entry.offset;
        place += size;
    }
    m_nextOdt = odt + 1 == m_plan.size() ? 0 : odt + 1;
    return m_nextOdt == 0;
}

void DtoDecoder::dropSample() {
    if (m_nextOdt != 0) {
        ++m_incomplete;
    }
    m_nextOdt = 0;
}

TickUnwrapper::TickUnwrapper(std::size_t timestampSize, double tick_s)
    : m_modulus(std::ldexp(1.0, static_cast<int>(8 * timestampSize))),
      m_mask((std::uint64_t{1} << (8 * timestampSize)) - 1), m_tick_s(tick_s) {
    HB_ASSERT(timestampSize >= 1 && timestampSize <= 4);
    HB_ASSERT(tick_s > 0.0);
}

std::int64_t TickUnwrapper::unwrap(std::uint64_t stamp, double arrival_s) {
    if (m_hasLast) {
        const std::uint64_t difference = (stamp - m_last) & m_mask;
        const double expected = (arrival_s - m_lastArrival_s) / m_tick_s;
        const double turns = std::round((expected - static_cast<double>(difference)) / m_modulus);
        m_total += static_cast<std::int64_t>(difference) +
                   static_cast<std::int64_t>(std::clamp(turns, -1.0, 1e6) * m_modulus);
    }
    m_hasLast = true;
    m_last = stamp;
    m_lastArrival_s = arrival_s;
    return m_total;
}

} // namespace halbench::devices::xcp
