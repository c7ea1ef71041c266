#include "tests/widgets/live_plot/live_plot_stack_fixture.h"

#include <QtTest>

#include <gtest/gtest.h>

namespace halbench::widgets {
namespace {

using Command = LivePlotStack::Command;

class ValueKeysTest : public LivePlotStackTest {
protected:
    ValueKeysTest() {
        QApplication::setActiveWindow(&stack);
        plots()[1]->setFocus();
        frame();
    }
    void press(Qt::Key code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(QApplication::focusWidget(), code, modifiers);
        frame();
    }
};

TEST_F(ValueKeysTest, zoomTheValuesOfThePlotWithTheFocusAroundTheirMiddle) {
    const ValueRange before = stack.valueRange(1);
    const ValueRange other = stack.valueRange(0);
    press(Qt::Key_Plus, Qt::ControlModifier);
    const ValueRange after = stack.valueRange(1);
    EXPECT_NEAR(after.length(), before.length() / 1.5, 1e-9 * before.length());
    EXPECT_NEAR(after.low + after.high, before.low + before.high, 1e-9 * before.length());
    EXPECT_EQ(stack.valueRange(0), other);
    press(Qt::Key_Minus, Qt::ControlModifier);
    press(Qt::Key_Minus, Qt::ControlModifier);
    EXPECT_NEAR(stack.valueRange(1).length(), 1.5 * before.length(), 1e-9 * before.length());
    press(Qt::Key_Equal, Qt::ControlModifier); // where the plus is above it
    EXPECT_NEAR(stack.valueRange(1).length(), before.length(), 1e-9 * before.length());
    press(Qt::Key_Backspace); // steps in a row are one
    EXPECT_EQ(stack.valueRange(1), before);
    EXPECT_FALSE(stack.heldRange(1));
}

TEST_F(ValueKeysTest, arrowsScrollThemAndShiftFGivesThemBackToTheData) {
    const ValueRange before = stack.valueRange(1);
    press(Qt::Key_Up);
    EXPECT_NEAR(stack.valueRange(1).low, before.low + 0.05 * before.length(), 1e-9 * before.length());
    EXPECT_NEAR(stack.valueRange(1).length(), before.length(), 1e-9 * before.length());
    press(Qt::Key_Down, Qt::ShiftModifier);
    EXPECT_NEAR(stack.valueRange(1).high, before.high - 0.2 * before.length(), 1e-9 * before.length());
    EXPECT_TRUE(stack.heldRange(1));
    EXPECT_TRUE(stack.isFollowing()) << "the time is not touched";
    press(Qt::Key_F, Qt::ShiftModifier);
    EXPECT_FALSE(stack.heldRange(1));
}

TEST_F(ValueKeysTest, theRightAxisGoesWithTheLeftOne) {
    std::vector<PlotSpec> specs = motorPlots();
    ASSERT_GE(specs[0].curves.size(), 2U);
    specs[0].curves[1].isRight = true;
    specs[0].right = {"Other", "V", {}};
    stack.setPlots(specs);
    plots()[0]->setFocus();
    frame();
    const double left = stack.valueRange(0).length();
    const double right = stack.valueRange(0, true).length();
    press(Qt::Key_Plus, Qt::ControlModifier);
    EXPECT_NEAR(stack.valueRange(0, true).length() / right, stack.valueRange(0).length() / left, 1e-9);
}

TEST_F(ValueKeysTest, noNumberOfStepsShowsAnAxisThatCannotBeDrawn) {
    for (int i = 0; i < 400; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Minus, Qt::ControlModifier);
    }
    frame();
    EXPECT_LT(stack.valueRange(1).length(), 1e31);
    for (int i = 0; i < 400; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Plus, Qt::ControlModifier);
    }
    frame();
    EXPECT_GT(stack.valueRange(1).length(), 0.0);
}

} // namespace
} // namespace halbench::widgets
