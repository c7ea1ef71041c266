#include "app/window/project_session.h"

#include <QFile>
#include <QTemporaryDir>

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

    QTemporaryDir folder;
};

TEST_F(ProjectSessionTest, aCrashLosesNothingThatWasAutosaved) {
    {
        ProjectSession before(file("unnamed.toml"));
        ASSERT_TRUE(before.save(file("motor.toml")));
        before.update(withNotes("unsaved"));
        ASSERT_TRUE(before.autosave());
    } // the program dies here: nothing is saved or discarded
    ProjectSession after(file("unnamed.toml"));
    const auto left = after.recoverable(file("motor.toml"));
    ASSERT_TRUE(left);
    after.recover(file("motor.toml"), *left);
    EXPECT_EQ(after.project().notes, "unsaved");
    EXPECT_TRUE(after.isChanged()); // it is still not saved
}

TEST_F(ProjectSessionTest, aProjectWithoutANameIsRecoveredToo) {
    ProjectSession before(file("unnamed.toml"));
    before.update(withNotes("never named"));
    ASSERT_TRUE(before.autosave());
    EXPECT_EQ(ProjectSession(file("unnamed.toml")).recoverable("")->notes, "never named");
}

TEST_F(ProjectSessionTest, savingRemovesTheAutosave) {
    ProjectSession session(file("unnamed.toml"));
    session.update(withNotes("kept"));
    ASSERT_TRUE(session.autosave());
    ASSERT_TRUE(session.save(file("motor.toml")));
    EXPECT_FALSE(session.isChanged());
    EXPECT_FALSE(session.recoverable(file("motor.toml")));
    EXPECT_FALSE(session.recoverable(""));
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

TEST_F(ProjectSessionTest, aNewProjectIsEmptyAndUnchanged) {
    ProjectSession session(file("unnamed.toml"));
    session.update(withNotes("old"));
    session.startNew();
    EXPECT_EQ(session.project(), Project());
    EXPECT_FALSE(session.isChanged());
}

} // namespace
} // namespace halbench::app
