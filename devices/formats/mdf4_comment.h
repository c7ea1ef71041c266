#pragma once

#include "devices/recording/recording_meta.h"

#include <optional>
#include <string>
#include <string_view>

namespace halbench::devices::mdf4 {

// The comments of an MDF 4.10 file: XML in the standard's vocabulary, so that every tool shows them; what a
// recording's sidecar says goes into <common_properties> and comes back from there.

/// <HDcomment>: device, software, start, period, overrides and the parameters at the start.
std::string headerComment(const RecordingMeta& meta);
/// <FHcomment>: who wrote the file.
std::string historyComment();
/// <CNcomment>: the role, the signal's name when the channel had to be called otherwise, and the expression
/// of a derived signal.
std::string channelComment(const std::string& role, const std::string& signal,
                           const std::string& expression = {});
/// <EVcomment> of a change of a parameter.
std::string changeComment(const RecordingMeta::ParameterChange& change);

/// What the comments above said; other elements are passed over. Errors: InvalidInput, line and cause of XML
/// that does not parse or declares a document type.
Result<void> readHeaderComment(std::string_view xml, RecordingMeta& meta);
struct ChannelNote {
    std::string role;
    std::string signal; ///< empty: called as the channel
    std::string expression;
};
Result<ChannelNote> readChannelComment(std::string_view xml);
/// Name and value; nothing when the event is no change of a parameter.
Result<std::optional<RecordingMeta::ParameterChange>> readEventComment(std::string_view xml);

} // namespace halbench::devices::mdf4
