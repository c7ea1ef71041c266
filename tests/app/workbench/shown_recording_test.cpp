#include "app/workbench/shown_recording.h"
#include "app/workspaces/monitor/monitor_panel.h"
#include "devices/formats/recording_file.h"
#include "devices/recording/recording_writer.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/progress_row.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QPushButton>
#include <QTemporaryDir>

#include <cmath>

namespace halbench::app {
namespace {

class ShownRecordingTest : public BenchTest {
protected:
    /// At 1 kHz, from a time that is not zero; the value is the row's number, in each column with a factor.
    /// Every `gapRows` rows ten are missing.
    QString write(const QString& name, int rows, std::size_t columns, int gapRows = 0) {
        Recording recording;
        StreamLayout layout;
        layout.period_s = 0.001;
        for (std::size_t column = 0; column < columns; ++column) {
            layout.columns.push_back({"s" + std::to_string(column), "A"});
        }
        recording.layout = std::make_shared<const StreamLayout>(std::move(layout));
        for (int row = 0; row < rows; ++row) {
            const int skipped = gapRows > 0 ? 10 * (row / gapRows) : 0;
            recording.time_s.push_back(5.0 + (row + skipped) / 1000.0);
            for (std::size_t column = 0; column < columns; ++column) {
                recording.values.push_back(static_cast<double>(row) * static_cast<double>(column + 1));
            }
        }
        devices::RecordingMeta meta;
        meta.device.model = "other";
        meta.markers = {{5.25, "knock"}};
        meta.period_s = 0.001;
        const QString path = folder.filePath(name);
        EXPECT_TRUE(devices::writeRecordingFile(path.toStdString(), recording, meta));
        return path;
    }
    ShownRecording& shown() { return bench().shownRecording(); }
    bool isDone() {
        return wait([&] { return !shown().isBusy() && shown().file() != nullptr; });
    }
    const control::SampleHistory& history() { return bench().history(); }

    QTemporaryDir folder;
};

TEST_F(ShownRecordingTest, allOfItIsThereWhileItsTimeStandsStill) {
    shown().open(write("run.csv", 3000, 2));
    ASSERT_TRUE(isDone());
    ASSERT_TRUE(history().range());
    EXPECT_EQ(history().range()->begin_s, 0.0) << "from its first row";
    EXPECT_NEAR(history().range()->end_s, 2.999, 1e-9);
    std::vector<control::TimedValue> samples;
    history().samples("s1", *history().range(), samples);
    ASSERT_EQ(samples.size(), 3000U);
    for (std::size_t row = 0; row < samples.size(); ++row) {
        ASSERT_NEAR(samples[row].time_s, static_cast<double>(row) / 1000.0, 1e-9); // 5 s have a rounding
        ASSERT_EQ(samples[row].value, 2.0 * static_cast<double>(row));
    }
    EXPECT_EQ(history().statistics("s0", *history().range()).gaps, 0U);
    EXPECT_EQ(session().state(), SessionState::Connected);
    EXPECT_EQ(session().report().deviceTime_s, 0.0);
}

TEST_F(ShownRecordingTest, whatIsNotAsItWasRecordedIsShownAndDoubted) {
    const QString path = write("run.csv", 50, 1);
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    const QByteArray written = file.readAll();
    file.resize(written.lastIndexOf('\n', written.size() - 2) + 1); // without its last row
    file.close();
    QStringList logged;
    QObject::connect(&session(), &DeviceSession::message, &session(),
                     [&](MessageLevel level, const QString&, const QString& text) {
                         if (level == MessageLevel::Warning) {
                             logged.append(text);
                         }
                     });
    MonitorPanel panel(bench());
    shown().open(path);
    ASSERT_TRUE(isDone());
    ASSERT_EQ(logged.size(), 1);
    EXPECT_TRUE(logged[0].contains("49 of 50 rows")) << logged[0].toStdString();
    EXPECT_EQ(panel.findChild<widgets::MessageBar*>()->message().text, logged[0]);
    shown().open(write("whole.csv", 50, 1));
    ASSERT_TRUE(isDone());
    EXPECT_EQ(logged.size(), 1);
}

TEST_F(ShownRecordingTest, missingRowsAreGaps) {
    shown().open(write("run.csv", 1000, 1, 100));
    ASSERT_TRUE(isDone());
    EXPECT_EQ(history().statistics("s0", *history().range()).gaps, 9U);
    EXPECT_EQ(history().lostRows(), 90U);
    EXPECT_NEAR(history().range()->end_s, 1.089, 1e-9);
}

TEST_F(ShownRecordingTest, aLongOneComesPieceByPieceAndTheWindowLivesBetween) {
    int lives = 0; // what the window does in its own time
    QTimer other;
    QObject::connect(&other, &QTimer::timeout, &other, [&] { ++lives; });
    double before_s = -1.0;
    int pieces = 0;
    QObject::connect(&shown(), &ShownRecording::began, &other, [&] { other.start(0); });
    QObject::connect(&shown(), &ShownRecording::changed, &other, [&] {
        if (shown().file() != nullptr && shown().shown_s() > before_s) {
            before_s = shown().shown_s();
            ++pieces;
        }
    });
    shown().open(write("long.csv", 60'000, 20)); // 1.2 million values
    ASSERT_TRUE(isDone());
    EXPECT_GE(pieces, 4);
    EXPECT_GE(lives + 1, pieces);
    EXPECT_NEAR(history().range()->end_s, 59.999, 1e-9);
    EXPECT_LE(history().bytes(), history().budget_bytes());
}

TEST_F(ShownRecordingTest, cancelledWhileItIsShownItKeepsWhatIsThere) {
    QObject::connect(&shown(), &ShownRecording::changed, &shown(), [&] {
        if (shown().shown_s() > 0.0 && shown().isBusy()) {
            shown().cancel();
        }
    });
    shown().open(write("long.csv", 60'000, 20));
    ASSERT_TRUE(isDone());
    EXPECT_GT(history().range()->end_s, 1.0);
    EXPECT_LT(history().range()->end_s, 59.0);
    EXPECT_EQ(session().state(), SessionState::Connected);
}

TEST_F(ShownRecordingTest, cancelledWhileItIsReadNothingIsOpen) {
    shown().open(write("run.csv", 3000, 2));
    shown().cancel();
    EXPECT_FALSE(shown().isBusy());
    EXPECT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    EXPECT_EQ(shown().file(), nullptr);
    EXPECT_FALSE(history().range());
}

TEST_F(ShownRecordingTest, whatCannotBeReadIsRefusedAndNothingWaits) {
    shown().open(folder.filePath("none.csv"));
    EXPECT_TRUE(shown().isBusy());
    EXPECT_TRUE(wait([&] { return !shown().isBusy(); }));
    EXPECT_EQ(session().state(), SessionState::Disconnected);
}

TEST_F(ShownRecordingTest, aSpeedThatIsChosenPlaysItFromItsBeginning) {
    shown().open(write("run.csv", 3000, 2));
    ASSERT_TRUE(isDone());
    bench().liveSignals().want(&shown(), {"s0"});
    bench().setPace({1.0});
    ASSERT_TRUE(wait([&] { return shown().file() == nullptr; }));
    ASSERT_TRUE(history().range());
    EXPECT_EQ(history().range()->begin_s, 0.0);
    EXPECT_LT(history().range()->end_s, 2.9);
    EXPECT_EQ(history().latest("s0")->value, std::round(history().latest("s0")->time_s * 1000.0));
}

TEST_F(ShownRecordingTest, aSignalThatIsDerivedLaterHasAllOfIt) {
    shown().open(write("run.csv", 3000, 2));
    ASSERT_TRUE(isDone());
    bench().setDerivedSignals({{"sum", "s0 + s1", "A"}});
    ASSERT_TRUE(isDone());
    EXPECT_EQ(history().range("sum"), history().range("s0"));
    EXPECT_EQ(history().valueAt("sum", 2.0)->value, 6000.0);
}

TEST_F(ShownRecordingTest, anotherDeviceTakesItsPlace) {
    shown().open(write("run.csv", 3000, 2));
    ASSERT_TRUE(isDone());
    connectTo("sim:htm", 20.0);
    EXPECT_EQ(shown().file(), nullptr);
    EXPECT_FALSE(history().contains("s0"));
}

TEST_F(ShownRecordingTest, theMonitorShowsAllOfItWithItsMarkersAndSaysHowFarItIs) {
    MonitorPanel panel(bench());
    panel.resize(900, 600);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    auto* row = panel.findChild<widgets::ProgressRow*>();
    auto* stack = panel.findChild<widgets::LivePlotStack*>();
    EXPECT_FALSE(row->isVisible());
    shown().open(write("run.csv", 30'000, 20));
    EXPECT_TRUE(row->isVisible());
    ASSERT_TRUE(isDone());
    stack->refresh();
    EXPECT_FALSE(row->isVisible());
    EXPECT_LE(stack->timeRange().begin_s, 0.0);
    EXPECT_GE(stack->timeRange().end_s, 29.999 - 1e-6); // times from 5 s on have a rounding
    EXPECT_FALSE(stack->isFollowing());
    ASSERT_EQ(stack->markers().size(), 1U);
    EXPECT_EQ(stack->markers()[0].text, "knock");
    EXPECT_NEAR(stack->markers()[0].time_s, 0.25, 1e-9);
    stack->setTimeSpan(1.0);
    bench().setDerivedSignals({{"sum", "s0 + s1", "A"}});
    ASSERT_TRUE(isDone());
    EXPECT_LT(stack->timeRange().length_s(), 1.5) << "the user looks somewhere";
}

TEST_F(ShownRecordingTest, cancelIsAButtonAndSaysWhatIsShown) {
    MonitorPanel panel(bench());
    panel.show();
    auto* row = panel.findChild<widgets::ProgressRow*>();
    QObject::connect(&shown(), &ShownRecording::changed, &panel, [&] {
        if (shown().shown_s() > 0.0 && shown().isBusy()) {
            row->findChild<QPushButton*>()->click();
        }
    });
    shown().open(write("long.csv", 60'000, 20));
    ASSERT_TRUE(isDone());
    EXPECT_TRUE(panel.findChild<widgets::MessageBar*>()->message().text.contains("60.00 s"));
}

} // namespace
} // namespace halbench::app
