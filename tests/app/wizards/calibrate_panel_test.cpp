#include "app/wizards/calibrate_panel.h"
#include "app/wizards/calibrate_text.h"
#include "app/workbench/wall_clock.h"
#include "control/base/units.h"
#include "tests/app/workspaces/panel_fixture.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/message_bar.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/display_units.h"

#include <QCheckBox>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QTabWidget>
#include <QTemporaryDir>

namespace halbench::app {
namespace {

class CalibratePanelTest : public PanelTest {
protected:
    void SetUp() override {
        PanelTest::SetUp();
        show(panel);
    }
    QString message() const { return panel.findChild<widgets::MessageBar*>()->message().text; }
    QString remedy() const { return panel.findChild<widgets::MessageBar*>()->message().remedy; }
    /// Titles of those that can be chosen and show something.
    QStringList pictures() const {
        const auto* tabs = panel.findChild<QTabWidget*>();
        QStringList titles;
        for (int i = 0; tabs->isVisible() && i < tabs->count(); ++i) {
            if (tabs->isTabVisible(i) && !static_cast<widgets::FigureView*>(tabs->widget(i))->isEmpty()) {
                titles << tabs->tabText(i);
            }
        }
        return titles;
    }
    bool isResultShown() const { return button(panel, "Calibrate again") != nullptr; }

    CalibratePanel panel{bench};
};

TEST_F(CalibratePanelTest, recordsAMotionMadeByHand) {
    connectMotor("sim:spherical?motion=5&adc=1&seed=2", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    const auto boxes = panel.findChildren<QCheckBox*>();
    const auto shown = std::count_if(boxes.begin(), boxes.end(), [](const QCheckBox* box) {
        return box->text().contains("fr&iction") && !box->isHidden();
    });
    EXPECT_EQ(shown, 0); // nothing drives the rotor
    click(panel, "Start calibration");
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    const auto* table = panel.findChild<widgets::EstimateTable*>();
    EXPECT_TRUE(table->text().contains("gain error r of sensor 0")) << table->text().toStdString();
    EXPECT_TRUE(table->text().contains("harmonic (4,2)")) << table->text().toStdString();
    EXPECT_TRUE(pictures().isEmpty()) << pictures().join(", ").toStdString();
    const auto before = valuesNow();
    click(panel, "Apply");
    ASSERT_TRUE(wait([&] { return message().startsWith("Applied"); })) << message().toStdString();
    EXPECT_NE(valuesNow().at("sensor.gain_1"), before.at("sensor.gain_1"));
    click(panel, "Restore");
    ASSERT_TRUE(wait([&] { return valuesNow().at("sensor.gain_1") == before.at("sensor.gain_1"); }));
}

TEST_F(CalibratePanelTest, refusesAMotionThatDoesNotExcite) {
    connectMotor("sim:spherical?adc=1&seed=2", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    click(panel, "Start calibration");
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    EXPECT_FALSE(isEnabled(panel, "Apply"));
}

TEST_F(CalibratePanelTest, proposesAppliesOnPurposeAndRestores) {
    connectMotor("sim:htm?seed=5", 0.0);
    const auto before = valuesNow();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    click(panel, "Start calibration");
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    EXPECT_EQ(valuesNow(), before); // nothing is applied by itself
    const auto* table = panel.findChild<widgets::EstimateTable*>();
    ASSERT_GE(table->rowCount(), 6);
    EXPECT_EQ(pictures(), (QStringList{"Hall ellipse", "Residual", "Static friction"}));
    const int last = table->columnCount() - 1;
    EXPECT_EQ(table->horizontalHeaderItem(last)->text(), "On the device");
    EXPECT_EQ(table->item(0, last)->text(), widgets::numberText(before.at("stray.coefficient") * 1e3, 4));
    panel.resize(900, 420); // lower than the table: what is to be done stays in sight
    const auto* apply = button(panel, "Apply");
    EXPECT_TRUE(wait([&] { return apply->visibleRegion().boundingRect() == apply->rect(); }));
    click(panel, "Apply");
    ASSERT_TRUE(wait([&] { return message().startsWith("Applied"); })) << message().toStdString();
    EXPECT_TRUE(message().endsWith("when the simulated device is disconnected.")) << message().toStdString();
    const auto after = valuesNow();
    EXPECT_NE(after.at("hall.offset_a"), before.at("hall.offset_a"));
    EXPECT_EQ(after.at("gain.kp"), before.at("gain.kp"));
    EXPECT_FALSE(isEnabled(panel, "Apply"));
    const auto now = [](double offset_T) { return "\t" + widgets::numberText(offset_T * 1e3, 4); };
    EXPECT_TRUE(table->text().contains(now(after.at("hall.offset_a")))) << table->text().toStdString();
    click(panel, "Restore");
    ASSERT_TRUE(wait([&] { return message().contains("Previous values restored"); }));
    EXPECT_EQ(valuesNow(), before);
    EXPECT_TRUE(table->text().contains(now(before.at("hall.offset_a")))) << table->text().toStdString();
    // Whoever writes it: beside the figure stands what the device has.
    bench.writeValues({{"hall.offset_a", 0.00125}}, [](const Result<void>&) {});
    EXPECT_TRUE(wait([&] { return table->text().contains(now(0.00125)); })) << table->text().toStdString();
}

TEST_F(CalibratePanelTest, aResultIsNotAppliedToAnotherBoardNorToAnArmedOne) {
    connectMotor("sim:htm?seed=5", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    click(panel, "Start calibration");
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Apply"); }));

    const auto arm = [&](bool isArmed) {
        bench.session().request(
            [isArmed](devices::Device& device) { return isArmed ? device.arm() : device.disarm(); },
            [](const Result<void>&) {});
        ASSERT_TRUE(wait([&] { return bench.session().report().board.isArmed == isArmed; }));
    };
    arm(true);
    EXPECT_FALSE(isEnabled(panel, "Apply"));
    arm(false);
    EXPECT_TRUE(isEnabled(panel, "Apply"));

    connectMotor("sim:htm?seed=6", 0.0);
    EXPECT_TRUE(isResultShown()) << "it is not lost";
    EXPECT_TRUE(panel.record());
    EXPECT_FALSE(isEnabled(panel, "Apply"));
    EXPECT_TRUE(message().contains("Another device is connected")) << message().toStdString();
}

TEST_F(CalibratePanelTest, aResultOfThisSessionIsForItsDeviceAfterAReconnectLikeOneOfTheProject) {
    connectMotor("sim:htm?seed=5", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    click(panel, "Start calibration");
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Apply"); }));
    click(panel, "Apply");
    ASSERT_TRUE(wait([&] { return message().startsWith("Applied"); }));
    const auto calibrated = valuesNow();

    bench.session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return bench.session().state() == SessionState::Disconnected; }));
    EXPECT_FALSE(isEnabled(panel, "Apply"));
    connectMotor("sim:htm?seed=5", 0.0); // begins with the values that it keeps
    EXPECT_TRUE(isResultShown());
    EXPECT_TRUE(message().contains("Same as the connected device.")) << message().toStdString();
    ASSERT_TRUE(wait([&] { return remedy().contains("Not on the device yet: press Apply"); }))
        << remedy().toStdString();
    const auto before = valuesNow();
    EXPECT_NE(before.at("hall.offset_a"), calibrated.at("hall.offset_a"));
    click(panel, "Apply");
    ASSERT_TRUE(wait([&] { return message().startsWith("Applied"); }));
    EXPECT_EQ(valuesNow(), calibrated);
    click(panel, "Restore");
    ASSERT_TRUE(wait([&] { return message().contains("Previous values restored"); }));
    EXPECT_EQ(valuesNow(), before);
}

TEST_F(CalibratePanelTest, disconnectingWhileItRunsSaysWhyItEnded) {
    connectMotor("sim:htm?seed=5", 1.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    click(panel, "Start calibration");
    ASSERT_TRUE(wait([&] { return bench.session().report().board.isArmed; }));
    bench.session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return bench.session().state() == SessionState::Disconnected; }));
    EXPECT_TRUE(message().contains("Stopped: the device was disconnected")) << message().toStdString();
    EXPECT_TRUE(remedy().contains("disarmed")) << remedy().toStdString();
}

TEST_F(CalibratePanelTest, savesTheSameBytesAsTheBatchProgramForTheSameSeed) {
    // Second route: the headless program, with all imperfections of the motor.
    const QTemporaryDir folder;
    const auto content = [&folder](const char* name) {
        QFile file(folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name;
        return file.readAll();
    };
    QProcess batch;
    batch.start(HALBENCH_PROGRAM,
                {"calibrate", "sim:htm?seed=5", "all", "--out", folder.filePath("batch.json")});
    panel.setFileChooser(
        {[&folder](QWidget*, const FileQuestion&) { return folder.filePath("panel.json"); }, {}});
    connectMotor("sim:htm?seed=5", 0.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    click(panel, "Start calibration");
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    click(panel, "Save calibration\u2026");
    ASSERT_TRUE(wait([&] { return message().startsWith("Saved"); })) << message().toStdString();
    ASSERT_TRUE(wait([&] { return batch.state() == QProcess::NotRunning; }));
    ASSERT_EQ(batch.exitCode(), 0) << batch.readAllStandardError().toStdString();
    EXPECT_EQ(content("panel.json"), content("batch.json"));
}

TEST_F(CalibratePanelTest, onlyWhatIsChosenIsDone) {
    connectMotor("sim:htm", 0.0);
    for (auto* box : panel.findChildren<QCheckBox*>()) {
        if (box->isVisible() && !box->text().contains("Stray")) {
            QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
        }
    }
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    click(panel, "Start calibration");
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    EXPECT_EQ(panel.findChild<widgets::EstimateTable*>()->rowCount(), 1);
    EXPECT_EQ(pictures(), QStringList()); // the stray field alone has none
}

TEST_F(CalibratePanelTest, cancelLeavesEverythingAsItWas) {
    connectMotor("sim:htm", 5.0);
    const auto before = valuesNow();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    click(panel, "Start calibration");
    ASSERT_TRUE(wait([&] { return bench.session().report().board.isArmed; }));
    click(panel, "Cancel");
    ASSERT_TRUE(wait([&] { return message().contains("cancelled"); })) << message().toStdString();
    EXPECT_EQ(valuesNow(), before);
    EXPECT_FALSE(bench.session().report().board.isArmed);
    EXPECT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
}

TEST_F(CalibratePanelTest, whatStartsAndEndsItIsInSightHoweverLittleRoomThereIs) {
    panel.resize(700, 330);
    connectMotor("sim:htm", 1.0);
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    click(panel, "Start calibration");
    EXPECT_TRUE(isWhole(panel, "Cancel"));
    click(panel, "Cancel");
    ASSERT_TRUE(wait([&] { return message().contains("cancelled"); })) << message().toStdString();
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    EXPECT_TRUE(isWhole(panel, "Start calibration"));
}

CalibrationRecord measuredOn(const devices::DeviceInfo& device) {
    CalibrationRecord record;
    record.header.device = device;
    record.header.started = "2026-05-04T03:02:01Z";
    record.result.figures = {
        {"hall.offset_a", "T", {1e-3, std::pair(9e-4, 1.1e-3), control::EstimateSource::Identified, "T"}}};
    record.result.before = {{"hall.offset_a", 5e-4}};
    record.result.proposed = {{"hall.offset_a", 1e-3}};
    record.result.isApplied = true;
    return record;
}

TEST_F(CalibratePanelTest, aCalibrationOfTheProjectIsAppliedOnPurposeAndRestoresWhatTheDeviceHad) {
    connectMotor("sim:htm?seed=5", 0.0);
    const auto before = valuesNow();
    panel.restore(measuredOn(bench.session().info()));
    EXPECT_TRUE(message().contains(localDate("2026-05-04T03:02:01Z"))) << message().toStdString();
    EXPECT_TRUE(message().contains("Same as the connected device.")) << message().toStdString();
    EXPECT_EQ(valuesNow(), before); // showing it writes nothing
    click(panel, "Apply");
    ASSERT_TRUE(wait([&] { return message().startsWith("Applied"); }));
    EXPECT_NEAR(valuesNow().at("hall.offset_a"), 1e-3, 1e-9); // float32 on the board
    click(panel, "Restore");
    ASSERT_TRUE(wait([&] { return message().contains("Previous values restored"); }));
    EXPECT_EQ(valuesNow(), before);
}

TEST_F(CalibratePanelTest, aCalibrationThatTheBoardHasIsNotCalledMissing) {
    connectMotor("sim:htm?seed=5", 0.0);
    panel.restore(measuredOn(bench.session().info()));
    EXPECT_TRUE(remedy().contains("Not on the device yet")) << remedy().toStdString();
    const CalibrationRecord record = measuredOn(bench.session().info());
    bench.writeValues(record.result.proposed, [](const Result<void>&) {}); // by another panel
    EXPECT_TRUE(wait([&] { return remedy().startsWith("These values are on the device"); }))
        << remedy().toStdString();
}

TEST_F(CalibratePanelTest, aCalibrationOfAnotherDeviceIsShownButNotApplied) {
    connectMotor("sim:htm?seed=5", 0.0);
    devices::DeviceInfo other = bench.session().info();
    other.id = "another";
    panel.restore(measuredOn(other));
    EXPECT_TRUE(isResultShown());
    EXPECT_FALSE(isEnabled(panel, "Apply"));
    EXPECT_TRUE(message().contains("another"));
    panel.restore(std::nullopt);
    EXPECT_FALSE(isResultShown());
    EXPECT_FALSE(panel.record());
}

TEST_F(CalibratePanelTest, aCalibrationOfASimulatedMotorWithOtherOverridesIsNotApplied) {
    connectMotor("sim:htm?seed=5&B0=0.150", 0.0);
    devices::DeviceInfo other = bench.session().info();
    other.overrides = {{"B0", "0.15"}, {"seed", "5"}}; // as a file says it
    panel.restore(measuredOn(other));
    EXPECT_TRUE(isEnabled(panel, "Apply"));
    other.overrides = {{"B0", "0.16"}, {"seed", "5"}};
    panel.restore(measuredOn(other));
    EXPECT_FALSE(isEnabled(panel, "Apply"));
    other.overrides = {{"seed", "5"}};
    panel.restore(measuredOn(other));
    EXPECT_FALSE(isEnabled(panel, "Apply"));
}

TEST_F(CalibratePanelTest, carriesTheWallClocksStartAndTheDevicesDuration) {
    QDateTime now = QDateTime::fromString("2026-05-04T03:02:01Z", Qt::ISODate);
    bench.setWallClock([&now] { return now; });
    connectMotor("sim:htm", 10.0);
    for (auto* box : panel.findChildren<QCheckBox*>()) {
        if (box->isVisible() && !box->text().contains("Stray")) {
            QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
        }
    }
    ASSERT_TRUE(wait([&] { return isEnabled(panel, "Start calibration"); }));
    click(panel, "Start calibration");
    now = now.addSecs(3600); // it begins when it is started, not when it ends
    ASSERT_TRUE(wait([&] { return isResultShown(); })) << message().toStdString();
    EXPECT_EQ(panel.record()->header.started, "2026-05-04T03:02:01Z");
    // The board's own time is what the plan says, or more where a busy computer answers late; that of the
    // clock on the wall would be a tenth of it.
    CalibrateConfig config;
    config.which = {Calibration::Stray};
    const double predicted_s = predictCalibrate(config).duration_s;
    EXPECT_GT(panel.record()->result.duration_s, 0.7 * predicted_s);
    EXPECT_LT(panel.record()->result.duration_s, 10.0 * predicted_s); // the clock that was set: an hour
    bool isSaid = false;
    for (const auto* label : panel.findChildren<QLabel*>()) {
        isSaid = isSaid || label->text().contains("started " + localDate("2026-05-04T03:02:01Z"));
    }
    EXPECT_TRUE(isSaid);
}

TEST(CalibrateWords, showsMillitesla) {
    CalibrateResult result;
    result.figures = {{"hall.offset_a", "T", {5.6e-3, std::pair(5.5e-3, 5.7e-3), {}, "T"}}};
    result.before = {{"hall.offset_a", 1e-3}};
    const auto rows = calibrationRows(result, nullptr, {});
    EXPECT_NEAR(*rows.at(0).value, 5.6, 1e-12);
    EXPECT_EQ(rows.at(0).unit, "mT");
    EXPECT_EQ(rows.at(0).source, "1"); // no device to ask: before
    const std::map<std::string, double> values = {{"hall.offset_a", 2e-3}};
    EXPECT_EQ(calibrationRows(result, &values, {}).at(0).source, "2");
}

TEST(CalibrateWords, definesTheResidualAngleErrorOnce) {
    CalibrateResult result;
    EXPECT_TRUE(calibrationGain(result, {}).isEmpty());
    result.residualBefore_rad = degreesToRadians(2.0);
    result.residualAfter_rad = degreesToRadians(0.25);
    result.figures.push_back({"hall.offset_a", "T", {}});
    const QString text = calibrationGain(result, {});
    EXPECT_TRUE(text.startsWith("Residual angle error: 2\u00b0")) << text.toStdString();
    EXPECT_TRUE(text.contains("0.25\u00b0 with the proposed"));
    EXPECT_TRUE(text.contains("Root mean square"));
}

TEST(CalibrateWords, saysThatTheBreakawayCurrentIsNotFrictionWhileMoving) {
    CalibrateResult result;
    EXPECT_TRUE(breakawayNote(result).isEmpty());
    result.staticFriction = {{0.5, 1.6}};
    EXPECT_TRUE(breakawayNote(result).contains("identification.md#62-two-currents-of-friction"));
}

TEST(CalibrateWords, showsAnglesAndSpeedsAsPreferred) {
    CalibrateResult result;
    result.figures = {{"hall.quadrature", "rad", {0.01, std::pair(0.009, 0.011), {}, "rad"}}};
    result.residualBefore_rad = 0.02;
    result.residualAfter_rad = 0.002;
    const DisplayUnits radians{widgets::AngleUnit::Radian, SpeedUnit::RadiansPerSecond};
    EXPECT_NEAR(*calibrationRows(result, nullptr, {}).at(0).value, 0.01 * 180.0 / M_PI, 1e-12);
    EXPECT_EQ(calibrationRows(result, nullptr, radians).at(0).unit, "rad");
    EXPECT_EQ(*calibrationRows(result, nullptr, radians).at(0).value, 0.01);
    EXPECT_TRUE(calibrationGain(result, {}).contains("1.15\u00b0")); // 0.02 rad
    EXPECT_TRUE(calibrationGain(result, radians).contains("0.02 rad"));
    CalibrateConfig config;
    config.speedLimit_rad_s = 30.0;
    EXPECT_TRUE(calibrationOutlook(config, radians).contains("at 30 rad/s"));
    EXPECT_TRUE(calibrationOutlook(config, {}).contains("at 286 r/min")); // 30 30/pi
}

} // namespace
} // namespace halbench::app
