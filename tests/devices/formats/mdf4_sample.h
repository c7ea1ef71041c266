#pragma once

#include "devices/formats/mdf4_writer.h"
#include "devices/recording/recording_csv.h"

#include <QtCore/QBuffer>

#include <limits>

namespace halbench::devices {

/// A recording with everything that a file must hold: a gap, NaN, signals that differ in their unit alone, a
/// change and a marker.
struct Mdf4Sample {
    Recording recording;
    RecordingMeta meta;
};

inline Mdf4Sample mdf4Sample() {
    Mdf4Sample sample;
    sample.recording.layout = std::make_shared<const StreamLayout>(
        StreamLayout{{{"position", "rad"}, {"x", "A"}, {"x", "V"}, {"time", ""}}, 0.01});
    for (int row = 0; row < 20; ++row) {
        sample.recording.time_s.push_back((row < 12 ? row : row + 5) / 100.0);
        const double value = row == 3 ? std::numeric_limits<double>::quiet_NaN() : row / 3.0;
        sample.recording.values.insert(sample.recording.values.end(),
                                       {value, -value, 1e300 * row, 1.0 * row});
    }
    sample.meta.device.model = "htm";
    sample.meta.device.id = "id <1>";
    sample.meta.started = "2026-01-02T03:04:05Z";
    sample.meta.period_s = 0.01;
    for (const StreamLayout::Column& column : sample.recording.layout->columns) {
        sample.meta.signals.push_back(
            {column.name, csvColumnName(column.name, column.unit), column.unit, ""});
    }
    sample.meta.signals[0].role = "position";
    sample.meta.parameters = {{"gain.kp", 0.1, "A/rad"}};
    sample.meta.changes = {{0.05, "gain.kp", 1.0 / 3.0}};
    sample.meta.markers = {{-0.1, "before <all>"}, {1.0 / 7.0, "\xC3\xA4"}};
    return sample;
}

/// Written in blocks of `rowsAtOnce`.
inline std::string mdf4Octets(const Mdf4Sample& sample, std::size_t rowsAtOnce = 1000) {
    QBuffer buffer;
    buffer.open(QIODevice::ReadWrite);
    Mdf4Writer writer(buffer, sample.meta);
    bool isWritten = writer.begin(*sample.recording.layout);
    const std::size_t columns = sample.recording.layout->columns.size();
    for (std::size_t row = 0; row < sample.recording.rows(); row += rowsAtOnce) {
        const std::size_t end = std::min(row + rowsAtOnce, sample.recording.rows());
        SampleBlock block{sample.recording.layout, {}, {}, 0.0, 0};
        for (std::size_t i = row; i < end; ++i) {
            block.time_s.push_back(sample.recording.time_s[i]);
        }
        for (std::size_t i = row * columns; i < end * columns; ++i) {
            block.values.push_back(sample.recording.values[i]);
        }
        isWritten = isWritten && writer.append(block);
    }
    return isWritten && writer.finish() ? buffer.data().toStdString() : std::string();
}

} // namespace halbench::devices
