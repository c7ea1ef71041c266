#include "devices/formats/mdf4_writer.h"

#include "devices/formats/mdf4_blocks.h"
#include "devices/formats/mdf4_comment.h"
#include "devices/recording/file_access.h"
#include "devices/recording/recording_csv.h"

#include <QtCore/QDateTime>
#include <QtCore/QSaveFile>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace halbench::devices {

namespace {

using namespace mdf4;

constexpr std::size_t RowsPerBlock = 4096;
constexpr std::uint16_t CountsAndLengthDue =
    0x5; // of an unfinalised file: cycle count, length of the last DT

std::string identification(bool isFinal) {
    std::string block(isFinal ? FinalisedId : UnfinalisedId);
    block += VersionText;
    block += Program;
    put(block, std::uint32_t{0});
    put(block, Version);
    block.append(30, '\0');
    put(block, isFinal ? std::uint16_t{0} : CountsAndLengthDue);
    put(block, std::uint16_t{0});
    return block;
}

/// Nanoseconds since 1970, UTC; then that the (zero) offsets to local time are valid.
std::string startTime(const std::string& started) {
    const QDateTime start = QDateTime::fromString(QString::fromStdString(started), Qt::ISODateWithMs);
    const qint64 start_ms = start.isValid() ? std::max<qint64>(start.toMSecsSinceEpoch(), 0) : 0;
    std::string data;
    put(data, static_cast<std::uint64_t>(start_ms) * 1'000'000U);
    put(data, std::uint32_t{0});
    put(data, std::uint8_t{2});
    return data;
}

/// Names in a group are unique; two columns may differ in nothing but their unit.
std::string channelName(const StreamLayout::Column& column, std::set<std::string>& taken) {
    if (taken.insert(column.name).second) {
        return column.name;
    }
    std::string name = csvColumnName(column.name, column.unit);
    while (!taken.insert(name).second) {
        name += '_';
    }
    return name;
}

RecordingMeta::SignalNote noteOf(const RecordingMeta& meta, const StreamLayout::Column& column) {
    for (const RecordingMeta::SignalNote& note : meta.signals) {
        if (note.name == column.name && note.unit == column.unit) {
            return note;
        }
    }
    return {};
}

/// Type, 64-bit float at its place in the row; no ranges, limits or invalidation.
std::string channelData(std::size_t index) {
    std::string data;
    put(data, index == 0 ? Master : std::uint8_t{0});
    put(data, index == 0 ? TimeAxis : std::uint8_t{0});
    put(data, Real);
    put(data, std::uint8_t{0});
    put(data, static_cast<std::uint32_t>(index * sizeof(double)));
    put(data, std::uint32_t{64});
    put(data, std::uint64_t{0});   // flags, place of an invalidation bit
    put(data, std::uint8_t{0xFF}); // as many digits as there are
    data.resize(Cn.data, '\0');
    return data;
}

/// A point in time as 1 x time, so that no digit is lost.
std::string eventData(double time_s) {
    std::string data;
    put(data, Marker);
    put(data, TimeAxis);
    data.resize(16, '\0'); // a point, no special cause, no scope, no attachments
    put(data, std::int64_t{1});
    put(data, time_s);
    return data;
}

} // namespace

Mdf4Writer::Mdf4Writer(QIODevice& output, RecordingMeta meta) : m_output(output), m_meta(std::move(meta)) {}

std::uint64_t Mdf4Writer::addText(const std::string& text) {
    const std::uint64_t offset = here();
    m_bytes += makeBlock(Tx.id, {}, text + '\0');
    return offset;
}

std::uint64_t Mdf4Writer::addComment(const std::string& xml) {
    const std::uint64_t offset = here();
    m_bytes += makeBlock(Md.id, {}, xml + '\0');
    return offset;
}

/// No clock is asked: equal recordings give equal files.
std::uint64_t Mdf4Writer::addHistory() {
    const std::uint64_t comment = addComment(historyComment());
    const std::uint64_t offset = here();
    std::string data = startTime(m_meta.started);
    data.resize(Fh.data, '\0');
    m_bytes += makeBlock(Fh.id, {0, comment}, data);
    return offset;
}

std::uint64_t Mdf4Writer::addSource() {
    const std::uint64_t name = addText(m_meta.device.model.empty() ? "device" : m_meta.device.model);
    const std::uint64_t path = m_meta.device.id.empty() ? 0 : addText(m_meta.device.id);
    const std::uint64_t offset = here();
    std::string data;
    put(data, std::uint8_t{1}); // a control unit
    put(data, std::uint8_t{0});
    put(data, std::uint8_t{m_meta.device.isSimulated});
    data.resize(Si.data, '\0');
    m_bytes += makeBlock(Si.id, {name, path, 0}, data);
    return offset;
}

/// Their texts, then the channels one behind the other.
std::uint64_t Mdf4Writer::addChannels(const StreamLayout& layout) {
    struct Texts {
        std::uint64_t name;
        std::uint64_t unit;
        std::uint64_t comment;
    };
    std::vector<Texts> texts{{addText("time"), addText("s"), 0}};
    std::set<std::string> taken{"time"};
    for (const StreamLayout::Column& column : layout.columns) {
        const std::string name = channelName(column, taken);
        const RecordingMeta::SignalNote note = noteOf(m_meta, column);
        const std::string signal = name == column.name ? std::string() : column.name;
        Texts own{addText(name), 0, 0};
        own.unit = column.unit.empty() ? 0 : addText(column.unit);
        const bool isPlain = note.role.empty() && signal.empty() && note.expression.empty();
        own.comment = isPlain ? 0 : addComment(channelComment(note.role, signal, note.expression));
        texts.push_back(own);
    }
    const std::uint64_t first = here();
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const std::uint64_t next = i + 1 < texts.size() ? here() + Cn.size() : 0;
        m_bytes += makeBlock(Cn.id, {next, 0, texts[i].name, 0, 0, 0, texts[i].unit, texts[i].comment},
                             channelData(i));
    }
    return first;
}

std::string Mdf4Writer::headerBlock(std::uint64_t firstEvent) const {
    std::string data = startTime(m_meta.started);
    data.resize(Hd.data, '\0');
    return makeBlock(Hd.id, {m_dataGroup, m_history, 0, 0, firstEvent, m_comment}, data);
}

bool Mdf4Writer::begin(const StreamLayout& layout) {
    m_columns = layout.columns.size();
    m_bytes = identification(false) + headerBlock(0);
    m_comment = addComment(headerComment(m_meta));
    m_history = addHistory();
    const std::uint64_t source = addSource();
    const std::uint64_t channels = addChannels(layout);
    m_channelGroup = here();
    std::string data(24, '\0'); // record id, cycles so far, flags, path separator
    put(data, static_cast<std::uint32_t>((m_columns + 1) * sizeof(double)));
    put(data, std::uint32_t{0});
    m_bytes += makeBlock(Cg.id, {0, channels, 0, source, 0, 0}, data);
    m_dataGroup = here();
    m_data = here() + Dg.size();
    m_bytes += makeBlock(Dg.id, {0, m_channelGroup, m_data, 0}, std::string(Dg.data, '\0'));
    m_bytes += makeBlock(Dt.id, {}, {});
    m_bytes.replace(HdOffset, Hd.size(), headerBlock(0));
    return flush();
}

bool Mdf4Writer::append(const SampleBlock& block) {
    for (std::size_t row = 0; row < block.rows(); ++row) {
        put(m_bytes, block.time_s[row]);
        for (std::size_t column = 0; column < m_columns; ++column) {
            put(m_bytes, block.value(row, column));
        }
    }
    m_rows += block.rows();
    return flush();
}

/// Their texts, then the events one behind the other. Offset of the first one, 0 without any.
std::uint64_t Mdf4Writer::addEvents() {
    struct Event {
        double time_s;
        std::uint64_t name;
        std::uint64_t comment;
    };
    std::vector<Event> events;
    for (const RecordingMeta::Marker& marker : m_meta.markers) {
        events.push_back({marker.time_s, addText(marker.text), 0});
    }
    for (const RecordingMeta::ParameterChange& change : m_meta.changes) {
        const std::uint64_t name = addText(fmt::format("{} = {}", change.name, change.value));
        events.push_back({change.time_s, name, addComment(changeComment(change))});
    }
    const std::uint64_t first = here();
    for (std::size_t i = 0; i < events.size(); ++i) {
        const std::uint64_t next = i + 1 < events.size() ? here() + Ev.size() : 0;
        m_bytes +=
            makeBlock(Ev.id, {next, 0, 0, events[i].name, events[i].comment}, eventData(events[i].time_s));
    }
    return events.empty() ? 0 : first;
}

bool Mdf4Writer::finish() {
    const std::uint64_t firstEvent = addEvents();
    std::string cycles;
    put(cycles, m_rows);
    std::string length;
    put(length, std::uint64_t{HeaderSize + m_rows * (m_columns + 1) * sizeof(double)});
    return flush() && patch(m_data + 8, length) &&
           patch(m_channelGroup + HeaderSize + LinkSize * Cg.links + CycleCount, cycles) &&
           patch(HdOffset, headerBlock(firstEvent)) && patch(0, identification(true));
}

bool Mdf4Writer::flush() {
    const auto size = static_cast<qint64>(m_bytes.size());
    const bool isWritten = m_output.write(m_bytes.data(), size) == size;
    m_begin += m_bytes.size();
    m_bytes.clear();
    return isWritten;
}

bool Mdf4Writer::patch(std::uint64_t offset, const std::string& octets) {
    const auto size = static_cast<qint64>(octets.size());
    return m_output.seek(static_cast<qint64>(offset)) && m_output.write(octets.data(), size) == size;
}

Result<void> writeMdf4File(const std::string& path, const Recording& recording, RecordingMeta meta) {
    if (const Result<void> folder = createFolderOf(path); !folder) {
        return folder;
    }
    QSaveFile file(QString::fromStdString(path)); // takes the name when it is complete
    if (!file.open(QIODevice::WriteOnly)) {
        return cannotWrite(path, file);
    }
    meta.rates = recording.rates;
    Mdf4Writer writer(file, std::move(meta));
    bool isWritten = writer.begin(*recording.layout);
    const std::size_t columns = recording.layout->columns.size();
    for (std::size_t row = 0; isWritten && row < recording.rows(); row += RowsPerBlock) {
        const std::size_t end = std::min(row + RowsPerBlock, recording.rows());
        const auto time = recording.time_s.begin();
        const auto values = recording.values.begin();
        const auto at = [](auto begin, std::size_t index) {
            return begin + static_cast<std::ptrdiff_t>(index);
        };
        SampleBlock block{recording.layout, {at(time, row), at(time, end)}, {}, 0.0, 0};
        block.values.assign(at(values, row * columns), at(values, end * columns));
        isWritten = writer.append(block);
    }
    if (!isWritten || !writer.finish() || !file.commit()) {
        return cannotWrite(path, file);
    }
    return {};
}

} // namespace halbench::devices
