#include "devices/formats/replay_device.h"

#include "devices/formats/recording_file.h"
#include "devices/profile.h"
#include "devices/recording/file_access.h"

#include <QtCore/QFileInfo>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace halbench::devices {

namespace {

constexpr double Rounding_s = 1e-9;
constexpr double BlockDuration_s = 0.010;

tl::unexpected<Error> readOnly() {
    return failure(ErrorCode::DeviceRefused, "this is a recording: it cannot be changed, armed or stopped",
                   "connect a real or simulated device");
}

class ReplayDevice final : public Device, private Clock {
public:
    ReplayDevice(const std::string& uri, const std::string& path, RecordedFile file, double begin_s)
        : m_hold(path), m_whole(std::make_shared<const RecordedFile>(std::move(file))), m_file(*m_whole),
          m_now_s(begin_s) {
        m_info = m_file.meta.device;
        m_info.uri = uri;
        m_info.transport = "replay";
        describe();
    }

    const DeviceInfo& info() const override { return m_info; }
    const Catalogue& catalogue() const override { return m_catalogue; }
    Clock& clock() override { return *this; }
    DeviceState state() const override { return {true, false, false, 0, {}}; }
    LinkStatistics statistics() const override { return {}; }

    Result<std::vector<double>> readParameters(std::span<const std::string> names) override;
    Result<std::vector<double>> readSignals(std::span<const std::string> names) override;
    Result<void> writeParameters(std::span<const ParameterValue>) override { return readOnly(); }
    Result<void> saveParameters() override { return readOnly(); }
    Result<void> startStream(const StreamRequest& request, BlockSink sink) override;
    void stopStream() noexcept override { m_sink = nullptr; }
    Result<void> arm() override { return readOnly(); }
    Result<void> disarm() override { return {}; }
    void stop() noexcept override {}
    Result<void> clearStop() override { return {}; }
    Result<Recording> readCapture() override { return Recording{}; }
    const std::shared_ptr<const RecordedFile>& whole() const { return m_whole; }

private:
    double now_s() const override { return m_now_s; }
    Result<void> waitFor(double duration_s) override;

    const Recording& data() const { return m_file.recording; }
    double timeOf(std::size_t row) const { return data().time_s[row] - data().time_s.front(); }
    void describe();
    void deliverUntil(double time_s);
    bool takeRow(SampleBlock& block, std::size_t row);
    /// Places of the signals in the recording. Error: UnknownName.
    Result<std::vector<std::size_t>> columnsOf(std::span<const std::string> names) const;

    FileHold m_hold;
    std::shared_ptr<const RecordedFile> m_whole;
    const RecordedFile& m_file; ///< the same
    DeviceInfo m_info;
    Catalogue m_catalogue;
    double m_now_s;
    BlockSink m_sink;
    std::shared_ptr<const StreamLayout> m_layout;
    std::vector<std::size_t> m_columns;
    std::size_t m_nextRow = 0;
    double m_streamStart_s = 0.0;
    std::int64_t m_divider = 1;   ///< recorded rows per row of the stream
    std::int64_t m_nextIndex = 0; ///< number of the stream's next row
};

void ReplayDevice::describe() {
    const double rate_Hz = data().layout->period_s > 0.0 ? 1.0 / data().layout->period_s : 0.0;
    const std::size_t width = data().layout->columns.size();
    std::vector<double> least(width, 0.0);
    std::vector<double> largest(width, 0.0);
    for (std::size_t row = 0; row < data().rows(); ++row) { // as they lie in memory
        for (std::size_t column = 0; column < width; ++column) {
            const double value = data().values[row * width + column];
            least[column] = row == 0 ? value : std::min(least[column], value);
            largest[column] = row == 0 ? value : std::max(largest[column], value);
        }
    }
    for (std::size_t column = 0; column < width; ++column) {
        SignalSpec spec;
        spec.name = data().layout->columns[column].name;
        spec.unit = data().layout->columns[column].unit;
        spec.maxRate_Hz = rate_Hz;
        for (const RecordingMeta::SignalNote& note : m_file.meta.signals) {
            spec.role = note.name == spec.name ? note.role : spec.role;
        }
        spec.min = least[column];
        spec.max = largest[column];
        m_catalogue.signals.push_back(std::move(spec));
        m_catalogue.defaultSignals.push_back(data().layout->columns[column].name);
    }
    for (const RecordingMeta::ParameterNote& note : m_file.meta.parameters) {
        ParameterSpec spec;
        spec.name = note.name;
        spec.unit = note.unit;
        spec.defaultValue = spec.min = spec.max = note.value;
        spec.group = note.name.substr(0, note.name.find('.'));
        spec.access = ParameterAccess::ReadOnly;
        m_catalogue.parameters.push_back(std::move(spec));
    }
    if (const auto profile = findProfile(m_info.model); profile && *profile) {
        const std::vector<std::string> all = m_catalogue.defaultSignals;
        applyProfile(**profile, m_catalogue);
        m_catalogue.defaultSignals = all;
        m_catalogue.procedures = {"record"};
    }
}

Result<std::vector<double>> ReplayDevice::readParameters(std::span<const std::string> names) {
    std::vector<double> values;
    for (const std::string& name : names) {
        const auto found = std::find_if(m_file.meta.parameters.begin(), m_file.meta.parameters.end(),
                                        [&](const auto& note) { return note.name == name; });
        if (found == m_file.meta.parameters.end()) {
            return failure(ErrorCode::UnknownName, fmt::format("the recording has no parameter '{}'", name),
                           "list the names with: halbench describe replay:FILE");
        }
        values.push_back(found->value);
    }
    return values;
}

Result<std::vector<std::size_t>> ReplayDevice::columnsOf(std::span<const std::string> names) const {
    std::vector<std::size_t> columns;
    for (const std::string& name : names) {
        const int column = data().layout->indexOf(name);
        if (column < 0) {
            return failure(ErrorCode::UnknownName, fmt::format("the recording has no signal '{}'", name),
                           "list the names with: halbench describe replay:FILE");
        }
        columns.push_back(static_cast<std::size_t>(column));
    }
    return columns;
}

Result<std::vector<double>> ReplayDevice::readSignals(std::span<const std::string> names) {
    const Result<std::vector<std::size_t>> columns = columnsOf(names);
    if (!columns) {
        return failure(columns.error());
    }
    const auto& times = data().time_s;
    const auto later = std::partition_point(times.begin(), times.end(), [this](double time_s) {
        return time_s - data().time_s.front() <= m_now_s + Rounding_s;
    });
    const auto row = static_cast<std::size_t>(std::max<std::ptrdiff_t>(later - times.begin() - 1, 0));
    std::vector<double> values;
    for (const std::size_t column : *columns) {
        values.push_back(data().values[row * data().layout->columns.size() + column]);
    }
    return values;
}

Result<void> ReplayDevice::startStream(const StreamRequest& request, BlockSink sink) {
    Result<std::vector<std::size_t>> columns = columnsOf(request.signals);
    if (!columns) {
        return failure(columns.error());
    }
    const double recorded_Hz = 1.0 / data().layout->period_s;
    const double divider = recorded_Hz / request.rate_Hz;
    constexpr double Tolerance = 1e-6;
    if (!(divider > 1.0 - Tolerance) || std::abs(divider - std::round(divider)) > Tolerance * divider) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("the recording of {} Hz cannot be replayed at {} Hz", recorded_Hz, request.rate_Hz),
            fmt::format("use a rate that divides {} Hz", recorded_Hz));
    }
    StreamLayout layout;
    layout.period_s = data().layout->period_s * std::round(divider);
    for (const std::size_t column : *columns) {
        layout.columns.push_back(data().layout->columns[column]);
    }
    m_layout = std::make_shared<const StreamLayout>(std::move(layout));
    m_columns = *std::move(columns);
    m_sink = std::move(sink);
    m_streamStart_s = m_now_s;
    m_divider = std::llround(divider);
    m_nextIndex = 0;
    m_nextRow = 0;
    while (m_nextRow < data().rows() && timeOf(m_nextRow) < m_now_s - Rounding_s) {
        ++m_nextRow;
    }
    return {};
}

void ReplayDevice::deliverUntil(double time_s) {
    while (m_sink && m_nextRow < data().rows() && timeOf(m_nextRow) <= time_s + Rounding_s) {
        auto block = std::make_shared<SampleBlock>();
        block->layout = m_layout;
        block->hostArrival_s = time_s;
        const double end_s = std::min(time_s, timeOf(m_nextRow) + BlockDuration_s) + Rounding_s;
        while (m_nextRow < data().rows() && timeOf(m_nextRow) <= end_s && takeRow(*block, m_nextRow)) {
            ++m_nextRow;
        }
        if (!block->time_s.empty()) {
            m_sink(block);
        }
    }
}

/// False when rows are missing before this one and the block has some already: a new block begins.
bool ReplayDevice::takeRow(SampleBlock& block, std::size_t row) {
    const double time_s = timeOf(row) - m_streamStart_s;
    const auto index = static_cast<std::int64_t>(std::llround(time_s / data().layout->period_s));
    if (index % m_divider != 0) {
        return true;
    }
    const std::int64_t lost = std::max<std::int64_t>(index / m_divider - m_nextIndex, 0);
    if (lost > 0 && !block.time_s.empty()) {
        return false;
    }
    block.lostRows += static_cast<std::uint64_t>(lost);
    m_nextIndex = index / m_divider + 1;
    block.time_s.push_back(time_s);
    for (const std::size_t column : m_columns) {
        block.values.push_back(data().values[row * data().layout->columns.size() + column]);
    }
    return true;
}

Result<void> ReplayDevice::waitFor(double duration_s) {
    const double end_s = m_now_s + std::max(duration_s, 0.0);
    const double last_s = timeOf(data().rows() - 1) + data().layout->period_s;
    deliverUntil(std::min(end_s, last_s));
    m_now_s = std::min(end_s, last_s);
    if (end_s > last_s + Rounding_s) {
        return failure(ErrorCode::DeviceLost, fmt::format("the recording ends at {} s", last_s),
                       "use a shorter time");
    }
    return {};
}

struct Source {
    std::string path;
    double begin_s = 0.0;
};

/// A file may have a question mark in its name.
Source sourceOf(const std::string& text) {
    constexpr std::string_view Option = "?at=";
    const std::size_t place = text.rfind(Option);
    if (place == std::string::npos || QFileInfo::exists(QString::fromStdString(text))) {
        return {text, 0.0};
    }
    const char* const begin = text.data() + place + Option.size();
    const char* const end = text.data() + text.size();
    double begin_s = 0.0;
    const auto parsed = std::from_chars(begin, end, begin_s);
    const bool isTime = parsed.ec == std::errc{} && parsed.ptr == end && begin_s >= 0.0;
    return isTime ? Source{text.substr(0, place), begin_s} : Source{text, 0.0};
}

} // namespace

Result<std::unique_ptr<Device>> openReplayDevice(const std::string& uri, const std::string& text,
                                                 const std::function<Result<void>()>& checkAbort,
                                                 const std::function<void(double)>& onProgress) {
    const Source source = sourceOf(text);
    Result<RecordedFile> file = readRecordingFile(source.path, checkAbort, onProgress);
    if (!file) {
        return failure(file.error());
    }
    const Recording& recording = file->recording;
    if (recording.rows() < 2 || !(recording.layout->period_s > 0.0)) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' has fewer than two rows", source.path),
                       "give a recording with data");
    }
    const double length_s = recording.time_s.back() - recording.time_s.front();
    if (!(source.begin_s <= length_s)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("the recording ends at {} s, before {} s", length_s, source.begin_s),
                       "use a start time before the end");
    }
    return std::unique_ptr<Device>(
        std::make_unique<ReplayDevice>(uri, source.path, *std::move(file), source.begin_s));
}

std::shared_ptr<const RecordedFile> recordingOf(const Device& device) {
    const auto* replay = dynamic_cast<const ReplayDevice*>(&device);
    return replay != nullptr ? replay->whole() : nullptr;
}

} // namespace halbench::devices
