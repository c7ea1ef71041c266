#include "app/window/project/project_recording.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

double lengthOf(ProjectReader& reader, const ConfigNode& node, const std::string& key, double longest_s) {
    const double length_s = reader.number(node, key);
    if (!(length_s >= 0.0 && length_s <= longest_s)) {
        reader.refuse(node, fmt::format("'{}' of a recording is from 0 to {} s", key, longest_s));
        return 0.0;
    }
    return length_s;
}

} // namespace

toml::table projectRecording(const RecordingChoice& choice) {
    return toml::table{
        {"before_s", choice.before_s}, {"at_trigger", choice.isAtTrigger}, {"after_s", choice.after_s}};
}

void readRecording(ProjectReader& reader, const ConfigNode& node, RecordingChoice& choice) {
    if (node.kind != ConfigNode::Kind::Table) {
        reader.refuse(node, "'recording' must be a table");
    }
    for (const auto& [key, value] : node.members) {
        if (key == "before_s") {
            choice.before_s = lengthOf(reader, value, key, LongestBefore_s);
        } else if (key == "at_trigger") {
            choice.isAtTrigger = reader.flag(value, key);
        } else if (key == "after_s") {
            choice.after_s = lengthOf(reader, value, key, LongestAfter_s);
        } else {
            reader.refuse(
                value, fmt::format("unknown key '{}'; [recording] has before_s, at_trigger, after_s", key));
        }
    }
}

} // namespace halbench::app
