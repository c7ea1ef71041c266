#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace halbench::devices::xcp {

enum class ByteOrder { LittleEndian, BigEndian };

using Octets = std::span<const std::uint8_t>;
using Packet = std::vector<std::uint8_t>;

/// Unsigned number of `octets.size()` (1..8) octets. resources/help/protocol.md 3.1.
std::uint64_t readUnsigned(Octets octets, ByteOrder order);
/// Appends the low `size` octets of a number.
void appendUnsigned(Packet& packet, std::uint64_t value, std::size_t size, ByteOrder order);

/// The types a board may keep a value in; names as in the description file (3.13).
enum class DataType { UByte, SByte, UWord, SWord, ULong, SLong, UInt64, Int64, Float32, Float64 };

std::size_t sizeOf(DataType type);
std::optional<DataType> findDataType(const std::string& name);
bool isFloat(DataType type);
/// Smallest and largest raw value (of the float types: the largest finite number).
double lowestOf(DataType type);
double highestOf(DataType type);

/// The raw number in `octets`, whose size must be sizeOf(type).
double decodeRaw(Octets octets, DataType type, ByteOrder order);
/// Appends a raw number; integers are rounded to nearest and kept inside the type.
void appendRaw(Packet& packet, double raw, DataType type, ByteOrder order);

/// CRC16-CITT of BUILD_CHECKSUM type 8 (3.5): polynomial 1021, start FFFF, no reflection, no final xor.
std::uint16_t crc16(Octets octets);

/// "F5 06", at most `limit` octets, for messages.
std::string hexText(Octets octets, std::size_t limit = 8);

} // namespace halbench::devices::xcp
