#include "app/procedures/record/capture_procedure.h"
#include "app/procedures/record/record_procedure.h"
#include "tests/app/procedures/simulated_motor.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr std::size_t Rows = 4096;

// Enough to cross several steps of the converter at rest: no two stretches of it look alike.
const std::string Noisy = "seed=5&hall_noise_mT=2";

CaptureConfig capture(std::vector<std::string> signals) {
    CaptureConfig config;
    config.signals = std::move(signals);
    return config;
}

// A second route to the same values: the stream of an equal board, which noise makes unmistakable.
TEST(Capture, isTheStreamAtLoopRate) {
    RecordConfig all;
    all.signals = {"hall.a", "current_command", "position", "hall.b"};
    all.rate_Hz = 1000.0;
    all.duration_s = 6.0;
    const auto stream = runRecord(*openMotor(Noisy), all, {});
    ASSERT_TRUE(stream);
    const auto device = openMotor(Noisy);
    const auto captured = runCapture(*device, capture(all.signals), {});
    ASSERT_TRUE(captured) << captured.error().message;
    ASSERT_EQ(captured->rows(), Rows);
    EXPECT_DOUBLE_EQ(captured->time_s.front(), 0.0);
    EXPECT_DOUBLE_EQ(captured->time_s.back(), 4.095);
    EXPECT_EQ(captured->layout->columns[3].unit, "T");
    const std::vector<double>& whole = stream->recording.values;
    // The capture keeps single precision; the position is streamed as a finer count times its unit.
    const auto isSame = [](double one, double other) {
        constexpr double TwoRoundings_ratio = 2.4e-7;
        return std::abs(one - other) <= TwoRoundings_ratio * std::abs(other);
    };
    const auto place =
        std::search(whole.begin(), whole.end(), captured->values.begin(), captured->values.end(), isSame);
    EXPECT_NE(place, whole.end()) << "all 4096 rows of all signals, one after the other";
    EXPECT_NE(captured->column("hall.a").front(), captured->column("hall.a").back());
}

TEST(Capture, putsTheBoardsSetUpBackAndArmsNothing) {
    const auto device = openMotor("");
    setParameter(*device, "capture.prescaler", 7.0);
    setParameter(*device, "capture.signal_2", 3.0);
    CaptureConfig config = capture({"speed"});
    config.rate_Hz = 500.0;
    const auto captured = runCapture(*device, config, {});
    ASSERT_TRUE(captured);
    EXPECT_DOUBLE_EQ(captured->time_s.back(), 8.19);
    EXPECT_EQ(captured->layout->columns.size(), 1U);
    EXPECT_EQ(parameter(*device, "capture.prescaler"), 7.0);
    EXPECT_EQ(parameter(*device, "capture.signal_2"), 3.0);
    EXPECT_EQ(parameter(*device, "capture.start"), 0.0);
    EXPECT_FALSE(device->state().isArmed);
}

// The sensors' noise crosses the mean of the Hall signal again and again, in both directions.
TEST(Capture, beginsWhereTheSignalCrossesTheLevel) {
    for (const bool isRising : {true, false}) {
        const auto device = openMotor(Noisy);
        const std::string name[] = {"hall.a"};
        CaptureConfig config = capture({"hall.a"});
        config.pretrigger_ratio = 0.25;
        config.trigger = {CaptureTrigger::Kind::Level, "hall.a", 0.0, isRising};
        RecordConfig before;
        before.signals = {"hall.a"};
        before.rate_Hz = 1000.0;
        const auto noise = runRecord(*device, before, {});
        ASSERT_TRUE(noise);
        const std::vector<double> values = noise->recording.column("hall.a");
        config.trigger.level = 0.5 * (*std::max_element(values.begin(), values.end()) +
                                      *std::min_element(values.begin(), values.end()));
        const auto captured = runCapture(*device, config, {});
        ASSERT_TRUE(captured) << captured.error().message;
        const std::vector<double> hall = captured->column("hall.a");
        const auto zero = static_cast<std::size_t>(
            std::find(captured->time_s.begin(), captured->time_s.end(), 0.0) - captured->time_s.begin());
        ASSERT_EQ(zero, Rows / 4);
        const double sign = isRising ? 1.0 : -1.0;
        EXPECT_LT(sign * hall[zero - 1], sign * config.trigger.level);
        EXPECT_GE(sign * hall[zero], sign * config.trigger.level);
    }
}

TEST(Capture, saysWhenTheTriggerDoesNotCome) {
    const auto device = openMotor("");
    setParameter(*device, "capture.trigger", 1.0);
    CaptureConfig config = capture({"speed"});
    config.trigger = {CaptureTrigger::Kind::Level, "speed", 100.0, true};
    config.patience_s = 1.0;
    const auto refused = runCapture(*device, config, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    EXPECT_EQ(parameter(*device, "capture.trigger"), 1.0) << "put back";
    EXPECT_EQ(parameter(*device, "capture.start"), 0.0) << "waits no longer";
}

TEST(Capture, refusesWhatTheBoardCannotDo) {
    const auto device = openMotor("");
    const auto code = [&](const CaptureConfig& config) {
        const auto done = runCapture(*device, config, {});
        return done ? ErrorCode::Internal : done.error().code;
    };
    EXPECT_EQ(code(capture({})), ErrorCode::Usage);
    EXPECT_EQ(code(capture({"hall.a", "hall.b", "speed", "position", "status"})), ErrorCode::Usage);
    EXPECT_EQ(code(capture({"speed", "speed"})), ErrorCode::Usage);
    EXPECT_EQ(code(capture({"posture"})), ErrorCode::UnknownName);
    CaptureConfig config = capture({"speed"});
    config.rate_Hz = 300.0;
    EXPECT_EQ(code(config), ErrorCode::OutOfRange);
    config.rate_Hz = 1000.0;
    config.pretrigger_ratio = 1.0;
    EXPECT_EQ(code(config), ErrorCode::OutOfRange);
}

TEST(CaptureTrigger, readsTheCommandLinesForm) {
    EXPECT_EQ(parseCaptureTrigger("")->kind, CaptureTrigger::Kind::Immediate);
    EXPECT_EQ(parseCaptureTrigger("now")->kind, CaptureTrigger::Kind::Immediate);
    EXPECT_EQ(parseCaptureTrigger("reference")->kind, CaptureTrigger::Kind::Reference);
    const auto falling = parseCaptureTrigger("hall.a<-1.5e-3");
    ASSERT_TRUE(falling);
    EXPECT_EQ(falling->kind, CaptureTrigger::Kind::Level);
    EXPECT_EQ(falling->signal, "hall.a");
    EXPECT_EQ(falling->level, -1.5e-3);
    EXPECT_FALSE(falling->isRising);
    for (const char* text : {"later", ">1", "speed>", "speed", "speed>1A", "<"}) {
        EXPECT_EQ(parseCaptureTrigger(text).error().code, ErrorCode::Usage) << text;
    }
    EXPECT_EQ(parseCaptureTrigger("speed>inf").error().code, ErrorCode::NotFinite);
}

} // namespace
} // namespace halbench::app
