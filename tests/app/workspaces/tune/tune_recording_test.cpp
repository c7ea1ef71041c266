// What if, of any recording: in the Tune panel as `analyse --what-if` answers it.
#include "app/documents/result_documents.h"
#include "app/documents/text/output_file.h"
#include "app/headless/recording_file.h"
#include "app/tuning/loop_conditions.h"
#include "app/tuning/what_if_report.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/what_if_page.h"
#include "tests/app/procedures/simulated_motor.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

#include <QFile>

namespace halbench::app {
namespace {

class TuneRecordingTest : public TunePanelTest {
protected:
    void SetUp() override {
        TunePanelTest::SetUp();
        panel.setFileChooser({[this](QWidget*, const FileQuestion&) { return gainsPath(); },
                              [this](QWidget*, const FileQuestion& question) {
                                  asked << question.title;
                                  return question.filter.contains("json") ? gainsPath() : chosen;
                              }});
    }

    /// A step of half a radian with the published gains, as `move --out` writes it.
    QString recorded(const char* name, const char* query = "seed=3", double duration_s = 1.5) const {
        const auto device = openMotor(query);
        const MoveResult result = moved(*device, move("step,amplitude_deg=28.6479", duration_s));
        const QString path = m_folder.filePath(name);
        EXPECT_TRUE(
            writeRecording(path.toStdString(), result.recording, *device, {"1970-01-01T00:00:00Z", {}, {}}));
        return path;
    }
    QString withoutSidecar(const QString& path) const {
        EXPECT_TRUE(QFile::remove(QString(path).replace(".csv", ".meta.json")));
        return path;
    }
    void open(const QString& path) {
        chosen = path;
        click(panel, "What-if");
        click(panel,
              panel.findChild<WhatIfPage*>()->isUsed() ? "Another move\u2026" : "Open a recorded move");
    }
    /// The page as it is; its picture has the recorded motion under this name.
    std::vector<double> drawn(const std::string& label) const {
        const auto& panels = panel.findChild<WhatIfPage*>()->picture().figure().panels;
        for (const widgets::Curve& each : panels.empty() ? std::vector<widgets::Curve>{} : panels[0].curves) {
            if (each.label == label) {
                return each.y;
            }
        }
        return {};
    }
    QString said() const { return panel.findChild<widgets::VerdictView*>("whatIf")->text(); }

    QString chosen;
    QStringList asked;
};

TEST_F(TuneRecordingTest, aRecordingIsShownWithWhatTheProposedGainsWouldHaveMadeOfIt) {
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    open(recorded("move.csv"));
    ASSERT_TRUE(wait([&] { return !drawn("90 % band").empty(); })) << said().toStdString();
    EXPECT_TRUE(panel.findChild<WhatIfPage*>()->isVisible());
    EXPECT_TRUE(said().contains("move.csv: the identified model matches")) << said().toStdString();
    EXPECT_TRUE(said().contains("With the proposed gains: overshoot")) << said().toStdString();
    // Second route: what the command line computes of the same file, motor and gains.
    const auto ran = readRanMove(chosen.toStdString(), {}, *loopConditionsOf("htm"));
    ASSERT_TRUE(ran);
    const auto report = reportWhatIf(*ran, motorEstimate(publishedMotor()), bench.design()->law,
                                     {TuneConfig().draws, TuneConfig().seed});
    ASSERT_TRUE(report && report->predicted);
    EXPECT_EQ(drawn("recorded"), ran->move.position_rad);
    EXPECT_EQ(drawn("with the proposed gains"), report->predicted->angle_rad);
}

TEST_F(TuneRecordingTest, theCurveFollowsTheGainsAndTheGainsThatRanHaveTheRecordingItself) {
    bench.setIdentification(publishedMotor());
    open(recorded("move.csv"));
    ASSERT_TRUE(wait([&] { return !drawn("with the proposed gains").empty(); }));
    const auto before = drawn("with the proposed gains");
    type("gain.kp", "25");
    ASSERT_TRUE(wait([&] {
        const auto now = drawn("with the proposed gains");
        return !now.empty() && now != before;
    }));
    choose("Source of the gains", "Preset: published");
    EXPECT_TRUE(wait([&] { return said().contains("equal the recorded gains"); })) << said().toStdString();
    EXPECT_TRUE(drawn("with the proposed gains").empty());
    type("gain.kp", "400");
    EXPECT_TRUE(wait([&] { return said().contains("no prediction"); })) << said().toStdString();
    EXPECT_TRUE(drawn("with the proposed gains").empty()) << "unstable";
}

// The words of the command line, in place of the prediction.
TEST_F(TuneRecordingTest, aRecordOfAnotherMotorIsWithheldWithTheReason) {
    bench.setIdentification(publishedMotor());
    open(recorded("other.csv", "seed=3&J=1.65e-3"));
    ASSERT_TRUE(wait([&] { return said().contains("no prediction"); })) << said().toStdString();
    EXPECT_TRUE(said().contains("does not match the recorded move")) << said().toStdString();
    EXPECT_TRUE(drawn("with the proposed gains").empty());
    EXPECT_FALSE(drawn("recorded").empty());
    // Another identification is another judgement of the same recording.
    auto heavy = publishedMotor();
    heavy.inertia.value = 3.0 * *heavy.inertia.value;
    for (const char* ratio : {"c_over_J", "phi_over_J"}) {
        heavy.ratios[ratio].value = *heavy.ratios[ratio].value / 3.0;
    }
    bench.setIdentification(heavy);
    EXPECT_TRUE(wait([&] { return !said().contains("does not match"); })) << said().toStdString();
}

TEST_F(TuneRecordingTest, whatIsNoMoveIsRefusedInPlaceAndTheOneBeforeStays) {
    bench.setIdentification(publishedMotor());
    open(m_folder.filePath("none.csv"));
    ASSERT_TRUE(wait([&] { return message().contains("none.csv"); })) << message().toStdString();
    EXPECT_FALSE(panel.findChild<WhatIfPage*>()->isUsed());
    open(recorded("move.csv"));
    ASSERT_TRUE(wait([&] { return !drawn("recorded").empty(); }));
    EXPECT_EQ(message(), QString()); // of the one before
    QFile file(m_folder.filePath("hall.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("time_s,hall_a_T\n0,0\n0.001,0\n0.002,0\n");
    file.close();
    panel.useRecording(file.fileName());
    ASSERT_TRUE(wait([&] { return message().contains("position"); })) << message().toStdString();
    EXPECT_TRUE(said().contains("move.csv")) << said().toStdString();
    EXPECT_FALSE(drawn("recorded").empty());
}

TEST_F(TuneRecordingTest, gainsThatAreNotRecordedAreAskedFor) {
    TuneConfig config;
    config.method = "published";
    const auto gains = runTune(motorEstimate(publishedMotor()), config);
    ASSERT_TRUE(gains);
    ResultHeader header;
    header.schema = "halbench.gains/1";
    ASSERT_TRUE(writeFile(gainsPath().toStdString(), *toJsonText(gainsDocument(header, *gains))));
    bench.setIdentification(publishedMotor());
    open(withoutSidecar(recorded("bare.csv")));
    ASSERT_TRUE(wait([&] { return message().contains("not in its .meta.json file"); }))
        << message().toStdString();
    click(panel, "Recorded gains…");
    ASSERT_TRUE(wait([&] { return !drawn("recorded").empty(); })) << message().toStdString();
    EXPECT_TRUE(wait([&] { return said().contains("matches"); })) << said().toStdString();
    EXPECT_EQ(asked.back(), "Open the active gains of the recording");
}

TEST_F(TuneRecordingTest, itGoesWhenItIsRemovedAndWithItsProject) {
    bench.setIdentification(publishedMotor());
    open(recorded("move.csv"));
    ASSERT_TRUE(wait([&] { return !drawn("recorded").empty(); }));
    click(panel, "Remove");
    EXPECT_NE(button(panel, "Open a recorded move"), nullptr);
    EXPECT_TRUE(drawn("recorded").empty());
    open(chosen);
    ASSERT_TRUE(wait([&] { return !drawn("recorded").empty(); }));
    panel.restoreDesign(std::nullopt); // another project
    EXPECT_FALSE(panel.findChild<WhatIfPage*>()->isUsed());
    EXPECT_TRUE(drawn("recorded").empty());
}

// Two minutes of a move take a second or more to judge: a window that waited would not answer in between.
TEST_F(TuneRecordingTest, nothingWaitsForIt) {
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    const QString path = recorded("long.csv", "seed=3", 115.0);
    QElapsedTimer whole;
    QElapsedTimer round;
    whole.start();
    round.start();
    qint64 longest_ms = 0;
    const auto isSaid = [&](const QStringList& words) {
        longest_ms = std::max(longest_ms, round.restart());
        return std::any_of(words.begin(), words.end(),
                           [&](const QString& word) { return said().contains(word); });
    };
    open(path);
    ASSERT_TRUE(wait([&] { return isSaid({"Assessing"}); })) << said().toStdString();
    ASSERT_TRUE(wait([&] {
        return isSaid({"matches", "no prediction", "doubtful"});
    })) << said().toStdString();
    EXPECT_LT(longest_ms, whole.elapsed() / 2) << "between two rounds of the event loop";
}

} // namespace
} // namespace halbench::app
