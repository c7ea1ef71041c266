#include "app/procedures/excite/table_reference.h"
#include "app/procedures/excite/travel_reference.h"
#include "tests/app/procedures/pose_tables.h"
#include "tests/app/procedures/simulated_motor.h"

#include <cmath>

namespace halbench::app {
namespace {

std::unique_ptr<devices::Device> openPlaten() {
    auto device = devices::openDevice("sim:planar?imperfections=off&chain=ideal", {});
    EXPECT_TRUE(device) << device.error().message;
    if (!device) {
        return nullptr;
    }
    for (const auto& [name, value] : {std::pair{"coil.force_constant", -3.52301},
                                      {"feedforward.x.inertia", 0.64},
                                      {"feedforward.y.inertia", 0.64},
                                      {"feedforward.phi.inertia", 1e-3}}) {
        setParameter(**device, name, value);
    }
    return std::move(*device);
}

MoveConfig tableMove(const std::string& text, const std::string& keys = "") {
    MoveConfig config = move("table,file=p.csv" + keys, 0.0);
    const auto done = attachTable(config.reference, poseTable(text));
    EXPECT_TRUE(done) << done.error().message;
    config.duration_s = defaultDuration_s(config.reference).value_or(0.0);
    return config;
}

const std::string Timed = "time_s,x_mm,y_mm,phi_mrad\n0.5,1,0,1\n1,2,1,0\n1.5,1,2,-1\n2.5,0,0,0\n";

TEST(TableMove, timedPosesAreReachedAtTheirTimes) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    const MoveConfig config = tableMove(Timed);
    const MoveResult result = moved(*device, config);
    EXPECT_EQ(result.quality.verdict, Verdict::Good)
        << (result.quality.findings.empty() ? "" : result.quality.findings.front().message);
    EXPECT_NEAR(result.travel_s.value_or(0.0), 2.5, 1e-9);
    EXPECT_EQ(result.axis.id, "x");
    ASSERT_EQ(result.partners.size(), 2u);
    EXPECT_EQ(result.partners[0].axis.id, "y");
    EXPECT_EQ(result.partners[1].axis.id, "phi");
    EXPECT_TRUE(result.others.empty());
    EXPECT_TRUE(result.isOneOfSeveral());
    // The board follows the poses of the file: row 2 a second after the start, in single precision.
    const std::vector<double> x = result.recording.column("reference.x");
    const std::vector<double> y = result.recording.column("reference.y");
    ASSERT_GT(x.size(), 2600u);
    EXPECT_NEAR(x[1000] - x.back(), 2e-3, 1e-8); // it ends where it began
    EXPECT_NEAR(y[1000] - y.back(), 1e-3, 1e-8);
    ASSERT_TRUE(result.truth && result.contour && result.contour->truth);
    ASSERT_EQ(result.truth->rows.size(), 4u);
    EXPECT_EQ(result.truth->rows[1].line, 3u);
    EXPECT_DOUBLE_EQ(result.truth->rows[1].arrival_s, 1.0);
    EXPECT_FALSE(result.truth->rows[1].settlingTime_s); // passed without a rest
    // The lag of the filtered difference is 66 um at 0.438 m/s^2 (travel_move_test.cpp); of this table at
    // most 9 D/T^2 = 0.036 m/s^2 an axis: 6 um. With two axes, and as much again for what follows it.
    EXPECT_LT(result.contour->truth->peak, 20e-6);
    EXPECT_GT(result.contour->truth->peak, 0.0);
    EXPECT_LE(result.contour->truth->rms, result.contour->truth->peak);
    EXPECT_LE(result.contour->truth->peak,
              std::hypot(result.truth->peakError, result.partners[0].truth->peakError) + 2e-7);
    for (const RowFigures& row : result.truth->rows) {
        EXPECT_LE(std::fabs(row.error), result.truth->peakError + 1e-12);
    }
    EXPECT_EQ(parameter(*device, "path.shape"), 0.0);
}

TEST(TableMove, visitsRowsAndTellsHowTheySettle) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    const MoveConfig config = tableMove("x_mm,y_mm\n1,0\n1,1\n0,0\n",
                                        ",rate_mm_s=20,acceleration_m_s2=0.5,jerk_m_s3=20,dwell_s=0.5");
    const MoveResult result = moved(*device, config);
    EXPECT_EQ(result.quality.verdict, Verdict::Good);
    ASSERT_EQ(result.others.size(), 1u);
    EXPECT_EQ(result.others.front().axis.id, "phi");
    ASSERT_TRUE(result.truth);
    ASSERT_EQ(result.truth->rows.size(), 3u);
    // The profile ends at rest with an error of a few um, 2 % of 1 mm are 20 um.
    ASSERT_TRUE(result.truth->rows[0].settlingTime_s);
    EXPECT_LT(*result.truth->rows[0].settlingTime_s, 0.1);
    EXPECT_FALSE(result.truth->rows[1].settlingTime_s); // x does not move to this row
    ASSERT_TRUE(result.partners.at(0).truth->rows[1].settlingTime_s);
    EXPECT_LT(std::fabs(result.truth->finalError), 1e-5);
    // Half a second of rest in row 1: its reference stands.
    const std::vector<double> x = result.recording.column("reference.x");
    const auto arrival = static_cast<std::size_t>(std::ceil(1e3 * result.truth->rows[0].arrival_s));
    EXPECT_EQ(x[arrival + 1], x[arrival + 490]);
    EXPECT_NEAR(x[arrival + 1] - x.back(), 1e-3, 1e-8);
}

TEST(TableMove, oneAxisAloneMovesAndTheOthersHold) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    const MoveResult result = moved(*device, tableMove("time_s,phi_mrad\n0.5,2\n1,0\n"));
    EXPECT_EQ(result.axis.id, "phi");
    EXPECT_TRUE(result.partners.empty());
    EXPECT_EQ(result.others.size(), 2u);
    EXPECT_FALSE(result.contour); // nothing moved in the plane
}

TEST(TableMove, refusesBeforeAnythingMoves) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    const auto errorOf = [&](const MoveConfig& config) {
        const auto result = runMove(*device, config, {});
        EXPECT_FALSE(result);
        EXPECT_FALSE(device->state().isArmed);
        EXPECT_EQ(parameter(*device, "table.number"), 0.0); // nothing was written
        return result ? Error{} : result.error();
    };
    const Error far = errorOf(tableMove("time_s,x_mm\n1,2\n5,60\n"));
    EXPECT_EQ(far.code, ErrorCode::OutOfRange);
    EXPECT_TRUE(far.message.starts_with("p.csv:3: row 2: axis x goes as far as")) << far.message;
    // 38 mm in a tenth of a second behind a slow way: the spline takes a run-up.
    const Error swing = errorOf(tableMove("time_s,x_mm\n1,2\n1.1,40\n"));
    EXPECT_NE(swing.hint.find("swings out"), std::string::npos) << swing.message;
    const Error fast = errorOf(tableMove("time_s,x_mm\n1,2\n2,2\n2.1,40\n"));
    EXPECT_NE(fast.message.find("window.speed"), std::string::npos) << fast.message;
    // 3.098 N over 0.64 kg are 4.84 m/s^2; 9 D/T^2 of 10 mm in 0.1 s are 9.
    const Error hard = errorOf(tableMove("time_s,x_mm\n0.1,10\n0.2,10\n1.2,0\n"));
    EXPECT_NE(hard.message.find("accelerates at"), std::string::npos) << hard.message;
    MoveConfig named = tableMove(Timed);
    named.axis = "x";
    EXPECT_EQ(errorOf(named).code, ErrorCode::Usage);
    MoveConfig unread = move("table,file=p.csv", 2.0);
    EXPECT_EQ(errorOf(unread).code, ErrorCode::InvalidInput);
    MoveConfig brief = tableMove(Timed);
    brief.duration_s = 1.0;
    EXPECT_EQ(errorOf(brief).code, ErrorCode::InvalidInput);
    // The end of the travel: 50 mm to either side, and the platen does not stand in the middle.
    setParameter(*device, "window.x", 0.09);
    const Error end = errorOf(tableMove("time_s,x_mm\n3,-30\n6,-70\n"));
    EXPECT_NE(end.message.find("its travel ends at"), std::string::npos) << end.message;
}

TEST(TableMove, boardWithoutTablesRefuses) {
    auto device = devices::openDevice("sim:htm", {});
    ASSERT_TRUE(device);
    const auto result = runMove(**device, tableMove("time_s,angle_mrad\n1,2\n2,0\n"), {});
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("follows no table"), std::string::npos);
}

/// Ends a move when its reference has run for a while, and says how it went on.
TEST(TableMove, abortStopsTheMotionAndLeavesNoOrder) {
    const auto device = openPlaten();
    ASSERT_NE(device, nullptr);
    bool isRecording = false;
    int asked = 0;
    ProcedureObserver observer;
    observer.onState = [&](ProcedureState state) {
        isRecording = isRecording || state == ProcedureState::Record;
    };
    observer.checkAbort = [&]() -> Result<void> {
        asked += isRecording ? 1 : 0;
        return asked < 20 ? Result<void>() : failure(ErrorCode::Interrupted, "ended", "");
    };
    const auto result = runMove(*device, tableMove(Timed), observer);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Interrupted);
    EXPECT_FALSE(device->state().isArmed);
    EXPECT_EQ(parameter(*device, "path.shape"), 0.0);
}

} // namespace
} // namespace halbench::app
