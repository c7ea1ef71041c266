#include "app/procedures/move/move_procedure.h"
#include "app/window/docks/dock_layout.h"
#include "app/window/docks/panels.h"
#include "app/window/help/help_window.h"
#include "app/window/main_window.h"
#include "app/window/project/project_menu.h"
#include "app/workspaces/device/device_panel.h"
#include "app/workspaces/device/notes_panel.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/stop_button.h"

#include <QDialog>
#include <QFile>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QTemporaryDir>
#include <qtadvanceddocking/DockWidget.h>
#include <qwt_plot_canvas.h>

#include <functional>
#include <future>
#include <utility>

namespace halbench::app {
namespace {

/// Tells when the widget is hidden.
class HideWatch : public QObject {
public:
    explicit HideWatch(std::function<void()> told) : m_told(std::move(told)) {}

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Hide) {
            m_told();
        }
        return QObject::eventFilter(watched, event);
    }

private:
    std::function<void()> m_told;
};

/// Counts the paints of what it watches.
class PaintCount : public QObject {
public:
    int count = 0;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        count += event->type() == QEvent::Paint ? 1 : 0;
        return QObject::eventFilter(watched, event);
    }
};

class MainWindowTest : public WindowTest {
protected:
    void startMove() {
        session().runProcedure(
            "move",
            [](devices::Device& device, const ProcedureObserver& observer) {
                MoveConfig config;
                config.reference = *parseMoveReference("sine,amplitude_deg=100,period_s=2");
                config.duration_s = 30.0;
                return runMove(device, config, observer);
            },
            [this](Result<MoveResult> result) { moved = std::move(result); });
        ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    }

    std::optional<Result<MoveResult>> moved;
};

TEST_F(MainWindowTest, aMinimisedWindowDrawsNothingAndStillTakesItsSamples) {
    open();
    connectMotor(1.0);
    PaintCount paints;
    for (QWidget* canvas : window->docks().panel("monitor")->findChildren<QwtPlotCanvas*>()) {
        canvas->installEventFilter(&paints);
    }
    ASSERT_TRUE(wait([&] { return paints.count > 3; }));
    window->showMinimized();
    settle();
    paints.count = 0;
    const std::uint64_t before = window->bench().history().revision();
    ASSERT_TRUE(wait([&] { return window->bench().history().revision() > before + 3; }));
    EXPECT_EQ(paints.count, 0);
    window->showNormal();
    EXPECT_TRUE(wait([&] { return paints.count > 3; }));
}

TEST_F(MainWindowTest, enterInTheDeviceListConnectsTheSimulatedMotor) {
    open();
    auto* list = window->findChild<DevicePanel*>()->findChild<QListWidget*>();
    QTest::keyClick(list, Qt::Key_Return);
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    EXPECT_TRUE(session().info().isSimulated);
}

// From a display of twice the size, or the same one at half the scale.
TEST_F(MainWindowTest, aPlaceThatWasKeptElsewhereIsBroughtOntoTheScreen) {
    open();
    const QRect room = window->screen()->availableGeometry();
    window->setGeometry(room.right() - 40, room.bottom() - 40, 3 * room.width(), 3 * room.height());
    Preferences kept;
    kept.geometry = window->saveGeometry();
    MainWindow again(kept);
    EXPECT_TRUE(room.contains(again.pos())) << again.x() << ", " << again.y();
    EXPECT_LE(again.width(), std::max(room.width(), again.minimumSizeHint().width()));
    EXPECT_LE(again.height(), std::max(room.height(), again.minimumSizeHint().height()));
}

/// As a program does that ends without closing its window. A memory checker sees what a panel touches then.
TEST_F(MainWindowTest, aWindowThatGoesUnclosedHidesItsPanelsWhileTheirBenchIsThere) {
    open();
    connectMotor(5.0);
    for (const char* panel : {"xy", "spectrum"}) {
        window->docks().docks().value(QString::fromLatin1(panel))->setAsCurrentTab();
    }
    QWidget* seen = window->docks().panel("spectrum");
    ASSERT_TRUE(wait([&] { return seen->isVisible(); }));
    bool isBenchThere = false;
    const QObject* bench = &window->bench();
    bool isBenchGone = false;
    QObject::connect(bench, &QObject::destroyed, qApp, [&] { isBenchGone = true; });
    HideWatch watch([&] { isBenchThere = !isBenchGone; });
    seen->installEventFilter(&watch);
    window.reset();
    EXPECT_TRUE(isBenchThere);
}

/// The same of a panel in a window of its own, which is not hidden with the one it belongs to.
TEST_F(MainWindowTest, aWindowThatGoesHidesItsFloatingPanelsWhileTheirBenchIsThere) {
    open();
    connectMotor(5.0);
    window->docks().docks().value("spectrum")->setFloating();
    QWidget* seen = window->docks().panel("spectrum");
    ASSERT_TRUE(wait([&] { return seen->isVisible(); }));
    bool isBenchThere = false;
    bool isBenchGone = false;
    QObject::connect(&window->bench(), &QObject::destroyed, qApp, [&] { isBenchGone = true; });
    HideWatch watch([&] { isBenchThere = !isBenchGone; });
    seen->installEventFilter(&watch);
    window.reset();
    EXPECT_TRUE(isBenchThere);
}

TEST_F(MainWindowTest, theListMarksTheDeviceThatIsConnectedAndNoOther) {
    open();
    auto* devices = window->findChild<DevicePanel*>();
    auto* list = devices->findChild<QListWidget*>();
    // Two rows fit whole, however few there are: half a row looks like the last one.
    EXPECT_GE(list->viewport()->height(), 2 * list->visualItemRect(list->item(0)).height());
    list->setCurrentRow(list->count() - 1);
    window->connectDevice("sim:htm");
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    ASSERT_NE(list->currentItem(), nullptr);
    EXPECT_EQ(list->currentItem()->data(Qt::UserRole).toString(), "sim:htm");
    devices->toggleConnection();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    window->connectDevice("sim:htm?seed=9"); // not in the list
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    EXPECT_EQ(list->currentItem(), nullptr);
}

TEST_F(MainWindowTest, escapeStopsWhateverHasTheFocus) {
    open();
    connectMotor(1.0);
    startMove();
    QTest::keyClick(window->findChild<DevicePanel*>(), Qt::Key_Escape);
    ASSERT_TRUE(wait([&] { return moved.has_value(); }));
    EXPECT_FALSE(*moved);
    EXPECT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
}

TEST_F(MainWindowTest, escapeInAModalDialogClosesItAndStops) {
    open();
    connectMotor(1.0);
    startMove();
    QDialog dialog(window.get());
    dialog.setModal(true);
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog.isVisible());
    EXPECT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
}

TEST_F(MainWindowTest, theStopButtonIsThereInEveryPerspectiveAtTheSamePlace) {
    open();
    auto* stop = window->findChild<widgets::StopButton*>();
    const QPoint place = stop->mapTo(window.get(), QPoint());
    for (const Perspective perspective : AllPerspectives) {
        window->docks().setPerspective(perspective);
        QTest::qWait(0);
        EXPECT_TRUE(stop->isVisible());
        EXPECT_EQ(stop->mapTo(window.get(), QPoint()), place) << perspectiveId(perspective).toStdString();
    }
}

TEST_F(MainWindowTest, aLatchedStopIsReleasedOnPurposeAndNeverByStop) {
    Preferences preferences;
    preferences.stopLockOut_ms = 0;
    open(preferences);
    connectMotor(1.0);
    startMove();
    auto* stop = window->findChild<widgets::StopButton*>();
    QTest::mouseClick(stop, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return stop->isLatched(); }));
    EXPECT_FALSE(session().report().board.isArmed);
    QPushButton* release = nullptr;
    for (auto* button : window->findChildren<QPushButton*>()) {
        release = button->text() == "Release" ? button : release;
    }
    ASSERT_NE(release, nullptr);
    const QPoint place = stop->mapTo(window.get(), QPoint());
    ASSERT_TRUE(wait([&] { return release->isEnabled(); })); // the lock-out has passed
    QTest::mouseClick(stop, Qt::LeftButton);
    QTest::qWait(300); // three reports of the board
    EXPECT_TRUE(stop->isLatched());
    ASSERT_TRUE(wait([&] { return release->isEnabled(); }));
    EXPECT_TRUE(release->isVisible());
    QTest::mouseClick(release, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return !stop->isLatched(); }));
    EXPECT_FALSE(session().report().board.isArmed); // released, not armed
    EXPECT_FALSE(release->isVisible());
    EXPECT_EQ(stop->mapTo(window.get(), QPoint()), place); // nothing moved to make room
}

TEST_F(MainWindowTest, fitsItsFirstSizeInEveryPerspective) {
    const auto theme = widgets::loadTheme("light"); // the program's letters
    ASSERT_TRUE(theme);
    widgets::applyTheme(application, *theme, {QLocale(), widgets::Dress().fontSize_pt});
    open();
    connectMotor(1.0);
    for (const Perspective perspective : AllPerspectives) {
        window->docks().setPerspective(perspective);
        QTest::qWait(50);
        EXPECT_EQ(window->size(), QSize(1440, 900)) << perspectiveId(perspective).toStdString();
        // The data get at least half of the width.
        const auto* centre = window->docks().docks().value(perspective == Perspective::Identify ? "identify"
                                                           : perspective == Perspective::Tune   ? "tune"
                                                           : perspective == Perspective::Field  ? "field"
                                                                                                : "monitor");
        EXPECT_GE(centre->width(), 700) << perspectiveId(perspective).toStdString();
    }
}

TEST_F(MainWindowTest, focusNeverFallsToStopWhenThePerspectiveChanges) {
    open();
    QApplication::setActiveWindow(window.get());
    connectMotor(1.0);
    for (const Perspective perspective : {Perspective::Tune, Perspective::Field, Perspective::Identify,
                                          Perspective::Record, Perspective::Monitor}) {
        window->docks().panel(perspectiveId(window->docks().perspective()))->setFocus();
        window->docks().setPerspective(perspective);
        QTest::qWait(0);
        EXPECT_EQ(qobject_cast<widgets::StopButton*>(QApplication::focusWidget()), nullptr);
    }
}

TEST_F(MainWindowTest, quittingKeepsTheWindowWithItsStopUntilWhatRunsHasEnded) {
    std::promise<void> fit; // takes longer than anybody waits
    open();
    connectMotor(1.0);
    session().runProcedure(
        "fit",
        [running = fit.get_future().share()](devices::Device& device, const ProcedureObserver&) {
            Result<void> armed = device.arm();
            running.wait();
            return armed;
        },
        [](const Result<void>&) {});
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    window->close();
    ASSERT_TRUE(wait([&] { return !session().report().board.isArmed; })); // at once, and the window lives
    EXPECT_TRUE(window->findChild<widgets::StopButton*>()->isVisible());
    const auto bars = window->findChildren<widgets::MessageBar*>();
    EXPECT_TRUE(std::any_of(bars.begin(), bars.end(), [](const widgets::MessageBar* bar) {
        return bar->isVisible() && bar->message().text.contains("closes after");
    }));
    fit.set_value();
    EXPECT_TRUE(wait([&] { return !window->isVisible(); }));
}

TEST_F(MainWindowTest, theViewMenuHasThePanelsInOneOrder) {
    open();
    QStringList titles;
    for (const QAction* action : window->menuBar()->actions().at(2)->menu()->actions()) {
        if (action->isSeparator()) {
            break;
        }
        titles << action->text();
    }
    QStringList expected;
    for (const PanelSpec& panel : panelSpecs()) {
        expected << panel.title;
    }
    EXPECT_EQ(titles, expected);
}

TEST_F(MainWindowTest, anArrangementIsKeptPerPerspective) {
    open();
    const auto* log = window->docks().docks().value("log");
    window->docks().unfold("log");
    window->docks().setPerspective(Perspective::Tune);
    EXPECT_TRUE(log->isClosed());
    window->docks().setPerspective(Perspective::Monitor);
    EXPECT_FALSE(log->isClosed());
    window->docks().reset();
    EXPECT_TRUE(log->isClosed());
}

TEST_F(MainWindowTest, aDamagedArrangementIsLeftOutAndThePanelsStay) {
    open();
    window->docks().setArrangements({{"monitor", "not a layout"}});
    EXPECT_FALSE(window->docks().docks().value("devices")->isClosed());
}

TEST_F(MainWindowTest, aProjectBringsBackDeviceNotesAndArrangement) {
    QTemporaryDir folder;
    const QString path = folder.filePath("motor.toml");
    Project project;
    project.device = "sim:htm?seed=9";
    project.notes = "bearing greased";
    project.recording = {2.0, true, 5.0};
    ASSERT_TRUE(saveProject(project, path.toStdString()));
    open();
    window->openProject(path);
    EXPECT_EQ(window->findChild<DevicePanel*>()->address(), "sim:htm?seed=9");
    EXPECT_EQ(static_cast<NotesPanel*>(window->docks().panel("notes"))->notes(), "bearing greased");
    EXPECT_EQ(session().state(), SessionState::Disconnected); // opening a file moves nothing
    EXPECT_EQ(window->bench().recording().choice(), project.recording);
    window->bench().recording().setChoice({2.0, true, 7.0});
    Q_EMIT window->findChild<ProjectMenu*>()->collecting();
    EXPECT_EQ(window->project().project().recording, (RecordingChoice{2.0, true, 7.0}));
    EXPECT_TRUE(window->windowTitle().contains("motor.toml"));
    window.reset(); // its lock is in the folder
}

TEST_F(MainWindowTest, whatAProjectSaysOfRecordingsHoldsAfterThePresentOne) {
    QTemporaryDir folder;
    Project project;
    project.recording = {2.0, true, 5.0};
    const QString path = folder.filePath("motor.toml");
    ASSERT_TRUE(saveProject(project, path.toStdString()));
    open();
    connectMotor(5.0);
    RecordingControl& recording = window->bench().recording();
    recording.setFolder(folder.path());
    recording.start();
    ASSERT_TRUE(wait([&] { return recording.status().rows > 10; }));
    const RecordingChoice running = recording.choice();
    window->openProject(path);
    EXPECT_TRUE(recording.isRecording());
    EXPECT_EQ(recording.choice(), running);
    bool isSaid = false;
    for (const auto* bar : window->findChildren<widgets::MessageBar*>()) {
        isSaid |= bar->isVisible() && bar->message().text.contains("from the next recording on");
    }
    EXPECT_TRUE(isSaid);
    Q_EMIT window->findChild<ProjectMenu*>()->collecting(); // saved meanwhile
    EXPECT_EQ(window->project().project().recording, project.recording);
    recording.stop();
    ASSERT_TRUE(wait([&] { return !recording.isRecording(); }));
    EXPECT_EQ(recording.choice(), project.recording);
    window.reset(); // its lock is in the folder
}

TEST_F(MainWindowTest, aDamagedProjectIsSaidInPlaceAndNothingIsLost) {
    QTemporaryDir folder;
    const QString path = folder.filePath("motor.toml");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("schema = \"halbench.project/9\"");
    file.close();
    open();
    static_cast<NotesPanel*>(window->docks().panel("notes"))->setNotes("mine");
    window->openProject(path);
    window->project().finishWriting(); // what was open is kept first
    EXPECT_EQ(static_cast<NotesPanel*>(window->docks().panel("notes"))->notes(), "mine");
    const auto bars = window->findChildren<widgets::MessageBar*>();
    EXPECT_TRUE(std::any_of(bars.begin(), bars.end(), [](const widgets::MessageBar* bar) {
        return bar->isVisible() && bar->message().text.contains("newer");
    }));
}

} // namespace
} // namespace halbench::app
