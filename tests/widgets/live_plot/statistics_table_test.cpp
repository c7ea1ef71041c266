#include "tests/widgets/gui_fixture.h"
#include "widgets/live_plot/statistics_table.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QtTest/QTest>

namespace halbench::widgets {
namespace {

class StatisticsTableTest : public GuiTest {
protected:
    static StatisticsRow row() {
        StatisticsRow made;
        made.name = "Hall A";
        made.unit = "mT";
        made.decimals = 2;
        made.min = -1.5;
        made.max = 2.25;
        made.mean = 0.5;
        made.rms = 1.0;
        made.deviation = 0.866;
        made.count = 1234;
        made.gaps = 2;
        return made;
    }
    StatisticsTable table;
};

TEST_F(StatisticsTableTest, writesEveryNumberInTheUnitShown) {
    table.setRows({row()});
    EXPECT_EQ(table.text(), "Signal\tMin\tMax\tPk-pk\tMean\tRMS\tStd dev\tValues\tGaps\n"
                            "Hall A [mT]\t-1.500\t2.250\t3.750\t0.500\t1.000\t0.866\t1234\t2\n");
}

TEST_F(StatisticsTableTest, whatTheNumbersAreOfStandsAboveTheNames) {
    table.setStretch("In view, 10 s");
    table.setRows({row()});
    EXPECT_TRUE(table.text().startsWith("In view, 10 s\tMin"));
}

TEST_F(StatisticsTableTest, theSlopeIsThereWithCursorsOnly) {
    StatisticsRow sloping = row();
    sloping.slope = -12.5;
    table.setRows({sloping});
    EXPECT_TRUE(table.text().contains("Slope/s")); // of the unit beside the name
    EXPECT_TRUE(table.text().contains("\t-12.5\t")) << table.text().toStdString();
    table.setRows({row()});
    EXPECT_FALSE(table.text().contains("Slope"));
}

TEST_F(StatisticsTableTest, withoutValuesThereAreNoNumbers) {
    StatisticsRow empty;
    empty.name = "State";
    table.setRows({empty});
    EXPECT_TRUE(table.text().contains(QString("State\t%1\t%1").arg(QChar(0x2013))))
        << table.text().toStdString();
}

TEST_F(StatisticsTableTest, isCopiedAsText) {
    table.setRows({row()});
    table.show();
    QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QGuiApplication::clipboard()->text(), table.text());
    QGuiApplication::clipboard()->clear();
    table.actions().front()->trigger(); // by the mouse
    EXPECT_EQ(QGuiApplication::clipboard()->text(), table.text());
}

TEST_F(StatisticsTableTest, columnsDoNotShrinkWhenNumbersDo) {
    StatisticsRow wide = row();
    wide.mean = -123456.0;
    table.setRows({row()});
    const int before = table.columnWidth(4);
    table.setRows({wide});
    const int after = table.columnWidth(4);
    EXPECT_GT(after, before);
    table.setRows({row()});
    EXPECT_EQ(table.columnWidth(4), after);
}

TEST_F(StatisticsTableTest, itsHeightFollowsItsRowsUpToAFew) {
    table.setRows({row()});
    const int one = table.sizeHint().height();
    table.setRows({row(), row()});
    EXPECT_GT(table.sizeHint().height(), one);
    table.setRows(std::vector<StatisticsRow>(40, row()));
    EXPECT_LT(table.sizeHint().height(), 10 * one);
    EXPECT_LT(table.minimumSizeHint().height(), table.sizeHint().height()); // where room is short
}

TEST_F(StatisticsTableTest, namesGiveWayToNumbersAndKeepTheirUnit) {
    StatisticsRow wide = row();
    wide.name = "Reluctance torque of the second coil";
    table.setRows({wide});
    table.resize(2000, 200);
    table.show();
    QCoreApplication::processEvents();
    const QHeaderView& header = *table.horizontalHeader();
    const int whole = header.length();
    ASSERT_LT(whole, table.viewport()->width());
    table.resize(whole - 100, 200);
    QCoreApplication::processEvents();
    EXPECT_LE(header.length(), table.viewport()->width()) << "the last column is in sight";
    EXPECT_EQ(table.textElideMode(), Qt::ElideMiddle);
    EXPECT_EQ(table.item(0, 0)->toolTip(), "Reluctance torque of the second coil [mT]");
    table.resize(2000, 200);
    QCoreApplication::processEvents();
    EXPECT_EQ(header.length(), whole) << "with room again";
}

TEST_F(StatisticsTableTest, itsHeightIsOfWholeRowsAlsoWithAScrollBar) {
    table.setRows(std::vector<StatisticsRow>(5, row()));
    for (const int width : {2000, 200}) { // beside, and with a scroll bar
        table.resize(width, 200);
        table.show();
        QCoreApplication::processEvents();
        for (int room_px = 120; room_px < 160; ++room_px) {
            table.resize(width, table.heightWithin(room_px));
            QCoreApplication::processEvents();
            EXPECT_LE(table.height(), room_px);
            EXPECT_EQ(table.viewport()->height() % table.rowHeight(0), 0) << width << " " << room_px;
        }
    }
}

} // namespace
} // namespace halbench::widgets
