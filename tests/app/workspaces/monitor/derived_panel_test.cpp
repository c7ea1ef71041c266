#include "app/workspaces/monitor/derived_panel.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "app/workspaces/monitor/monitor_plots.h"
#include "app/workspaces/monitor/signal_tree.h"
#include "app/workspaces/monitor/signals_panel.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "tests/app/workspaces/monitor/five_plots.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>

#include <algorithm>

namespace halbench::app {
namespace {

class DerivedPanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<DerivedPanel>(bench());
        monitor = std::make_unique<MonitorPanel>(bench());
        monitor->setView(fivePlots());
        list = std::make_unique<SignalsPanel>(bench());
        QObject::connect(list.get(), &SignalsPanel::plotRequested, monitor.get(), &MonitorPanel::plot);
        QObject::connect(monitor.get(), &MonitorPanel::plottedChanged, list.get(), &SignalsPanel::setPlotted);
        for (QWidget* widget : std::initializer_list<QWidget*>{monitor.get(), list.get(), panel.get()}) {
            widget->resize(900, 600);
            widget->show();
            ASSERT_TRUE(QTest::qWaitForWindowExposed(widget));
        }
    }
    void TearDown() override {
        panel.reset();
        list.reset();
        monitor.reset();
    }

    void write(const QString& name, const QString& expression, const QString& unit) {
        type(find<QLineEdit>(*panel, "Name"), name);
        type(find<QLineEdit>(*panel, "Unit"), unit);
        type(find<QLineEdit>(*panel, "Expression"), expression);
    }
    void enter() { QTest::keyClick(find<QLineEdit>(*panel, "Expression"), Qt::Key_Return); }
    QString problem() { return find<QLabel>(*panel, "Error in the expression")->text(); }
    QTableWidget& table() { return *find<QTableWidget>(*panel, "Derived signals"); }
    SignalTree& tree() { return *list->findChild<SignalTree*>(); }

    std::unique_ptr<DerivedPanel> panel;
    std::unique_ptr<MonitorPanel> monitor;
    std::unique_ptr<SignalsPanel> list;
};

TEST_F(DerivedPanelTest, aKeptSignalIsInTheTreeAndIsPlottedInItsUnit) {
    connectTo("sim:htm", 5.0);
    write("field", "sqrt(hall.a^2 + hall.b^2)", "T");
    EXPECT_EQ(problem(), QString());
    enter();
    ASSERT_EQ(table().rowCount(), 1);
    EXPECT_EQ(table().item(0, 3)->text(), "computed");
    const auto found = tree().findItems("field", Qt::MatchExactly | Qt::MatchRecursive);
    QTreeWidgetItem* item = nullptr;
    for (QTreeWidgetItem* one : found) { // the group of the quantity is called the same
        item = one->parent() != nullptr ? one : item;
    }
    ASSERT_NE(item, nullptr);
    item->setCheckState(SignalTree::NameColumn, Qt::Checked);
    const auto* stack = monitor->findChild<widgets::LivePlotStack*>();
    EXPECT_EQ(stack->plots()[0].curves.size(), 3U); // beside the Hall sensors, in mT
    ASSERT_TRUE(wait([&] { return bench().history().latest("field").has_value(); }));
    // The two sensors see sine and cosine of 157 mT (resources/help/htm-theory.md).
    EXPECT_NEAR(bench().history().latest("field")->value, 0.157, 0.02);
}

TEST_F(DerivedPanelTest, anotherExpressionForgetsWhatTheOneBeforeComputed) {
    connectTo("sim:htm", 5.0);
    monitor->plot("hall.a", true);
    write("x", "2 * hall.a", "");
    enter();
    monitor->plot("x", true);
    ASSERT_TRUE(wait([&] { return bench().history().latest("x").has_value(); }));
    write("x", "3 * hall.a", "");
    enter();
    EXPECT_FALSE(bench().history().latest("x"));
    ASSERT_TRUE(wait([&] { return bench().history().latest("x").has_value(); }));
    std::vector<control::TimedValue> hall;
    std::vector<control::TimedValue> computed;
    const control::TimeRange held = *bench().history().range("x");
    bench().history().samples("x", held, computed);
    bench().history().samples("hall.a", held, hall);
    hall.erase(hall.begin(), hall.end() - static_cast<std::ptrdiff_t>(computed.size()));
    for (std::size_t i = 0; i < computed.size(); ++i) {
        EXPECT_DOUBLE_EQ(computed[i].value, 3.0 * hall[i].value) << i;
    }
}

TEST_F(DerivedPanelTest, anEmptyListGivesAnExampleAndANewSignalAsksForItsPlot) {
    connectTo("sim:htm", 5.0);
    QStringList plotted;
    QObject::connect(panel.get(), &DerivedPanel::plotRequested,
                     [&](const QString& name, bool) { plotted << name; });
    const auto isExplained = [&] {
        const auto labels = panel->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->isVisible() && label->text().contains("current.a^2");
        });
    };
    EXPECT_TRUE(isExplained());
    write("half", "speed / 2", "rad/s");
    enter();
    EXPECT_FALSE(isExplained());
    EXPECT_EQ(plotted, QStringList("half"));
    write("half", "speed / 4", "rad/s"); // the same signal: its plot is chosen already
    enter();
    EXPECT_EQ(plotted.size(), 1);
}

TEST_F(DerivedPanelTest, aMistakeIsSaidInPlaceAndNotKept) {
    connectTo("sim:htm", 5.0);
    write("x", "hall.a + * 2", "");
    EXPECT_TRUE(problem().contains("column")) << problem().toStdString();
    enter();
    EXPECT_EQ(table().rowCount(), 0);
    write("x", "hall.north", "");
    EXPECT_TRUE(problem().contains("'hall.north'")) << problem().toStdString();
}

TEST_F(DerivedPanelTest, whatItNeedsIsSentWhenItIsPlotted) {
    connectTo("sim:htm", 5.0);
    write("half", "reference.segment / 2", "1"); // no default signal
    enter();
    EXPECT_FALSE(bench().history().contains("reference.segment"));
    monitor->plot("half", true);
    EXPECT_TRUE(wait([&] { return bench().history().latest("half").has_value(); }));
}

TEST_F(DerivedPanelTest, enterTakesARowIntoTheFieldsAndDeleteRemovesItWithItsCurve) {
    connectTo("sim:htm", 5.0);
    write("half", "speed / 2", "rad/s");
    enter();
    monitor->plot("half", true);
    table().setFocus();
    table().setCurrentCell(0, 0);
    Q_EMIT table().cellActivated(0, 0);
    EXPECT_EQ(find<QLineEdit>(*panel, "Expression")->text(), "speed / 2");
    type(find<QLineEdit>(*panel, "Expression"), "speed / 4");
    enter();
    ASSERT_EQ(bench().derivedSignals().size(), 1U);
    EXPECT_EQ(bench().derivedSignals()[0].expression, "speed / 4");
    const auto* stack = monitor->findChild<widgets::LivePlotStack*>();
    EXPECT_EQ(plottedSignals(stack->plots()).count("half"), 1U);
    table().setFocus();
    table().setCurrentCell(0, 0);
    QTest::keyClick(&table(), Qt::Key_Delete);
    EXPECT_TRUE(bench().derivedSignals().empty());
    EXPECT_EQ(plottedSignals(stack->plots()).count("half"), 0U);
}

TEST_F(DerivedPanelTest, theViewKeepsThemAndTheyWaitForADevice) {
    MonitorView view;
    view.derived = {{"half", "speed / 2", "rad/s"}};
    view.plots = {{{"half"}, {}, {}}};
    view.span_s = 10.0;
    monitor->setView(view);
    ASSERT_EQ(table().rowCount(), 1);
    EXPECT_EQ(table().item(0, 3)->text(), "waits for a device");
    EXPECT_EQ(monitor->view(), view);
    connectTo("sim:htm", 5.0);
    EXPECT_TRUE(wait([&] { return bench().history().latest("half").has_value(); }));
    EXPECT_EQ(monitor->view(), view);
    EXPECT_NE(table().item(0, 3)->text(), "waits for a device");
}

} // namespace
} // namespace halbench::app
