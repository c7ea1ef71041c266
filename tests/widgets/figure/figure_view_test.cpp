#include "tests/widgets/gui_fixture.h"
#include "widgets/figure/figure_probe.h"
#include "widgets/figure/figure_scales.h"
#include "widgets/figure/figure_view.h"

#include <QClipboard>
#include <QFile>
#include <QFileInfo>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest/QTest>

#include <cmath>

namespace halbench::widgets {
namespace {

/// Two panels above the time axis: a line of 11 points and three single points.
Figure twoPanels() {
    Figure figure;
    figure.title = "Test run";
    figure.x = {"time", "s", false, 0.0, 10.0, {}};
    Panel upper;
    upper.y = {"angle", "deg", false, 0.0, 100.0, {}};
    Curve line{"measured", {}, {}, CurveStyle::Line, {}};
    for (int i = 0; i <= 10; ++i) {
        line.x.push_back(i);
        line.y.push_back(i == 3 ? NAN : 10.0 * i);
    }
    upper.curves = {line};
    Panel lower;
    lower.y = {"current", "A", false, -1.0, 1.0, {}};
    lower.curves = {{"command", {2.0, 5.0, 8.0}, {-0.5, 0.0, 0.5}, CurveStyle::Points, {}}};
    figure.panels = {upper, lower};
    return figure;
}

class FigureViewTest : public GuiTest {
protected:
    void showFigure(QSize size) {
        view.setFigure(twoPanels());
        view.resize(size);
        view.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    }

    FigureView view;
};

TEST_F(FigureViewTest, theNearestSampleIsTheOneUnderThePointer) {
    const Figure figure = twoPanels();
    const FigureLayout layout = layOut(figure, 600);
    const FigurePoint wanted{1, 0, 1};
    const auto place = placeOf(figure, layout, wanted);
    ASSERT_TRUE(place);
    EXPECT_EQ(nearestPoint(figure, layout, *place + QPointF(3.0, -4.0), 6.0), wanted);
    EXPECT_FALSE(nearestPoint(figure, layout, *place + QPointF(30.0, -40.0), 6.0));
    EXPECT_FALSE(placeOf(figure, layout, {0, 0, 3})); // not a number
}

TEST_F(FigureViewTest, aWalkLeavesOutWhatCannotBeSeen) {
    const Figure figure = twoPanels();
    const FigureLayout layout = layOut(figure, 600);
    EXPECT_EQ(neighbour(figure, layout, {0, 0, 2}, 1).index, 4U);
    EXPECT_EQ(neighbour(figure, layout, {0, 0, 4}, -1).index, 2U);
    EXPECT_EQ(neighbour(figure, layout, {0, 0, 10}, 1).index, 10U);
}

TEST_F(FigureViewTest, aSampleIsSaidWithItsUnits) {
    EXPECT_EQ(pointText(twoPanels(), {1, 0, 2}), "command: time 8 s, current 0.5 A");
}

TEST_F(FigureViewTest, whatItShowsIsSaidToThoseWhoHearIt) {
    showFigure({500, 360});
    EXPECT_EQ(view.accessibleName(), "Test run");
    EXPECT_TRUE(view.accessibleDescription().contains("angle from 0 \u00b0 to 100 \u00b0 (measured)"))
        << view.accessibleDescription().toStdString();
    view.clear();
    EXPECT_FALSE(view.accessibleName().isEmpty());
}

TEST_F(FigureViewTest, arrowKeysWalkFromSampleToSample) {
    showFigure({500, 360});
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_EQ(view.probeText(), "measured: time 0 s, angle 0 \u00b0");
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_EQ(view.probeText(), "measured: time 1 s, angle 10 \u00b0");
    EXPECT_EQ(view.accessibleDescription(), view.probeText());
    QTest::keyClick(&view, Qt::Key_Left);
    EXPECT_EQ(view.probeText(), "measured: time 0 s, angle 0 \u00b0");
}

TEST_F(FigureViewTest, thePointerFindsASampleAtEveryFontSize) {
    for (const double size_pt : {9.5, 19.0}) {
        applyTheme(*qApp, currentTheme(), {QLocale::c(), size_pt});
        showFigure({900, 700});
        QString found;
        // The middle one of the three lower points lies in the middle of the lower panel.
        for (int y = 360; y < 700 && found.isEmpty(); y += 8) {
            for (int x = 400; x < 600 && found.isEmpty(); x += 8) {
                QMouseEvent move(QEvent::MouseMove, QPointF(x, y), Qt::NoButton, Qt::NoButton,
                                 Qt::NoModifier);
                QCoreApplication::sendEvent(&view, &move);
                found = view.probeText();
            }
        }
        EXPECT_TRUE(found.startsWith("command")) << size_pt;
    }
}

TEST_F(FigureViewTest, fillsItsHeightAndNeverNeedsMoreThanItsMinimum) {
    showFigure({500, 360});
    EXPECT_LE(view.minimumSizeHint().height(), 300);
    EXPECT_EQ(view.image(2.0).size(), QSize(1000, 720));
    const QImage picture = view.image(1.0);
    const QImage shown = view.grab().toImage();
    dress("dark");
    EXPECT_NE(view.grab().toImage().pixel(1, 1), shown.pixel(1, 1)); // in the colours of the new theme
    EXPECT_EQ(view.image(1.0), picture) << "what leaves the window is for paper";
}

TEST_F(FigureViewTest, savesThePictureOfTheMomentItWasTaken) {
    showFigure({500, 360});
    const QImage before = view.image(2.0);
    const PictureSaving taken = view.taken();
    view.clear(); // while the file is chosen
    const QTemporaryDir folder;
    ASSERT_TRUE(taken(folder.filePath("a.png"))());
    EXPECT_EQ(QImage(folder.filePath("a.png")).convertToFormat(QImage::Format_RGB32),
              before.convertToFormat(QImage::Format_RGB32));
    ASSERT_TRUE(taken(folder.filePath("a.csv"))());
    EXPECT_GT(QFileInfo(folder.filePath("a.csv")).size(), 20);
}

TEST_F(FigureViewTest, copiesAndSavesThePicture) {
    showFigure({500, 360});
    QTest::keyClick(&view, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QGuiApplication::clipboard()->image().size(), QSize(1000, 720));
    QSignalSpy exports(&view, &FigureView::exportRequested);
    QTest::keyClick(&view, Qt::Key_E, Qt::ControlModifier);
    EXPECT_EQ(exports.count(), 1);

    const QTemporaryDir folder;
    ASSERT_TRUE(view.taken()(folder.filePath("a.png"))());
    EXPECT_EQ(QImage(folder.filePath("a.png")).size(), QSize(1000, 720));
    ASSERT_TRUE(view.taken()(folder.filePath("a.svg"))());
    QFile svg(folder.filePath("a.svg"));
    ASSERT_TRUE(svg.open(QIODevice::ReadOnly));
    EXPECT_TRUE(svg.readAll().contains("Test run"));
    const auto refused = view.taken()(folder.filePath("none/a.png"))();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::FileSystem);
}

TEST_F(FigureViewTest, theMarkStaysWhileItsSampleKeepsItsPlace) {
    showFigure({700, 500});
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_Right);
    QTest::keyClick(&view, Qt::Key_Right);
    const QString before = view.probeText();
    ASSERT_FALSE(before.isEmpty());
    Figure risen = twoPanels();
    for (double& value : risen.panels[0].curves[0].y) {
        value += 5.0;
    }
    view.setFigure(risen);
    EXPECT_FALSE(view.probeText().isEmpty());
    EXPECT_NE(view.probeText(), before); // the value there now
    for (double& value : risen.panels[0].curves[0].x) {
        value += 0.25;
    }
    view.setFigure(risen);
    EXPECT_TRUE(view.probeText().isEmpty());
}

TEST_F(FigureViewTest, onEqualScalesACircleIsRound) {
    Figure figure;
    figure.isEqualScale = true;
    figure.x = {"a", "mT", false, {}, {}, {}};
    Panel panel;
    panel.y = {"b", "mT", false, {}, {}, {}};
    panel.curves = {{"circle", {-100.0, 100.0, 0.0, 0.0}, {0.0, 0.0, -100.0, 100.0}, CurveStyle::Points, {}}};
    figure.panels = {panel};
    for (const int width_px : {400, 900}) {
        Figure drawn = figure;
        makeEqualScale(drawn, width_px);
        const FigureLayout layout = layOut(drawn, width_px);
        const auto place = [&](std::size_t index) { return *placeOf(drawn, layout, {0, 0, index}); };
        EXPECT_NEAR(place(1).x() - place(0).x(), place(2).y() - place(3).y(), 1e-6) << width_px;
        EXPECT_TRUE(layout.panels[0].canvas.contains(place(0)));
        EXPECT_TRUE(layout.panels[0].canvas.contains(place(3)));
    }
}

} // namespace
} // namespace halbench::widgets
