// No curve of before: what is kept between two predictions is not kept beyond what it is of.
#include "app/documents/result_documents.h"
#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

#include <QMouseEvent>

namespace halbench::app {
namespace {

constexpr const char* Bode = "Open loop";
constexpr const char* LargeStep = "Predicted step with";
constexpr const char* SmallStep = "Predicted step of";
constexpr const char* Load = "Load step equal";

class TuneFreshCurvesTest : public TunePanelTest {
protected:
    void write(const std::string& name, double value) {
        bool isDone = false;
        bench.writeValues({{name, value}},
                          [&](const Result<void>& written) { isDone = written.has_value(); });
        ASSERT_TRUE(wait([&] { return isDone && bench.deviceValue(name) == value; }));
    }
    /// What the same gains look like in an analysis of their own.
    std::vector<double> ofAnalysis(const control::PositionLaw& law) {
        LoopConditions conditions = bench.design()->conditions;
        return runAnalysis(motorEstimate(*bench.identification()), law, conditions)->bode.magnitude_dB;
    }
    control::PositionLaw onDevice() { return *lawFromParameters(bench.deviceValues()); }
    bool isDrawn(const std::string& label, const control::PositionLaw& law) {
        return wait([&] { return bench.design() && curve(Bode, label) == ofAnalysis(law); });
    }
    widgets::FigureView& picture() { return panel.findChild<LoopView*>()->picture(); }
    void mouse(QEvent::Type type, const QPoint& at, Qt::MouseButton button, Qt::MouseButtons buttons) {
        QMouseEvent event(type, QPointF(at), button, buttons, Qt::NoModifier);
        QApplication::sendEvent(&picture(), &event);
    }
    KeptDesign kept(double proportional) {
        TuneResult design = *bench.design();
        design.law.gains.proportional = proportional;
        return keptDesign("kept", *toJsonText(gainsDocument(bench.designHeader(), design)));
    }
};

TEST_F(TuneFreshCurvesTest, otherGainsOnTheDeviceAreDrawnWhereverTheyComeFrom) {
    prepare();
    ASSERT_TRUE(isDrawn("before", onDevice()));
    const auto step = curve(LargeStep, "before");
    write("gain.kp", 14.0);
    ASSERT_TRUE(isDrawn("before", onDevice()));
    EXPECT_NE(curve(LargeStep, "before"), step);
    type("gain.kp", "33"); // and stay while the proposed ones change
    ASSERT_TRUE(wait([&] { return bench.design() && bench.design()->law.gains.proportional == 33.0; }));
    EXPECT_TRUE(isDrawn("before", onDevice()));
    bench.session().disconnectDevice();
    ASSERT_TRUE(wait([&] { return curve(Bode, "before").empty(); }));
    connectMotor("sim:htm?seed=5", 0.0); // a board with the gains that it is delivered with
    ASSERT_EQ(onDevice().gains.proportional, 10.0);
    EXPECT_TRUE(isDrawn("before", onDevice()));
}

TEST_F(TuneFreshCurvesTest, anotherMotorHasOtherCurvesOfTheSameGains) {
    prepare();
    panel.setSavedDesigns({kept(30.0)});
    control::PositionLaw law = bench.design()->law;
    law.gains.proportional = 30.0;
    ASSERT_TRUE(isDrawn("kept", law));
    ASSERT_TRUE(isDrawn("before", onDevice()));
    const auto before = curve(Bode, "before");
    const auto band = curve(Bode, "5-95 % band (motor uncertainty)");
    IdentifyResult stronger = publishedMotor();
    stronger.ratios["phi_over_J"].value = 2.0 * *stronger.ratios["phi_over_J"].value;
    stronger.torqueConstant.value = 2.0 * *stronger.torqueConstant.value;
    bench.setIdentification(stronger);
    ASSERT_TRUE(wait([&] { return curve(Bode, "before") != before; }));
    EXPECT_TRUE(isDrawn("before", onDevice()));
    EXPECT_TRUE(isDrawn("kept", law));
    EXPECT_NE(curve(Bode, "5-95 % band (motor uncertainty)"), band);
}

TEST_F(TuneFreshCurvesTest, aKeptDesignThatBecomesAnotherIsDrawnAsThat) {
    prepare();
    control::PositionLaw law = bench.design()->law;
    for (const double proportional : {30.0, 22.0}) {
        panel.setSavedDesigns({kept(proportional)}); // under the same name
        law.gains.proportional = proportional;
        EXPECT_TRUE(isDrawn("kept", law)) << proportional;
    }
}

// The view of the loop that is chosen in the middle of a drag, and the pictures behind other buttons.
TEST_F(TuneFreshCurvesTest, whatComesToSightDuringADragIsOfTheGainsInTheHand) {
    prepare();
    const auto small = curve(SmallStep, "proposed");
    const auto load = curve(Load, "proposed");
    ASSERT_FALSE(small.empty() || load.empty());
    QPoint at = picture().handlePlace(0).value();
    mouse(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
    const auto bode = picture().figure().panels.at(0).curves.at(0).y;
    at += QPoint(-40, 0);
    mouse(QEvent::MouseMove, at, Qt::NoButton, Qt::LeftButton);
    ASSERT_TRUE(wait([&] { return picture().figure().panels.at(0).curves.at(0).y != bode; }));
    EXPECT_NE(curve(SmallStep, "proposed"), small);
    EXPECT_NE(curve(Load, "proposed"), load);
    auto* views = panel.findChild<LoopView*>();
    views->setView(LoopView::View::Nichols); // runs along the same magnitudes
    const auto dragged = picture().figure().panels.at(0).curves.at(0).y;
    EXPECT_FALSE(dragged.empty());
    EXPECT_NE(dragged, bode);
    views->setView(LoopView::View::Bode);
    EXPECT_EQ(picture().figure().panels.at(0).curves.at(0).y, dragged);
    mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton);
    ASSERT_TRUE(wait([&] { return canApply(); }));
    EXPECT_EQ(curve(Bode, "proposed"), ofAnalysis(bench.design()->law));
}

TEST_F(TuneFreshCurvesTest, everyViewOfTheLoopIsOfTheGainsAsTheyAre) {
    prepare();
    auto* views = panel.findChild<LoopView*>();
    for (const auto view : {LoopView::View::Nyquist, LoopView::View::Nichols, LoopView::View::Sensitivity,
                            LoopView::View::RootLocus, LoopView::View::Bode}) {
        views->setView(view);
        const auto before = picture().figure().panels.at(0).curves;
        const double next = bench.design()->law.gains.proportional - 2.0;
        type("gain.kp", QByteArray::number(next).constData());
        ASSERT_TRUE(wait([&] { return bench.design() && bench.design()->law.gains.proportional == next; }));
        const auto after = picture().figure().panels.at(0).curves;
        ASSERT_EQ(after.size(), before.size());
        const auto isSame = [](const widgets::Curve& one, const widgets::Curve& other) {
            return one.x == other.x && one.y == other.y;
        };
        EXPECT_FALSE(std::equal(after.begin(), after.end(), before.begin(), isSame)) << int(view);
    }
    EXPECT_EQ(curve(Bode, "proposed"), ofAnalysis(bench.design()->law));
}

} // namespace
} // namespace halbench::app
