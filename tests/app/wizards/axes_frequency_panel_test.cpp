#include "app/procedures/frequency/axes_frequency.h"
#include "app/wizards/axes_frequency_panel.h"
#include "app/wizards/axes_frequency_text.h"
#include "app/wizards/frequency_panel.h"
#include "app/workspaces/tune/axes/axis_loops.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "tests/app/workspaces/tune/axes/axis_model_fixture.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/controls/verdict_view.h"

#include <QComboBox>
#include <QLineEdit>
#include <QTabWidget>

namespace halbench::app {
namespace {

class AxesFrequencyPanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<FrequencyPanel>(bench());
        panel->resize(1000, 700);
        panel->show();
        connectTo("sim:planar?imperfections=off", 0.0);
        axes = panel->findChild<AxesFrequencyPanel*>();
        ASSERT_NE(axes, nullptr);
        start = find<QAbstractButton>(*axes, "Start measurement");
        ASSERT_TRUE(wait([&] { return start->isEnabled(); }));
    }
    void TearDown() override { panel.reset(); }

    void enter(const char* field, const char* text) {
        auto* edit = find<QLineEdit>(*axes, field);
        edit->clear();
        QTest::keyClicks(edit, text);
    }
    bool isFound() { return !axes->findChild<widgets::VerdictView*>()->text().isEmpty() && hasResult(); }
    bool hasResult() {
        const auto* table = axes->findChild<widgets::EstimateTable*>();
        return table->isVisible() && table->rowCount() > 0;
    }

    std::unique_ptr<FrequencyPanel> panel;
    AxesFrequencyPanel* axes = nullptr;
    QAbstractButton* start = nullptr;
};

TEST_F(AxesFrequencyPanelTest, listsTheAxesAndGivesPlaceToTheMotor) {
    EXPECT_TRUE(axes->isVisible());
    EXPECT_EQ(find<QComboBox>(*axes, "Excited axes")->count(), 4); // all at once, x, y, phi
    session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return session().state() == SessionState::Disconnected; }));
    connectTo("sim:htm", 0.0);
    EXPECT_FALSE(axes->isVisible());
}

TEST_F(AxesFrequencyPanelTest, anImpossibleBandCannotBeStarted) {
    enter("Highest frequency [Hz]", "0.5"); // below the lowest
    EXPECT_FALSE(start->isEnabled());
    enter("Highest frequency [Hz]", "40");
    EXPECT_TRUE(start->isEnabled());
}

TEST_F(AxesFrequencyPanelTest, cancellingRestoresAndReturnsToTheSettings) {
    const double kp = parameter("gain.x.kp");
    QTest::mouseClick(start, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return !session().procedure().isEmpty(); }));
    session().abortProcedure();
    ASSERT_TRUE(wait([&] { return session().procedure().isEmpty() && start->isVisible(); }));
    EXPECT_FALSE(hasResult());
    EXPECT_FALSE(session().report().board.isArmed);
    EXPECT_EQ(parameter("gain.x.kp"), kp);
}

// Without imperfections the platen is the published free mass: the margin that its gains have on that model
// is a second route to what is measured. 2 degrees is what a margin may be wrong by before it is withheld.
TEST_F(AxesFrequencyPanelTest, measuredPhaseMarginsAreThoseOfTheModel) {
    AxisLoops loops;
    loops.setModel(platenModelFile());
    ASSERT_TRUE(wait([&] { return bench().deviceValues().count("gain.phi.kp") > 0; }));
    ASSERT_TRUE(loops.readDevice(session().catalogue(), bench().deviceValues()));
    QTest::mouseClick(start, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return isFound(); }));
    const auto* table = axes->findChild<widgets::EstimateTable*>();
    ASSERT_EQ(table->rowCount(), 8); // two margins of three axes, peaks of S and T
    for (const auto& [axis, row] : {std::pair("x", 0), std::pair("y", 2), std::pair("phi", 4)}) {
        AxisChoice& choice = loops.choice(axis);
        choice.method = "device";
        choice.law = loops.present(axis);
        ASSERT_TRUE(choice.law) << axis;
        const auto answer = answerAxis(*loops.question(axis));
        ASSERT_TRUE(answer) << axis;
        const double expected_deg = answer->proposed.predicted.margins.phaseMargin_deg;
        const double measured_deg = table->item(row, 1)->text().toDouble();
        EXPECT_NEAR(measured_deg, expected_deg, 2.0) << axis;
    }
    const auto* tabs = axes->findChild<QTabWidget*>();
    EXPECT_EQ(tabs->count(), 3);
    EXPECT_TRUE(tabs->isTabEnabled(1));
}

} // namespace
} // namespace halbench::app
