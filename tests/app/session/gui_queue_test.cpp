#include "app/session/gui_queue.h"

#include <QtCore/QCoreApplication>
#include <QtTest/QTest>

#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

namespace halbench::app {
namespace {

class GuiQueueTest : public ::testing::Test {
    int m_argc = 1;
    char m_name[5] = "test";
    char* m_argv[2] = {m_name, nullptr};
    QCoreApplication m_application{m_argc, m_argv};
};

TEST_F(GuiQueueTest, runsWhatAnotherThreadAddedHereAndInItsOrder) {
    GuiQueue queue;
    std::vector<int> order; // touched by this thread only
    std::vector<std::thread::id> threads;
    std::thread other([&] {
        for (int i = 0; i < 100; ++i) {
            queue.add([&, i] {
                order.push_back(i);
                threads.push_back(std::this_thread::get_id());
            });
        }
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return order.size() == 100; }));
    other.join();
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
        EXPECT_EQ(threads[static_cast<std::size_t>(i)], std::this_thread::get_id());
    }
}

TEST_F(GuiQueueTest, aFunctionMayAddAndWaitForTheNextOnes) {
    GuiQueue queue;
    bool isInnerDone = false;
    bool isOuterDone = false;
    queue.add([&] {
        queue.add([&] { isInnerDone = true; });
        isOuterDone = QTest::qWaitFor([&] { return isInnerDone; });
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return isOuterDone; }));
}

TEST_F(GuiQueueTest, dropsWhatHasNotRunWhenItGoes) {
    int runs = 0;
    auto queue = std::make_unique<GuiQueue>();
    const auto alive = std::make_shared<int>(0);
    queue->add([&runs, alive] { ++runs; });
    queue.reset();
    QCoreApplication::processEvents();
    EXPECT_EQ(runs, 0);
    EXPECT_EQ(alive.use_count(), 1);
}

} // namespace
} // namespace halbench::app
