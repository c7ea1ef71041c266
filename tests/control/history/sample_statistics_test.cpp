#include "control/base/random.h"
#include "control/history/sample_history.h"
#include "control/signals/moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace halbench::control {
namespace {

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

std::shared_ptr<const StreamLayout> layoutOf(double period_s) {
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"x", "A"}};
    layout->period_s = period_s;
    return layout;
}

TEST(MomentsTest, areThoseOfTheTextbook) {
    Moments moments;
    for (const double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0, NaN}) {
        moments.add(value);
    }
    EXPECT_EQ(moments.count(), 8U);
    EXPECT_EQ(moments.missing(), 1U);
    EXPECT_DOUBLE_EQ(moments.mean(), 5.0);
    EXPECT_DOUBLE_EQ(moments.deviation(), std::sqrt(32.0 / 7.0));
    EXPECT_DOUBLE_EQ(moments.rms(), std::sqrt(29.0)); // mean square: (4+16+16+16+25+25+49+81)/8
}

TEST(MomentsTest, ofTwoPartsAreThoseOfTheWhole) {
    Random random(7);
    Moments whole;
    Moments parts;
    for (int part = 0; part < 10; ++part) {
        Moments own;
        for (int i = 0; i < 100 * part; ++i) {
            const double value = 1e6 + 1e-3 * random.gaussian(); // a large constant part
            whole.add(value);
            own.add(value);
        }
        parts.add(own);
    }
    EXPECT_EQ(parts.count(), whole.count());
    // 4500 updates, each rounded by 6e-11 in the mean, of either sign: they wander off by 4e-9.
    EXPECT_NEAR(parts.mean(), whole.mean(), 2e-8);
    // One unit of the last place of 1e6 is 1e-10, a ten-millionth of the deviation.
    EXPECT_NEAR(parts.deviation(), whole.deviation(), 1e-6 * whole.deviation());
    EXPECT_NEAR(whole.deviation(), 1e-3, 1e-4);
}

TEST(SampleStatisticsTest, ofAnyStretchEqualThoseOfItsSamples) {
    SampleHistory history(std::size_t{1} << 26);
    const auto layout = layoutOf(0.001);
    Random random(3);
    std::vector<double> all;
    for (int block = 0; block < 30; ++block) { // seven chunks
        SampleBlock rows;
        rows.layout = layout;
        for (int i = 0; i < 1000; ++i) {
            rows.time_s.push_back(0.001 * static_cast<double>(all.size()));
            all.push_back(all.size() % 97 == 0 ? NaN : 2.0 + 0.5 * random.gaussian());
            rows.values.push_back(all.back());
        }
        history.append(rows);
    }
    for (const auto& [first, last] : {std::pair{0, 29999}, std::pair{10, 20}, std::pair{4090, 12300},
                                      std::pair{4096, 8191}, std::pair{5000, 5000}}) {
        const SampleStatistics found = history.statistics("x", {0.001 * first, 0.001 * last});
        Moments expected;
        Extremes extremes;
        for (int i = first; i <= last; ++i) {
            expected.add(all[static_cast<std::size_t>(i)]);
            extremes.add(all[static_cast<std::size_t>(i)]);
        }
        EXPECT_EQ(found.moments.count(), expected.count()) << first;
        EXPECT_EQ(found.moments.missing(), expected.missing());
        EXPECT_NEAR(found.moments.mean(), expected.mean(), 1e-12);
        EXPECT_NEAR(found.moments.deviation(), expected.deviation(), 1e-12);
        // The pyramid keeps floats.
        EXPECT_NEAR(found.extremes.min, extremes.min, 1e-6);
        EXPECT_NEAR(found.extremes.max, extremes.max, 1e-6);
        EXPECT_EQ(found.gaps, 0U);
    }
}

TEST(SampleStatisticsTest, countGapsInsideTheStretchOnly) {
    SampleHistory history(std::size_t{1} << 24);
    for (const auto& [period_s, begin_s] :
         {std::pair{0.01, 0.0}, std::pair{0.01, 2.0}, std::pair{0.02, 4.0}}) {
        SampleBlock rows; // a second each, with a second missing between
        rows.layout = layoutOf(period_s);
        rows.lostRows = begin_s > 0.0 ? 100 : 0;
        for (double time_s = begin_s; time_s < begin_s + 0.995; time_s += period_s) {
            rows.time_s.push_back(time_s);
            rows.values.push_back(1.0);
        }
        history.append(rows);
    }
    EXPECT_EQ(history.statistics("x", {0.0, 10.0}).gaps, 2U);
    EXPECT_EQ(history.statistics("x", {0.5, 2.5}).gaps, 1U);
    EXPECT_EQ(history.statistics("x", {2.0, 2.5}).gaps, 0U);
    EXPECT_EQ(history.statistics("x", {2.5, 10.0}).gaps, 1U); // another stream
    EXPECT_EQ(history.statistics("x", {1.2, 1.8}).moments.count(), 0U);
    EXPECT_EQ(history.statistics("nobody", {0.0, 10.0}).moments.count(), 0U);
}

} // namespace
} // namespace halbench::control
