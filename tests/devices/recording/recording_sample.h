#pragma once

#include "devices/recording/recording_csv.h"
#include "devices/recording/recording_writer.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace halbench::devices {

inline std::string contentOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

inline Recording ramp(std::size_t rows, double period_s = 0.01) {
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(
        StreamLayout{{{"position", "rad"}, {"hall.a", "T"}, {"status", ""}}, period_s});
    for (std::size_t row = 0; row < rows; ++row) {
        recording.time_s.push_back(static_cast<double>(row) / 100.0);
        recording.values.insert(recording.values.end(), {0.5 * static_cast<double>(row), 0.157, 1.0});
    }
    return recording;
}

inline RecordingMeta metaOf(const Recording& recording) {
    RecordingMeta meta;
    meta.device.model = "htm";
    meta.device.overrides = {{"c", "2e-3"}};
    meta.started = "1970-01-01T00:00:00Z";
    for (const StreamLayout::Column& column : recording.layout->columns) {
        meta.signals.push_back(
            {column.name, csvColumnName(column.name, column.unit), column.unit, column.name});
    }
    meta.parameters = {{"gain.kp", 10.0, "A/rad"}};
    return meta;
}

/// A program that wrote these rows and ended there; gives what it left.
inline std::string interrupt(const std::string& file, const Recording& part) {
    auto writer = RecordingWriter::create(file, *part.layout, metaOf(part));
    EXPECT_TRUE(writer);
    EXPECT_TRUE((*writer)->append({part.layout, part.time_s, part.values, 0.0, 0}));
    return contentOf(file + ".partial");
}

} // namespace halbench::devices
