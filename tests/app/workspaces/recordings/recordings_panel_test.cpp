#include "app/workbench/drive_control.h"
#include "app/workbench/recording_folders.h"
#include "app/workbench/shown_recording.h"
#include "app/workspaces/recordings/recordings_panel.h"
#include "app/workspaces/recordings/recordings_table_model.h"
#include "app/workspaces/recordings/run_overlay.h"
#include "devices/formats/recording_file.h"
#include "devices/recording/recording_writer.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/figure/figure_view.h"

#include <QAbstractButton>
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

class RecordingsPanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        bench().recording().setFolder(folder.path());
    }
    void TearDown() override { panel.reset(); }

    /// Ten seconds at 100 Hz; the position is the amplitude times the time.
    void write(const QString& name, double amplitude,
               std::vector<devices::RecordingMeta::Marker> markers = {}) {
        Recording recording;
        recording.layout = std::make_shared<const StreamLayout>(
            StreamLayout{{{"position", "rad"}, {"current.command", "A"}}, 0.01});
        for (int row = 0; row < 1000; ++row) {
            recording.time_s.push_back(row / 100.0);
            recording.values.insert(recording.values.end(), {amplitude * row / 100.0, 1.0});
        }
        devices::RecordingMeta meta;
        meta.device.model = "htm";
        meta.device.id = "HB-17";
        meta.started = "2026-01-01T00:00:00Z";
        meta.signals = {{"position", "position_rad", "rad", "position"},
                        {"current.command", "current_command_A", "A", "current.command"}};
        meta.markers = std::move(markers);
        ASSERT_TRUE(
            devices::writeRecordingFile(folder.filePath(name + ".csv").toStdString(), recording, meta));
    }
    void open() {
        panel = std::make_unique<RecordingsPanel>(bench());
        panel->resize(1000, 800);
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
    }
    QTableView* table() { return find<QTableView>(*panel, "Recordings"); }
    bool listed(int count) {
        return wait([&] { return table()->model()->rowCount() == count; });
    }
    widgets::Message message() {
        return panel->findChild<widgets::MessageBar*>("recordings_message")->message();
    }

    QTemporaryDir folder;
    std::unique_ptr<RecordingsPanel> panel;
};

TEST_F(RecordingsPanelTest, whatWasInterruptedIsFoundInTheDefaultFolderTooAndItIsSaidWhere) {
    const QByteArray before = qgetenv("HOME");
    QTemporaryDir home;
    qputenv("HOME", home.path().toUtf8());
    ASSERT_TRUE(defaultRecordingFolder().startsWith(home.path())) << defaultRecordingFolder().toStdString();
    const QString elsewhere = QDir(defaultRecordingFolder()).filePath("lost.csv");
    ASSERT_TRUE(QDir().mkpath(defaultRecordingFolder()));
    for (const QString& path : {elsewhere, folder.filePath("here.csv")}) {
        const auto layout = std::make_shared<const StreamLayout>(StreamLayout{{{"position", "rad"}}, 0.01});
        auto writer = devices::RecordingWriter::create(path.toStdString(), *layout, {});
        ASSERT_TRUE(writer);
        ASSERT_TRUE((*writer)->append({layout, {0.0, 0.01, 0.02}, {1.0, 2.0, 3.0}, 0.0, 0}));
    } // as a killed program leaves it
    QStringList said;
    QObject::connect(&session(), &DeviceSession::message, &session(),
                     [&](MessageLevel, const QString&, const QString& text) { said << text; });
    open();
    ASSERT_TRUE(wait([&] { return said.size() == 2; }));
    EXPECT_TRUE(QFile::exists(elsewhere));
    EXPECT_TRUE(QFile::exists(folder.filePath("here.csv")));
    EXPECT_EQ(said.filter(QDir(elsewhere).path()).size(), 1) << "it is said from where";
    EXPECT_TRUE(interruptedIn(defaultRecordingFolder()).isEmpty());
    qputenv("HOME", before);
}

TEST_F(RecordingsPanelTest, greyedButtonsSayWhy) {
    write("one", 1.0);
    write("two", 2.0);
    open();
    ASSERT_TRUE(listed(2));
    const auto isSaid = [&](const QString& words) {
        const auto labels = panel->findChildren<widgets::ElidedLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const auto* label) { return label->words().contains(words); });
    };
    const auto* open = find<QPushButton>(*panel, "Open");
    EXPECT_FALSE(open->isEnabled());
    EXPECT_TRUE(isSaid("Select a recording"));
    table()->selectAll();
    EXPECT_FALSE(open->isEnabled());
    EXPECT_TRUE(isSaid("select one"));
    table()->selectRow(0);
    EXPECT_TRUE(open->isEnabled());
    EXPECT_FALSE(isSaid("elect"));
}

TEST_F(RecordingsPanelTest, theMenuOfTheListCopiesThePathAndTheRow) {
    write("one", 1.0);
    open();
    ASSERT_TRUE(listed(1));
    EXPECT_EQ(table()->contextMenuPolicy(), Qt::ActionsContextMenu);
    EXPECT_LE(table()->actions().size(), 10);
    table()->selectRow(0);
    const auto choose = [&](const QString& words) {
        for (QAction* action : table()->actions()) {
            if (action->text() == words) {
                action->trigger();
            }
        }
        return QGuiApplication::clipboard()->text();
    };
    EXPECT_EQ(choose("Copy path"), QDir::toNativeSeparators(folder.filePath("one.csv")));
    EXPECT_TRUE(choose("Copy rows").startsWith("one"));
}

TEST_F(RecordingsPanelTest, findsARecordingByItsWords) {
    write("cold", 1.0);
    write("warm", 2.0);
    open();
    ASSERT_TRUE(listed(2));
    QTest::keyClick(panel.get(), Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(find<QLineEdit>(*panel, "Search recordings"), "HB-17 war");
    EXPECT_EQ(table()->model()->rowCount(), 1);
    EXPECT_EQ(table()->model()->index(0, 0).data(), "warm");
    // The clear button fades in; until it has, Qt's animation belongs to nobody and counts as a leak.
    const auto* clear = find<QLineEdit>(*panel, "Search recordings")->findChild<QAbstractButton*>();
    ASSERT_NE(clear, nullptr);
    EXPECT_TRUE(wait([&] { return clear->property("opacity").toDouble() >= 1.0; }));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

TEST_F(RecordingsPanelTest, severalRecordingsAreSeenInALowWindowHoweverLongTheirMarkersAre) {
    for (int i = 0; i < 6; ++i) {
        write(QStringLiteral("run%1").arg(i), 1.0, {{1.0, std::string(200, 'x')}});
    }
    open();
    panel->resize(700, 450); // the centre of a window of 1366 x 768
    ASSERT_TRUE(listed(6));
    QApplication::processEvents();
    const QRect third = table()->visualRect(table()->model()->index(2, 0));
    EXPECT_LE(third.bottom(), table()->viewport()->height());
    table()->selectAll();
    auto* align = find<QComboBox>(*panel, "Alignment of the recordings");
    ASSERT_TRUE(wait([&] { return align->count() == 2; }));
    QApplication::processEvents();
    const auto* shown = find<QComboBox>(*panel, "Range");
    EXPECT_LE(shown->mapTo(panel.get(), shown->rect().bottomRight()).x(), 700);
}

// Neither moves anything nor leaves the device that is connected.
TEST_F(RecordingsPanelTest, aRecordingIsHandedToTuneForAWhatIf) {
    write("run", 1.0);
    open();
    ASSERT_TRUE(listed(1));
    QSignalSpy asked(panel.get(), &RecordingsPanel::whatIfRequested);
    auto* whatIf = find<QPushButton>(*panel, "What-if");
    ASSERT_NE(whatIf, nullptr);
    EXPECT_FALSE(whatIf->isEnabled()) << "nothing is selected";
    table()->selectRow(0);
    ASSERT_TRUE(wait([&] { return whatIf->isEnabled(); }));
    QTest::mouseClick(whatIf, Qt::LeftButton);
    ASSERT_EQ(asked.count(), 1);
    EXPECT_EQ(asked.at(0).at(0).toString(), folder.filePath("run.csv"));
    EXPECT_EQ(bench().session().state(), SessionState::Disconnected);
}

TEST_F(RecordingsPanelTest, tagsAndNotesGoIntoTheSidecar) {
    write("run", 1.0);
    open();
    ASSERT_TRUE(listed(1));
    auto* tags = find<QLineEdit>(*panel, "Tags of the recording");
    panel->findChild<QTabWidget*>()->setCurrentIndex(2);
    EXPECT_FALSE(tags->isEnabled()) << "nothing is selected";
    table()->selectRow(0);
    QTest::keyClicks(tags, "cold, first");
    QTest::keyClicks(find<QPlainTextEdit>(*panel, "Notes on the recording"), "new bearing");
    const auto saved = [&] {
        const auto file = devices::readRecordingFile(folder.filePath("run.csv").toStdString());
        return file && file->meta.tags == std::vector<std::string>{"cold", "first"} &&
               file->meta.notes == "new bearing";
    };
    EXPECT_TRUE(wait(saved));
    EXPECT_EQ(tags->text(), "cold, first") << "what is typed stays as it is";
}

TEST_F(RecordingsPanelTest, enterOpensAllOfARecordingAtOnce) {
    write("run", 1.0);
    open();
    ASSERT_TRUE(listed(1));
    table()->selectRow(0);
    table()->setFocus();
    QTest::keyClick(table(), Qt::Key_Return);
    ASSERT_TRUE(wait([&] { return bench().shownRecording().file() && !bench().shownRecording().isBusy(); }));
    EXPECT_NEAR(bench().history().range()->end_s, 9.99, 1e-9);
    EXPECT_NEAR(bench().history().valueAt("position", 5.0)->value, 5.0, 1e-6);
}

TEST_F(RecordingsPanelTest, controlReturnPlaysARecordingInThePanelsFromWhereItIsAsked) {
    write("run", 1.0);
    open();
    ASSERT_TRUE(listed(1));
    bench().setPace({20.0});
    table()->selectRow(0);
    table()->setFocus();
    QTest::keyClick(table(), Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return session().info().transport == "replay"; }));
    bench().liveSignals().want(panel.get(), {"position"});
    ASSERT_TRUE(wait([&] { return bench().history().latest("position").has_value(); }));
    EXPECT_NEAR(bench().history().latest("position")->value, bench().history().latest("position")->time_s,
                1e-6); // the position is the time
    auto* from = find<widgets::QuantityEdit>(*panel, "Start at");
    from->setFocus();
    from->selectAll();
    QTest::keyClicks(from, "8");
    QTest::keyClick(from, Qt::Key_Return);
    ASSERT_TRUE(wait([&] {
        const auto range = bench().history().range("position");
        return range && range->begin_s >= 8.0;
    })) << "the time axis is that of the recording";
    EXPECT_NEAR(bench().history().latest("position")->value, bench().history().latest("position")->time_s,
                1e-6);
}

TEST_F(RecordingsPanelTest, whereToBeginIsOfOneRecording) {
    write("cold", 1.0);
    write("warm", 2.0);
    open();
    ASSERT_TRUE(listed(2));
    auto* from = find<widgets::QuantityEdit>(*panel, "Start at");
    table()->selectRow(0);
    from->setValue(3.0);
    QTest::keyClick(panel.get(), Qt::Key_F5);
    EXPECT_EQ(from->value(), 3.0);
    click(*panel, "Replay");
    EXPECT_TRUE(wait([&] { return session().report().deviceTime_s >= 3.0; }));
    table()->selectRow(1);
    EXPECT_EQ(from->value(), 0.0);
}

TEST_F(RecordingsPanelTest, aReplayLastsAsLongAsTheRecordingAtItsSpeed) {
    write("run", 1.0);
    open();
    ASSERT_TRUE(listed(1));
    bench().setPace({1.0});
    table()->selectRow(0);
    click(*panel, "Replay");
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    ASSERT_TRUE(wait([&] { return session().report().deviceTime_s > 0.05; }));
    EXPECT_LT(session().report().deviceTime_s, 9.0) << "not all of it at once";
    bench().setPace({100.0});
    EXPECT_TRUE(wait([&] { return session().report().deviceTime_s > 9.0; }));
}

TEST_F(RecordingsPanelTest, selectedRecordingsAreLaidOverEachOtherWithOneCursor) {
    write("cold", 1.0, {{1.0, "record"}, {2.0, "knock"}});
    write("warm", 2.0, {{5.0, "knock"}});
    open();
    ASSERT_TRUE(listed(2));
    table()->selectAll();
    auto* view = panel->findChild<widgets::FigureView*>();
    ASSERT_TRUE(wait([&] { return !view->isEmpty(); }));
    EXPECT_EQ(view->figure().panels[0].curves.size(), 2U);
    auto* align = find<QComboBox>(*panel, "Alignment of the recordings");
    const int knock = align->findText("marker: knock");
    ASSERT_GE(knock, 0);
    align->setCurrentIndex(knock);
    auto* cursor = find<widgets::QuantityEdit>(*panel, "Time of the cursor");
    cursor->setValue(1.0);
    auto* values = find<QTableWidget>(*panel, "Values at the cursor");
    ASSERT_EQ(values->rowCount(), 2);
    // one second after the knock: position 3 rad of the cold run, 12 rad of the warm one, in degrees
    for (int row = 0; row < 2; ++row) {
        const bool isCold = values->item(row, 0)->text() == "cold";
        const double expected_deg = (isCold ? 3.0 : 12.0) * 180.0 / M_PI;
        EXPECT_NEAR(values->item(row, 1)->text().section(' ', 0, 0).toDouble(), expected_deg, 1e-2)
            << values->item(row, 1)->text().toStdString();
    }
    auto* span = find<QComboBox>(*panel, "Range");
    span->setCurrentIndex(span->findData(0.1));
    EXPECT_TRUE(wait([&] { return view->figure().x.max == 1.05; })) << "so much about the cursor";
    align->setCurrentIndex(align->findText("trigger"));
    EXPECT_TRUE(wait([&] { return view->figure().panels[0].curves.size() == 1; })) << "the other has none";
    cursor->setValue(500.0);
    EXPECT_TRUE(wait([&] { return !view->isVisible(); })) << "nothing was recorded then";
}

TEST_F(RecordingsPanelTest, aTriggerIsOfferedOnlyWhenThereIsOne) {
    write("run", 1.0);
    open();
    ASSERT_TRUE(listed(1));
    table()->selectRow(0);
    auto* align = find<QComboBox>(*panel, "Alignment of the recordings");
    ASSERT_TRUE(wait([&] { return align->count() > 0; }));
    EXPECT_EQ(align->findText("trigger"), -1);
}

TEST_F(RecordingsPanelTest, anArmedDeviceIsNotLeftForARecording) {
    write("run", 1.0);
    open();
    ASSERT_TRUE(listed(1));
    table()->selectRow(0);
    connectTo("sim:htm", 20.0);
    auto* play = find<QPushButton>(*panel, "Replay");
    EXPECT_TRUE(wait([&] { return play->isEnabled(); }));
    bench().drive().arm();
    ASSERT_TRUE(wait([&] { return bench().drive().isArmed(); }));
    EXPECT_TRUE(wait([&] { return !play->isEnabled(); }));
    table()->setFocus();
    QTest::keyClick(table(), Qt::Key_Return);
    QTest::keyClick(table(), Qt::Key_Return, Qt::ControlModifier);
    EXPECT_FALSE(bench().shownRecording().isBusy());
    EXPECT_EQ(session().info().transport, "loopback");
    panel->open(folder.filePath("run.csv")); // dropped on the window, or from its start page
    EXPECT_TRUE(wait([&] { return message().remedy == "Disarm the device first."; }))
        << message().text.toStdString();
    EXPECT_EQ(session().info().transport, "loopback");
    bench().drive().disarm();
    EXPECT_TRUE(wait([&] { return play->isEnabled(); }));
}

TEST_F(RecordingsPanelTest, moreRecordingsThanCanBeToldApartAreNotRead) {
    for (int i = 0; i < 18; ++i) {
        write(QStringLiteral("run%1").arg(i), 1.0);
    }
    open();
    ASSERT_TRUE(listed(18));
    table()->selectAll();
    auto* view = panel->findChild<widgets::FigureView*>();
    ASSERT_TRUE(wait([&] { return !view->isEmpty(); }));
    EXPECT_EQ(view->figure().panels[0].curves.size(), 16U);
    EXPECT_TRUE(panel->findChild<widgets::MessageBar*>("overlay_message")->message().text.contains("16"));
}

TEST_F(RecordingsPanelTest, whatAKilledProgramLeftIsRecoveredAtTheStartAndSaid) {
    Recording part;
    part.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"position", "rad"}}, 0.01});
    part.time_s = {0.0, 0.01, 0.02};
    part.values = {1.0, 2.0, 3.0};
    {
        auto writer =
            devices::RecordingWriter::create(folder.filePath("run.csv").toStdString(), *part.layout, {});
        ASSERT_TRUE(writer);
        ASSERT_TRUE((*writer)->append({part.layout, part.time_s, part.values, 0.0, 0}));
    }
    open();
    ASSERT_TRUE(wait([&] { return message().text.contains("0.02 s"); }));
    EXPECT_TRUE(message().remedy.contains("All written data were recovered"));
    ASSERT_TRUE(listed(1));
    EXPECT_TRUE(wait(
        [&] { return table()->model()->index(0, RecordingsTableModel::Gaps).data().toString().isEmpty(); }));
    EXPECT_TRUE(QFile::exists(folder.filePath("run.csv")));
}

TEST_F(RecordingsPanelTest, whatIsSelectedStaysSelectedWhenTheFolderIsReadAgain) {
    write("cold", 1.0);
    write("warm", 2.0);
    open();
    ASSERT_TRUE(listed(2));
    table()->selectAll();
    write("hot", 3.0);
    QTest::keyClick(panel.get(), Qt::Key_F5);
    ASSERT_TRUE(listed(3));
    EXPECT_EQ(table()->selectionModel()->selectedRows().size(), 2);
}

TEST_F(RecordingsPanelTest, anotherFolderIsLookedIntoAtOnce) {
    const QTemporaryDir empty;
    bench().recording().setFolder(empty.path());
    write("run", 1.0);
    open();
    bench().recording().setFolder(folder.path());
    EXPECT_TRUE(listed(1));
}

TEST_F(RecordingsPanelTest, aNewRecordingAppearsByItself) {
    open();
    ASSERT_TRUE(listed(0));
    connectTo("sim:htm", 20.0);
    bench().recording().start();
    ASSERT_TRUE(wait([&] { return bench().recording().status().rows > 20; }));
    bench().recording().stop();
    EXPECT_TRUE(listed(1));
}

TEST_F(RecordingsPanelTest, aTableOfAnotherProgramIsLookedAtBeforeItOpens) {
    QFile table(folder.filePath("bench.csv"));
    ASSERT_TRUE(table.open(QIODevice::WriteOnly));
    table.write("t_ms;Winkel [deg]\n0;0,5\n1;1,5\n2;2,5\n");
    table.close();
    open();
    ASSERT_TRUE(listed(1));
    this->table()->selectRow(0);
    click(*panel, "Open");
    ASSERT_TRUE(wait([&] { return find<QPushButton>(*panel, "Import")->isEnabled(); }));
    EXPECT_EQ(panel->findChild<QTabWidget*>()->tabText(panel->findChild<QTabWidget*>()->currentIndex()),
              "Import");
    EXPECT_TRUE(message().text.contains("another program")) << message().text.toStdString();
    click(*panel, "Import");
    ASSERT_TRUE(wait([&] { return bench().shownRecording().file() != nullptr; }));
    EXPECT_TRUE(bench().shownRecording().path().endsWith("bench-2.csv"));
    EXPECT_TRUE(listed(2));
    ASSERT_TRUE(wait([&] { return bench().history().contains("Winkel"); }));
}

} // namespace
} // namespace halbench::app
