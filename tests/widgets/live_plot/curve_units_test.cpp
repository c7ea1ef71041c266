// Where a curve is seen when its unit is not that of its axis any more.
#include "control/base/units.h"
#include "widgets/live_plot/curve_units.h"

#include <gtest/gtest.h>

namespace halbench::widgets {
namespace {

const QString Degree = QString::fromUtf8("\u00b0");

PlotCurve angle(const char* signal) {
    PlotCurve curve{signal, signal, Degree, 180.0 / Pi, 2};
    curve.unitChoices = {{"", Degree, 180.0 / Pi, 2},
                         {"deg", Degree, 180.0 / Pi, 2},
                         {"rad", "rad", 1.0, 4},
                         {"mrad", "mrad", 1e3, 2},
                         {"urad", "urad", 1e6, 0}};
    return curve;
}

PlotSpec angles(const std::vector<const char*>& signalNames) {
    PlotSpec plot;
    plot.quantity = "angle";
    plot.unit = Degree;
    for (const char* name : signalNames) {
        plot.curves.push_back(angle(name));
    }
    return plot;
}

TEST(CurveUnits, anAxisGoesAlongWithItsOnlyCurveAndIsHeldNoMore) {
    PlotSpec plot = angles({"a"});
    plot.fixedRange = ValueRange{-10.0, 10.0}; // of degrees
    EXPECT_TRUE(showIn(plot, "a", "mrad").isChanged);
    EXPECT_EQ(plot.unit, "mrad");
    EXPECT_EQ(plot.quantity, "angle");
    EXPECT_EQ(plot.curves[0].unit, "mrad");
    EXPECT_EQ(plot.curves[0].factor, 1e3);
    EXPECT_EQ(plot.curves[0].ownUnit, "mrad");
    EXPECT_FALSE(plot.fixedRange);
    EXPECT_TRUE(showIn(plot, "a", "").isChanged);
    EXPECT_EQ(plot, angles({"a"})) << "as in the preferences again";
}

TEST(CurveUnits, besideOthersItGoesToTheFreeAxisAndComesBack) {
    PlotSpec plot = angles({"a", "b"});
    plot.fixedRange = ValueRange{-10.0, 10.0};
    const PlotSpec before = plot;
    const UnitChange change = showIn(plot, "a", "mrad"); // the first one too
    EXPECT_TRUE(change.isChanged);
    EXPECT_FALSE(change.below);
    EXPECT_EQ(plot.unit, Degree);
    EXPECT_TRUE(plot.curves[0].isRight);
    EXPECT_FALSE(plot.curves[1].isRight);
    EXPECT_EQ(plot.right, (PlotAxis{"angle", "mrad", {}}));
    EXPECT_EQ(plot.fixedRange, before.fixedRange) << "the axis that stays in its unit is held still";
    EXPECT_TRUE(showIn(plot, "a", "").isChanged);
    EXPECT_EQ(plot, before);
}

TEST(CurveUnits, theSameUnitByItsNameMovesNothing) {
    PlotSpec plot = angles({"a", "b"});
    EXPECT_TRUE(showIn(plot, "b", "deg").isChanged) << "it stays in degrees whatever is preferred";
    EXPECT_FALSE(plot.curves[1].isRight);
    EXPECT_EQ(plot.curves[1].ownUnit, "deg");
}

TEST(CurveUnits, whereBothAxesHaveOthersItIsAPlotBelow) {
    PlotSpec plot = angles({"a", "b", "c"});
    plot.column = 2;
    ASSERT_FALSE(showIn(plot, "b", "mrad").below);
    const UnitChange third = showIn(plot, "c", "urad");
    ASSERT_TRUE(third.below);
    EXPECT_EQ(plot.curves.size(), 2U);
    EXPECT_EQ(third.below->unit, "urad");
    EXPECT_EQ(third.below->quantity, "angle");
    EXPECT_EQ(third.below->column, 2);
    EXPECT_FALSE(third.below->curves[0].isRight);
}

TEST(CurveUnits, theRightAxisTakesASecondCurveOfItsUnit) {
    PlotSpec plot = angles({"a", "b", "c"});
    showIn(plot, "b", "mrad");
    EXPECT_FALSE(showIn(plot, "c", "mrad").below);
    EXPECT_TRUE(plot.curves[2].isRight);
    EXPECT_FALSE(showIn(plot, "b", "").below); // and lets one go back
    EXPECT_FALSE(plot.curves[1].isRight);
    EXPECT_EQ(plot.right.unit, "mrad");
}

TEST(CurveUnits, whatItCannotBeShownInChangesNothing) {
    PlotSpec plot = angles({"a"});
    const PlotSpec before = plot;
    EXPECT_FALSE(showIn(plot, "a", "mT").isChanged);
    EXPECT_FALSE(showIn(plot, "b", "mrad").isChanged);
    EXPECT_FALSE(showIn(plot, "a", "").isChanged) << "it is already";
    EXPECT_EQ(plot, before);
}

TEST(CurveUnits, otherPreferencesPartWhatHasAUnitOfItsOwn) {
    std::vector<PlotSpec> plots = {angles({"a", "b", "c", "d"}), angles({"e"})};
    plots[0].fixedRange = ValueRange{-10.0, 10.0};
    for (const std::size_t changed : {0U, 3U}) { // those that nobody chose a unit for
        plots[0].curves[changed].unit = "rad";
    }
    plots[0].curves[2].unit = "mrad";
    settleUnits(plots);
    ASSERT_EQ(plots.size(), 3U);
    EXPECT_EQ(plots[0].unit, "rad");
    EXPECT_FALSE(plots[0].fixedRange);
    EXPECT_EQ(plots[0].right.unit, Degree);
    EXPECT_EQ(plots[0].curves.size(), 3U);
    EXPECT_EQ(plots[1].unit, "mrad");
    EXPECT_EQ(plots[1].curves[0].signal, "c");
    EXPECT_EQ(plots[2].curves[0].signal, "e");
    const std::vector<PlotSpec> settled = plots;
    settleUnits(plots);
    EXPECT_EQ(plots, settled);
}

} // namespace
} // namespace halbench::widgets
