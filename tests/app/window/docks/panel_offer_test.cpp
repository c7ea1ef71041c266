#include "app/window/docks/dock_layout.h"
#include "app/window/docks/panel_needs.h"
#include "app/window/docks/panels.h"
#include "app/workspaces/actuators/registry/actuator_panels.h"
#include "app/workspaces/drive/arm_button.h"
#include "app/workspaces/drive/mode_box.h"
#include "devices/simulated/registry/simulated_models.h"
#include "tests/app/window/top_bar_fixture.h"
#include "tests/conformance/actuator/toy_model.h"
#include "tests/devices/xcp/foreign_board.h"
#include "widgets/actuators/registry/actuator_views.h"

#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

/// Panels, menu entries, perspectives and controls of the bar with devices of different abilities.
class PanelOfferTest : public TopBarTest {
protected:
    static void SetUpTestSuite() {
        devices::addSimulatedModel(devices::toyModel());
        devices::addSimulatedModel(devices::sensingToyModel());
    }

    void connectTo(const QString& uri) {
        QString refusal;
        const QObject listener;
        QObject::connect(&session(), &DeviceSession::connectFailed, &listener,
                         [&refusal](const QString& message) { refusal = message; });
        window->connectDevice(uri);
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected || !refusal.isEmpty(); }));
        ASSERT_EQ(refusal.toStdString(), "") << uri.toStdString();
    }
    void disconnect() {
        session().disconnectDevice();
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    }
    bool isOpen(const QString& id) { return !window->docks().docks().value(id)->isClosed(); }
    /// Of the View menu, whether it can be seen.
    bool isInMenu(const QString& title) {
        for (const QAction* action : window->findChildren<QAction*>()) {
            if (action->text() == title && !action->isCheckable() && action->isVisible()) {
                return true;
            }
        }
        return false;
    }
    /// Buttons of the whole window with this word that a user could press or see.
    int seen(const QString& words) {
        int count = 0;
        for (const auto* button : window->findChildren<QAbstractButton*>()) {
            count += button->isVisible() && button->text().remove('&') == words ? 1 : 0;
        }
        return count;
    }
    QSet<QString> offered() {
        QSet<QString> ids;
        for (const PanelSpec& spec : panelSpecs()) {
            if (window->docks().isOffered(spec.id)) {
                ids.insert(spec.id);
            }
        }
        return ids;
    }
};

TEST_F(PanelOfferTest, aDeviceThatOnlySensesHasNeitherArmNorDriveNorTune) {
    open();
    window->docks().raise("drive");
    window->docks().setPerspective(Perspective::Tune); // which it has no use for
    connectTo("sim:sense");
    EXPECT_EQ(window->docks().perspective(), Perspective::Monitor);
    for (const char* id : {"drive", "tune", "identify", "calibrate", "frequency", "relay", "field"}) {
        EXPECT_FALSE(window->docks().isOffered(id)) << id;
        EXPECT_FALSE(isOpen(id)) << id;
    }
    for (const char* title : {"Drive", "Tune", "Identify", "Calibrate", "Field"}) {
        EXPECT_FALSE(isInMenu(title)) << title;
    }
    EXPECT_TRUE(isInMenu("Monitor"));
    EXPECT_FALSE(inBar<ArmButton>()->isVisible());
    EXPECT_FALSE(inBar<ModeBox>()->isVisible());
    EXPECT_EQ(seen("Arm"), 0);
    EXPECT_EQ(perspective("Tune"), nullptr);
    EXPECT_EQ(perspective("Identify"), nullptr);
    EXPECT_NE(perspective("Monitor"), nullptr);
    EXPECT_NE(perspective("Record"), nullptr);
    key(Qt::Key_3, Qt::ControlModifier); // Tune
    EXPECT_EQ(window->docks().perspective(), Perspective::Monitor);
    key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier); // Arm
    EXPECT_FALSE(isArmed());
    EXPECT_TRUE(wait([&] { return window->bench().history().latest("position.x").has_value(); }));
    // STOP is where it always is.
    EXPECT_TRUE(window->findChild<TopBar*>()->isVisible());
}

TEST_F(PanelOfferTest, theRelayExperimentIsOfADeviceWithOneAxis) {
    open();
    connectTo("sim:planar");
    for (const char* id : {"identify", "frequency", "calibrate", "tune", "drive"}) {
        EXPECT_TRUE(window->docks().isOffered(id)) << id;
    }
    EXPECT_FALSE(window->docks().isOffered("relay"));
}

TEST_F(PanelOfferTest, anOrientationInSpaceHasItsPerspectiveAndNothingToDrive) {
    open();
    connectTo("sim:spherical");
    ASSERT_TRUE(window->docks().isOffered(Perspective::Field));
    EXPECT_NE(perspective("Field && Pose"), nullptr);
    EXPECT_FALSE(window->docks().isOffered(Perspective::Tune));
    // Its sensors are calibrated; there is nothing to identify.
    EXPECT_TRUE(window->docks().isOffered(Perspective::Identify));
    EXPECT_TRUE(window->docks().isOffered("calibrate"));
    EXPECT_FALSE(window->docks().isOffered("identify"));
    EXPECT_EQ(seen("Arm"), 0);
    window->docks().setPerspective(Perspective::Field);
    EXPECT_EQ(window->docks().perspective(), Perspective::Field);
    EXPECT_TRUE(isOpen("field"));
    EXPECT_TRUE(isOpen("estimators"));
    EXPECT_TRUE(isOpen("coverage"));
    disconnect();
    connectTo("sim:htm");
    EXPECT_FALSE(window->docks().isOffered("estimators"));
    EXPECT_FALSE(window->docks().isOffered("coverage"));
}

TEST_F(PanelOfferTest, theNextDeviceFindsThePanelsAsTheyWereLeft) {
    open();
    connectTo("sim:htm");
    ASSERT_EQ(offered().size(), static_cast<int>(panelSpecs().size() - actuatorPanels().size()));
    window->docks().raise("parameters");
    window->docks().raise("drive");
    window->docks().raise("log");
    const ads::CDockWidget* drive = window->docks().docks().value("drive");
    ASSERT_EQ(drive->dockAreaWidget()->currentDockWidget(), drive);
    disconnect();
    connectTo("sim:sense");
    ASSERT_FALSE(isOpen("drive"));
    // What is kept is not this device's: a project that is saved now opens with Drive.
    EXPECT_TRUE(window->docks().arrangements().value("monitor").contains("Name=\"drive\" Closed=\"0\""));
    window->docks().setPerspective(Perspective::Record);
    window->docks().setPerspective(Perspective::Monitor);
    EXPECT_FALSE(isOpen("drive"));
    disconnect();
    EXPECT_TRUE(isOpen("drive"));
    EXPECT_EQ(drive->dockAreaWidget()->currentDockWidget(), drive) << "in front, as before";
    EXPECT_TRUE(isOpen("log"));
    EXPECT_TRUE(isInMenu("Drive"));
    EXPECT_TRUE(inBar<ArmButton>()->isVisible());
    EXPECT_NE(perspective("Tune"), nullptr);
}

TEST_F(PanelOfferTest, anActuatorOfThisTestIsDrivenAndIdentifiedButNotCalibrated) {
    open();
    connectTo("sim:toy");
    EXPECT_TRUE(window->docks().isOffered("drive"));
    EXPECT_TRUE(window->docks().isOffered(Perspective::Tune));
    EXPECT_TRUE(window->docks().isOffered(Perspective::Identify));
    EXPECT_FALSE(window->docks().isOffered("calibrate"));
    EXPECT_FALSE(window->docks().isOffered(Perspective::Field)); // no view is registered
    EXPECT_TRUE(inBar<ArmButton>()->isVisible());
}

/// Picture of a few lines of the actuator of this test.
class SlidePicture final : public widgets::ActuatorPicture {
public:
    using ActuatorPicture::ActuatorPicture;
    void showSettings(const widgets::ActuatorValues&) override {}
    void showSamples(const widgets::ActuatorValues& values) override {
        m_position_m = values.signal("position.x");
    }
    void setStale(bool) override {}
    void clear() override { m_position_m.reset(); }
    QString numbers() const override {
        return m_position_m ? QString("slide at %1 m").arg(*m_position_m) : QString();
    }

private:
    std::optional<double> m_position_m;
};

TEST_F(PanelOfferTest, aViewThatIsRegisteredShowsItsActuator) {
    const auto make = [](QWidget* parent) { return new SlidePicture(parent); };
    widgets::addActuatorView({"toy", {"position.x", "reference.x", "truth.position.x"}, {}, make});
    open();
    connectTo("sim:toy");
    ASSERT_TRUE(window->docks().isOffered(Perspective::Field));
    window->docks().setPerspective(Perspective::Field);
    EXPECT_TRUE(wait([&] {
        const auto labels = window->docks().docks().value("field")->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            const QStringList words = label->text().split(' ');
            return label->text().startsWith("slide at ") &&
                   std::fabs(words.value(2).toDouble()) < 2e-6; // noise
        });
    }));
    widgets::addActuatorView({"toy", {"nothing that is there"}, {}, make}); // for the next test
}

TEST_F(PanelOfferTest, aBoardWithoutAProfileIsWatchedSetAndRecorded) {
    devices::xcp::ForeignBoard board;
    open();
    connectTo(QString::fromStdString(board.uri()));
    const QSet<QString> expected = {"devices",       "signals",  "recordings", "monitor", "monitor2",
                                    "monitor3",      "spectrum", "xy",         "record",  "parameters",
                                    "configuration", "log",      "derived",    "notes"};
    EXPECT_EQ(offered(), expected);
}

TEST_F(PanelOfferTest, everyPerspectiveNamesItsMainPanel) {
    for (const Perspective perspective : AllPerspectives) {
        bool isThere = false;
        for (const PanelSpec& spec : panelSpecs()) {
            const auto& in = spec.perspectives;
            isThere =
                isThere || (mainPanels(perspective).contains(spec.id) && spec.area == PanelArea::Centre &&
                            std::find(in.begin(), in.end(), perspective) != in.end());
        }
        EXPECT_TRUE(isThere) << perspectiveId(perspective).toStdString();
    }
}

} // namespace
} // namespace halbench::app
