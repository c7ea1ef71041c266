#include "app/recordings/sidecar_change.h"
#include "app/workbench/recording_trigger.h"
#include "app/workbench/shown_recording.h"
#include "app/workspaces/monitor/recorded_markers.h"
#include "app/workspaces/recordings/record_panel.h"
#include "devices/formats/recording_file.h"
#include "devices/recording/recording_writer.h"
#include "tests/app/workspaces/monitor/monitor_fixture.h"
#include "widgets/controls/message_bar.h"

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

    /// Recording every sample of the stream; `recorded` is the complete file, once it is.
    void startRecording(const char* name) {
        bench().recording().setFolder(folder.path());
        bench().recording().setName(QLatin1String(name));
        bench().recording().setRate_Hz(1000.0);
        QObject::connect(&bench().recording(), &RecordingControl::finished, panel.get(),
                         [this](const QString& path, const RecorderStatus&) { recorded = path; });
        bench().recording().start();
        ASSERT_TRUE(wait([&] { return bench().recording().status().rows > 50; }));
    }
    void stopRecording() {
        bench().recording().stop();
        ASSERT_TRUE(wait([&] { return !recorded.isEmpty(); }));
    }
    std::string listed() {
        std::string text;
        for (const auto& marker : metaOf(recorded).markers) {
            text += marker.text + " at " + std::to_string(marker.time_s) + "; ";
        }
        return text;
    }

    QTemporaryDir folder;
    QString recorded;
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
    QObject::connect(&bench().recording(), &RecordingControl::finished, panel.get(),
                     [&](const QString& path, const RecorderStatus&) { recorded = path; });
    stopRecording();
    ASSERT_TRUE(wait([&] { return metaOf(recorded).markers.size() == 1; })) << listed();
    const devices::RecordingMeta meta = metaOf(recorded);
    EXPECT_EQ(meta.markers[0].text, "knock on the table");
    EXPECT_GT(meta.markers[0].time_s, 0.0);
    EXPECT_LT(meta.markers[0].time_s, marked_s) << "counts from the first row";
}

/// The rows that end with these values.
std::vector<double> endsOf(const std::vector<control::TimedValue>& trail, const Recording& recording,
                           const std::string& signal) {
    const auto column = static_cast<std::size_t>(recording.layout->indexOf(signal));
    const std::size_t width = recording.layout->columns.size();
    std::vector<double> ends_s;
    for (std::size_t row = trail.size() - 1; row < recording.rows(); ++row) {
        const bool isSame = std::all_of(trail.begin(), trail.end(), [&](const control::TimedValue& each) {
            const auto before = static_cast<std::size_t>(&trail.back() - &each);
            const double value = recording.values[(row - before) * width + column];
            return static_cast<float>(value) == static_cast<float>(each.value); // as the board sends it
        });
        if (isSame) {
            ends_s.push_back(recording.time_s[row]);
        }
    }
    return ends_s;
}

/// The noise of a Hall sensor names a row: no other has the same before it.
TEST_F(MonitorMarkersTest, areAtTheirRowAfterTheDevicesClockBeganAgain) {
    connectTo("sim:htm?seed=6&hall_noise_mT=2", 5.0);
    ASSERT_TRUE(wait([&] { return bench().history().range().has_value(); }));
    SampleBlock ahead; // of a clock that was three seconds later than the one from now on
    ahead.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"hall.a", "T"}}, 0.001});
    ahead.time_s = {bench().history().range()->end_s + 3.0};
    ahead.values = {0.0};
    bench().show(ahead, 0.0, true);
    ASSERT_TRUE(wait([&] { return bench().history().range()->end_s > ahead.time_s[0] + 0.1; }));
    ASSERT_GT(bench().recordingTrigger().shifts().newest(), 2.0) << "else this proves nothing";
    startRecording("anew");
    const double recorded_s = bench().history().range()->end_s;
    ASSERT_TRUE(wait([&] { return bench().history().range()->end_s > recorded_s + 0.2; }));
    stack().refresh();
    press(Qt::Key_M);
    const double marked_s = stack().markers().back().time_s;
    std::vector<control::TimedValue> trail;
    ASSERT_TRUE(bench().history().samples("hall.a", {marked_s - 0.05, marked_s}, trail));
    std::erase_if(trail, [&](const control::TimedValue& each) { // those beyond its ends
        return each.time_s > marked_s || each.time_s < marked_s - 0.05;
    });
    ASSERT_TRUE(wait([&] { return bench().recording().status().elapsed_s > 1.0; }));
    stopRecording();
    ASSERT_TRUE(wait([&] { return metaOf(recorded).markers.size() == 1; })) << listed();
    const auto file = devices::readRecordingFile(recorded.toStdString());
    const std::vector<double> ends_s = endsOf(trail, file->recording, "hall.a");
    ASSERT_EQ(ends_s.size(), 1U);
    EXPECT_NEAR(file->meta.markers[0].time_s, ends_s[0], 1e-6); // rows are 1 ms apart
}

TEST_F(MonitorMarkersTest, oneOfTheRecordPanelIsInThePlotsAndNotedThere) {
    connectTo("sim:htm", 5.0);
    RecordPanel record(bench());
    QObject::connect(&record, &RecordPanel::marked, panel.get(), &MonitorPanel::takeRecordedMarker);
    auto* note = record.findChild<QLineEdit*>(QStringLiteral("markerNote"));
    EXPECT_FALSE(note->isEnabled()) << "there is no recording";
    startRecording("both");
    ASSERT_TRUE(wait([&] { return note->isEnabled(); }));
    const auto mark = [&](const char* text) {
        QTest::keyClicks(note, QLatin1String(text));
        QTest::keyClick(note, Qt::Key_Return);
    };
    stack().refresh();
    press(Qt::Key_M);
    stack().chooseMarker(0);
    mark("knock");
    mark("");
    mark("gone");
    QStringList texts;
    for (const widgets::PlotMarker& marker : stack().markers()) {
        texts << marker.text;
    }
    ASSERT_EQ(texts, (QStringList{"1", "knock", "3", "gone"})) << "one that nobody named has a number";
    EXPECT_EQ(stack().chosenMarker(), 0U) << "who types a note goes on";
    EXPECT_EQ(stack().markers()[1].text, "knock");
    const control::TimeRange held = bench().history().range().value();
    EXPECT_NEAR(stack().markers()[1].time_s, held.end_s, 1.0); // newest, on the plots' time
    this->note(1, QStringLiteral("the door"));
    stack().chooseMarker(3);
    stack().action(Command::RemoveMarker)->trigger();
    ASSERT_TRUE(wait([&] { return bench().recording().status().elapsed_s > 1.0; }));
    stopRecording();
    ASSERT_TRUE(wait([&] { return metaOf(recorded).markers.size() == 3; })) << listed();
    const auto kept = metaOf(recorded).markers;
    const auto has = [&](const char* text) {
        return std::count_if(kept.begin(), kept.end(),
                             [&](const auto& marker) { return marker.text == text; }) == 1;
    };
    EXPECT_TRUE(has("1") && has("the door") && has("3")) << listed();
}

TEST_F(MonitorMarkersTest, oneOfTheRecordPanelIsAtItsRowInTheFile) {
    connectTo("sim:htm", 5.0);
    RecordPanel record(bench());
    QObject::connect(&record, &RecordPanel::marked, panel.get(), &MonitorPanel::takeRecordedMarker);
    startRecording("row");
    record.findChild<QLineEdit*>(QStringLiteral("markerNote"))->setText(QStringLiteral("here"));
    ASSERT_TRUE(
        wait([&] { return record.findChild<QLineEdit*>(QStringLiteral("markerNote"))->isEnabled(); }));
    QTest::keyClick(record.findChild<QLineEdit*>(QStringLiteral("markerNote")), Qt::Key_Return);
    ASSERT_EQ(stack().markers().size(), 1U);
    press(Qt::Key_M); // another one, that tells where the first row is
    ASSERT_TRUE(wait([&] { return bench().recording().status().elapsed_s > 1.0; }));
    const double apart_s = stack().markers()[1].time_s - stack().markers()[0].time_s;
    stopRecording();
    ASSERT_TRUE(wait([&] { return metaOf(recorded).markers.size() == 2; })) << listed();
    const auto kept = metaOf(recorded).markers;
    EXPECT_NEAR(kept[1].time_s - kept[0].time_s, apart_s, 1e-9) << "the same moments in file and plots";
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
    ASSERT_TRUE(wait([&] { return message->isVisible() && message->message().text.contains("not saved"); }));
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
