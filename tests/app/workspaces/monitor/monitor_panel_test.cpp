#include "app/workbench/display_quantity.h"
#include "app/workbench/fault_text.h"
#include "app/workbench/live_signals.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "app/workspaces/monitor/monitor_plots.h"
#include "app/workspaces/monitor/signal_tree.h"
#include "app/workspaces/monitor/signals_panel.h"
#include "control/base/units.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "tests/app/workspaces/monitor/five_plots.h"
#include "widgets/controls/empty_state.h"
#include "widgets/controls/message_bar.h"
#include "widgets/live_plot/live_legend.h"
#include "widgets/live_plot/live_plot.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QAction>
#include <QHeaderView>
#include <QMimeData>
#include <QSignalSpy>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

class MonitorPanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<MonitorPanel>(bench());
        panel->setView(fivePlots());
        list = std::make_unique<SignalsPanel>(bench());
        // As the window connects them (app/window/panel_connections.cpp).
        QObject::connect(list.get(), &SignalsPanel::plotRequested, panel.get(), &MonitorPanel::plot);
        QObject::connect(panel.get(), &MonitorPanel::plottedChanged, list.get(), &SignalsPanel::setPlotted);
        list->resize(300, 800);
        list->show();
        panel->resize(1200, 800);
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
    }
    void TearDown() override {
        list.reset();
        panel.reset();
    }

    widgets::LivePlotStack& stack() { return *panel->findChild<widgets::LivePlotStack*>(); }
    SignalTree& tree() { return *list->findChild<SignalTree*>(); }
    QTreeWidgetItem* item(const QString& words) {
        for (QTreeWidgetItem* found : tree().findItems(words, Qt::MatchExactly | Qt::MatchRecursive)) {
            if (found->parent() != nullptr) { // a group may be called the same
                return found;
            }
        }
        return nullptr;
    }
    bool isPlotted(const char* signal) { return plottedSignals(stack().plots()).count(signal) > 0; }

    std::unique_ptr<MonitorPanel> panel;
    std::unique_ptr<SignalsPanel> list;
};

TEST_F(MonitorPanelTest, withoutADeviceItOffersTheSimulatedMotor) {
    auto* empty = panel->findChild<widgets::EmptyState*>();
    ASSERT_TRUE(empty->isVisible());
    QSignalSpy asked(panel.get(), &MonitorPanel::connectRequested);
    click(*panel, "Connect the simulated motor");
    EXPECT_EQ(asked.count(), 1);
    connectTo("sim:htm", 5.0);
    EXPECT_FALSE(empty->isVisible());
    session().disconnectDevice();
    EXPECT_FALSE(empty->isVisible()); // what was measured can still be looked at
}

// The engineer looks at the motion and at what drives it; the rest is a tick away.
TEST_F(MonitorPanelTest, aDeviceShowsPositionSpeedAndCurrentAtFirst) {
    panel->setView({});
    connectTo("sim:htm", 5.0);
    const auto signalsOf = [&](std::size_t plot) {
        std::vector<std::string> names;
        for (const widgets::PlotCurve& curve : stack().plots()[plot].curves) {
            names.push_back(curve.signal);
        }
        return names;
    };
    using Names = std::vector<std::string>;
    ASSERT_EQ(stack().plots().size(), 3U);
    EXPECT_EQ(signalsOf(0), (Names{"position", "reference"}));
    EXPECT_EQ(signalsOf(1), Names{"speed"});
    EXPECT_EQ(signalsOf(2), (Names{"current_command", "current.a", "current.b"}));
    connectTo("sim:planar", 5.0); // its angle has another unit than its ways
    ASSERT_EQ(stack().plots().size(), 3U);
    EXPECT_EQ(signalsOf(0), (Names{"position.x", "reference.x", "position.y", "reference.y"}));
    EXPECT_EQ(signalsOf(1), (Names{"position.phi", "reference.phi"}));
    EXPECT_EQ(signalsOf(2), (Names{"speed.x", "speed.y"}));
    connectTo("sim:spherical", 5.0);
    ASSERT_EQ(stack().plots().size(), 2U);
    EXPECT_EQ(signalsOf(0).size(), 6U); // angles
    EXPECT_EQ(signalsOf(1).size(), 4U); // a quaternion, whole
}

TEST_F(MonitorPanelTest, aConnectedMotorIsWatchedAtOnceInThePlotsOfItsView) {
    connectTo("sim:htm", 5.0);
    ASSERT_EQ(stack().plots().size(), 5U);
    EXPECT_EQ(stack().plots()[0].unit, "mT");
    EXPECT_EQ(stack().plots()[1].unit, QString::fromUtf8("\u00b0"));
    EXPECT_EQ(stack().plots()[2].unit, "r/min");
    EXPECT_EQ(bench().liveSignals().rate_Hz(), 1000.0);
    ASSERT_TRUE(wait([&] { return bench().history().latest("hall.a").has_value(); }));
    ASSERT_TRUE(wait([&] { return item("Hall A")->text(SignalTree::ValueColumn).size() > 1; }));
    // 0.157 T is the rotor's field; the Hall sensor sees its cosine.
    EXPECT_LT(std::fabs(QLocale().toDouble(item("Hall A")->text(SignalTree::ValueColumn))), 170.0);
}

TEST_F(MonitorPanelTest, theValuesAxesFitAnotherDeviceAtOnceAndTheSameOneAsTheUserHeldThem) {
    const auto indexOf = [&](const char* signal) {
        const auto& plots = stack().plots();
        const auto found = std::find_if(plots.begin(), plots.end(), [&](const widgets::PlotSpec& plot) {
            return plot.curves.front().signal == signal;
        });
        return static_cast<int>(found - plots.begin());
    };
    connectTo("sim:htm?seed=4", 5.0);
    const int speed = indexOf("speed");
    const widgets::ValueRange held{200.0, 300.0};
    for (widgets::LivePlot* plot : stack().findChildren<widgets::LivePlot*>()) {
        if (plot->spec() == stack().plots()[static_cast<std::size_t>(speed)]) {
            plot->setUserRange(held);
        }
    }
    ASSERT_EQ(stack().heldRange(speed), held);
    connectTo("sim:htm?seed=4", 5.0);
    EXPECT_EQ(stack().heldRange(speed), held) << "the same one, reconnected";
    connectTo("sim:htm?seed=9", 5.0);
    const int other = indexOf("speed"); // among its own plots
    EXPECT_FALSE(stack().heldRange(other).has_value());
    ASSERT_TRUE(wait([&] { return bench().history().latest("speed").has_value(); }));
    EXPECT_TRUE(wait([&] {
        const double now_r_min = 30.0 / Pi * bench().history().latest("speed")->value;
        return stack().valueRange(other).contains({now_r_min, now_r_min});
    }));
}

TEST_F(MonitorPanelTest, valuesThatAreNotUpdatedAnyMoreSayItAndSinceWhen) {
    connectTo("sim:htm", 5.0);
    const auto isMarked = [&] {
        const widgets::LegendTableModel& legend = panel->findChild<widgets::LiveLegend*>()->table();
        const QModelIndex value = legend.index(0, widgets::LegendTableModel::Value);
        return item("Hall A")->font(SignalTree::ValueColumn).italic() &&
               item("Hall A")->toolTip(SignalTree::ValueColumn).contains("since") &&
               tree().headerItem()->text(SignalTree::ValueColumn) == "Last" &&
               legend.data(value, Qt::FontRole).value<QFont>().italic() &&
               legend.data(value, Qt::ToolTipRole).toString().contains("since");
    };
    const auto isFresh = [&] {
        return item("Hall A")->text(SignalTree::ValueColumn).size() > 1 &&
               !item("Hall A")->font(SignalTree::ValueColumn).italic() &&
               tree().headerItem()->text(SignalTree::ValueColumn) == "Now";
    };
    ASSERT_TRUE(wait(isFresh));
    session().setPace({0.0}); // time passes only while a procedure runs
    EXPECT_TRUE(wait(isMarked));
    session().setPace({5.0});
    EXPECT_TRUE(wait(isFresh));
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    EXPECT_TRUE(bench().freshness().isStale()); // at once
    EXPECT_TRUE(wait(isMarked));
    EXPECT_GT(item("Hall A")->text(SignalTree::ValueColumn).size(), 1); // the last value stays
}

TEST_F(MonitorPanelTest, aSignalThatIsNotPlottedAnyMoreSaysThatItsValueIsOld) {
    connectTo("sim:htm", 5.0);
    item("Capture state")->setCheckState(SignalTree::NameColumn, Qt::Checked);
    ASSERT_TRUE(wait([&] { return item("Capture state")->text(SignalTree::ValueColumn).size() > 1; }));
    EXPECT_EQ(item("Capture state")->toolTip(SignalTree::ValueColumn), QString());
    item("Capture state")->setCheckState(SignalTree::NameColumn, Qt::Unchecked);
    EXPECT_TRUE(
        wait([&] { return item("Capture state")->toolTip(SignalTree::ValueColumn).contains("since"); }));
    EXPECT_FALSE(item("Angle")->font(SignalTree::ValueColumn).italic()); // the others go on
}

TEST_F(MonitorPanelTest, otherUnitsChangeTreeAndPlotsAndNoTick) {
    connectTo("sim:htm", 5.0);
    bench().setDisplayUnits({widgets::AngleUnit::Radian, SpeedUnit::RadiansPerSecond});
    EXPECT_EQ(item("Angle")->text(SignalTree::UnitColumn), "rad");
    EXPECT_EQ(item("Angle")->checkState(SignalTree::NameColumn), Qt::Checked);
    EXPECT_EQ(stack().plots()[1].unit, "rad");
    EXPECT_EQ(stack().plots().size(), 5U);
}

TEST_F(MonitorPanelTest, temperaturesWarnFromTheProfileAndTurnBadAtTheDevicesLimit) {
    connectTo("sim:htm", 5.0);
    const auto bands = [&] { return stack().plots()[4].bands; };
    ASSERT_EQ(bands().size(), 2U);
    EXPECT_EQ(bands()[0].from, 65.0); // resources/devices/htm.json: T_pause_degC
    EXPECT_EQ(bands()[1].from, 80.0);
    bench().writeValues({{"limit.temperature", 75.0}}, [](const Result<void>&) {});
    EXPECT_TRUE(wait([&] { return bands()[1].from == 75.0; }));
}

TEST_F(MonitorPanelTest, enterAndTickPlotASignalAndItIsStreamed) {
    connectTo("sim:htm", 5.0);
    ASSERT_FALSE(isPlotted("truth.position"));
    tree().setFocus();
    tree().setCurrentItem(item("True angle"));
    QTest::keyClick(&tree(), Qt::Key_Return);
    EXPECT_TRUE(isPlotted("truth.position"));
    EXPECT_EQ(stack().plots().size(), 5U); // beside the other angles
    QTest::keyClick(&tree(), Qt::Key_Return);
    EXPECT_FALSE(isPlotted("truth.position"));
    item("Capture state")->setCheckState(SignalTree::NameColumn, Qt::Checked);
    EXPECT_TRUE(isPlotted("capture.state"));
    EXPECT_EQ(stack().plots().size(), 6U);
    EXPECT_TRUE(wait([&] { return bench().history().latest("capture.state").has_value(); }));
}

TEST_F(MonitorPanelTest, pauseKeepsTheDataAndTheTickFollowsTheLegend) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return bench().history().range().has_value(); }));
    click(*panel, "Pause");
    EXPECT_TRUE(stack().isPaused());
    const double before_s = bench().history().range()->end_s;
    EXPECT_TRUE(wait([&] { return bench().history().range()->end_s > before_s + 0.5; }));
    EXPECT_TRUE(stack().isPaused());
    click(*panel, "Pause");
    EXPECT_FALSE(stack().isPaused());
    stack().removeCurve(1, "reference");
    Q_EMIT stack().plotsChanged();
    EXPECT_EQ(item("Reference")->checkState(SignalTree::NameColumn), Qt::Unchecked);
}

TEST_F(MonitorPanelTest, plotsStayWhenTheSameDeviceComesBack) {
    connectTo("sim:htm", 5.0);
    item("Speed")->setCheckState(SignalTree::NameColumn, Qt::Unchecked);
    ASSERT_FALSE(isPlotted("speed"));
    session().disconnectDevice();
    connectTo("sim:htm", 5.0);
    EXPECT_FALSE(isPlotted("speed"));
}

TEST_F(MonitorPanelTest, anAngleOfManyTurnsIsShownWhole) {
    connectTo("sim:htm", 1.0);
    QAbstractItemModel* model = tree().model();
    const QModelIndex value = model->index(0, 1, model->index(0, 0));
    model->setData(value, QStringLiteral("-190800.25")); // 530 turns
    EXPECT_LE(tree().sizeHintForIndex(value).width(), tree().header()->sectionSize(1));
}

TEST_F(MonitorPanelTest, everyToolSaysItsShortcut) {
    for (const QToolButton* button : panel->findChildren<QToolButton*>()) {
        if (button->defaultAction() != nullptr) {
            EXPECT_TRUE(button->toolTip().contains('(')) << button->text().toStdString();
            EXPECT_FALSE(button->accessibleName().isEmpty());
        }
    }
}

TEST(DisplayQuantityTest, showsDegreesTurnsMilliteslaAmpereAndCelsius) {
    EXPECT_NEAR(displayQuantity("rad", {}).factor * Pi, 180.0, 1e-9);
    EXPECT_NEAR(displayQuantity("rad/s", {}).factor * 2.0 * Pi, 60.0, 1e-9); // one turn a second
    EXPECT_EQ(displayQuantity("T", {}).factor, 1000.0);
    EXPECT_EQ(displayQuantity("A", {}).unit, "A");
    EXPECT_EQ(displayQuantity("degC", {}).unit, QString::fromUtf8("\u00b0C"));
    EXPECT_EQ(displayQuantity("kg*m^2", {}).factor, 1.0);
    EXPECT_EQ(signalWords("hall.b"), "Hall B");
    EXPECT_EQ(signalWords("foreign.name"), "foreign.name");
    EXPECT_EQ(signalWords("position.x"), "Position x");
    EXPECT_EQ(signalWords("truth.speed.phi"), "True speed \u03c6");
    EXPECT_EQ(signalWords("current.coil3"), "Current 3");
    EXPECT_EQ(signalWords("hall.y2"), "Hall y2");
    EXPECT_EQ(signalWords("field.0.theta"), QString::fromUtf8("Field 0\u00a0\u03b8"));
    EXPECT_EQ(signalWords("position.foreign"), "position.foreign");
    EXPECT_EQ(signalWords("reference.segment"), "Generator segment");
}

TEST(MonitorPlotsTest, aDeviceWithoutRolesShowsItsFirstSignalsByUnit) {
    devices::Catalogue catalogue;
    for (const char* name : {"x", "y"}) {
        SignalSpec spec;
        spec.name = name;
        spec.unit = "V";
        catalogue.signals.push_back(spec);
    }
    SignalSpec other;
    other.name = "n";
    catalogue.signals.push_back(other);
    const auto plots = defaultPlots(catalogue, {}, {});
    ASSERT_EQ(plots.size(), 2U);
    EXPECT_EQ(plots[0].curves.size(), 2U);
}

TEST(FaultWordsTest, everyFaultHasWordsAndARemedy) {
    devices::DeviceState board;
    EXPECT_TRUE(faultWords(board).what.isEmpty());
    for (board.fault = 1; board.fault <= 9; ++board.fault) { // 9: a code this program does not know
        board.faultText = "the board's words";
        EXPECT_FALSE(faultWords(board).what.isEmpty());
        EXPECT_FALSE(faultWords(board).remedy.isEmpty());
    }
    board.fault = 9;
    EXPECT_EQ(faultWords(board).what, "the board's words");
    board.fault = 0;
    board.isStopLatched = true;
    EXPECT_TRUE(faultWords(board).what.contains("Stopped"));
    board.faultText = "stopped by command"; // devices/firmware/htm/hb_htm_tables.c
    EXPECT_EQ(stopReason(board), "by command");
    EXPECT_EQ(stopReason(board, "by Esc"), "by Esc");
    EXPECT_EQ(faultWords(board, "by Esc").what, "Stopped: by Esc");
    EXPECT_EQ(faultWords(board).what, "Stopped: by command");
}

TEST_F(MonitorPanelTest, aSignalThatTheDeviceDoesNotHaveIsSaidAndKeptUntilThePlotsChange) {
    MonitorView view;
    view.plots = {{{"hall.a", "hall.north"}, {}, {}}, {{"torque"}, {}, {}}};
    view.span_s = 10.0;
    panel->setView(view);
    connectTo("sim:htm", 5.0);
    const widgets::Message& said = panel->findChild<widgets::MessageBar*>()->message();
    EXPECT_TRUE(said.text.contains("hall.north") && said.text.contains("torque")) << said.text.toStdString();
    ASSERT_EQ(stack().plots().size(), 1U);
    EXPECT_EQ(plottedSignals(stack().plots()), std::set<std::string>{"hall.a"});
    EXPECT_EQ(panel->view(), view);
    tree().setCurrentItem(item("Hall B"));
    QTest::keyClick(&tree(), Qt::Key_Return);
    EXPECT_TRUE(said.text.isEmpty());
    ASSERT_FALSE(panel->view().plots.empty());
    EXPECT_EQ(panel->view().plots[0].signalNames, (std::vector<std::string>{"hall.a", "hall.b"}));
}

} // namespace
} // namespace halbench::app
