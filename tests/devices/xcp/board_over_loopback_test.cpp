#include "devices/open/open_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>

namespace halbench::devices {
namespace {

std::unique_ptr<Device> openBoard() {
    Result<std::unique_ptr<Device>> device = openDevice("sim:htm?imperfections=off", {});
    if (!device) {
        ADD_FAILURE() << device.error().message;
        return nullptr;
    }
    return *std::move(device);
}

TEST(BoardOverLoopback, tellsItsSignalsAndParametersWithUnits) {
    const auto device = openBoard();
    ASSERT_TRUE(device);
    for (const char* name : {"position", "speed", "hall.a", "status", "torn_count", "truth.position"}) {
        EXPECT_NE(device->catalogue().findSignal(name), nullptr) << name;
    }
    EXPECT_EQ(device->catalogue().findSignal("hall.a")->unit, "T");
    EXPECT_DOUBLE_EQ(device->catalogue().findSignal("hall.a")->maxRate_Hz, 1000.0);
    const ParameterSpec* gain = device->catalogue().findParameter("gain.kp");
    ASSERT_NE(gain, nullptr);
    EXPECT_EQ(gain->unit, "A/rad");
    EXPECT_TRUE(gain->isTransactional);
    EXPECT_FALSE(device->catalogue().findParameter("hb.arm")->isTransactional);
    EXPECT_EQ(device->catalogue().findParameter("set.first"), nullptr);
    EXPECT_EQ(device->catalogue().signalForRole("position"), "position");
    EXPECT_EQ(device->info().model, "htm");
    EXPECT_FALSE(device->info().firmware.empty());
}

TEST(BoardOverLoopback, everyParameterIsWrittenReadBackAndRestored) {
    const auto device = openBoard();
    ASSERT_TRUE(device);
    for (const ParameterSpec& spec : device->catalogue().parameters) {
        if (spec.name == "hb.arm" || spec.name == "hb.stop" ||
            spec.name.find(".start") != std::string::npos) {
            continue;
        }
        const auto before = device->readParameters({&spec.name, 1});
        ASSERT_TRUE(before) << spec.name;
        const double other = (*before)[0] == spec.max ? spec.min : spec.max;
        const ParameterValue change{spec.name, other};
        const auto written = device->writeParameters({&change, 1});
        ASSERT_TRUE(written) << spec.name << ": " << written.error().message;
        const ParameterValue back{spec.name, (*before)[0]};
        const auto restored = device->writeParameters({&back, 1});
        ASSERT_TRUE(restored) << spec.name << ": " << restored.error().message;
        EXPECT_EQ(*device->readParameters({&spec.name, 1}), *before) << spec.name;
    }
}

TEST(BoardOverLoopback, streamsRowsOnTheExactDeviceClock) {
    const auto device = openBoard();
    ASSERT_TRUE(device);
    Recording recording;
    const auto started = device->startStream({{"position", "hall.a", "current_command"}, 100.0},
                                             [&](const SampleBlockPtr& block) { recording.append(*block); });
    ASSERT_TRUE(started) << started.error().message;
    ASSERT_TRUE(device->clock().waitFor(1.0));
    device->stopStream();
    ASSERT_GE(recording.rows(), 99U);
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        // Ticks of 1 us divided by 1e6 is the double next to the decimal, as is row / 100.
        EXPECT_DOUBLE_EQ(recording.time_s[row], static_cast<double>(row) / 100.0);
    }
    EXPECT_EQ(recording.lostRows, 0U);
}

TEST(BoardOverLoopback, stopLatchesUntilClearedAndRefusesArming) {
    const auto device = openBoard();
    ASSERT_TRUE(device);
    ASSERT_TRUE(device->arm());
    EXPECT_TRUE(device->state().isArmed);
    device->stop();
    EXPECT_TRUE(device->state().isStopLatched);
    EXPECT_FALSE(device->state().isArmed);
    const auto waited = device->clock().waitFor(0.1);
    ASSERT_FALSE(waited);
    EXPECT_EQ(waited.error().code, ErrorCode::SafetyStop);
    const auto armed = device->arm();
    ASSERT_FALSE(armed);
    EXPECT_EQ(armed.error().code, ErrorCode::DeviceRefused);
    ASSERT_TRUE(device->clearStop());
    ASSERT_TRUE(device->arm());
    ASSERT_TRUE(device->clock().waitFor(3.0)) << "the watchdog of 1 s must be fed while waiting";
    ASSERT_TRUE(device->disarm());
}

TEST(BoardOverLoopback, watchdogIsOursWhileArmedAndAsItWasAfterwards) {
    const std::string name = "hb.watchdog_ms";
    for (const double former : {0.0, 250.0, 2000.0}) {
        const auto device = openBoard();
        ASSERT_TRUE(device);
        const ParameterValue before{name, former};
        ASSERT_TRUE(device->writeParameters({&before, 1}));
        for (int i = 0; i < 2; ++i) {
            ASSERT_TRUE(device->arm());
            EXPECT_DOUBLE_EQ(device->readParameters({&name, 1})->front(), 1000.0);
            ASSERT_TRUE(device->disarm());
            EXPECT_DOUBLE_EQ(device->readParameters({&name, 1})->front(), former);
        }
        ASSERT_TRUE(device->arm());
        const ParameterValue wish{name, 500.0};
        ASSERT_TRUE(device->writeParameters({&wish, 1}));
        ASSERT_TRUE(device->disarm());
        EXPECT_DOUBLE_EQ(device->readParameters({&name, 1})->front(), 500.0) << "somebody set it on purpose";
    }
}

TEST(BoardOverLoopback, captureOfTheBoardIsTheStreamAtLoopRate) {
    const auto device = openBoard();
    ASSERT_TRUE(device);
    // Handles are the numbers of the signals in the board's table.
    const auto handleOf = [&](const std::string& name) {
        const auto& signals = device->catalogue().signals;
        return static_cast<double>(std::find_if(signals.begin(), signals.end(),
                                                [&](const SignalSpec& spec) { return spec.name == name; }) -
                                   signals.begin());
    };
    const std::vector<ParameterValue> setUp = {{"capture.signal_1", handleOf("current_command")},
                                               {"capture.signal_2", handleOf("speed")},
                                               {"capture.pretrigger", 0.0},
                                               {"capture.prescaler", 1.0},
                                               {"hb.mode", 1.0}};
    ASSERT_TRUE(device->writeParameters(setUp));
    ASSERT_TRUE(device->arm());
    Recording stream;
    ASSERT_TRUE(device->startStream({{"current_command", "speed"}, 1000.0},
                                    [&](const SampleBlockPtr& block) { stream.append(*block); }));
    const std::vector<ParameterValue> start = {{"capture.start", 1.0}, {"hb.setpoint", 2.0}};
    ASSERT_TRUE(device->writeParameters(start));
    ASSERT_TRUE(device->clock().waitFor(1.0));
    const auto early = device->readCapture();
    ASSERT_TRUE(early) << early.error().message;
    EXPECT_EQ(early->rows(), 0U) << "4096 samples take 4.1 s";
    ASSERT_TRUE(device->clock().waitFor(3.5));
    device->stopStream();
    auto capture = device->readCapture();
    int pieces = 1;
    for (; capture && capture->rows() == 0 && pieces < 1000; ++pieces) {
        capture = device->readCapture();
    }
    EXPECT_EQ(pieces, 64) << "64 rows each, so that none holds up the link";
    ASSERT_TRUE(capture) << capture.error().message;
    ASSERT_EQ(capture->rows(), 4096U);
    EXPECT_EQ(capture->layout->columns[1].name, "speed");
    EXPECT_DOUBLE_EQ(capture->time_s[1000], 1.0);
    // Both saw the same loop: the capture is the stream, shifted by the ticks between the two starts.
    const std::vector<double> streamed = stream.column("speed");
    const std::vector<double> captured = capture->column("speed");
    ASSERT_GT(streamed.size(), 4200U);
    std::size_t shift = 0;
    const auto isSame = [&](std::size_t offset) {
        return std::equal(captured.begin(), captured.begin() + 4000,
                          streamed.begin() + static_cast<long>(offset));
    };
    while (shift < 100 && !isSame(shift)) {
        ++shift;
    }
    EXPECT_LT(shift, 100U);
    EXPECT_GT(std::abs(captured.back()), 1.0) << "2 A turn the rotor: the comparison is not of zeros";
}

TEST(BoardOverLoopback, interruptEndsAWaitWithItsOwnCode) {
    std::atomic<int> signal{0};
    OpenOptions options;
    options.interruptSignal = &signal;
    const auto device = openDevice("sim:htm", options);
    ASSERT_TRUE(device);
    ASSERT_TRUE((*device)->clock().waitFor(0.01));
    signal = SIGINT;
    EXPECT_EQ((*device)->clock().waitFor(10.0).error().code, ErrorCode::Interrupted);
    for (const int ending : {SIGTERM, SIGHUP, SIGQUIT}) {
        signal = ending;
        EXPECT_EQ((*device)->clock().waitFor(10.0).error().code, ErrorCode::Terminated) << ending;
    }
    EXPECT_LT((*device)->clock().now_s(), 0.2);
    const ParameterValue back{"gain.kp", 10.0};
    EXPECT_TRUE((*device)->writeParameters({&back, 1})) << "restoring works after the signal";
}

} // namespace
} // namespace halbench::devices
