#include "control/base/random.h"
#include "control/base/units.h"
#include "control/signals/trigger.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

struct Row {
    double time_s;
    double value;
};

std::shared_ptr<const StreamLayout> layoutOf(double period_s) {
    StreamLayout layout;
    layout.columns = {{"other", ""}, {"current", "A"}};
    layout.period_s = period_s;
    return std::make_shared<const StreamLayout>(layout);
}

SampleBlock blockOf(const std::shared_ptr<const StreamLayout>& layout, const std::vector<Row>& rows) {
    SampleBlock block;
    block.layout = layout;
    for (const Row& row : rows) {
        block.time_s.push_back(row.time_s);
        block.values.insert(block.values.end(), {1e9, row.value});
    }
    return block;
}

/// Rows one second apart.
std::vector<Row> everySecond(const std::vector<double>& values) {
    std::vector<Row> rows;
    for (const double value : values) {
        rows.push_back({static_cast<double>(rows.size()), value});
    }
    return rows;
}

/// A window so short that it never holds an edge off.
TriggerConfig shortWindow(TriggerSlope slope = TriggerSlope::Rising, double hysteresis = 0.0) {
    TriggerConfig config;
    config.source = "current";
    config.mode = TriggerMode::Normal;
    config.slope = slope;
    config.hysteresis = hysteresis;
    config.window_s = 0.01;
    config.preTrigger_ratio = 0.0;
    return config;
}

EdgeTrigger triggerOf(const TriggerConfig& config) {
    Result<EdgeTrigger> trigger = EdgeTrigger::create(config);
    EXPECT_TRUE(trigger) << trigger.error().message;
    return *std::move(trigger);
}

std::vector<double> timesOf(const std::vector<TriggerEvent>& events) {
    std::vector<double> times;
    for (const TriggerEvent& event : events) {
        times.push_back(event.time_s);
    }
    return times;
}

std::vector<double> eventTimes(const TriggerConfig& config, const std::vector<Row>& rows) {
    return timesOf(triggerOf(config).take(blockOf(layoutOf(1.0), rows)));
}

/// What the header says of an edge, looking back from each row.
bool isEdge(const std::vector<double>& values, std::size_t row, double hysteresis, double sign) {
    if (!(sign * values[row] >= 0.0)) {
        return false;
    }
    for (std::size_t back = row; back-- > 0;) {
        if (!(sign * values[back] < 0.0)) {
            return false; // at or beyond the level, or no number
        }
        if (sign * values[back] <= -hysteresis) {
            return true;
        }
    }
    return false;
}

TEST(EdgeTrigger, findsTheEdgesOfEveryShortSignal) {
    const std::vector<double> alphabet = {-2.0, -1.0, 0.0, 1.0, 2.0, Nan};
    const std::size_t length = 5;
    for (std::size_t code = 0; code < 7776; ++code) { // 6^5
        std::vector<double> values;
        for (std::size_t rest = code; values.size() < length; rest /= 6) {
            values.push_back(alphabet[rest % 6]);
        }
        for (const double hysteresis : {0.0, 1.0, 1.5}) {
            for (const TriggerSlope slope :
                 {TriggerSlope::Rising, TriggerSlope::Falling, TriggerSlope::Either}) {
                std::vector<std::size_t> expected;
                for (std::size_t row = 0; row < length; ++row) {
                    if ((slope != TriggerSlope::Falling && isEdge(values, row, hysteresis, 1.0)) ||
                        (slope != TriggerSlope::Rising && isEdge(values, row, hysteresis, -1.0))) {
                        expected.push_back(row);
                    }
                }
                std::vector<std::size_t> found; // an edge lies up to one row before the sample that shows it
                for (const double time_s : eventTimes(shortWindow(slope, hysteresis), everySecond(values))) {
                    found.push_back(static_cast<std::size_t>(std::ceil(time_s)));
                }
                ASSERT_EQ(found, expected) << code << " " << hysteresis << " " << static_cast<int>(slope);
            }
        }
    }
}

TEST(EdgeTrigger, tellsTheCrossingBetweenTwoSamplesAndItsSlope) {
    TriggerConfig config = shortWindow(TriggerSlope::Either);
    config.level = 0.5;
    const auto events = triggerOf(config).take(blockOf(layoutOf(1.0), everySecond({0.0, 2.0, 0.0, 0.5})));
    ASSERT_EQ(events.size(), 3U);
    EXPECT_DOUBLE_EQ(events[0].time_s, 0.25);
    EXPECT_EQ(events[0].cause, TriggerCause::Rising);
    EXPECT_DOUBLE_EQ(events[1].time_s, 1.75);
    EXPECT_EQ(events[1].cause, TriggerCause::Falling);
    EXPECT_DOUBLE_EQ(events[2].time_s, 3.0); // reaching the level is crossing it
}

TEST(EdgeTrigger, theWindowLiesAboutTheEventAsAsked) {
    TriggerConfig config = shortWindow();
    config.window_s = 2.0;
    config.preTrigger_ratio = 0.25;
    const auto events =
        triggerOf(config).take(blockOf(layoutOf(1.0), everySecond({-1.0, -1.0, 1.0, -1.0, 1.0, 1.0})));
    ASSERT_EQ(events.size(), 2U);
    EXPECT_DOUBLE_EQ(events[0].time_s, 1.5);
    EXPECT_DOUBLE_EQ(events[0].begin_s, 1.0);
    EXPECT_DOUBLE_EQ(events[0].end_s, 3.0);
    EXPECT_DOUBLE_EQ(events[1].time_s, 3.5); // after the window of the first
}

TEST(EdgeTrigger, waitsForThePartBeforeTheTriggerAtTheStart) {
    TriggerConfig config = shortWindow();
    config.window_s = 4.0;
    config.preTrigger_ratio = 0.5;
    const std::vector<double> values = {-1.0, 1.0, -1.0, 1.0, 1.0};
    EXPECT_THAT(eventTimes(config, everySecond(values)), testing::ElementsAre(2.5));
}

TEST(EdgeTrigger, anEdgeWithinTheWindowOrTheHoldOffIsNone) {
    std::vector<double> square;
    for (int i = 0; i < 21; ++i) {
        square.push_back(i % 2 == 0 ? -1.0 : 1.0); // edges up at 0.5, 2.5, 4.5 ...
    }
    TriggerConfig config = shortWindow();
    EXPECT_EQ(eventTimes(config, everySecond(square)).size(), 10U);
    config.holdOff_s = 5.0;
    EXPECT_THAT(eventTimes(config, everySecond(square)), testing::ElementsAre(0.5, 6.5, 12.5, 18.5));
    config.holdOff_s = 1.0;
    config.window_s = 7.0;
    EXPECT_THAT(eventTimes(config, everySecond(square)), testing::ElementsAre(0.5, 8.5, 16.5));
}

TEST(EdgeTrigger, anEdgeDuringTheHoldOffDoesNotCountLater) {
    TriggerConfig config = shortWindow();
    config.holdOff_s = 3.0;
    EXPECT_THAT(eventTimes(config, everySecond({-1.0, 1.0, -1.0, 1.0, 1.0, 1.0, 1.0, -1.0, 1.0})),
                testing::ElementsAre(0.5, 7.5));
}

TEST(EdgeTrigger, noiseAboutTheLevelTriggersOnceWithHysteresis) {
    Random random(5);
    std::vector<Row> rows;
    for (int i = 0; i < 10000; ++i) {
        const double t = i * 0.001;
        rows.push_back({t, -std::cos(2.0 * Pi * t) + 0.05 * random.gaussian()});
    }
    const auto layout = layoutOf(0.001);
    TriggerConfig config = shortWindow();
    config.window_s = 1e-4;
    EXPECT_GT(triggerOf(config).take(blockOf(layout, rows)).size(), 20U);
    config.hysteresis = 0.4;                                              // eight sigma
    EXPECT_EQ(triggerOf(config).take(blockOf(layout, rows)).size(), 10U); // one a period
}

TEST(EdgeTrigger, autoShowsSomethingAfterItsWait) {
    TriggerConfig config = shortWindow();
    config.mode = TriggerMode::Auto;
    config.autoWait_s = 2.9;
    const auto events = triggerOf(config).take(
        blockOf(layoutOf(1.0), everySecond({-1.0, -1.0, -1.0, -1.0, 1.0, 1.0, Nan, Nan, Nan})));
    ASSERT_EQ(events.size(), 3U);
    EXPECT_EQ(events[0].time_s, 3.0);
    EXPECT_EQ(events[0].cause, TriggerCause::Wait);
    EXPECT_EQ(events[1].time_s, 3.5);
    EXPECT_EQ(events[1].cause, TriggerCause::Rising); // an edge is better and begins the wait anew
    EXPECT_EQ(events[2].time_s, 7.0);                 // 3.5 + 0.01 + 2.9 have passed; also without values
    EXPECT_EQ(events[2].cause, TriggerCause::Wait);
    config.mode = TriggerMode::Normal;
    EXPECT_THAT(eventTimes(config, everySecond(std::vector<double>(100, -1.0))), testing::IsEmpty());
}

TEST(EdgeTrigger, singleStopsAfterTheFirstUntilItIsArmedAgain) {
    TriggerConfig config = shortWindow();
    config.mode = TriggerMode::Single;
    EdgeTrigger trigger = triggerOf(config);
    const SampleBlock block = blockOf(layoutOf(1.0), everySecond({-1.0, 1.0, -1.0, 1.0}));
    EXPECT_EQ(trigger.take(block).size(), 1U);
    EXPECT_TRUE(trigger.isDone());
    EXPECT_TRUE(trigger.take(block).empty());
    trigger.rearm();
    EXPECT_FALSE(trigger.isDone());
    EXPECT_EQ(trigger.config().source, "current");
    EXPECT_EQ(trigger.take(block).size(), 1U);
}

TEST(EdgeTrigger, anEdgeInsideAGapIsNone) {
    const TriggerConfig config = shortWindow();
    EXPECT_THAT(eventTimes(config, {{0, -1}, {1, -1}, {3, 1}, {4, -1}, {5, 1}}), testing::ElementsAre(4.5));
    EdgeTrigger trigger = triggerOf(config); // told by the stream, time goes on evenly
    EXPECT_TRUE(trigger.take(blockOf(layoutOf(1.0), {{0, -1}})).empty());
    SampleBlock after = blockOf(layoutOf(1.0), {{1, 1}, {2, -1}, {3, 1}});
    after.lostRows = 5;
    EXPECT_THAT(timesOf(trigger.take(after)), testing::ElementsAre(2.5));
}

TEST(EdgeTrigger, blocksWithoutRowsOrWithoutTheSourceKeepTheGap) {
    EdgeTrigger trigger = triggerOf(shortWindow());
    EXPECT_TRUE(trigger.take(blockOf(layoutOf(1.0), {{0, -1}})).empty());
    SampleBlock lost = blockOf(layoutOf(1.0), {});
    lost.lostRows = 1;
    EXPECT_TRUE(trigger.take(lost).empty());
    EXPECT_TRUE(trigger.take(blockOf(layoutOf(1.0), {{1, 1}, {2, -1}})).empty());
    SampleBlock foreign = blockOf(layoutOf(1.0), {{3, 1}});
    foreign.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"a", ""}, {"b", ""}}, 1.0});
    EXPECT_TRUE(trigger.take(foreign).empty());
    EXPECT_TRUE(trigger.take(blockOf(layoutOf(1.0), {{4, 1}})).empty());
}

TEST(EdgeTrigger, aGapEndsTheWindowButNotTheHoldOff) {
    TriggerConfig config = shortWindow();
    config.window_s = 100.0;
    const std::vector<Row> rows = {{0, -1}, {1, 1}, {10, -1}, {11, 1}, {12, -1}, {13, 1}};
    EXPECT_THAT(eventTimes(config, rows), testing::ElementsAre(0.5, 10.5));
    config.holdOff_s = 11.0;
    EXPECT_THAT(eventTimes(config, rows), testing::ElementsAre(0.5, 12.5));
    config.holdOff_s = 0.0;
    config.preTrigger_ratio = 0.02; // two seconds of it, collected again after the gap
    EXPECT_THAT(eventTimes(config, {{0, -1}, {1, -1}, {2, -1}, {3, 1}, {10, -1}, {11, 1}, {12, -1}, {13, 1}}),
                testing::ElementsAre(2.5, 12.5));
}

TEST(EdgeTrigger, aClockThatStartsAgainEndsTheHoldOff) {
    TriggerConfig config = shortWindow();
    config.holdOff_s = 1000.0;
    EXPECT_THAT(eventTimes(config, {{5000, -1}, {5001, 1}, {0, -1}, {1, 1}}),
                testing::ElementsAre(5000.5, 0.5));
}

/// Noise with missing values, gaps and a clock that starts again.
std::vector<Row> troubledStream() {
    Random random(9);
    std::vector<Row> rows;
    double time_s = 0.0;
    for (int i = 0; i < 300; ++i) {
        time_s += random.below(20) == 0 ? 0.0371 : 0.01;
        time_s = i == 200 ? 0.0 : time_s;
        rows.push_back({time_s, random.below(15) == 0 ? Nan : random.gaussian()});
    }
    return rows;
}

TEST(EdgeTrigger, eventsDoNotDependOnWhereTheStreamIsCut) {
    const std::vector<Row> rows = troubledStream();
    const auto layout = layoutOf(0.01);
    for (const TriggerMode mode : {TriggerMode::Auto, TriggerMode::Normal, TriggerMode::Single}) {
        TriggerConfig config = shortWindow(TriggerSlope::Either, 0.3);
        config.mode = mode;
        config.window_s = 0.05;
        config.preTrigger_ratio = 0.3;
        config.holdOff_s = 0.06;
        config.autoWait_s = 0.02;
        const std::vector<TriggerEvent> whole = triggerOf(config).take(blockOf(layout, rows));
        EXPECT_EQ(whole.size() > 1, mode != TriggerMode::Single);
        EdgeTrigger rowByRow = triggerOf(config);
        std::vector<TriggerEvent> single;
        for (std::size_t cut = 0; cut <= rows.size(); ++cut) {
            const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(cut);
            EdgeTrigger trigger = triggerOf(config);
            std::vector<TriggerEvent> events = trigger.take(blockOf(layout, {rows.begin(), middle}));
            const auto rest = trigger.take(blockOf(layout, {middle, rows.end()}));
            events.insert(events.end(), rest.begin(), rest.end());
            ASSERT_EQ(events, whole) << cut;
            if (cut < rows.size()) {
                const auto next = rowByRow.take(blockOf(layout, {rows[cut]}));
                single.insert(single.end(), next.begin(), next.end());
            }
        }
        EXPECT_EQ(single, whole);
    }
}

TEST(EdgeTrigger, refusesSettingsThatAreNone) {
    const auto codeOf = [](auto change) {
        TriggerConfig config = shortWindow();
        change(config);
        const Result<EdgeTrigger> trigger = EdgeTrigger::create(config);
        EXPECT_TRUE(trigger || !trigger.error().hint.empty());
        return trigger ? ErrorCode::Internal : trigger.error().code;
    };
    EXPECT_EQ(codeOf([](TriggerConfig& c) { c.source.clear(); }), ErrorCode::Usage);
    EXPECT_EQ(codeOf([](TriggerConfig& c) { c.level = Nan; }), ErrorCode::NotFinite);
    EXPECT_EQ(codeOf([](TriggerConfig& c) { c.window_s = INFINITY; }), ErrorCode::NotFinite);
    EXPECT_EQ(codeOf([](TriggerConfig& c) { c.hysteresis = -0.1; }), ErrorCode::OutOfRange);
    EXPECT_EQ(codeOf([](TriggerConfig& c) { c.preTrigger_ratio = 1.1; }), ErrorCode::OutOfRange);
    EXPECT_EQ(codeOf([](TriggerConfig& c) { c.preTrigger_ratio = -0.1; }), ErrorCode::OutOfRange);
    EXPECT_EQ(codeOf([](TriggerConfig& c) { c.window_s = 0.0; }), ErrorCode::OutOfRange);
    EXPECT_EQ(codeOf([](TriggerConfig& c) { c.autoWait_s = 0.0; }), ErrorCode::OutOfRange);
    EXPECT_EQ(codeOf([](TriggerConfig& c) { c.holdOff_s = -1.0; }), ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
