#include "app/headless/recording_file.h"

#include <fmt/format.h>

namespace halbench::app {

std::vector<devices::RecordingMeta::Marker> segmentMarkers(const Recording& recording) {
    const std::vector<double> segments = recording.column("reference.segment");
    std::vector<devices::RecordingMeta::Marker> markers;
    double before = 0.0;
    for (std::size_t row = 0; row < segments.size(); ++row) {
        if (segments[row] != before) {
            markers.push_back({recording.time_s[row], segments[row] > 0.0
                                                          ? fmt::format("reference segment {}", segments[row])
                                                          : std::string("reference ends")});
        }
        before = segments[row];
    }
    return markers;
}

Result<void> writeRecording(const std::string& path, const Recording& recording, devices::Device& device,
                            RecordingNotes notes) {
    Recording written = recording;
    if (!written.layout) { // a stream that ended before its first row
        written.layout = std::make_shared<const StreamLayout>();
    }
    devices::RecordingMeta meta = devices::describeRecording(device, *written.layout, notes.started);
    meta.markers = segmentMarkers(written);
    meta.markers.insert(meta.markers.end(), notes.markers.begin(), notes.markers.end());
    if (!notes.parameters.empty()) {
        meta.parameters = std::move(notes.parameters);
    }
    meta.automaticName = std::move(notes.automaticName);
    return devices::writeRecordingFile(path, written, std::move(meta));
}

RecordOutlet RecordingOutput::outlet() {
    return {[this](const StreamLayout& layout) { return begin(layout); },
            [this](const SampleBlock& block) { return m_writer->append(block); }};
}

Result<void> RecordingOutput::begin(const StreamLayout& layout) {
    devices::WriterOptions options;
    options.flushInterval_s = devices::FlushInterval_s;
    devices::RecordingMeta meta = devices::describeRecording(m_device, layout, m_started);
    meta.automaticName = m_automaticName;
    auto writer = devices::RecordingWriter::create(m_path, layout, std::move(meta), std::move(options));
    if (!writer) {
        return failure(writer.error());
    }
    m_writer = *std::move(writer);
    if (!m_writer->movedAside().empty()) {
        m_warn(fmt::format(
            "interrupted recording found, saved as '{}'; halbench convert makes a recording of it",
            m_writer->movedAside()));
    }
    return {};
}

void RecordingOutput::addMarker(double time_s, const std::string& text) {
    if (m_writer) {
        m_writer->addMarker(time_s, text);
    }
}

Result<void> RecordingOutput::finish() {
    return m_writer->finish();
}

Error RecordingOutput::stopped(Error error) {
    if (m_writer != nullptr && m_writer->abandon()) {
        error.hint += fmt::format("{}what was recorded is in '{}', halbench convert makes a recording of it",
                                  error.hint.empty() ? "" : "; ", m_writer->partialPath());
    }
    m_writer.reset();
    return error;
}

} // namespace halbench::app
