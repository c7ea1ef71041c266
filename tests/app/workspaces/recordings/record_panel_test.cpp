#include "app/procedures/move/move_procedure.h"
#include "app/workbench/recording_control.h"
#include "app/workbench/recording_trigger.h"
#include "app/workbench/wall_clock.h"
#include "app/workspaces/recordings/record_panel.h"
#include "devices/formats/recording_file.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/quantity_edit.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>

#include <algorithm>
#include <atomic>
#include <thread>

namespace halbench::app {
namespace {

class RecordPanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<RecordPanel>(bench());
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
        type(find<QLineEdit>(*panel, "Folder of recordings"), folder.path());
    }
    void TearDown() override { panel.reset(); }

    widgets::Message message() { return panel->findChild<widgets::MessageBar*>()->message(); }
    void set(const QString& field, const QString& number) {
        auto* box = find<widgets::QuantityEdit>(*panel, field);
        type(box, number);
        QTest::keyClick(box, Qt::Key_Return);
    }
    devices::RecordedFile recorded(const QString& name) {
        auto file = devices::readRecordingFile(folder.filePath(name + ".csv").toStdString());
        EXPECT_TRUE(file) << (file ? "" : file.error().message);
        return file ? *std::move(file) : devices::RecordedFile();
    }
    QString figure(const QString& name) { return find<QLabel>(*panel, name)->text(); }

    QTemporaryDir folder;
    std::unique_ptr<RecordPanel> panel;
};

TEST_F(RecordPanelTest, recordsAFileThatOpensAgainWithUnitsMarkersAndChanges) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Start recording")->isEnabled(); }));
    type(find<QLineEdit>(*panel, "Name of the recording"), "first");
    click(*panel, "Start recording");
    ASSERT_TRUE(wait([&] { return figure("Samples written").toInt() > 50; }));
    EXPECT_EQ(figure("Samples lost"), "0");
    auto* note = find<QLineEdit>(*panel, "Note of the marker");
    QTest::keyClicks(note, "knock");
    QTest::keyClick(note, Qt::Key_Return);
    bench().writeValues({{"gain.kp", 12.0}}, [](const Result<void>&) {});
    ASSERT_TRUE(wait([&] { return bench().deviceValue("gain.kp").value_or(0.0) == 12.0; }));
    ASSERT_TRUE(wait([&] { return figure("Samples written").toInt() > 150; }));
    click(*panel, "Stop recording");
    ASSERT_TRUE(wait([&] { return message().severity == widgets::Severity::Success; }));

    const std::string path = folder.filePath("first.csv").toStdString();
    const auto file = devices::readRecordingFile(path);
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_TRUE(file->warnings.empty()); // the SHA-256 fits
    EXPECT_GT(file->recording.rows(), 150U);
    EXPECT_EQ(file->recording.lostRows, 0U);
    EXPECT_EQ(file->recording.layout->period_s, 0.001); // the rows of the plots unless said otherwise
    const int hall = file->recording.layout->indexOf("hall.a");
    ASSERT_GE(hall, 0);
    EXPECT_EQ(file->recording.layout->columns[static_cast<std::size_t>(hall)].unit, "T");
    ASSERT_EQ(file->meta.markers.size(), 1U);
    EXPECT_EQ(file->meta.markers[0].text, "knock");
    ASSERT_EQ(file->meta.changes.size(), 1U);
    EXPECT_EQ(file->meta.changes[0].name, "gain.kp");
    EXPECT_EQ(file->meta.device.id, "sim-htm-1");
    EXPECT_FALSE(file->meta.parameters.empty());
}

TEST_F(RecordPanelTest, theDefaultNameHasTheDeviceAndAnIsoDate) {
    EXPECT_EQ(datedName("sim-htm-1", QDateTime({2026, 11, 21}, {21, 5, 9}, Qt::UTC)),
              "sim-htm-1_2026-11-21T21-05-09");
    EXPECT_EQ(datedName("a b/c", QDateTime({2026, 1, 2}, {3, 4, 5}, Qt::UTC)), "a-b-c_2026-01-02T03-04-05");
    EXPECT_TRUE(wallClock().isValid());
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Start recording")->isEnabled(); }));
    click(*panel, "Start recording");
    const QString name = QFileInfo(bench().recording().path()).fileName();
    EXPECT_TRUE(name.startsWith("sim-htm-1_20")) << name.toStdString();
    EXPECT_TRUE(name.endsWith(".csv"));
}

TEST_F(RecordPanelTest, theMaskNamesWhatNobodyNamedAndTheSidecarSaysWhichThatIs) {
    RecordingControl& recording = bench().recording();
    recording.setNameMask("{device} {number} {name}");
    auto* name = find<QLineEdit>(*panel, "Name of the recording");
    EXPECT_EQ(name->placeholderText(), "{device} {number} {name}");
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Start recording")->isEnabled(); }));
    for (const char* typed : {"", "a/b"}) {
        type(name, typed);
        click(*panel, "Start recording");
        ASSERT_TRUE(wait([&] { return figure("Samples written").toInt() > 5; }));
        click(*panel, "Stop recording");
        ASSERT_TRUE(wait([&] { return !recording.isRecording(); }));
    }
    EXPECT_EQ(recorded("sim-htm-1 001 recording").meta.automaticName, "sim-htm-1 001 recording");
    EXPECT_EQ(recorded("sim-htm-1 001 a-b").meta.automaticName, "") << "somebody named it";
}

TEST_F(RecordPanelTest, showsWhatAProjectBringsUnlessSomethingIsRecorded) {
    RecordingControl& recording = bench().recording();
    recording.setChoice({2.5, true, 10.0});
    EXPECT_EQ(find<widgets::QuantityEdit>(*panel, "Pre-trigger time")->value(), 2.5);
    EXPECT_EQ(find<QComboBox>(*panel, "Start of the recording")->currentIndex(), 1);
    auto* after = find<widgets::QuantityEdit>(*panel, "Post-trigger time");
    EXPECT_EQ(after->value(), 10.0);
    EXPECT_TRUE(after->isEnabled());
    EXPECT_EQ(recording.choice(), (RecordingChoice{2.5, true, 10.0}));
    set("Post-trigger time", "4");
    EXPECT_EQ(recording.choice().after_s, 4.0);
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Wait for the trigger")->isEnabled(); }));
    click(*panel, "Wait for the trigger");
    recording.setChoice({});
    EXPECT_EQ(recording.choice(), (RecordingChoice{2.5, true, 4.0})) << "it waits";
}

TEST_F(RecordPanelTest, anOlderRecordingIsNeverOverwritten) {
    QFile older(folder.filePath("mine.csv"));
    ASSERT_TRUE(older.open(QIODevice::WriteOnly));
    older.write("precious");
    older.close();
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Start recording")->isEnabled(); }));
    type(find<QLineEdit>(*panel, "Name of the recording"), "mine");
    click(*panel, "Start recording");
    EXPECT_EQ(message().severity, widgets::Severity::Error);
    EXPECT_FALSE(bench().recording().isRecording());
    ASSERT_TRUE(older.open(QIODevice::ReadOnly));
    EXPECT_EQ(older.readAll(), "precious");
}

TEST_F(RecordPanelTest, aDeviceThatGoesAwayCompletesTheFile) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Start recording")->isEnabled(); }));
    type(find<QLineEdit>(*panel, "Name of the recording"), "short");
    click(*panel, "Start recording");
    ASSERT_TRUE(wait([&] { return figure("Samples written").toInt() > 20; }));
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return message().severity == widgets::Severity::Success; }));
    const auto file = devices::readRecordingFile(folder.filePath("short.csv").toStdString());
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_GT(file->recording.rows(), 20U);
}

TEST_F(RecordPanelTest, aProcedureIsRecordedThroughItsOwnStream) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Start recording")->isEnabled(); }));
    type(find<QLineEdit>(*panel, "Name of the recording"), "move");
    click(*panel, "Start recording");
    ASSERT_TRUE(wait([&] { return figure("Samples written").toInt() > 20; }));
    bool hasMoved = false;
    session().runProcedure(
        "move",
        [](devices::Device& device, const ProcedureObserver& observer) {
            MoveConfig config;
            config.reference = *parseMoveReference("step,amplitude_deg=100");
            config.duration_s = 1.0;
            return runMove(device, config, observer);
        },
        [&hasMoved](const Result<MoveResult>& moved) { hasMoved = moved.has_value(); });
    ASSERT_TRUE(wait([&] { return hasMoved; }));
    const int before = figure("Samples written").toInt();
    ASSERT_TRUE(
        wait([&] { return figure("Samples written").toInt() > before + 50; })); // the panels' stream again
    click(*panel, "Stop recording");
    // A warning where the change from one stream to the other took rows.
    ASSERT_TRUE(wait([&] { return message().text.contains("move.csv"); }));
    const auto file = devices::readRecordingFile(folder.filePath("move.csv").toStdString());
    ASSERT_TRUE(file) << file.error().message;
    const std::vector<double> position = file->recording.column("position");
    const auto [least, most] = std::minmax_element(position.begin(), position.end());
    EXPECT_GT(*most - *least, 1.5); // rad, of a step of 100 degrees = 1.75
    std::uint64_t lost = 0;
    for (const auto& gap : file->meta.gaps) {
        lost += gap.lostRows;
    }
    EXPECT_EQ(lost, file->recording.lostRows); // what is missing is marked, no more and no less
}

TEST_F(RecordPanelTest, aDiskThatDoesNotKeepUpIsAnErrorWhileItHappensAndAtTheEnd) {
    std::atomic<bool> isStuck = true;
    devices::DiskAccess disk = devices::realDisk();
    disk.write = [&isStuck](QFile& file, std::string_view octets) {
        while (isStuck && !octets.starts_with("time_s")) {
            std::this_thread::yield();
        }
        return devices::realDisk().write(file, octets);
    };
    bench().recording().setDisk(disk);
    bench().recording().setQueueRows(200);
    connectTo("sim:htm", 20.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Start recording")->isEnabled(); }));
    type(find<QLineEdit>(*panel, "Name of the recording"), "slow");
    click(*panel, "Start recording");
    ASSERT_TRUE(wait([&] { return message().severity == widgets::Severity::Error; }));
    EXPECT_TRUE(message().text.contains("too slow"));
    isStuck = false;
    click(*panel, "Stop recording");
    ASSERT_TRUE(wait([&] { return message().text.contains("slow.csv"); }));
    EXPECT_EQ(message().severity, widgets::Severity::Error);
    EXPECT_TRUE(message().remedy.contains("because of a slow disk")) << message().remedy.toStdString();
    const auto file = devices::readRecordingFile(folder.filePath("slow.csv").toStdString());
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_GT(file->meta.droppedRows, 0U);
}

TEST_F(RecordPanelTest, theTimeBeforeTheStartIsInTheRecordingAndItsEndIsMarked) {
    connectTo("sim:htm", 5.0);
    set("Pre-trigger time", "2");
    ASSERT_TRUE(wait([&] { return bench().recording().held_s() >= 2.0; }));
    EXPECT_TRUE(wait([&] { return figure("Trigger event of the recording").contains("2.0 of 2.0 s"); }));
    type(find<QLineEdit>(*panel, "Name of the recording"), "before");
    click(*panel, "Start recording");
    ASSERT_TRUE(wait([&] { return figure("Samples written").toInt() > 250; }));
    click(*panel, "Stop recording");
    ASSERT_TRUE(wait([&] { return message().severity == widgets::Severity::Success; }));
    const auto file = recorded("before");
    EXPECT_TRUE(file.meta.gaps.empty()) << "the stream did not change when the recording started";
    ASSERT_EQ(file.meta.markers.size(), 1U);
    EXPECT_EQ(file.meta.markers[0].text, "record");
    // One row of the stream, at 1 kHz, may be cut off where the two seconds begin.
    EXPECT_NEAR(file.meta.markers[0].time_s, 2.0, 1e-3 + 1e-9);
}

TEST_F(RecordPanelTest, aRecordingAtTheTriggerWaitsForItAndEndsByItself) {
    connectTo("sim:htm?hall_noise_mT=2", 5.0);
    TriggerChoice choice;
    choice.source = "hall.a";
    choice.level = 1.0; // T: more than there ever is
    bench().recordingTrigger().setChoice(choice, "Hall A rises through 1000 mT");
    set("Pre-trigger time", "1");
    find<QComboBox>(*panel, "Start of the recording")->setCurrentIndex(1);
    set("Post-trigger time", "0.5");
    EXPECT_TRUE(figure("Trigger event of the recording").startsWith("Begins when Hall A rises"));
    type(find<QLineEdit>(*panel, "Name of the recording"), "event");
    click(*panel, "Wait for the trigger");
    EXPECT_TRUE(bench().recording().isWaiting());
    // What is shown lags behind what is held: only then is the whole second there before any event.
    const double begin_s = bench().history().range()->end_s;
    ASSERT_TRUE(wait([&] { return bench().history().range()->end_s > begin_s + 1.5; }));
    EXPECT_EQ(bench().recording().held_s(), 1.0);
    EXPECT_FALSE(bench().recording().isRecording());
    EXPECT_TRUE(figure("Trigger event of the recording").startsWith("Waiting until Hall A rises"));
    choice.level = bench().history().latest("hall.a")->value; // in its noise: passed within a few samples
    bench().recordingTrigger().setChoice(choice, "Hall A rises");
    ASSERT_TRUE(wait([&] { return message().severity == widgets::Severity::Success; }));
    EXPECT_FALSE(bench().recording().isWaiting());
    const auto file = recorded("event");
    EXPECT_TRUE(file.meta.gaps.empty());
    ASSERT_EQ(file.meta.markers.size(), 1U);
    EXPECT_EQ(file.meta.markers[0].text, "trigger");
    EXPECT_NEAR(file.meta.markers[0].time_s, 1.0, 1e-3 + 1e-9);
    // Rows 10 ms apart from the first one to half a second behind the event.
    EXPECT_GT(file.recording.time_s.back(), 1.5 - 0.011 - 1e-3);
    EXPECT_LT(file.recording.time_s.back(), 1.5);
}

TEST_F(RecordPanelTest, aWaitThatIsEndedLeavesNothing) {
    connectTo("sim:htm", 5.0);
    find<QComboBox>(*panel, "Start of the recording")->setCurrentIndex(1);
    click(*panel, "Wait for the trigger");
    EXPECT_FALSE(find<QComboBox>(*panel, "Start of the recording")->isEnabled());
    click(*panel, "Cancel the wait");
    EXPECT_FALSE(bench().recording().isWaiting());
    click(*panel, "Wait for the trigger");
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    EXPECT_FALSE(bench().recording().isWaiting());
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST_F(RecordPanelTest, aFolderThatCannotBeMadeIsSaidInPlace) {
    QFile file(folder.filePath("file"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.close();
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Start recording")->isEnabled(); }));
    type(find<QLineEdit>(*panel, "Folder of recordings"), folder.filePath("file/below"));
    click(*panel, "Start recording");
    ASSERT_TRUE(wait([&] { return message().severity == widgets::Severity::Error; }));
    EXPECT_TRUE(message().text.contains("below"));
    EXPECT_TRUE(wait([&] { return find<QPushButton>(*panel, "Start recording")->isEnabled(); }));
    EXPECT_EQ(session().state(), SessionState::Connected); // nothing else is disturbed
}

/// Two windows on one folder: the second finds its name before the first has a file.
TEST_F(RecordPanelTest, anotherWindowThatBeginsInTheSameMomentGetsANameOfItsOwn) {
    Workbench other;
    connectTo("sim:htm", 5.0);
    other.session().connectDevice("sim:htm?seed=2", {5.0});
    ASSERT_TRUE(wait([&] { return other.session().state() == SessionState::Connected; }));
    RecordingControl& first = bench().recording();
    RecordingControl& second = other.recording();
    for (RecordingControl* one : {&first, &second}) {
        one->setFolder(folder.path());
        one->setNameMask("run {number}");
        one->start();
    }
    EXPECT_NE(first.path(), second.path());
    ASSERT_TRUE(wait([&] { return first.status().rows > 10 && second.status().rows > 10; }));
    first.stop();
    second.stop();
    ASSERT_TRUE(wait([&] { return !first.isRecording() && !second.isRecording(); }));
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files, QDir::Name),
              QStringList({"run 001.csv", "run 001.meta.json", "run 002.csv", "run 002.meta.json"}));
}

} // namespace
} // namespace halbench::app
