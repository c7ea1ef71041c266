// A verification is of one device and of one motor.
#include "app/workbench/shared_results.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

#include <QScrollArea>
#include <QSignalSpy>

namespace halbench::app {
namespace {

class TuneVerificationTest : public TunePanelTest {
protected:
    /// By hand, as another panel does.
    void arm(bool isArmed) {
        bench.session().request(
            [isArmed](devices::Device& device) { return isArmed ? device.arm() : device.disarm(); },
            [](const Result<void>& done) { EXPECT_TRUE(done); });
        ASSERT_TRUE(wait([&] { return bench.session().report().board.isArmed == isArmed; }));
    }
};

TEST_F(TuneVerificationTest, howFarAndHowLongItTurnsIsSaidBeforehandInTheUnitsOfTheUser) {
    prepare();
    const auto says = [this](const char* part) {
        const auto labels = panel.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [part](const QLabel* label) {
            return label->isVisible() && label->text().contains("Device stops at") &&
                   plain(label->text()).contains(part);
        });
    };
    // Half a radian; the board's window is twice that and a quarter of a turn (move_procedure.cpp).
    EXPECT_TRUE(says("Verification: 0.5 rad in 3.1 s"));
    EXPECT_TRUE(says("at 2.57 rad or 40 rad/s"));
    bench.setDisplayUnits({widgets::AngleUnit::Degree, SpeedUnit::TurnsPerMinute});
    EXPECT_TRUE(says("Verification: 28.6\u00b0 in 3.1 s"));
    EXPECT_TRUE(says("at 147\u00b0 or 382 r/min"));
    panel.resize(900, 420);
    EXPECT_TRUE(isWhole(panel, "Apply and verify"));
}

// Of the place that the panel has in a window of 1440 x 900.
TEST_F(TuneVerificationTest, itsPictureIsLargeEnoughToJudge) {
    panel.resize(720, 580);
    prepare();
    verify();
    ASSERT_TRUE(hasVerification());
    const auto* scroll = [this] {
        QWidget* place = panel.findChild<widgets::VerdictView*>("agreement")->parentWidget();
        return place->findChild<QScrollArea*>();
    }();
    const widgets::FigureView* picture = figure("Verification");
    EXPECT_TRUE(wait([&] { return picture->height() > 0.6 * panel.height(); })) << picture->height();
    EXPECT_LE(picture->height(), scroll->viewport()->height()); // all of it at once, its axis too
    EXPECT_LE(picture->width(), scroll->viewport()->width());
}

// The second click of a double click must not meet another button than the first.
TEST_F(TuneVerificationTest, noButtonMovesWhenThereIsSomethingToDecideAndWhenItIsDecided) {
    prepare();
    const auto frame = [this](const char* text) {
        const QAbstractButton* found = button(panel, text);
        return found == nullptr ? QRect() : QRect(found->mapTo(&panel, QPoint()), found->size());
    };
    const QRect apply = frame("Apply and verify");
    click(panel, "Apply and verify");
    EXPECT_EQ(frame("Apply and verify"), apply) << "while it runs";
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Keep"); }));
    EXPECT_EQ(frame("Apply and verify"), apply) << "while there is something to decide";
    EXPECT_FALSE(frame("Keep").intersects(apply));
    EXPECT_FALSE(frame("Restore").intersects(apply));
    const QPoint keep = frame("Keep").center();
    click(panel, "Keep");
    EXPECT_EQ(frame("Apply and verify"), apply) << "once it is decided";
    EXPECT_EQ(qobject_cast<QAbstractButton*>(panel.childAt(keep)), nullptr);
}

TEST_F(TuneVerificationTest, itEndsWithItsDevice) {
    prepare();
    verify();
    ASSERT_TRUE(hasVerification());
    bench.session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return bench.session().state() == SessionState::Disconnected; }));
    EXPECT_FALSE(hasVerification()) << agreement().toStdString();
    EXPECT_TRUE(message().isEmpty()) << message().toStdString();
    EXPECT_EQ(button(panel, "Keep"), nullptr);
    EXPECT_EQ(button(panel, "Restore"), nullptr);
    connectMotor("sim:htm?seed=9", 0.0);
    EXPECT_FALSE(hasVerification());
    EXPECT_EQ(button(panel, "Restore"), nullptr);
}

TEST_F(TuneVerificationTest, gainsForTheMotorOfAnotherDeviceAreDoubtful) {
    prepare();
    EXPECT_FALSE(verdict().contains("was identified on"));
    Provenance other;
    other.header.device = bench.session().info();
    other.header.device->id = "sim-htm-9";
    bench.setIdentification(publishedMotor(), other);
    EXPECT_TRUE(wait([&] { return verdict().contains("'sim-htm-9'"); })) << verdict().toStdString();
    EXPECT_TRUE(verdict().startsWith("Doubtful")) << verdict().toStdString();
}

TEST_F(TuneVerificationTest, thatTheKeptGainsRunIsNotSaidOfAnotherDevice) {
    prepare();
    verify();
    click(panel, "Keep");
    EXPECT_EQ(message(), "New gains active until disconnect.");
    EXPECT_TRUE(hasVerification());
    QSignalSpy driving(&panel, &TunePanel::drivingRequested);
    click(panel, "Drive the motor"); // what follows kept gains
    EXPECT_EQ(driving.count(), 1);
    connectMotor("sim:htm?seed=9", 0.0); // leaves the one before
    ASSERT_TRUE(wait([&] { return bench.session().info().uri == "sim:htm?seed=9"; }));
    EXPECT_FALSE(hasVerification());
    EXPECT_TRUE(message().isEmpty()) << message().toStdString();
}

TEST_F(TuneVerificationTest, itIsNotSaidOfGainsThatWereTypedSince) {
    prepare();
    verify();
    ASSERT_TRUE(agreement().startsWith("Within the predicted band\n")) << agreement().toStdString();
    click(panel, "Keep");
    ASSERT_EQ(message(), "New gains active until disconnect.");
    type("gain.kp", "500");
    ASSERT_TRUE(wait([&] { return verdict().startsWith("Rejected"); })) << verdict().toStdString();
    EXPECT_TRUE(agreement().contains("not those shown")) << agreement().toStdString();
    EXPECT_TRUE(message().isEmpty()) << message().toStdString();
    panel.historyActions().front()->trigger(); // the gains that were verified
    EXPECT_TRUE(wait([&] { return agreement().startsWith("Within the predicted band\n"); }))
        << agreement().toStdString();
}

TEST_F(TuneVerificationTest, itEndsWithItsMotorWhoseGainsCanStillBeRestored) {
    prepare();
    const auto before = valuesNow();
    verify();
    bench.setIdentification(publishedMotor(), {{}, ResultOrigin::Project});
    panel.restoreDesign(std::nullopt);
    EXPECT_FALSE(hasVerification());
    EXPECT_TRUE(message().isEmpty()) << message().toStdString();
    click(panel, "Restore"); // the device is the same
    ASSERT_TRUE(wait([&] { return message().contains("revious gains restored"); }));
    EXPECT_EQ(valuesNow(), before);
}

TEST_F(TuneVerificationTest, theGainsFromBeforeAreNotWrittenIntoALoopThatRuns) {
    prepare();
    verify();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Restore"); }));
    arm(true);
    EXPECT_FALSE(isEnabled(panel, "Restore"));
    EXPECT_TRUE(isEnabled(panel, "Keep")); // that writes nothing
    arm(false);
    EXPECT_TRUE(wait([&] { return isEnabled(panel, "Restore"); }));
}

TEST_F(TuneVerificationTest, theNextOneBeginsWithoutTheVerdictBefore) {
    prepare();
    verify();
    ASSERT_TRUE(wait([&] { return canApply(); }));
    bool hadOld = true;
    QString said;
    QObject::connect(&bench.session(), &DeviceSession::procedureStage, &panel, [&](ProcedureState now) {
        if (now == ProcedureState::Verify) {
            hadOld = hasVerification();
            said = checks();
        }
    });
    bench.session().setPace({1.0}); // so that the word comes before the end
    click(panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return !said.isEmpty(); }));
    EXPECT_FALSE(hadOld);
    EXPECT_TRUE(said.contains("Verification running")) << said.toStdString();
    EXPECT_FALSE(said.contains("Another procedure") || said.contains("manually")) << said.toStdString();
    bench.session().setPace({0.0});
    ASSERT_TRUE(wait([&] { return bench.session().procedure().isEmpty() && hasVerification(); }));
    EXPECT_FALSE(checks().contains("running")) << checks().toStdString();
}

} // namespace
} // namespace halbench::app
