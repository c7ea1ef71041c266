#include "app/window/project_file.h"

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

Project sample() {
    Project project;
    project.device = "sim:htm?seed=7";
    project.notes = "first line\nwith \"quotes\" and µ";
    project.perspective = "tune";
    project.layouts = {{"monitor", "<xml/>"}, {"tune", ""}};
    project.models = {{"cold", "{\"schema\": \"halbench.identification/1\"}"}};
    project.designs = {{"recommended", "{}"}, {"slow", "{}"}};
    return project;
}

TEST(ProjectFile, comesBackAsItWasWritten) {
    const auto read = parseProject(projectText(sample()), "motor.toml");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, sample());
}

TEST(ProjectFile, anEmptyProjectIsAProject) {
    const auto read = parseProject(projectText({}), "motor.toml");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, Project());
}

TEST(ProjectFile, namesLineAndKeyOfAMistake) {
    const auto wrongType = parseProject("schema = \"halbench.project/1\"\ndevice = 7\n", "motor.toml");
    ASSERT_FALSE(wrongType);
    EXPECT_NE(wrongType.error().message.find("motor.toml:2:"), std::string::npos);
    EXPECT_NE(wrongType.error().message.find("device"), std::string::npos);
    const auto unknown = parseProject("schema = \"halbench.project/1\"\ncolour = \"red\"\n", "motor.toml");
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message.find("colour"), std::string::npos);
}

TEST(ProjectFile, aNewerVersionIsSaidToBeOne) {
    const auto read = parseProject("schema = \"halbench.project/2\"\n", "motor.toml");
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.find("newer"), std::string::npos);
}

TEST(ProjectFile, everyTruncationIsRefusedOrRead) {
    const std::string text = projectText(sample());
    for (std::size_t length = 0; length < text.size(); ++length) {
        const auto read = parseProject(text.substr(0, length), "motor.toml");
        if (!read) {
            EXPECT_EQ(read.error().code, ErrorCode::InvalidInput) << length;
            EXPECT_FALSE(read.error().hint.empty());
        }
    }
}

TEST(ProjectFile, aFolderThatCannotBeWrittenLeavesTheOldFile) {
    QTemporaryDir folder;
    const std::string path = folder.filePath("motor.toml").toStdString();
    ASSERT_TRUE(saveProject(sample(), path));
    const auto refused = saveProject({}, path + "/motor.toml"); // a file is no folder
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::FileSystem);
    const auto read = loadProject(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, sample());
}

TEST(ProjectFile, theAutosaveStandsBesideTheProject) {
    EXPECT_EQ(autosavePath("folder/motor.toml"), "folder/motor.toml.autosave");
}

} // namespace
} // namespace halbench::app
