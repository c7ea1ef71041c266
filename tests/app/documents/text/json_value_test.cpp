#include "app/documents/text/json_value.h"
#include "app/documents/text/text_place.h"

#include <gtest/gtest.h>

#include <limits>

namespace halbench::app {
namespace {

TEST(JsonValue, keepsMembersInTheOrderTheyWereSet) {
    JsonValue value = JsonValue::object();
    value.set("z", 1).set("a", "text").set("list", JsonValue::array().push(0.1).push(nullptr).push(true));
    EXPECT_EQ(toJsonText(value).value(),
              "{\n  \"z\": 1,\n  \"a\": \"text\",\n  \"list\": [0.1, null, true]\n}\n");
    value.set("z", 2);
    EXPECT_EQ(value.members().front().value.number(), 2.0);
    EXPECT_EQ(value.members().size(), 3U);
}

TEST(JsonValue, numberThatIsNotFiniteIsAnErrorWithItsPlace) {
    JsonValue inner = JsonValue::object();
    inner.set("value", std::numeric_limits<double>::quiet_NaN());
    JsonValue value = JsonValue::object();
    value.set("margins", inner);
    const Result<std::string> text = toJsonText(value);
    ASSERT_FALSE(text.has_value());
    EXPECT_EQ(text.error().code, ErrorCode::Internal);
    EXPECT_NE(text.error().message.find("margins"), std::string::npos);
}

TEST(JsonValue, whatIsLegitimatelyUnboundedIsNull) {
    EXPECT_TRUE(finiteOrNull(std::numeric_limits<double>::infinity()).isNull());
    EXPECT_TRUE(finiteOrNull(std::optional<double>{}).isNull());
    EXPECT_EQ(finiteOrNull(2.5).number(), 2.5);
    EXPECT_TRUE(textOrNull("").isNull());
}

TEST(JsonValue, everyTextSurvives) {
    const std::string hard = "quote \" backslash \\ line\nend tab\t control \x01 \xC3\xA4 \xE2\x82\xAC /";
    JsonValue value = JsonValue::object();
    value.set("key \"1\"", hard);
    const Result<JsonValue> back = parseJson(toJsonText(value).value(), "x");
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->find("key \"1\"")->text(), hard);
}

TEST(JsonValue, numbersSurviveExactly) {
    for (const double number : {5.5e-4, 1.0 / 3.0, 1e-300, 1e300, 262144.0}) {
        JsonValue list = JsonValue::array();
        list.push(number);
        EXPECT_EQ(parseJson(toJsonText(list).value(), "x")->items().front().number(), number);
    }
}

TEST(JsonParser, namesFileLineAndColumnOfAMistake) {
    for (const char* wrong : {"", "{", "[1,]", "{\"a\": NaN}", "{\"a\" 1}", "{} x"}) {
        const Result<JsonValue> value = parseJson(wrong, "gains.json");
        ASSERT_FALSE(value.has_value()) << wrong;
        EXPECT_EQ(value.error().code, ErrorCode::InvalidInput);
        EXPECT_EQ(value.error().message.rfind("gains.json:", 0), 0U) << value.error().message;
    }
    EXPECT_EQ(parseJson("{\n  \"a\": ?\n}", "g").error().message.rfind("g:2:", 0), 0U);
}

TEST(JsonValue, findsMembersAndSurvivesAskingTheWrongKind) {
    const JsonValue value = parseJson("{\"a\": {\"b\": 3}}", "x").value();
    EXPECT_EQ(value.find("a")->find("b")->integer(), 3);
    EXPECT_EQ(value.find("c"), nullptr);
    EXPECT_EQ(JsonValue(3).find("a"), nullptr);
    EXPECT_FALSE(JsonValue(2.5).integer().has_value());
}

TEST(TextPlace, countsLinesAndColumnsFromOne) {
    const TextPlace place = placeOfOffset("ab\ncd", 4);
    EXPECT_EQ(place.line, 2);
    EXPECT_EQ(place.column, 2);
    EXPECT_EQ(placeOfOffset("ab", 99).column, 3); // behind the end: the end
}

} // namespace
} // namespace halbench::app
