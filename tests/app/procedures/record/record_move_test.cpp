#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/record/record_procedure.h"
#include "tests/app/procedures/rogue_board.h"
#include "tests/app/procedures/simulated_motor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

TEST(Record, givesRowsFromZeroUpToTheDuration) {
    const auto device = openMotor("");
    RecordConfig config;
    config.duration_s = 1.0;
    const auto result = runRecord(*device, config, {});
    ASSERT_TRUE(result) << result.error().message;
    ASSERT_EQ(result->recording.rows(), 100U);
    EXPECT_EQ(result->recording.time_s.front(), 0.0);
    EXPECT_NEAR(result->recording.time_s.back(), 0.99, 1e-9);
    EXPECT_EQ(result->quality.verdict, Verdict::Good);
    EXPECT_FALSE(device->state().isArmed);
    EXPECT_EQ(result->recording.layout->columns.size(), device->catalogue().defaultSignals.size());
}

/// A device that stands still for a while by the host's clock, as a served simulation does whose process is
/// stopped: its own time does not go on.
class StandingBoard : public RogueBoard {
public:
    StandingBoard(std::unique_ptr<devices::Device> device, double from_s, double pause_s)
        : RogueBoard(std::move(device), [](auto values) { return values; }),
          m_clock(RogueBoard::clock(), from_s, pause_s) {}
    devices::Clock& clock() override { return m_clock; }

private:
    class StandingClock : public devices::Clock {
    public:
        StandingClock(devices::Clock& inner, double from_s, double pause_s)
            : m_inner(inner), m_from_s(inner.now_s() + from_s), m_left_s(pause_s) {}
        double now_s() const override { return m_inner.now_s() + m_stood_s; }
        Result<void> waitFor(double duration_s) override {
            if (m_inner.now_s() < m_from_s || m_left_s <= 0.0) {
                return m_inner.waitFor(duration_s);
            }
            m_stood_s += duration_s;
            m_left_s -= duration_s;
            return {};
        }

    private:
        devices::Clock& m_inner;
        double m_from_s;
        double m_left_s;
        double m_stood_s = 0.0;
    };
    StandingClock m_clock;
};

// Its rows are late and not lost, and none is missing in its own time.
TEST(Record, aDeviceThatStoodStillIsWaitedForUntilItsRowsAreThere) {
    for (const double pause_s : {0.3, 0.7, 1.0}) {
        for (const double rate_Hz : {100.0, 200.0}) {
            StandingBoard device(openMotor(""), 0.4, pause_s);
            RecordConfig config;
            config.duration_s = 2.0;
            config.rate_Hz = rate_Hz;
            const auto result = runRecord(device, config, {});
            ASSERT_TRUE(result) << result.error().message;
            EXPECT_EQ(result->recording.rows(), static_cast<std::size_t>(2.0 * rate_Hz)) << pause_s;
            EXPECT_EQ(result->quality.verdict, Verdict::Good) << pause_s;
            EXPECT_EQ(result->lostRows, 0U);
        }
    }
}

// One that never goes on does not hold the recording for ever: half of the rows are no recording.
TEST(Record, aDeviceThatStandsStillForGoodEndsTheRecording) {
    StandingBoard device(openMotor(""), 0.4, 1e9);
    RecordConfig config;
    config.duration_s = 2.0;
    const double start_s = device.clock().now_s();
    const auto result = runRecord(device, config, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::DeviceLost);
    EXPECT_LT(device.clock().now_s() - start_s, 2.5);
}

TEST(Record, anOutletGetsTheRowsThatMemoryWouldHaveHeld) {
    RecordConfig config;
    config.duration_s = 0.5;
    config.rate_Hz = 1000.0;
    const auto kept = runRecord(*openMotor(""), config, {});
    ASSERT_TRUE(kept);
    Recording streamed;
    StreamLayout announced;
    const RecordOutlet outlet{[&](const StreamLayout& layout) -> Result<void> {
                                  announced = layout;
                                  return {};
                              },
                              [&](const SampleBlock& block) -> Result<void> {
                                  streamed.append(block);
                                  return {};
                              }};
    const auto result = runRecord(*openMotor(""), config, {}, &outlet);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->rows, 500U);
    EXPECT_EQ(result->recording.rows(), 0U);
    EXPECT_EQ(streamed.time_s, kept->recording.time_s);
    EXPECT_EQ(streamed.values, kept->recording.values);
    EXPECT_DOUBLE_EQ(announced.period_s, streamed.layout->period_s);
    ASSERT_EQ(announced.columns.size(), streamed.layout->columns.size());
    for (std::size_t column = 0; column < announced.columns.size(); ++column) {
        EXPECT_EQ(announced.columns[column].name, streamed.layout->columns[column].name);
        EXPECT_EQ(announced.columns[column].unit, streamed.layout->columns[column].unit);
    }
}

TEST(Record, aDiskThatIsSlowToBeginCostsNoRow) {
    for (const double slow_s : {0.2, 1.5, 10.0}) {
        const auto device = openMotor("");
        RecordConfig config;
        config.duration_s = 2.0;
        config.rate_Hz = 1000.0;
        Recording streamed;
        const RecordOutlet outlet{[&](const StreamLayout&) { return device->clock().waitFor(slow_s); },
                                  [&](const SampleBlock& block) -> Result<void> {
                                      streamed.append(block);
                                      return {};
                                  }};
        const auto result = runRecord(*device, config, {}, &outlet);
        ASSERT_TRUE(result);
        EXPECT_EQ(streamed.rows(), 2000U) << slow_s;
        EXPECT_EQ(result->lostRows, 0U);
        EXPECT_EQ(result->quality.verdict, Verdict::Good);
    }
}

TEST(Record, noFileIsBegunBeforeTheRecordingIsAllowed) {
    const auto device = openMotor("");
    ProcedureState last = ProcedureState::Prepare;
    ProcedureObserver observer;
    observer.onState = [&last](ProcedureState state) { last = state; };
    observer.checkAbort = [&last]() -> Result<void> {
        return last == ProcedureState::Record ? failure(ErrorCode::Interrupted, "cancelled by the user", "")
                                              : Result<void>();
    };
    bool hasBegun = false;
    const RecordOutlet outlet{[&](const StreamLayout&) -> Result<void> {
                                  hasBegun = true;
                                  return {};
                              },
                              [](const SampleBlock&) { return Result<void>(); }};
    const auto result = runRecord(*device, {}, observer, &outlet);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Interrupted);
    EXPECT_FALSE(hasBegun);
}

TEST(Record, endsSoonWithTheErrorOfItsOutlet) {
    const auto device = openMotor("");
    RecordConfig config;
    config.duration_s = 1000.0;
    const RecordOutlet outlet{[](const StreamLayout&) { return Result<void>(); },
                              [](const SampleBlock& block) -> Result<void> {
                                  return block.time_s.back() < 1.0
                                             ? Result<void>()
                                             : failure(ErrorCode::FileSystem, "the disk is full", "");
                              }};
    const auto result = runRecord(*device, config, {}, &outlet);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::FileSystem);
    EXPECT_LT(device->clock().now_s(), 2.0);
}

/// A motor that spins up by 3 A for ever, so that its speed passes a level once.
std::unique_ptr<devices::Device> spinningUp() {
    auto device = openMotor("");
    setParameter(*device, "hb.mode", static_cast<double>(devices::BoardMode::Current));
    EXPECT_TRUE(device->arm());
    setParameter(*device, "hb.setpoint", 3.0);
    return device;
}

RecordConfig uponSpeed(double preTrigger_s, double duration_s) {
    RecordConfig config;
    config.signals = {"position", "current.a"};
    config.rate_Hz = 500.0;
    config.duration_s = duration_s;
    config.trigger = RecordTrigger{*parseCaptureTrigger("speed>10"), preTrigger_s, 10.0};
    return config;
}

TEST(Record, aTriggeredOneIsAPieceOfThePlainOneOfTheSameSeed) {
    RecordConfig plainConfig = uponSpeed(0.0, 4.0);
    plainConfig.trigger.reset();
    plainConfig.signals.push_back("speed");
    const auto plain = runRecord(*spinningUp(), plainConfig, {});
    ASSERT_TRUE(plain) << plain.error().message;
    const std::vector<double> speed = plain->recording.column("speed");
    std::size_t event = 1;
    while (event < speed.size() && !(speed[event - 1] < 10.0 && speed[event] >= 10.0)) {
        ++event;
    }
    ASSERT_LT(event, speed.size());
    ASSERT_GT(event, 60U);
    for (const double before_s : {0.0, 0.1, 60.0}) { // the last is more than there was
        const auto piece = runRecord(*spinningUp(), uponSpeed(before_s, 0.5), {});
        ASSERT_TRUE(piece) << piece.error().message;
        ASSERT_TRUE(piece->trigger_s);
        // The level is passed between the rows event - 1 and event.
        const std::size_t first = before_s > 1.0 ? 0 : event - static_cast<std::size_t>(before_s * 500.0);
        const std::size_t last = event + 250;
        ASSERT_EQ(piece->rows, last - first) << before_s;
        const auto columns = static_cast<std::ptrdiff_t>(plain->recording.layout->columns.size());
        const auto begin = plain->recording.values.begin();
        EXPECT_EQ(piece->recording.values,
                  std::vector<double>(begin + static_cast<std::ptrdiff_t>(first) * columns,
                                      begin + static_cast<std::ptrdiff_t>(last) * columns))
            << before_s;
        EXPECT_EQ(piece->recording.time_s.front(), 0.0);
        for (std::size_t row = 0; row < piece->rows; ++row) {
            EXPECT_DOUBLE_EQ(piece->recording.time_s[row], 0.002 * static_cast<double>(row));
        }
        const double share = (10.0 - speed[event - 1]) / (speed[event] - speed[event - 1]);
        EXPECT_NEAR(*piece->trigger_s, 0.002 * (static_cast<double>(event - first) - 1.0 + share), 1e-9);
        EXPECT_EQ(piece->quality.verdict, Verdict::Good);
        EXPECT_EQ(piece->lostRows, 0U);
    }
}

TEST(Record, aTriggerThatDoesNotComeIsRefusedAfterItsPatience) {
    const auto device = openMotor("");
    RecordConfig config = uponSpeed(1.0, 0.5);
    config.trigger->patience_s = 2.0;
    const auto result = runRecord(*device, config, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Refused);
    EXPECT_NEAR(device->clock().now_s(), 2.0, 0.2);
}

TEST(Record, refusesWhatIsNoTriggerOfAStream) {
    const auto device = openMotor("");
    RecordConfig config = uponSpeed(1.0, 0.5);
    config.trigger->event.kind = CaptureTrigger::Kind::Reference;
    EXPECT_EQ(runRecord(*device, config, {}).error().code, ErrorCode::Usage);
    for (const double bad : {-1.0, std::nan(""), 1e9}) {
        EXPECT_EQ(runRecord(*device, uponSpeed(bad, 0.5), {}).error().code, ErrorCode::OutOfRange);
    }
    config = uponSpeed(1.0, 0.5);
    config.trigger->patience_s = 0.0;
    EXPECT_EQ(runRecord(*device, config, {}).error().code, ErrorCode::OutOfRange);
    EXPECT_FALSE(device->state().isArmed);
}

TEST(TriggeredRows, aGapInWhatWasHeldStaysAGap) {
    std::vector<SampleBlock> given;
    auto rows =
        TriggeredRows::create({*parseCaptureTrigger("a>50"), 1.0, 10.0}, [&](const SampleBlock& block) {
            given.push_back(block);
            return Result<void>();
        });
    ASSERT_TRUE(rows);
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"a", "A"}};
    layout->period_s = 0.01;
    const auto send = [&](int from, int to, std::uint64_t lostRows) {
        SampleBlock block;
        block.layout = layout;
        block.lostRows = lostRows;
        for (int row = from; row < to; ++row) {
            block.time_s.push_back(0.01 * row);
            block.values.push_back(row - 200.0);
        }
        ASSERT_TRUE(rows->take(block));
    };
    send(0, 180, 0);
    send(200, 240, 20);
    EXPECT_TRUE(given.empty());
    send(240, 260, 0); // -10 ... 59: passes 50 at row 250
    send(260, 300, 0);
    ASSERT_TRUE(rows->hasEvent());
    EXPECT_DOUBLE_EQ(rows->event_s(), 2.5);
    ASSERT_EQ(given.size(), 4U);
    EXPECT_EQ(given[0].values.front(), -50.0); // row 150: one second before
    EXPECT_EQ(given[0].rows(), 30U);
    EXPECT_EQ(given[0].lostRows, 0U);
    EXPECT_EQ(given[1].lostRows, 20U);
    EXPECT_EQ(given[1].time_s.front(), 0.5);
    EXPECT_EQ(given[3].time_s.back(), 1.49);
    EXPECT_EQ(rows->trigger_s(), 1.0);
}

TEST(Record, refusesWhatTheDeviceCannotDo) {
    const auto device = openMotor("");
    RecordConfig config;
    config.signals = {"position", "posture"};
    EXPECT_EQ(runRecord(*device, config, {}).error().code, ErrorCode::UnknownName);
    config.signals = {"position"};
    for (const double bad : {0.0, -1.0, std::nan("")}) {
        config.duration_s = bad;
        EXPECT_EQ(runRecord(*device, config, {}).error().code, ErrorCode::OutOfRange);
    }
    config.duration_s = 1.0;
    config.rate_Hz = 300.0; // does not divide 1000
    const auto refused = runRecord(*device, config, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::OutOfRange);
}

TEST(MoveReference, readsTheCommandLinesForm) {
    const auto sine = parseMoveReference("sine,amplitude_deg=360,period_s=5");
    ASSERT_TRUE(sine);
    EXPECT_EQ(sine->shape, MoveReference::Shape::Sine);
    EXPECT_NEAR(sine->amplitude, 2.0 * Pi, 1e-12);
    EXPECT_NEAR(sine->frequency_Hz, 0.2, 1e-12);
    const auto stairs = parseMoveReference("staircase,amplitude_deg=0.32,period_s=1,count=10");
    ASSERT_TRUE(stairs);
    EXPECT_EQ(stairs->count, 10);
    EXPECT_EQ(stairs->period_s, 1.0);
}

TEST(MoveReference, refusesWhatIsNoReference) {
    const std::pair<const char*, ErrorCode> cases[] = {
        {"", ErrorCode::UnknownName},
        {"jump,amplitude_deg=1", ErrorCode::UnknownName},
        {"step", ErrorCode::InvalidInput},
        {"step,amplitude_deg", ErrorCode::InvalidInput},
        {"step,amplitude_deg=", ErrorCode::InvalidInput},
        {"step,amplitude_deg=1,5", ErrorCode::InvalidInput},
        {"step,amplitude=1", ErrorCode::UnknownName},
        {"step,amplitude_deg=nan", ErrorCode::NotFinite},
        {"step,amplitude_deg=1e9", ErrorCode::OutOfRange},
        {"sine,amplitude_deg=10", ErrorCode::InvalidInput},
        {"staircase,amplitude_deg=1,count=1.5", ErrorCode::OutOfRange},
        {"chirp,amplitude_deg=10,frequency_hz=1", ErrorCode::InvalidInput},
        {"ramp,amplitude_deg=10", ErrorCode::InvalidInput}};
    for (const auto& [text, code] : cases) {
        const auto refused = parseMoveReference(text);
        ASSERT_FALSE(refused) << text;
        EXPECT_EQ(refused.error().code, code) << text;
    }
}

TEST(MoveReference, asksForAsMuchRoomAsItNeeds) {
    EXPECT_NEAR(referenceExcursion(*parseMoveReference("ramp,rate_rad_s=2"), 3.0), 6.0, 1e-12);
    EXPECT_NEAR(referenceExcursion(*parseMoveReference("ramp,rate_rad_s=2,amplitude_rad=1"), 3.0), 1.0,
                1e-12);
    EXPECT_NEAR(referenceExcursion(*parseMoveReference("staircase,amplitude_rad=0.5,count=4"), 9.0), 2.0,
                1e-12);
    EXPECT_NEAR(referenceExcursion(*parseMoveReference("step,amplitude_rad=-3,base_rad_s=1"), 2.0), 5.0,
                1e-12);
}

MoveResponse delayedSine(double gain, double delay_rad) {
    MoveResponse response;
    response.rowsPerReference = 1;
    for (int i = 0; i <= 10000; ++i) {
        const double phase_rad = 2.0 * Pi * 0.5 * i * 1e-3;
        response.time_s.push_back(i * 1e-3);
        response.reference.push_back(std::sin(phase_rad));
        response.position.push_back(gain * std::sin(phase_rad - delay_rad));
    }
    return response;
}

TEST(MoveFigures, findGainAndPhaseOfASine) {
    MoveConfig config;
    config.reference.shape = MoveReference::Shape::Sine;
    config.reference.amplitude = 1.0;
    config.reference.frequency_Hz = 0.5;
    config.duration_s = 10.0;
    const auto figures = measureMove(delayedSine(1.2, 0.3), config);
    ASSERT_TRUE(figures);
    EXPECT_NEAR(figures->gain_ratio.value_or(0), 1.2, 1e-9);
    EXPECT_NEAR(figures->phase_deg.value_or(0), -radiansToDegrees(0.3), 1e-6);
    // |1 - 1.2 e^(-0.3 i)| is the amplitude of the error, its rms is that over sqrt 2
    const double amplitude = std::hypot(1.0 - 1.2 * std::cos(0.3), 1.2 * std::sin(0.3));
    EXPECT_NEAR(figures->maxError, amplitude, 1e-5);
    EXPECT_NEAR(figures->rmsError, amplitude / std::sqrt(2.0), 1e-4); // both ends of the part count
}

TEST(MoveFigures, countOnlyTheSettledPartOfAStaircase) {
    MoveConfig config;
    config.reference.shape = MoveReference::Shape::Staircase;
    config.reference.amplitude = 1.0;
    config.reference.count = 2;
    config.duration_s = 2.0;
    MoveResponse response;
    response.rowsPerReference = 1;
    for (int i = 0; i < 2000; ++i) {
        const double late = i % 1000 < 500 ? 0.5 : 0.01; // large while it moves
        response.time_s.push_back(i * 1e-3);
        response.reference.push_back(i < 1000 ? 1.0 : 2.0);
        response.position.push_back(response.reference.back() - late);
    }
    const auto figures = measureMove(response, config);
    ASSERT_TRUE(figures);
    EXPECT_NEAR(figures->maxError, 0.01, 1e-12);
    EXPECT_NEAR(figures->peakError, 0.5, 1e-12);
}

TEST(MoveFigures, refuseAResponseThatIsNotOne) {
    EXPECT_EQ(measureMove({{0.0}, {0.0}, {0.0}}, {}).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(measureMove({{0.0, 0.1}, {0.0}, {0.0, 0.0}}, {}).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(measureMove({{0.0, 0.1}, {0.0, 0.0}, {0.0, std::nan("")}}, {}).error().code,
              ErrorCode::NotFinite);
}

TEST(Move, endsWithASafetyStopWhenTheSpeedWindowIsLeft) {
    const auto device = openMotor("imperfections=off");
    MoveConfig config = move("step,amplitude_deg=300", 3);
    config.speedLimit_rad_s = 5.0;
    const auto result = runMove(*device, config, {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::SafetyStop);
    EXPECT_FALSE(device->state().isArmed);
    EXPECT_EQ(parameter(*device, "window.speed"), 40.0);
}

TEST(Move, waitsForTheRotorToRestBeforeItStarts) {
    const auto device = openMotor(FullChain);
    moved(*device, move("ramp,rate_deg_s=500", 2)); // leaves it coasting
    const MoveResult result = moved(*device, move("step,amplitude_deg=100", 3));
    EXPECT_NEAR(result.truth->overshoot_percent.value_or(0), 33.3, 0.5);
}

TEST(Move, sameSeedGivesTheSameBits) {
    const auto run = [](const char* query) {
        return moved(*openMotor(query), move("step,amplitude_deg=100", 2));
    };
    EXPECT_EQ(run("seed=4").recording.values, run("seed=4").recording.values);
    EXPECT_NE(run("seed=4").recording.values, run("seed=5").recording.values);
}

TEST(CoilForecast, agreesWithTheDerivedTimes) {
    // Section 9: 4 A held in one phase reaches 80 degC in 71 s; 2 A rotating (2 A^2 mean) 60.1 degC after 600
    // s.
    const models::CoilHeatingConfig model;
    const CoilTemperatures cold;
    EXPECT_NEAR(forecastCoil_degC(model, cold, 16.0, 71.0), 80.0, 0.5);
    EXPECT_NEAR(forecastCoil_degC(model, cold, 2.0, 600.0), 60.1, 0.1);
}

TEST(CoilForecast, neverForecastsCoolingBelowThePresent) {
    const CoilTemperatures warm{60.0, 50.0};
    EXPECT_EQ(forecastCoil_degC(models::CoilHeatingConfig{}, warm, 0.0, 100.0), 60.0);
}

TEST(CoilForecast, refusesAMoveThatWouldOverheatBeforeItIsArmed) {
    const auto device = openMotor("imperfections=off");
    MoveConfig config =
        move("chirp,amplitude_deg=50,frequency_hz=0.1,frequency_end_hz=5", 120); // no ideal form
    const auto refused = runMove(*device, config, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
    EXPECT_EQ(device->clock().now_s(), 0.0);
}

} // namespace
} // namespace halbench::app
