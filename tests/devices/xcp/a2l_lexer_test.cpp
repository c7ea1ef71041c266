#include "devices/xcp/a2l_lexer.h"

#include <gtest/gtest.h>

namespace halbench::devices::xcp {
namespace {

std::vector<A2lToken> tokensOf(std::string_view text) {
    A2lLexer lexer(text);
    std::vector<A2lToken> tokens;
    while (!lexer.isAtEnd()) {
        tokens.push_back(lexer.take());
    }
    return tokens;
}

TEST(A2lLexer, cutsWordsTextsAndBlocksWithTheirPlaces) {
    const auto tokens = tokensOf("word /begin BLOCK a.b[0]/*c*/\"x \"\"y\"\"\"// z\n/end  BLOCK");
    ASSERT_EQ(tokens.size(), 5U);
    EXPECT_TRUE(tokens[0].isWord("word"));
    EXPECT_EQ(tokens[1].kind, A2lTokenKind::Begin);
    EXPECT_EQ(tokens[1].text, "BLOCK");
    EXPECT_EQ(tokens[1].place, 5U);
    EXPECT_TRUE(tokens[2].isWord("a.b[0]"));
    EXPECT_EQ(tokens[3].kind, A2lTokenKind::String);
    EXPECT_EQ(tokens[3].text, "x \"y\"");
    EXPECT_EQ(tokens[4].kind, A2lTokenKind::End);
}

TEST(A2lLexer, afterAnErrorOnlyTheEndComes) {
    A2lLexer lexer("one two three");
    lexer.take();
    lexer.fail(4, "no");
    lexer.fail(8, "later");
    EXPECT_TRUE(lexer.isAtEnd());
    EXPECT_EQ(lexer.takeWord("a word"), "");
    ASSERT_TRUE(lexer.error());
    EXPECT_NE(lexer.error()->message.find("byte 4: no"), std::string::npos) << "the first error stays";
}

TEST(A2lLexer, numbersAreDecimalHexadecimalOrFloating) {
    EXPECT_EQ(a2lNumber("12"), 12.0);
    EXPECT_EQ(a2lNumber("-1.5e3"), -1500.0);
    EXPECT_EQ(a2lNumber("+7"), 7.0);
    EXPECT_EQ(a2lNumber("0x1F"), 31.0);
    EXPECT_EQ(a2lNumber("0XfF"), 255.0);
    for (const char* wrong : {"", "-", "+-1", "0x", "0xG", "1.5x", "nan", "inf", "1e999", "--1", "0x-1"}) {
        EXPECT_FALSE(a2lNumber(wrong)) << wrong;
    }
}

TEST(A2lLexer, skippingABlockEndsBehindItsOwnEnd) {
    A2lLexer lexer("/begin A x /begin B /end B \"/end A\" /end A after");
    const A2lToken begin = lexer.take();
    lexer.skipBlock(begin);
    EXPECT_TRUE(lexer.peek().isWord("after"));
    A2lLexer crossed("/begin A /begin B /end A /end B");
    crossed.skipBlock(crossed.take());
    EXPECT_TRUE(crossed.error());
}

} // namespace
} // namespace halbench::devices::xcp
