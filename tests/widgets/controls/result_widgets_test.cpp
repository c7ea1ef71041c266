#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/controls/verdict_view.h"

#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QSignalSpy>
#include <QVBoxLayout>
#include <QtTest/QTest>

#include <algorithm>

namespace halbench::widgets {
namespace {

class ResultWidgetsTest : public GuiTest {};

TEST_F(ResultWidgetsTest, anEstimateShowsTwoDigitsOfItsInterval) {
    const auto shown = [](double value, double half) {
        const EstimateText text = estimateText(value, half);
        return text.value + "|" + text.half;
    };
    EXPECT_EQ(shown(1.4, 0.0213), "1.400|0.021");
    EXPECT_EQ(shown(1234.5, 21.3), "1235|21"); // half to even is not ours: the C library rounds
    EXPECT_EQ(shown(5.5e-4, 1.23e-6), "0.0005500|0.0000012");
    EXPECT_EQ(shown(1.23e-7, 4.5e-9), "1.230e-7|4.5e-9");
    EXPECT_EQ(estimateText(5.5e-4, std::nullopt).half, "\u2013");
}

TEST_F(ResultWidgetsTest, aValueThatIsNotIdentifiableHasADashAndItsRemedy) {
    EstimateTable table;
    table.setRows({{"damping c", 1.2e-3, 1.1e-3, 1.3e-3, "N\u00b7m\u00b7s/rad", "identified", ""},
                   {"inertia J", {}, {}, {}, "kg\u00b7m\u00b2", "not identifiable", "give J"}});
    EXPECT_EQ(table.rowCount(), 2);
    EXPECT_EQ(table.item(1, 1)->text(), "\u2013");
    EXPECT_EQ(table.item(1, 0)->toolTip(), "give J");
    EXPECT_TRUE(table.item(0, 1)->toolTip().contains("0.0011 to 0.0013"));
    QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QGuiApplication::clipboard()->text().count('\n'), 2);
    EXPECT_TRUE(QGuiApplication::clipboard()->text().contains("0.00120\t0.00010"));
}

// Values of the device come again and again: the rows are measured and laid out when one of them is another.
TEST_F(ResultWidgetsTest, rowsThatAreTheSameStayAsTheyAre) {
    EstimateTable table;
    const std::vector<EstimateRow> rows = {{"damping c", 1.2e-3, 1.1e-3, 1.3e-3, "N", "identified", ""}};
    table.setRows(rows);
    const QTableWidgetItem* first = table.item(0, 1);
    table.setRows(rows);
    EXPECT_EQ(table.item(0, 1), first);
    std::vector<EstimateRow> others = rows;
    others.front().remark = "from the sweep";
    table.setRows(others);
    EXPECT_EQ(table.item(0, 1)->toolTip(), "from the sweep");
    table.setLastTitle("Before"); // a column of numbers is aligned otherwise
    table.setRows(others);
    EXPECT_TRUE(table.item(0, 4)->textAlignment() & Qt::AlignRight);
    table.setRows({});
    EXPECT_EQ(table.rowCount(), 0);
}

TEST_F(ResultWidgetsTest, aVerdictThatGotMoreWidthGivesItsHeightBack) {
    VerdictView view;
    view.setVerdict(VerdictLevel::Good, "Good",
                    {{QString("many words ").repeated(20), QString("more words ").repeated(20)}});
    view.resize(120, 400);
    view.show();
    QTest::qWait(0);
    const int narrow = view.minimumSizeHint().height();
    view.resize(900, 400);
    QTest::qWait(0);
    EXPECT_LT(view.minimumSizeHint().height(), narrow / 3); // lines are over seven times as long
}

TEST_F(ResultWidgetsTest, aTableKnowsTheWidthAtWhichNothingIsShortened) {
    EstimateTable table;
    table.setRows({{"damping c", 1.2e-3, 1.1e-3, 1.3e-3, "N·m·s/rad", "identified", ""},
                   {"inertia J", {}, {}, {}, "kg·m²", "not identifiable", "give J"}});
    table.resize(table.neededWidth(), 200);
    table.show();
    QTest::qWait(0);
    EXPECT_GE(table.columnWidth(table.columnCount() - 1),
              table.fontMetrics().horizontalAdvance("not identifiable"));
    EXPECT_LE(table.horizontalHeader()->length(), table.viewport()->width());
}

TEST_F(ResultWidgetsTest, whereItIsNarrowNamesTakeTwoLinesAndNoColumnIsCut) {
    QWidget page; // first: it must outlive its table
    EstimateTable table;
    table.setLastTitle("On the device");
    table.setRows({{"angle error removed by the map, rms", 1.2, 1.1, 1.3, "\u00b0", "1.15", ""}});
    auto* column = new QVBoxLayout(&page);
    column->addWidget(&table);
    column->addStretch(1);
    page.resize(table.neededWidth() + 40, 300);
    page.show();
    QTest::qWait(0);
    const int one_px = table.height();
    page.resize(table.neededWidth() - 60, 300);
    for (int events = 0; events < 20 && table.height() <= one_px;
         ++events) { // rows, then the page around them
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
    }
    EXPECT_GT(table.height(), one_px); // a line more
    EXPECT_LE(table.horizontalHeader()->length(), table.viewport()->width());
    EXPECT_EQ(table.horizontalHeaderItem(4)->text(), "On the device");
    EXPECT_TRUE(table.item(0, 4)->textAlignment() & Qt::AlignRight);
}

TEST_F(ResultWidgetsTest, aVerdictIsSaidWithEveryRemarkAndRemedy) {
    VerdictView view;
    view.setVerdict(VerdictLevel::Doubtful, "Doubtful", {{"one point decides", "repeat it"}});
    EXPECT_EQ(view.text(), "Doubtful\none point decides; repeat it");
    EXPECT_EQ(view.accessibleDescription(), view.text());
}

TEST_F(ResultWidgetsTest, aVerdictWhoseRemarksStandElsewhereEndsWithoutAColon) {
    QWidget elsewhere;
    QVBoxLayout place(&elsewhere);
    VerdictView view;
    const auto hasLabel = [](const QWidget& parent, const QString& words) {
        const auto labels = parent.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text() == words; });
    };
    view.setVerdict(VerdictLevel::Doubtful, "Stable, if this is true:", {{"stray known", ""}});
    EXPECT_TRUE(hasLabel(view, "Stable, if this is true:"));
    view.moveRemarks(place);
    view.setVerdict(VerdictLevel::Doubtful, "Stable, if this is true:", {{"stray known", ""}});
    EXPECT_TRUE(hasLabel(view, "Stable, if this is true"));
    EXPECT_TRUE(hasLabel(elsewhere, QString::fromUtf8("\u2022 stray known")));
    view.setVerdict(VerdictLevel::Doubtful, QString::fromUtf8("\u7a33\u5b9a\uff1a"), {});
    EXPECT_TRUE(hasLabel(view, QString::fromUtf8("\u7a33\u5b9a")));
}

class OptionalNumberTest : public GuiTest {
protected:
    OptionalNumberTest() { edit.setLimits({0.0, 10.0, false}); }
    void type(const char* text) {
        edit.clear();
        QTest::keyClicks(&edit, text);
    }
    OptionalNumberEdit edit;
};

TEST_F(OptionalNumberTest, readsANumberOrNothing) {
    EXPECT_TRUE(edit.isValid());
    EXPECT_FALSE(edit.value());
    QSignalSpy changes(&edit, &OptionalNumberEdit::valueChanged);
    type("5.5e-4");
    EXPECT_EQ(edit.value(), 5.5e-4);
    EXPECT_GT(changes.count(), 0);
}

TEST_F(OptionalNumberTest, neverHasAValueThatIsNotFiniteOrOutOfItsLimits) {
    edit.setExplanation("the inertia");
    for (const char* text : {"nan", "inf", "-inf", "1e999", "0", "-1", "10.01", "1,5,3", "abc", "0x10"}) {
        type(text);
        EXPECT_FALSE(edit.value()) << text;
        EXPECT_FALSE(edit.isValid()) << text;
        EXPECT_EQ(roleOf(edit), Role::Bad) << text;
        EXPECT_NE(edit.toolTip(), "the inertia") << text;
    }
    type("3");
    EXPECT_EQ(roleOf(edit), Role::None);
    EXPECT_EQ(edit.toolTip(), "the inertia");
}

TEST_F(OptionalNumberTest, keepsAllDigitsOfAValueThatWasNotEdited) {
    edit.setValue(1.0 / 3.0);
    EXPECT_EQ(edit.value(), 1.0 / 3.0);
    EXPECT_EQ(edit.text(), "0.33333"); // enough to read
    edit.setLimits({0.0, 5.0, false}); // reads it again
    QTest::keyClicks(&edit, "4");
    EXPECT_EQ(edit.value(), 0.333334);
    QTest::keyClick(&edit, Qt::Key_Backspace);
    EXPECT_EQ(edit.value(), 1.0 / 3.0); // as if it had not been touched
    edit.setValue(std::nullopt);
    EXPECT_TRUE(edit.text().isEmpty());
}

} // namespace
} // namespace halbench::widgets
