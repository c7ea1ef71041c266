#include "devices/recording/file_access.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace halbench::devices {
namespace {

TEST(FileAccess, makesTheFoldersOfAFileAndNotTheFile) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("new/deep/run.csv").toStdString();
    ASSERT_TRUE(createFolderOf(path));
    EXPECT_TRUE(std::filesystem::is_directory(folder.filePath("new/deep").toStdString()));
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(FileAccess, refusesAFolderWhereAFileIsDue) {
    const QTemporaryDir folder;
    const auto done = createFolderOf(folder.path().toStdString());
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::FileSystem);
    std::ofstream(folder.filePath("file").toStdString()) << "x";
    EXPECT_FALSE(createFolderOf(folder.filePath("file/run.csv").toStdString()));
}

TEST(FileAccess, refusesADeviceThatWouldBecomeAFile) {
    const auto done = createFolderOf("/dev/null");
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::FileSystem);
    EXPECT_EQ(done.error().message, "'/dev/null' is a device or pipe");
}

TEST(FileAccess, theCauseIsNamedInWords) {
    const QTemporaryDir folder;
    QFile file(folder.filePath("none/run.csv"));
    ASSERT_FALSE(file.open(QIODevice::WriteOnly));
    const Error error = cannotWrite("run.csv", file).value();
    EXPECT_EQ(error.code, ErrorCode::FileSystem);
    EXPECT_EQ(error.message, "cannot write 'run.csv': No such file or directory");
    EXPECT_FALSE(error.hint.empty());
}

TEST(FileAccess, aMovedFileReplacesWhatWasThere) {
    const QTemporaryDir folder;
    const std::string from = folder.filePath("a").toStdString();
    const std::string to = folder.filePath("b").toStdString();
    std::ofstream(from) << "new";
    std::ofstream(to) << "older";
    ASSERT_TRUE(moveInto(from, to));
    EXPECT_EQ(std::filesystem::file_size(to), 3U);
    const auto again = moveInto(from, to);
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().message,
              "cannot rename '" + from + "' to '" + to + "': No such file or directory");
}

} // namespace
} // namespace halbench::devices
