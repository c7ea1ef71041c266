#include "app/batch/law_code.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

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
    const std::string code = lawCode(law, conditions, {});
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
    const std::string code = lawCode({}, {}, {"by */ hand", motor});
    const std::string head = code.substr(0, code.find("static const"));
    EXPECT_EQ(head.find("*/"), head.rfind("*/")) << head;
    EXPECT_EQ(head.find("\n#"), std::string::npos) << head;
}

TEST(LawCode, withoutAPathNothingIsWritten) {
    EXPECT_TRUE(writeLaw("", {}, {}, {}));
    EXPECT_FALSE(writeLaw("/dev/null/law.c", {}, {}, {}));
}

} // namespace
} // namespace halbench::app
