#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/copy_menu.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QTableWidget>
#include <QTreeWidget>

namespace halbench::widgets {
namespace {

using CopyMenuTest = GuiTest;

QString copied(QWidget& view, const QString& words) {
    for (QAction* action : view.actions()) {
        if (action->text() == words) {
            QGuiApplication::clipboard()->clear();
            action->trigger();
            return QGuiApplication::clipboard()->text();
        }
    }
    return QStringLiteral("no such action");
}

TEST_F(CopyMenuTest, copiesCellRowsAndTableWithTabs) {
    QTableWidget table(2, 2);
    table.setHorizontalHeaderLabels({"Name", "Value"});
    const char* texts[2][2] = {{"angle", "1.5"}, {"speed", "2"}};
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 2; ++column) {
            table.setItem(row, column, new QTableWidgetItem(texts[row][column]));
        }
    }
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    addCopyMenu(table);
    EXPECT_EQ(table.contextMenuPolicy(), Qt::ActionsContextMenu);
    table.selectRow(1);
    table.setCurrentCell(1, 1);
    EXPECT_EQ(copied(table, "Copy cell"), "2");
    EXPECT_EQ(copied(table, "Copy rows"), "speed\t2");
    EXPECT_EQ(copied(table, "Copy table"), "Name\tValue\nangle\t1.5\nspeed\t2");
}

TEST_F(CopyMenuTest, ofATreeTheRowsBelowAreCopiedToo) {
    QTreeWidget tree;
    tree.setHeaderLabels({"Signal", "Now"});
    auto* group = new QTreeWidgetItem(&tree, {"Angle"});
    new QTreeWidgetItem(group, {"Reference", "0.10"});
    addCopyMenu(tree);
    EXPECT_EQ(copied(tree, "Copy table"), "Signal\tNow\nAngle\nReference\t0.10");
}

} // namespace
} // namespace halbench::widgets
