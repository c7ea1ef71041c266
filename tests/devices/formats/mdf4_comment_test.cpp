#include "devices/formats/mdf4_comment.h"

#include <gtest/gtest.h>

namespace halbench::devices::mdf4 {
namespace {

constexpr const char* Hostile = "a<b>&\"c\" ]]> 'd' \xC3\xA4 \xE8\xBD\xB4";

TEST(Mdf4Comment, whatASidecarSaysComesBackWhateverTheTextsAre) {
    RecordingMeta meta;
    meta.device.model = "htm";
    meta.device.id = Hostile;
    meta.device.firmware = "epk-7";
    meta.device.isSimulated = true;
    meta.device.overrides = {{"c", "2e-3"}};
    meta.started = "2026-01-02T03:04:05Z";
    meta.software = "0.1.0";
    meta.period_s = 0.001;
    meta.parameters = {{"gain.kp", 0.1, "A/rad"}, {"limit.current", 1.0 / 3.0, "A"}};
    RecordingMeta back;
    ASSERT_TRUE(readHeaderComment(headerComment(meta), back));
    EXPECT_EQ(back.device.model, meta.device.model);
    EXPECT_EQ(back.device.id, meta.device.id);
    EXPECT_EQ(back.device.firmware, meta.device.firmware);
    EXPECT_TRUE(back.device.isSimulated);
    EXPECT_EQ(back.device.overrides, meta.device.overrides);
    EXPECT_EQ(back.started, meta.started);
    EXPECT_EQ(back.software, meta.software);
    EXPECT_EQ(back.period_s, meta.period_s);
    ASSERT_EQ(back.parameters.size(), 2U);
    EXPECT_EQ(back.parameters[1].name, "limit.current");
    EXPECT_EQ(back.parameters[1].value, 1.0 / 3.0) << "every digit";
    EXPECT_EQ(back.parameters[1].unit, "A");
}

TEST(Mdf4Comment, whatXmlCannotHoldIsReplaced) {
    RecordingMeta meta;
    meta.device.id = std::string("a\x01\x1B", 3);
    RecordingMeta back;
    ASSERT_TRUE(readHeaderComment(headerComment(meta), back));
    EXPECT_EQ(back.device.id, "a\xEF\xBF\xBD\xEF\xBF\xBD");
}

TEST(Mdf4Comment, channelsSayTheirRoleAndTheirName) {
    const auto note = readChannelComment(channelComment("position", "x"));
    ASSERT_TRUE(note);
    EXPECT_EQ(note->role, "position");
    EXPECT_EQ(note->signal, "x");
}

TEST(Mdf4Comment, anEventIsAChangeOnlyWhenItNamesAParameter) {
    const auto change = readEventComment(changeComment({1.0, "gain.kp", 0.25}));
    ASSERT_TRUE(change && *change);
    EXPECT_EQ((*change)->name, "gain.kp");
    EXPECT_EQ((*change)->value, 0.25);
    const auto other = readEventComment("<EVcomment><TX>note</TX></EVcomment>");
    ASSERT_TRUE(other);
    EXPECT_FALSE(*other);
}

TEST(Mdf4Comment, whatIsNoXmlOrDeclaresEntitiesIsRefused) {
    RecordingMeta meta;
    for (const char* xml :
         {"", "<HDcomment>", "<!DOCTYPE x [<!ENTITY a \"b\">]><HDcomment>&a;</HDcomment>"}) {
        const auto read = readHeaderComment(xml, meta);
        ASSERT_FALSE(read) << xml;
        EXPECT_EQ(read.error().code, ErrorCode::InvalidInput);
        EXPECT_EQ(read.error().message.substr(0, 6), "line 1");
    }
}

TEST(Mdf4Comment, theFilesHistoryNamesTheTool) {
    EXPECT_NE(historyComment().find("<tool_id>Halbench</tool_id>"), std::string::npos);
}

} // namespace
} // namespace halbench::devices::mdf4
