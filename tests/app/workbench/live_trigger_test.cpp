#include "app/workbench/live_trigger.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace halbench::app {
namespace {

constexpr double Period_s = 0.001;
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

using Row = std::vector<double>;

/// A history that gets one row after the other, in blocks of 33 as a window's frame brings them.
class LiveTriggerTest : public testing::Test {
protected:
    void feed(double seconds, const std::function<Row(double)>& row, std::uint64_t lostRows = 0) {
        const auto rows = static_cast<std::size_t>(std::lround(seconds / Period_s));
        for (std::size_t i = 0; i < rows; i += 33) {
            SampleBlock block;
            block.layout = layout;
            block.lostRows = i == 0 ? lostRows : 0;
            for (std::size_t k = i; k < std::min(i + 33, rows); ++k) {
                const Row values = row(m_time_s);
                block.time_s.push_back(m_time_s);
                block.values.insert(block.values.end(), values.begin(), values.end());
                m_time_s += Period_s;
            }
            history.append(block);
            if (trigger.update()) {
                shown.push_back(*trigger.shown());
            }
        }
    }

    static std::shared_ptr<const StreamLayout> makeLayout() {
        auto made = std::make_shared<StreamLayout>();
        made->columns = {{"speed", "rad/s"}, {"reference", "rad"}, {"current_command", "A"}};
        made->period_s = Period_s;
        return made;
    }

    std::shared_ptr<const StreamLayout> layout = makeLayout();
    control::SampleHistory history{std::size_t{1} << 26};
    LiveTrigger trigger{history};
    TriggerChoice choice;
    const SetPointSignals setPoint{"reference", "current_command"};
    std::vector<control::TriggerEvent> shown;
    double m_time_s = 0.0;
};

Row sine(double time_s) {
    return {std::sin(2.0 * M_PI * time_s), NaN, 0.0};
}

TEST_F(LiveTriggerTest, showsTheWindowAroundEachRisingEdgeOnceItIsWhole) {
    choice.source = "speed";
    choice.mode = control::TriggerMode::Normal;
    choice.window_s = 0.4;
    feed(0.3, sine);
    ASSERT_TRUE(trigger.start(choice, setPoint));
    EXPECT_EQ(trigger.state(), TriggerState::Waiting);
    feed(0.75, sine); // to 1.05 s: past the edge at 1 s, not past its window
    EXPECT_EQ(trigger.state(), TriggerState::Filling);
    EXPECT_TRUE(shown.empty());
    feed(2.45, sine); // to 3.5 s
    EXPECT_EQ(trigger.state(), TriggerState::Shown);
    ASSERT_EQ(shown.size(), 3U); // at 1, 2 and 3 s
    for (std::size_t i = 0; i < shown.size(); ++i) {
        // Between two samples by a straight line, whose error on a sine is far below a period's thousandth.
        EXPECT_NEAR(shown[i].time_s, 1.0 + static_cast<double>(i), 1e-6);
        EXPECT_NEAR(shown[i].begin_s, shown[i].time_s - 0.1, 1e-12);
        EXPECT_NEAR(shown[i].end_s, shown[i].time_s + 0.3, 1e-12);
    }
}

TEST_F(LiveTriggerTest, singleStopsAfterItsEventUntilItIsArmedAgain) {
    choice.source = "speed";
    choice.mode = control::TriggerMode::Single;
    choice.window_s = 0.4;
    ASSERT_TRUE(trigger.start(choice, setPoint));
    feed(4.0, sine);
    EXPECT_EQ(shown.size(), 1U);
    EXPECT_EQ(trigger.state(), TriggerState::Stopped);
    trigger.rearm();
    feed(2.0, sine);
    EXPECT_EQ(shown.size(), 2U);
}

TEST_F(LiveTriggerTest, autoShowsSomethingWithoutAnEvent) {
    choice.source = "speed";
    choice.level = 5.0; // never reached
    choice.window_s = 0.2;
    ASSERT_TRUE(trigger.start(choice, setPoint));
    feed(3.0, sine);
    ASSERT_FALSE(shown.empty());
    EXPECT_EQ(shown.back().cause, control::TriggerCause::Wait);
}

TEST_F(LiveTriggerTest, aSetPointThatMovesOnIsOneEvent) {
    choice.mode = control::TriggerMode::Normal;
    choice.window_s = 0.2;
    ASSERT_TRUE(trigger.start(choice, setPoint));
    // A current that moves under a reference is no set-point.
    feed(1.0, [](double t) { return Row{0.0, 0.25, std::sin(40.0 * t)}; });
    EXPECT_TRUE(shown.empty());
    feed(1.0, [](double t) { return Row{0.0, 0.25 + t, std::sin(40.0 * t)}; }); // a ramp from 1 s
    ASSERT_EQ(shown.size(), 1U);
    EXPECT_NEAR(shown[0].time_s, 1.0, Period_s);
    feed(0.5, [](double) { return Row{0.0, 2.0, 0.0}; });
    feed(0.5, [](double) { return Row{0.0, 1.0, 0.0}; }); // a step at 2.5 s
    ASSERT_EQ(shown.size(), 2U);
    EXPECT_NEAR(shown[1].time_s, 2.5, Period_s);
}

// A set-point of the given rate under rows of 1 kHz: held between its own samples.
double held(double time_s, double rate_Hz, const std::function<double(double)>& motion) {
    return motion(std::floor(time_s * rate_Hz + 1e-6) / rate_Hz);
}

TEST_F(LiveTriggerTest, aSineSampledMoreSlowlyThanTheRowsIsOneEvent) {
    for (const double rate_Hz : {1000.0, 500.0, 100.0, 50.0, 20.0, 8.0}) {
        shown.clear();
        choice.mode = control::TriggerMode::Normal;
        choice.window_s = 0.2;
        ASSERT_TRUE(trigger.start(choice, setPoint));
        feed(1.0, [](double) { return Row{0.0, 0.0, 0.0}; });
        const double begin_s = m_time_s;
        feed(12.0, [&](double t) {
            return Row{0.0,
                       held(t - begin_s, rate_Hz, [](double u) { return std::sin(2.0 * M_PI * 0.7 * u); }),
                       0.0};
        });
        ASSERT_EQ(shown.size(), 1U) << rate_Hz;
        EXPECT_NEAR(shown[0].time_s, begin_s, 1.0 / rate_Hz + 2.0 * Period_s) << rate_Hz;
        feed(1.0, [](double) { return Row{0.0, 0.0, 0.0}; }); // ends with a step, still part of the motion
        EXPECT_EQ(shown.size(), 1U) << rate_Hz;
    }
}

TEST_F(LiveTriggerTest, rampsChirpsAndCurrentsInCoarseStepsAreOneEventEach) {
    const std::vector<std::function<Row(double)>> motions = {
        [](double t) {
            return Row{0.0, held(t, 100.0, [](double u) { return 3.0 * u; }), 0.0};
        },
        [](double t) {
            return Row{0.0, held(t, 100.0, [](double u) { return std::sin(u * u); }), 0.0};
        },
        [](double t) {
            return Row{0.0, NaN, held(t, 50.0, [](double u) { return 0.1 * u; })};
        }};
    for (const auto& motion : motions) {
        shown.clear();
        choice.mode = control::TriggerMode::Normal;
        choice.window_s = 0.2;
        const bool isCurrent = std::isnan(motion(0.0)[1]);
        const auto still = [&](double) { return Row{0.0, isCurrent ? NaN : 0.0, 0.0}; };
        feed(1.0, still);
        ASSERT_TRUE(trigger.start(choice, setPoint));
        feed(0.3, still); // an event needs its stretch before
        const double begin_s = m_time_s;
        feed(4.0, [&](double t) { return motion(t - begin_s); });
        EXPECT_EQ(shown.size(), 1U);
    }
}

TEST_F(LiveTriggerTest, aTriggerThatStartsInTheMiddleOfAMotionWaitsForTheNextOne) {
    choice.mode = control::TriggerMode::Normal;
    choice.window_s = 0.2;
    const auto moving = [](double t) {
        return Row{0.0, held(t, 100.0, [](double u) { return std::sin(4.0 * u); }), 0.0};
    };
    feed(2.0, moving);
    ASSERT_TRUE(trigger.start(choice, setPoint));
    feed(2.0, moving);
    EXPECT_TRUE(shown.empty());
    feed(0.5, [](double) { return Row{0.0, 0.0, 0.0}; });
    const double begin_s = m_time_s;
    feed(0.5, [](double) { return Row{0.0, 1.0, 0.0}; });
    ASSERT_EQ(shown.size(), 1U);
    EXPECT_NEAR(shown[0].time_s, begin_s, Period_s);
}

TEST_F(LiveTriggerTest, withoutAReferenceTheCommandedCurrentIsTheSetPoint) {
    choice.mode = control::TriggerMode::Normal;
    choice.window_s = 0.2;
    ASSERT_TRUE(trigger.start(choice, setPoint));
    feed(0.5, [](double) { return Row{0.0, NaN, 0.0}; });
    feed(0.5, [](double) { return Row{0.0, NaN, 1.5}; });
    ASSERT_EQ(shown.size(), 1U);
    EXPECT_NEAR(shown[0].time_s, 0.5, Period_s);
    feed(0.5, [](double) { return Row{0.0, 0.1, 1.5}; }); // the mode uses a reference now: nothing changed
    EXPECT_EQ(shown.size(), 1U);
}

TEST_F(LiveTriggerTest, anEdgeInsideAGapIsNone) {
    choice.source = "speed";
    choice.mode = control::TriggerMode::Normal;
    choice.window_s = 0.2;
    ASSERT_TRUE(trigger.start(choice, setPoint));
    feed(0.5, [](double) { return Row{-1.0, NaN, 0.0}; });
    m_time_s += 0.5;
    feed(
        1.0,
        [](double) {
            return Row{1.0, NaN, 0.0};
        },
        500);
    EXPECT_TRUE(shown.empty());
}

TEST_F(LiveTriggerTest, goesOnWhenTheHistoryWasCleared) {
    choice.source = "speed";
    choice.mode = control::TriggerMode::Normal;
    choice.window_s = 0.2;
    ASSERT_TRUE(trigger.start(choice, setPoint));
    feed(2.5, sine);
    const std::size_t before = shown.size();
    history.clear();
    m_time_s = 0.0;
    feed(2.5, sine);
    EXPECT_GT(shown.size(), before);
}

TEST_F(LiveTriggerTest, refusesAWindowOfNoLength) {
    choice.window_s = 0.0;
    EXPECT_FALSE(trigger.start(choice, setPoint));
    EXPECT_EQ(trigger.state(), TriggerState::Off);
}

} // namespace
} // namespace halbench::app
