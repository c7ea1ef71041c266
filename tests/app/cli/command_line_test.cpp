#include "app/cli/command_line.h"

#include <gmock/gmock.h>

#include <fstream>

namespace halbench::app {

TEST(CommandLineTest, globalFlagsStandBeforeOrAfterTheCommand) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"--json", "--seed", "7", "--arm", "convert", "in.csv", "out.csv"},
          std::vector<std::string>{"convert", "in.csv", "out.csv", "--json", "--arm", "--seed", "7"},
          std::vector<std::string>{"convert", "--seed=7", "in.csv", "--json", "out.csv", "--arm"}}) {
        const Result<CommandLine> line = parseCommandLine(arguments);
        ASSERT_TRUE(line) << line.error().message;
        EXPECT_EQ(line->command, "convert");
        EXPECT_EQ(line->outputs.recordings, (std::vector<std::string>{"out.csv"}));
        EXPECT_TRUE(line->global.style.isJson);
        EXPECT_TRUE(line->global.mayArm);
        EXPECT_EQ(line->global.seed, 7u);
    }
}

TEST(CommandLineTest, repeatedOptionsDoNotSwallowWhatFollows) {
    const Result<CommandLine> line =
        parseCommandLine({"convert", "--derive", "a = b", "in.csv", "--derive", "c = d", "out.csv"});
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_EQ(line->outputs.recordings, (std::vector<std::string>{"out.csv"}));
    EXPECT_TRUE(parseCommandLine({"identify", "--given", "J=1e-4", "--given", "phi=1e-2", "sim:htm"}));
}

TEST(CommandLineTest, anOverlayTakesAnyNumberOfRecordings) {
    const Result<CommandLine> line =
        parseCommandLine({"overlay", "a.csv", "b.csv", "c.csv", "--signals", "position", "--out", "all.csv"});
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_EQ(line->outputs.recordings, (std::vector<std::string>{"all.csv"}));
    EXPECT_FALSE(parseCommandLine({"overlay", "a.csv", "b.csv"}));
}

TEST(CommandLineTest, everyLineHasOptionsOfItsOwn) {
    const Result<CommandLine> first = parseCommandLine({"plot", "a.csv", "--out", "a.svg"});
    const Result<CommandLine> second = parseCommandLine({"plot", "b.csv", "--out", "b.svg"});
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->outputs.files, (std::vector<std::string>{"a.svg"}));
    EXPECT_EQ(second->outputs.files, (std::vector<std::string>{"b.svg"}));
}

TEST(CommandLineTest, aTitleNamesNoFile) {
    const std::string data = testing::TempDir() + "drawn.csv";
    const std::string picture = testing::TempDir() + "drawn.svg";
    for (const std::string& file : {data, picture}) { // the picture is there since an earlier run
        std::ofstream(file) << "time_s\n";
    }
    const Result<CommandLine> line =
        parseCommandLine({"plot", data, "--title", picture, "--out", picture, "--force"});
    ASSERT_TRUE(line) << line.error().message;
    EXPECT_EQ(line->outputs.inputs, (std::vector<std::string>{data}));
}

TEST(CommandLineTest, withoutArgumentsItIsHelp) {
    const Result<CommandLine> line = parseCommandLine({});
    ASSERT_TRUE(line);
    EXPECT_EQ(line->command, "help");
    for (const char* command :
         {"devices",  "describe", "get",        "set",     "record", "move",     "calibrate",
          "identify", "tune",     "analyse",    "run",     "serve",  "convert",  "spectrum",
          "plot",     "import",   "recordings", "overlay", "orient", "coverage", "place"}) {
        EXPECT_THAT(line->helpText, testing::HasSubstr(command));
    }
}

TEST(CommandLineTest, whatIsNoNameOfARecordingIsRefusedBeforeAnythingMoves) {
    using Words = std::vector<std::string>;
    for (const Words& begin : {Words{"record", "sim:htm", "--duration", "1", "--out"},
                               Words{"move", "sim:htm", "--duration", "1", "--reference", "step", "--out"},
                               Words{"identify", "sim:htm", "--record"}, Words{"import", "a.txt", "--out"},
                               Words{"overlay", "a.csv", "b.csv", "--signals", "speed", "--out"}}) {
        const auto given = [&](const std::string& name) {
            Words words = begin;
            words.push_back(name);
            return parseCommandLine(words);
        };
        EXPECT_TRUE(given("run.csv")) << begin.front();
        for (const char* name : {"run.mf4", "run.mat", "run", "run.CSV", "/dev/null"}) {
            const Result<CommandLine> line = given(name);
            ASSERT_FALSE(line) << begin.front() << ' ' << name;
            EXPECT_EQ(line.error().code, ErrorCode::Usage);
            EXPECT_THAT(line.error().message, testing::HasSubstr(name));
            EXPECT_THAT(line.error().message, testing::HasSubstr(begin.back()));
        }
    }
}

TEST(CommandLineTest, jsonIsKnownBeforeAnythingIsUnderstood) {
    EXPECT_TRUE(styleFromArguments({"nonsense", "--json"}).isJson);
    EXPECT_FALSE(parseCommandLine({"nonsense", "--json"}));
}

} // namespace halbench::app
