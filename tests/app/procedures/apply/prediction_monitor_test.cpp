#include "app/procedures/apply/prediction_monitor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::app {
namespace {

/// Up to 0.5 rad about a line at 1 rad/s, for a second.
MotionEnvelope band() {
    MotionEnvelope result;
    for (int i = 0; i <= 200; ++i) {
        result.time_s.push_back(0.005 * i);
        result.angle_rad.p5.push_back(0.005 * i - 0.5);
        result.angle_rad.p95.push_back(0.005 * i + 0.5);
    }
    return result;
}

/// A move from 3 rad, at rest for 50 ms, then with this way at each time.
SampleBlockPtr block(const std::function<double(double)>& way_rad) {
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"position", "rad"}, {"reference.running", ""}};
    auto result = std::make_shared<SampleBlock>();
    result->layout = layout;
    for (int row = 0; row < 1050; ++row) {
        const bool isRunning = row >= 50;
        result->time_s.push_back(7.0 + 1e-3 * row);
        const double time_s = 1e-3 * (row - 50);
        result->values.insert(result->values.end(),
                              {3.0 + (isRunning ? way_rad(time_s) : 0.0), isRunning ? 1.0 : 0.0});
    }
    return result;
}

bool leaves(const std::function<double(double)>& way_rad) {
    const ProcedureObserver nobody;
    PredictionMonitor watch(nobody, band());
    const ProcedureObserver observer = watch.observer();
    observer.onBlock(block(way_rad));
    EXPECT_EQ(watch.hasLeft(), !observer.checkAbort());
    return watch.hasLeft();
}

TEST(BandCheck, keepsTheFirstDeparture) {
    BandCheck check(band());
    for (int row = 0; row < 1000; ++row) {
        const double time_s = 1e-3 * row;
        const bool isFar = (time_s > 0.2 && time_s < 0.21) || (time_s > 0.3 && time_s < 0.4) || time_s > 0.6;
        check.add(time_s, isFar ? time_s - 0.7 : time_s);
        EXPECT_EQ(check.departure().has_value(), time_s > 0.3155) << time_s; // 15 ms are a glitch
    }
    EXPECT_NEAR(check.departure()->at_s, 0.3, 1.5e-3);       // a row
    EXPECT_NEAR(check.departure()->beyond_rad, 0.2, 5.5e-3); // a point of the band
    EXPECT_NE(departureError(*check.departure()).message.find("at 0.301 s"), std::string::npos);
}

TEST(PredictionMonitor, aMoveInsideGoesOn) {
    EXPECT_FALSE(leaves([](double time_s) { return time_s; }));
    EXPECT_FALSE(leaves([](double time_s) { return time_s + 0.49; }));
}

TEST(PredictionMonitor, aMoveThatLeavesIsEnded) {
    EXPECT_TRUE(leaves([](double) { return 0.0; }));                 // stays behind, from 0.5 s on
    EXPECT_TRUE(leaves([](double time_s) { return 3.0 * time_s; })); // runs away
    EXPECT_TRUE(leaves([](double time_s) { return -time_s; }));      // the wrong way
    EXPECT_TRUE(leaves([](double time_s) { return time_s < 0.3 ? time_s : std::nan(""); }));
}

TEST(PredictionMonitor, aGlitchIsNone) {
    EXPECT_FALSE(leaves([](double time_s) { return std::abs(time_s - 0.3) < 0.005 ? 2.0 : time_s; }));
    EXPECT_TRUE(leaves([](double time_s) { return std::abs(time_s - 0.3) < 0.02 ? 2.0 : time_s; }));
}

TEST(PredictionMonitor, saysWhenAndHowFar) {
    const ProcedureObserver nobody;
    PredictionMonitor watch(nobody, band());
    watch.observer().onBlock(block([](double time_s) { return time_s < 0.4 ? time_s : time_s + 0.6; }));
    ASSERT_TRUE(watch.hasLeft());
    EXPECT_NE(watch.departure().message.find("at 0.4 s, by 5."),
              std::string::npos) // 0.1 rad less a point of the band
        << watch.departure().message;
    EXPECT_EQ(watch.departure().code, ErrorCode::Refused);
}

TEST(PredictionMonitor, whoeverWatchedBeforeStillHearsEverything) {
    int blocks = 0;
    bool isAborted = false;
    ProcedureObserver before;
    before.onBlock = [&](const SampleBlockPtr&) { ++blocks; };
    before.checkAbort = [&]() -> Result<void> {
        return isAborted ? Result<void>(failure(ErrorCode::Interrupted, "", "")) : Result<void>();
    };
    PredictionMonitor watch(before, band());
    const ProcedureObserver observer = watch.observer();
    observer.onBlock(block([](double time_s) { return time_s; }));
    EXPECT_EQ(blocks, 1);
    EXPECT_TRUE(observer.checkAbort());
    isAborted = true;
    EXPECT_EQ(observer.checkAbort().error().code, ErrorCode::Interrupted);
}

} // namespace
} // namespace halbench::app
