#include "app/documents/text/names.h"
#include "app/headless/exit_code.h"
#include "devices/interruption.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

// resources/help/command-line.md, "Exit codes"
TEST(ExitCode, followsTheContract) {
    using Code = ErrorCode;
    for (const Code code : {Code::Usage, Code::UnknownName, Code::OutOfRange, Code::NotFinite,
                            Code::InvalidInput, Code::FileSystem, Code::ConsentMissing}) {
        EXPECT_EQ(static_cast<int>(exitCodeFor(code)), 2) << errorCodeName(code);
    }
    for (const Code code : {Code::DeviceLost, Code::Protocol, Code::DeviceRefused}) {
        EXPECT_EQ(static_cast<int>(exitCodeFor(code)), 3) << errorCodeName(code);
    }
    EXPECT_EQ(static_cast<int>(exitCodeFor(Code::Refused)), 1);
    EXPECT_EQ(static_cast<int>(exitCodeFor(Code::SafetyStop)), 4);
    EXPECT_EQ(static_cast<int>(exitCodeFor(Code::Internal)), 5);
    EXPECT_EQ(static_cast<int>(exitCodeFor(Code::Interrupted)), 130);
    EXPECT_EQ(static_cast<int>(exitCodeFor(Code::Terminated)), 143);
}

TEST(ExitCode, endBySignalIs128AndItsNumber) {
    for (const int signal : {SIGHUP, SIGINT, SIGQUIT, SIGTERM}) {
        const ErrorCode code = devices::codeOfSignal(signal);
        EXPECT_EQ(static_cast<int>(exitCodeFor(code, signal)), 128 + signal);
        EXPECT_EQ(static_cast<int>(exitCodeFor(ErrorCode::DeviceLost, signal)), 3) << "not restored";
    }
    EXPECT_EQ(exitCodeFor(ErrorCode::Interrupted, 0), ExitCode::Interrupted);
}

TEST(ErrorLine, isOneLineWhateverTheMessageHolds) {
    const std::string line = errorLine({ErrorCode::InvalidInput, "first\nsecond\r\n", "do\nthis"});
    EXPECT_EQ(line.find_first_of("\r\n"), std::string::npos);
    EXPECT_NE(line.find("second"), std::string::npos);
    EXPECT_NE(line.find("do this"), std::string::npos);
}

TEST(ErrorDocument, holdsCodeMessageHintAndExitCode) {
    const JsonValue document = errorDocument({ErrorCode::OutOfRange, "too much", "less"});
    EXPECT_EQ(document.find("schema")->text(), "halbench.error/1");
    EXPECT_EQ(document.find("code")->text(), "out_of_range");
    EXPECT_EQ(document.find("message")->text(), "too much");
    EXPECT_EQ(document.find("hint")->text(), "less");
    EXPECT_EQ(document.find("exit_code")->integer(), 2);
}

TEST(Names, nearestKnownWordIsOffered) {
    const std::vector<std::string> known = {"gain.kp", "gain.ki", "limit.current"};
    EXPECT_EQ(nearestName("limit.curent", known), "limit.current");
    EXPECT_EQ(nearestName("completely different", known), "");
}

TEST(Names, listsAreSplitAndTrimmed) {
    EXPECT_EQ(splitList("a, b,c"), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_TRUE(splitList("").empty());
}

} // namespace
} // namespace halbench::app
