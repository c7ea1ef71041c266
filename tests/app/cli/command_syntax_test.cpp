#include "app/cli/command_syntax.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::app {
namespace {

CommandOptions parsed(std::vector<std::string> words) {
    CLI::App app;
    CommandOptions options;
    addRecordingCommands(app, options);
    std::reverse(words.begin(), words.end()); // as CLI11 takes them
    app.parse(words);
    return options;
}

TEST(CommandSyntax, anOptionThatRepeatsTakesOneValueEachTime) {
    const CommandOptions options =
        parsed({"convert", "--derive", "a = b", "in.csv", "--derive", "c = d", "out.csv"});
    EXPECT_EQ(options.derived, (std::vector<std::string>{"a = b", "c = d"}));
    EXPECT_EQ(options.input, "in.csv");
    EXPECT_EQ(options.out, "out.csv");
}

TEST(CommandSyntax, anOverlayTakesAnyNumberOfRecordings) {
    const CommandOptions options =
        parsed({"overlay", "a.csv", "b.csv", "c.csv", "--signals", "position", "--out", "all.csv"});
    EXPECT_EQ(options.names, (std::vector<std::string>{"a.csv", "b.csv", "c.csv"}));
    EXPECT_EQ(options.signals, "position");
    EXPECT_THROW(parsed({"overlay", "a.csv", "b.csv"}), CLI::RequiredError);
}

} // namespace
} // namespace halbench::app
