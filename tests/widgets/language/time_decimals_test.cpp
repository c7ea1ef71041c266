#include "tests/widgets/live_plot/live_plot_stack_fixture.h"
#include "widgets/language/time_decimals.h"
#include "widgets/live_plot/axes/time_field.h"
#include "widgets/live_plot/cursor_bar.h"

#include <QLabel>
#include <QLineEdit>
#include <QtTest>

#include <gtest/gtest.h>

namespace halbench::widgets {
namespace {

TEST(TimeDecimals, followFromTheSamplesAndTheStretchThatIsShown) {
    EXPECT_EQ(timeDecimals(10.0, {}), 4);   // never fewer than before
    EXPECT_EQ(timeDecimals(10.0, 1e-3), 4); // a tenth of 1 ms
    EXPECT_EQ(timeDecimals(10.0, 1e-4), 5); // 10 kHz
    EXPECT_EQ(timeDecimals(10.0, 5e-5), 6); // 20 kHz: a tenth is 5 us
    EXPECT_EQ(timeDecimals(1e-3, 1e-3), 6); // zoomed in: a thousandth of the view
    EXPECT_EQ(timeDecimals(1e-9, 1e-9), 9); // a double has no more
    EXPECT_EQ(timeDecimals(0.0, 0.0), 4);
}

TEST(TimeDecimals, aShortDistanceSaysAsMuchAsALongOne) {
    EXPECT_EQ(timeDistanceText(0.125, 4), "0.12500");
    EXPECT_EQ(timeDistanceText(12.5, 4), "12.5000");
    EXPECT_EQ(timeDistanceText(0.000123456, 5), "0.00012346");
    EXPECT_EQ(timeDistanceText(0.0, 4), "0.0000");
    EXPECT_EQ(timeDistanceText(-0.5, 4), "-0.50000");
}

TEST(TimeDecimals, areCountedAsTyped) {
    EXPECT_EQ(typedDecimals("12.3456789 s"), 7);
    EXPECT_EQ(typedDecimals("-0,25"), 2);
    EXPECT_EQ(typedDecimals("7 s"), 0);
}

class TimeFieldTest : public LivePlotStackTest {
protected:
    TimeFieldTest() {
        QApplication::setActiveWindow(&stack);
        stack.setCursorsVisible(true);
        frame();
    }
    TimeField& field() { return *stack.findChildren<TimeField*>().front(); }
    void enter(const QString& text) {
        field().setFocus();
        field().selectAll();
        QTest::keyClicks(&field(), text);
        QTest::keyClick(&field(), Qt::Key_Return);
        frame();
    }
};

TEST_F(TimeFieldTest, whatWasTypedStaysToTheLastDigit) {
    enter("25.0000125");
    EXPECT_EQ(stack.cursors().a_s, 25.0000125);
    EXPECT_TRUE(field().text().startsWith("25.0000125")) << field().text().toStdString();
    plots().front()->setFocus(); // leaving the field reads it once more
    frame();
    EXPECT_EQ(stack.cursors().a_s, 25.0000125);
    EXPECT_TRUE(field().text().startsWith("25.0000125"));
}

TEST_F(TimeFieldTest, leavingTheFieldDoesNotRoundACursorThatWasDragged) {
    stack.setCursor(0, 24.987654321);
    frame();
    EXPECT_TRUE(field().text().startsWith("24.9877 "));
    field().setFocus();
    QTest::keyClick(&field(), Qt::Key_Return);
    plots().front()->setFocus();
    frame();
    EXPECT_EQ(stack.cursors().a_s, 24.987654321);
}

TEST_F(TimeFieldTest, zoomedInThereAreDecimalsForTwoNeighbours) {
    stack.showTimeRange({20.0, 20.0005});
    stack.setCursor(0, 20.0000004);
    stack.setCursor(1, 20.0000012);
    stack.refresh();
    frame();
    const auto fields = stack.findChildren<TimeField*>();
    EXPECT_NE(fields[0]->text(), fields[1]->text()); // half a microsecond is a thousandth of the view
    // 0.8 us and its reciprocal, to the digits that the times have
    EXPECT_TRUE(stack.findChild<CursorBar*>()->distanceText().contains("0.00000080000"))
        << stack.findChild<CursorBar*>()->distanceText().toStdString();
    EXPECT_TRUE(stack.findChild<CursorBar*>()->distanceText().contains("1.25e6"));
}

} // namespace
} // namespace halbench::widgets
