#pragma once

#include "devices/recording/recording_csv.h"
#include "devices/recording/recording_writer.h"

#include <QString>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <memory>

namespace halbench::app {

/// Writes ten seconds of a speed at a rate that no simulated board has, to be replayed; its address.
inline QString fastReplay(const QTemporaryDir& folder, double rate_Hz) {
    StreamLayout layout{{{"speed", "rad/s"}}, 1.0 / rate_Hz};
    Recording recording;
    recording.layout = std::make_shared<const StreamLayout>(layout);
    for (int row = 0; row < static_cast<int>(10.0 * rate_Hz); ++row) {
        recording.time_s.push_back(row / rate_Hz);
        recording.values.push_back(row);
    }
    devices::RecordingMeta meta;
    meta.device.model = "htm";
    meta.period_s = layout.period_s;
    meta.parameters = {{"limit.temperature", 80.0, "degC"}};
    meta.signals.push_back({"speed", devices::csvColumnName("speed", "rad/s"), "rad/s", "speed", {}});
    const QString path = folder.filePath("fast.csv");
    EXPECT_TRUE(devices::writeExactRecordingFile(path.toStdString(), recording, meta));
    return "replay:" + path;
}

} // namespace halbench::app
