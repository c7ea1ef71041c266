#include "devices/formats/csv_columns.h"
#include "devices/formats/foreign_unit.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

using Texts = std::vector<std::string>;

Result<CsvColumns> arrange(const Texts& names, const CsvImportRequest& request = {},
                           const Texts& units = {}) {
    return arrangeColumns(names, units, names.size(), request);
}

TEST(ForeignUnit, isReadAsItsSiUnitWithOneRounding) {
    const auto inSi = [](std::string_view written, double value) {
        const std::optional<ForeignUnit> unit = readForeignUnit(written);
        return unit ? value * unit->factor / unit->divisor : -1.0;
    };
    EXPECT_EQ(inSi("mA", 3.0), 0.003)
        << "three divided by a thousand, rounded once, is the double next to 0.003";
    EXPECT_EQ(inSi("[us]", 7.0), 7e-6);
    EXPECT_EQ(inSi("(rpm)", 60.0), 60.0 * (3.14159265358979323846 / 30.0)); // 2 pi in the same two roundings
    EXPECT_EQ(inSi("rad/s", 0.1), 0.1);
    EXPECT_EQ(readForeignUnit("\xC2\xB0\x43")->symbol, "degC");
    EXPECT_EQ(readForeignUnit("deg")->symbol, "rad");
    EXPECT_EQ(readForeignUnit("-")->symbol, "");
    EXPECT_FALSE(readForeignUnit("C")) << "coulomb or Celsius";
    EXPECT_FALSE(readForeignUnit("furlong"));
}

TEST(ForeignUnit, whatRecordingsReadIsReadInTablesToo) {
    struct Case {
        const char* written;
        const char* symbol;
        double value;
        double inSi;
    };
    for (const Case& one :
         {Case{"min", "s", 2.0, 120.0}, Case{"mdeg", "rad", 180e3, 3.14159265358979323846},
          Case{"\xC2\xB5rad", "rad", 5.0, 5e-6}, Case{"\xC2\xB5\x41", "A", 7.0, 7e-6},
          Case{"G", "T", 1e4, 1.0}, Case{"degF", "degC", 212.0, 100.0}, Case{"mm", "m", 3.0, 0.003}}) {
        const std::optional<ForeignUnit> unit = readForeignUnit(one.written);
        ASSERT_TRUE(unit) << one.written;
        EXPECT_EQ(unit->symbol, one.symbol) << one.written;
        EXPECT_NEAR(one.value * unit->factor / unit->divisor + unit->offset, one.inSi, 1e-12 * one.inSi)
            << one.written; // a few roundings
    }
    EXPECT_FALSE(readForeignUnit("1/min")) << "of turns or of anything else";
}

TEST(CsvColumns, aTemperatureInKelvinIsConvertedAndTheLeastOfASpeedIsNoMinute) {
    const auto result =
        arrange({"t [min]", "coil_temperature_a_K", "coil_temperature.b [K]", "speed x (min)"});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->questions.empty());
    EXPECT_EQ(result->columns[0].inSi(2.0), 120.0);
    for (const std::size_t column : {1U, 2U}) {
        EXPECT_EQ(result->columns[column].unit, "degC");
        EXPECT_NEAR(result->columns[column].inSi(300.0), 26.85, 1e-12);
    }
    EXPECT_EQ(result->columns[3].unit, "");
    EXPECT_EQ(result->columns[3].inSi(5.0), 5.0);
}

TEST(CsvColumns, unitsStandInBracketsOrInTheirOwnRow) {
    const auto result = arrange({"t [s]", "omega (rpm)", "speed (filtered)", "x"}, {}, {"", "", "A", "mT"});
    ASSERT_TRUE(result) << result.error().message;
    ASSERT_EQ(result->time, 0U);
    EXPECT_EQ(result->columns[1].signal, "omega");
    EXPECT_EQ(result->columns[1].unit, "rad/s");
    EXPECT_EQ(result->columns[2].signal, "speed_filtered");
    EXPECT_EQ(result->columns[2].unit, "A");
    EXPECT_EQ(result->columns[3].unit, "T");
    EXPECT_EQ(result->columns[3].divisor, 1e3);
}

TEST(CsvColumns, aTemperatureInDegIsAskedFor) {
    for (const char* header :
         {"temp [deg]", "Motor temperature (deg)", "coil_temp [\xC2\xB0]", "Temperatur [deg]"}) {
        const auto asked = arrange({"time [s]", header});
        ASSERT_TRUE(asked) << asked.error().message;
        ASSERT_EQ(asked->questions.size(), 1U) << header;
        EXPECT_EQ(asked->questions[0].answers[0].unit.second, "degC");
    }
    CsvImportRequest request;
    request.units = {{"temp", "degC"}};
    const auto celsius = arrange({"time [s]", "temp [deg]"}, request);
    ASSERT_TRUE(celsius && celsius->questions.empty());
    EXPECT_EQ(celsius->columns[1].unit, "degC");
    request.units = {{"temp", "deg"}};
    const auto angle = arrange({"time [s]", "temp [deg]"}, request);
    ASSERT_TRUE(angle && angle->questions.empty());
    EXPECT_EQ(angle->columns[1].unit, "rad");
    EXPECT_TRUE(arrange({"time [s]", "template [deg]", "tempo2 [deg]"})->questions.empty());
}

TEST(CsvColumns, ourOwnHeadersAreUnderstood) {
    const auto result = arrange({"time_s", "position_rad", "hall_a_T", "phase_A"});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->questions.empty());
    EXPECT_EQ(result->columns[1].signal, "position");
    EXPECT_EQ(result->columns[1].unit, "rad");
    EXPECT_EQ(result->columns[2].signal, "hall.a");
    EXPECT_EQ(result->columns[3].signal, "phase_A");
    EXPECT_FALSE(result->columns[3].isUnitKnown) << "the A of a foreign name may be anything";
}

TEST(CsvColumns, aUnitBehindANameOfOursIsReadWhereItIsOneOfItsQuantity) {
    const auto result = arrange({"time_s", "position_deg", "speed_rpm", "current_command_mA", "hall_a_mT",
                                 "position_mA", "omega_rpm", "speed_filtered"});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->questions.empty());
    const auto expectIs = [&](std::size_t index, const char* signal, const char* unit) {
        EXPECT_EQ(result->columns[index].signal, signal);
        EXPECT_EQ(result->columns[index].unit, unit);
    };
    expectIs(1, "position", "rad");
    EXPECT_DOUBLE_EQ(result->columns[1].factor / result->columns[1].divisor, 3.14159265358979323846 / 180.0);
    expectIs(2, "speed", "rad/s");
    expectIs(3, "current_command", "A");
    EXPECT_EQ(result->columns[3].divisor, 1e3);
    expectIs(4, "hall.a", "T");
    expectIs(5, "position_mA", ""); // no angle: a name of its own, as are those of others
    expectIs(6, "omega_rpm", "");
    expectIs(7, "speed_filtered", "");
}

TEST(CsvColumns, aMappedSignalMustHaveItsQuantity) {
    CsvImportRequest request;
    request.map = {{"speed", "omega_mech"}};
    auto result = arrange({"t_s", "omega_mech"}, request);
    ASSERT_TRUE(result) << result.error().message;
    ASSERT_EQ(result->questions.size(), 1U);
    EXPECT_EQ(result->questions[0].about, "unit");
    EXPECT_EQ(result->questions[0].answers[1].option, "--unit 'omega_mech=rpm'");
    request.units = {{"omega_mech", "rpm"}};
    result = arrange({"t_s", "omega_mech"}, request);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_TRUE(result->questions.empty());
    EXPECT_EQ(result->columns[1].signal, "speed");
    EXPECT_EQ(result->columns[1].unit, "rad/s");
    request.units = {{"omega_mech", "mA"}};
    result = arrange({"t_s", "omega_mech"}, request);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(result.error().message, "column 'omega_mech' is in mA, but speed is in rad/s");
}

/// An answer that names two columns at once would be refused.
TEST(CsvColumns, columnsOfOneHeaderAreAskedForByTheirNumber) {
    const auto result = arrange({"t_s", "speed", "speed", "x", "x [V]"});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(columnWord(result->columns, 0), "t_s");
    EXPECT_EQ(columnWord(result->columns, 1), "2");
    EXPECT_EQ(columnWord(result->columns, 3), "4") << "x is the name of the next one too";
    EXPECT_EQ(columnWord(result->columns, 4), "x [V]");
    ASSERT_FALSE(result->questions.empty());
    EXPECT_EQ(result->questions[0].answers[0].option, "--unit '2=rad/s'");
}

TEST(CsvColumns, aNameThatBeginsWithADigitIsKeptBehindAWord) {
    const auto result = arrange({"t_s", "1x", "2nd harmonic"});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->columns[1].signal, "column_1x");
    EXPECT_EQ(result->columns[2].signal, "column_2nd_harmonic");
}

TEST(CsvColumns, namesAreMadeFitAndKeptApart) {
    const auto result = arrange({"t_s", "a b", "a-b", "", "a_b_2", "\xCF\x89", "position", "position_rad"},
                                {{}, "", {}, {}, {{"7", "deg"}}});
    ASSERT_TRUE(result) << result.error().message;
    Texts signals;
    for (const CsvColumn& column : result->columns) {
        signals.push_back(column.signal);
    }
    EXPECT_EQ(signals,
              (Texts{"", "a_b", "a_b_2", "column_4", "a_b_2_2", "column_6", "position", "position_rad"}));
}

TEST(CsvColumns, theTimeIsAskedForWhenItIsNotCertain) {
    for (const Texts& names :
         {Texts{"a", "b"}, Texts{"time", "t"}, Texts{"a", "delay [ms]"}, Texts{"", ""}}) {
        const auto result = arrange(names);
        ASSERT_TRUE(result) << result.error().message;
        ASSERT_EQ(result->questions.size(), 1U) << names[0];
        EXPECT_EQ(result->questions[0].about, "time");
    }
    const auto result = arrange({"time", "a"});
    ASSERT_TRUE(result);
    ASSERT_EQ(result->questions.size(), 1U);
    EXPECT_EQ(result->questions[0].about, "unit") << "seconds or milliseconds";
    EXPECT_FALSE(arrange({"zeit [ms]", "a"})->time != 0U);
    EXPECT_EQ(arrange({"x [ms]", "a"})->time, 0U) << "the first column, and it alone is a time";
}

TEST(CsvColumns, wrongAnswersAreRefusedWithTheColumns) {
    const auto codeOf = [](const CsvImportRequest& request) {
        const auto result = arrange({"t_s", "a [A]", "a [V]"}, request);
        return result ? ErrorCode::Internal : result.error().code;
    };
    EXPECT_EQ(codeOf({{}, "nothing", {}, {}, {}}), ErrorCode::UnknownName);
    EXPECT_EQ(codeOf({{}, "4", {}, {}, {}}), ErrorCode::UnknownName);
    EXPECT_EQ(codeOf({{}, "a", {}, {}, {}}), ErrorCode::Usage) << "two columns are called so";
    EXPECT_EQ(codeOf({{}, "a [A]", {}, {}, {}}), ErrorCode::InvalidInput) << "ampere is no time";
    EXPECT_EQ(codeOf({{}, "", {}, {{"x", "zzz"}}, {}}), ErrorCode::UnknownName);
    EXPECT_EQ(codeOf({{}, "", {}, {{"a b", "2"}}, {}}), ErrorCode::Usage) << "not a name";
    EXPECT_EQ(codeOf({{}, "", {}, {{"x", "2"}, {"y", "2"}}, {}}), ErrorCode::Usage);
    EXPECT_EQ(codeOf({{}, "", {}, {{"x", "1"}}, {}}), ErrorCode::Usage) << "the time is no signal";
    EXPECT_EQ(codeOf({{}, "", {}, {{"x", "2"}, {"x", "3"}}, {}}), ErrorCode::Usage);
    EXPECT_EQ(codeOf({{}, "", {}, {}, {{"2", "furlong"}}}), ErrorCode::UnknownName);
}

} // namespace
} // namespace halbench::devices
