#include "app/cli/command_line.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace halbench::app {
namespace {

class CommandOutputs : public testing::Test {
protected:
    std::string path(const std::string& name) const { return m_folder.filePath(name.c_str()).toStdString(); }
    std::string there(const std::string& name) const {
        std::ofstream(path(name)) << "x";
        return path(name);
    }
    static Result<void> check(const std::vector<std::string>& arguments) {
        const auto line = parseCommandLine(arguments);
        EXPECT_TRUE(line) << line.error().message;
        return checkOutputs(line->outputs, line->global.mayOverwrite);
    }

private:
    QTemporaryDir m_folder;
};

TEST_F(CommandOutputs, aFileThatIsThereIsNotOverwritten) {
    const std::string file = there("old.csv");
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"record", "sim:htm", "--duration", "1", "--out", file},
          {"identify", "sim:htm", "--record", file},
          {"identify", "sim:htm", "--out", file},
          {"calibrate", "sim:htm", "hall", "--out", file},
          {"tune", "m.json", "--out", file},
          {"tune", "m.json", "--code", file},
          {"tune", "m.json", "--picture", "bode=" + file},
          {"analyse", "m.json", "g.json", "--bode", file},
          {"analyse", "m.json", "g.json", "--step", file},
          {"analyse", "m.json", "g.json", "--poles", file},
          {"convert", "in.csv", file},
          {"spectrum", "in.csv", "--signal", "a", "--out", file},
          {"plot", "in.csv", "--out", file},
          {"import", "in.txt", "--out", file},
          {"overlay", "a.csv", "b.csv", "--signals", "x", "--out", file},
          {"config", "save", "sim:htm", file}}) {
        const auto checked = check(arguments);
        ASSERT_FALSE(checked) << arguments[0] << ' ' << arguments[2];
        EXPECT_EQ(checked.error().code, ErrorCode::Usage);
        EXPECT_NE(checked.error().message.find(file), std::string::npos);
        std::vector<std::string> forced = arguments;
        forced.emplace_back("--force");
        EXPECT_TRUE(check(forced)) << arguments[0];
    }
}

TEST_F(CommandOutputs, tableOfAReferenceIsAnInput) {
    const std::string table = there("poses.csv");
    for (const std::string& reference :
         {"table,file=" + table, "table,file=" + table + ",rate_mm_s=5", "table,rate_mm_s=5,file=" + table}) {
        const auto checked =
            check({"move", "sim:planar", "--reference", reference, "--out", table, "--force"});
        ASSERT_FALSE(checked) << reference;
        EXPECT_NE(checked.error().message.find("would overwrite"), std::string::npos);
        EXPECT_TRUE(check({"move", "sim:planar", "--reference", reference, "--out", path("other.csv")}));
    }
}

TEST_F(CommandOutputs, whatIsReadMayBeThere) {
    const std::string file = there("old.toml");
    EXPECT_TRUE(check({"config", "compare", "sim:htm", file}));
    EXPECT_TRUE(check({"analyse", there("m.json"), there("g.json")}));
    EXPECT_TRUE(check({"record", "sim:htm", "--duration", "1", "--out", path("new.csv")}));
    EXPECT_TRUE(check({"identify", "sim:htm", "--out", "/dev/null"}));
}

// The result would take the place of what it is made of: --force consents to the loss of an older result
// only.
TEST_F(CommandOutputs, anInputIsNeverOverwrittenEvenWithForce) {
    const std::string model = there("m.json");
    const std::string gains = there("g.json");
    const std::string motion = there("run.csv");
    const std::string sidecar = there("run.meta.json");
    const std::string board = there("board.a2l");
    std::filesystem::create_hard_link(model, path("hard.json"));
    std::filesystem::create_symlink(model, path("soft.json"));
    const std::string detour = path("../" + std::filesystem::path(model).parent_path().filename().string());
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"tune", model, "--out", model},
          {"tune", model, "--out", path("hard.json")},
          {"tune", model, "--out", path("soft.json")},
          {"tune", model, "--out", detour + "/m.json"},
          {"tune", model, "--code", model},
          {"tune", model, "--picture", "bode=" + model},
          {"tune", model, "--gains", gains, "--out", gains},
          {"tune", model, "--relay", gains, "--out", gains},
          {"analyse", model, gains, "--bode", gains},
          {"analyse", model, gains, "--compare", path("hard.json"), "--step", path("hard.json")},
          {"analyse", model, gains, "--what-if", motion, "--motion", motion},
          {"analyse", model, gains, "--what-if", motion, "--motion", sidecar},
          {"identify", motion, "--out", motion},
          {"identify", motion, "--out", sidecar},
          {"identify", "replay:" + motion, "--record", motion},
          {"identify", "sim:htm", "--bare", model, "--added-inertia", "1e-4", "--out", model},
          {"identify", "tcp:localhost:5555?a2l=" + board, "--out", board},
          {"calibrate", motion, "hall", "--out", motion},
          {"convert", motion, motion},
          {"spectrum", motion, "--signal", "a", "--out", motion},
          {"plot", motion, "--out", motion},
          {"plot", motion, "--out", sidecar},
          {"import", motion, "--out", motion},
          {"overlay", there("other.csv"), motion, "--signals", "x", "--out", motion},
          {"orient", motion, "--out", motion},
          {"record", "replay:" + motion, "--duration", "1", "--out", motion},
          {"record", "replay:" + there("run?.csv"), "--duration", "1", "--out", path("run?.csv")},
          {"identify", "tcp:localhost:5555?a2l=" + path("a%26b.a2l"), "--out", there("a&b.a2l")},
          {"move", "replay:" + motion, "--reference", "step,amplitude_deg=1", "--duration", "1", "--out",
           motion}}) {
        for (const bool isForced : {false, true}) {
            std::vector<std::string> asked = arguments;
            asked.insert(asked.end(), isForced ? 1 : 0, "--force");
            const auto checked = check(asked);
            ASSERT_FALSE(checked) << arguments[0] << ' ' << arguments.back();
            EXPECT_EQ(checked.error().code, ErrorCode::Usage);
            EXPECT_NE(checked.error().message.find("would overwrite"), std::string::npos) << arguments[0];
        }
    }
    EXPECT_TRUE(check({"tune", model, "--gains", gains, "--out", there("old.json"), "--force"}));
    EXPECT_TRUE(check({"convert", motion, path("run.mf4")}));
    EXPECT_TRUE(check({"identify", "sim:htm", "--out", there("old.json"), "--force"}));
}

// The new name is written as NAME.partial first.
TEST_F(CommandOutputs, anInputIsNotTheWorkingFileOfAResult) {
    const std::string partial = there("m.json.partial");
    EXPECT_FALSE(check({"tune", partial, "--out", path("m.json")}));
    EXPECT_FALSE(check({"tune", partial, "--out", path("m.json"), "--force"}));
    EXPECT_TRUE(check({"tune", partial, "--out", path("gains.json")}));
    EXPECT_TRUE(check({"convert", there("run.csv.partial"), path("run.csv")})); // recovers it
}

// A run writes result.json and a recording for each step, under names that its steps choose.
TEST_F(CommandOutputs, aRunDoesNotWriteIntoTheFolderThatItReadsFrom) {
    std::filesystem::create_directory(path("run"));
    const std::string motion = there("run/step.csv");
    for (const char* folder : {"run", "./run", "run/../run"}) {
        const auto checked =
            check({"run", "e.toml", "--device", "replay:" + motion, "--out", path(folder), "--force"});
        ASSERT_FALSE(checked) << folder;
        EXPECT_NE(checked.error().message.find(motion), std::string::npos);
    }
    EXPECT_TRUE(check({"run", there("run/e.toml"), "--out", path("run"), "--force"}));
    EXPECT_TRUE(check({"run", "e.toml", "--device", "replay:" + motion, "--out", path("new")}));
}

TEST_F(CommandOutputs, aSidecarThatIsThereIsKept) {
    there("old.meta.json");
    EXPECT_FALSE(check({"record", "sim:htm", "--duration", "1", "--out", path("old.csv")}));
    EXPECT_TRUE(check({"record", "sim:htm", "--duration", "1", "--out", path("old.csv"), "--force"}));
}

TEST_F(CommandOutputs, twoResultsOfOneCommandNeverShareAFile) {
    const std::string file = path("both.csv");
    const std::string sameFile = path("./both.csv");
    std::filesystem::create_symlink(there("target.svg"), path("link.svg"));
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"identify", "sim:htm", "--record", file, "--out", file},
          {"identify", "sim:htm", "--record", file, "--out", path("both.meta.json")},
          {"identify", "sim:htm", "--frequency", "--bode", file, "--out", sameFile},
          {"analyse", "m.json", "g.json", "--bode", file, "--step", sameFile},
          {"analyse", "m.json", "g.json", "--step", file, "--poles", file},
          {"tune", "m.json", "--out", file, "--code", file},
          {"tune", "m.json", "--picture", "bode=" + path("target.svg"), "--picture",
           "step=" + path("link.svg")}}) {
        for (const bool isForced : {false, true}) {
            std::vector<std::string> asked = arguments;
            asked.insert(asked.end(), isForced ? 1 : 0, "--force");
            const auto checked = check(asked);
            ASSERT_FALSE(checked) << arguments[0] << ' ' << arguments.back();
            EXPECT_EQ(checked.error().code, ErrorCode::Usage);
            EXPECT_NE(checked.error().message.find("two results"), std::string::npos);
        }
    }
    EXPECT_TRUE(check({"analyse", "m.json", "g.json", "--bode", file, "--step", path("other.csv")}));
    EXPECT_TRUE(check({"analyse", "m.json", "g.json", "--bode", "/dev/null", "--step", "/dev/null"}));
}

TEST_F(CommandOutputs, aFolderWithResultsNeedsForceAndAnyOtherIsRefused) {
    std::filesystem::create_directory(path("run"));
    EXPECT_TRUE(check({"run", "e.toml", "--out", path("run")}));
    EXPECT_TRUE(check({"run", "e.toml", "--out", path("new")}));
    there("run/result.json");
    there("run/step.csv");
    EXPECT_FALSE(check({"run", "e.toml", "--out", path("run")}));
    EXPECT_TRUE(check({"run", "e.toml", "--out", path("run"), "--force"}));
    EXPECT_TRUE(check({"run", "e.toml", "--out", path("run"), "--dry-run"}));
    there("run/thesis.docx");
    EXPECT_FALSE(check({"run", "e.toml", "--out", path("run"), "--force"}));
}

} // namespace
} // namespace halbench::app
