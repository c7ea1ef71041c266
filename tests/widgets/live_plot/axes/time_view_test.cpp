#include "widgets/live_plot/axes/time_view.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::widgets {
namespace {

using control::TimeRange;

TEST(TimeView, fillsFromTheLeftThenFollowsTheNewestSample) {
    TimeView view(10.0);
    view.update(TimeRange{0.0, 3.0}, 1000);
    EXPECT_NEAR(view.range().begin_s, 0.0, 1e-9);
    view.update(TimeRange{0.0, 25.004}, 1000);
    EXPECT_NEAR(view.range().length_s(), 10.0, 1e-9);
    EXPECT_GE(view.range().end_s, 25.004);
    EXPECT_LT(view.range().end_s, 25.004 + 0.01); // less than one column
}

TEST(TimeView, followsByWholePixelColumns) {
    TimeView view(10.0);
    view.update(TimeRange{0.0, 100.0}, 1000);
    const double first_s = view.range().end_s;
    for (int i = 1; i < 100; ++i) {
        view.update(TimeRange{0.0, 100.0 + 0.0137 * i}, 1000);
        const double columns = (view.range().end_s - first_s) / 0.01;
        ASSERT_NEAR(columns, std::round(columns), 1e-6);
    }
}

TEST(TimeView, pauseFreezesTheViewAndRememberHowFarBehindItIs) {
    TimeView view(10.0);
    view.update(TimeRange{0.0, 100.0}, 1000);
    view.setPaused(true);
    const TimeRange before = view.range();
    view.update(TimeRange{0.0, 107.5}, 1000);
    EXPECT_EQ(view.range(), before);
    EXPECT_DOUBLE_EQ(view.behind_s(), 7.5);
    EXPECT_DOUBLE_EQ(view.now_s(), 100.0);
    EXPECT_LE(view.drawn().end_s, 100.0);
    view.setPaused(false);
    EXPECT_TRUE(view.isFollowing());
    view.update(TimeRange{0.0, 107.5}, 1000);
    EXPECT_NEAR(view.range().end_s, 107.5, 0.01);
}

TEST(TimeView, scrollingBackStandsStillWhileDataArrive) {
    TimeView view(10.0);
    view.update(TimeRange{0.0, 100.0}, 1000);
    view.pan(-30.0);
    EXPECT_FALSE(view.isFollowing());
    view.update(TimeRange{0.0, 140.0}, 1000);
    EXPECT_NEAR(view.range().end_s, 70.0, 0.02);
    view.setFollowing(true);
    view.update(TimeRange{0.0, 140.0}, 1000);
    EXPECT_NEAR(view.range().end_s, 140.0, 0.02);
}

TEST(TimeView, keepsHalfAViewOfDataOnTheScreen) {
    TimeView view(10.0);
    view.update(TimeRange{0.0, 100.0}, 1000);
    view.pan(-1e6);
    EXPECT_NEAR(view.range().begin_s, -5.0, 0.02);
    view.pan(1e6);
    EXPECT_NEAR(view.range().end_s, 105.0, 0.02);
}

TEST(TimeView, zoomKeepsThePointerOrWhileFollowingTheNewestSample) {
    TimeView view(10.0);
    view.update(TimeRange{0.0, 100.0}, 1000);
    view.zoom(0.5, 92.0);
    EXPECT_TRUE(view.isFollowing());
    EXPECT_NEAR(view.range().end_s, 100.0, 0.02);
    EXPECT_NEAR(view.range().length_s(), 5.0, 1e-9);
    view.show({10.0, 20.0});
    view.zoom(0.5, 12.0);
    EXPECT_NEAR(view.range().begin_s, 11.0, 1e-9);
    EXPECT_NEAR(view.range().end_s, 16.0, 1e-9);
}

TEST(TimeView, showsAllThatIsHeldButNotBeyondThePause) {
    TimeView view(10.0);
    view.update(TimeRange{20.0, 100.0}, 1000);
    view.setPaused(true);
    view.update(TimeRange{20.0, 130.0}, 1000);
    view.showAll();
    EXPECT_NEAR(view.range().begin_s, 20.0, 1e-9);
    EXPECT_NEAR(view.range().end_s, 100.0, 1e-9);
}

TEST(TimeView, doesNotZoomBelowWhatAnySamplingShows) {
    TimeView view(10.0);
    for (int i = 0; i < 1000; ++i) {
        view.zoom(0.5, 5.0);
    }
    EXPECT_GT(view.range().length_s(), 1e-6);
}

} // namespace
} // namespace halbench::widgets
