#include "app/workbench/drive_control.h"
#include "app/workbench/stop_latch.h"
#include "app/workspaces/parts/preflight.h"
#include "tests/app/workspaces/bench_fixture.h"

#include <QSignalSpy>

namespace halbench::app {
namespace {

using StopLatchTest = BenchTest;

TEST_F(StopLatchTest, isReleasedOnPurposeAndNotBeforeTheLockOutHasPassed) {
    connectTo("sim:htm", 5.0);
    StopLatch& latch = bench().stopLatch();
    QSignalSpy changes(&latch, &StopLatch::changed);
    latch.setLockOut_ms(200);
    session().stopActuator();
    ASSERT_TRUE(wait([&] { return latch.isLatched(); }));
    EXPECT_TRUE(latch.isLocked());
    std::optional<ErrorCode> refused;
    latch.release(
        [&](const Result<void>& done) { refused = done ? std::nullopt : std::optional(done.error().code); });
    EXPECT_EQ(refused, ErrorCode::Refused);
    ASSERT_TRUE(wait([&] { return !latch.isLocked(); }));
    EXPECT_TRUE(latch.isLatched());
    EXPECT_EQ(changes.count(), 2); // latched, and free to release
    latch.release([](const Result<void>& done) { EXPECT_TRUE(done); });
    EXPECT_TRUE(wait([&] { return !latch.isLatched(); }));
    EXPECT_FALSE(session().report().board.isArmed);
}

TEST_F(StopLatchTest, armingWaitsAfterTheReleaseAtLeastADoubleClick) {
    connectTo("sim:htm", 5.0);
    StopLatch& latch = bench().stopLatch();
    latch.setLockOut_ms(0);
    session().stopActuator();
    ASSERT_TRUE(wait([&] { return latch.isLatched() && !latch.isLocked(); }));
    EXPECT_FALSE(bench().drive().canArm());
    latch.release([](const Result<void>& done) { EXPECT_TRUE(done); });
    ASSERT_TRUE(wait([&] { return !latch.isLatched(); }));
    EXPECT_TRUE(latch.isJustReleased());
    bench().drive().arm();
    EXPECT_FALSE(bench().drive().isPending());
    EXPECT_TRUE(wait([&] { return !latch.isJustReleased(); }));
    EXPECT_TRUE(bench().drive().canArm());
}

/// Procedures arm too: a second click, or a key that is held, right after the release must start none.
TEST_F(StopLatchTest, noProcedureStartsRightAfterTheReleaseEither) {
    connectTo("sim:htm", 5.0);
    const Preflight checks(bench());
    ASSERT_TRUE(wait([&] { return checks.isPassed(); }));
    StopLatch& latch = bench().stopLatch();
    latch.setLockOut_ms(0);
    session().stopActuator();
    ASSERT_TRUE(wait([&] { return latch.isLatched() && !latch.isLocked(); }));
    bool wasOpen = false;
    QObject::connect(&latch, &StopLatch::changed, &latch,
                     [&] { wasOpen = wasOpen || (latch.isJustReleased() && checks.isPassed()); });
    QObject::connect(&session(), &DeviceSession::reportChanged, &latch,
                     [&] { wasOpen = wasOpen || (latch.isJustReleased() && checks.isPassed()); });
    latch.release([](const Result<void>& done) { EXPECT_TRUE(done); });
    ASSERT_TRUE(wait([&] { return latch.isJustReleased(); }));
    EXPECT_FALSE(checks.isPassed());
    EXPECT_FALSE(checks.remedy().isEmpty());
    EXPECT_TRUE(wait([&] { return checks.isPassed(); }));
    EXPECT_FALSE(latch.isJustReleased());
    EXPECT_FALSE(wasOpen);
}

TEST_F(StopLatchTest, everyFurtherStopLocksAnew) {
    connectTo("sim:htm", 5.0);
    StopLatch& latch = bench().stopLatch();
    latch.setLockOut_ms(300);
    session().stopActuator();
    ASSERT_TRUE(wait([&] { return latch.isLatched() && !latch.isLocked(); }));
    session().stopActuator();
    std::optional<ErrorCode> refused; // though no report has come since
    latch.release(
        [&](const Result<void>& done) { refused = done ? std::nullopt : std::optional(done.error().code); });
    EXPECT_EQ(refused, ErrorCode::Refused);
    EXPECT_TRUE(latch.isLocked());
    EXPECT_TRUE(wait([&] { return !latch.isLocked(); }));
    EXPECT_TRUE(latch.isLatched());
}

} // namespace
} // namespace halbench::app
