#include "devices/xcp/a2l_parser.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace halbench::devices::xcp {
namespace {

A2lDescription parsedModule(const std::string& content) {
    const std::string text =
        "/begin PROJECT p \"\" /begin MODULE m \"\" " + content + " /end MODULE /end PROJECT";
    const auto description = A2lParser(text).parse();
    EXPECT_TRUE(description) << description.error().message;
    return description.value_or(A2lDescription{});
}

std::string signal(const std::string& name, const std::string& more) {
    return fmt::format("/begin MEASUREMENT {} \"\" UBYTE {} 0 0 0 200 ECU_ADDRESS 1 /end MEASUREMENT ", name,
                       more);
}

TEST(A2lParser, ofTwoObjectsWithOneNameTheFirstCounts) {
    const auto a2l =
        parsedModule(signal("x", "NO_COMPU_METHOD") + "/begin MEASUREMENT x \"second\" UWORD "
                                                      "NO_COMPU_METHOD 0 0 0 1 /end MEASUREMENT");
    ASSERT_EQ(a2l.measurements.size(), 1U);
    EXPECT_EQ(a2l.measurements[0].type, DataType::UByte);
}

TEST(A2lParser, objectsWithoutTypeOrConversionAreLeftOutWithAWarning) {
    const auto a2l = parsedModule(
        signal("no_conversion", "missing") +
        "/begin CHARACTERISTIC no_layout \"\" VALUE 0 missing 0 NO_COMPU_METHOD 0 1 /end CHARACTERISTIC " +
        "/begin CHARACTERISTIC curve \"\" CURVE 0 f 0 NO_COMPU_METHOD 0 1 /end CHARACTERISTIC " +
        signal("good", "NO_COMPU_METHOD"));
    ASSERT_EQ(a2l.measurements.size(), 1U);
    EXPECT_EQ(a2l.measurements[0].name, "good");
    EXPECT_TRUE(a2l.characteristics.empty());
    ASSERT_EQ(a2l.warnings.size(), 2U);
    EXPECT_NE(a2l.warnings[0].find("'no_conversion'"), std::string::npos);
    EXPECT_NE(a2l.warnings[1].find("'no_layout'"), std::string::npos);
}

TEST(A2lParser, limitsTheWrongWayRoundAreTheTypesOwn) {
    const auto a2l =
        parsedModule("/begin MEASUREMENT x \"\" SBYTE NO_COMPU_METHOD 0 0 5 -5 /end MEASUREMENT");
    EXPECT_EQ(a2l.measurements[0].lower, -128.0);
    EXPECT_EQ(a2l.measurements[0].upper, 127.0);
    EXPECT_EQ(a2l.warnings.size(), 1U);
}

TEST(A2lParser, aFallingConversionKeepsLowerBelowUpper) {
    const auto a2l = parsedModule("/begin MEASUREMENT x \"\" UBYTE c 0 0 -1e9 1e9 /end MEASUREMENT "
                                  "/begin COMPU_METHOD c \"\" LINEAR \"%f\" \"V\" COEFFS_LINEAR -2 10 "
                                  "/end COMPU_METHOD");
    EXPECT_EQ(a2l.measurements[0].lower, 10.0 - 2.0 * 255.0);
    EXPECT_EQ(a2l.measurements[0].upper, 10.0);
}

TEST(A2lParser, interfacesOfOtherProtocolsAreSkipped) {
    const auto a2l =
        parsedModule("/begin IF_DATA CCP /begin DAQ /begin EVENT 1 2 3 /end EVENT /end DAQ /end IF_DATA "
                     "/begin IF_DATA XCPplus /begin DAQ DYNAMIC /begin EVENT \"e\" \"e\" 4 DAQ 1 10 6 0 "
                     "/end EVENT /end DAQ /begin XCP_ON_TCP_IP 1 5555 ADDRESS \"1.2.3.4\" "
                     "/end XCP_ON_TCP_IP /end IF_DATA");
    ASSERT_EQ(a2l.events.size(), 1U);
    EXPECT_EQ(a2l.events[0].number, 4);
    EXPECT_DOUBLE_EQ(a2l.events[0].cycle_s, 0.010);
}

} // namespace
} // namespace halbench::devices::xcp
