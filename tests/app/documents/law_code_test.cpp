#include "app/documents/law_code.h"
#include "control/law/filtered_delta.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>

namespace halbench::app {
namespace {

// That the code computes the law is shown by tests/conformance/program/check_law.py, which compiles it.

double constantOf(const std::string& code, const std::string& name) {
    const std::size_t place = code.find("double " + name + " = ");
    return place == std::string::npos ? std::nan("")
                                      : std::strtod(code.c_str() + code.find('=', place) + 1, nullptr);
}

TEST(LawCode, hasEveryNumberToItsLastBit) {
    control::PositionLaw law;
    law.gains.proportional = 40.0;
    law.gains.integral = 1.0 / 3.0;
    law.gains.derivative = 1e-9 / 7.0;
    LoopConditions conditions;
    conditions.currentLimit_A = 3.3;
    const std::string code = *lawCode(law, conditions, {});
    EXPECT_EQ(constantOf(code, "KP"), 40.0);
    EXPECT_NE(code.find("KP = 40.0;"), std::string::npos) << "a whole number is a double too";
    EXPECT_EQ(constantOf(code, "KI"), 1.0 / 3.0);
    EXPECT_EQ(constantOf(code, "KD"), 1e-9 / 7.0);
    EXPECT_EQ(constantOf(code, "LIMIT"), 3.3);
    EXPECT_EQ(constantOf(code, "TS"), conditions.timing.period_s);
}

TEST(LawCode, namesFromAFileStayInTheComment) {
    devices::DeviceInfo motor;
    motor.model = "htm */ int x; /*";
    motor.id = "1\n#include <x>";
    const std::string code = *lawCode({}, {}, {"by */ hand", motor});
    const std::string head = code.substr(0, code.find("static const"));
    EXPECT_EQ(head.find("*/"), head.rfind("*/")) << head;
    EXPECT_EQ(head.find("\n#"), std::string::npos) << head;
}

// The filters of the file are those that the loop was judged with, to the last bit.
TEST(LawCode, ofAFilteredLawHasItsWeightsAndTheSectionsOfItsFilters) {
    control::FilteredLaw filtered;
    filtered.gains.proportional = 12.0;
    filtered.gains.derivative = 0.8;
    filtered.gains.integral = 20.0;
    filtered.gains.filter_s = 0.004;
    filtered.proportionalWeight = 0.6;
    filtered.filters = {control::NotchFilter{180.0, 0.1, 0.5}, control::LowPassFilter{250.0, 1}};
    const LoopConditions conditions;
    const std::string code = *lawCode({{}, filtered}, conditions, {});
    EXPECT_EQ(constantOf(code, "KP"), 12.0);
    EXPECT_EQ(constantOf(code, "WEIGHT_B"), 0.6);
    EXPECT_EQ(constantOf(code, "WEIGHT_C"), 0.0);
    EXPECT_EQ(constantOf(code, "TF"), 0.004);
    const auto sections = control::filterSections(filtered.filters, conditions.timing.period_s);
    ASSERT_TRUE(sections);
    const std::string table = "FILTERS[SECTIONS][5] = {";
    const char* at = code.c_str() + code.find(table) + table.size();
    for (const control::LawSection<double>& section : *sections) {
        at = std::strchr(at, '{') + 1;
        char* end = nullptr;
        for (const double expected : {section.b0, section.b1, section.b2, section.a1, section.a2}) {
            EXPECT_EQ(std::strtod(at, &end), expected);
            at = end + 1;
        }
    }
    EXPECT_NE(code.find("notch: frequency_rad_s 180"), std::string::npos) << code;
    filtered.filters.clear();
    EXPECT_EQ((*lawCode({{}, filtered}, conditions, {})).find("FILTERS"), std::string::npos);
    filtered.proportionalWeight = 3.0;
    EXPECT_FALSE(lawCode({{}, filtered}, conditions, {}));
}

TEST(LawCode, withoutAPathNothingIsWritten) {
    EXPECT_TRUE(writeLaw("", {}, {}, {}));
    EXPECT_FALSE(writeLaw("/dev/null/law.c", {}, {}, {}));
}

} // namespace
} // namespace halbench::app
