#include "tests/control/history/history_twins.h"

#include <algorithm>

namespace halbench::control {
namespace {

using Glance = SampleHistory::Glance;

/// Twins whose store brings what is asked for when it is told.
struct SlowTwins : Twins {
    explicit SlowTwins(std::size_t chunks = 24) : Twins(chunks * SampleChunk::bytesFor(3)) {
        recordTrouble(*this);
        pages->canFetch = true;
    }
    /// What was asked for comes. Whether the history says that there is something new.
    bool settle() {
        pages->deliver();
        const std::uint64_t before = paged.revision();
        paged.settle();
        return paged.revision() != before;
    }
};

/// Groups are floats relative to the first value: noise of some ones is right to a millionth.
bool contains(const Extremes& whole, const Extremes& part) {
    constexpr double Rounding = 1e-5;
    return part.isEmpty() ||
           (!whole.isEmpty() && whole.min <= part.min + Rounding && whole.max >= part.max - Rounding);
}

TEST(Glance, waitsForNothingShowsNoLessAndIsExactOnceTheDetailHasCome) {
    SlowTwins twins;
    Random random(7);
    std::vector<HistoryColumn> plain;
    std::vector<HistoryColumn> paged;
    std::size_t coarse = 0;
    for (int i = 0; i < 200; ++i) {
        TimeRange range = someRange(random, *twins.plain.range());
        range.end_s = std::min(range.end_s, range.begin_s + 15.0); // what the cache has room for
        const std::string signal = twins.plain.signals()[static_cast<std::size_t>(i) % 4];
        const auto count = static_cast<std::size_t>(1.0 + 2000.0 * random.uniform());
        twins.plain.columns(signal, range, count, plain);
        for (bool isWhole = false; !isWhole;) {
            const std::size_t reads = twins.pages->reads;
            {
                const Glance glance(twins.paged);
                twins.paged.columns(signal, range, count, paged);
                isWhole = glance.isWhole();
            }
            ASSERT_EQ(twins.pages->reads, reads);
            if (!isWhole) {
                ++coarse;
                Extremes seen;
                for (const HistoryColumn& column : paged) {
                    seen.add(column.extremes);
                }
                // At its ends rows are told by times between the marks, which are off where rows were lost.
                const TimeRange inner{range.begin_s + 0.2, range.end_s - 0.2};
                const Extremes least =
                    inner.length_s() > 0.0 ? twins.plain.extremes(signal, inner) : Extremes{};
                ASSERT_TRUE(contains(seen, least)) << "a spike would not be seen";
                ASSERT_TRUE(twins.settle());
            }
        }
        expectSame(plain, paged);
    }
    EXPECT_GT(coarse, 50U); // or nothing was tried
    EXPECT_EQ(twins.paged.damagedParts(), 0U);
}

TEST(Glance, samplesThatAreNotHereAreSaidToBeMissing) {
    SlowTwins twins;
    const TimeRange range{20.0, 20.1};
    std::vector<TimedValue> plain;
    std::vector<TimedValue> paged;
    twins.plain.samples("a", range, plain);
    ASSERT_GT(plain.size(), 50U);
    {
        const Glance glance(twins.paged);
        EXPECT_FALSE(twins.paged.samples("a", range, paged));
        EXPECT_FALSE(twins.paged.valueAt("a", 20.05).has_value()) << "no number is better than a wrong one";
        EXPECT_FALSE(glance.isWhole());
    }
    EXPECT_TRUE(twins.settle());
    const Glance glance(twins.paged);
    EXPECT_TRUE(twins.paged.samples("a", range, paged));
    expectSame(plain, paged);
    EXPECT_EQ(twins.paged.valueAt("a", 20.05)->value, twins.plain.valueAt("a", 20.05)->value);
    EXPECT_TRUE(glance.isWhole());
}

TEST(Glance, questionsOutsideOfItAreExactAtOnce) {
    SlowTwins twins;
    Random random(8);
    std::vector<HistoryColumn> plain;
    std::vector<HistoryColumn> paged;
    for (int i = 0; i < 100; ++i) {
        const TimeRange range = someRange(random, *twins.plain.range());
        {
            const Glance glance(twins.paged);
            twins.paged.columns("a", range, 300, paged);
        }
        twins.plain.columns("a", range, 300, plain);
        twins.paged.columns("a", range, 300, paged); // the same question
        expectSame(plain, paged);
    }
}

TEST(Glance, whatWasDroppedIsAskedForAgain) {
    SlowTwins twins;
    std::vector<TimedValue> samples;
    const auto look = [&] {
        const Glance glance(twins.paged);
        return twins.paged.samples("a", {20.0, 20.1}, samples);
    };
    EXPECT_FALSE(look());
    const std::size_t asked = twins.pages->asked();
    EXPECT_FALSE(look());
    EXPECT_EQ(twins.pages->asked(), asked) << "it is on its way";
    twins.pages->deliver(true);
    twins.paged.settle();
    EXPECT_FALSE(look());
    EXPECT_EQ(twins.pages->asked(), asked);
    EXPECT_TRUE(twins.settle());
    EXPECT_TRUE(look());
}

TEST(Glance, whatCannotBeReadIsAGapAndNotAskedForAgain) {
    SlowTwins twins;
    for (PageStore::Page page = 0; page < 10; ++page) {
        twins.pages->damaged.insert(page);
    }
    std::vector<TimedValue> samples;
    {
        const Glance glance(twins.paged);
        EXPECT_FALSE(twins.paged.samples("a", {1.0, 1.1}, samples));
    }
    EXPECT_TRUE(twins.settle());
    const Glance glance(twins.paged);
    EXPECT_TRUE(twins.paged.samples("a", {1.0, 1.1}, samples));
    EXPECT_TRUE(std::isnan(samples.front().value));
    EXPECT_GT(twins.paged.damagedParts(), 0U);
}

TEST(Glance, aPictureThatNeedsMoreThanThereIsRoomForStaysCoarseAndAsksNoMore) {
    SlowTwins twins(4);
    std::vector<TimedValue> samples;
    std::size_t most_bytes = 0;
    int looks = 0;
    for (bool isNews = true; isNews && looks < 100; ++looks) {
        {
            const Glance glance(twins.paged);
            for (const char* signal : {"a", "b", "c"}) { // six chunks each; the cache has half of one
                (void)twins.paged.samples(signal, {1.0, 25.0}, samples);
            }
            EXPECT_FALSE(glance.isWhole());
        }
        isNews = twins.settle();
        most_bytes = std::max(most_bytes, twins.paged.bytes());
    }
    EXPECT_LT(looks, 100);
    EXPECT_LE(most_bytes, twins.paged.budget_bytes());
}

TEST(Glance, withoutAStoreEverythingIsWhole) {
    SampleHistory history(Large);
    history.append(blockOf(layoutOf({"a"}, 0.001), 0, 100, [](std::size_t, std::size_t) { return 1.0; }));
    const Glance glance(history);
    EXPECT_EQ(history.valueAt("a", 0.05)->value, 1.0);
    EXPECT_TRUE(glance.isWhole());
}

TEST(Glance, oneInsideAnotherEndsNothing) {
    SlowTwins twins;
    std::vector<TimedValue> samples;
    const Glance outer(twins.paged);
    {
        const Glance inner(twins.paged);
        (void)twins.paged.samples("a", {20.0, 20.1}, samples);
    }
    EXPECT_FALSE(outer.isWhole());
    const std::size_t reads = twins.pages->reads;
    (void)twins.paged.samples("a", {40.0, 40.1}, samples);
    EXPECT_EQ(twins.pages->reads, reads);
}

} // namespace
} // namespace halbench::control
