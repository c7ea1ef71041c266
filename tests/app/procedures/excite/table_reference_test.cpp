#include "app/procedures/excite/move_reference_keys.h"
#include "app/procedures/excite/table_reference.h"
#include "app/procedures/excite/travel_reference.h"
#include "tests/app/procedures/pose_tables.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

MoveReference wanted(const std::string& keys = "") {
    const auto reference = parseMoveReference("table,file=p.csv" + keys);
    EXPECT_TRUE(reference) << reference.error().message;
    return reference.value_or(MoveReference{});
}

PoseTable tableOf(const std::string& text) {
    return poseTable(text);
}

MoveReference attached(const std::string& text, const std::string& keys = "") {
    MoveReference reference = wanted(keys);
    const auto done = attachTable(reference, tableOf(text));
    EXPECT_TRUE(done) << done.error().message;
    return reference;
}

Error refusal(const std::string& text, const std::string& keys = "") {
    MoveReference reference = wanted(keys);
    const auto done = attachTable(reference, tableOf(text));
    EXPECT_FALSE(done) << text;
    return done ? Error{} : done.error();
}

TEST(TableReference, hasAFileAndLimitsOfBothKinds) {
    const MoveReference reference = wanted(",rate_mm_s=20,acceleration_m_s2=0.5,rate_mrad_s=10,acceleration_"
                                           "rad_s2=1,jerk_rad_s3=30,dwell_s=0.2");
    EXPECT_EQ(reference.shape, MoveReference::Shape::Table);
    EXPECT_EQ(reference.file, "p.csv");
    EXPECT_DOUBLE_EQ(reference.rate, 0.02);
    EXPECT_DOUBLE_EQ(reference.turning.rate, 0.01);
    EXPECT_DOUBLE_EQ(reference.turning.acceleration, 1.0);
    EXPECT_DOUBLE_EQ(reference.turning.jerk.value_or(0.0), 30.0);
    EXPECT_FALSE(reference.jerk);
    EXPECT_DOUBLE_EQ(reference.dwell_s, 0.2);
    EXPECT_FALSE(travelTime_s(reference)); // not before the file is read
}

TEST(TableReference, keysThatDoNotBelongTogetherAreRefused) {
    for (const char* text :
         {"table", "table,file=", "table,file=p.csv,amplitude_mm=2", "table,file=p.csv,base_um_s=1",
          "table,file=p.csv,heading_deg=3", "step,amplitude_mm=1,file=p.csv", "step,amplitude_mm=1,dwell_s=1",
          "table,file=p.csv,file=q.csv", "table,file=p.csv,dwell_s=-1"}) {
        EXPECT_FALSE(parseMoveReference(text)) << text;
    }
}

TEST(TableReference, settingsOfEveryPathHaveAKeyInSi) {
    using Shape = MoveReference::Shape;
    for (const Shape shape : {Shape::Circle, Shape::Raster, Shape::Arc, Shape::Line, Shape::Table}) {
        MoveReference reference;
        reference.shape = shape;
        reference.file = shape == Shape::Table ? "p.csv" : "";
        for (const ReferenceSetting& setting : settingsOf(shape)) {
            const SettingSpec spec = settingSpec(setting);
            EXPECT_TRUE(spec.key.starts_with(setting.stem));
            EXPECT_FALSE(spec.help.empty());
            EXPECT_LE(spec.help.size(), 60u) << spec.help; // a tooltip
            EXPECT_TRUE(setMoveReference(reference, spec.key, 1.0)) << spec.key;
        }
        EXPECT_TRUE(checkMoveReference(reference)) << moveShapeName(shape); // they are all that it needs
    }
    EXPECT_TRUE(settingsOf(Shape::Step).empty());
    using enum MoveReference::Quantity;
    EXPECT_EQ(settingSpec({"rate", Length}).unit, "m/s");
    EXPECT_EQ(settingSpec({"acceleration", Angle}).unit, "rad/s^2");
    EXPECT_EQ(settingSpec({"jerk", Length}).key, "jerk_m_s3");
    EXPECT_EQ(settingSpec({"heading", Length}).unit, "rad");
    EXPECT_EQ(settingSpec({"dwell", Length}).unit, "s");
    EXPECT_EQ(settingSpec({"turns", Length}).unit, "");
    EXPECT_TRUE(settingSpec({"turns", Length}).isWhole);
}

TEST(TableReference, tellsItsTravelTimeAndItsPoses) {
    const MoveReference timed = attached("time_s,x_mm,phi_mrad\n1,2,0\n3,-1,4\n");
    EXPECT_NEAR(travelTime_s(timed).value_or(0.0), 3.0, 1e-12);
    EXPECT_NEAR(defaultDuration_s(timed).value_or(0.0), 4.0, 1e-12);
    EXPECT_NEAR(referenceAt(timed, 1.0, "x").value_or(0.0), 2e-3, 1e-15);
    EXPECT_NEAR(referenceAt(timed, 9.0, "phi").value_or(0.0), 4e-3, 1e-15);
    EXPECT_FALSE(referenceAt(timed, 1.0, "y"));
    EXPECT_GE(referenceExcursion(timed, 4.0, "x"), 2e-3);
    EXPECT_GE(referenceExcursion(timed, 4.0), 4e-3);
    EXPECT_EQ(referenceExcursion(timed, 4.0, "y"), 0.0);
    // d/v + v/a: 2 mm, dwell, 3 mm.
    const MoveReference visited =
        attached("x_mm\n2\n-1\n", ",rate_mm_s=20,acceleration_m_s2=0.5,dwell_s=0.5");
    EXPECT_NEAR(travelTime_s(visited).value_or(0.0), 0.1 + 0.04 + 0.5 + 0.15 + 0.04, 1e-12);
}

TEST(TableReference, asksForTheLimitsOfWhatMoves) {
    const std::string lengths = ",rate_mm_s=20,acceleration_m_s2=0.5";
    EXPECT_NE(refusal("x_mm,phi_mrad\n1,0\n2,3\n").message.find("rate_m_s"), std::string::npos);
    EXPECT_NE(refusal("x_mm\n1\n2\n", ",rate_mm_s=20").message.find("acceleration_m_s2"), std::string::npos);
    const Error turn = refusal("x_mm,phi_mrad\n1,0\n2,3\n", lengths);
    EXPECT_TRUE(turn.message.starts_with("p.csv:1:")) << turn.message;
    EXPECT_NE(turn.message.find("phi_mrad needs rate_rad_s"), std::string::npos) << turn.message;
    attached("x_mm,phi_mrad\n1,0\n2,0\n", lengths); // phi stays
    EXPECT_NE(refusal("time_s,x_mm\n1,1\n2,2\n", ",dwell_s=1").hint.find("pause"), std::string::npos);
}

TEST(TableReference, limitsOfATimedTableNameRowValueAndLimit) {
    const std::string text = "time_s,x_mm\n1,1\n3,1\n\n3.5,20\n"; // a pause, then 19 mm in half a second
    attached(text);
    for (const auto& [key, word] : {std::pair{",rate_mm_s=20", "moves at"},
                                    {",acceleration_m_s2=0.5", "accelerates at"},
                                    {",jerk_m_s3=1", "has a jerk of"}}) {
        const Error error = refusal(text, key);
        EXPECT_EQ(error.code, ErrorCode::OutOfRange) << key;
        EXPECT_TRUE(error.message.starts_with("p.csv:5: row 3: axis x ")) << error.message;
        EXPECT_NE(error.message.find(word), std::string::npos) << error.message;
    }
    // One interval of 1 s over 1 mm: 9/4 mm/s, 9 mm/s^2, 54 mm/s^3 (pose_motion_test.cpp).
    const std::string one = "time_s,x_mm\n0,0\n1,1\n";
    attached(one, ",rate_mm_s=2.26,acceleration_mm_s2=9.01,jerk_mm_s3=54.01");
    EXPECT_NE(refusal(one, ",rate_mm_s=2.24").message.find("0.00225 m/s, the limit is 0.00224 m/s"),
              std::string::npos);
    EXPECT_NE(refusal(one, ",acceleration_mm_s2=8.99").message.find("0.009 m/s^2"), std::string::npos);
    EXPECT_NE(refusal(one, ",jerk_mm_s3=53.9").message.find("0.054 m/s^3"), std::string::npos);
}

TEST(TableReference, aPoseAtTimeZeroIsWhereItStands) {
    const Error error = refusal("time_s,x_mm\n0,1\n1,2\n");
    EXPECT_TRUE(error.message.starts_with("p.csv:2:")) << error.message;
    EXPECT_NE(error.message.find("time 0"), std::string::npos);
    EXPECT_NE(refusal("time_s,x_mm\n0,0\n1,0\n").message.find("move nothing"), std::string::npos);
}

devices::Catalogue boardWithTable(double pieces) {
    devices::Catalogue catalogue;
    for (const auto& [id, unit] : {std::pair{"a", "m"}, {"b", "rad"}}) {
        devices::AxisSpec axis;
        axis.id = id;
        axis.positionUnit = unit;
        catalogue.axes.push_back(axis);
    }
    for (const char* name : {"table.number", "table.duration"}) {
        ParameterSpec spec;
        spec.name = name;
        spec.max = pieces;
        catalogue.parameters.push_back(spec);
    }
    return catalogue;
}

TEST(TableReference, axesAreThoseOfTheDevice) {
    const devices::Catalogue board = boardWithTable(100.0);
    const auto codeAndPlace = [&](const std::string& text) {
        const auto axes = tableAxes(board, attached(text));
        EXPECT_FALSE(axes) << text;
        return axes ? std::string() : axes.error().message;
    };
    const auto axes = tableAxes(board, attached("time_s,b_mrad,a_mm\n1,2,0\n2,3,0\n"));
    ASSERT_TRUE(axes) << axes.error().message;
    ASSERT_EQ(axes->size(), 1u); // a stays
    EXPECT_EQ(axes->front().id, "b");
    EXPECT_NE(codeAndPlace("time_s,a_mm,z_mm\n1,1,1\n2,2,2\n").find("p.csv:1:13: the device has no axis 'z'"),
              std::string::npos);
    EXPECT_NE(codeAndPlace("time_s,a_mrad\n1,1\n2,2\n").find("axis a is in m, not in rad (a_mrad)"),
              std::string::npos);
    EXPECT_FALSE(tableAxes(devices::Catalogue{}, attached("time_s,a_mm\n1,1\n2,2\n")));
    EXPECT_FALSE(tableAxes(board, wanted())); // the file was not read
    // Two intervals and two further knots are four pieces.
    EXPECT_TRUE(tableAxes(boardWithTable(4.0), attached("time_s,a_mm\n1,1\n2,2\n")));
    const auto full = tableAxes(boardWithTable(3.0), attached("time_s,a_mm\n1,1\n2,2\n"));
    ASSERT_FALSE(full);
    EXPECT_NE(full.error().message.find("4 pieces, the board has room for 3"), std::string::npos);
    EXPECT_FALSE(tableAxes(boardWithTable(5.0), attached("time_s,a_mm\n1,1\n20,2\n"))); // one lasts 9.5 s
}

TEST(TableReference, everyRowAndTheWayBetweenStayWithinTheWindows) {
    const MoveReference reference = attached("time_s,x_mm\n1,2\n3,3\n4,20\n");
    const auto error = [&](const TableAxisLimits& limits) {
        const auto kept = checkTableLimits(reference, {limits});
        return kept ? std::string() : kept.error().message;
    };
    EXPECT_EQ(error({"x", 0.021, "window.x", 1.0, "window.speed"}), "");
    EXPECT_EQ(error({"y", 0.0, "window.y", 0.0, "window.speed"}), ""); // not in the table
    EXPECT_TRUE(error({"x", 0.019, "window.x", 1.0, "window.speed"})
                    .starts_with("p.csv:4: row 3: axis x goes as far as"));
    EXPECT_NE(error({"x", 0.03, "window.x", 0.02, "window.speed"}).find("(window.speed)"), std::string::npos);
    EXPECT_NE(error({"x", 0.03, "window.x", 1.0, "window.speed", 0.05}).find("accelerates at"),
              std::string::npos);
}

// 8 mm of 10 mm to the right: the way back to the left is free, 3 mm farther to the right are not.
TEST(TableReference, theWindowCountsFromItsMiddle) {
    const auto fits = [](const char* text, double from) {
        TableAxisLimits limits{"x", 0.01, "window.x", 1.0, "window.speed"};
        limits.from = from;
        return checkTableLimits(attached(text), {limits});
    };
    EXPECT_TRUE(fits("time_s,x_mm\n1,-3\n2,-5\n", 0.008));
    EXPECT_TRUE(fits("time_s,x_mm\n1,3\n2,5\n", -0.008));
    const auto beyond = fits("time_s,x_mm\n1,2\n2,3\n", 0.008);
    ASSERT_FALSE(beyond);
    EXPECT_NE(beyond.error().message.find("goes as far as 0.01"), std::string::npos)
        << beyond.error().message;
    EXPECT_NE(beyond.error().message.find("the limit is 0.01 m (window.x)"), std::string::npos);
    EXPECT_FALSE(fits("time_s,x_mm\n1,-2\n2,-3\n", -0.008));
}

// Rows at 4 mm each, uneven in time: the spline swings beyond them, and the end of the travel is there.
TEST(TableReference, theWayBetweenRowsEndsAtTheEndOfTheTravelToo) {
    const MoveReference reference = attached("time_s,x_mm\n1,4\n1.3,4.4\n6,4\n");
    const double most = tableReach(reference, "x");
    ASSERT_GT(most, 4.404e-3);
    EXPECT_TRUE(checkTableEnds(reference, {{"x", 0.05, 0.05 - most - 1e-6}}));
    const auto beyond = checkTableEnds(reference, {{"x", 0.05, 0.05 - 4.402e-3}}); // every row fits
    ASSERT_FALSE(beyond);
    EXPECT_NE(beyond.error().message.find("its travel ends at 0.05 m"), std::string::npos)
        << beyond.error().message;
}

TEST(TableReference, aNegativeRateIsNoLimit) {
    MoveReference reference = wanted();
    EXPECT_TRUE(checkTableKeys(reference));
    reference.rate = -0.005;
    EXPECT_FALSE(checkTableKeys(reference));
    reference.rate = 0.0;
    reference.turning.rate = -1.0;
    EXPECT_FALSE(checkTableKeys(reference));
}

TEST(TableReference, noRowLiesBeyondTheEndOfTheTravel) {
    const MoveReference reference = attached("time_s,x_mm\n1,2\n3,-3\n");
    EXPECT_TRUE(checkTableEnds(reference, {{"x", 0.05, 0.0479}}));
    const auto beyond = checkTableEnds(reference, {{"x", 0.05, 0.049}});
    ASSERT_FALSE(beyond);
    EXPECT_TRUE(beyond.error().message.starts_with("p.csv:2: row 1: axis x would come to 0.051"))
        << beyond.error().message;
    EXPECT_FALSE(checkTableEnds(reference, {{"x", 0.05, -0.048}}));
}

} // namespace
} // namespace halbench::app
