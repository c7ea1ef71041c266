#include "app/window/project/project_session.h"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest/QTest>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

class ProjectSessionTest : public testing::Test {
protected:
    std::string file(const char* name) const { return folder.filePath(name).toStdString(); }

    static Project withNotes(const char* notes) {
        Project project;
        project.notes = notes;
        return project;
    }

    bool saved(ProjectSession& session, const char* name) {
        std::optional<bool> answer;
        session.save(file(name), [&](const Result<void>& written) { answer = written.has_value(); });
        return QTest::qWaitFor([&] { return answer.has_value(); }, 120000) && *answer;
    }

    int argumentCount = 1;
    char programName[5] = "test";
    char* arguments[2] = {programName, nullptr};
    QCoreApplication application{argumentCount, arguments};
    QTemporaryDir folder;
};

TEST_F(ProjectSessionTest, aCrashLosesNothingThatWasAutosaved) {
    {
        ProjectSession before(file("unnamed.toml"));
        ASSERT_TRUE(saved(before, "motor.toml"));
        before.update(withNotes("unsaved"));
        ASSERT_TRUE(before.autosaveNow());
    } // the program dies here: nothing is saved or discarded
    ProjectSession after(file("unnamed.toml"));
    const auto left = after.recoverable(file("motor.toml"));
    ASSERT_TRUE(left);
    after.recover(file("motor.toml"), *left);
    EXPECT_EQ(after.project().notes, "unsaved");
    EXPECT_TRUE(after.isChanged()); // it is still not saved
}

TEST_F(ProjectSessionTest, anInterruptedProjectIsKnownUntilItIsOpenSavedOrUnchanged) {
    const std::string motor = file("motor.toml");
    {
        ProjectSession before(file("unnamed.toml"));
        ASSERT_TRUE(saved(before, "motor.toml"));
        before.update(withNotes("unsaved"));
        ASSERT_TRUE(before.autosaveNow());
        EXPECT_FALSE(before.wasLeftWithWork(motor)) << "it is open here";
        EXPECT_FALSE(ProjectSession(file("other.toml")).wasLeftWithWork(motor)) << "another window has it";
    }
    ProjectSession after(file("unnamed.toml"));
    EXPECT_TRUE(after.wasLeftWithWork(motor));
    EXPECT_TRUE(after.wasLeftWithWork(motor)) << "asking leaves it as it is";
    EXPECT_FALSE(after.wasLeftWithWork(file("none.toml")));
    ASSERT_TRUE(saveProject(withNotes("unsaved"), motor));
    EXPECT_FALSE(after.wasLeftWithWork(motor)) << "the file has the same";
}

TEST_F(ProjectSessionTest, aProjectWithoutANameIsRecoveredToo) {
    {
        ProjectSession before(file("unnamed.toml"));
        before.update(withNotes("never named"));
        ASSERT_TRUE(before.autosaveNow());
    }
    EXPECT_EQ(ProjectSession(file("unnamed.toml")).recoverable("")->notes, "never named");
}

TEST_F(ProjectSessionTest, savingRemovesTheAutosave) {
    ProjectSession session(file("unnamed.toml"));
    session.update(withNotes("kept"));
    ASSERT_TRUE(session.autosaveNow());
    ASSERT_TRUE(saved(session, "motor.toml"));
    EXPECT_FALSE(session.isChanged());
    EXPECT_FALSE(session.recoverable(file("motor.toml")));
    EXPECT_FALSE(session.recoverable(""));
}

TEST_F(ProjectSessionTest, aSaveThatHasNotAnsweredYetIsCompleteWhenTheSessionEnds) {
    {
        ProjectSession session(file("unnamed.toml"));
        session.update(withNotes("first"));
        session.autosave([](const Result<void>&) {}); // is being written
        session.update(withNotes("second"));
        session.save(file("motor.toml"), [](const Result<void>&) {}); // waits behind it
    }
    EXPECT_EQ(loadProject(file("motor.toml"))->notes, "second");
}

TEST_F(ProjectSessionTest, anAutosaveOfAProjectThatWasLeftMeanwhileIsNotOfferedLater) {
    ProjectSession session(file("unnamed.toml"));
    session.update(withNotes("left"));
    bool isWritten = false;
    session.autosave([&](const Result<void>&) { isWritten = true; });
    session.startNew();
    ASSERT_TRUE(QTest::qWaitFor([&] { return isWritten; }, 120000));
    EXPECT_FALSE(session.recoverable(""));
    EXPECT_EQ(session.project(), Project());
}

TEST_F(ProjectSessionTest, whatChangedDuringASaveIsStillToBeSaved) {
    ProjectSession session(file("unnamed.toml"));
    session.update(withNotes("saved"));
    bool isWritten = false;
    session.save(file("motor.toml"), [&](const Result<void>& written) { isWritten = written.has_value(); });
    session.update(withNotes("typed meanwhile"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return isWritten; }, 120000));
    EXPECT_TRUE(session.isChanged());
    EXPECT_EQ(loadProject(file("motor.toml"))->notes, "saved");
}

TEST_F(ProjectSessionTest, aDamagedFileLeavesTheOpenProjectAsItIs) {
    ProjectSession session(file("unnamed.toml"));
    session.update(withNotes("open"));
    QFile damaged(folder.filePath("damaged.toml"));
    ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
    damaged.write("schema = \"halbench.project/1\"\nnotes = ");
    damaged.close();
    const auto opened = session.open(file("damaged.toml"));
    ASSERT_FALSE(opened);
    EXPECT_EQ(session.project().notes, "open");
    EXPECT_TRUE(session.path().empty());
}

TEST_F(ProjectSessionTest, aDamagedAutosaveIsNotOffered) {
    QFile damaged(folder.filePath("motor.toml.autosave"));
    ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
    damaged.write("\0\0\0", 3);
    damaged.close();
    EXPECT_FALSE(ProjectSession(file("unnamed.toml")).recoverable(file("motor.toml")));
}

TEST_F(ProjectSessionTest, reopeningWhatIsStillBeingWrittenWaitsForIt) {
    ASSERT_TRUE(saveProject(withNotes("saved"), file("motor.toml")));
    ProjectSession session(file("unnamed.toml"));
    ASSERT_TRUE(session.open(file("motor.toml")));
    session.update(withNotes("not saved"));
    session.startNew(); // begins to write the autosave
    ASSERT_TRUE(session.open(file("motor.toml")));
    ASSERT_TRUE(session.recoverable(file("motor.toml")));
    EXPECT_EQ(session.recoverable(file("motor.toml"))->notes, "not saved");
}

TEST_F(ProjectSessionTest, anArrangementAloneIsSavedButNeverAutosaved) {
    ProjectSession session(file("unnamed.toml"));
    Project arranged;
    arranged.layouts = {{"tune", "<moved/>"}};
    session.update(arranged);
    EXPECT_FALSE(session.isChanged());
    session.autosave([](const Result<void>&) { ADD_FAILURE() << "nothing changed"; });
    ASSERT_TRUE(session.autosaveNow());
    EXPECT_FALSE(QFile::exists(folder.filePath("unnamed.toml.autosave")));
    ASSERT_TRUE(saved(session, "motor.toml"));
    EXPECT_EQ(loadProject(file("motor.toml"))->layouts, arranged.layouts);
}

TEST_F(ProjectSessionTest, aNewProjectIsEmptyAndUnchanged) {
    ProjectSession session(file("unnamed.toml"));
    session.update(withNotes("old"));
    session.startNew();
    EXPECT_EQ(session.project(), Project());
    EXPECT_FALSE(session.isChanged());
}

} // namespace
} // namespace halbench::app
