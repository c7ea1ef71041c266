#include "app/procedures/move/move_procedure.h"
#include "app/session/device_session.h"

#include <QtCore/QCoreApplication>
#include <QtTest/QTest>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

constexpr int Patience_ms = 100000; // a race detector on a busy machine is a hundred times slower

/// At a high speed of simulated time a thread that is late by a few milliseconds is late by seconds of the
/// device: nothing of a move may be missing because of that.
class PacedMove : public testing::TestWithParam<double> {
protected:
    Result<MoveResult> moveOnce() {
        std::optional<Result<MoveResult>> result;
        session.runProcedure(
            "move",
            [](devices::Device& device, const ProcedureObserver& observer) {
                MoveConfig config;
                config.reference = *parseMoveReference("step,amplitude_deg=30");
                config.duration_s = 3.0;
                return runMove(device, config, observer);
            },
            [&result](Result<MoveResult> found) { result = std::move(found); });
        EXPECT_TRUE(QTest::qWaitFor([&] { return result.has_value(); }, Patience_ms));
        return *result;
    }

    int m_argumentCount = 1;
    char m_name[5] = "test";
    char* m_arguments[2] = {m_name, nullptr};
    QCoreApplication application{m_argumentCount, m_arguments};
    DeviceSession session;
};

TEST_P(PacedMove, isRecordedToItsEnd) {
    session.connectDevice("sim:htm", {GetParam()});
    ASSERT_TRUE(QTest::qWaitFor([&] { return session.state() == SessionState::Connected; }, Patience_ms));
    for (int run = 0; run < 5; ++run) {
        const Result<MoveResult> move = moveOnce();
        ASSERT_TRUE(move) << move.error().message;
        ASSERT_FALSE(move->recording.time_s.empty());
        EXPECT_NEAR(move->recording.time_s.back(), 3.0, 1e-3) << run; // a sample of 1 kHz
        EXPECT_EQ(move->recording.rows(), 3001U) << run;
        EXPECT_EQ(move->recording.lostRows, 0U) << run;
    }
}

INSTANTIATE_TEST_SUITE_P(Speeds, PacedMove, testing::Values(20.0, 100.0, 1000.0));

} // namespace
} // namespace halbench::app
