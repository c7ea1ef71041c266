#pragma once

#include "control/base/page_store.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace halbench::devices {

// How a part of a page lies in its file: its checksum, then its octets.

inline constexpr std::size_t PartSumBytes = sizeof(std::uint64_t);

/// Of octets that come back from a disk: finds what is damaged, and what belongs to another page or part.
/// A multiplication for every eight octets; it need not withstand anybody's intent.
inline std::uint64_t partSum(std::span<const std::byte> octets, PageStore::Page page, std::size_t part) {
    constexpr std::uint64_t Factor = 0x9E3779B97F4A7C15U;
    std::uint64_t sum = (page + 1) * Factor ^ (part + 1);
    const auto mix = [&sum](std::uint64_t word) {
        sum = (sum ^ word) * Factor;
        sum ^= sum >> 29U;
    };
    std::size_t place = 0;
    for (; place + sizeof(std::uint64_t) <= octets.size(); place += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, octets.data() + place, sizeof word);
        mix(word);
    }
    for (; place < octets.size(); ++place) {
        mix(static_cast<std::uint64_t>(octets[place]));
    }
    return sum;
}

} // namespace halbench::devices
