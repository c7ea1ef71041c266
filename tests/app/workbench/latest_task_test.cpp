#include "app/workbench/latest_task.h"

#include <QCoreApplication>
#include <QtTest/QTest>

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <future>
#include <iterator>
#include <vector>

namespace halbench::app {
namespace {

class LatestTaskTest : public testing::Test {
protected:
    int m_argumentCount = 1;
    char m_name[5] = "test";
    char* m_arguments[2] = {m_name, nullptr};
    QCoreApplication application{m_argumentCount, m_arguments};
};

TEST_F(LatestTaskTest, answersOnTheThreadThatAskedAndComputesOnAnother) {
    LatestTask task;
    std::thread::id worker;
    std::optional<int> answer;
    task.run([] { return std::pair(42, std::this_thread::get_id()); },
             [&](std::pair<int, std::thread::id> found) {
                 answer = found.first;
                 worker = found.second;
             });
    EXPECT_TRUE(task.isBusy());
    ASSERT_TRUE(QTest::qWaitFor([&] { return answer.has_value(); }));
    EXPECT_EQ(answer, 42);
    EXPECT_NE(worker, std::this_thread::get_id());
    EXPECT_FALSE(task.isBusy());
}

/// A window has dozens; the system lists the threads of a process.
TEST_F(LatestTaskTest, costsNoThreadUntilItIsAsked) {
    const auto threads = [] {
        const std::filesystem::directory_iterator list("/proc/self/task");
        return std::distance(begin(list), end(list));
    };
    const auto before = threads();
    LatestTask task;
    EXPECT_EQ(threads(), before);
    bool isAnswered = false;
    task.run([] { return 1; }, [&](int) { isAnswered = true; });
    EXPECT_EQ(threads(), before + 1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return isAnswered; }));
    task.run([] { return 2; }, [&](int) { isAnswered = true; });
    EXPECT_EQ(threads(), before + 1) << "one for all questions";
}

TEST_F(LatestTaskTest, onlyTheNewestQuestionIsAnswered) {
    LatestTask task;
    std::promise<void> begun;
    std::promise<void> release;
    std::atomic<int> computed = 0;
    std::vector<int> answers;
    const auto keep = [&](int answer) { answers.push_back(answer); };
    task.run(
        [&] {
            begun.set_value();
            release.get_future().wait();
            return 1;
        },
        keep);
    begun.get_future().wait();
    for (int i = 2; i <= 9; ++i) { // all but the last are overtaken before they begin
        task.run(
            [&computed, i] {
                ++computed;
                return i;
            },
            keep);
    }
    release.set_value();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !task.isBusy(); }));
    EXPECT_EQ(answers, std::vector<int>{9});
    EXPECT_EQ(computed, 1);
}

TEST_F(LatestTaskTest, aCancelledQuestionIsNotAnsweredAndTheNextOneIs) {
    LatestTask task;
    std::promise<void> begun;
    std::promise<void> release;
    std::vector<int> answers;
    const auto keep = [&](int answer) { answers.push_back(answer); };
    task.run(
        [&] {
            begun.set_value();
            release.get_future().wait();
            return 1;
        },
        keep);
    begun.get_future().wait();
    task.run([] { return 2; }, keep); // waits behind it
    task.cancel();
    EXPECT_FALSE(task.isBusy());
    release.set_value();
    task.run([] { return 3; }, keep);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !task.isBusy(); }));
    EXPECT_EQ(answers, std::vector<int>{3});
}

TEST_F(LatestTaskTest, aWaitingQuestionDiesWithItsTask) {
    std::atomic<bool> isAnswered = false;
    {
        LatestTask task;
        task.run([] { return 1; }, [&](int) { isAnswered = true; });
    }
    QCoreApplication::processEvents();
    EXPECT_FALSE(isAnswered);
}

} // namespace
} // namespace halbench::app
