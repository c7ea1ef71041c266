#include "app/procedures/move/move_procedure.h"
#include "app/window/docks/dock_layout.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/parts/preflight.h"
#include "devices/formats/recording_file.h"
#include "devices/open/open_device.h"
#include "tests/app/window/faulty_line.h"
#include "tests/app/window/window_test.h"
#include "tests/app/workspaces/published_motor.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/status_strip.h"

#include <QCheckBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>

#include <algorithm>
#include <chrono>

namespace halbench::app {
namespace {

using Fault = FaultyLine::Fault;

/// The window with a board whose cable is pulled and put back.
class WindowReconnectTest : public WindowTest {
protected:
    void connectBoard() {
        open();
        session().setReturnTimes({0.05, 1.5, 0.2, 0.0, 3});
        window->connectDevice(QString::fromStdString(line.uri()));
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
        ASSERT_TRUE(wait([&] { return window->bench().deviceValue("gain.kp").has_value(); }));
        ASSERT_TRUE(wait([&] { return window->bench().history().latest("hall.a").has_value(); }));
    }

    void arm() {
        session().request([](devices::Device& device) { return device.arm(); }, [](const Result<void>&) {});
        ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    }

    void unplug() {
        line.spoil(Fault::Cut);
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Reconnecting; }));
        EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    }

    void plugIn() {
        const std::uint64_t returns = session().returns();
        line.spoil(Fault::None);
        ASSERT_TRUE(wait([&] {
            return session().returns() == returns + 1 && session().state() == SessionState::Connected;
        }));
        EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    }

    /// Somebody else's program changes a value of the board while our cable is out.
    void changeBehindTheWindow(const ParameterValue& value) {
        const auto other = devices::openDevice(line.boardUri(), {});
        ASSERT_TRUE(other) << other.error().message;
        ASSERT_TRUE((*other)->writeParameters({&value, 1}));
    }

    QString notice() const {
        QString text;
        for (const auto* bar : window->findChildren<widgets::MessageBar*>()) {
            if (bar->isVisibleTo(window.get()) && bar->message().text.contains("onnection lost")) {
                text = bar->message().text;
            }
            if (bar->isVisibleTo(window.get()) && bar->message().text.startsWith("Reconnected after")) {
                text = bar->message().text;
            }
        }
        return text;
    }

    QString remedy() const {
        for (const auto* bar : window->findChildren<widgets::MessageBar*>()) {
            if (bar->isVisibleTo(window.get()) && bar->message().text == notice()) {
                return bar->message().remedy;
            }
        }
        return {};
    }

    template <typename Widget>
    Widget* named(const QString& words) const {
        for (Widget* widget : window->findChildren<Widget*>()) {
            if (widget->accessibleName() == words) {
                return widget;
            }
        }
        return nullptr;
    }

    QPushButton* button(const QString& text) const {
        for (QPushButton* one : window->findChildren<QPushButton*>()) {
            if (one->text() == text) {
                return one;
            }
        }
        return nullptr;
    }

    /// How far the time of the rows goes on at the row of this time.
    static double stepAcross(const Recording& recording, double time_s) {
        const auto after = std::lower_bound(recording.time_s.begin(), recording.time_s.end(), time_s - 1e-9);
        return after == recording.time_s.begin() || after == recording.time_s.end() ? 0.0
                                                                                    : *after - *(after - 1);
    }

    widgets::StatusStrip& strip() { return *window->findChild<widgets::StatusStrip*>(); }

    FaultyLine line;
};

TEST_F(WindowReconnectTest, recordsOnWithAMarkedGapAndIsNotArmed) {
    const QTemporaryDir folder;
    connectBoard();
    arm();
    RecordingControl& recording = window->bench().recording();
    recording.setFolder(folder.path());
    QTest::keyClick(window.get(), Qt::Key_R, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return recording.status().rows > 20; }));
    unplug();
    EXPECT_TRUE(strip().stateText().contains("reconnecting")) << strip().stateText().toStdString();
    EXPECT_TRUE(wait([&] { return notice().startsWith("Connection lost"); })) << notice().toStdString();
    EXPECT_TRUE(recording.isRecording());
    EXPECT_TRUE(remedy().contains("The recording continues with a gap.")) << remedy().toStdString();
    EXPECT_FALSE(session().report().board.isArmed);
    // Long against what a busy machine lets its clocks wait.
    ASSERT_TRUE(wait([&, since = std::chrono::steady_clock::now()] {
        return std::chrono::steady_clock::now() - since > std::chrono::milliseconds(500);
    }));
    plugIn();
    const auto rows = recording.status().rows;
    ASSERT_TRUE(wait([&] { return recording.status().rows > rows + 20; }));
    EXPECT_FALSE(session().report().board.isArmed);
    EXPECT_TRUE(wait([&] { return notice().startsWith("Reconnected after"); })) << notice().toStdString();
    recording.stop();
    ASSERT_TRUE(wait([&] { return !recording.isRecording(); }));
    const auto file = devices::readRecordingFile(recording.path().toStdString());
    ASSERT_TRUE(file) << file.error().message;
    ASSERT_EQ(file->meta.gaps.size(), 1U);
    // The rows carry the board's clock: across the gap it went on by the lost rows and the one behind them.
    const double step_s = stepAcross(file->recording, file->meta.gaps[0].time_s);
    EXPECT_GE(file->meta.gaps[0].lostRows, 1U);
    EXPECT_NEAR(step_s, static_cast<double>(file->meta.gaps[0].lostRows + 1) * file->meta.period_s,
                0.5 * file->meta.period_s);
    // The outage is taken on this machine's clock, which a busy machine reads late at either end; a gap that
    // forgot the outage would be one row.
    EXPECT_GE(step_s, 0.5 * session().outage_s());
    ASSERT_EQ(file->meta.markers.size(), 2U);
    EXPECT_EQ(file->meta.markers[0].text, "connection lost");
    EXPECT_EQ(file->meta.markers[1].text, "connection back");
    EXPECT_GT(file->meta.markers[1].time_s - file->meta.markers[0].time_s, 0.0);
}

TEST_F(WindowReconnectTest, theHistoryStaysAndShowsTheGap) {
    connectBoard();
    std::vector<control::TimedValue> history; // something has to be there before the loss
    ASSERT_TRUE(wait([&] {
        history.clear();
        window->bench().history().samples("hall.a", {-1e9, 1e9}, history);
        return history.size() > 100;
    }));
    unplug();
    const auto before = window->bench().history().latest("hall.a");
    ASSERT_TRUE(before);
    plugIn();
    ASSERT_TRUE(wait([&] {
        const auto now = window->bench().history().latest("hall.a");
        // Rows that were on their way when the cable went come later than `before` too.
        return session().returns() > 0 && now && now->time_s > before->time_s + session().outage_s();
    }));
    std::vector<control::TimedValue> samples;
    window->bench().history().samples("hall.a", {before->time_s - 0.5, before->time_s + 1e3}, samples);
    const auto gaps = std::count_if(samples.begin(), samples.end(), [&](const control::TimedValue& sample) {
        return sample.isAfterGap && sample.time_s > before->time_s;
    });
    EXPECT_GE(gaps, 1);
    EXPECT_LT(samples.front().time_s, before->time_s); // what came before the loss is still there
}

TEST_F(WindowReconnectTest, valuesThatDifferAreListedAndWrittenBackOnlyByTheUser) {
    connectBoard();
    const double before = *window->bench().deviceValue("gain.kp");
    unplug();
    changeBehindTheWindow({"gain.kp", before + 1.5});
    plugIn();
    ASSERT_TRUE(wait([&] { return window->bench().differences().size() == 1; }));
    EXPECT_EQ(window->bench().deviceValue("gain.kp"), before + 1.5); // the screen tells what is on the device
    EXPECT_TRUE(notice().contains("Changed values: 1")) << notice().toStdString();
    auto* list = named<QLabel>("Changed values");
    ASSERT_NE(list, nullptr);
    EXPECT_TRUE(list->isVisible());
    EXPECT_TRUE(list->text().startsWith("gain.kp: ")) << list->text().toStdString();
    QTest::mouseClick(button("Write old values"), Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return window->bench().differences().empty(); }));
    EXPECT_EQ(window->bench().deviceValue("gain.kp"), before);
    EXPECT_FALSE(list->isVisible());
    EXPECT_EQ(remedy(), "Old values written.");
}

TEST_F(WindowReconnectTest, thatItIsBackDisarmedIsNotSaidOnceItIsArmed) {
    connectBoard();
    unplug();
    EXPECT_FALSE(remedy().contains("recording")) << remedy().toStdString(); // none runs
    plugIn();
    ASSERT_TRUE(wait([&] { return notice().startsWith("Reconnected after"); }));
    EXPECT_EQ(remedy(), "Its values are unchanged.");
    arm();
    EXPECT_TRUE(wait([&] { return notice().isEmpty(); })) << notice().toStdString();
}

TEST_F(WindowReconnectTest, aDifferenceThatWasDecidedElsewhereIsListedNoMore) {
    connectBoard();
    const double before = *window->bench().deviceValue("gain.kp");
    unplug();
    changeBehindTheWindow({"gain.kp", before + 1.5});
    plugIn();
    ASSERT_TRUE(wait([&] { return window->bench().differences().size() == 1; }));
    bool isWritten = false; // as the Parameters panel does
    window->bench().writeValues({{"gain.kp", before + 3.0}}, [&](const Result<void>&) { isWritten = true; });
    ASSERT_TRUE(wait([&] { return isWritten; }));
    EXPECT_TRUE(window->bench().differences().empty());
    EXPECT_FALSE(named<QLabel>("Changed values")->isVisible());
}

TEST_F(WindowReconnectTest, differencesThatNobodyDecidedOutliveTheNextLoss) {
    connectBoard();
    const double before = *window->bench().deviceValue("gain.kp");
    unplug();
    changeBehindTheWindow({"gain.kp", before + 1.5});
    plugIn();
    ASSERT_TRUE(wait([&] { return window->bench().differences().size() == 1; }));
    unplug();
    plugIn();
    ASSERT_TRUE(wait([&] { return window->bench().differences().size() == 1; }));
    EXPECT_EQ(window->bench().differences()[0].before, before);
    QTest::mouseClick(button("Keep device values"), Qt::LeftButton);
    EXPECT_TRUE(window->bench().differences().empty());
}

TEST_F(WindowReconnectTest, aProcedureEndsAndDoesNotGoOnWithTheDeviceThatCameBack) {
    connectBoard();
    std::optional<Result<MoveResult>> moved;
    session().runProcedure(
        "move",
        [](devices::Device& device, const ProcedureObserver& observer) {
            MoveConfig config;
            config.reference = *parseMoveReference("sine,amplitude_deg=100,period_s=2");
            config.duration_s = 30.0;
            return runMove(device, config, observer);
        },
        [&](Result<MoveResult> result) { moved = std::move(result); });
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    unplug();
    plugIn();
    ASSERT_TRUE(wait([&] { return moved.has_value(); }));
    ASSERT_FALSE(*moved);
    EXPECT_EQ(moved->error().code, ErrorCode::DeviceLost);
    EXPECT_TRUE(wait([&] { return window->bench().deviceValue("hb.arm") == 0.0; }));
    EXPECT_FALSE(session().report().board.isArmed);
}

/// The board ends the trial by its watchdog: the new gains ran for as long as they were watched.
TEST_F(WindowReconnectTest, aLossInTheVerificationMoveOfTuneLeavesTheOldGainsAndADisarmedBoard) {
    connectBoard();
    Workbench& bench = window->bench();
    const double before = *bench.deviceValue("gain.kp");
    window->docks().setPerspective(Perspective::Tune);
    bench.setIdentification(publishedMotor());
    ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    ASSERT_NE(bench.design()->law.gains.proportional, before);
    QWidget& tune = *window->docks().panel("tune");
    auto* consent = tune.findChild<Preflight*>()->findChild<QCheckBox*>();
    ASSERT_NE(consent, nullptr);
    consent->click();
    auto* apply = button("Apply and verify");
    ASSERT_NE(apply, nullptr);
    ASSERT_TRUE(wait([&] { return apply->isEnabled(); }));
    apply->click();
    // Armed is the whole move and three seconds long; its fastest tenth of a second may pass between two
    // frames.
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    unplug();
    ASSERT_TRUE(wait([&] { return session().procedure().isEmpty(); }));
    const auto* said = tune.findChild<widgets::MessageBar*>();
    EXPECT_TRUE(said->message().text.contains(QString::fromStdString(session().report().lost->message)))
        << said->message().text.toStdString();
    EXPECT_FALSE(apply->isEnabled());
    plugIn();
    ASSERT_TRUE(wait([&] { return bench.deviceValue("gain.kp") == before; }));
    EXPECT_TRUE(bench.differences().empty());
    EXPECT_FALSE(session().report().board.isArmed);
    EXPECT_EQ(bench.deviceValue("hb.trial"), 0.0);
}

TEST_F(WindowReconnectTest, escWhileTheDeviceIsAwayIsObeyedAtItsReturn) {
    connectBoard();
    arm();
    unplug();
    QTest::keyClick(window.get(), Qt::Key_Escape);
    plugIn();
    EXPECT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
}

TEST_F(WindowReconnectTest, anotherBoardAtTheSameAddressIsRefusedInItsOwnWords) {
    connectBoard();
    unplug();
    line.plugInAnother();
    line.spoil(Fault::None);
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Lost; }));
    EXPECT_NE(session().report().lost->message.find("another device answers"), std::string::npos)
        << session().report().lost->message;
    EXPECT_TRUE(strip().stateText().contains("connection lost")) << strip().stateText().toStdString();
}

TEST_F(WindowReconnectTest, disconnectEndsTheSearchAndTheDeviceIsOfferedFirst) {
    connectBoard();
    unplug();
    session().disconnectDevice();
    EXPECT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    auto* list = window->docks().panel("devices")->findChild<QListWidget*>();
    ASSERT_NE(list, nullptr);
    EXPECT_EQ(list->item(0)->data(Qt::UserRole).toString().toStdString(), line.uri());
}

} // namespace
} // namespace halbench::app
