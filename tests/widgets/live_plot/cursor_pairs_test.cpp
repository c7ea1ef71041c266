#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/live_plot/cursor_bar.h"
#include "widgets/live_plot/cursor_pairs.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QtTest>

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::widgets {
namespace {

using Command = LivePlotStack::Command;

TEST(CursorPairs, thereIsAlwaysOneWithANameOfItsOwn) {
    CursorPairs pairs;
    ASSERT_EQ(pairs.list().size(), 1U);
    EXPECT_FALSE(pairs.areKept());
    pairs.add(1.0, 2.0);
    pairs.add(3.0, 4.0);
    EXPECT_EQ(pairs.name(), "3");
    EXPECT_TRUE(pairs.rename(" rise "));
    EXPECT_EQ(pairs.name(), "rise");
    EXPECT_FALSE(pairs.rename("2"));
    EXPECT_FALSE(pairs.rename("  "));
    EXPECT_EQ(pairs.name(), "rise");
    pairs.remove();
    EXPECT_EQ(pairs.name(), "2"); // the last of those that are left
    pairs.remove();
    pairs.remove();
    ASSERT_EQ(pairs.list().size(), 1U);
    EXPECT_FALSE(pairs.areKept());
}

TEST(CursorPairs, whatWasKeptWithoutANameOrTwiceGetsANumber) {
    const CursorPairs pairs({{"rise", 1.0, 2.0}, {"", 3.0, 4.0}, {"rise", 5.0, 6.0}}, 7);
    ASSERT_EQ(pairs.list().size(), 3U);
    EXPECT_EQ(pairs.list()[1].name, "1");
    EXPECT_EQ(pairs.list()[2].name, "2");
    EXPECT_EQ(pairs.chosen(), 2U);
    EXPECT_DOUBLE_EQ(pairs.cursors().b_s, 6.0);
}

/// Keys as the window gives them: shortcuts need an active one.
class CursorPairKeysTest : public LivePlotStackTest {
protected:
    CursorPairKeysTest() {
        QApplication::setActiveWindow(&stack);
        plots().front()->setFocus();
    }
    void press(Qt::Key code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(QApplication::focusWidget(), code, modifiers);
        frame();
    }
    void type(const QString& text) {
        QTest::keyClicks(QApplication::focusWidget(), text);
        press(Qt::Key_Return);
    }
    CursorBar& bar() { return *stack.findChild<CursorBar*>(); }
};

TEST_F(CursorPairKeysTest, aPairIsAddedNamedChosenAndRemovedByKeys) {
    press(Qt::Key_N); // cursors were not shown: the first pair is the new one
    EXPECT_TRUE(stack.cursors().isVisible);
    ASSERT_EQ(stack.cursorPairs().list().size(), 1U);
    const CursorPair first = stack.cursors();
    press(Qt::Key_F2);
    type("rise");
    EXPECT_EQ(stack.cursorPairs().name(), "rise");
    plots().front()->setFocus();
    press(Qt::Key_N);
    ASSERT_EQ(stack.cursorPairs().list().size(), 2U);
    EXPECT_EQ(stack.cursorPairs().name(), "1");
    press(Qt::Key_Right);
    EXPECT_NE(stack.cursors().a_s, first.a_s);
    EXPECT_DOUBLE_EQ(stack.cursorPairs().list()[0].a_s, first.a_s); // the other one stays
    press(Qt::Key_P);
    EXPECT_EQ(stack.cursorPairs().name(), "rise");
    press(Qt::Key_P, Qt::ShiftModifier);
    EXPECT_EQ(stack.cursorPairs().name(), "1");
    press(Qt::Key_N, Qt::ShiftModifier);
    ASSERT_EQ(stack.cursorPairs().list().size(), 1U);
    EXPECT_EQ(stack.cursorPairs().name(), "rise");
    EXPECT_DOUBLE_EQ(stack.cursors().a_s, first.a_s);
}

TEST_F(CursorPairKeysTest, aNameThatIsTakenOrEmptyIsRefusedInPlaceAndTheOldOneStays) {
    press(Qt::Key_C);
    press(Qt::Key_N);
    press(Qt::Key_F2);
    type("1");
    EXPECT_EQ(stack.cursorPairs().name(), "2");
    QString said;
    for (const QLabel* label : bar().findChildren<QLabel*>()) {
        said += label->text();
    }
    EXPECT_TRUE(said.contains("Pair 1 exists already")) << said.toStdString();
    EXPECT_FALSE(bar().findChild<QLineEdit*>("name")->isVisible());
    EXPECT_EQ(bar().findChild<QToolButton*>()->text(), "2");
}

TEST_F(CursorPairKeysTest, theMenuOfTheBarHasThePairsAndWhatCanBeDoneWithThem) {
    press(Qt::Key_C);
    press(Qt::Key_N);
    QMenu* menu = bar().findChild<QToolButton*>()->menu();
    Q_EMIT menu->aboutToShow();
    const QList<QAction*> entries = menu->actions();
    ASSERT_EQ(entries.size(), 2 + 1 + 7); // pairs, a line, actions
    EXPECT_TRUE(entries[1]->isChecked());
    entries[0]->trigger();
    EXPECT_EQ(stack.cursorPairs().name(), "1");
    EXPECT_EQ(entries[3], stack.action(Command::NewPair));
}

TEST_F(CursorPairKeysTest, theBarIsWholeOnTheWindowsFirstSize) {
    applyTheme(*qApp, loadTheme("light").value(), {QLocale(), Dress().fontSize_pt}); // as in the window
    stack.resize(690, 560); // what 1440 x 900 leaves for it
    CursorPairs long_({{"A name of more than a few letters", 1234.5678, 1012.25}, {"b", 0.0, 1.0}}, 0);
    long_.setVisible(true);
    stack.setCursorPairs(long_);
    frame();
    EXPECT_LE(bar().minimumSizeHint().width(), 690);
    for (const QLabel* label : bar().findChildren<QLabel*>()) {
        if (label->isVisible() && !label->text().isEmpty()) {
            EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
        }
    }
}

TEST_F(CursorPairKeysTest, lettersOfANameAreNoCommands) {
    press(Qt::Key_C);
    press(Qt::Key_F2);
    type("NAP and GC");
    EXPECT_EQ(stack.cursorPairs().name(), "NAP and GC");
    EXPECT_EQ(stack.cursorPairs().list().size(), 1U);
    EXPECT_FALSE(stack.isPaused());
}

TEST_F(CursorPairKeysTest, theViewGoesToThePairAndThePairComesIntoTheView) {
    press(Qt::Key_C);
    stack.setCursor(0, 3.0);
    stack.setCursor(1, 5.0);
    press(Qt::Key_G);
    EXPECT_NEAR(stack.timeRange().begin_s, 2.0, 1e-9); // the pair is the middle half
    EXPECT_NEAR(stack.timeRange().end_s, 6.0, 1e-9);
    stack.showTimeRange({10.0, 16.0});
    press(Qt::Key_C, Qt::ShiftModifier);
    EXPECT_NEAR(stack.cursors().a_s, 12.0, 1e-9);
    EXPECT_NEAR(stack.cursors().b_s, 14.0, 1e-9);
}

TEST_F(CursorPairKeysTest, onlyAPairThatNobodyNamedComesIntoTheViewByItself) {
    CursorPairs kept({{"rise", 1.0, 2.0}}, 0);
    stack.setCursorPairs(kept);
    press(Qt::Key_C);
    EXPECT_DOUBLE_EQ(stack.cursors().a_s, 1.0); // the view follows at 30 s
    stack.setCursorPairs({});
    press(Qt::Key_C);
    EXPECT_GT(stack.cursors().a_s, 15.0);
}

TEST_F(CursorPairKeysTest, aCursorOfAnotherPairIsTakenByTheMouseAndItsPairMeasures) {
    const control::TimeRange view = stack.timeRange();
    stack.setPaused(true);
    CursorPairs two(
        {{"one", view.begin_s + 1.0, view.begin_s + 2.0}, {"two", view.begin_s + 5.0, view.begin_s + 7.0}},
        0);
    two.setVisible(true);
    stack.setCursorPairs(two);
    frame();
    LivePlot* plot = plots()[2];
    const auto xOf = [&](double time_s) {
        return static_cast<int>(std::lround(plot->canvasMap(QwtPlot::xBottom).transform(time_s)));
    };
    drag(plot, {xOf(view.begin_s + 7.0), 30}, {xOf(view.begin_s + 8.0), 30}, Qt::LeftButton);
    EXPECT_EQ(stack.cursorPairs().name(), "two");
    EXPECT_NEAR(stack.cursors().b_s, view.begin_s + 8.0, 0.01); // a column
    EXPECT_DOUBLE_EQ(stack.cursorPairs().list()[0].b_s, view.begin_s + 2.0);
}

TEST_F(CursorPairKeysTest, allPairsAreDrawnThoseThatDoNotMeasureFaintly) {
    stack.setPlots({PlotSpec{}}); // no grid, no curves
    stack.showTimeRange({0.0, 10.0});
    CursorPairs two({{"one", 2.0, 4.0}, {"two", 6.0, 8.0}}, 1);
    two.setVisible(true);
    stack.setCursorPairs(two);
    frame();
    LivePlot* plot = plots()[0];
    const QImage image = plot->canvas()->grab().toImage();
    const Theme theme = loadTheme("light").value();
    const auto share = [&](double time_s) { // of the line's pixels below the flag that are inked
        const int x = static_cast<int>(std::lround(plot->canvasMap(QwtPlot::xBottom).transform(time_s)));
        int inked = 0;
        const int top = 2 * stack.fontMetrics().height();
        for (int y = top; y < image.height() - 4; ++y) {
            bool isInked = false;
            for (int dx = -1; dx <= 1; ++dx) {
                isInked = isInked || image.pixelColor(x + dx, y) != theme.plotBackground;
            }
            inked += isInked ? 1 : 0;
        }
        return static_cast<double>(inked) / (image.height() - 4 - top);
    };
    EXPECT_GT(share(6.0), 0.9);
    EXPECT_GT(share(8.0), 0.9);
    EXPECT_GT(share(2.0), 0.2); // dots
    EXPECT_LT(share(2.0), 0.7);
    EXPECT_LT(share(5.0), 0.1);
}

} // namespace
} // namespace halbench::widgets
