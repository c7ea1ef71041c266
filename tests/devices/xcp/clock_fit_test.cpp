#include "control/base/random.h"
#include "devices/xcp/clock_fit.h"
#include "devices/xcp/xcp_device.h"
#include "tests/devices/xcp/test_slave.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::devices::xcp {
namespace {

/// One reading a second; the answer needs `there_s` to the board and `back_s` to the host.
void read(ClockFit& fit, int second, double there_s, double back_s, double drift_ppm) {
    const double sent_s = second;
    const double board_s = 1000.0 + (sent_s + there_s) * (1.0 + 1e-6 * drift_ppm);
    fit.add(sent_s, sent_s + there_s + back_s, board_s);
}

TEST(ClockFit, perfectReadingsGiveTheDriftExactly) {
    for (const double drift_ppm : {0.0, 50.0, -20000.0}) {
        ClockFit fit;
        for (int second = 0; second < 10; ++second) {
            read(fit, second, 0.001, 0.001, drift_ppm);
        }
        // 1e-13 s of rounding at 1000 s over 10 s: far below 1e-3 ppm.
        EXPECT_NEAR(fit.drift()->drift_ppm, drift_ppm, 1e-3);
        EXPECT_LT(fit.drift()->uncertainty_ppm, 1e-3);
    }
}

TEST(ClockFit, saysNothingOfTooFewReadings) {
    ClockFit fit;
    for (int second = 0; second < 5; ++second) {
        read(fit, second, 0.001, 0.001, 10.0);
        EXPECT_FALSE(fit.drift());
    }
    read(fit, 5, 0.001, 0.001, 10.0);
    EXPECT_TRUE(fit.drift());
    ClockFit atOnce; // all at one time: no line goes through them
    for (int i = 0; i < 10; ++i) {
        read(atOnce, 1, 0.001, 0.001, 10.0);
    }
    EXPECT_FALSE(atOnce.drift());
}

TEST(ClockFit, slowRoundTripsDoNotCount) {
    ClockFit fit;
    for (int second = 0; second < 60; ++second) {
        const double queue_s = second % 3 == 0 ? 0.05 + 0.001 * second : 0.0; // a growing queue, one way
        read(fit, second, 0.001 + queue_s, 0.001, 30.0);
    }
    EXPECT_NEAR(fit.drift()->drift_ppm, 30.0, 1e-3);
}

TEST(ClockFit, intervalHoldsTheTruthInNominallyManyRuns) {
    Random random(1);
    int covered = 0;
    constexpr int Runs = 2000;
    constexpr double Drift_ppm = -40.0;
    for (int run = 0; run < Runs; ++run) {
        ClockFit fit;
        for (int second = 0; second < 20; ++second) {
            // Both ways 1 ms and a little more: no round trip is twice the shortest.
            const double there_s = 0.001 + 1e-5 * random.gaussian();
            const double back_s = 0.001 + 1e-5 * random.gaussian();
            read(fit, second, there_s, back_s, Drift_ppm);
        }
        const ClockDrift drift = *fit.drift();
        covered += std::abs(drift.drift_ppm - Drift_ppm) <= drift.uncertainty_ppm ? 1 : 0;
    }
    // 95 % of 2000 runs, three standard deviations of a binomial count (29), 2 % of the quantile.
    EXPECT_NEAR(covered, 1900, 35);
}

TEST(ClockFit, readingsOfTenMinutesAgoAreForgotten) {
    ClockFit fit;
    for (int second = 0; second < 1200; ++second) {
        fit.add(second, second + 0.002, second + 1e-6 * (second < 600 ? 0.0 : 100.0 * (second - 600)));
    }
    EXPECT_NEAR(fit.drift()->drift_ppm, 100.0, 1e-3);
}

/// Streams for a while from a slave whose clock runs at its own rate.
LinkStatistics streamFrom(SlaveTraits traits, bool measuresClock, std::size_t* questions = nullptr) {
    auto slave = std::make_unique<TestSlave>(traits);
    slave->answerDelay_s = 0.002;
    TestSlave* watched = slave.get();
    XcpDeviceOptions options;
    options.measuresClock = measuresClock;
    const auto device = openXcpDevice(std::move(slave), std::move(options));
    EXPECT_TRUE(device) << device.error().message;
    EXPECT_TRUE((*device)->clock().waitFor(5.0));
    EXPECT_EQ(watched->count(Command::GetDaqClock), 0U) << "only while streaming";
    EXPECT_TRUE((*device)->startStream({{"count"}, 100.0}, [](const SampleBlockPtr&) {}));
    EXPECT_TRUE((*device)->clock().waitFor(12.0));
    if (questions != nullptr) {
        *questions = watched->count(Command::GetDaqClock);
    }
    return (*device)->statistics();
}

TEST(ClockDrift, isMeasuredOnceASecondWhileStreaming) {
    SlaveTraits traits;
    traits.clockRatio = 1.0 + 250e-6;
    traits.firstTick = 0xFFFFFFFF - 8'000'000; // the counter turns over on the way
    std::size_t questions = 0;
    const LinkStatistics statistics = streamFrom(traits, true, &questions);
    EXPECT_NEAR(static_cast<double>(questions), 12.0, 1.0);
    ASSERT_TRUE(statistics.clockDrift);
    // Ticks of 1 us over 12 s: 0.1 ppm.
    EXPECT_NEAR(statistics.clockDrift->drift_ppm, 250.0, 0.2);
    EXPECT_LT(statistics.clockDrift->uncertainty_ppm, 0.5);
}

TEST(ClockDrift, isAbsentWhereNobodyAskedOrTheBoardRefuses) {
    std::size_t questions = 0;
    EXPECT_FALSE(streamFrom({}, false, &questions).clockDrift);
    EXPECT_EQ(questions, 0U);
    SlaveTraits traits;
    traits.hasClockCommand = false;
    EXPECT_FALSE(streamFrom(traits, true, &questions).clockDrift);
    EXPECT_EQ(questions, 1U) << "a board that does not know the command is asked once";
}

} // namespace
} // namespace halbench::devices::xcp
