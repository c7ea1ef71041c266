#include "app/window/docks/dock_layout.h"
#include "app/workspaces/device/notes_panel.h"
#include "tests/app/window/window_test.h"

#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTemporaryDir>

namespace halbench::app {
namespace {

/// Two windows as two programs open them, with a data folder of their own.
class SecondWindowTest : public WindowTest {
protected:
    void SetUp() override {
        QStandardPaths::setTestModeEnabled(false);
        qputenv("XDG_DATA_HOME", folder.path().toUtf8());
        qputenv("XDG_CONFIG_HOME", folder.path().toUtf8());
        open();
        second = std::make_unique<MainWindow>(Preferences{});
        second->furnish();
        second->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(second.get()));
    }

    void TearDown() override {
        second.reset();
        WindowTest::TearDown();
    }

    QString path(const char* file = "motor.toml") const { return folder.filePath(file); }
    static NotesPanel* notes(MainWindow& window) {
        return static_cast<NotesPanel*>(window.docks().panel("notes"));
    }
    static const widgets::MessageBar* message(const MainWindow& window) {
        for (const auto* bar : window.findChildren<widgets::MessageBar*>()) {
            if (bar->isVisible() && !bar->message().text.isEmpty()) {
                return bar;
            }
        }
        return nullptr;
    }
    void write(const char* notes) {
        Project project;
        project.notes = notes;
        ASSERT_TRUE(saveProject(project, path().toStdString()));
    }

    QTemporaryDir folder;
    std::unique_ptr<MainWindow> second;
};

TEST_F(SecondWindowTest, aProjectThatAnotherWindowHasIsSaidAndACopyIsOffered) {
    write("as saved");
    window->openProject(path());
    notes(*window)->setNotes("in the first window");
    notes(*second)->setNotes("in the second window");
    second->openProject(path());
    second->project().finishWriting();                          // what was open is kept first
    EXPECT_EQ(notes(*second)->notes(), "in the second window"); // nothing is lost
    const auto* said = message(*second);
    ASSERT_NE(said, nullptr);
    EXPECT_TRUE(said->message().text.contains("motor.toml is open in another window"));
    EXPECT_EQ(said->message().actionText, "Open a copy");
    for (auto* button : said->findChildren<QPushButton*>()) {
        if (button->text() == "Open a copy") {
            button->setFocus();
            QTest::keyClick(button, Qt::Key_Space);
        }
    }
    EXPECT_EQ(notes(*second)->notes(), "as saved");
    EXPECT_TRUE(second->project().path().empty()); // saving asks for a name
    EXPECT_TRUE(second->isWindowModified());
    EXPECT_TRUE(message(*second)->message().text.contains("copy of motor.toml"));
    EXPECT_EQ(second->bench().session().state(), SessionState::Disconnected); // nothing is armed
}

TEST_F(SecondWindowTest, theFileOfAnotherWindowIsNotOverwritten) {
    write("as saved");
    window->openProject(path());
    std::optional<Result<void>> answer;
    second->project().save(path().toStdString(), [&](const Result<void>& written) { answer = written; });
    ASSERT_TRUE(answer);
    ASSERT_FALSE(*answer);
    EXPECT_EQ(answer->error().code, ErrorCode::Refused);
    EXPECT_EQ(loadProject(path().toStdString())->notes, "as saved");
}

TEST_F(SecondWindowTest, aProjectIsFreeWhenItsWindowHasClosedOrWentOn) {
    write("as saved");
    window->openProject(path());
    window->openProject(path("missing.toml"));
    second->openProject(path());
    EXPECT_TRUE(second->project().path().empty()); // the first still has it
    window->project().startNew();
    window->project().finishWriting();
    second->openProject(path());
    EXPECT_EQ(second->project().path(), path().toStdString());
}

TEST_F(SecondWindowTest, twoWindowsWithoutAProjectKeepTheirWorkApart) {
    notes(*window)->setNotes("first");
    notes(*second)->setNotes("second");
    window->close();
    second->close();
    window.reset();
    second.reset();
    QStringList found;
    MainWindow third{Preferences{}};
    third.recoverUnnamed();
    MainWindow fourth{Preferences{}};
    fourth.recoverUnnamed();
    EXPECT_EQ(notes(third)->notes(), "first");
    EXPECT_EQ(notes(fourth)->notes(), "second");
}

TEST_F(SecondWindowTest, workWithoutANameThatWasLeftIsInTheMenu) {
    write("as saved");
    notes(*window)->setNotes("not named yet");
    window->openProject(path()); // by the shortcut, before the autosave's time
    window->project().finishWriting();
    EXPECT_EQ(notes(*window)->notes(), "as saved");
    ASSERT_TRUE(wait([&] { return !window->project().waiting().empty(); }));
    QMenu* recent = nullptr;
    for (QMenu* menu : window->menuBar()->findChildren<QMenu*>()) {
        recent = menu->title().contains("recent") ? menu : recent;
    }
    ASSERT_NE(recent, nullptr);
    recent->aboutToShow();
    QAction* left = nullptr;
    for (QAction* action : recent->actions()) {
        left = action->text().startsWith("Unnamed project") ? action : left;
    }
    ASSERT_NE(left, nullptr);
    left->trigger();
    window->project().finishWriting();
    EXPECT_EQ(notes(*window)->notes(), "not named yet");
    EXPECT_TRUE(window->project().path().empty());
}

TEST_F(SecondWindowTest, unsavedWorkIsThereAgainAfterAnotherProject) {
    write("as saved");
    Project other;
    ASSERT_TRUE(saveProject(other, path("other.toml").toStdString()));
    window->openProject(path());
    notes(*window)->setNotes("not saved");
    window->openProject(path("other.toml"));
    window->project().finishWriting(); // what was open is kept first
    EXPECT_EQ(notes(*window)->notes(), "");
    window->openProject(path());
    EXPECT_EQ(notes(*window)->notes(), "not saved");
    EXPECT_TRUE(window->isWindowModified());
}

TEST_F(SecondWindowTest, aDamagedAutosaveIsKeptAsideAndSaid) {
    write("as saved");
    QFile damaged(path("motor.toml.autosave"));
    ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
    damaged.write("half a li");
    damaged.close();
    window->openProject(path());
    EXPECT_EQ(notes(*window)->notes(), "as saved");
    ASSERT_NE(message(*window), nullptr);
    EXPECT_TRUE(message(*window)->message().text.contains("motor.toml.autosave.damaged"));
    EXPECT_TRUE(QFile::exists(path("motor.toml.autosave.damaged")));
    EXPECT_FALSE(QFile::exists(path("motor.toml.autosave")));
}

} // namespace
} // namespace halbench::app
