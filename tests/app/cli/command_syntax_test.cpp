#include "app/cli/command_syntax.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::app {
namespace {

/// One option of each kind, filled from words.
struct Words {
    std::string input, text;
    std::vector<std::string> repeated;
    std::string recording;
    bool isSet = false;
};

Words parsed(std::vector<std::string> words) {
    CLI::App app;
    Words options;
    CommandSyntax syntax(app);
    syntax.argument("IN", options.input, "Input");
    syntax.option("--text", options.text, "Text", "T", Presence::Required);
    syntax.repeatable("--again", options.repeated, "Several", "A");
    syntax.recording("--out", options.recording, "Recording");
    syntax.flag("--set", options.isSet, "Flag");
    std::reverse(words.begin(), words.end()); // as CLI11 takes them
    app.parse(words);
    return options;
}

TEST(CommandSyntax, fillsTheFieldOfEachOption) {
    const Words options = parsed({"in.csv", "--text", "7.5", "--set", "--out", "out.csv"});
    EXPECT_EQ(options.input, "in.csv");
    EXPECT_EQ(options.text, "7.5");
    EXPECT_EQ(options.recording, "out.csv");
    EXPECT_TRUE(options.isSet);
    EXPECT_TRUE(options.repeated.empty());
}

TEST(CommandSyntax, anOptionThatRepeatsTakesOneValueEachTime) {
    const Words options = parsed({"--again", "a", "in.csv", "--again", "b", "--text", "t"});
    EXPECT_EQ(options.repeated, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(options.input, "in.csv");
}

TEST(CommandSyntax, whatIsRequiredMustBeThere) {
    EXPECT_THROW(parsed({"in.csv"}), CLI::RequiredError);
    EXPECT_THROW(parsed({"--text", "t"}), CLI::RequiredError);
    EXPECT_THROW(parsed({"in.csv", "--text", "t", "--out", "run.mat"}), CLI::ValidationError);
}

} // namespace
} // namespace halbench::app
