#pragma once

#include <QtCore/QtEndian>

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>

namespace halbench::devices::mdf4 {

// ASAM MDF 4.1 is made of blocks: id "##XX", 4 octets reserved, length and number of links as 64 bits, the
// links (offsets in the file, 0 = none), then the block's data; little endian, each begins at a multiple
// of 8.

constexpr std::size_t HeaderSize = 24; ///< before the links
constexpr std::size_t LinkSize = 8;
constexpr std::uint64_t IdentificationSize = 64; ///< the one block without header, at the file's begin
constexpr std::uint64_t HdOffset = IdentificationSize;
constexpr std::uint16_t Version = 410;
constexpr std::string_view FinalisedId = "MDF     ";
constexpr std::string_view UnfinalisedId = "UnFinMF ";
constexpr std::string_view VersionText = "4.10    ";
constexpr std::string_view Program = "Halbench";

/// Links and octets of data of each block that we write.
struct Shape {
    std::string_view id;
    std::size_t links;
    std::size_t data;
    constexpr std::size_t size() const { return HeaderSize + LinkSize * links + data; }
};
constexpr Shape Hd{"##HD", 6, 32};
constexpr Shape Fh{"##FH", 2, 16};
constexpr Shape Dg{"##DG", 4, 8};
constexpr Shape Cg{"##CG", 6, 32};
constexpr Shape Si{"##SI", 3, 8};
constexpr Shape Cn{"##CN", 8, 72};
constexpr Shape Ev{"##EV", 5, 32};
constexpr Shape Tx{"##TX", 0, 0};
constexpr Shape Md{"##MD", 0, 0};
constexpr Shape Dt{"##DT", 0, 0};

constexpr std::size_t CycleCount = 8; ///< where it is in the data of a CG
constexpr std::uint8_t Master = 2;    ///< channel type: the axis
constexpr std::uint8_t TimeAxis = 1;  ///< what a master or an event counts in: seconds
constexpr std::uint8_t Real = 4;      ///< data type: IEEE 754, little endian
constexpr std::uint8_t Marker = 6;    ///< event type

/// Numbers one behind the other, little endian.
template <typename Number>
void put(std::string& octets, Number value) {
    const Number little = qToLittleEndian(value);
    octets.append(reinterpret_cast<const char*>(&little), sizeof little);
}

/// The number at a place that must lie inside.
template <typename Number>
Number get(std::string_view octets, std::size_t place) {
    Number little;
    std::memcpy(&little, octets.data() + place, sizeof little);
    return qFromLittleEndian(little);
}

/// A whole block, filled up with zeros to a multiple of 8.
std::string makeBlock(std::string_view id, std::initializer_list<std::uint64_t> links, std::string_view data);

} // namespace halbench::devices::mdf4
