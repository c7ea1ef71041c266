#include "app/workbench/file_queue.h"

#include <QCoreApplication>
#include <QtTest/QTest>

#include <gtest/gtest.h>

#include <filesystem>
#include <future>
#include <iterator>
#include <optional>
#include <vector>

namespace halbench::app {
namespace {

class FileQueueTest : public testing::Test {
protected:
    int m_argumentCount = 1;
    char m_name[5] = "test";
    char* m_arguments[2] = {m_name, nullptr};
    QCoreApplication application{m_argumentCount, m_arguments};
};

/// The system lists the threads of a process.
TEST_F(FileQueueTest, costsNoThreadUntilItGetsAJob) {
    const auto threads = [] {
        const std::filesystem::directory_iterator list("/proc/self/task");
        return std::distance(begin(list), end(list));
    };
    const auto before = threads();
    FileQueue files;
    EXPECT_EQ(threads(), before);
    bool isWritten = false;
    files.run([] { return Result<void>(); }, [&](const Result<void>&) { isWritten = true; });
    EXPECT_EQ(threads(), before + 1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return isWritten; }));
}

TEST_F(FileQueueTest, whatWaitsIsWrittenAndAnsweredInOrder) {
    FileQueue files;
    std::promise<void> disk; // slow until all have been asked for
    std::vector<int> written;
    std::vector<int> answered;
    for (int i = 0; i < 10; ++i) {
        files.run(
            [&written, i, ready = i == 0 ? disk.get_future().share() : std::shared_future<void>()] {
                if (ready.valid()) {
                    ready.wait();
                }
                written.push_back(i);
                return Result<int>(i);
            },
            [&answered](const Result<int>& number) { answered.push_back(*number); });
    }
    disk.set_value();
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered.size() == 10; }));
    EXPECT_EQ(answered, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(written, answered);
}

TEST_F(FileQueueTest, theEndCompletesWhatWaitsAndSaysWhatFailed) {
    std::promise<void> disk;
    int written = 0;
    testing::internal::CaptureStderr();
    {
        FileQueue files;
        files.run([ready = disk.get_future().share()] { return ready.wait(), Result<void>(); },
                  [](const Result<void>&) {});
        files.run([&written]() -> Result<void> { return ++written, Result<void>(); },
                  [](const Result<void>&) { FAIL() << "the asker may be gone"; });
        files.run([]() -> Result<void> { return failure(ErrorCode::FileSystem, "no space", "make room"); },
                  [](const Result<void>&) {});
        disk.set_value();
    }
    EXPECT_EQ(written, 1);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("no space"), std::string::npos);
}

TEST_F(FileQueueTest, anErrorThatWasToldIsNotSaidAgain) {
    testing::internal::CaptureStderr();
    std::optional<ErrorCode> told;
    {
        FileQueue files;
        files.run([]() -> Result<void> { return failure(ErrorCode::FileSystem, "no space", "make room"); },
                  [&told](const Result<void>& written) { told = written.error().code; });
        ASSERT_TRUE(QTest::qWaitFor([&] { return told.has_value(); }));
    }
    EXPECT_EQ(told, ErrorCode::FileSystem);
    EXPECT_TRUE(testing::internal::GetCapturedStderr().empty());
}

} // namespace
} // namespace halbench::app
