#include "app/window/docks/dock_layout.h"
#include "app/window/window_program.h"
#include "app/workbench/drive_control.h"
#include "app/workspaces/device/device_panel.h"
#include "app/workspaces/device/notes_panel.h"
#include "devices/open/open_device.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/message_bar.h"

#include <QDialog>
#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTimer>

#include <atomic>
#include <csignal>

namespace halbench::app {
namespace {

/// A program as a terminal starts it, although what runs the tests may ignore the end of its terminal
/// (nohup).
class ProcessOfTerminal : public QProcess {
protected:
    void setupChildProcess() override { ::signal(SIGHUP, SIG_DFL); }
};

/// `halbench --connect DEVICE --project FILE`: the real program beside this window, and its arguments.
class WindowProgramTest : public WindowTest {
protected:
    void openWith(const std::vector<std::string>& words) {
        window = makeWindow(application, Preferences());
        obey(*window, words);
        window->show();
    }

    const NotesPanel& notes() const { return static_cast<NotesPanel&>(*window->docks().panel("notes")); }

    void keepProject() const {
        Project project;
        project.device = "sim:htm?seed=9";
        project.notes = "bearing greased";
        ASSERT_TRUE(saveProject(project, path().toStdString()));
    }
    QString path() const { return folder.filePath("motor.toml"); }

    static bool hasOpen(const QProcess& process, const QString& node) {
        const QDir folder(QStringLiteral("/proc/%1/fd").arg(process.processId()));
        for (const QFileInfo& entry : folder.entryInfoList(QDir::Files | QDir::System)) {
            if (entry.symLinkTarget() == node) {
                return true;
            }
        }
        return false;
    }

    static void end(QProcess& process) {
        process.kill();
        process.waitForFinished(Patience_ms);
    }

    QTemporaryDir folder;
};

TEST_F(WindowProgramTest, connectsTheDeviceOfItsArgumentsAndArmsNothing) {
    openWith({"--connect", "sim:htm"});
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    EXPECT_EQ(session().info().model, "htm");
    EXPECT_TRUE(session().info().isSimulated);
    EXPECT_FALSE(session().report().board.isArmed);
}

TEST_F(WindowProgramTest, opensTheProjectOfItsArgumentsAndConnectsNothing) {
    keepProject();
    openWith({"--project", path().toStdString()});
    ASSERT_TRUE(wait([&] { return window->docks().panel("notes") != nullptr; }));
    ASSERT_TRUE(wait([&] { return notes().notes() == "bearing greased"; }));
    EXPECT_TRUE(window->windowTitle().contains("motor.toml"));
    EXPECT_EQ(session().state(), SessionState::Disconnected);
    window.reset(); // its lock is in the folder
}

TEST_F(WindowProgramTest, withBothTheDeviceOfTheArgumentIsConnected) {
    keepProject();
    openWith({"--project", path().toStdString(), "--connect", "sim:htm?seed=4"});
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    EXPECT_EQ(notes().notes(), "bearing greased");
    window->docks().raise("devices"); // folded while a device is connected
    EXPECT_EQ(window->findChild<DevicePanel*>()->address(), "sim:htm?seed=4");
    window.reset();
}

/// The terminal is closed, or the session is ended, while the motor moves.
TEST_F(WindowProgramTest, aSignalStopsDisarmsAndCloses) {
    openWith({"--connect", "sim:htm"});
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
    ASSERT_TRUE(wait([&] { return window->bench().history().latest("position").has_value(); }));
    window->bench().drive().arm();
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    std::atomic<int> received{0};
    closeBySignal(*window, received);
    received = SIGHUP;
    ASSERT_TRUE(wait([&] { return !window->isVisible(); }));
    EXPECT_EQ(session().state(), SessionState::Disconnected);
}

/// The board itself tells that it was stopped: a window that only went away leaves it to its watchdog, or to
/// the next CONNECT, which disarms without a word.
TEST_F(WindowProgramTest, aSignalStopsTheMotorThatMoves) {
    for (const int signal : {SIGTERM, SIGHUP}) {
        QProcess board;
        board.start(HALBENCH_PROGRAM, {"serve", "sim:htm", "--pty"});
        ASSERT_TRUE(board.waitForReadyRead(Patience_ms));
        const QString node = QString::fromUtf8(board.readLine()).trimmed().section("pty:", 1);
        const std::string address = "serial:" + node.toStdString();
        openWith({"--connect", address});
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
        DriveControl& drive = window->bench().drive();
        drive.setMode(devices::BoardMode::Current);
        // A board on a line is not known to be simulated; where the machine is busy for a second, its
        // watchdog disarms it, and it is armed again.
        ASSERT_TRUE(wait([&] {
            if (drive.canArm()) {
                drive.giveConsent();
                drive.arm();
            }
            return drive.canMove();
        }));
        drive.setSetpoint(1.0, 0.0);
        ASSERT_TRUE(wait([&] {
            const auto current_A = window->bench().history().latest("current_command");
            return current_A && current_A->value > 0.5;
        })) << "the motor is driven";
        std::atomic<int> received{0};
        closeBySignal(*window, received);
        received = signal;
        ASSERT_TRUE(wait([&] { return !window->isVisible(); }));
        window.reset();
        const auto device = devices::openDevice(address, {});
        ASSERT_TRUE(device) << device.error().message;
        const std::vector<std::string> names = {"status", "current_command", "current.a", "current.b"};
        const auto values = (*device)->readSignals(names);
        ASSERT_TRUE(values) << values.error().message;
        EXPECT_EQ((*values)[0], 2.0) << "stopped by command; idle and 3, by the watchdog, are too late";
        EXPECT_EQ((*values)[1], 0.0);
        // of a coil with 0.1 ms the current is gone; what is left is the noise of its sensor
        EXPECT_NEAR((*values)[2], 0.0, 0.05);
        EXPECT_NEAR((*values)[3], 0.0, 0.05);
        end(board);
    }
}

TEST_F(WindowProgramTest, aModalDialogDoesNotHoldASignalUp) {
    openWith({});
    std::atomic<int> received{0};
    closeBySignal(*window, received);
    QDialog dialog(window.get());
    QTimer::singleShot(0, &dialog, [&received] { received = SIGTERM; });
    dialog.exec(); // returns only when something closes it
    EXPECT_TRUE(wait([&] { return !window->isVisible(); }));
}

TEST_F(WindowProgramTest, eachSignalThatEndsProgramsEndsTheWindowWithItsCode) {
    for (const int signal : {SIGTERM, SIGHUP, SIGQUIT, SIGINT}) {
        QProcess board;
        board.start(HALBENCH_PROGRAM, {"serve", "sim:htm", "--pty"});
        ASSERT_TRUE(board.waitForReadyRead(Patience_ms));
        const QString node = QString::fromUtf8(board.readLine()).trimmed().section("pty:", 1);
        ProcessOfTerminal program;
        program.start(HALBENCH_PROGRAM, {"--connect", "serial:" + node});
        ASSERT_TRUE(wait([&] { return hasOpen(program, node); }));
        ::kill(static_cast<pid_t>(program.processId()), signal);
        ASSERT_TRUE(program.waitForFinished(Patience_ms)) << signal;
        EXPECT_EQ(program.exitStatus(), QProcess::NormalExit) << signal;
        EXPECT_EQ(program.exitCode(), 128 + signal);
        end(board);
    }
}

/// Two programs on one serial line and one project.
TEST_F(WindowProgramTest, whatTheProgramHasAnotherWindowIsToldWhoHasIt) {
    keepProject();
    QProcess board;
    board.start(HALBENCH_PROGRAM, {"serve", "sim:htm", "--pty"});
    ASSERT_TRUE(board.waitForReadyRead(Patience_ms));
    const QString node = QString::fromUtf8(board.readLine()).trimmed().section("pty:", 1);
    ASSERT_TRUE(node.startsWith("/dev/")) << node.toStdString();
    QProcess program;
    program.start(HALBENCH_PROGRAM, {"--project", path(), "--connect", "serial:" + node});
    ASSERT_TRUE(program.waitForStarted(Patience_ms));
    ASSERT_TRUE(wait([&] { return QFile::exists(path() + ".lock"); }));

    open();
    const auto* panel = window->findChild<DevicePanel*>();
    const auto said = [&] {
        QString words;
        for (const auto* bar : panel->findChildren<widgets::MessageBar*>()) {
            words += bar->isVisible() ? bar->message().text + ' ' + bar->message().remedy : QString();
        }
        return words;
    };
    ASSERT_TRUE(wait([&] { return hasOpen(program, node); }));
    window->connectDevice("serial:" + node);
    ASSERT_TRUE(wait([&] { return said().contains("is in use by halbench"); })) << said().toStdString();
    EXPECT_TRUE(said().contains("close that program")) << said().toStdString();
    EXPECT_EQ(session().state(), SessionState::Disconnected);
    EXPECT_EQ(program.state(), QProcess::Running); // its connection is not disturbed

    window->openProject(path());
    EXPECT_EQ(notes().notes(), "");
    end(program);
    end(board);
}

} // namespace
} // namespace halbench::app
