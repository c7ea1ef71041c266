#include "app/workspaces/actuators/spherical/live_field_rows.h"
#include "tests/app/workspaces/bench_fixture.h"

#include <algorithm>

namespace halbench::app {
namespace {

using LiveFieldRowsTest = BenchTest;

TEST_F(LiveFieldRowsTest, areTheLastRowsWithTheirUsualNames) {
    connectTo("sim:spherical?motion=5", 5.0);
    const std::vector<std::string> signalNames = liveFieldSignals(session().catalogue());
    ASSERT_EQ(signalNames.size(), 13U); // nine fields, the coil's current, three true angles
    EXPECT_EQ(liveFieldRows(bench(), 10.0).recording.rows(), 0U); // nobody streams them
    bench().liveSignals().want(&session(), signalNames);
    ASSERT_TRUE(wait([&] { return liveFieldRows(bench(), 10.0).recording.rows() > 1500; }));
    const Recording rows = liveFieldRows(bench(), 1.0).recording;
    EXPECT_NEAR(rows.time_s.back() - rows.time_s.front(), 1.0, 0.01);
    const auto& columns = rows.layout->columns;
    ASSERT_EQ(columns.size(), 13U);
    EXPECT_EQ(columns[0].name, "field.0.r");
    EXPECT_EQ(columns[0].unit, "T");
    EXPECT_EQ(columns[12].name, "truth.gamma");
}

TEST_F(LiveFieldRowsTest, ofAnotherDeviceThereAreNone) {
    connectTo("sim:htm", 5.0);
    EXPECT_EQ(liveFieldRows(bench(), 10.0).recording.rows(), 0U);
}

} // namespace
} // namespace halbench::app
