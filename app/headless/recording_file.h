#pragma once

#include "app/procedures/record/record_procedure.h"
#include "devices/recording/recording_writer.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace halbench::app {

/// Remarks in the sidecar of a recording, beside its device and signals.
struct RecordingNotes {
    std::string started; ///< the header's, so that virtual time gives equal bytes
    std::vector<devices::RecordingMeta::Marker> markers;
    /// At the start of the recording; empty: as they are now.
    std::vector<devices::RecordingMeta::ParameterNote> parameters;
    std::string automaticName = {}; ///< as devices::RecordingMeta
};

/// Where the board's reference began a step or plateau, or ended: markers of a recording that has the signal
/// reference.segment.
std::vector<devices::RecordingMeta::Marker> segmentMarkers(const Recording& recording);

/// Writes a recording as CSV with its sidecar NAME.meta.json (resources/help/command-line.md, "Recording"),
/// its reference's segments as markers beside those given. Error: FileSystem.
Result<void> writeRecording(const std::string& path, const Recording& recording, devices::Device& device,
                            RecordingNotes notes);

/// Receives a warning for people, a sentence without its end.
using WarningSink = std::function<void(const std::string& text)>;

/// A recording that goes into its file as it comes (resources/help/command-line.md, "Recording").
/// Thread: the procedure's.
class RecordingOutput {
public:
    RecordingOutput(devices::Device& device, std::string path, std::string started, WarningSink warn)
        : m_device(device), m_path(std::move(path)), m_started(std::move(started)), m_warn(std::move(warn)) {}

    /// For runRecord(); this object must outlive it. Errors: FileSystem, Usage.
    RecordOutlet outlet();
    /// As devices::RecordingMeta; before it begins.
    void setAutomaticName(const std::string& name) { m_automaticName = name; }
    /// For the sidecar; time of the recording.
    void addMarker(double time_s, const std::string& text);
    /// Gives the file its name. Error: FileSystem; see stopped().
    Result<void> finish();
    /// The error that ended the recording, with the place of what was recorded until then.
    Error stopped(Error error);

private:
    Result<void> begin(const StreamLayout& layout);

    devices::Device& m_device;
    std::string m_path;
    std::string m_started;
    std::string m_automaticName;
    WarningSink m_warn;
    std::unique_ptr<devices::RecordingWriter> m_writer;
};

} // namespace halbench::app
