#include "app/batch/sidecar_change.h"
#include "app/workspaces/recorded_markers.h"
#include "app/workspaces/shown_recording.h"
#include "devices/acquisition/recording_file.h"
#include "devices/acquisition/recording_writer.h"
#include "tests/app/workspaces/monitor_fixture.h"
#include "widgets/message_bar.h"

#include <QAction>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QTemporaryDir>

namespace halbench::app {
namespace {

using Command = widgets::LivePlotStack::Command;

/// Markers of the plots, from the key to the file and back.
class MonitorMarkersTest : public MonitorTest {
protected:
    devices::RecordingMeta metaOf(const QString& path) {
        const auto file = devices::readRecordingFile(path.toStdString());
        EXPECT_TRUE(file);
        return file ? file->meta : devices::RecordingMeta();
    }
    void note(std::size_t marker, const QString& text) {
        stack().chooseMarker(marker);
        stack().action(Command::MarkerNote)->trigger();
        auto* field = stack().findChild<QLineEdit*>(QStringLiteral("note"));
        field->setText(text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    QString writtenRecording(const char* name, const char* ending) {
        Recording recording;
        StreamLayout layout;
        layout.period_s = 0.001;
        layout.columns.push_back({"s0", "A"});
        recording.layout = std::make_shared<const StreamLayout>(std::move(layout));
        for (int row = 0; row < 3000; ++row) {
            recording.time_s.push_back(5.0 + row / 1000.0);
            recording.values.push_back(row);
        }
        devices::RecordingMeta meta;
        meta.device.model = "other";
        meta.markers = {{5.1, "record"}, {5.7, "knock"}};
        meta.tags = {"cold"};
        meta.period_s = 0.001;
        const QString path = folder.filePath(QLatin1String(name) + QLatin1String(ending));
        EXPECT_TRUE(devices::writeRecordingFile(path.toStdString(), recording, meta));
        return path;
    }
    void show(const QString& path) {
        bench().shownRecording().open(path);
        ASSERT_TRUE(wait([&] {
            return !bench().shownRecording().isBusy() && bench().shownRecording().file() != nullptr;
        }));
    }

    QTemporaryDir folder;
};

TEST(RecordedMarkers, areInTheSidecarAsTheyAreInTheEnd) {
    using Markers = std::vector<devices::RecordingMeta::Marker>;
    const Markers kept{{0.0, "record"}, {0.5, "1"}, {1.5, "2"}, {2.0, "connection lost"}};
    const Markers given{{90.0, "old"}, {100.5, "1"}, {101.5, "2"}}; // the recording began at 100 s
    const Markers wanted{{90.0, "old"}, {100.5, "knock"}, {100.25, "added"}, {200.0, "after its end"}};
    const Markers result = withMarkers(kept, given, wanted, 3.0);
    ASSERT_EQ(result.size(), 4U);
    EXPECT_EQ(result[0].text, "record");
    EXPECT_EQ(result[1].text, "connection lost");
    EXPECT_EQ(result[2].text, "knock");
    EXPECT_NEAR(result[2].time_s, 0.5, 1e-12);
    EXPECT_NEAR(result[3].time_s, 0.25, 1e-12);
    // The recorder took one for its own that came with its first row, however late the plots were.
    const Markers first = withMarkers({{0.0, "1"}}, {{99.9, "1"}}, {{99.9, "start"}}, 3.0);
    ASSERT_EQ(first.size(), 1U);
    EXPECT_EQ(first[0].text, "start");
    EXPECT_EQ(first[0].time_s, 0.0);
    EXPECT_TRUE(withMarkers({{0.0, "1"}}, {{99.9, "1"}}, {}, 3.0).empty()) << "it was removed";
}

TEST_F(MonitorMarkersTest, aRecordingHasThemWithTheirLastNoteAtTheDevicesTime) {
    connectTo("sim:htm", 5.0);
    bench().recording().setFolder(folder.path());
    bench().recording().setName(QStringLiteral("marked"));
    ASSERT_TRUE(wait([&] { return bench().history().range().has_value(); }));
    press(Qt::Key_M); // before the recording begins: none of its
    bench().recording().start();
    ASSERT_TRUE(wait([&] { return bench().recording().status().rows > 50; }));
    const double recorded_s = bench().session().report().deviceTime_s;
    ASSERT_TRUE(wait([&] { return bench().history().range()->end_s > recorded_s; })) << "what is drawn lags";
    stack().refresh();
    press(Qt::Key_M);
    press(Qt::Key_M);
    ASSERT_EQ(stack().markers().size(), 3U);
    const double marked_s = stack().markers()[1].time_s;
    const double rows_s = bench().history().range()->end_s;
    EXPECT_LE(marked_s, rows_s);
    note(1, QStringLiteral("knock on the table"));
    stack().chooseMarker(2);
    stack().action(Command::RemoveMarker)->trigger();
    QString path;
    QObject::connect(&bench().recording(), &RecordingControl::finished, panel.get(),
                     [&](const QString& written, const RecorderStatus&) { path = written; });
    const auto file = [&] { return metaOf(path); };
    bench().recording().stop();
    ASSERT_TRUE(wait([&] { return !path.isEmpty(); }));
    const auto listed = [&] {
        std::string text;
        for (const auto& marker : file().markers) {
            text += marker.text + " at " + std::to_string(marker.time_s) + "; ";
        }
        return text;
    };
    ASSERT_TRUE(wait([&] { return file().markers.size() == 1; })) << listed();
    const devices::RecordingMeta meta = file();
    EXPECT_EQ(meta.markers[0].text, "knock on the table");
    EXPECT_GT(meta.markers[0].time_s, 0.0);
    EXPECT_LT(meta.markers[0].time_s, marked_s) << "counts from the first row";
}

TEST_F(MonitorMarkersTest, aShownRecordingKeepsThemInItsSidecarAndShowsThemAgain) {
    const QString path = writtenRecording("run", ".csv");
    show(path);
    ASSERT_EQ(stack().markers().size(), 2U);
    note(1, QStringLiteral("the door"));
    stack().setCursorsVisible(true);
    stack().setCursor(0, 1.25);
    stack().action(Command::CursorA)->trigger();
    stack().action(Command::Marker)->trigger();
    const auto kept = [&] { return metaOf(path).markers; };
    ASSERT_TRUE(wait([&] { return kept().size() == 3; }));
    EXPECT_EQ(kept()[0].time_s, 5.1) << "what was not touched is as it was, to the last bit";
    EXPECT_EQ(kept()[1].text, "the door");
    EXPECT_EQ(kept()[1].time_s, 5.7);
    EXPECT_NEAR(kept()[2].time_s, 6.25, 1e-12);
    EXPECT_EQ(metaOf(path).tags, std::vector<std::string>{"cold"}) << "all else stays";
    bench().shownRecording().open(path);
    ASSERT_TRUE(wait([&] { return stack().markers().size() == 3 && !bench().shownRecording().isBusy(); }));
    EXPECT_EQ(stack().markers()[1].text, "the door");
}

TEST_F(MonitorMarkersTest, whereThereIsNoSidecarItIsSaidThatTheyAreNotKept) {
    const QString path = writtenRecording("bare", ".csv");
    ASSERT_TRUE(QFile::remove(folder.filePath("bare.meta.json")));
    show(path);
    stack().action(Command::Marker)->trigger();
    auto* message = panel->findChild<widgets::MessageBar*>();
    ASSERT_TRUE(wait([&] { return message->isVisible() && message->message().text.contains("not kept"); }));
    EXPECT_FALSE(QFile::exists(folder.filePath("bare.meta.json")));
}

TEST_F(MonitorMarkersTest, otherKeysOfASidecarStay) {
    const QString path = writtenRecording("later", ".csv");
    QFile sidecar(folder.filePath("later.meta.json"));
    ASSERT_TRUE(sidecar.open(QIODevice::ReadOnly));
    QJsonObject root = QJsonDocument::fromJson(sidecar.readAll()).object();
    sidecar.close();
    root.insert("of_a_later_version", 7);
    ASSERT_TRUE(sidecar.open(QIODevice::WriteOnly));
    sidecar.write(QJsonDocument(root).toJson());
    sidecar.close();
    ASSERT_TRUE(writeRecordingMarkers(path, {{5.5, "µ & ü"}}));
    EXPECT_EQ(metaOf(path).markers.at(0).text, "µ & ü");
    ASSERT_TRUE(sidecar.open(QIODevice::ReadOnly));
    EXPECT_EQ(QJsonDocument::fromJson(sidecar.readAll()).object().value("of_a_later_version").toInt(), 7);
}

} // namespace
} // namespace halbench::app
