// Gains of another motor than the one that is connected.
#include "app/workbench/shared_results.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

namespace halbench::app {
namespace {

class ForeignMotorPanelTest : public TunePanelTest {
protected:
    /// The published motor, identified on this device.
    void identifiedOn(const std::string& id, bool isSimulated = false) {
        Provenance from;
        from.header.device = devices::DeviceInfo{};
        from.header.device->model = "htm";
        from.header.device->id = id;
        from.header.device->isSimulated = isSimulated;
        bench.setIdentification(publishedMotor(), from);
        ASSERT_TRUE(wait([&] { return bench.design().has_value() && !verdict().isEmpty(); }));
        ASSERT_TRUE(wait([&] { return isEnabled(panel, "Save gains\u2026"); })); // judged to its end
    }

    QWidget* notice() const { return panel.findChild<QWidget*>("foreign"); }
    QString said() const {
        QString words;
        for (const auto* label : notice()->findChildren<QLabel*>()) {
            words += label->isVisible() ? label->text() : QString();
        }
        return words;
    }
    QCheckBox* consent() const { return notice()->findChild<QCheckBox*>(); }
    static void tick(QCheckBox* box) {
        ASSERT_TRUE(box->isVisible());
        QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
    }

    /// A board behind a wire: for the window no simulated one.
    void connectBoard() {
        m_board.start(HALBENCH_PROGRAM, {"serve", "sim:htm", "--tcp", "127.0.0.1:0"});
        ASSERT_TRUE(m_board.waitForReadyRead(Patience_ms));
        connectMotor(QString::fromUtf8(m_board.readLine()).trimmed().section(' ', 1), 1.0);
        ASSERT_FALSE(bench.session().info().isSimulated);
    }
    void theRotorMayTurn() {
        tick(panel.findChild<Preflight*>()->findChild<QCheckBox*>());
        ASSERT_TRUE(wait([&] { return panel.findChild<Preflight*>()->isPassed(); }));
    }
    void TearDown() override {
        bench.session().disconnectDevice();
        EXPECT_TRUE(wait([&] { return bench.session().state() == SessionState::Disconnected; }));
        m_board.kill();
        m_board.waitForFinished(Patience_ms);
    }

    QProcess m_board;
};

TEST_F(ForeignMotorPanelTest, aRealDeviceTakesThemAfterAConsentOfTheirOwnOnly) {
    connectBoard();
    identifiedOn("another-board");
    theRotorMayTurn();
    EXPECT_FALSE(canApply());
    EXPECT_TRUE(said().contains("'another-board'")) << said().toStdString();
    tick(consent());
    EXPECT_TRUE(canApply());
    identifiedOn("a-third-board"); // that was a consent for the other motor
    EXPECT_FALSE(consent()->isChecked());
    EXPECT_FALSE(canApply());
}

TEST_F(ForeignMotorPanelTest, theMotorOfThisDeviceNeedsNone) {
    connectBoard();
    identifiedOn(bench.session().info().id);
    theRotorMayTurn();
    EXPECT_TRUE(canApply());
    EXPECT_FALSE(notice()->isVisible());
}

TEST_F(ForeignMotorPanelTest, aSimulatedDeviceIsToldButCannotBeHarmed) {
    connectMotor("sim:htm", 0.0);
    identifiedOn("another-board");
    EXPECT_TRUE(said().contains("'another-board'")) << said().toStdString();
    EXPECT_FALSE(consent()->isVisible());
    EXPECT_TRUE(wait([&] { return canApply(); }));
    bench.session().disconnectDevice();
    EXPECT_TRUE(wait([&] { return !notice()->isVisible(); })); // there is no device to be another one
}

} // namespace
} // namespace halbench::app
