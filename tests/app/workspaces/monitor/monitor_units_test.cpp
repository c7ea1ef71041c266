// A signal of the Monitor in a unit of its own.
#include "app/workspaces/monitor/monitor_picture.h"
#include "app/workspaces/monitor/monitor_plots.h"
#include "app/workspaces/parts/signal_units.h"
#include "control/base/units.h"
#include "tests/app/workspaces/monitor/monitor_fixture.h"
#include "widgets/controls/message_bar.h"
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/statistics_table.h"

namespace halbench::app {
namespace {

const QString Degree = QString::fromUtf8("\u00b0");

class MonitorUnitsTest : public MonitorTest {
protected:
    void SetUp() override {
        MonitorTest::SetUp();
        connectTo("sim:htm", 5.0);
        ASSERT_EQ(stack().plots().size(), 5U);
    }
    widgets::LiveLegend* legend(int plot) {
        for (widgets::LiveLegend* each : panel->findChildren<widgets::LiveLegend*>()) {
            if (each->accessibleName().endsWith(stack().plots()[static_cast<std::size_t>(plot)].quantity)) {
                return each;
            }
        }
        ADD_FAILURE() << plot;
        return nullptr;
    }
    /// As the key in the legend does.
    void choose(int plot, int curve, const std::string& unit) {
        Q_EMIT legend(plot)->unitRequested(curve, unit);
        stack().refresh();
    }
    const widgets::PlotSpec& plot(std::size_t index) { return stack().plots()[index]; }
    bool hasSamples(double length_s) {
        return wait(
            [&] { return bench().history().range() && bench().history().range()->length_s() > length_s; });
    }
};

// Shown is the value in SI times the factor of the unit, rounded once, everywhere.
TEST_F(MonitorUnitsTest, legendCursorsStatisticsAndPictureHaveItExactly) {
    ASSERT_TRUE(hasSamples(2.0));
    stack().setPaused(true);
    const double end_s = bench().history().range()->end_s;
    widgets::CursorPairs pairs({{"", end_s - 1.5, end_s - 0.5}}, 0);
    pairs.setVisible(true);
    stack().setCursorPairs(pairs);
    choose(0, 0, "uT");
    EXPECT_EQ(plot(0).right.unit, QString::fromUtf8("\u00b5T"));
    EXPECT_EQ(plot(0).right.quantity, plot(0).quantity);
    const auto inMicrotesla = [](double value_T, int decimals) {
        return QLocale().toString(1e6 * value_T, 'f', decimals).remove(QLocale().groupSeparator());
    };
    const double atA_T = bench().history().valueAt("hall.a", end_s - 1.5)->value;
    stack().refresh();
    const QAbstractItemModel& numbers = *legend(0)->model();
    EXPECT_EQ(numbers.index(0, widgets::LegendTableModel::AtA).data().toString(), inMicrotesla(atA_T, 0));
    EXPECT_EQ(numbers.index(0, widgets::LegendTableModel::Unit).data().toString(), plot(0).right.unit);
    press(Qt::Key_S);
    auto* table = panel->findChild<widgets::StatisticsTable*>();
    const control::SampleStatistics found =
        bench().history().statistics("hall.a", {end_s - 1.5, end_s - 0.5});
    EXPECT_EQ(table->item(0, 0)->text(), QString::fromUtf8("Hall A [\u00b5T]"));
    EXPECT_EQ(table->item(0, 4)->text(), inMicrotesla(found.moments.mean(), 1));
    EXPECT_EQ(table->item(1, 0)->text(), "Hall B [mT]");
    const auto sheets = monitorSheets(stack(), bench().history());
    const widgets::Panel& drawn = sheets.front().figure.panels[0];
    ASSERT_TRUE(drawn.right);
    EXPECT_EQ(drawn.right->unit, "\u00b5T");
    EXPECT_EQ(drawn.y.unit, "mT");
    EXPECT_TRUE(drawn.curves[0].isRight);
}

TEST_F(MonitorUnitsTest, theProjectKeepsItsNameInFiles) {
    choose(2, 0, "deg/s");
    choose(1, 1, "mrad");
    EXPECT_EQ(plot(2).unit, QString::fromUtf8("\u00b0/s"));
    const MonitorView kept = panel->view();
    EXPECT_EQ(kept.plots[1].rightNames, std::vector<std::string>{"reference"});
    EXPECT_EQ(kept.plots[1].units, (std::map<std::string, std::string>{{"reference", "mrad"}}));
    EXPECT_EQ(kept.plots[2].units, (std::map<std::string, std::string>{{"speed", "deg/s"}}));
    choose(2, 0, "");
    EXPECT_TRUE(panel->view().plots[2].units.empty());
    panel->setView(kept);
    EXPECT_EQ(plot(1).right.unit, "mrad");
    EXPECT_EQ(plot(2).unit, QString::fromUtf8("\u00b0/s"));
    EXPECT_EQ(panel->view(), kept);
}

TEST_F(MonitorUnitsTest, anAxisHeldInItIsHeldAgain) {
    MonitorView view;
    view.plots = {{{"speed"}, widgets::ValueRange{-90.0, 90.0}, "\u00b0/s"}};
    view.plots[0].units = {{"speed", "deg/s"}};
    panel->setView(view);
    EXPECT_EQ(stack().heldRange(0), (widgets::ValueRange{-90.0, 90.0}));
    EXPECT_EQ(panel->view().plots, view.plots);
}

TEST_F(MonitorUnitsTest, otherPreferencesLeaveItAsItIs) {
    choose(1, 1, "mrad");
    bench().setDisplayUnits({widgets::AngleUnit::Radian, {}});
    EXPECT_EQ(plot(1).unit, "rad");
    EXPECT_EQ(plot(1).right.unit, "mrad");
    choose(1, 1, "deg"); // alone there: the axis goes along
    EXPECT_EQ(plot(1).right.unit, Degree);
    bench().setDisplayUnits({});
    EXPECT_EQ(plot(1).unit, Degree);
    EXPECT_EQ(plot(1).right.unit, Degree);
    EXPECT_EQ(plot(1).curves[1].ownUnit, "deg");
}

TEST_F(MonitorUnitsTest, whatPreferencesPartIsSeenOnTheOtherAxis) {
    choose(1, 1, "deg");
    EXPECT_FALSE(plot(1).curves[1].isRight) << "the same unit";
    bench().setDisplayUnits({widgets::AngleUnit::Radian, {}});
    ASSERT_EQ(stack().plots().size(), 5U);
    EXPECT_EQ(plot(1).unit, "rad");
    EXPECT_EQ(plot(1).right.unit, Degree);
    EXPECT_TRUE(plot(1).curves[1].isRight);
}

TEST_F(MonitorUnitsTest, orInAPlotBelowWhereTheOtherAxisIsTaken) {
    choose(1, 1, "deg");
    Q_EMIT stack().signalsDropped(1, {"truth.speed"});
    ASSERT_EQ(plot(1).right.unit, "r/min");
    bench().setDisplayUnits({widgets::AngleUnit::Radian, {}});
    ASSERT_EQ(stack().plots().size(), 6U);
    EXPECT_EQ(plot(1).unit, "rad");
    EXPECT_EQ(plot(2).unit, Degree);
    EXPECT_EQ(plot(2).curves[0].signal, "reference");
    EXPECT_EQ(plottedSignals(stack().plots()).count("reference"), 1U);
}

TEST_F(MonitorUnitsTest, aUnitOfTheProjectThatDoesNotFitIsSaidAndKept) {
    MonitorView view;
    view.plots = {{{"hall.a", "hall.b"}, {}, {}}};
    view.plots[0].units = {{"hall.a", "mrad"}};
    panel->setView(view);
    const widgets::Message& said = panel->findChild<widgets::MessageBar*>()->message();
    EXPECT_TRUE(said.text.contains("hall.a [mrad]")) << said.text.toStdString();
    EXPECT_FALSE(said.remedy.isEmpty());
    EXPECT_EQ(plot(0).unit, "mT");
    EXPECT_FALSE(hasRightAxis(plot(0)));
    EXPECT_EQ(panel->view().plots, view.plots) << "until the plots are changed";
    choose(0, 1, "T");
    EXPECT_TRUE(said.text.isEmpty());
    EXPECT_EQ(panel->view().plots[0].units, (std::map<std::string, std::string>{{"hall.b", "T"}}));
}

TEST_F(MonitorUnitsTest, aMissingSignalAndAUnitThatDoesNotFitAreBothSaid) {
    MonitorView view;
    view.plots = {{{"hall.a", "torque"}, {}, {}}};
    view.plots[0].units = {{"hall.a", "mrad"}, {"torque", "mNm"}};
    panel->setView(view);
    const QString said = panel->findChild<widgets::MessageBar*>()->message().text;
    EXPECT_TRUE(said.contains("torque")) << said.toStdString();
    EXPECT_TRUE(said.contains("hall.a [mrad]")) << said.toStdString();
    EXPECT_FALSE(said.contains("torque [")) << "nobody knows what it would be";
    EXPECT_EQ(panel->view().plots, view.plots);
}

TEST_F(MonitorUnitsTest, aFurtherMonitorHasItsOwn) {
    MonitorPanel further(bench(), nullptr, MonitorPanel::Rank::Further);
    MonitorView view;
    view.plots = {{{"speed"}, {}, {}}};
    view.plots[0].units = {{"speed", "rev/s"}};
    further.setView(view);
    EXPECT_EQ(further.findChild<widgets::LivePlotStack*>()->plots()[0].unit, "rev/s");
    EXPECT_EQ(further.view().plots, view.plots);
    EXPECT_EQ(plot(2).unit, "r/min");
}

} // namespace
} // namespace halbench::app
