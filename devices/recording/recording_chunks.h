#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::devices {

// Checksums of a recording that is being written: resources/help/command-line.md, "While it records". Pure
// functions of text.

/// CRC-32 of IEEE 802.3 (as in zip and PNG); `before`: of the octets that go ahead.
std::uint32_t crc32(std::string_view octets, std::uint32_t before = 0);

/// A stretch of the file that was on the disk when its checksum was noted; the first begins at its first
/// octet, each other where the one before ends. It ends with a whole line.
struct RecordingChunk {
    std::uint64_t octets = 0;
    std::uint32_t crc = 0;
    bool operator==(const RecordingChunk&) const = default;
};

/// "OCTETS CRC\n", the checksum with eight hexadecimal digits.
std::string chunkLine(const RecordingChunk& chunk);
/// All up to the first line that is not one, e.g. torn by a power loss.
std::vector<RecordingChunk> parseChunks(std::string_view text);

/// What the checksums say of a stretch of a file.
enum class PartState {
    Confirmed, ///< it is what was written
    Damaged,   ///< it is not
    Unchecked  ///< no checksum says; always the end of the file
};
struct CheckedPart {
    std::string_view text;
    PartState state = PartState::Unchecked;
    bool operator==(const CheckedPart&) const = default;
};
/// The file in pieces, in order, none of them empty. A chunk of which the file has only the beginning is not
/// damaged: what is there has no checksum.
std::vector<CheckedPart> checkChunks(std::string_view text, const std::vector<RecordingChunk>& chunks);

} // namespace halbench::devices
