#include "control/base/choice_words.h"

#include <gtest/gtest.h>

namespace halbench {
namespace {

TEST(ChoiceWords, areThoseBetweenTheBars) {
    EXPECT_EQ(choiceWords("windings|prism|published"),
              (std::vector<std::string>{"windings", "prism", "published"}));
    EXPECT_EQ(choiceWords("one"), std::vector<std::string>{"one"});
    EXPECT_TRUE(choiceWords("").empty());
    EXPECT_EQ(choiceWords("a||b"), (std::vector<std::string>{"a", "", "b"}));
    EXPECT_EQ(lastChoice("windings|prism|published"), 2.0);
    EXPECT_EQ(lastChoice("one"), 0.0);
}

} // namespace
} // namespace halbench
