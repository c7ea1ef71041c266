#include "app/wizards/axes_frequency_panel.h"
#include "app/wizards/axes_identify_panel.h"
#include "app/wizards/calibrate_panel.h"
#include "app/wizards/frequency_panel.h"
#include "app/wizards/identify_panel.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/estimate_table.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

namespace halbench::app {
namespace {

class AxesIdentifyPanelTest : public BenchTest {
protected:
    void open(QWidget& panel) {
        panel.resize(900, 700);
        panel.show();
        connectTo("sim:planar", 0.0);
    }
    static AxesIdentifyPanel* axesOf(IdentifyPanel& panel) { return panel.findChild<AxesIdentifyPanel*>(); }
};

TEST_F(AxesIdentifyPanelTest, aDeviceWithSeveralAxesHasItsOwnFormAndTheMotorItsOwn) {
    IdentifyPanel panel(bench());
    open(panel);
    ASSERT_NE(axesOf(panel), nullptr);
    EXPECT_TRUE(axesOf(panel)->isVisible());
    EXPECT_EQ(find<QComboBox>(*axesOf(panel), "Axes of the model")->count(), 4); // all, x, y, phi
    find<QLineEdit>(*axesOf(panel), "Moving mass");
    find<QLineEdit>(*axesOf(panel), "Inertia about the vertical");
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    connectTo("sim:htm", 0.0);
    EXPECT_FALSE(axesOf(panel)->isVisible());
}

TEST_F(AxesIdentifyPanelTest, twoGivenConstantsAreRefusedBeforeAnythingMoves) {
    IdentifyPanel panel(bench());
    open(panel);
    AxesIdentifyPanel& axes = *axesOf(panel);
    auto* start = find<QAbstractButton>(axes, "Start identification");
    ASSERT_TRUE(wait([&] { return start->isEnabled(); }));
    QTest::keyClicks(find<QLineEdit>(axes, "Moving mass"), "0.64");
    EXPECT_TRUE(start->isEnabled());
    QTest::keyClicks(find<QLineEdit>(axes, "Inertia about the vertical"), "0.001");
    EXPECT_FALSE(start->isEnabled());
}

// resources/help/planar-theory.md section 3: 0.64 kg; the acceleration per newton is its inverse.
TEST_F(AxesIdentifyPanelTest, theModelOfEveryAxisComesWithIntervals) {
    IdentifyPanel panel(bench());
    open(panel);
    std::optional<AxisModelFile> model;
    QObject::connect(&panel, &IdentifyPanel::axesIdentified, &panel,
                     [&](const AxisModelFile& found) { model = found; });
    AxesIdentifyPanel& axes = *axesOf(panel);
    auto* start = find<QAbstractButton>(axes, "Start identification");
    ASSERT_TRUE(wait([&] { return start->isEnabled(); }));
    QTest::mouseClick(start, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return model.has_value(); }));
    ASSERT_EQ(model->model.axes.size(), 3U);
    ASSERT_TRUE(model->header.device);
    EXPECT_EQ(model->header.device->model, "planar");
    for (const IdentifiedAxis& axis : model->model.axes) {
        ASSERT_TRUE(axis.accelerationGain.value) << axis.axis;
        EXPECT_TRUE(axis.accelerationGain.interval95) << axis.axis;
    }
    auto* table = axes.findChild<widgets::EstimateTable*>();
    EXPECT_GE(table->rowCount(), 9); // three of each axis, and the constants
    EXPECT_TRUE(table->text().contains("acceleration per effort"));
    EXPECT_TRUE(find<QAbstractButton>(axes, "Tune with this model")->isEnabled());
}

// Disarmed, the platen brakes for 0.3 s of its own time, which does not pass between two procedures in
// virtual time; the board homes none that is driven.
TEST_F(AxesIdentifyPanelTest, anUnhomedPlatenIsIdentifiedRightAfterAnotherProcedure) {
    IdentifyPanel panel(bench());
    FrequencyPanel response(bench());
    open(panel);
    response.show();
    auto* other = find<QAbstractButton>(*response.findChild<AxesFrequencyPanel*>(), "Start measurement");
    ASSERT_TRUE(wait([&] { return other->isEnabled(); }));
    QTest::mouseClick(other, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return session().report().board.isArmed; }));
    session().abortProcedure();
    ASSERT_TRUE(wait([&] { return session().procedure().isEmpty(); }));
    bool isFound = false;
    QObject::connect(&panel, &IdentifyPanel::axesIdentified, &panel, [&] { isFound = true; });
    auto* start = find<QAbstractButton>(*axesOf(panel), "Start identification");
    ASSERT_TRUE(wait([&] { return start->isEnabled(); }));
    QTest::mouseClick(start, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return session().procedure().isEmpty() && (isFound || start->isVisible()); }));
    EXPECT_TRUE(isFound);
}

TEST_F(AxesIdentifyPanelTest, calibrationOffersWhatTheActuatorHas) {
    CalibratePanel panel(bench());
    open(panel);
    const auto choice = [&](const char* text) { return find<QCheckBox>(panel, text); };
    EXPECT_TRUE(wait([&] { return !choice("Static friction")->isVisible(); })); // air has none
    EXPECT_TRUE(choice("Hall sensors")->isVisible());
    EXPECT_TRUE(choice("Stray field of the coils")->isVisible());
}

TEST_F(AxesIdentifyPanelTest, calibrationOfTheChipsIsAppliedToTheBoard) {
    CalibratePanel panel(bench());
    open(panel);
    const double before = parameter("chip.gain_x_1");
    auto* start = find<QAbstractButton>(panel, "Start calibration");
    ASSERT_TRUE(wait([&] { return start->isEnabled(); }));
    QTest::mouseClick(start, Qt::LeftButton);
    auto* apply = find<QAbstractButton>(panel, "Apply");
    ASSERT_TRUE(wait([&] { return apply->isVisible() && apply->isEnabled(); }));
    auto* table = panel.findChild<widgets::EstimateTable*>();
    EXPECT_TRUE(table->text().contains("chip 1: gain error along x'"));
    QTest::mouseClick(apply, Qt::LeftButton);
    EXPECT_TRUE(wait([&] { return parameter("chip.gain_x_1") != before; })); // drawn with a spread of 1 %
}

} // namespace
} // namespace halbench::app
