#include "devices/acquisition/display_inbox.h"

#include <gtest/gtest.h>

#include <thread>

namespace halbench::devices {
namespace {

SampleBlockPtr blockAt(double time_s, std::size_t rows) {
    auto block = std::make_shared<SampleBlock>();
    block->time_s.assign(rows, time_s);
    return block;
}

TEST(DisplayInbox, givesBlocksOnceAndInOrder) {
    DisplayInbox inbox(1000);
    inbox.push(blockAt(1.0, 10));
    inbox.push({blockAt(2.0, 10), 0.5});
    const auto blocks = inbox.take();
    ASSERT_EQ(blocks.size(), 2U);
    EXPECT_EQ(blocks[0].begin_s(), 1.0);
    EXPECT_EQ(blocks[1].begin_s(), 2.5);
    EXPECT_TRUE(inbox.take().empty());
}

TEST(DisplayInbox, leavesOutAndCountsWhatAWindowThatSleepsDoesNotTake) {
    DisplayInbox inbox(100);
    for (int i = 0; i < 30; ++i) {
        inbox.push(blockAt(i, 10));
    }
    EXPECT_EQ(inbox.skippedRows(), 200U);
    EXPECT_EQ(inbox.take().size(), 10U);
    inbox.push(blockAt(31.0, 10));
    EXPECT_EQ(inbox.take().size(), 1U); // there is room again
}

TEST(DisplayInbox, losesNothingBetweenTwoThreads) {
    DisplayInbox inbox(1'000'000);
    std::thread connection([&] {
        for (int i = 0; i < 2000; ++i) {
            inbox.push(blockAt(i, 1));
        }
    });
    double expected = 0.0;
    while (expected < 2000.0) {
        for (const TimedBlock& block : inbox.take()) {
            ASSERT_EQ(block.begin_s(), expected);
            expected += 1.0;
        }
    }
    connection.join();
    EXPECT_EQ(inbox.skippedRows(), 0U);
}

} // namespace
} // namespace halbench::devices
