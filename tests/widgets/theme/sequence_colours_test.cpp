#include "widgets/theme/sequence_colours.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::widgets {
namespace {

/// L* of CIE 1976, what an eye without colours sees.
double lightness(QRgb colour) {
    const auto linear = [](int part) {
        const double c = part / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double y =
        0.2126 * linear(qRed(colour)) + 0.7152 * linear(qGreen(colour)) + 0.0722 * linear(qBlue(colour));
    return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

TEST(SequenceColoursTest, lightnessRisesEvenlySoThatNoHueIsNeeded) {
    const SequenceColours colours(false);
    const auto at = [&](double value) { return lightness(colours.rgb({0.0, 1.0}, value)); };
    const double whole = at(1.0) - at(0.0);
    EXPECT_GT(whole, 70.0); // of 100
    for (int i = 0; i < 20; ++i) {
        const double step = at(0.05 * (i + 1)) - at(0.05 * i);
        EXPECT_NEAR(step, whole / 20.0, 0.5 * whole / 20.0) << i; // nowhere flat, nowhere an edge
    }
}

TEST(SequenceColoursTest, aDecadeIsAsWideEverywhereAndNoNumberIsTransparent) {
    const SequenceColours logarithmic(true);
    const SequenceColours linear(false);
    EXPECT_EQ(logarithmic.rgb({0.01, 100.0}, 1.0), linear.rgb({0.0, 4.0}, 2.0));
    EXPECT_EQ(logarithmic.rgb({0.01, 100.0}, 0.0), linear.rgb({0.0, 1.0}, 0.0)); // silence is the darkest
    EXPECT_EQ(logarithmic.rgb({0.01, 100.0}, 1e6), linear.rgb({0.0, 1.0}, 1.0));
    EXPECT_EQ(qAlpha(logarithmic.rgb({0.01, 100.0}, std::nan(""))), 0);
}

} // namespace
} // namespace halbench::widgets
