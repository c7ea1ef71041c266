#include "app/window/project/project_lock.h"
#include "app/window/project/unnamed_projects.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

class ProjectLockTest : public testing::Test {
protected:
    std::string file(const char* name) const { return folder.filePath(name).toStdString(); }
    bool exists(const char* name) const { return QFile::exists(folder.filePath(name)); }

    void leaveWork(const std::string& path, const char* notes) {
        Project project;
        project.notes = notes;
        ASSERT_TRUE(saveProject(project, autosavePath(path)));
    }

    int argumentCount = 1;
    char programName[5] = "test";
    char* arguments[2] = {programName, nullptr};
    QCoreApplication application{argumentCount, arguments};
    QTemporaryDir folder;
};

TEST_F(ProjectLockTest, oneWindowHasAProjectUntilItLetsGo) {
    {
        const auto first = ProjectLock::take(file("motor.toml"));
        ASSERT_TRUE(first);
        const auto second = ProjectLock::take(file("motor.toml"));
        ASSERT_FALSE(second);
        EXPECT_EQ(second.error().code, ErrorCode::Refused);
        EXPECT_NE(second.error().message.find(std::to_string(QCoreApplication::applicationPid())),
                  std::string::npos);
        EXPECT_TRUE(ProjectLock::take(file("other.toml")));
    }
    EXPECT_TRUE(ProjectLock::take(file("motor.toml")));
    EXPECT_FALSE(exists("motor.toml.lock"));
}

TEST_F(ProjectLockTest, aLockOfADeadProgramIsTakenOver) {
    QProcess program;
    program.start("true", QStringList());
    ASSERT_TRUE(program.waitForStarted());
    const qint64 dead = program.processId();
    ASSERT_TRUE(program.waitForFinished());
    QFile left(folder.filePath("motor.toml.lock")); // as QLockFile writes it: process, program, machine
    ASSERT_TRUE(left.open(QIODevice::WriteOnly));
    left.write(QByteArray::number(dead) + "\ntrue\n" + QSysInfo::machineHostName().toLocal8Bit() + "\n");
    left.close();
    EXPECT_TRUE(ProjectLock::take(file("motor.toml")));
}

TEST_F(ProjectLockTest, aLockOfAnotherMachineIsNotTakenHoweverOldItIs) {
    QFile left(folder.filePath("motor.toml.lock"));
    ASSERT_TRUE(left.open(QIODevice::WriteOnly));
    left.write("1\nhalbench\nanother-machine\n");
    ASSERT_TRUE(
        left.setFileTime(QDateTime::fromSecsSinceEpoch(1000000000), QFileDevice::FileModificationTime));
    left.close();
    const auto taken = ProjectLock::take(file("motor.toml"));
    ASSERT_FALSE(taken);
    EXPECT_NE(taken.error().message.find("another-machine"), std::string::npos);
    EXPECT_NE(taken.error().hint.find("motor.toml.lock"), std::string::npos);
}

TEST_F(ProjectLockTest, theSameFileByAnotherWayIsTheSame) {
    QFile made(folder.filePath("motor.toml"));
    ASSERT_TRUE(made.open(QIODevice::WriteOnly));
    made.close();
    ASSERT_TRUE(QFile::link(folder.filePath("motor.toml"), folder.filePath("link.toml")));
    const auto first = ProjectLock::take(file("motor.toml"));
    ASSERT_TRUE(first);
    EXPECT_TRUE(first->isOf(file("link.toml")));
    EXPECT_FALSE(ProjectLock::take(file("link.toml")));
}

TEST_F(ProjectLockTest, eachWindowHasAPlaceOfItsOwnForWhatHasNoName) {
    const UnnamedPlace first = claimUnnamed(file("unnamed.toml"), false);
    const UnnamedPlace second = claimUnnamed(file("unnamed.toml"), false);
    EXPECT_EQ(first.path, file("unnamed.toml"));
    EXPECT_EQ(second.path, file("unnamed-2.toml"));
}

TEST_F(ProjectLockTest, workThatWaitsIsTakenUpFirstAndNeverOverwritten) {
    leaveWork(file("unnamed.toml"), ""); // an arrangement only
    leaveWork(file("unnamed-3.toml"), "mine");
    EXPECT_EQ(waitingUnnamed(file("unnamed.toml")), std::vector<std::string>{file("unnamed-3.toml")});
    EXPECT_EQ(claimUnnamed(file("unnamed.toml"), true).path, file("unnamed.toml"));
    const UnnamedPlace found = claimUnnamed(file("unnamed.toml"), false);
    EXPECT_EQ(found.path, file("unnamed-3.toml"));
    EXPECT_TRUE(waitingUnnamed(file("unnamed.toml")).empty()); // another window has it
}

TEST_F(ProjectLockTest, aFolderThatDoesNotExistIsMade) {
    const UnnamedPlace place = claimUnnamed(file("data/unnamed.toml"), false);
    EXPECT_EQ(place.path, file("data/unnamed.toml"));
    EXPECT_TRUE(exists("data/unnamed.toml.lock"));
}

} // namespace
} // namespace halbench::app
