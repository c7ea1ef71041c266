#include "app/window/start/start_list.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/message_bar.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeWidget>

namespace halbench::app {
namespace {

class StartListTest : public WindowTest {
protected:
    void make(StartList::Kind kind) {
        list = std::make_unique<StartList>(
            StartList::Words{QStringLiteral("Recent"), QStringLiteral("None yet."), QStringLiteral("Tip")},
            kind, nullptr);
        list->setEntries({{QStringLiteral("/a/one.toml"), QStringLiteral("one.toml"), QStringLiteral("/a")},
                          {QStringLiteral("/b/two.toml"),
                           QStringLiteral("two.toml"),
                           QStringLiteral("/b"),
                           {},
                           QStringLiteral("moved or deleted")}});
        list->resize(400, 300);
        list->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(list.get()));
    }
    void TearDown() override {
        list.reset();
        WindowTest::TearDown();
    }
    QTreeWidget& rows() { return *list->findChild<QTreeWidget*>(); }
    widgets::MessageBar& message() { return *list->findChild<widgets::MessageBar*>(); }
    QAction* action(const QString& text) {
        for (QAction* found : rows().actions()) {
            if (found->text() == text) {
                return found;
            }
        }
        return nullptr;
    }
    void choose(int row) { rows().setCurrentItem(rows().topLevelItem(row)); }

    std::unique_ptr<StartList> list;
};

TEST_F(StartListTest, enterAndDoubleClickOpenTheRow) {
    make(StartList::Kind::Files);
    QSignalSpy opened(list.get(), &StartList::openRequested);
    choose(0);
    QTest::keyClick(&rows(), Qt::Key_Return);
    ASSERT_EQ(opened.size(), 1);
    EXPECT_EQ(opened.front().front().toString(), QStringLiteral("/a/one.toml"));
    const QPoint place = rows().visualItemRect(rows().topLevelItem(0)).center();
    QTest::mouseClick(rows().viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(rows().viewport(), Qt::LeftButton, {}, place);
    EXPECT_EQ(opened.size(), 2);
}

TEST_F(StartListTest, aRowThatCannotBeOpenedSaysWhyAndCanBeRemoved) {
    make(StartList::Kind::Files);
    QSignalSpy opened(list.get(), &StartList::openRequested);
    QSignalSpy removed(list.get(), &StartList::removeRequested);
    EXPECT_EQ(rows().topLevelItem(1)->text(1), QStringLiteral("moved or deleted"));
    EXPECT_EQ(rows().topLevelItem(1)->foreground(0).color(),
              list->palette().color(QPalette::Disabled, QPalette::Text));
    choose(1);
    EXPECT_FALSE(action(QStringLiteral("Open"))->isEnabled());
    QTest::keyClick(&rows(), Qt::Key_Return);
    EXPECT_EQ(opened.size(), 0);
    ASSERT_TRUE(message().isVisible());
    EXPECT_TRUE(message().message().text.contains(QStringLiteral("moved or deleted")));
    EXPECT_EQ(message().message().remedy, QStringLiteral("/b/two.toml"));
    EXPECT_EQ(message().message().actionText, QStringLiteral("Remove from the list"));
    Q_EMIT message().actionTriggered();
    ASSERT_EQ(removed.size(), 1);
    EXPECT_EQ(removed.front().front().toString(), QStringLiteral("/b/two.toml"));
    EXPECT_FALSE(message().isVisible());
    QTest::keyClick(&rows(), Qt::Key_Return);
    choose(0);
    EXPECT_FALSE(message().isVisible()) << "it was of another row";
}

TEST_F(StartListTest, deleteRemovesAndTheMenuHasFourEntriesForFiles) {
    make(StartList::Kind::Files);
    rows().activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(list.get()));
    QSignalSpy removed(list.get(), &StartList::removeRequested);
    choose(0);
    rows().setFocus();
    QTest::keyClick(&rows(), Qt::Key_Delete);
    ASSERT_EQ(removed.size(), 1);
    EXPECT_EQ(removed.front().front().toString(), QStringLiteral("/a/one.toml"));
    EXPECT_EQ(rows().actions().size(), 4);
    make(StartList::Kind::BuiltIn);
    EXPECT_EQ(rows().actions().size(), 1) << "what comes with the program stays in its list";
}

TEST_F(StartListTest, isAsTallAsItsRowsAndSaysWhenThereIsNone) {
    make(StartList::Kind::Files);
    const QRect last = rows().visualItemRect(rows().topLevelItem(1));
    EXPECT_TRUE(rows().viewport()->rect().contains(last));
    EXPECT_LT(rows().viewport()->height(), last.bottom() + last.height());
    list->setEntries({});
    EXPECT_FALSE(rows().isVisible());
    QStringList said;
    for (const auto* label : list->findChildren<QLabel*>()) {
        said << (label->isVisible() ? label->text() : QString());
    }
    EXPECT_TRUE(said.contains(QStringLiteral("None yet.")));
}

TEST_F(StartListTest, theCurrentRowStaysWhateverComesBeforeIt) {
    make(StartList::Kind::Files);
    choose(0);
    std::vector<StartEntry> entries = list->entries();
    entries.insert(entries.begin(), {QStringLiteral("/c/new.toml"), QStringLiteral("new.toml"), {}});
    list->setEntries(entries);
    EXPECT_EQ(rows().currentItem()->text(0), QStringLiteral("one.toml"));
    widgets::applyTheme(application, widgets::loadTheme("dark").value()); // makes the rows anew
    ASSERT_EQ(rows().topLevelItemCount(), 3);
    EXPECT_EQ(rows().currentItem()->text(0), QStringLiteral("one.toml"));
}

TEST_F(StartListTest, isReadOutByNameWithItsDetail) {
    make(StartList::Kind::Files);
    EXPECT_EQ(rows().accessibleName(), QStringLiteral("Recent"));
    EXPECT_EQ(rows().topLevelItem(0)->data(0, Qt::AccessibleTextRole).toString(),
              QStringLiteral("one.toml, /a"));
}

} // namespace
} // namespace halbench::app
