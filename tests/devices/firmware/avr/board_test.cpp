#include "tests/devices/firmware/avr/avr_fixture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::simavr {
namespace {

using devices::BoardMode;

TEST(AvrBoard, describesItselfLikeTheSimulatedOne) {
    AvrBench bench = openBench();
    ASSERT_TRUE(bench.device);
    EXPECT_EQ(bench.device->info().model, "htm");
    EXPECT_FALSE(bench.device->info().firmware.empty());
    for (const char* name : {"position", "speed", "reference", "current.a", "hall.b", "coil_temperature.a",
                             "status", "fault", "torn_count", "reference.segment"}) {
        ASSERT_NE(bench.device->catalogue().findSignal(name), nullptr) << name;
    }
    EXPECT_EQ(bench.device->catalogue().findParameter("gain.kp")->unit, "A/rad");
    EXPECT_TRUE(bench.device->catalogue().findParameter("gain.kp")->isTransactional);
    EXPECT_EQ(bench.device->statistics().packetsDamaged, 0U);
}

TEST(AvrBoard, everySignalIsReadAndStandsAtRest) {
    AvrBench bench = openBench();
    ASSERT_TRUE(bench.device);
    for (const auto& signal : bench.device->catalogue().signals) {
        const double value = bench.read(signal.name);
        EXPECT_TRUE(std::isfinite(value)) << signal.name;
    }
    // one code is 0.39 mT and 0.49 K (resources/help/htm-theory.md section 5)
    EXPECT_NEAR(bench.read("hall.a"), 0.157, 4e-4);
    EXPECT_NEAR(bench.read("hall.b"), 0.0, 4e-4);
    EXPECT_NEAR(bench.read("coil_temperature.b"), 25.0, 0.5);
}

TEST(AvrBoard, everyParameterIsWrittenReadBackAndRestored) {
    AvrBench bench = openBench();
    ASSERT_TRUE(bench.device);
    for (const ParameterSpec& spec : bench.device->catalogue().parameters) {
        if (spec.name == "hb.arm" || spec.name == "hb.stop" ||
            spec.name.find(".start") != std::string::npos) {
            continue;
        }
        const double before = bench.read(spec.name);
        const double other = before == spec.max ? spec.min : spec.max;
        ASSERT_TRUE(bench.write(spec.name, other)) << spec.name;
        EXPECT_NEAR(bench.read(spec.name), other, 1e-5 * std::fabs(other)) << spec.name;
        ASSERT_TRUE(bench.write(spec.name, before)) << spec.name;
        EXPECT_EQ(bench.read(spec.name), before) << spec.name;
    }
}

TEST(AvrBoard, armsAndTurnsTheRotorToThePosition) {
    AvrBench bench = openBench();
    ASSERT_TRUE(bench.device);
    ASSERT_TRUE(bench.write("hb.mode", static_cast<double>(BoardMode::Position)));
    ASSERT_TRUE(bench.device->arm());
    ASSERT_TRUE(bench.write("hb.setpoint", 1.0));
    bench.wait(1.5);
    // the friction band of 10 A/rad: 8.21 degrees (resources/help/htm-theory.md section 6.7)
    EXPECT_NEAR(bench.board->plant().truth().rotor.angle_rad, 1.0, 0.15);
    EXPECT_NEAR(bench.read("position"), bench.board->plant().truth().rotor.angle_rad, 3e-3);
    ASSERT_TRUE(bench.device->disarm());
    EXPECT_EQ(bench.board->dacCode(0), 2048);
    EXPECT_EQ(bench.board->dacCode(1), 2048);
}

TEST(AvrBoard, silenceOfTheMasterStopsTheMotor) {
    AvrBench bench = openBench();
    ASSERT_TRUE(bench.device);
    ASSERT_TRUE(bench.write("hb.mode", static_cast<double>(BoardMode::Current)));
    ASSERT_TRUE(bench.device->arm());
    ASSERT_TRUE(bench.write("hb.setpoint", 3.0));
    bench.wait(0.5);
    EXPECT_NE(bench.board->dacCode(1), 2048);
    // The master falls silent: its process was killed. The watchdog set by arming is 1 s.
    bench.board->advanceTo(bench.board->time_s() + 1.1);
    EXPECT_EQ(bench.board->dacCode(0), 2048);
    EXPECT_EQ(bench.board->dacCode(1), 2048);
}

TEST(AvrBoard, aStopReachesABoardWithoutASession) {
    const auto board = makeBoard(perfectMotor());
    board->advanceTo(0.5);
    AvrTransport line(board);
    ASSERT_TRUE(line.open());
    std::vector<std::uint8_t> packet;
    ASSERT_TRUE(line.receive(packet, 0.5));
    const std::uint8_t stop[] = {0xF1, 0x45};
    ASSERT_TRUE(line.send(stop));
    EXPECT_FALSE(*line.receive(packet, 0.1)); // silent, but obeyed (resources/help/protocol.md 3.11)
    const std::uint8_t connect[] = {0xFF, 0x00};
    ASSERT_TRUE(line.send(connect));
    ASSERT_TRUE(*line.receive(packet, 0.1));
    ASSERT_TRUE(line.send(stop)); // now it answers with the latch
    ASSERT_TRUE(*line.receive(packet, 0.1));
    EXPECT_EQ(packet, (std::vector<std::uint8_t>{0xFF, 0x01}));
}

TEST(AvrBoard, anotherRunGivesTheSameBits) {
    std::vector<std::vector<double>> runs;
    for (int i = 0; i < 2; ++i) {
        AvrBench bench = openBench({}, 7); // with noise and all imperfections
        ASSERT_TRUE(bench.device);
        std::vector<double> values;
        const auto started = bench.device->startStream(
            {{"position", "speed", "hall.a", "current.a"}, 100.0}, [&values](const SampleBlockPtr& block) {
                for (std::size_t row = 0; row < block->rows(); ++row) {
                    values.push_back(block->time_s[row]);
                    for (std::size_t column = 0; column < 4; ++column) {
                        values.push_back(block->value(row, column));
                    }
                }
            });
        ASSERT_TRUE(started) << started.error().message;
        ASSERT_TRUE(bench.write("hb.mode", static_cast<double>(BoardMode::Current)));
        ASSERT_TRUE(bench.device->arm());
        ASSERT_TRUE(bench.write("hb.setpoint", 2.0));
        bench.wait(1.0);
        values.push_back(bench.board->plant().truth().rotor.angle_rad);
        values.push_back(static_cast<double>(bench.board->core().cycle()));
        runs.push_back(std::move(values));
    }
    EXPECT_GT(runs[0].size(), 400U);
    EXPECT_EQ(runs[0], runs[1]);
}

} // namespace
} // namespace halbench::simavr
