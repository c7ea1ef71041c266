#include "devices/xcp/a2l_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::devices::xcp {

namespace {

constexpr std::size_t MaxWarnings = 100;

/// Keeps the objects that `isUsable(index)` accepts, in their order, and the first of each name.
template <typename Object, typename Predicate>
void keepUsable(std::vector<Object>& objects, Predicate isUsable) {
    std::vector<Object> kept;
    std::map<std::string, bool> seen;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (!seen[objects[i].name] && isUsable(i)) {
            seen[objects[i].name] = true;
            kept.push_back(std::move(objects[i]));
        }
    }
    objects = std::move(kept);
}

} // namespace

bool A2lSegment::contains(Address where, std::size_t octets) const {
    return where.extension == address.extension && where.offset >= address.offset &&
           std::uint64_t{where.offset} + octets <= std::uint64_t{address.offset} + size;
}

bool A2lSegment::hasTwoWritablePages() const {
    const auto isWritable = [this](std::uint8_t wanted) {
        return std::any_of(pages.begin(), pages.end(), [wanted](const A2lPage& page) {
            return page.number == wanted && page.isWritable;
        });
    };
    return isWritable(0) && isWritable(1);
}

void A2lParser::resolve() {
    keepUsable(m_description.measurements, [this](std::size_t i) {
        return resolveObject(m_description.measurements[i], m_pendingMeasurements[i]);
    });
    keepUsable(m_description.characteristics, [this](std::size_t i) {
        return resolveObject(m_description.characteristics[i], m_pendingCharacteristics[i]);
    });
}

bool A2lParser::resolveObject(A2lObject& object, const Pending& pending) {
    std::optional<DataType> type = findDataType(pending.layout);
    if (!type) {
        const auto layout = m_layouts.find(pending.layout);
        if (layout == m_layouts.end()) {
            warn(object, fmt::format("its type '{}' is unknown", pending.layout));
            return false;
        }
        type = layout->second;
    }
    object.type = *type;
    if (!resolveConversion(object, pending)) {
        return false;
    }
    if (!pending.unit.empty()) {
        object.conversion.unit = pending.unit;
    }
    resolveLimits(object);
    return true;
}

bool A2lParser::resolveConversion(A2lObject& object, const Pending& pending) {
    if (pending.conversion == "NO_COMPU_METHOD") {
        return true;
    }
    const auto found = m_conversions.find(pending.conversion);
    if (found == m_conversions.end() || !found->second.isUsable) {
        warn(object, fmt::format("its conversion '{}' is {}", pending.conversion,
                                 found == m_conversions.end() ? "missing" : "not of a supported kind"));
        return false;
    }
    object.conversion = found->second.conversion;
    if (const auto words = m_wordTables.find(found->second.wordTable); words != m_wordTables.end()) {
        object.conversion.words = words->second;
    }
    return true;
}

void A2lParser::resolveLimits(A2lObject& object) {
    double lowest = object.conversion.toPhysical(lowestOf(object.type));
    double highest = object.conversion.toPhysical(highestOf(object.type));
    if (lowest > highest) {
        std::swap(lowest, highest);
    }
    if (object.lower > object.upper) {
        warn(object, "its lower limit is above the upper one; the type's limits are used");
        object.lower = lowest;
        object.upper = highest;
    }
    // Real files print limits with six digits, slightly outside the type (3.13).
    object.lower = std::clamp(object.lower, lowest, highest);
    object.upper = std::clamp(object.upper, lowest, highest);
}

void A2lParser::warn(const A2lObject& object, const std::string& what) {
    if (m_description.warnings.size() < MaxWarnings) {
        m_description.warnings.push_back(
            fmt::format("'{}' (byte {} of the description): {}", object.name, object.place, what));
    }
}

} // namespace halbench::devices::xcp
