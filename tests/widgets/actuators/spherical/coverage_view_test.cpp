#include "tests/widgets/gui_fixture.h"
#include "widgets/actuators/spherical/coverage_view.h"
#include "widgets/theme/theme_style.h"

#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QtTest/QTest>

namespace halbench::widgets {
namespace {

/// 3 by 3 poses, 0 to 8 mT; the last one is not covered.
CoverageSlice nine() {
    CoverageSlice slice;
    slice.x = {"β", -10.0, 10.0, 3};
    slice.y = {"α", -10.0, 10.0, 3};
    slice.quantity = "Least reading";
    slice.unit = "mT";
    slice.high = 8.0;
    for (int i = 0; i < 9; ++i) {
        slice.values.push_back(i);
        slice.isUncovered.push_back(i == 8);
    }
    return slice;
}

class CoverageViewTest : public GuiTest {
protected:
    int pixelsOf(const QColor& colour) const {
        QImage image(300, 300, QImage::Format_RGB32);
        QPainter painter(&image);
        view.draw(painter, currentTheme(), image.size());
        painter.end();
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                count += image.pixel(x, y) == colour.rgb();
            }
        }
        return count;
    }

    CoverageView view;
};

TEST_F(CoverageViewTest, uncoveredPosesHaveTheColourOfAnError) {
    CoverageSlice slice = nine();
    view.setSlice(slice);
    const int one = pixelsOf(currentTheme().bad);
    EXPECT_GT(one, 500); // a ninth of the map
    slice.isUncovered[0] = true;
    view.setSlice(slice);
    EXPECT_NEAR(pixelsOf(currentTheme().bad), 2 * one, 0.1 * one);
    slice.isUncovered.assign(9, false);
    view.setSlice(slice);
    EXPECT_EQ(pixelsOf(currentTheme().bad), 0);
}

TEST_F(CoverageViewTest, arrowKeysReadPoses) {
    view.setSlice(nine());
    const QSignalSpy moved(&view, &CoverageView::cursorMoved);
    EXPECT_EQ(view.cursorText(), "");
    QTest::keyClick(&view, Qt::Key_Home);
    EXPECT_EQ(view.cursorText(), "β 0°, α 0°: 4.00 mT");
    QTest::keyClick(&view, Qt::Key_Right);
    QTest::keyClick(&view, Qt::Key_Up);
    EXPECT_EQ(view.cursorText(), "β 10°, α 10°: 8.00 mT, not covered");
    QTest::keyClick(&view, Qt::Key_Right); // the border
    EXPECT_EQ(view.cursorText(), "β 10°, α 10°: 8.00 mT, not covered");
    EXPECT_EQ(view.accessibleDescription(), view.cursorText());
    EXPECT_EQ(moved.count(), 4);
}

TEST_F(CoverageViewTest, aClickReadsThePoseBelowIt) {
    view.setSlice(nine());
    view.resize(300, 300);
    QTest::mouseClick(&view, Qt::LeftButton, {}, {120, 140}); // the middle of the map or beside it
    EXPECT_TRUE(view.cursorText().contains("mT"));
}

TEST_F(CoverageViewTest, anEmptySliceIsOnlyGround) {
    view.setSlice(nine());
    view.setSlice({});
    EXPECT_EQ(view.cursorText(), "");
    EXPECT_EQ(pixelsOf(currentTheme().bad), 0);
    QTest::keyClick(&view, Qt::Key_Home);
    EXPECT_EQ(view.cursorText(), "");
}

} // namespace
} // namespace halbench::widgets
