#include "app/headless/recording_file.h"
#include "devices/open/open_device.h"
#include "devices/recording/recording_writer.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

// An interrupted recording is not overwritten, and the user is told where it is.
TEST(RecordingOutput, warnsOfAnInterruptedRecordingOfItsName) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("run.csv").toStdString();
    QFile interrupted(QString::fromStdString(devices::partialPathOf(path)));
    ASSERT_TRUE(interrupted.open(QIODevice::WriteOnly));
    interrupted.write("time_s,position_rad\n0,0.5\n");
    interrupted.close();
    const auto device = devices::openDevice("sim:htm", {}).value();
    std::vector<std::string> warnings;
    RecordingOutput output(*device, path, "1970-01-01T00:00:00Z",
                           [&](const std::string& text) { warnings.push_back(text); });
    ASSERT_TRUE(output.outlet().begin(StreamLayout{{{"position", "rad"}}, 0.01}));
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find("interrupted recording found"), std::string::npos) << warnings[0];
    ASSERT_TRUE(output.finish());
    EXPECT_TRUE(QFile::exists(QString::fromStdString(path)));
}

} // namespace
} // namespace halbench::app
