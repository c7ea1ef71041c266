#include "devices/firmware/xcp/hb_text.h"
#include "tests/devices/firmware/board_fixture.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <set>
#include <sstream>

namespace halbench::devices::firmware {
namespace {

std::uint32_t announcedLength(BoardFixture& f) {
    return BoardFixture::u32(f.command({0xFA, 4}), 4);
}

std::string upload(BoardFixture& f, std::uint32_t from, std::uint32_t count, std::uint8_t step) {
    std::string text;
    const Octets where = BoardFixture::le32(from);
    f.command({0xF6, 0, 0, 1, where[0], where[1], where[2], where[3]});
    while (count > 0) {
        const auto part = static_cast<std::uint8_t>(std::min<std::uint32_t>(step, count));
        const Octets answer = f.command({0xF5, part});
        if (answer.size() != part + 1U) {
            ADD_FAILURE() << "upload refused";
            return text;
        }
        text.append(answer.begin() + 1, answer.end());
        count -= part;
    }
    return text;
}

std::string wholeText(BoardFixture& f) {
    return upload(f, 0, announcedLength(f), 254);
}

TEST(XcpA2l, setsTheTransferAddressByItself) {
    BoardFixture f;
    f.connect();
    EXPECT_EQ(f.command({0xFA, 4})[1], 0);
    const Octets answer = f.command({0xF5, 13});
    EXPECT_EQ(std::string(answer.begin() + 1, answer.end()), "ASAP2_VERSION");
}

TEST(XcpA2l, isTheSameAtAnySplit) {
    BoardFixture f;
    f.connect();
    const std::string whole = wholeText(f);
    const auto length = static_cast<std::uint32_t>(whole.size());
    ASSERT_GT(length, 10000U);
    for (const std::uint8_t step : {std::uint8_t{1}, std::uint8_t{7}, std::uint8_t{31}, std::uint8_t{253}}) {
        EXPECT_EQ(upload(f, 0, length, step), whole) << int(step);
    }
    // Backwards, so that the renderer's cursor never helps.
    for (std::uint32_t from = length - length % 97; from >= 97; from -= 97) {
        const std::uint32_t count = std::min<std::uint32_t>(97, length - from);
        ASSERT_EQ(upload(f, from, count, 254), whole.substr(from, count)) << from;
    }
    EXPECT_EQ(f.read(length, 1, 1), refused(0x22));
}

TEST(XcpA2l, closesEveryBlockItOpens) {
    BoardFixture f;
    f.connect();
    const std::string text = wholeText(f);
    std::vector<std::string> open;
    std::size_t at = 0;
    while ((at = text.find_first_of("/\"", at)) != std::string::npos) {
        if (text[at] == '"') { // strings hold no quotes in our tables
            at = text.find('"', at + 1) + 1;
            continue;
        }
        const bool begins = text.compare(at, 7, "/begin ") == 0;
        const std::size_t name = at + (begins ? 7 : 5);
        const std::string word = text.substr(name, text.find_first_of(" \n", name) - name);
        if (begins) {
            open.push_back(word);
        } else {
            ASSERT_FALSE(open.empty());
            ASSERT_EQ(open.back(), word);
            open.pop_back();
        }
        at = name;
    }
    EXPECT_TRUE(open.empty());
}

/// The names every host relies on (resources/help/protocol.md 3.15, resources/devices/htm.json).
const std::string RequiredNames =
    "position speed reference current_command current.a current.b hall.a hall.b "
    "coil_temperature.a coil_temperature.b status fault torn_count reference.segment "
    "reference.running capture.state gain.kp gain.ki gain.kd feedforward.inertia "
    "feedforward.viscous feedforward.coulomb feedforward.coulomb_speed stiction.current "
    "stiction.threshold stiction.speed control.law limit.current limit.temperature "
    "window.position window.position_enabled window.speed window.speed_enabled stray.enabled "
    "stray.coefficient decode.method delay.samples commutation.divider commutation.advance "
    "hall.offset_a hall.offset_b hall.gain_ratio hall.quadrature hall.amplitude "
    "errormap.enabled errormap.cos1 errormap.sin6 set.first set.last hb.arm hb.mode "
    "hb.setpoint hb.watchdog_ms hb.stop reference.shape reference.amplitude reference.rate "
    "reference.frequency reference.frequency_end reference.period reference.count "
    "reference.duration reference.base reference.seed reference.start plateau.count "
    "plateau.current_1 plateau.current_32 plateau.dwell capture.signal_1 capture.signal_4 "
    "capture.trigger capture.trigger_signal capture.level capture.slope capture.pretrigger "
    "capture.prescaler capture.start capture.data";

TEST(XcpA2l, describesEverySignalAndParameterOnce) {
    BoardFixture f;
    f.connect();
    const std::string text = wholeText(f);
    std::set<std::string> names;
    for (const char* keyword : {"/begin MEASUREMENT ", "/begin CHARACTERISTIC "}) {
        for (std::size_t at = text.find(keyword); at != std::string::npos; at = text.find(keyword, at + 1)) {
            const std::size_t name = at + std::strlen(keyword);
            EXPECT_TRUE(names.insert(text.substr(name, text.find(' ', name) - name)).second);
        }
    }
    std::istringstream required(RequiredNames);
    for (std::string name; required >> name;) {
        EXPECT_TRUE(names.count(name)) << name;
    }
}

TEST(XcpA2l, givesAddressesUnitsAndWords) {
    BoardFixture f;
    f.connect();
    const std::string text = wholeText(f);
    EXPECT_NE(
        text.find(
            "/begin MEASUREMENT position \"Rotor angle, unwrapped\" SLONG CM.position 0 0 -51471 51471\n"
            "ECU_ADDRESS 0x0000\nPHYS_UNIT \"rad\"\n"),
        std::string::npos);
    EXPECT_NE(text.find("NO_COMPU_METHOD 0 4294967295\n"), std::string::npos); // marks: the whole type
    const std::size_t factor = text.find("COEFFS_LINEAR 2.3");
    ASSERT_NE(factor, std::string::npos);
    EXPECT_EQ(std::strtod(text.c_str() + factor + 14, nullptr), 2.0 * Pi / 262144.0)
        << "an angle that a host computes is the nearest double";
    EXPECT_NE(text.find("/begin CHARACTERISTIC gain.kp \"Proportional gain\" VALUE 0x10004 RL.FLOAT32_IEEE 0 "
                        "NO_COMPU_METHOD 0 2000\nPHYS_UNIT \"A/rad\"\n"),
              std::string::npos);
    EXPECT_NE(
        text.find(
            "COMPU_VTAB VT.hb.mode \"\" TAB_VERB 4 0 \"idle\" 1 \"current\" 2 \"position\" 3 \"d-axis\""),
        std::string::npos);
    EXPECT_NE(text.find("1 \"coil temperature above its limit\""), std::string::npos);
    EXPECT_NE(text.find("/begin EVENT \"fast\" \"fast\" 0 DAQ 8 1 6 0 /end EVENT"), std::string::npos);
    EXPECT_NE(text.find("ECU_ADDRESS_EXTENSION 2\nREAD_ONLY\nMATRIX_DIM 4096 4 1\n"), std::string::npos);
    const Octets epk = f.command({0xFA, 5});
    EXPECT_NE(text.find("EPK \"" + std::string(epk.begin() + 8, epk.end()) + '"'), std::string::npos);
}

TEST(XcpA2l, tellsTheLineItIsServedOnAndKeepsItsPacketsThatShort) {
    hb_htm_config config{};
    config.transport_a2l = "/begin XCP_ON_SxI 0x0100 115200 /end XCP_ON_SxI\n";
    config.max_dto = 40;
    BoardFixture f(&config);
    BoardFixture usual;
    const Octets session = f.command({0xFF, 0x00});
    usual.connect();
    EXPECT_EQ(session[4] | (session[5] << 8), 40);
    const std::string text = wholeText(f);
    EXPECT_NE(text.find(config.transport_a2l), std::string::npos);
    EXPECT_EQ(text.find("XCP_ON_TCP_IP"), std::string::npos);
    EXPECT_NE(text.find(" 255 40 BYTE_ORDER_MSB_LAST"), std::string::npos);
    EXPECT_NE(f.command({0xFA, 5}), usual.command({0xFA, 5})) << "another description, another EPK";
    f.command({0xD6});
    f.command({0xD5, 0, 1, 0});
    f.command({0xD4, 0, 0, 0, 1});
    f.command({0xD3, 0, 0, 0, 0, 20});
    f.command({0xE2, 0, 0, 0, 0, 0});
    const Octets entry{0xE1, 0xFF, 4, 0, 0, 0, 0, 0};
    for (int i = 0; i < (40 - 5) / 4; ++i) { // 5 octets of identification and time stamp
        ASSERT_EQ(f.command(entry), Accepted);
    }
    EXPECT_EQ(f.command(entry), refused(0x2A));
}

TEST(XcpA2l, doesNotDependOnTheLocale) {
    BoardFixture f;
    f.connect();
    const std::string text = wholeText(f);
    std::setlocale(LC_ALL, "de_DE.UTF-8"); // harmless where it is not installed
    EXPECT_EQ(wholeText(f), text);
    std::setlocale(LC_ALL, "C");
}

std::string formatted(float value) {
    char text[HB_NUMBER_CAPACITY];
    hb_format_float(value, text);
    return text;
}

TEST(NumberText, isWhatAPersonWouldWrite) {
    EXPECT_EQ(formatted(0.0F), "0");
    EXPECT_EQ(formatted(1.0F), "1");
    EXPECT_EQ(formatted(-1.5F), "-1.5");
    EXPECT_EQ(formatted(0.02F), "0.02");
    EXPECT_EQ(formatted(100.0F), "100");
    EXPECT_EQ(formatted(0.157F), "0.157");
    EXPECT_EQ(formatted(4294967296.0F), "4294967300"); // shortest that reads back as the same float
    EXPECT_EQ(formatted(1.0e6F), "1000000");
    EXPECT_EQ(formatted(1.0e-6F), "1e-06");
    EXPECT_EQ(formatted(3.4028235e38F), "3.4028235e+38");
    EXPECT_EQ(formatted(1.0e-45F), "1e-45"); // the smallest float is 1.4e-45: one digit is enough
}

TEST(NumberText, readsBackAsTheSameFloat) {
    std::uint32_t state = 12345;
    for (int i = 0; i < 200000; ++i) {
        state = state * 1664525U + 1013904223U;
        const std::uint32_t bits = (state >> 1) ^ (state << 17);
        float value;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value)) {
            continue;
        }
        const std::string text = formatted(value);
        ASSERT_EQ(std::strtof(text.c_str(), nullptr), value) << text;
        ASSERT_LT(text.size(), static_cast<std::size_t>(HB_NUMBER_CAPACITY));
    }
}

TEST(NumberText, readsBackPowersOfTwo) {
    for (int power = -126; power < 128; ++power) {
        const float value = std::ldexp(1.0F, power);
        ASSERT_EQ(std::strtof(formatted(value).c_str(), nullptr), value) << formatted(value);
    }
}

TEST(NumberText, writesWholeNumbersAndAddresses) {
    char text[HB_NUMBER_CAPACITY];
    hb_format_unsigned(0, text);
    EXPECT_STREQ(text, "0");
    hb_format_unsigned(4294967295U, text);
    EXPECT_STREQ(text, "4294967295");
    hb_format_hex(0x10004, 4, text);
    EXPECT_STREQ(text, "10004");
    hb_format_hex(0xAB, 8, text);
    EXPECT_STREQ(text, "000000AB");
}

} // namespace
} // namespace halbench::devices::firmware
