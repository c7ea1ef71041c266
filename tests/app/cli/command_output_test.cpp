#include "app/cli/command_output.h"
#include "app/headless/console.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <filesystem>

namespace halbench::app {
namespace {

struct Ended {
    CommandResult result = ExitCode::Done;
    std::string out;
};

Ended end(bool isJson, const std::string& file) {
    ConsoleStyle style;
    style.isJson = isJson;
    Console console(style);
    std::atomic<int> signal = 0;
    CommandContext context{{}, console, signal};
    const Error error{ErrorCode::FileSystem, "full/x.csv cannot be written", "make room"};
    testing::internal::CaptureStdout();
    Ended ended;
    ended.result = endWithResult(
        context, {JsonValue::object().set("schema", "halbench.frequency/1"), "the summary\n", file}, error);
    std::fflush(stdout);
    ended.out = testing::internal::GetCapturedStdout();
    return ended;
}

TEST(CommandOutput, anErrorOfWritingSaysWhichFile) {
    const auto folder = namingFile("a/x.csv", failure(ErrorCode::FileSystem, "no folder 'a'", "make it"));
    EXPECT_EQ(folder.error().message, "a/x.csv: no folder 'a'");
    const auto file =
        namingFile("a/x.csv", failure(ErrorCode::FileSystem, "a/x.csv: disk full", "make room"));
    EXPECT_EQ(file.error().message, "a/x.csv: disk full");
    EXPECT_TRUE(namingFile("a/x.csv", {}));
}

TEST(CommandOutput, asTextItIsPrintedAndTheErrorFollows) {
    const Ended ended = end(false, "");
    EXPECT_EQ(ended.out, "the summary\n");
    ASSERT_FALSE(ended.result);
    EXPECT_EQ(ended.result.error().message, "full/x.csv cannot be written");
}

/// One document on stdout and no other: the error's, which holds it.
TEST(CommandOutput, asJsonItIsInTheErrorsDocument) {
    const Ended ended = end(true, "");
    ASSERT_TRUE(ended.result);
    EXPECT_EQ(*ended.result, ExitCode::Usage);
    EXPECT_NE(ended.out.find("halbench.error/1"), std::string::npos) << ended.out;
    EXPECT_LT(ended.out.find("\"result\""), ended.out.find("halbench.frequency/1")) << ended.out;
    EXPECT_EQ(ended.out.find("the summary"), std::string::npos);
}

TEST(CommandOutput, inAFileItIsNotPrinted) {
    const std::string file = testing::TempDir() + "kept_result.json";
    const Ended ended = end(false, file);
    EXPECT_EQ(ended.out, "");
    ASSERT_FALSE(ended.result);
    EXPECT_NE(ended.result.error().message.find("the result is in " + file), std::string::npos);
    EXPECT_TRUE(std::filesystem::remove(file));
}

} // namespace
} // namespace halbench::app
