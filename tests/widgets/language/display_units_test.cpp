#include "control/base/units.h"
#include "widgets/language/display_units.h"

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
    EXPECT_EQ(displayUnit("A*s/rad", AngleUnit::Degree).text, QStringLiteral("A·s/°"));
    EXPECT_EQ(displayUnit("N*m", AngleUnit::Degree).factor, 1.0);
    EXPECT_EQ(displayUnit("A/rad", AngleUnit::Radian).factor, 1.0);
}

TEST(DisplayUnits, numbersAreReadInTheUsersNotationAndTheProgrammers) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    EXPECT_EQ(parseNumber(QStringLiteral("1,5")), 1.5);
    EXPECT_EQ(parseNumber(QStringLiteral("1.5")), 1.5);
    EXPECT_EQ(parseNumber(QStringLiteral("−2,5 A"), QStringLiteral("A")), -2.5);
    EXPECT_EQ(numberText(1234.5, 7), QStringLiteral("1234,5"));
    QLocale::setDefault(before);
}

TEST(DisplayUnits, degreesAreReadAsASignAndAsAWord) {
    const QString unit = displayUnit("A/(rad*s)", AngleUnit::Degree).text;
    EXPECT_EQ(unit, QStringLiteral("A/(°·s)"));
    EXPECT_EQ(parseNumber(QStringLiteral("0.1 A/(°·s)"), unit), 0.1);
    EXPECT_EQ(parseNumber(QStringLiteral("0.1 A/(deg·s)"), unit), 0.1);
    EXPECT_EQ(parseNumber(QStringLiteral("0.1 A/(rad·s)"), unit), std::nullopt);
}

TEST(DisplayUnits, aSettingHasFiveDigitsAndNeverLosesWholeOnes) {
    EXPECT_EQ(settingText(0.17453292), QStringLiteral("0.17453"));
    EXPECT_EQ(settingText(-1.0404561), QStringLiteral("-1.0405"));
    EXPECT_EQ(settingText(115200.0), QStringLiteral("115200"));
    EXPECT_EQ(settingText(40.0), QStringLiteral("40"));
    EXPECT_EQ(settingText(0.0), QStringLiteral("0"));
    EXPECT_EQ(settingText(1e9), QStringLiteral("1e9"));
}

TEST(DisplayUnits, aNumberIsReadRightOrRefusedAndNeverOffByThousands) {
    struct Case {
        const char* text;
        std::optional<double> english, german, chinese;
    };
    const Case cases[] = {
        {"1,500", {}, 1.5, {}},    {"1.500", 1.5, {}, 1.5},    {"0,500", {}, 0.5, {}},
        {"0.500", 0.5, 0.5, 0.5},  {"0,5", {}, 0.5, {}},       {"1.5", 1.5, 1.5, 1.5},
        {"-1,500", {}, -1.5, {}},  {"-1.500", -1.5, {}, -1.5}, {"1,500.25", {}, {}, {}},
        {"1.500,25", {}, {}, {}},  {"1e-3", 1e-3, 1e-3, 1e-3}, {"1.6e-3", 1.6e-3, 1.6e-3, 1.6e-3},
        {"1,500,000", {}, {}, {}}, {"1.500.000", {}, {}, {}},  {"1500", 1500.0, 1500.0, 1500.0}};
    const QLocale before;
    const std::pair<QLocale, std::optional<double> Case::*> languages[] = {
        {QLocale(QLocale::English, QLocale::UnitedStates), &Case::english},
        {QLocale(QLocale::German, QLocale::Germany), &Case::german},
        {QLocale(QLocale::Chinese, QLocale::China), &Case::chinese}};
    for (const auto& [locale, expected] : languages) {
        QLocale::setDefault(locale);
        for (const Case& each : cases) {
            EXPECT_EQ(parseNumber(QLatin1String(each.text)), each.*expected)
                << each.text << " in " << locale.name().toStdString();
        }
    }
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
