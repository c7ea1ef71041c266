#include "widgets/raster/curve_mask.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::widgets {
namespace {

constexpr int Columns = 60;
constexpr int Rows = 50;

/// White ink on black, so that a pixel's value is its coverage.
class CurveMaskTest : public testing::Test {
protected:
    CurveMaskTest() {
        image.fill(Qt::black);
        mask.begin(Columns, Rows);
    }
    void paint() { mask.paint(image, Qt::white, {}); }
    int at(int column, int row) const { return qGreen(image.pixel(column, row)); }
    double ink() const {
        double sum = 0.0;
        for (int column = 0; column < Columns; ++column) {
            for (int row = 0; row < Rows; ++row) {
                sum += at(column, row) / 255.0;
            }
        }
        return sum;
    }

    QImage image{Columns, Rows, QImage::Format_RGB32};
    CurveMask mask;
};

TEST_F(CurveMaskTest, aBoxHasSoftEndsAndAFullMiddle) {
    mask.addBox(7, 10.75, 14.0, 1.0); // half a row of pen beyond each end
    paint();
    EXPECT_NEAR(at(7, 10), 0.75 * 255.0, 2.0);
    EXPECT_EQ(at(7, 11), 255);
    EXPECT_EQ(at(7, 13), 255);
    EXPECT_NEAR(at(7, 14), 0.5 * 255.0, 2.0);
    EXPECT_EQ(at(7, 9) + at(7, 15) + at(6, 12) + at(8, 12), 0);
}

TEST_F(CurveMaskTest, aSpikeIsAsWideAsThePen) {
    mask.addBox(20, 10.0, 30.0, 3.0);
    paint();
    EXPECT_EQ(at(19, 20) + at(20, 20) + at(21, 20), 3 * 255);
    EXPECT_EQ(at(18, 20) + at(22, 20), 0);
    mask.begin(Columns, Rows);
    mask.addBox(40, 10.0, 30.0, 1.5);
    paint();
    EXPECT_NEAR(at(39, 20) + at(40, 20) + at(41, 20), 1.5 * 255.0, 2.0);
}

TEST_F(CurveMaskTest, aFlatLineOfBoxesIsAsThickAsThePen) {
    for (int column = 0; column < Columns; ++column) {
        mask.addBox(column, 20.3, 20.3, 1.5);
    }
    paint();
    EXPECT_NEAR(ink(), 1.5 * Columns, 0.02 * Columns);
}

TEST_F(CurveMaskTest, linesOfAnyDirectionHaveTheInkOfTheirLengthAndWidth) {
    for (const double angle : {0.0, 0.2, 0.7, 0.9, 1.3, 1.5708, 2.2}) {
        image.fill(Qt::black);
        mask.begin(Columns, Rows);
        const PixelPoint from{30.0 - 15.0 * std::cos(angle), 25.0 - 15.0 * std::sin(angle)};
        const PixelPoint to{30.0 + 15.0 * std::cos(angle), 25.0 + 15.0 * std::sin(angle)};
        const bool isForward = from.x <= to.x;
        mask.addLine(isForward ? from : to, isForward ? to : from, 1.5);
        paint();
        EXPECT_NEAR(ink(), 45.0, 0.3) << angle; // 30 long, 1.5 wide; coverage is rounded to 1/255
    }
}

TEST_F(CurveMaskTest, aLineOfManyPiecesIsAsStrongAsOneOfOne) {
    for (int i = 0; i < 100; ++i) {
        mask.addLine({5.0 + 0.4 * i, 20.0 + 0.1 * i}, {5.4 + 0.4 * i, 20.1 + 0.1 * i}, 1.5);
    }
    paint();
    EXPECT_NEAR(ink(), 1.5 * std::hypot(40.0, 10.0), 1.5);
}

TEST_F(CurveMaskTest, whatLiesOutsideIsLeftOut) {
    mask.addBox(-2, 0.0, 10.0, 1.0);
    mask.addBox(Columns + 1, 0.0, 10.0, 1.0);
    mask.addBox(5, -1e5, -3.0, 1.0);
    mask.addBox(6, 60.0, 1e5, 1.0);
    mask.addLine({-100.0, -100.0}, {-50.0, -90.0}, 1.5);
    mask.addLine({70.0, 60.0}, {71.0, 1e5}, 1.5);
    mask.addDot({-20.0, 80.0}, 4.0);
    paint();
    EXPECT_EQ(ink(), 0.0);
    mask.addBox(9, -1e5, 1e5, 1.0);
    paint();
    EXPECT_EQ(ink(), static_cast<double>(Rows));
}

TEST_F(CurveMaskTest, aDotIsRound) {
    mask.addDot({30.0, 25.0}, 6.0);
    paint();
    EXPECT_NEAR(ink(), 3.14159 * 9.0, 2.0);
    EXPECT_EQ(at(27, 22), at(32, 27)); // symmetric about its centre
    EXPECT_EQ(at(26, 22), 0);
}

TEST_F(CurveMaskTest, nothingIsLeftOfTheCurveBefore) {
    mask.addBox(7, 10.5, 13.5, 1.0);
    mask.begin(Columns, Rows);
    mask.addBox(8, 1.5, 1.5, 1.0);
    paint();
    EXPECT_EQ(at(7, 12), 0);
    EXPECT_EQ(at(8, 1), 255);
}

TEST_F(CurveMaskTest, dashesLeaveColumnsOut) {
    for (int column = 0; column < Columns; ++column) {
        mask.addBox(column, 10.5, 10.5, 1.0);
    }
    mask.paint(image, Qt::white, [](int column) { return column % 2 == 0; });
    EXPECT_EQ(ink(), Columns / 2.0);
}

TEST_F(CurveMaskTest, fullCoverageIsTheColourItselfOnAnyGround) {
    image.fill(QColor(12, 34, 56));
    mask.addBox(3, 5.5, 8.5, 1.0);
    mask.paint(image, QColor(201, 117, 33), {});
    EXPECT_EQ(image.pixelColor(3, 7), QColor(201, 117, 33));
    EXPECT_EQ(image.pixelColor(4, 7), QColor(12, 34, 56));
}

} // namespace
} // namespace halbench::widgets
