#include "devices/open_device.h"

#include <gtest/gtest.h>

#include <cmath>

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

} // namespace
} // namespace halbench::devices
