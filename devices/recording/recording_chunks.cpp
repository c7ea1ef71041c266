#include "devices/recording/recording_chunks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace halbench::devices {

namespace {

constexpr std::array<std::uint32_t, 256> makeTable() {
    constexpr std::uint32_t Reflected = 0xEDB88320U; // of the polynomial 04C11DB7
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t octet = 0; octet < table.size(); ++octet) {
        std::uint32_t value = octet;
        for (int bit = 0; bit < 8; ++bit) {
            value = (value >> 1U) ^ ((value & 1U) != 0 ? Reflected : 0U);
        }
        table[octet] = value;
    }
    return table;
}

constexpr std::array<std::uint32_t, 256> Table = makeTable();

bool parseChunk(std::string_view line, RecordingChunk& chunk) {
    const std::size_t blank = line.find(' ');
    if (blank == std::string_view::npos || line.size() != blank + 9) {
        return false;
    }
    const char* const end = line.data() + line.size();
    const auto octets = std::from_chars(line.data(), line.data() + blank, chunk.octets);
    const auto crc = std::from_chars(line.data() + blank + 1, end, chunk.crc, 16);
    return octets.ec == std::errc{} && octets.ptr == line.data() + blank && chunk.octets > 0 &&
           crc.ec == std::errc{} && crc.ptr == end;
}

} // namespace

std::uint32_t crc32(std::string_view octets, std::uint32_t before) {
    constexpr std::uint32_t All = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t value = before ^ All;
    for (const char octet : octets) {
        value = (value >> 8U) ^ Table[(value ^ static_cast<unsigned char>(octet)) & 0xFFU];
    }
    return value ^ All;
}

std::string chunkLine(const RecordingChunk& chunk) {
    return fmt::format("{} {:08x}\n", chunk.octets, chunk.crc);
}

std::vector<RecordingChunk> parseChunks(std::string_view text) {
    std::vector<RecordingChunk> chunks;
    for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
        RecordingChunk chunk;
        if (!parseChunk(text.substr(0, end), chunk)) {
            break;
        }
        chunks.push_back(chunk);
        text.remove_prefix(end + 1);
    }
    return chunks;
}

std::vector<CheckedPart> checkChunks(std::string_view text, const std::vector<RecordingChunk>& chunks) {
    std::vector<CheckedPart> parts;
    for (const RecordingChunk& chunk : chunks) {
        if (text.size() < chunk.octets) {
            break;
        }
        const std::string_view part = text.substr(0, chunk.octets);
        parts.push_back({part, crc32(part) == chunk.crc ? PartState::Confirmed : PartState::Damaged});
        text.remove_prefix(part.size());
    }
    if (!text.empty()) {
        parts.push_back({text, PartState::Unchecked});
    }
    return parts;
}

} // namespace halbench::devices
