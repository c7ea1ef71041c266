#include "app/window/docks/dock_layout.h"
#include "app/window/file_dialogs.h"
#include "app/window/panel_connections.h"
#include "app/wizards/frequency_panel.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/recordings/recordings_panel.h"
#include "app/workspaces/tune/axes/axis_tune_panel.h"
#include "app/workspaces/tune/tune_panel.h"
#include "tests/app/window/window_test.h"
#include "tests/app/workspaces/published_motor.h"
#include "tests/app/workspaces/tune/axes/axis_model_fixture.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/controls/stop_button.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QPushButton>
#include <qtadvanceddocking/DockWidget.h>

#include <Eigen/Core>
#include <algorithm>

namespace halbench::app {
namespace {

class PanelConnectionsTest : public WindowTest {
protected:
    /// The one that can be seen.
    QPushButton* button(const char* panel, const QString& text) {
        for (auto* found : window->docks().panel(panel)->findChildren<QPushButton*>()) {
            if (found->text().remove('&') == text && found->isVisible()) {
                return found;
            }
        }
        return nullptr;
    }
};

TEST_F(PanelConnectionsTest, withoutAMotorTuneLeadsToIdentify) {
    open();
    window->docks().setPerspective(Perspective::Tune);
    ASSERT_TRUE(wait([&] { return button("tune", "Identify the motor") != nullptr; }));
    QTest::mouseClick(button("tune", "Identify the motor"), Qt::LeftButton);
    EXPECT_EQ(window->docks().perspective(), Perspective::Identify);
    EXPECT_TRUE(wait([&] { return button("identify", "Start identification") != nullptr; }));
    EXPECT_NE(button("identify", "Load model\u2026"), nullptr); // the window has dialogs
}

// The recommended gains need the stray coefficient to better than half of it (htm-theory.md 8.4): not before
// a calibration has said how well it is known, and after it for the device that was calibrated only.
TEST_F(PanelConnectionsTest, aStrayCalibrationIsKnownToTune) {
    open();
    connectMotor(0.0);
    window->bench().setIdentification(publishedMotor());
    const auto needsCalibration = [&] {
        const auto& design = window->bench().design();
        return design &&
               std::any_of(design->warnings.begin(), design->warnings.end(),
                           [](const Finding& each) { return each.code == "stray_field_not_calibrated"; });
    };
    ASSERT_TRUE(wait(needsCalibration));
    window->docks().setPerspective(Perspective::Identify);
    window->docks().docks().value("calibrate")->setAsCurrentTab();
    for (auto* box : window->docks().panel("calibrate")->findChildren<QCheckBox*>()) {
        box->setChecked(box->text().remove('&').startsWith("Stray"));
    }
    ASSERT_TRUE(wait([&] { return button("calibrate", "Start calibration")->isEnabled(); }));
    QTest::mouseClick(button("calibrate", "Start calibration"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return button("calibrate", "Apply") != nullptr; }, 120000));
    EXPECT_TRUE(wait([&] { return !needsCalibration(); }));
    ASSERT_TRUE(window->bench().design());
    session().disconnectDevice();
    EXPECT_TRUE(wait(needsCalibration));
}

// From the measurement to the picture: the points that were measured lie in the open loop of Tune.
TEST_F(PanelConnectionsTest, aMeasuredResponseIsUsedInTune) {
    open();
    connectMotor(0.0);
    window->bench().setIdentification(publishedMotor());
    window->docks().setPerspective(Perspective::Identify);
    window->docks().docks().value("frequency")->setAsCurrentTab();
    ASSERT_TRUE(wait([&] { return button("frequency", "Start measurement")->isEnabled(); }));
    QTest::mouseClick(button("frequency", "Start measurement"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return button("frequency", "Use in Tune") != nullptr; }, 120000));
    QTest::mouseClick(button("frequency", "Use in Tune"), Qt::LeftButton);
    EXPECT_EQ(window->docks().perspective(), Perspective::Tune);
    ASSERT_TRUE(wait([&] { return button("tune", "Remove the response") != nullptr; }));
}

// A response of several axes waits in Tune until the axes are identified.
TEST_F(PanelConnectionsTest, aMeasuredResponseOfAxesIsUsedInTune) {
    open();
    window->connectDevice("sim:planar?imperfections=off");
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->bench().deviceValues().empty(); }, Patience_ms));
    AxesFrequencyResult result;
    AxisResponse axis;
    axis.axis.id = "y";
    axis.law.kp_A_per_rad = 660.0;
    axis.law.period_s = result.period_s;
    result.axes.push_back(axis);
    AxesFrequencyPoint point;
    point.plant.frequency_rad_s = 50.0;
    point.plant.coherence = Eigen::VectorXd::Constant(1, 0.99);
    point.loop.loops.push_back({-660.0 / (0.64 * 50.0 * 50.0), 0.0});
    point.isUsed = {true};
    result.points.push_back(point);
    Q_EMIT static_cast<FrequencyPanel*>(window->docks().panel("frequency"))->axesUseRequested(result);
    EXPECT_EQ(window->docks().perspective(), Perspective::Tune);
    auto* tune = static_cast<TunePanel*>(window->docks().panel("tune"));
    tune->useAxisModel(platenModelFile());
    auto* axes = tune->findChild<AxisTunePanel*>();
    ASSERT_NE(axes, nullptr);
    EXPECT_TRUE(wait([&] { return axes->loops().measured("y").has_value(); }));
    EXPECT_FALSE(axes->loops().isMeasured("x"));
}

TEST_F(PanelConnectionsTest, aRecordingIsAskedOfTuneWhatIf) {
    open();
    window->bench().setIdentification(publishedMotor());
    auto* recordings = static_cast<RecordingsPanel*>(window->docks().panel("recordings"));
    Q_EMIT recordings->whatIfRequested(QStringLiteral("none.csv"));
    EXPECT_EQ(window->docks().perspective(), Perspective::Tune);
    const auto* message = window->docks().panel("tune")->findChild<widgets::MessageBar*>();
    EXPECT_TRUE(wait([&] { return message->message().text.contains("none.csv"); }));
}

// From the swing to the proposal: Ziegler and Nichols from what was measured, and nothing is applied.
TEST_F(PanelConnectionsTest, aMeasuredUltimateGainIsUsedInTune) {
    open();
    window->connectDevice("sim:htm?imperfections=off"); // uncalibrated sensors would have it refused
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->bench().deviceValues().empty(); }, Patience_ms));
    session().setPace({0.0});
    window->bench().setIdentification(publishedMotor());
    window->docks().setPerspective(Perspective::Identify);
    window->docks().docks().value("relay")->setAsCurrentTab();
    ASSERT_TRUE(wait([&] { return button("relay", "Start experiment")->isEnabled(); }));
    QTest::mouseClick(button("relay", "Start experiment"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return button("relay", "Use in Tune") != nullptr; }, 120000));
    QTest::mouseClick(button("relay", "Use in Tune"), Qt::LeftButton);
    EXPECT_EQ(window->docks().perspective(), Perspective::Tune);
    auto* gain = window->docks().docks().value("tune")->widget()->findChild<widgets::OptionalNumberEdit*>(
        "ultimate-gain");
    ASSERT_NE(gain, nullptr);
    EXPECT_TRUE(gain->isVisible());
    EXPECT_NEAR(gain->value().value_or(0.0), 16.29, 0.5); // resources/help/htm-theory.md 7.7
}

TEST_F(PanelConnectionsTest, aFileDialogCarriesASmallStop) {
    open();
    connectMotor(1.0);
    QFileDialog dialog;
    dressFileDialog(dialog, {"Save as model", "model.json", "Model (*.json)"}, true, window->bench());
    EXPECT_EQ(dialog.defaultSuffix(), "json");
    auto* stop = dialog.findChild<widgets::StopButton*>();
    ASSERT_NE(stop, nullptr);
    QTest::mousePress(stop, Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return session().report().board.isStopLatched; }));
}

} // namespace
} // namespace halbench::app
