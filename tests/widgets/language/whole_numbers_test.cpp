#include "tests/widgets/gui_fixture.h"
#include "widgets/language/whole_numbers.h"

#include <QHeaderView>
#include <QPainter>
#include <QTableWidget>
#include <QtTest/QTest>

namespace halbench::widgets {
namespace {

class WholeNumbersTest : public GuiTest {
protected:
    void SetUp() override {
        table.setItemDelegate(new WholeNumbers(&table));
        table.verticalHeader()->hide();
        table.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
        table.setFocusPolicy(Qt::NoFocus);
        table.setColumnWidth(0, 100);
        table.setColumnWidth(1, 100);
        put("1001");
    }
    void put(const QString& text) {
        auto* cell = new QTableWidgetItem(text);
        cell->setTextAlignment(static_cast<int>(Qt::AlignRight | Qt::AlignVCenter));
        table.setItem(0, 1, cell);
    }
    QImage picture(int width_px) {
        table.resize(width_px, 100);
        table.show();
        QCoreApplication::processEvents();
        return table.viewport()->grab().toImage();
    }

    QTableWidget table{1, 2};
};

TEST_F(WholeNumbersTest, tellNumbersFromWords) {
    for (const char* number : {"1001", "-2.5", "\u2212 3 mT", "\u2264 40", "3 of 5", ".5"}) {
        EXPECT_TRUE(readsAsNumber(QString::fromUtf8(number))) << number;
    }
    for (const char* words : {"", "\u2013", "Hall 1", "A 12", "\u2026"}) {
        EXPECT_FALSE(readsAsNumber(QString::fromUtf8(words))) << words;
    }
}

TEST_F(WholeNumbersTest, aNumberThatTheEdgeCutsIsDotsWhateverItIs) {
    const QImage cut = picture(190); // its last digit would be beyond the edge
    put("77");
    EXPECT_EQ(picture(190), cut) << "nothing of the digits is to be seen";
    put("A 12");
    EXPECT_NE(picture(190), cut) << "words are cut as ever";
}

TEST_F(WholeNumbersTest, aNumberInTooNarrowAColumnIsDotsWhateverItIs) {
    table.resizeColumnToContents(1);
    table.setColumnWidth(1, table.columnWidth(1) - 3);
    const QImage cut = picture(400);
    put("1002");
    EXPECT_EQ(picture(400), cut);
    table.setColumnWidth(1, table.columnWidth(1) + 3);
    const QImage whole = picture(400);
    put("1001");
    EXPECT_NE(picture(400), whole) << "it fits again";
}

TEST_F(WholeNumbersTest, aWholeNumberIsDrawnAsByAnyTable) {
    const QImage whole = picture(400);
    put("77");
    EXPECT_NE(picture(400), whole);
    put("1001");
    table.setItemDelegate(new QStyledItemDelegate(&table));
    EXPECT_EQ(picture(400), whole);
}

} // namespace
} // namespace halbench::widgets
