#include "app/procedures/move/move_procedure.h"
#include "app/workspaces/analysis/xy_panel.h"
#include "app/workspaces/parts/signal_box.h"
#include "tests/app/workspaces/bench_fixture.h"
#include "widgets/controls/estimate_table.h"
#include "widgets/figure/figure_view.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalSpy>

#include <algorithm>

namespace halbench::app {
namespace {

class XyPanelTest : public BenchTest {
protected:
    void SetUp() override {
        BenchTest::SetUp();
        panel = std::make_unique<XyPanel>(bench());
        panel->resize(700, 800);
        panel->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(panel.get()));
    }
    void TearDown() override { panel.reset(); }

    void turn() {
        session().runProcedure(
            "Move",
            [](devices::Device& device, const ProcedureObserver& observer) {
                MoveConfig config;
                config.reference = *parseMoveReference("ramp,rate_deg_s=720");
                config.duration_s = 20.0;
                return runMove(device, config, observer);
            },
            [](const Result<MoveResult>& moved) {
                EXPECT_TRUE(moved || moved.error().code == ErrorCode::Interrupted) << moved.error().message;
            });
    }
    widgets::FigureView& view() { return *panel->findChild<widgets::FigureView*>(); }
    widgets::EstimateTable& numbers() { return *panel->findChild<widgets::EstimateTable*>(); }
    QString words() { return find<QLabel>(*panel, "Summary of the ellipse")->text(); }

    std::unique_ptr<XyPanel> panel;
};

TEST_F(XyPanelTest, withoutADeviceItOffersTheSimulatedMotor) {
    QSignalSpy asked(panel.get(), &XyPanel::connectRequested);
    click(*panel, "Connect the simulated motor");
    EXPECT_EQ(asked.count(), 1);
}

TEST_F(XyPanelTest, aMotorAtRestHasPointsButNoEllipseAndSaysWhy) {
    connectTo("sim:htm", 5.0);
    ASSERT_TRUE(wait([&] { return !view().isEmpty(); }));
    EXPECT_TRUE(view().figure().isEqualScale);
    EXPECT_TRUE(wait([&] { return !words().isEmpty(); }));
    EXPECT_FALSE(numbers().isVisible());
    find<QCheckBox>(*panel, "Ellipse")->click();
    EXPECT_TRUE(wait([&] { return words().isEmpty(); }));
}

TEST_F(XyPanelTest, theHallSensorsOfATurningMotorLieOnAnEllipse) {
    connectTo("sim:htm", 0.0); // as fast as possible: a busy machine changes nothing
    turn();
    ASSERT_TRUE(wait([&] { return numbers().isVisible(); })) << words().toStdString();
    ASSERT_EQ(numbers().rowCount(), 5);
    EXPECT_EQ(view().figure().panels.at(0).curves.size(), 2U);
    EXPECT_TRUE(words().contains("Semi-axes")) << words().toStdString();
    // The curve goes through the cloud: the extremes of both agree to the noise and the ellipse's own error.
    const auto& curves = view().figure().panels.at(0).curves;
    const auto largest = [](const std::vector<double>& values) {
        return *std::max_element(values.begin(), values.end());
    };
    EXPECT_NEAR(largest(curves[0].x), largest(curves[1].x), 0.05 * largest(curves[1].x));
    EXPECT_NEAR(largest(curves[0].y), largest(curves[1].y), 0.05 * largest(curves[1].y));
}

TEST_F(XyPanelTest, signalsOfOtherUnitsHaveTheirOwnScales) {
    connectTo("sim:htm", 5.0);
    panel->findChildren<SignalBox*>().at(1)->choose("speed");
    EXPECT_TRUE(wait([&] { return !view().isEmpty() && !view().figure().isEqualScale; }));
}

} // namespace
} // namespace halbench::app
