#include "app/window/docks/dock_layout.h"
#include "app/window/help/about_dialog.h"
#include "app/window/help/shortcut_list.h"
#include "tests/app/window/window_test.h"

#include <QAction>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include <set>

namespace halbench::app {
namespace {

class ShortcutListTest : public WindowTest {
protected:
    std::set<QString> shownKeys(const ShortcutList& list) const {
        const auto* table = list.findChild<QTableWidget*>();
        std::set<QString> keys;
        for (int row = 0; row < table->rowCount(); ++row) {
            if (!table->isRowHidden(row)) {
                keys.insert(table->item(row, 0)->text());
            }
        }
        return keys;
    }
};

TEST_F(ShortcutListTest, actionsWithAKeyAreListedByFunctionWithoutMnemonics) {
    QAction save(QStringLiteral("&Save as…"), nullptr);
    save.setShortcut(QKeySequence(QStringLiteral("Ctrl+S")));
    QAction fit(QStringLiteral("Fit"), nullptr);
    fit.setShortcut(QKeySequence(QStringLiteral("F")));
    QAction keyless(QStringLiteral("Nothing"), nullptr);
    const std::vector<ShortcutRow> rows =
        shortcutRows(QList<QAction*>{&save, &keyless, &fit, &save}, QStringLiteral("Plots"));
    EXPECT_EQ(rows, (std::vector<ShortcutRow>{
                        {QStringLiteral("F"), QStringLiteral("Fit"), QStringLiteral("Plots")},
                        {QStringLiteral("Ctrl+S"), QStringLiteral("Save as"), QStringLiteral("Plots")}}));
}

TEST_F(ShortcutListTest, buttonsAreListedByTheirKeyNotByTheirUnderlinedLetter) {
    QPushButton record(QStringLiteral("Record data"));
    record.setShortcut(QKeySequence(QStringLiteral("Ctrl+R")));
    QPushButton apply(QStringLiteral("&Apply"));
    EXPECT_EQ(shortcutRows(QList<QAbstractButton*>{&record, &apply}, QStringLiteral("Bar")),
              (std::vector<ShortcutRow>{
                  {QStringLiteral("Ctrl+R"), QStringLiteral("Record data"), QStringLiteral("Bar")}}));
}

TEST_F(ShortcutListTest, theWindowListsItsOwnKeysAndThoseOfItsPanels) {
    open();
    QAction* show = nullptr;
    for (QAction* action : window->findChildren<QAction*>()) {
        show = action->shortcut() == QKeySequence(QStringLiteral("Ctrl+F1")) ? action : show;
    }
    ASSERT_NE(show, nullptr);
    show->trigger();
    auto* list = window->findChild<ShortcutList*>();
    ASSERT_NE(list, nullptr);
    const std::set<QString> keys = shownKeys(*list);
    for (const char* key : {"Esc", "F11", "Ctrl+I", "Space", "Ctrl+E", "F1", "Ctrl+R", "Ctrl+2"}) {
        EXPECT_EQ(keys.count(QString::fromLatin1(key)), 1U) << key;
    }
    list->findChild<QLineEdit*>()->setText(QStringLiteral("stop actuator"));
    EXPECT_EQ(shownKeys(*list), (std::set<QString>{QStringLiteral("Esc")}));
}

TEST_F(ShortcutListTest, aboutHasTheVersionsThatAFaultReportNeeds) {
    const QString text = aboutText();
    EXPECT_TRUE(text.startsWith(QStringLiteral("Halbench " HALBENCH_VERSION)));
    EXPECT_TRUE(text.contains(QString::fromLatin1(qVersion())));
    EXPECT_TRUE(text.contains(QStringLiteral("Eigen ")));
}

} // namespace
} // namespace halbench::app
