#pragma once

#include "control/base/random.h"
#include "control/history/sample_history.h"
#include "tests/control/history/history_blocks.h"
#include "tests/control/history/memory_pages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {

inline const double NaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr std::size_t Large = std::size_t{1} << 30;
/// Three chunks of what the tests record: almost all of it is elsewhere.
inline const std::size_t Tiny = 4 * SampleChunk::bytesFor(3);

/// The same rows in memory and, but for the newest, in a store.
struct Twins {
    explicit Twins(std::size_t budget_bytes = Tiny) : paged(budget_bytes) { paged.setStore(pages); }
    void append(const SampleBlock& block) {
        plain.append(block);
        paged.append(block);
    }
    std::shared_ptr<MemoryPages> pages = std::make_shared<MemoryPages>();
    SampleHistory plain{Large};
    SampleHistory paged;
};

/// Three noisy signals at 1 kHz with lost rows, jumps of the clock, values that are none and, later, another
/// layout and a clock that starts again.
inline void recordTrouble(Twins& twins) {
    Random random(11);
    const auto layout = layoutOf({"a", "b", "c"}, 0.001);
    const auto value = [&](std::size_t row, std::size_t column) {
        const bool isNone = column == 1 && row % 30'000 > 28'000;
        return isNone ? NaN : 1e3 * static_cast<double>(column) + random.gaussian();
    };
    std::size_t row = 0;
    while (row < 150'000) {
        const auto rows = static_cast<std::size_t>(1.0 + 3000.0 * random.uniform());
        SampleBlock block = blockOf(layout, row, rows, value);
        block.lostRows = random.uniform() < 0.1 ? 1 : 0;
        twins.append(block);
        row += rows + (random.uniform() < 0.1 ? 50 : 0);
    }
    twins.append(blockOf(layoutOf({"b", "d"}, 0.0005), 0, 60'000, value));
    twins.append(blockOf(layoutOf({"b", "d"}, 0.0005), 0, 20'000, value)); // its clock starts again
}

inline TimeRange someRange(Random& random, const TimeRange& held) {
    const double length_s = held.length_s() * std::pow(10.0, -5.0 * random.uniform());
    const double begin_s = held.begin_s + (held.length_s() * 1.02 - length_s) * random.uniform();
    return {begin_s, begin_s + length_s};
}

inline void expectSame(const std::vector<HistoryColumn>& plain, const std::vector<HistoryColumn>& paged) {
    ASSERT_EQ(plain.size(), paged.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
        ASSERT_EQ(plain[i].extremes.min, paged[i].extremes.min) << i;
        ASSERT_EQ(plain[i].extremes.max, paged[i].extremes.max) << i;
        ASSERT_EQ(plain[i].isAfterGap, paged[i].isAfterGap) << i;
    }
}

inline void expectSame(const std::vector<TimedValue>& plain, const std::vector<TimedValue>& paged) {
    ASSERT_EQ(plain.size(), paged.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
        ASSERT_EQ(plain[i].time_s, paged[i].time_s) << i;
        ASSERT_EQ(plain[i].isAfterGap, paged[i].isAfterGap) << i;
        ASSERT_TRUE(plain[i].value == paged[i].value ||
                    (std::isnan(plain[i].value) && std::isnan(paged[i].value)))
            << i;
    }
}

} // namespace halbench::control
