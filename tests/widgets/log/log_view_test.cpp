#include "tests/widgets/gui_fixture.h"
#include "widgets/log/log_filter_model.h"
#include "widgets/log/log_table_model.h"
#include "widgets/log/log_view.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QComboBox>
#include <QScrollBar>
#include <QTableView>
#include <QtTest/QTest>

namespace halbench::widgets {
namespace {

class LogViewTest : public GuiTest {
protected:
    static LogEntry entry(const char* text, LogLevel level = LogLevel::Information,
                          const char* source = "link") {
        return {12.5, level, QString::fromUtf8(source), QString::fromUtf8(text)};
    }
};

TEST_F(LogViewTest, countsWhatIsSaidAgainInsteadOfRepeatingIt) {
    LogTableModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.append({entry("12 blocks lost"), entry("12 blocks lost"), entry("12 blocks lost"), entry("ok")});
    ASSERT_EQ(model.rowCount(), 2);
    EXPECT_TRUE(
        model.index(0, LogTableModel::TextColumn).data().toString().contains(QStringLiteral("(3 times)")));
}

TEST_F(LogViewTest, keepsTheLastMessagesOnly) {
    LogTableModel model;
    std::vector<LogEntry> entries;
    for (std::size_t i = 0; i < LogTableModel::MostEntries + 5; ++i) {
        entries.push_back(entry(std::to_string(i).c_str()));
    }
    model.append(entries);
    EXPECT_EQ(model.rowCount(), static_cast<int>(LogTableModel::MostEntries));
    EXPECT_EQ(model.index(0, LogTableModel::TextColumn).data().toString(), QStringLiteral("5"));
}

TEST_F(LogViewTest, filtersByLevelAndWords) {
    LogTableModel model;
    model.append({entry("bytes", LogLevel::Debug), entry("connected"),
                  entry("slow", LogLevel::Warning, "board"), entry("lost", LogLevel::Error)});
    LogFilterModel filter;
    filter.setSourceModel(&model);
    EXPECT_EQ(filter.rowCount(), 3); // details are left out unless asked for
    filter.setLeast(LogLevel::Warning);
    EXPECT_EQ(filter.rowCount(), 2);
    filter.setWords(QStringLiteral("BOARD"));
    EXPECT_EQ(filter.rowCount(), 1);
    filter.setLeast(LogLevel::Debug);
    filter.setWords(QString());
    EXPECT_EQ(filter.rowCount(), 4);
}

TEST_F(LogViewTest, copiesWhatIsSelectedOrAllThatIsShown) {
    LogView view;
    view.append({entry("one"), entry("two")});
    auto* table = view.findChild<QTableView*>();
    view.resize(500, 300);
    view.show();
    QApplication::setActiveWindow(&view);
    table->setFocus();
    table->clearSelection();
    EXPECT_EQ(view.text().count(QLatin1Char('\n')), 1);
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QGuiApplication::clipboard()->text(), QStringLiteral("\t12.50\tnote\tlink\tone\n"
                                                                   "\t12.50\tnote\tlink\ttwo"));
    table->selectRow(1);
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    EXPECT_TRUE(QGuiApplication::clipboard()->text().endsWith(QStringLiteral("two")));
    EXPECT_FALSE(QGuiApplication::clipboard()->text().contains(QStringLiteral("one")));
}

TEST_F(LogViewTest, saysTheTimeOfDayBesideTheDevices) {
    LogTableModel model;
    LogEntry said = entry("armed");
    said.wall = QDateTime(QDate(2026, 11, 21), QTime(21, 15, 42)); // local time
    model.append({said});
    EXPECT_EQ(model.index(0, LogTableModel::ClockColumn).data().toString(), QStringLiteral("21:15:42"));
    EXPECT_EQ(model.index(0, LogTableModel::TimeColumn).data().toString(), QStringLiteral("12.50"));
    said.wall = said.wall.addSecs(2);
    model.append({said}); // counted: when it was said last
    EXPECT_TRUE(model.lineText(0).startsWith(QStringLiteral("21:15:44\t12.50\t")));
}

TEST_F(LogViewTest, followsUntilTheUserScrollsUp) {
    LogView view;
    view.resize(500, 200);
    view.show();
    QApplication::processEvents();
    const auto add = [&view](int first, int last) {
        for (int i = first; i < last; ++i) {
            view.append({entry(std::to_string(i).c_str())});
        }
        QApplication::processEvents();
    };
    add(0, 50);
    QScrollBar* bar = view.findChild<QTableView*>()->verticalScrollBar();
    EXPECT_EQ(bar->value(), bar->maximum());
    bar->setValue(10);
    add(50, 60);
    EXPECT_EQ(bar->value(), 10);
}

} // namespace
} // namespace halbench::widgets
