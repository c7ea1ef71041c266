#include "app/documents/text/output_file.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace halbench::app {
namespace {

namespace fs = std::filesystem;

class OutputFile : public ::testing::Test {
protected:
    OutputFile() {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        m_folder = fs::path(::testing::TempDir()) / (std::string("halbench_output_") + test->name());
        fs::remove_all(m_folder);
        fs::create_directories(m_folder);
    }
    ~OutputFile() override { fs::remove_all(m_folder); }

    std::string path(const std::string& name) const { return (m_folder / name).string(); }
    std::size_t entries() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
    }

    fs::path m_folder;
};

TEST_F(OutputFile, appearsWholeUnderItsNameInFoldersThatAreMade) {
    ASSERT_TRUE(writeFile(path("a/b/c.txt"), "content\n").has_value());
    EXPECT_EQ(readFile(path("a/b/c.txt")).value(), "content\n");
    EXPECT_FALSE(fs::exists(path("a/b/c.txt.partial")));
}

TEST_F(OutputFile, replacesAnOldOne) {
    ASSERT_TRUE(writeFile(path("c.txt"), "a long old text").has_value());
    ASSERT_TRUE(writeFile(path("c.txt"), "new").has_value());
    EXPECT_EQ(readFile(path("c.txt")).value(), "new");
    EXPECT_EQ(entries(), 1U);
}

TEST_F(OutputFile, failsInPlacesThatCannotBeWritten) {
    ASSERT_TRUE(writeFile(path("file"), "x").has_value());
    for (const std::string& place : {path("file/c.txt"), path(""), std::string("/proc/none/c.txt")}) {
        const Result<void> written = writeFile(place, "x");
        ASSERT_FALSE(written.has_value()) << place;
        EXPECT_EQ(written.error().code, ErrorCode::FileSystem);
        EXPECT_FALSE(written.error().hint.empty());
    }
    EXPECT_EQ(entries(), 1U); // nothing partial is left
}

TEST_F(OutputFile, fullDiskIsToldAndNotTakenForSuccess) {
    const Result<void> written = writeFile("/dev/full", "x");
    ASSERT_FALSE(written.has_value());
    EXPECT_NE(written.error().hint.find("space"), std::string::npos);
}

TEST_F(OutputFile, readingSaysWhatIsMissing) {
    EXPECT_NE(readFile(path("none")).error().message.find("none"), std::string::npos);
    EXPECT_EQ(readFile(path("")).error().code, ErrorCode::FileSystem);
}

} // namespace
} // namespace halbench::app
