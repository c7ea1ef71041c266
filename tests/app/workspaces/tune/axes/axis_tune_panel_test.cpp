#include "app/workspaces/tune/axes/axis_tune_panel.h"
#include "control/base/units.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "tests/app/workspaces/tune/axes/axis_model_fixture.h"
#include "widgets/controls/message_bar.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

namespace halbench::app {
namespace {

class AxisTunePanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<AxisTunePanel>(bench());
        panel->resize(1000, 700);
        panel->show();
    }
    void open(const char* address = "sim:planar?imperfections=off") {
        connectTo(address, 0.0);
        panel->setModel(platenModelFile());
        ASSERT_TRUE(answered());
    }
    void TearDown() override { panel.reset(); }

    bool answered() {
        return wait([&] { return bool(panel->loops().result(panel->loops().axes())); });
    }
    QComboBox* box(const char* name) { return find<QComboBox>(*panel, name); }
    void choose(const char* name, const char* data) {
        box(name)->setCurrentIndex(box(name)->findData(QString::fromLatin1(data)));
    }
    bool shows(const QString& text) {
        const auto labels = panel->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(text);
        });
    }

    std::unique_ptr<AxisTunePanel> panel;
};

TEST_F(AxisTunePanelTest, gainsHaveTheUnitsOfTheChosenAxis) {
    open();
    EXPECT_EQ(panel->axis(), "x");
    EXPECT_TRUE(shows("N/m"));
    EXPECT_FALSE(shows("N·m/rad"));
    choose("Axis", "phi");
    EXPECT_EQ(panel->axis(), "phi");
    EXPECT_TRUE(shows("N·m/rad"));
}

TEST_F(AxisTunePanelTest, eachAxisKeepsItsOwnMethod) {
    open();
    choose("Gains", "bandwidth");
    choose("Axis", "y");
    EXPECT_EQ(box("Gains")->currentData().toString(), "recommended");
    choose("Axis", "x");
    EXPECT_EQ(box("Gains")->currentData().toString(), "bandwidth");
}

TEST_F(AxisTunePanelTest, savedGainsOfAllAxesAreOpenedAgain) {
    open();
    const QTemporaryDir folder;
    const QString path = folder.filePath("gains.json");
    const auto chosen = [&](QWidget*, const FileQuestion&) { return path; };
    panel->setFileChooser({chosen, chosen});
    choose("Gains", "pole-placement");
    QTest::keyClicks(find<QLineEdit>(*panel, "frequency [rad/s]"), "25");
    QTest::keyClicks(find<QLineEdit>(*panel, "damping ratio"), "1");
    ASSERT_TRUE(answered());
    auto* save = find<QAbstractButton>(*panel, "Save gains\u2026");
    ASSERT_TRUE(wait([&] { return save->isEnabled(); })); // when the loops are those of the last target
    const double wanted = (*panel->loops().answer("x"))->proposed.law.gains.proportional;
    QTest::mouseClick(save, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return shows("Saved as"); }));
    choose("Gains", "recommended");
    ASSERT_TRUE(wait([&] {
        const auto* answer = panel->loops().answer("x");
        return answer != nullptr && *answer && (*answer)->proposed.law.gains.proportional != wanted;
    }));
    QTest::mouseClick(find<QAbstractButton>(*panel, "Open gains\u2026"), Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return box("Gains")->currentData().toString() == "edited"; }));
    ASSERT_TRUE(answered());
    ASSERT_TRUE(wait([&] {
        const auto* answer = panel->loops().answer("x");
        return answer != nullptr && *answer &&
               std::abs((*answer)->proposed.law.gains.proportional / wanted - 1.0) < 1e-9;
    }));
    EXPECT_TRUE(shows("Gains of"));
}

TEST_F(AxisTunePanelTest, gainsOfAMotorAreRefusedInPlace) {
    open();
    const QTemporaryDir folder;
    const QString path = folder.filePath("gains.json");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(R"({"schema": "halbench.gains/1", "gains": {"kp": {"value": 40, "unit": "A/rad"}}})");
    file.close();
    const auto chosen = [&](QWidget*, const FileQuestion&) { return path; };
    panel->setFileChooser({chosen, chosen});
    QTest::mouseClick(find<QAbstractButton>(*panel, "Open gains\u2026"), Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return shows("gains.json"); }));
    EXPECT_EQ(box("Gains")->currentData().toString(), "recommended");
}

// A free mass as measured: its points lie in the picture until they are removed, axis by axis.
TEST_F(AxisTunePanelTest, aMeasuredResponseIsShownUntilItIsRemoved) {
    open();
    MeasuredPlant plant;
    plant.period_s = 1e-3;
    for (const double frequency_Hz : {2.0, 5.0, 10.0, 20.0}) {
        const double w = 2.0 * Pi * frequency_Hz;
        plant.points.push_back({frequency_Hz, -1.0 / (0.64 * w * w), frequency_Hz < 15.0, 0.95});
    }
    auto* remove = find<QAbstractButton>(*panel, "Remove the response");
    EXPECT_FALSE(remove->isVisible());
    choose("Axis", "y");
    panel->useMeasured({{"x", plant}}); // one axis was measured: that is shown
    EXPECT_EQ(panel->axis(), "x");
    EXPECT_TRUE(remove->isVisible());
    EXPECT_TRUE(shows("3 of 4 frequencies"));
    ASSERT_TRUE(panel->loops().measured("x"));
    choose("Axis", "y");
    EXPECT_FALSE(remove->isVisible());
    choose("Axis", "x");
    QTest::mouseClick(remove, Qt::LeftButton);
    EXPECT_FALSE(panel->loops().measured("x"));
    EXPECT_FALSE(remove->isVisible());
}

// The command line's file of a device with several axes; that of a motor is refused in place.
TEST_F(AxisTunePanelTest, aMeasuredResponseIsOpenedFromAFile) {
    open();
    const QTemporaryDir folder;
    const QString path = folder.filePath("response.json");
    const auto chosen = [&](QWidget*, const FileQuestion&) { return path; };
    auto* measure = find<QAbstractButton>(*panel, "Measured response\u2026");
    EXPECT_FALSE(measure->isVisible());
    panel->setFileChooser({chosen, chosen});
    EXPECT_TRUE(measure->isVisible());
    const auto write = [&](const char* text) {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    write(R"({"schema": "halbench.frequency/1"})");
    QTest::mouseClick(measure, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return shows("is not halbench.axis-frequency/1"); }));
    EXPECT_FALSE(panel->loops().isMeasured("x"));
    write(R"({"schema": "halbench.axis-frequency/1", "sample_period_s": 0.001, "delay_samples": 1,
              "excitation": {"least_coherence": 0.9},
              "axes": [{"axis": "x", "position_unit": "m", "effort_unit": "N",
                        "gains": {"kp": 660, "ki": 1267, "kd": 39.8, "filter_s": 0.002}}],
              "points": [{"frequency_hz": 5, "coherence": [0.99], "used": [true],
                          "loops": [{"re": -2, "im": -1}]},
                         {"frequency_hz": 10, "coherence": [0.5], "used": [false],
                          "loops": [{"re": -0.5, "im": -1}]}]})");
    QTest::mouseClick(measure, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return panel->loops().isMeasured("x"); }));
    EXPECT_TRUE(shows("1 of 2 frequencies"));
}

TEST_F(AxisTunePanelTest, theChosenAxisIsAppliedVerifiedAndRestored) {
    open();
    const double before = parameter("gain.x.kp");
    const double other = parameter("gain.y.kp");
    choose("Gains", "pole-placement");
    auto* omega = find<QLineEdit>(*panel, "frequency [rad/s]");
    auto* zeta = find<QLineEdit>(*panel, "damping ratio");
    omega->clear();
    QTest::keyClicks(omega, "25");
    zeta->clear();
    QTest::keyClicks(zeta, "1");
    box("Axes to apply")->setCurrentIndex(1); // this axis
    auto* apply = find<QAbstractButton>(*panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return apply->isEnabled(); }));
    const double wanted = (*panel->loops().answer("x"))->proposed.law.gains.proportional;
    EXPECT_NE(wanted, before);
    QTest::mouseClick(apply, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return shows("every verification step went as predicted"); }));
    EXPECT_NEAR(parameter("gain.x.kp"), wanted, 1e-6 * wanted); // single precision
    EXPECT_EQ(parameter("gain.y.kp"), other);
    auto* restore = find<QAbstractButton>(*panel, "Restore");
    ASSERT_TRUE(wait([&] { return restore->isEnabled(); }));
    QTest::mouseClick(restore, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return shows("Previous gains restored."); }));
    EXPECT_EQ(parameter("gain.x.kp"), before);
}

TEST_F(AxisTunePanelTest, aMessageCoversNoButton) {
    open();
    auto* bar = panel->findChild<widgets::MessageBar*>();
    bar->showMessage({widgets::Severity::Information, "Gains applied.", "Keep them, or restore.", {}});
    for (const int width_px : {panel->minimumSizeHint().width(), 720, 1000, 1600}) {
        panel->resize(width_px, 640);
        QCoreApplication::processEvents();
        const QRect covered(bar->mapTo(panel.get(), QPoint()), bar->size());
        for (const auto* button : panel->findChildren<QAbstractButton*>()) {
            if (button->isVisible() && !bar->isAncestorOf(button)) {
                const QRect seen = button->visibleRegion().boundingRect();
                EXPECT_FALSE(covered.intersects(seen.translated(button->mapTo(panel.get(), QPoint()))))
                    << width_px << ", " << button->text().toStdString();
            }
        }
    }
}

// Half of the mass that the model has: the steps take half of the predicted effort, which no band allows.
TEST_F(AxisTunePanelTest, gainsOfAnotherMassArePutBack) {
    open("sim:planar?imperfections=off&m=0.32");
    std::map<std::string, double> before;
    for (const char* gain : {"gain.x.kp", "gain.x.ki", "gain.x.kd", "gain.y.kp", "gain.phi.kp"}) {
        before[gain] = parameter(gain);
    }
    choose("Gains", "pole-placement");
    auto* omega = find<QLineEdit>(*panel, "frequency [rad/s]");
    omega->clear();
    QTest::keyClicks(omega, "25");
    auto* apply = find<QAbstractButton>(*panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return apply->isEnabled(); }));
    EXPECT_NE((*panel->loops().answer("x"))->proposed.law.gains.proportional, before["gain.x.kp"]);
    QTest::mouseClick(apply, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return shows("a verification step did not go as predicted"); }));
    for (const auto& [gain, value] : before) {
        EXPECT_EQ(parameter(gain), value) << gain;
    }
    EXPECT_FALSE(find<QAbstractButton>(*panel, "Restore")->isEnabled()); // they run already
    EXPECT_FALSE(session().report().board.isArmed);
}

TEST_F(AxisTunePanelTest, stopEndsTheVerificationAndRestoresTheGains) {
    open();
    const double before = parameter("gain.x.kp");
    choose("Gains", "pole-placement");
    auto* omega = find<QLineEdit>(*panel, "frequency [rad/s]");
    omega->clear();
    QTest::keyClicks(omega, "25");
    auto* apply = find<QAbstractButton>(*panel, "Apply and verify");
    ASSERT_TRUE(wait([&] { return apply->isEnabled(); }));
    QTest::mouseClick(apply, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return !session().procedure().isEmpty(); }));
    session().stopActuator();
    ASSERT_TRUE(wait([&] { return session().procedure().isEmpty(); }));
    EXPECT_FALSE(shows("every verification step went as predicted"));
    EXPECT_EQ(parameter("gain.x.kp"), before);
    EXPECT_FALSE(session().report().board.isArmed);
}

} // namespace
} // namespace halbench::app
