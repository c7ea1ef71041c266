#include "app/window/docks/dock_layout.h"
#include "app/window/project/unsaved_bar.h"
#include "app/workspaces/device/log_panel.h"
#include "app/workspaces/device/notes_panel.h"
#include "tests/app/window/window_test.h"

#include <QDirIterator>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <qtadvanceddocking/DockWidget.h>

namespace halbench::app {
namespace {

/// What was done a moment ago is in what is kept, and a window that cannot keep it does not close.
class KeepingWorkTest : public WindowTest {
protected:
    void SetUp() override {
        QStandardPaths::setTestModeEnabled(false);
        qputenv("XDG_DATA_HOME", folder.path().toUtf8());
        qputenv("XDG_CONFIG_HOME", folder.path().toUtf8());
        open();
    }

    QString path(const char* file = "motor.toml") const { return folder.filePath(file); }
    std::string file(const char* called = "motor.toml") const { return path(called).toStdString(); }
    QString notes() { return static_cast<NotesPanel*>(window->docks().panel("notes"))->notes(); }

    void openNew(const char* called = "motor.toml") {
        ASSERT_TRUE(saveProject(Project(), file(called)));
        window->openProject(path(called));
        ASSERT_EQ(window->project().path(), file(called));
    }

    void type(const char* text) {
        QTest::keyClicks(window->docks().panel("notes")->findChild<QPlainTextEdit*>(), text);
    }
    void pressWithControl(Qt::Key key) { QTest::keyClick(window.get(), key, Qt::ControlModifier); }

    /// The file dialog that comes up next is answered with this file.
    void answerDialog(const QString& chosen) {
        QTimer::singleShot(0, window.get(), [chosen] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            ASSERT_NE(dialog, nullptr);
            dialog->findChild<QLineEdit*>("fileNameEdit")->setText(chosen);
            QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
        });
    }

    /// A folder in the autosave's place: what a full or vanished disk does to it.
    void blockAutosave() { ASSERT_TRUE(QDir(folder.path()).mkpath("motor.toml.autosave/full")); }

    void arm() {
        session().request([](devices::Device& device) { return device.arm(); },
                          [](const Result<void>& armed) { EXPECT_TRUE(armed); });
        ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    }
    widgets::MessageBar* saying(const char* words) {
        for (auto* bar : window->findChildren<widgets::MessageBar*>()) {
            if (bar->isVisible() && bar->message().text.contains(words)) {
                return bar;
            }
        }
        return nullptr;
    }

    widgets::MessageBar* offering(const char* action) {
        for (auto* bar : window->findChildren<widgets::MessageBar*>()) {
            if (bar->isVisible() && bar->message().actionText == action) {
                return bar;
            }
        }
        return nullptr;
    }
    void press(const char* action) {
        auto* bar = offering(action);
        ASSERT_NE(bar, nullptr) << action;
        QTest::keyClick(bar->findChild<QPushButton*>(), Qt::Key_Space);
    }

    void wantAnotherFromOneThatCannotBeKept() {
        openNew("other.toml");
        openNew();
        blockAutosave();
        type("typed");
        answerDialog(path("other.toml"));
        pressWithControl(Qt::Key_O);
        window->project().finishWriting();
        EXPECT_EQ(notes(), "typed"); // it stays open
        EXPECT_EQ(window->project().path(), file());
        EXPECT_TRUE(window->findChild<UnsavedBar*>()->isVisible());
    }

    /// Of what is offered where a project cannot be left.
    void choose(const char* words) {
        for (auto* button : window->findChild<UnsavedBar*>()->findChildren<QPushButton*>()) {
            if (button->text() == QString::fromUtf8(words)) {
                QTest::mouseClick(button, Qt::LeftButton);
            }
        }
        window->project().finishWriting();
    }

    QTemporaryDir folder;
};

TEST_F(KeepingWorkTest, savingByKeyTakesWhatWasTypedTheMomentBefore) {
    openNew();
    type("typed");
    pressWithControl(Qt::Key_S);
    window->project().finishWriting();
    EXPECT_EQ(loadProject(file())->notes, "typed");
    EXPECT_FALSE(window->isWindowModified());
    const auto* log = qobject_cast<LogPanel*>(window->docks().panel("log"));
    EXPECT_TRUE(log->text().contains("project\tsaved: ")) << log->text().toStdString();
}

TEST_F(KeepingWorkTest, aNewProjectByKeyKeepsWhatWasTypedTheMomentBefore) {
    openNew();
    type("typed");
    pressWithControl(Qt::Key_N);
    window->project().finishWriting();
    EXPECT_EQ(notes(), "");
    EXPECT_TRUE(window->project().path().empty());
    EXPECT_EQ(loadProject(file("motor.toml.autosave"))->notes, "typed");
}

TEST_F(KeepingWorkTest, openingAnotherByKeyKeepsWhatWasTypedTheMomentBefore) {
    openNew("other.toml");
    openNew();
    type("typed");
    answerDialog(path("other.toml"));
    pressWithControl(Qt::Key_O);
    window->project().finishWriting();
    EXPECT_EQ(window->project().path(), file("other.toml"));
    EXPECT_EQ(loadProject(file("motor.toml.autosave"))->notes, "typed");
}

TEST_F(KeepingWorkTest, aWindowThatCannotKeepItsWorkStaysOpenAndOffersWaysOut) {
    openNew();
    blockAutosave();
    type("typed");
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(window->isVisible());
    ASSERT_NE(offering("Save project as…"), nullptr);
    EXPECT_TRUE(offering("Save project as…")->message().text.contains("motor.toml.autosave"));
    ASSERT_NE(offering("Close anyway"), nullptr);
    answerDialog(path("elsewhere.toml"));
    press("Save project as…");
    window->project().finishWriting();
    EXPECT_EQ(loadProject(file("elsewhere.toml"))->notes, "typed");
    EXPECT_EQ(offering("Save project as…"), nullptr); // nothing is wrong any more
    EXPECT_EQ(offering("Close anyway"), nullptr);
    EXPECT_TRUE(window->close());
}

/// Writing may take as long as the disk likes, and Esc waits for it: nothing is armed by then.
TEST_F(KeepingWorkTest, theDeviceIsLeftBeforeAnythingIsWritten) {
    openNew();
    blockAutosave();
    type("typed");
    connectMotor(1.0);
    arm();
    std::size_t offers = 1;
    QObject::connect(&session(), &DeviceSession::stateChanged, window.get(), [&] {
        if (session().state() == SessionState::Disconnected) {
            offers = offering("Close anyway") == nullptr ? 0 : 1;
        }
    });
    EXPECT_FALSE(window->close());
    EXPECT_EQ(offering("Close anyway"), nullptr); // nothing was written yet
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    EXPECT_EQ(offers, 0U); // what leaving disarms is shown in tests/app/session
    ASSERT_TRUE(wait([&] { return offering("Close anyway") != nullptr; }));
    EXPECT_TRUE(window->isVisible()); // the work is not lost
}

TEST_F(KeepingWorkTest, noProjectIsReadWhileTheActuatorIsArmed) {
    openNew("other.toml");
    openNew();
    connectMotor(1.0);
    arm();
    window->openProject(path("other.toml"));
    EXPECT_EQ(window->project().path(), file());
    EXPECT_NE(saying("A project cannot be opened while the actuator is armed"), nullptr);
    QTest::keyClick(window.get(), Qt::Key_Escape);
    ASSERT_TRUE(wait([&] { return !session().report().board.isArmed; }));
    window->openProject(path("other.toml"));
    window->project().finishWriting();
    EXPECT_EQ(window->project().path(), file("other.toml"));
    EXPECT_EQ(saying("A project cannot be opened"), nullptr);
}

TEST_F(KeepingWorkTest, closingAnywayIsTheUsersChoice) {
    openNew();
    blockAutosave();
    type("typed");
    EXPECT_FALSE(window->close());
    press("Close anyway");
    EXPECT_FALSE(window->isVisible());
    EXPECT_EQ(loadProject(file())->notes, ""); // as it was saved
}

TEST_F(KeepingWorkTest, aProjectThatCannotBeKeptStaysOpenWhenANewOneIsWanted) {
    openNew();
    blockAutosave();
    type("typed");
    pressWithControl(Qt::Key_N);
    window->project().finishWriting();
    EXPECT_EQ(notes(), "typed"); // nothing is lost, and it is still this project
    EXPECT_EQ(window->project().path(), file());
    auto* bar = window->findChild<UnsavedBar*>();
    ASSERT_TRUE(bar->isVisible());
    choose("Try again"); // the disk is still full
    EXPECT_EQ(notes(), "typed");
    EXPECT_TRUE(bar->isVisible());
    ASSERT_TRUE(QDir(path("motor.toml.autosave")).removeRecursively());
    choose("Try again"); // now there is room
    EXPECT_EQ(notes(), "");
    EXPECT_TRUE(window->project().path().empty());
    EXPECT_FALSE(bar->isVisible());
    EXPECT_EQ(loadProject(file("motor.toml.autosave"))->notes, "typed");
}

TEST_F(KeepingWorkTest, whatCannotBeKeptIsSavedElsewhereAndTheOtherProjectOpens) {
    wantAnotherFromOneThatCannotBeKept();
    answerDialog(path("elsewhere.toml"));
    choose("Save project as…");
    EXPECT_EQ(loadProject(file("elsewhere.toml"))->notes, "typed");
    EXPECT_EQ(window->project().path(), file("other.toml")); // what was asked for
}

TEST_F(KeepingWorkTest, whatCannotBeKeptIsDiscardedOnPurposeOnly) {
    wantAnotherFromOneThatCannotBeKept();
    choose("Discard");
    EXPECT_EQ(window->project().path(), file("other.toml"));
    EXPECT_EQ(loadProject(file())->notes, ""); // as it was saved
}

TEST_F(KeepingWorkTest, aNamedProjectThatACrashInterruptedIsOfferedAtTheNextStart) {
    openNew();
    openNew("later.toml"); // the last one, without unsaved work
    window.reset();
    Project unsaved;
    unsaved.notes = "before the crash"; // what the autosave of five seconds ago holds
    ASSERT_TRUE(saveProject(unsaved, autosavePath(file())));
    open();
    window->recoverUnnamed();
    EXPECT_TRUE(window->project().path().empty()) << "nothing is opened unasked";
    ASSERT_NE(offering("Open the project"), nullptr);
    EXPECT_NE(saying("motor.toml"), nullptr);
    press("Open the project");
    EXPECT_EQ(window->project().path(), file());
    EXPECT_EQ(notes(), "before the crash");
}

TEST_F(KeepingWorkTest, aWindowThatWasOnlyLookedAtLeavesNothingToRecover) {
    window->docks().setPerspective(Perspective::Tune);
    EXPECT_TRUE(window->close());
    EXPECT_FALSE(window->isWindowModified());
    QDirIterator left(folder.path(), {"*.autosave"}, QDir::Files, QDirIterator::Subdirectories);
    EXPECT_FALSE(left.hasNext());
    open();
    window->recoverUnnamed();
    for (const auto* bar : window->findChildren<widgets::MessageBar*>()) {
        EXPECT_FALSE(bar->message().text.contains("Restored"));
    }
}

TEST_F(KeepingWorkTest, aNewProjectBesideAConnectedDeviceIsUnchanged) {
    connectMotor(0.0);
    pressWithControl(Qt::Key_N);
    window->close(); // collects the project
    EXPECT_FALSE(window->isWindowModified());
}

TEST_F(KeepingWorkTest, theSameForAProjectThatWasOnlyLookedAt) {
    openNew();
    window->docks().setPerspective(Perspective::Tune);
    EXPECT_TRUE(window->close());
    EXPECT_FALSE(window->isWindowModified());
    EXPECT_FALSE(QFile::exists(path("motor.toml.autosave")));
}

TEST_F(KeepingWorkTest, thePanelsOfAWindowWithoutAProjectAreWhereTheyWereLeft) {
    const auto isNotesClosed = [this] { return window->docks().docks().value("notes")->isClosed(); };
    ASSERT_TRUE(isNotesClosed());
    window->docks().raise("notes");
    EXPECT_TRUE(window->close());
    window = std::make_unique<MainWindow>(loadPreferences());
    window->furnish();
    window->show();
    window->recoverUnnamed();
    EXPECT_FALSE(isNotesClosed());
}

TEST_F(KeepingWorkTest, aResetOfTheArrangementIsForGood) {
    const auto again = [this] {
        EXPECT_TRUE(window->close());
        window = std::make_unique<MainWindow>(loadPreferences());
        window->furnish();
        window->show();
        window->recoverUnnamed();
    };
    const auto isNotesClosed = [this] { return window->docks().docks().value("notes")->isClosed(); };
    window->docks().raise("notes");
    window->docks().docks().value("monitor")->toggleView(false);
    again();
    ASSERT_FALSE(isNotesClosed());
    window->docks().reset();
    again();
    EXPECT_TRUE(isNotesClosed());
    EXPECT_FALSE(window->docks().docks().value("monitor")->isClosed());
}

} // namespace
} // namespace halbench::app
