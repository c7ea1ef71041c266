#include "app/workspaces/recordings/run_overlay.h"
#include "devices/recording/recording_writer.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/message_bar.h"

#include <QComboBox>
#include <QFile>
#include <QTemporaryDir>

namespace halbench::app {
namespace {

class RunOverlayTest : public BenchTest {
protected:
    QString write(const QString& name) {
        Recording recording;
        recording.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"position", "rad"}}, 0.01});
        for (int row = 0; row < 100; ++row) {
            recording.time_s.push_back(row / 100.0);
            recording.values.push_back(row / 1000.0);
        }
        devices::RecordingMeta meta;
        meta.signals = {{"position", "position_rad", "rad", "position"}};
        const QString path = folder.filePath(name + ".csv");
        EXPECT_TRUE(devices::writeRecordingFile(path.toStdString(), recording, meta));
        return path;
    }
    static void cutTo(const QString& path, int lines) {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::ReadWrite));
        QByteArray kept;
        for (int line = 0; line < lines; ++line) {
            kept += file.readLine();
        }
        ASSERT_TRUE(file.resize(kept.size()));
    }
    widgets::Message messageAfter(RunOverlay& overlay, const QStringList& paths) {
        overlay.setFiles(paths);
        auto* signal = find<QComboBox>(overlay, "Signal that is compared");
        EXPECT_TRUE(wait([&] { return signal->count() > 0; }));
        return overlay.findChild<widgets::MessageBar*>("overlay_message")->message();
    }

    QTemporaryDir folder;
};

TEST_F(RunOverlayTest, aRecordingThatWasCutIsShownAndSaid) {
    const QStringList paths{write("whole"), write("cut")};
    cutTo(paths[1], 41);
    RunOverlay overlay(bench());
    const widgets::Message message = messageAfter(overlay, paths);
    EXPECT_EQ(message.severity, widgets::Severity::Warning);
    EXPECT_TRUE(message.text.contains("40 of 100 rows")) << message.text.toStdString();
    EXPECT_FALSE(message.remedy.isEmpty());
}

TEST_F(RunOverlayTest, ofRecordingsAsTheyWereNothingIsSaid) {
    RunOverlay overlay(bench());
    EXPECT_EQ(messageAfter(overlay, {write("one"), write("two")}).text, QString());
}

} // namespace
} // namespace halbench::app
