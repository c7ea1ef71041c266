#include "app/procedures/excite/table_reference.h"
#include "app/procedures/move/row_figures.h"
#include "tests/app/procedures/pose_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

MoveConfig visiting(const std::string& text, const std::string& keys) {
    MoveConfig config;
    const auto reference = parseMoveReference("table,file=p.csv" + keys);
    EXPECT_TRUE(reference);
    config.reference = *reference;
    EXPECT_TRUE(attachTable(config.reference, poseTable(text)));
    return config;
}

/// Follows the reference, but for an error that fades from each arrival on: d exp(-10 t).
MoveResponse lateResponse(const MoveConfig& config, double error, double end_s) {
    MoveResponse response;
    response.rowsPerReference = 1;
    const TabledMotion& tabled = *config.reference.table;
    for (double time = 0.0; time <= end_s + 1e-9; time += 1e-3) {
        double since = time;
        for (const double arrival : tabled.motion.arrivals_s()) {
            since = time >= arrival - 1e-9 ? std::max(0.0, time - arrival) : since;
        }
        response.time_s.push_back(time);
        response.reference.push_back(tabled.motion.at(0, time).value);
        response.position.push_back(response.reference.back() - error * std::exp(-10.0 * since));
    }
    return response;
}

const std::string Limits = ",rate_m_s=1,acceleration_m_s2=10,dwell_s=1";

TEST(RowFigures, settleWhereTheErrorStaysWithinTheWindow) {
    MoveConfig config = visiting("x_m\n1\n0\n", Limits);
    // 1 m at 1 m/s and 10 m/s^2 takes 1.1 s; 0.1 exp(-10 t) = 0.02 at ln(5)/10 = 0.161 s.
    const auto rows = measureRows(lateResponse(config, 0.1, 5.0), config, "x");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_NEAR(rows[0].arrival_s, 1.1, 1e-9);
    EXPECT_EQ(rows[0].line, 2u);
    EXPECT_NEAR(rows[0].error, 0.1, 2e-3); // within a sample of the arrival
    ASSERT_TRUE(rows[0].settlingTime_s && rows[1].settlingTime_s);
    EXPECT_NEAR(*rows[0].settlingTime_s, 0.161, 2e-3);
    EXPECT_NEAR(*rows[1].settlingTime_s, 0.161, 2e-3);
    config.settlingWindow = 1e-3; // ln(100)/10
    EXPECT_NEAR(measureRows(lateResponse(config, 0.1, 5.0), config, "x")[0].settlingTime_s.value_or(0.0),
                0.461, 2e-3);
    config.settlingWindow = 1e-9; // ln(1e8)/10 is longer than the dwell
    EXPECT_FALSE(measureRows(lateResponse(config, 0.1, 5.0), config, "x")[0].settlingTime_s);
}

TEST(RowFigures, onlyRowsThatTheRecordingReachesAndAxesOfTheTable) {
    const MoveConfig config = visiting("x_m\n1\n0\n", Limits);
    EXPECT_EQ(measureRows(lateResponse(config, 0.1, 2.0), config, "x").size(), 1u);
    EXPECT_TRUE(measureRows(lateResponse(config, 0.1, 5.0), config, "y").empty());
    EXPECT_TRUE(measureRows(lateResponse(config, 0.1, 5.0), MoveConfig{}, "x").empty());
    const MoveConfig passing = visiting("x_m\n1\n2\n", ",rate_m_s=1,acceleration_m_s2=10");
    EXPECT_FALSE(measureRows(lateResponse(passing, 0.1, 5.0), passing, "x")[0].settlingTime_s); // no dwell
}

} // namespace
} // namespace halbench::app
