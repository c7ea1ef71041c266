#pragma once

#include "devices/device.h"

#include <map>
#include <string>
#include <vector>

namespace halbench::devices {

/// Sidecar NAME.meta.json of a recording NAME.csv.
struct RecordingMeta {
    struct SignalNote {
        std::string name;   ///< "hall.a"
        std::string column; ///< "hall_a_T"
        std::string unit;
        std::string role;
        std::string expression = {}; ///< of a signal that was derived
    };
    struct ParameterNote {
        std::string name;
        double value = 0.0;
        std::string unit;
    };
    struct ParameterChange {
        double time_s = 0.0;
        std::string name;
        double value = 0.0;
    };
    struct Marker {
        double time_s = 0.0;
        std::string text;
    };
    struct Gap {
        double time_s = 0.0; ///< first row after the gap
        std::uint64_t lostRows = 0;
    };

    DeviceInfo device;
    std::string started; ///< ISO 8601, UTC; virtual time begins at 1970-01-01T00:00:00Z
    std::string software;
    std::vector<SignalNote> signals;
    std::vector<ParameterNote> parameters; ///< at the start
    std::vector<ParameterChange> changes;
    std::vector<Marker> markers;
    std::vector<Gap> gaps;
    std::vector<RateChange> rates; ///< where the distance of rows changes; empty: period_s throughout
    std::uint64_t rows = 0;
    std::uint64_t droppedRows = 0; ///< of the stream, because the disk did not keep up
    std::vector<std::string> tags; ///< the user's words, to find it again
    std::string notes;             ///< the user's
    /// Without folder and ending, as long as nobody but the program named it: a renamed file has another.
    std::string automaticName;
    double period_s = 0.0;
    std::string sha256; ///< of the CSV file
};

/// What is to be said of a recording whose device had a description of another firmware
/// (DeviceInfo::otherFirmware).
std::string otherFirmwareWarning(const DeviceInfo& device);
inline constexpr const char* OtherFirmwareHint = "record again with the description of this firmware";
/// What a warning of the reader is about.
bool isFirmwareWarning(const std::string& warning);

/// All parameters as they are now; none when the device is lost.
std::vector<RecordingMeta::ParameterNote> parameterNotes(Device& device);

/// Device, signals of the layout and the parameters as they are now; without parameters when the device is
/// lost.
RecordingMeta describeRecording(Device& device, const StreamLayout& layout, const std::string& started);

/// Names the columns of the signals as a file of `layout` does, where they are the same signals.
void nameColumnsOf(const StreamLayout& layout, RecordingMeta& meta);

/// JSON text with sorted keys, so that equal recordings give equal bytes; schema "halbench.recording-meta/1".
std::string toMetaJson(const RecordingMeta& meta);
/// Errors: InvalidInput with the place.
Result<RecordingMeta> parseMetaJson(const std::string& text, const std::string& origin);

/// "dir/run.csv" -> "dir/run.meta.json"
std::string metaPathOf(const std::string& csvPath);

} // namespace halbench::devices
