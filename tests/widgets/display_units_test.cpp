#include "control/base/units.h"
#include "widgets/display_units.h"

#include <QLocale>

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::widgets {
namespace {

TEST(DisplayUnits, turnRadiansAboveAndBelowTheLine) {
    EXPECT_DOUBLE_EQ(displayUnit("rad", AngleUnit::Degree).factor, 180.0 / Pi);
    EXPECT_DOUBLE_EQ(displayUnit("rad/s^2/A", AngleUnit::Degree).factor, 180.0 / Pi);
    // resources/help/htm-theory.md section 10, 12: 10 A/deg = 572.958 A/rad
    EXPECT_NEAR(572.958 * displayUnit("A/rad", AngleUnit::Degree).factor, 10.0, 1e-5);
    EXPECT_DOUBLE_EQ(displayUnit("A/(rad*s)", AngleUnit::Degree).factor, Pi / 180.0);
    EXPECT_DOUBLE_EQ(displayUnit("A*s/rad", AngleUnit::Degree).factor, Pi / 180.0);
    EXPECT_EQ(displayUnit("A*s/rad", AngleUnit::Degree).text, QStringLiteral("A·s/deg"));
    EXPECT_EQ(displayUnit("N*m", AngleUnit::Degree).factor, 1.0);
    EXPECT_EQ(displayUnit("A/rad", AngleUnit::Radian).factor, 1.0);
}

TEST(DisplayUnits, numbersAreReadInTheUsersNotationAndTheProgrammers) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    EXPECT_EQ(parseNumber(QStringLiteral("1,5")), 1.5);
    EXPECT_EQ(parseNumber(QStringLiteral("1.5")), 1.5);
    EXPECT_EQ(parseNumber(QStringLiteral("−2,5 A"), QStringLiteral("A")), -2.5);
    EXPECT_EQ(numberText(1234.5), QStringLiteral("1234,5"));
    QLocale::setDefault(before);
}

TEST(DisplayUnits, whatIsNoFiniteNumberIsRefused) {
    for (const char* text : {"", "abc", "nan", "inf", "-inf", "1e999", "1 2", "0x10"}) {
        EXPECT_FALSE(parseNumber(QLatin1String(text)).has_value()) << text;
    }
}

TEST(DisplayUnits, valuesThatASinglePrecisionBoardCannotTellApartAreTheSame) {
    EXPECT_TRUE(areSameOnBoard(0.1, static_cast<double>(0.1F)));
    EXPECT_FALSE(areSameOnBoard(0.1, 0.10001));
    EXPECT_TRUE(areSameOnBoard(0.0, 0.0));
    EXPECT_FALSE(areSameOnBoard(0.0, 1e-30));
}

} // namespace
} // namespace halbench::widgets
