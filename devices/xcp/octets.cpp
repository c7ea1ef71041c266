#include "devices/xcp/octets.h"

#include "control/base/assert.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace halbench::devices::xcp {

namespace {

struct TypeEntry {
    DataType type;
    const char* name;
    std::size_t size;
    bool isSigned;
    bool isFloat;
};

constexpr std::array Types = {
    TypeEntry{DataType::UByte, "UBYTE", 1, false, false},
    TypeEntry{DataType::SByte, "SBYTE", 1, true, false},
    TypeEntry{DataType::UWord, "UWORD", 2, false, false},
    TypeEntry{DataType::SWord, "SWORD", 2, true, false},
    TypeEntry{DataType::ULong, "ULONG", 4, false, false},
    TypeEntry{DataType::SLong, "SLONG", 4, true, false},
    TypeEntry{DataType::UInt64, "A_UINT64", 8, false, false},
    TypeEntry{DataType::Int64, "A_INT64", 8, true, false},
    TypeEntry{DataType::Float32, "FLOAT32_IEEE", 4, true, true},
    TypeEntry{DataType::Float64, "FLOAT64_IEEE", 8, true, true},
};

const TypeEntry& entryOf(DataType type) {
    return Types[static_cast<std::size_t>(type)];
}

std::uint64_t integerBits(double raw, const TypeEntry& entry) {
    if (std::isnan(raw)) {
        return 0;
    }
    const double rounded = std::nearbyint(raw);
    if (rounded <= lowestOf(entry.type)) {
        return entry.isSigned ? std::uint64_t{1} << (8 * entry.size - 1) : 0;
    }
    if (rounded >= highestOf(entry.type)) {
        const std::size_t bits = 8 * entry.size - (entry.isSigned ? 1 : 0);
        return bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    }
    return entry.isSigned ? static_cast<std::uint64_t>(static_cast<std::int64_t>(rounded))
                          : static_cast<std::uint64_t>(rounded);
}

} // namespace

std::uint64_t readUnsigned(Octets octets, ByteOrder order) {
    HB_ASSERT(!octets.empty() && octets.size() <= 8);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < octets.size(); ++i) {
        const std::size_t place = order == ByteOrder::BigEndian ? i : octets.size() - 1 - i;
        value = (value << 8) | octets[place];
    }
    return value;
}

void appendUnsigned(Packet& packet, std::uint64_t value, std::size_t size, ByteOrder order) {
    HB_ASSERT(size >= 1 && size <= 8);
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t place = order == ByteOrder::LittleEndian ? i : size - 1 - i;
        packet.push_back(static_cast<std::uint8_t>(value >> (8 * place)));
    }
}

std::size_t sizeOf(DataType type) {
    return entryOf(type).size;
}

std::optional<DataType> findDataType(const std::string& name) {
    for (const TypeEntry& entry : Types) {
        if (name == entry.name) {
            return entry.type;
        }
    }
    return std::nullopt;
}

bool isFloat(DataType type) {
    return entryOf(type).isFloat;
}

double lowestOf(DataType type) {
    const TypeEntry& entry = entryOf(type);
    if (entry.isFloat) {
        return -highestOf(type);
    }
    return entry.isSigned ? -std::ldexp(1.0, static_cast<int>(8 * entry.size - 1)) : 0.0;
}

double highestOf(DataType type) {
    const TypeEntry& entry = entryOf(type);
    if (entry.isFloat) {
        return type == DataType::Float32 ? static_cast<double>(std::numeric_limits<float>::max())
                                         : std::numeric_limits<double>::max();
    }
    return std::ldexp(1.0, static_cast<int>(8 * entry.size - (entry.isSigned ? 1 : 0))) - 1.0;
}

double decodeRaw(Octets octets, DataType type, ByteOrder order) {
    const TypeEntry& entry = entryOf(type);
    HB_ASSERT(octets.size() == entry.size);
    const std::uint64_t bits = readUnsigned(octets, order);
    if (type == DataType::Float32) {
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    }
    if (type == DataType::Float64) {
        return std::bit_cast<double>(bits);
    }
    if (!entry.isSigned) {
        return static_cast<double>(bits);
    }
    const unsigned shift = static_cast<unsigned>(64 - 8 * entry.size);
    return static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift);
}

void appendRaw(Packet& packet, double raw, DataType type, ByteOrder order) {
    const TypeEntry& entry = entryOf(type);
    std::uint64_t bits = 0;
    if (type == DataType::Float32) {
        const double limit = highestOf(type);
        bits = std::bit_cast<std::uint32_t>(static_cast<float>(std::clamp(raw, -limit, limit)));
    } else if (type == DataType::Float64) {
        bits = std::bit_cast<std::uint64_t>(raw);
    } else {
        bits = integerBits(raw, entry);
    }
    appendUnsigned(packet, bits, entry.size, order);
}

std::uint16_t crc16(Octets octets) {
    std::uint32_t crc = 0xFFFF;
    for (const std::uint8_t octet : octets) {
        crc ^= static_cast<std::uint32_t>(octet) << 8;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & 0x8000U) != 0 ? (crc << 1) ^ 0x1021U : crc << 1;
        }
        crc &= 0xFFFFU;
    }
    return static_cast<std::uint16_t>(crc);
}

std::string hexText(Octets octets, std::size_t limit) {
    std::string text;
    for (std::size_t i = 0; i < std::min(octets.size(), limit); ++i) {
        text += fmt::format("{}{:02X}", i == 0 ? "" : " ", octets[i]);
    }
    return octets.size() > limit ? text + " ..." : text;
}

} // namespace halbench::devices::xcp
