#include "app/window/project/project_file.h"

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

Project sample() {
    Project project;
    project.device = "sim:htm?seed=7";
    project.notes = "first line\nwith \"quotes\" and µ";
    project.perspective = "tune";
    project.layouts = {{"monitor", "<xml/>"}, {"tune", ""}};
    project.models = {{"cold", "{\"schema\": \"halbench.identification/1\"}"}};
    project.designs = {{"recommended", "{}"}, {"slow", "{}"}};
    project.given = {{"J", 5.5e-4}, {"phi", 0.0143}};
    project.calibrations = {{"htm 1", "{\n  \"schema\": \"halbench.calibration/1\"\n}\n"}};
    project.monitor.plots = {{{"hall.a", "hall.b"}, widgets::ValueRange{-0.1, 1.0 / 3.0}, "mT"},
                             {{"speed"}, {}, {}, {}, {}, {}, widgets::OwnTime{2.5, true}},
                             {{"torque"}, {}, {}, {}, {}, {}, widgets::OwnTime{0.1, false}},
                             {{"position"}, {}, {}, {"speed"}, widgets::ValueRange{-2.0, 50.5}, "r/min"}};
    project.monitor.plots[3].column = 1;
    project.monitor.plots[3].units = {{"position", "mrad"}, {"speed", "r/min"}};
    project.monitor.plots[0].units = {{"hall.a", "uT"}};
    project.monitor.plots[0].height_ratio = 1.73;
    project.monitor.plots[3].width_ratio = 0.62;
    project.monitor.rate_Hz = 5000.0;
    MonitorView& further = project.furtherMonitors["monitor2"];
    further.plots = {{{"hall.a"}, {}, {}}, {{"speed"}, {}, {}}};
    further.plots[1].column = 1;
    further.plots[0].width_ratio = 1.4;
    further.plots[1].units = {{"speed", "deg/s"}};
    further.span_s = 4.0;
    project.monitor.isFollowing = false;
    project.monitor.span_s = 2.5;
    project.monitor.trigger = {
        true, "speed", control::TriggerMode::Single, control::TriggerSlope::Either, 1.25, 0.05, 0.4, 0.1,
        2.0,  true};
    project.monitor.cursors = {{"rise", 1.25, 2.0 / 3.0, false}, {"7 \u00b0", -1.0, 1e4, true}};
    project.monitor.areCursorsShown = true;
    project.monitor.looks = {{"speed", {19, {}}}, {"hall.a", {{}, "Rotor \u00b0"}}, {"x", {0, "X"}}};
    project.monitor.derived = {{"power", "current.a^2 + current.b^2", "A^2"}};
    project.recording = {2.5, true, 10.0};
    return project;
}

TEST(ProjectFile, comesBackAsItWasWritten) {
    const auto read = parseProject(projectText(sample()), "motor.toml");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, sample());
}

TEST(ProjectFile, equalProjectsAreEqualText) {
    const auto read = parseProject(projectText(sample()), "motor.toml");
    ASSERT_TRUE(read);
    EXPECT_EQ(projectText(*read), projectText(sample()));
}

TEST(ProjectFile, anArrangementAloneIsNoWork) {
    Project rearranged = sample();
    rearranged.layouts = {{"design", "<other/>"}};
    rearranged.perspective = "design";
    EXPECT_TRUE(isSameWork(rearranged, sample()));
    rearranged.notes += '.';
    EXPECT_FALSE(isSameWork(rearranged, sample()));
}

TEST(ProjectFile, textsComeBackWhateverIsInThem) {
    for (const char* text : {"\nfirst line empty", "ends in a break\n", "\"\"\"quotes\"\"\"",
                             "back\\slash \\n", "tab\tand\rreturn\r\n", "\x01 control", "'''"}) {
        Project project;
        project.notes = text;
        const auto read = parseProject(projectText(project), "motor.toml");
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->notes, text);
    }
}

TEST(ProjectFile, aPlotThatMakesNoSenseIsRefusedWithItsLine) {
    for (const char* lines : {"[[plot]]\nsignals = 7\n",
                              "[[plot]]\nmin = 1.0\n",
                              "[[plot]]\nmin = 1.0\nmax = 1.0\n",
                              "[[plot]]\nmin = nan\nmax = 1.0\n",
                              "[monitor]\nspan_s = 0.0\n",
                              "[monitor]\nfollow = 1\n",
                              "[monitor]\ntrigger = 1\n",
                              "[monitor.trigger]\nmode = \"always\"\n",
                              "[monitor.trigger]\nwindow_s = 0.0\n",
                              "[monitor.trigger]\non = 1\n",
                              "[monitor.trigger]\nedge = 1\n",
                              "plot = 3\n",
                              "derived = 3\n",
                              "[[derived]]\nname = \"x\"\n",
                              "[[plot]]\nown_span_s = 0.0\n",
                              "[[plot]]\nown_follow = true\n",
                              "[[plot]]\nown_span_s = \"1\"\n",
                              "[[plot]]\nown_span_s = 1.0\nown_follow = 3\n",
                              "[[plot]]\nright = 7\n",
                              "[[plot]]\nright_min = 1.0\n",
                              "[[derived]]\nformula = \"x\"\n",
                              "monitor = 3\n",
                              "monitor2 = 3\n",
                              "[monitor3]\nedge = 1\n",
                              "[monitor2]\nplot = 3\n",
                              "plot = [3]\n",
                              "recording = 1\n",
                              "[recording]\nbefore_s = 301\n",
                              "[recording]\nafter_s = -1.0\n",
                              "[recording]\nat_trigger = 1\n",
                              "[recording]\nname = \"x\"\n"}) {
        const auto read =
            parseProject(std::string("schema = \"halbench.project/1\"\n") + lines, "motor.toml");
        ASSERT_FALSE(read) << lines;
        EXPECT_NE(read.error().message.find("motor.toml:"), std::string::npos) << read.error().message;
    }
}

TEST(ProjectFile, twoDerivedSignalsOfOneNameAreRefusedWithTheSecondsLine) {
    const auto read = parseProject("schema = \"halbench.project/1\"\n"
                                   "[[derived]]\nname = \"x\"\nexpression = \"hall.a\"\n"
                                   "[[derived]]\nname = \"x\"\nexpression = \"hall.b\"\n",
                                   "motor.toml");
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.find("motor.toml:5:"), std::string::npos) << read.error().message;
    EXPECT_NE(read.error().message.find("'x'"), std::string::npos) << read.error().message;
}

/// Nothing is lost with the room of a plot, its unit or the rate: the work in the file is opened.
TEST(ProjectFile, aLayoutOfPlotsThatCannotBeIsAsUsualAndSaidWithItsLine) {
    for (const char* lines : {"[[plot]]\ncolumn = 0\n",
                              "[[plot]]\ncolumn = 1.5\n",
                              "[[plot]]\ncolumn = 1e9\n",
                              "[[plot]]\ncolumn = \"left\"\n",
                              "[[plot]]\nheight_percent = 0\n",
                              "[[plot]]\nheight_percent = -1\n",
                              "[[plot]]\nheight_percent = nan\n",
                              "[[plot]]\nheight_percent = 1e9\n",
                              "[[plot]]\nwidth_percent = 33.3\n",
                              "[[plot]]\nwidth_percent = [1]\n",
                              "[[plot]]\nunits = 3\n",
                              "[[plot]]\nunits = { x = 3 }\n",
                              "[[plot]]\nunits = { y = \"mrad\" }\n",
                              "[monitor]\nrate_hz = -1.0\n",
                              "[monitor]\ncurves = 3\n",
                              "[monitor.curves]\nx = { colour = 9 }\n",
                              "[monitor.curves]\nx = { line = \"wavy\" }\n",
                              "[monitor.curves]\nx = { width = 3 }\n",
                              "[monitor]\nrate_hz = \"fast\"\n",
                              "[monitor2]\nrate_hz = nan\n",
                              "[[monitor3.plot]]\ncolumn = -1\n"}) {
        const auto read = parseProject(
            std::string("schema = \"halbench.project/1\"\ndevice = \"sim:htm\"\n") + lines, "motor.toml");
        ASSERT_TRUE(read) << lines << read.error().message;
        EXPECT_EQ(read->device, "sim:htm");
        ASSERT_EQ(read->resets.size(), 1U) << lines;
        EXPECT_EQ(read->resets[0].find("motor.toml:4:"), 0U) << read->resets[0];
        const auto again = parseProject(projectText(*read), "motor.toml");
        ASSERT_TRUE(again);
        EXPECT_TRUE(again->resets.empty()) << lines << "what is written can be";
        EXPECT_TRUE(isSameWork(*again, *read)) << lines;
    }
}

TEST(ProjectFile, aUnitThatIsNoneIsNamedWithThoseThereAre) {
    const auto read = parseProject("schema = \"halbench.project/1\"\n[[plot]]\n"
                                   "units = { position = \"gon\", speed = \"r/min\" }\n"
                                   "signals = [\"position\", \"speed\"]\n",
                                   "motor.toml");
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->resets.size(), 1U);
    EXPECT_NE(read->resets[0].find("motor.toml:3:"), std::string::npos) << read->resets[0];
    EXPECT_NE(read->resets[0].find("'gon'"), std::string::npos) << read->resets[0];
    EXPECT_NE(read->resets[0].find("mrad"), std::string::npos) << "what can be written instead";
    EXPECT_EQ(read->monitor.plots.at(0).units.count("position"), 0U);
    EXPECT_EQ(read->monitor.plots.at(0).units.at("speed"), "r/min") << "the other one stays";
}

TEST(ProjectFile, equalSizesAreNotWritten) {
    Project project;
    project.monitor.plots = {{{"speed"}, {}, {}}, {{"hall.a"}, {}, {}}};
    EXPECT_EQ(projectText(project).find("_percent"), std::string::npos);
    project.monitor.plots[1].height_ratio = 0.33;
    EXPECT_NE(projectText(project).find("height_percent = 33\n"), std::string::npos) << projectText(project);
}

TEST(ProjectFile, pairsOfCursorsThatMakeNoSenseAreRefusedWithTheirLine) {
    const std::string good = "[[cursors]]\nname = \"x\"\na_s = 1.0\nb_s = 2\n";
    ASSERT_TRUE(parseProject("schema = \"halbench.project/1\"\n" + good, "motor.toml"));
    for (const std::string& lines :
         {std::string("cursors = 3\n"), std::string("cursors = [3]\n"),
          std::string("[[cursors]]\nname = \"x\"\na_s = 1.0\n"),
          std::string("[[cursors]]\na_s = 1.0\nb_s = 2.0\n"),
          std::string("[[cursors]]\nname = \"\"\na_s = 1.0\nb_s = 2.0\n"),
          std::string("[[cursors]]\nname = \"x\"\na_s = inf\nb_s = 2.0\n"), good + "measuring = 1\n",
          good + "colour = 1\n", good + good, std::string("[monitor]\ncursors = 1\n"),
          good + "measuring = true\n[[cursors]]\nname = \"y\"\na_s = 1.0\nb_s = 2.0\nmeasuring = true\n"}) {
        const auto read = parseProject("schema = \"halbench.project/1\"\n" + lines, "motor.toml");
        ASSERT_FALSE(read) << lines;
        EXPECT_NE(read.error().message.find("motor.toml:"), std::string::npos) << read.error().message;
        EXPECT_FALSE(read.error().hint.empty());
    }
    const auto twice = parseProject("schema = \"halbench.project/1\"\n" + good + good, "motor.toml");
    EXPECT_NE(twice.error().message.find("motor.toml:6:"), std::string::npos) << twice.error().message;
}

TEST(ProjectFile, anEmptyProjectIsAProject) {
    const auto read = parseProject(projectText({}), "motor.toml");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, Project());
}

TEST(ProjectFile, namesLineAndKeyOfAMistake) {
    const auto wrongType = parseProject("schema = \"halbench.project/1\"\ndevice = 7\n", "motor.toml");
    ASSERT_FALSE(wrongType);
    EXPECT_NE(wrongType.error().message.find("motor.toml:2:"), std::string::npos);
    EXPECT_NE(wrongType.error().message.find("device"), std::string::npos);
    const auto unknown = parseProject("schema = \"halbench.project/1\"\ncolour = \"red\"\n", "motor.toml");
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message.find("colour"), std::string::npos);
}

TEST(ProjectFile, aNewerVersionIsSaidToBeOne) {
    const auto read = parseProject("schema = \"halbench.project/2\"\n", "motor.toml");
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.find("newer"), std::string::npos);
}

TEST(ProjectFile, everyTruncationIsRefusedOrRead) {
    const std::string text = projectText(sample());
    for (std::size_t length = 0; length < text.size(); ++length) {
        const auto read = parseProject(text.substr(0, length), "motor.toml");
        if (!read) {
            EXPECT_EQ(read.error().code, ErrorCode::InvalidInput) << length;
            EXPECT_FALSE(read.error().hint.empty());
        }
    }
}

TEST(ProjectFile, aFolderThatCannotBeWrittenLeavesTheOldFile) {
    QTemporaryDir folder;
    const std::string path = folder.filePath("motor.toml").toStdString();
    ASSERT_TRUE(saveProject(sample(), path));
    const auto refused = saveProject({}, path + "/motor.toml"); // a file is no folder
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::FileSystem);
    const auto read = loadProject(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, sample());
}

TEST(ProjectFile, theAutosaveStandsBesideTheProject) {
    EXPECT_EQ(autosavePath("folder/motor.toml"), "folder/motor.toml.autosave");
}

} // namespace
} // namespace halbench::app
