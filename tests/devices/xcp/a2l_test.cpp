#include "devices/xcp/a2l.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace halbench::devices::xcp {
namespace {

/// A module with this content. Subset: resources/help/protocol.md 3.13.
std::string module(const std::string& content) {
    return "ASAP2_VERSION 1 71 /begin PROJECT p \"text\" /begin MODULE m \"\" " + content +
           " /end MODULE /end PROJECT";
}

A2lDescription parsed(const std::string& content) {
    const auto description = parseA2l(module(content));
    EXPECT_TRUE(description) << description.error().message;
    return description.value_or(A2lDescription{});
}

TEST(A2l, readsWhatABoardSays) {
    const A2lDescription a2l = parsed(R"(
        /begin MOD_COMMON "" BYTE_ORDER MSB_FIRST /end MOD_COMMON
        /begin MOD_PAR "" EPK "1.2" ADDR_EPK 0x10
            /begin MEMORY_SEGMENT cal "" DATA RAM INTERN 0x10000 0x40 -1 -1 -1 -1 -1
                /begin IF_DATA XCP /begin SEGMENT 0 2 0 0 0
                    /begin PAGE 0 ECU_ACCESS_DONT_CARE XCP_READ_ACCESS_DONT_CARE XCP_WRITE_ACCESS_DONT_CARE /end PAGE
                    /begin PAGE 1 ECU_ACCESS_DONT_CARE XCP_READ_ACCESS_DONT_CARE XCP_WRITE_ACCESS_NOT_ALLOWED /end PAGE
                /end SEGMENT /end IF_DATA
            /end MEMORY_SEGMENT
        /end MOD_PAR
        /begin MEASUREMENT a.b "help" SWORD late 0 0 -10 10 ECU_ADDRESS 0x18 ECU_ADDRESS_EXTENSION 2
            BIT_MASK 0xFF /begin IF_DATA XCP /begin DAQ_EVENT FIXED_EVENT_LIST EVENT 0 EVENT 3 /end DAQ_EVENT
            /end IF_DATA /end MEASUREMENT
        /begin COMPU_METHOD late "" LINEAR "%.3" "rad" COEFFS_LINEAR 0.5 1 /end COMPU_METHOD
        /begin RECORD_LAYOUT f FNC_VALUES 1 FLOAT32_IEEE ROW_DIR DIRECT /end RECORD_LAYOUT
        /begin CHARACTERISTIC gain "" VALUE 0x10004 f 0 words 0 2 READ_ONLY /end CHARACTERISTIC
        /begin COMPU_METHOD words "" TAB_VERB "%d" "" COMPU_TAB_REF table /end COMPU_METHOD
        /begin COMPU_VTAB table "" TAB_VERB 2 0 "off" 1 "on" /end COMPU_VTAB
        /begin GROUP g "title" ROOT /begin REF_CHARACTERISTIC gain /end REF_CHARACTERISTIC /end GROUP
        /begin IF_DATA XCP
            /begin PROTOCOL_LAYER 0x0100 250 1000 0 0 0 0 0 255 508 BYTE_ORDER_MSB_LAST /end PROTOCOL_LAYER
            /begin DAQ DYNAMIC 0 2 0 OPTIMISATION_TYPE_DEFAULT
                /begin EVENT "fast" "fast" 0 DAQ 255 1 6 0 /end EVENT /end DAQ
        /end IF_DATA)");
    EXPECT_EQ(a2l.epk, "1.2");
    EXPECT_EQ(a2l.epkAddress, 0x10U);
    EXPECT_EQ(a2l.order, ByteOrder::BigEndian);
    EXPECT_DOUBLE_EQ(*a2l.answerTimeout_s, 0.25);
    ASSERT_EQ(a2l.measurements.size(), 1U);
    const A2lMeasurement& signal = a2l.measurements[0];
    EXPECT_EQ(signal.name, "a.b");
    EXPECT_EQ(signal.address, (Address{0x18, 2}));
    EXPECT_EQ(signal.type, DataType::SWord);
    EXPECT_EQ(signal.bitMask, 0xFFU);
    EXPECT_EQ(signal.events, (std::vector<std::uint16_t>{0, 3}));
    EXPECT_EQ(signal.conversion.unit, "rad");
    EXPECT_EQ(signal.conversion.toPhysical(4.0), 3.0) << "the conversion may come after its use";
    ASSERT_EQ(a2l.characteristics.size(), 1U);
    EXPECT_TRUE(a2l.characteristics[0].isReadOnly);
    EXPECT_EQ(a2l.characteristics[0].conversion.words.at(1), "on");
    ASSERT_EQ(a2l.segments.size(), 1U);
    EXPECT_TRUE(a2l.segments[0].contains({0x10004, 0}, 4));
    EXPECT_FALSE(a2l.segments[0].contains({0x1003E, 0}, 4));
    EXPECT_FALSE(a2l.segments[0].hasTwoWritablePages());
    ASSERT_EQ(a2l.events.size(), 1U);
    EXPECT_DOUBLE_EQ(a2l.events[0].cycle_s, 0.001);
    EXPECT_EQ(a2l.groups[0].members, std::vector<std::string>{"gain"});
    EXPECT_TRUE(a2l.warnings.empty());
}

TEST(A2l, rationalFunctionsThatAreStraightLinesAreTakenTheOthersLeftOut) {
    const auto withConversion = [](const std::string& coefficients) {
        return parsed("/begin MEASUREMENT x \"\" UWORD c 0 0 -1e9 1e9 ECU_ADDRESS 0 /end MEASUREMENT "
                      "/begin COMPU_METHOD c \"\" RAT_FUNC \"%f\" \"\" COEFFS " +
                      coefficients + " /end COMPU_METHOD");
    };
    // raw = (b x + c) / f: b = 2, c = 3, f = 4 -> phys = (4 raw - 3) / 2
    const A2lDescription line = withConversion("0 2 3 0 0 4");
    ASSERT_EQ(line.measurements.size(), 1U);
    EXPECT_DOUBLE_EQ(line.measurements[0].conversion.toPhysical(10.0), 18.5);
    for (const char* curve : {"1 2 3 0 0 4", "0 2 3 0 1 4", "0 0 3 0 0 4", "0 2 3 0 0 0"}) {
        const A2lDescription left = withConversion(curve);
        EXPECT_TRUE(left.measurements.empty()) << curve;
        ASSERT_EQ(left.warnings.size(), 1U);
        EXPECT_NE(left.warnings[0].find("'x'"), std::string::npos);
    }
}

TEST(A2l, limitsAreKeptInsideTheType) {
    const A2lDescription a2l = parsed("/begin MEASUREMENT x \"\" ULONG NO_COMPU_METHOD 0 0 0 4.29497e+09 "
                                      "ECU_ADDRESS 0 /end MEASUREMENT");
    EXPECT_EQ(a2l.measurements[0].upper, 4294967295.0);
}

TEST(A2l, commentsUnknownBlocksAndQuotesAreReadOver) {
    const A2lDescription a2l = parsed(R"(/* /begin X */ // "
        /begin A2ML block "x" { /begin Y "/end Y" /end Y } /end A2ML
        /include "XCP_104.aml" UNKNOWN_WORD 1 2 3
        /begin MEASUREMENT x "say ""hi"" and \"bye\"" UBYTE NO_COMPU_METHOD 0 0 0 255 ECU_ADDRESS 0 NEW_WORD 5
            /begin ANNOTATION /end ANNOTATION /end MEASUREMENT)");
    ASSERT_EQ(a2l.measurements.size(), 1U);
    EXPECT_EQ(a2l.measurements[0].help, "say \"hi\" and \"bye\"");
}

TEST(A2l, textsThatAreNotUtf8AreTakenAsLatin1) {
    const A2lDescription latin = parsed("/begin MEASUREMENT x \"gr\xFC\xDF\" UBYTE NO_COMPU_METHOD 0 0 0 255 "
                                        "PHYS_UNIT \"\xB0\x43\" /end MEASUREMENT");
    EXPECT_EQ(latin.measurements[0].help, "gr\u00FC\u00DF");
    EXPECT_EQ(latin.measurements[0].conversion.unit, "\u00B0C");
    const A2lDescription utf8 =
        parsed("/begin MEASUREMENT x \"gr\u00FC\u00DF\" UBYTE NO_COMPU_METHOD 0 0 0 255 /end MEASUREMENT");
    EXPECT_EQ(utf8.measurements[0].help, "gr\u00FC\u00DF");
}

TEST(A2l, arraysHaveTheirNumberOfElements) {
    const A2lDescription a2l =
        parsed("/begin RECORD_LAYOUT f FNC_VALUES 1 FLOAT32_IEEE ROW_DIR DIRECT /end RECORD_LAYOUT "
               "/begin CHARACTERISTIC data \"\" VAL_BLK 0 f 0 NO_COMPU_METHOD 0 1 MATRIX_DIM 4096 4 1 "
               "ECU_ADDRESS_EXTENSION 2 /end CHARACTERISTIC");
    ASSERT_EQ(a2l.characteristics.size(), 1U);
    EXPECT_EQ(a2l.characteristics[0].count, 16384U);
    EXPECT_EQ(a2l.characteristics[0].address.extension, 2);
}

struct Nonsense {
    std::string text;
    std::string what;
};

class A2lNonsense : public testing::TestWithParam<Nonsense> {};

TEST_P(A2lNonsense, isRefusedWithThePositionInOctets) {
    const auto description = parseA2l(GetParam().text);
    ASSERT_FALSE(description);
    EXPECT_EQ(description.error().code, ErrorCode::InvalidInput);
    EXPECT_NE(description.error().message.find(GetParam().what), std::string::npos)
        << description.error().message;
}

INSTANTIATE_TEST_SUITE_P(
    Texts, A2lNonsense,
    testing::Values(
        Nonsense{"", "no PROJECT"}, Nonsense{"hello world", "no PROJECT"},
        Nonsense{"/begin PROJECT", "byte 14: the project's name"},
        Nonsense{"/begin PROJECT p \"", "byte 17: a text does not end"},
        Nonsense{"/begin PROJECT p \"\" /begin MODULE m \"\" ", "byte 20: block MODULE does not end"},
        Nonsense{"/begin PROJECT p \"\" /end MODULE", "/end MODULE where /end PROJECT"},
        Nonsense{"/end PROJECT", "without its /begin"}, Nonsense{"/* ", "comment does not end"},
        Nonsense{"/begin /begin x", "name of a block"},
        Nonsense{module("/begin MEASUREMENT x \"\" UBYTE c zero 0 0 0 /end MEASUREMENT"),
                 "'zero' is not a number"},
        Nonsense{module("/begin MEASUREMENT x \"\" UBYTE c 0 0 0 0 ECU_ADDRESS -1 /end MEASUREMENT"),
                 "whole number"},
        Nonsense{module("/begin MEASUREMENT x \"\" UBYTE c 0 0 0 0 ECU_ADDRESS 0x1FFFFFFFF "
                        "/end MEASUREMENT"),
                 "whole number"},
        Nonsense{module("/begin MEASUREMENT x \"\" UBYTE c 0 0 0 0 MATRIX_DIM 60000 60000 "
                        "/end MEASUREMENT"),
                 "elements"},
        Nonsense{std::string(9 << 20, ' '), "bytes exceed"}, Nonsense{std::string(5000, 'w'), "too long"}));

TEST(A2l, nestingIsBounded) {
    std::string deep;
    std::string ends;
    for (int i = 0; i < 100000; ++i) {
        deep += "/begin X ";
        ends += "/end X ";
    }
    const auto description = parseA2l(module(deep + ends));
    ASSERT_FALSE(description);
    EXPECT_NE(description.error().message.find("nested deeper than 64"), std::string::npos);
}

TEST(A2l, halfAMillionBlocksAreReadInLinearTime) {
    // Half a million unknown blocks fill the 8 MiB; the time-out of the test is the check.
    std::string many;
    for (int i = 0; i < 500000; ++i) {
        many += "/begin X /end X ";
    }
    EXPECT_TRUE(parsed(many).measurements.empty());
    std::string signals;
    for (int i = 0; i < 70000; ++i) {
        signals +=
            fmt::format("/begin MEASUREMENT s{} \"\" UBYTE NO_COMPU_METHOD 0 0 0 1 /end MEASUREMENT ", i);
    }
    const auto tooMany = parseA2l(module(signals));
    ASSERT_FALSE(tooMany);
    EXPECT_NE(tooMany.error().message.find("too many"), std::string::npos);
}

} // namespace
} // namespace halbench::devices::xcp
