#include "tests/app/workspaces/monitor/monitor_fixture.h"
#include "widgets/live_plot/statistics_table.h"

#include <QToolBar>
#include <QToolButton>

namespace halbench::app {
namespace {

class MonitorStatisticsTest : public MonitorTest {
protected:
    widgets::StatisticsTable& table() { return *panel->findChild<widgets::StatisticsTable*>(); }
    QString range() { return table().horizontalHeaderItem(0)->text(); }
};

TEST_F(MonitorStatisticsTest, theKeyShowsARowForEveryCurve) {
    connectTo("sim:htm", 5.0);
    EXPECT_FALSE(table().isVisible());
    press(Qt::Key_S);
    ASSERT_TRUE(table().isVisible());
    EXPECT_EQ(table().rowCount(), 10); // of the five default plots
    EXPECT_EQ(table().item(0, 0)->text(), "Hall A [mT]");
    EXPECT_TRUE(wait([&] { return QLocale().toULongLong(table().item(0, 8)->text()) > 1000; }));
    EXPECT_TRUE(range().startsWith("In view")) << range().toStdString();
    press(Qt::Key_S);
    EXPECT_FALSE(table().isVisible());
}

TEST_F(MonitorStatisticsTest, withCursorsItIsTheStretchBetweenThem) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(
        wait([&] { return bench().history().range() && bench().history().range()->length_s() > 2.0; }));
    press(Qt::Key_S);
    press(Qt::Key_C);
    const double end_s = bench().history().range()->end_s;
    stack().setCursor(0, end_s - 1.5);
    stack().setCursor(1, end_s - 0.5);
    EXPECT_EQ(range(), "A to B, 1 s");
    const control::SampleStatistics expected =
        bench().history().statistics("hall.a", {end_s - 1.5, end_s - 0.5});
    EXPECT_EQ(table().item(0, 4)->text(), QLocale().toString(1000.0 * expected.moments.mean(), 'f', 3));
    EXPECT_FALSE(table().isColumnHidden(7)); // the slope
    press(Qt::Key_C);
    EXPECT_TRUE(table().isColumnHidden(7));
}

TEST_F(MonitorStatisticsTest, ofSeveralPairsTheOneThatMeasuresCounts) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(
        wait([&] { return bench().history().range() && bench().history().range()->length_s() > 2.0; }));
    press(Qt::Key_S);
    const double end_s = bench().history().range()->end_s;
    widgets::CursorPairs two({{"long", end_s - 1.5, end_s - 0.5}, {"short", end_s - 1.0, end_s - 0.75}}, 1);
    two.setVisible(true);
    stack().setCursorPairs(two);
    EXPECT_EQ(range(), "A to B, 0.25 s");
    press(Qt::Key_P);
    EXPECT_EQ(range(), "A to B, 1 s");
}

TEST_F(MonitorStatisticsTest, aPlotWithItsOwnTimeAxisHasItsOwnStretch) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(
        wait([&] { return bench().history().range() && bench().history().range()->length_s() > 3.0; }));
    const double end_s = bench().history().range()->end_s;
    stack().showTimeRange({end_s - 2.0, end_s - 1.0});
    stack().setOwnTime(0, widgets::OwnTime{0.5, false});
    const control::TimeRange own = stack().timeRange(0);
    EXPECT_NEAR(own.length_s(), 0.5, 1e-9);
    press(Qt::Key_S);
    EXPECT_EQ(range(), "Visible range of each plot");
    const auto count = [&](const char* signal, control::TimeRange stretch) {
        return QLocale().toString(
            static_cast<qulonglong>(bench().history().statistics(signal, stretch).moments.count()));
    };
    EXPECT_EQ(table().item(0, 8)->text(), count("hall.a", own));
    ASSERT_EQ(table().item(5, 0)->text(), "Current command [A]");
    EXPECT_EQ(table().item(5, 8)->text(), count("current_command", {end_s - 2.0, end_s - 1.0}));
    EXPECT_NE(table().item(5, 8)->text(), table().item(0, 8)->text());
}

TEST_F(MonitorStatisticsTest, plotsKeepTwoThirdsOfThePanel) {
    connectTo("sim:htm", 5.0);
    for (const QSize size : {QSize(700, 560), QSize(700, 800), QSize(1400, 1200)}) {
        panel->resize(size);
        press(Qt::Key_S);
        press(Qt::Key_T); // with the trigger's line
        QTest::qWait(50);
        EXPECT_GE(3 * stack().height(), 2 * panel->height()) << size.height();
        EXPECT_GE(table().height(), table().minimumSizeHint().height()) << size.height();
        press(Qt::Key_T);
        press(Qt::Key_S);
    }
}

TEST_F(MonitorStatisticsTest, everyToolIsInSightInTheWindowsFirstSize) {
    connectTo("sim:htm", 5.0);
    panel->resize(700, 560); // what 1440 x 900 leaves for it
    QCoreApplication::processEvents();
    int tools = 0;
    for (const auto* button : panel->findChild<QToolBar*>()->findChildren<QToolButton*>()) {
        if (button->defaultAction() != nullptr) {
            EXPECT_TRUE(button->isVisible()) << button->accessibleName().toStdString();
            ++tools;
        }
    }
    EXPECT_GE(tools, 10);
}

} // namespace
} // namespace halbench::app
