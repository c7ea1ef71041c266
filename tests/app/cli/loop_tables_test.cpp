#include "app/cli/loop_tables.h"
#include "app/documents/text/output_file.h"
#include "app/procedures/tune/loop_axis.h"
#include "app/procedures/tune/tune_axes.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

std::string firstLine(const std::string& path) {
    const auto text = readFile(path);
    EXPECT_TRUE(text) << path;
    return text ? text->substr(0, text->find('\n')) : std::string();
}

TEST(LoopTables, columnsAreInTheUnitsOfTheAxisAndNothingElseIsWritten) {
    const auto known = [](double value, const std::string& unit) {
        return control::Estimate{value, {}, control::EstimateSource::Identified, unit};
    };
    AxisModel model;
    model.axes.push_back(
        {"phi", "rad", "N*m", known(0.0, "1/s"), known(1000.0, "rad/(s^2*N*m)"), {}, {1e-3, 1}});
    LoopConditions conditions;
    conditions.timing = {1e-3, 1};
    conditions.currentLimit_A = 0.236;
    conditions.axis = LoopAxis{"phi", "rad", "N*m", 60.0, 5e-3};
    const auto tuned = tuneAxes(model, {conditions}, {});
    ASSERT_TRUE(tuned);
    const TuneResult& axis = tuned->axes.front();
    const MotorEstimate estimate = estimateOfAxis(model, model.axes.front());
    const QTemporaryDir folder;
    const auto path = [&folder](const char* name) { return folder.filePath(name).toStdString(); };
    TabledLoop loop{estimate, {axis.law, axis.filtered}, conditions, {}};
    ASSERT_TRUE(writeLoopTables({"", path("step.csv"), ""}, loop, axis.predicted));
    EXPECT_EQ(firstLine(path("step.csv")),
              "time_s,response_rad,effort_Nm,load_position_rad,load_effort_Nm,response_p5_rad,"
              "response_p95_rad,load_position_p5_rad,load_position_p95_rad");
    EXPECT_FALSE(readFile(path("bode.csv")));
    loop.conditions.axis.reset(); // of a motor
    ASSERT_TRUE(
        writeLoopTables({path("bode.csv"), path("step.csv"), path("poles.csv")}, loop, axis.predicted));
    EXPECT_TRUE(firstLine(path("step.csv")).starts_with("time_s,response_rad,current_A,load_angle_rad"));
    EXPECT_TRUE(firstLine(path("bode.csv")).starts_with("frequency_hz,magnitude_db,phase_deg,"));
    EXPECT_EQ(firstLine(path("poles.csv")), "kind,branch,gain_factor,real,imaginary");
    EXPECT_FALSE(writeLoopTables({path("step.csv/bode.csv"), "", ""}, loop, axis.predicted));
}

} // namespace
} // namespace halbench::app
