#include "tests/app/workspaces/tune/tune_panel_fixture.h"

namespace halbench::app {
namespace {

/// Gains that only the working memory of a board has when it is left.
class TuneLeavingTest : public TunePanelTest {
protected:
    void SetUp() override {
        TunePanelTest::SetUp();
        QObject::connect(&panel, &TunePanel::gainsLeft, &panel,
                         [this](const QString& text, const QString& remedy, const QString& design) {
                             left << text;
                             left << remedy;
                             left << design;
                         });
    }
    void disconnect() {
        bench.session().disconnectDevice();
        ASSERT_TRUE(wait([&] { return bench.session().state() == SessionState::Disconnected; }));
    }
    QString remedy() const { return panel.findChild<widgets::MessageBar*>()->message().remedy; }
    QStringList designs() const {
        QStringList names;
        for (const KeptDesign& design : panel.savedDesigns()) {
            names << QString::fromStdString(design.name);
        }
        return names;
    }

    QStringList left; ///< text, remedy and design of each
};

TEST_F(TuneLeavingTest, keptGainsAreADesignOfTheProjectAndLeavingTheirDeviceSaysSo) {
    prepare();
    verify();
    const double kp = valuesNow().at("gain.kp");
    const QString device = QString::fromStdString(bench.session().info().id);
    click(panel, "Keep");
    EXPECT_EQ(designs(), QStringList("kept on " + device));
    EXPECT_TRUE(remedy().contains("'kept on " + device + "'")) << remedy().toStdString();
    EXPECT_TRUE(left.isEmpty());
    disconnect();
    ASSERT_EQ(left.size(), 3);
    EXPECT_TRUE(left[0].contains(device + " was disconnected")) << left[0].toStdString();
    EXPECT_TRUE(left[0].contains("is reset on disconnect")) << left[0].toStdString();
    EXPECT_TRUE(left[1].contains("Use this design, then Apply and verify")) << left[1].toStdString();
    EXPECT_EQ(left[2], "kept on " + device);
    EXPECT_EQ(designs().size(), 1) << "once, not again when it is left";

    // The way back that the message tells of.
    connectMotor("sim:htm?seed=4", 0.0);
    EXPECT_NE(valuesNow().at("gain.kp"), kp);
    panel.takeUpDesign(left[2].toStdString());
    ASSERT_TRUE(wait([&] { return canApply(); })) << verdict().toStdString();
    verify();
    EXPECT_NEAR(valuesNow().at("gain.kp"), kp, 1e-5 * kp); // a 4-octet float there
    click(panel, "Keep");
    EXPECT_EQ(designs().size(), 1) << "the project has them already";
}

TEST_F(TuneLeavingTest, gainsThatWereNeitherKeptNorRestoredAreNotLostEither) {
    prepare();
    verify();
    const QString device = QString::fromStdString(bench.session().info().id);
    EXPECT_TRUE(designs().isEmpty());
    connectMotor("sim:htm?seed=9", 0.0); // leaves it for another one
    ASSERT_TRUE(wait([&] { return left.size() == 3; }));
    EXPECT_TRUE(left[0].contains("neither kept nor restored")) << left[0].toStdString();
    EXPECT_EQ(designs(), QStringList("applied on " + device));
    disconnect();
    EXPECT_EQ(left.size(), 3) << "nothing of the other one was applied";
}

TEST_F(TuneLeavingTest, gainsWaitForTheirDecisionWhileARecordingIsOpen) {
    prepare();
    verify();
    const double kp = valuesNow().at("gain.kp");
    const QString device = QString::fromStdString(bench.session().info().id);
    bool hasFailed = false;
    QObject::connect(&bench.session(), &DeviceSession::connectFailed, &panel, [&] { hasFailed = true; });
    bench.session().connectDevice("replay:there-is-none.csv", {0.0}); // the device is back at once
    ASSERT_TRUE(wait([&] { return hasFailed && bench.session().state() == SessionState::Connected; }));
    EXPECT_TRUE(left.isEmpty()) << left.join(' ').toStdString();
    EXPECT_EQ(valuesNow().at("gain.kp"), kp);
    click(panel, "Keep");
    EXPECT_EQ(designs(), QStringList("kept on " + device));
}

TEST_F(TuneLeavingTest, restoredGainsLeaveNothingBehind) {
    prepare();
    verify();
    click(panel, "Restore");
    ASSERT_TRUE(wait([&] { return message().contains("revious gains restored"); }));
    disconnect();
    EXPECT_TRUE(left.isEmpty());
    EXPECT_TRUE(designs().isEmpty());
}

TEST_F(TuneLeavingTest, gainsThatWereSavedInTheDeviceAreNotSpokenOf) {
    prepare();
    verify();
    click(panel, "Keep");
    panel.onSavedInDevice(); // as the Parameters panel says it (app/window/panel_connections.cpp)
    disconnect();
    EXPECT_TRUE(left.isEmpty());
}

TEST_F(TuneLeavingTest, disconnectingWhileItVerifiesSaysWhyItEnded) {
    prepare();
    bench.session().setPace({1.0});
    click(panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return bench.session().report().board.isArmed; }));
    disconnect();
    EXPECT_TRUE(message().contains("Stopped: the device was disconnected")) << message().toStdString();
    EXPECT_TRUE(remedy().contains("disarmed")) << remedy().toStdString();
    EXPECT_TRUE(left.isEmpty()) << "the gains from before were put back";
}

} // namespace
} // namespace halbench::app
