#include "widgets/interval_text.h"

#include <QLocale>

#include <gtest/gtest.h>

#include <limits>

namespace halbench::widgets {
namespace {

std::string said(double value, double low, double high, const char* unit = "") {
    return intervalText({value, std::make_pair(low, high), QString::fromUtf8(unit), 95}).toStdString();
}

TEST(IntervalText, theIntervalDecidesTheDigits) {
    EXPECT_EQ(said(2.0512e-3, 2.0512e-3 - 4.1e-5, 2.0512e-3 + 4.1e-5, "N·m·s/rad"),
              "2.05e-3 ± 0.04e-3\u00a0N·m·s/rad (95 %)");
    EXPECT_EQ(said(2.0512e-3, 2.0512e-3 - 2.1e-5, 2.0512e-3 + 2.1e-5), "2.051e-3 ± 0.021e-3 (95 %)");
    EXPECT_EQ(said(1.4336, 1.3336, 1.5336, "A"), "1.43 ± 0.10\u00a0A (95 %)");
    EXPECT_EQ(said(0.157, 0.1565, 0.1575, "T"), "0.1570 ± 0.0005\u00a0T (95 %)");
}

TEST(IntervalText, aWideIntervalLeavesFewDigits) {
    EXPECT_EQ(said(12.0, -38.0, 62.0), "10 ± 50 (95 %)"); // tens are the last place that is known
    EXPECT_EQ(said(1.0e-3, -4.0e-3, 6.0e-3), "1e-3 ± 5e-3 (95 %)");
}

TEST(IntervalText, sidesThatDifferAreBothSaid) {
    EXPECT_EQ(said(1.2, 0.9, 2.1, "A"), "1.2 (0.9 to 2.1)\u00a0A (95 %)");
}

TEST(IntervalText, withoutAnIntervalThereIsNoNumber) {
    EXPECT_EQ(intervalText({1.0, std::nullopt, QString(), 95}), QStringLiteral("not identified"));
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(said(1.0, 0.0, infinity), "not identified");
    EXPECT_EQ(said(std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0), "not identified");
}

TEST(IntervalText, anIntervalWithoutWidthIsNotDividedBy) {
    EXPECT_EQ(said(2.0, 2.0, 2.0), "2.000000 ± 0.000000 (95 %)");
    EXPECT_EQ(said(0.0, 0.0, 0.0).substr(0, 1), "0");
}

TEST(IntervalText, speaksTheUsersNotation) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    EXPECT_EQ(said(1.4336, 1.3336, 1.5336, "A"), "1,43 ± 0,10\u00a0A (95 %)");
    QLocale::setDefault(before);
}

} // namespace
} // namespace halbench::widgets
