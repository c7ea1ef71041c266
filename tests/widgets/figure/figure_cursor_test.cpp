#include "tests/widgets/gui_fixture.h"
#include "widgets/figure/figure_cursor.h"
#include "widgets/figure/figure_view.h"

#include <QMouseEvent>
#include <QtTest/QTest>

#include <cmath>

namespace halbench::widgets {
namespace {

/// Two loops and a measured point over 1, 10, 100 Hz, magnitude over phase.
Figure linkedPanels() {
    Figure figure;
    figure.title = "Open loop";
    figure.x = {"frequency", "Hz", true, {}, {}, {}};
    figure.isLinked = true;
    Panel magnitude;
    magnitude.y = {"magnitude", "dB", false, {}, {}, {}};
    magnitude.curves = {{"proposed", {1.0, 10.0, 100.0}, {20.0, 0.0, -20.0}, CurveStyle::Line, 0},
                        {"before", {1.0, 10.0, 100.0}, {40.0, 20.0, NAN}, CurveStyle::DashedLine, 1},
                        {"measured", {10.0}, {1.0}, CurveStyle::Points, 6}};
    Panel phase;
    phase.y = {"phase", "deg", false, {}, {}, {}};
    phase.curves = magnitude.curves;
    phase.curves[0].y = {-90.0, -120.0, -180.0};
    phase.curves[1].y = {-90.0, -100.0, -110.0};
    phase.curves[2] = {{}, {10.0}, {-118.0}, CurveStyle::Points, 6}; // named by the panel above
    figure.panels = {magnitude, phase};
    return figure;
}

/// A curve along a frequency in the plane, and a circle along nothing.
Figure plane() {
    Figure figure;
    figure.title = "Nyquist plot";
    figure.x = {"real part", {}, false, -2.0, 2.0, {}};
    figure.parameter = Axis{"frequency", "Hz", true, {}, {}, {}};
    Panel panel;
    panel.y = {"imaginary part", {}, false, -2.0, 2.0, {}};
    panel.curves = {
        {"unit circle", {-1.0, 0.0, 1.0}, {0.0, -1.0, 0.0}, CurveStyle::DottedLine, 6},
        {"proposed", {0.5, -0.5, -0.1}, {-1.5, -0.5, 0.1}, CurveStyle::Line, 0, false, {1.0, 10.0, 100.0}}};
    figure.panels = {panel};
    return figure;
}

class FigureCursorTest : public GuiTest {
protected:
    void show(const Figure& figure) {
        view.setFigure(figure);
        view.resize(700, 500);
        view.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    }
    void point(QEvent::Type type, const QPoint& at) {
        const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, QPointF(at), button, button, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
    }

    FigureView view;
};

TEST_F(FigureCursorTest, everyPanelIsReadAtTheSameFrequency) {
    const Figure figure = linkedPanels();
    const FigureLayout layout = layOut(figure, 700);
    const auto above = readingsAt(figure, layout, 0, std::sqrt(10.0));
    ASSERT_EQ(above.size(), 2U);
    EXPECT_NEAR(above[0].y, 10.0, 1e-12); // halfway over the logarithm of the frequency
    EXPECT_EQ(above[1].text, "before: 30 dB");
    const auto below = readingsAt(figure, layout, 1, 10.0);
    ASSERT_EQ(below.size(), 3U);
    EXPECT_EQ(below[0].text, "proposed: -120 \u00b0");
    EXPECT_EQ(below[2].text, "measured: -118 \u00b0"); // its name stands above
}

TEST_F(FigureCursorTest, aGapHasNoValueAndNothingIsReadBeyondACurve) {
    const Figure figure = linkedPanels();
    const FigureLayout layout = layOut(figure, 700);
    EXPECT_EQ(readingsAt(figure, layout, 0, 50.0).size(), 1U);
    EXPECT_TRUE(readingsAt(figure, layout, 0, 200.0).empty());
}

TEST_F(FigureCursorTest, arrowKeysTakeTheLineThroughAllPanels) {
    show(linkedPanels());
    QTest::keyClick(&view, Qt::Key_Right); // the first sample that can be seen, from the lower left
    view.probeAlong(1.0);
    QTest::keyClick(&view, Qt::Key_Right);
    const QString text = view.probeText();
    EXPECT_TRUE(text.startsWith("frequency 10 Hz; magnitude proposed: 0 dB, before: 20 dB, measured: 1 dB; "
                                "phase proposed: -120 \u00b0"))
        << text.toStdString();
    EXPECT_EQ(view.accessibleDescription(), text);
    QTest::keyClick(&view, Qt::Key_Left);
    EXPECT_EQ(view.probedAlong(), 1.0);
}

TEST_F(FigureCursorTest, aClickKeepsTheFrequencyWhileThePointerGoesElsewhere) {
    show(linkedPanels());
    point(QEvent::MouseMove, {400, 120});
    ASSERT_TRUE(view.probedAlong());
    point(QEvent::MouseButtonPress, {400, 120});
    const auto kept = view.probedAlong();
    point(QEvent::MouseMove, {120, 120});
    EXPECT_EQ(view.probedAlong(), kept);
    point(QEvent::MouseButtonPress, {400, 2}); // above the panels
    EXPECT_FALSE(view.probedAlong());
    point(QEvent::MouseMove, {120, 120}); // it follows again
    EXPECT_NE(view.probedAlong(), kept);
}

TEST_F(FigureCursorTest, thePlaneMarksTheSameFrequency) {
    show(linkedPanels());
    view.probeAlong(10.0);
    view.setFigure(plane());
    EXPECT_EQ(view.probedAlong(), 10.0);
    EXPECT_EQ(view.probeText(), "frequency 10 Hz; proposed: real part -0.5, imaginary part -0.5");
    Figure turned = plane();
    turned.panels[0].curves[1].x[1] = -0.7; // other gains
    view.setFigure(turned);
    EXPECT_TRUE(view.probeText().contains("-0.7")) << view.probeText().toStdString();
    Figure other = linkedPanels();
    other.x.unit = "rad/s"; // the same number would be another frequency
    for (Panel& panel : other.panels) {
        for (Curve& curve : panel.curves) {
            for (double& value : curve.x) {
                value *= 6.28;
            }
        }
    }
    view.setFigure(other);
    EXPECT_FALSE(view.probedAlong());
}

TEST_F(FigureCursorTest, theLineIsDrawnInEveryPanel) {
    show(linkedPanels());
    const QImage before = view.grab().toImage();
    view.probeAlong(10.0);
    const QImage after = view.grab().toImage();
    const FigureLayout layout = layOut(linkedPanels(), 700);
    bool isUpper = false;
    bool isLower = false;
    for (int y = 0; y < after.height(); ++y) {
        for (int x = 0; x < after.width(); ++x) {
            const bool isNew = before.pixel(x, y) != after.pixel(x, y);
            isUpper = isUpper || (isNew && y < after.height() / 2 - 20);
            isLower = isLower || (isNew && y > after.height() / 2 + 20);
        }
    }
    EXPECT_TRUE(isUpper);
    EXPECT_TRUE(isLower);
}

} // namespace
} // namespace halbench::widgets
