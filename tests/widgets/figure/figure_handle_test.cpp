#include "tests/widgets/gui_fixture.h"
#include "widgets/figure/figure_handle.h"
#include "widgets/figure/figure_view.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QtTest/QTest>

#include <cmath>

namespace halbench::widgets {
namespace {

/// A magnitude over a logarithmic axis above a phase.
Figure bode(double gain_dB = 0.0) {
    Figure figure;
    figure.title = "Open loop";
    figure.x = {"frequency", "Hz", true, {}, {}, {}};
    Panel magnitude;
    magnitude.y = {"magnitude", "dB", false, {}, {}, {}};
    magnitude.curves = {{"L", {0.1, 1.0, 10.0}, {20.0 + gain_dB, gain_dB, -20.0 + gain_dB}, {}, {}}};
    Panel phase;
    phase.y = {"phase", "deg", false, {}, {}, {}};
    phase.curves = {{"L", {0.1, 1.0, 10.0}, {-90.0, -120.0, -170.0}, {}, {}}};
    figure.panels = {magnitude, phase};
    return figure;
}

const std::vector<FigureHandle> Handles = {{0, 1.0, 0.0, FigureHandle::Way::Horizontal, "gain crossover"},
                                           {1, 1.0, -120.0, FigureHandle::Way::Vertical, "phase margin"}};

class FigureHandleTest : public GuiTest {
protected:
    void SetUp() override {
        GuiTest::SetUp();
        view.setFigure(bode());
        view.setHandles(Handles);
        view.resize(600, 420);
        view.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    }
    void mouse(QEvent::Type type, const QPoint& at, Qt::MouseButton button, Qt::MouseButtons buttons) {
        QMouseEvent event(type, QPointF(at), button, buttons, Qt::NoModifier);
        QApplication::sendEvent(&view, &event);
    }
    void press(const QPoint& at) { mouse(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton); }
    void move(const QPoint& at) { mouse(QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton); }
    void release(const QPoint& at) { mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton); }

    FigureView view;
};

TEST_F(FigureHandleTest, aPlaceAndItsValuesAreEachOthersInverse) {
    const Figure figure = bode();
    const FigureLayout layout = layOut(figure, 600);
    for (const FigureHandle& handle : Handles) {
        const auto place = placeOfHandle(figure, layout, handle);
        ASSERT_TRUE(place.has_value());
        const QPointF values = valuesAt(figure, layout, handle.panel, *place);
        EXPECT_NEAR(values.x(), handle.x, 1e-9); // also where the axis is logarithmic
        EXPECT_NEAR(values.y(), handle.y, 1e-9);
        EXPECT_EQ(handleAt(figure, layout, Handles, *place + QPointF(4.0, -4.0)),
                  std::size_t(&handle - Handles.data()));
    }
    EXPECT_FALSE(handleAt(figure, layout, Handles, {5.0, 5.0}).has_value());
    EXPECT_FALSE(placeOfHandle(figure, layout, {0, NAN, 0.0, {}, {}}).has_value());
    EXPECT_FALSE(placeOfHandle(figure, layout, {7, 1.0, 0.0, {}, {}}).has_value());
}

TEST_F(FigureHandleTest, itIsTakenWhereItIsAndMovesAsFarAsThePointer) {
    QSignalSpy taken(&view, &FigureView::handleTaken);
    QSignalSpy moved(&view, &FigureView::handleMoved);
    QSignalSpy released(&view, &FigureView::handleReleased);
    const QPoint at = *view.handlePlace(0);
    press(at + QPoint(3, 2)); // not in its middle
    ASSERT_EQ(taken.count(), 1);
    move(at + QPoint(3, 2));
    // A pixel of this axis is 1 % of the frequency: nothing jumps when it is taken.
    EXPECT_NEAR(moved.back().at(1).toDouble(), 1.0, 0.02);
    move(at + QPoint(103, 2));
    EXPECT_GT(moved.back().at(1).toDouble(), 1.5);
    EXPECT_TRUE(released.isEmpty());
    release(at + QPoint(103, 2));
    EXPECT_EQ(released.count(), 1);
    EXPECT_FALSE(view.isHeld());
}

TEST_F(FigureHandleTest, theAxesStayWhileItIsHeldAndFindTheirExtentAfterwards) {
    press(*view.handlePlace(0));
    const QPoint before = *view.handlePlace(1);
    view.setFigure(bode(60.0));
    EXPECT_EQ(*view.handlePlace(1), before);
    EXPECT_TRUE(view.figure().panels[0].y.max.has_value());
    release(before);
    view.setFigure(bode(60.0));
    EXPECT_FALSE(view.figure().panels[0].y.max.has_value());
}

TEST_F(FigureHandleTest, besideAHandleNothingIsTaken) {
    QSignalSpy taken(&view, &FigureView::handleTaken);
    press(*view.handlePlace(0) + QPoint(60, 30));
    EXPECT_TRUE(taken.isEmpty());
    mouse(QEvent::MouseButtonPress, *view.handlePlace(0), Qt::RightButton, Qt::RightButton);
    EXPECT_TRUE(taken.isEmpty()); // the menu
}

TEST_F(FigureHandleTest, aReleaseThatNobodySawEndsItToo) {
    QSignalSpy released(&view, &FigureView::handleReleased);
    const QPoint at = *view.handlePlace(0);
    press(at);
    mouse(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
    EXPECT_EQ(released.count(), 1);
    press(at);
    view.setHandles({}); // what was held is gone
    EXPECT_EQ(released.count(), 2);
    EXPECT_FALSE(view.isHeld());
}

TEST_F(FigureHandleTest, theKeyboardMovesTheOneThatGoesThisWayAndIsSaidTo) {
    QSignalSpy stepped(&view, &FigureView::handleStepped);
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_Right, Qt::ControlModifier);
    QTest::keyClick(&view, Qt::Key_Down, Qt::ControlModifier);
    ASSERT_EQ(stepped.count(), 2);
    EXPECT_EQ(stepped.at(0).at(0).toInt(), 0);
    EXPECT_EQ(stepped.at(0).at(1).toInt(), 1);
    EXPECT_EQ(stepped.at(1).at(0).toInt(), 1);
    EXPECT_EQ(stepped.at(1).at(1).toInt(), -1);
    EXPECT_TRUE(view.accessibleDescription().contains("gain crossover, phase margin"))
        << view.accessibleDescription().toStdString();
    QTest::keyClick(&view, Qt::Key_Right); // without Ctrl it walks along the samples
    EXPECT_FALSE(view.probeText().isEmpty());
}

TEST_F(FigureHandleTest, thePointerShowsWhichWayItGoes) {
    mouse(QEvent::MouseMove, *view.handlePlace(0), Qt::NoButton, Qt::NoButton);
    EXPECT_EQ(view.cursor().shape(), Qt::SizeHorCursor);
    EXPECT_EQ(view.toolTip(), "Drag: gain crossover");
    mouse(QEvent::MouseMove, *view.handlePlace(1), Qt::NoButton, Qt::NoButton);
    EXPECT_EQ(view.cursor().shape(), Qt::SizeVerCursor);
    mouse(QEvent::MouseMove, {20, 20}, Qt::NoButton, Qt::NoButton);
    EXPECT_EQ(view.cursor().shape(), Qt::ArrowCursor);
    EXPECT_TRUE(view.toolTip().isEmpty());
}

} // namespace
} // namespace halbench::widgets
