#pragma once

#include "control/base/result.h"
#include "devices/xcp/octets.h"
#include "devices/xcp/packets.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::devices::xcp {

// What a board's description says, of the subset of A2L in resources/help/protocol.md 3.13.

/// phys = factor * raw + offset, or words for raw values.
struct A2lConversion {
    double factor = 1.0;
    double offset = 0.0;
    std::string unit;
    std::map<std::int64_t, std::string> words;

    double toPhysical(double raw) const { return factor * raw + offset; }
    double toRaw(double physical) const { return (physical - offset) / factor; }
};

/// What measurements and characteristics have in common.
struct A2lObject {
    std::string name;
    std::string help;
    Address address;
    DataType type = DataType::UByte;
    A2lConversion conversion;
    double lower = 0.0; ///< physical, inside what the type can hold
    double upper = 0.0;
    std::size_t count = 1; ///< elements of an array, 1 for a single value
    std::size_t place = 0; ///< octet where it is defined
};

struct A2lMeasurement : A2lObject {
    std::uint64_t bitMask = ~std::uint64_t{0};
    std::vector<std::uint16_t> events; ///< events it can be sampled on; empty = any
};

enum class A2lCharacteristicKind { Value, Ascii, ValueBlock };

struct A2lCharacteristic : A2lObject {
    A2lCharacteristicKind kind = A2lCharacteristicKind::Value;
    bool isReadOnly = false;
};

struct A2lGroup {
    std::string name;
    std::string title;
    bool isRoot = false;
    std::vector<std::string> members; ///< measurements and characteristics
};

struct A2lPage {
    std::uint8_t number = 0;
    bool isWritable = false;
};

struct A2lSegment {
    std::string name;
    Address address;
    std::uint32_t size = 0;
    std::uint8_t number = 0;
    std::vector<A2lPage> pages;

    bool contains(Address where, std::size_t octets) const;
    /// Pages 0 and 1 exist and both take writes: sets can be switched atomically (3.10).
    bool hasTwoWritablePages() const;
};

struct A2lEvent {
    std::string name;
    std::uint16_t number = 0;
    double cycle_s = 0.0; ///< 0 = sporadic
};

struct A2lDescription {
    std::string project;
    std::string module;
    std::optional<ByteOrder> order;
    std::string epk;
    std::optional<std::uint32_t> epkAddress; ///< where the board keeps its EPK (ADDR_EPK)
    std::optional<double> answerTimeout_s;   ///< T1 of the protocol layer
    std::vector<A2lMeasurement> measurements;
    std::vector<A2lCharacteristic> characteristics;
    std::vector<A2lGroup> groups;
    std::vector<A2lSegment> segments;
    std::vector<A2lEvent> events;
    std::vector<std::string> warnings; ///< objects left out, limits corrected
};

inline constexpr std::size_t MaxA2lSize = std::size_t{8} << 20;
inline constexpr int MaxA2lNesting = 64;

/// Reads a description. Unknown blocks and keywords are skipped; an object that cannot be used is left out
/// with a warning. Linear in the size. Errors: InvalidInput with the position in octets.
Result<A2lDescription> parseA2l(std::string_view text);

} // namespace halbench::devices::xcp
