#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/loop/loop_sliders.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "control/base/units.h"
#include "tests/app/workspaces/tune/tune_panel_fixture.h"

#include <QAction>
#include <QMouseEvent>
#include <QSlider>

#include <numeric>

namespace halbench::app {
namespace {

class TuneShapingTest : public TunePanelTest {
protected:
    void identify() {
        bench.setIdentification(publishedMotor());
        ASSERT_TRUE(wait([&] { return bench.design().has_value(); }));
    }
    widgets::FigureView& picture() { return panel.findChild<LoopView*>()->picture(); }
    QSlider* slider(const char* name) { return panel.findChild<QSlider*>(name); }
    QString note() {
        for (const auto* label : panel.findChild<LoopSliders*>()->findChildren<QLabel*>()) {
            if (label->wordWrap()) {
                return label->text();
            }
        }
        return {};
    }
    void mouse(QEvent::Type type, const QPoint& at, Qt::MouseButton button, Qt::MouseButtons buttons) {
        QMouseEvent event(type, QPointF(at), button, buttons, Qt::NoModifier);
        QApplication::sendEvent(&picture(), &event);
    }
    void take(int handle) {
        m_at = picture().handlePlace(handle).value();
        mouse(QEvent::MouseButtonPress, m_at, Qt::LeftButton, Qt::LeftButton);
        ASSERT_TRUE(picture().isHeld());
    }
    void moveBy(const QPoint& way) {
        m_at += way;
        mouse(QEvent::MouseMove, m_at, Qt::NoButton, Qt::LeftButton);
    }
    void release() { mouse(QEvent::MouseButtonRelease, m_at, Qt::LeftButton, Qt::NoButton); }

    control::StabilityMargins margins() { return bench.design()->predicted.margins; }
    /// The design of the gains in the fields.
    bool isJudged() {
        return wait([&] {
            return bench.design() && shown("gain.kp") > 0.0 &&
                   std::abs(bench.design()->law.gains.proportional / shown("gain.kp") - 1.0) < 1e-6;
        });
    }
    QAction* undo() { return panel.historyActions().front(); }
    QAction* redo() { return panel.historyActions().back(); }

    QPoint m_at;
};

TEST_F(TuneShapingTest, theCrossoverIsDraggedAndEveryPictureFollowsBeforeItIsReleased) {
    prepare();
    const auto onDevice = valuesNow();
    const double before_rad_s = *margins().gainCrossover_rad_s;
    const double margin_deg = margins().phaseMargin_deg;
    const auto bode = picture().figure().panels.at(0).curves.at(0).y;
    const auto step = curve("Predicted step with", "proposed");
    const auto axis = picture().figure().panels.at(0).y;
    take(0);
    moveBy({-40, 3}); // only across counts
    EXPECT_LT(shown("gain.kp"), 40.0);
    EXPECT_FALSE(canApply()); // not before what is seen is judged
    ASSERT_TRUE(wait([&] { return picture().figure().panels.at(0).curves.at(0).y != bode; }));
    EXPECT_NE(curve("Predicted step with", "proposed"), step);
    EXPECT_TRUE(picture().isHeld());
    EXPECT_TRUE(picture().figure().panels.at(0).y.min.has_value()); // held still
    release();
    ASSERT_TRUE(isJudged());
    EXPECT_FALSE(picture().figure().panels.at(0).y.min.has_value());
    EXPECT_LT(*margins().gainCrossover_rad_s, 0.9 * before_rad_s);
    EXPECT_NEAR(margins().phaseMargin_deg, margin_deg, 1e-3);
    EXPECT_EQ(bench.design()->method, "edited");
    EXPECT_EQ(valuesNow(), onDevice); // applying is another act
}

TEST_F(TuneShapingTest, whatIsDraggedComesToWhereThePointerIs) {
    identify();
    take(0);
    moveBy({-30, 0});
    release();
    ASSERT_TRUE(isJudged());
    EXPECT_LE(std::abs(picture().handlePlace(0)->x() - m_at.x()), 1);
}

TEST_F(TuneShapingTest, thePhaseMarginIsDraggedAtItsCrossover) {
    identify();
    const double crossover_rad_s = *margins().gainCrossover_rad_s;
    const double before_deg = margins().phaseMargin_deg;
    take(1);
    moveBy({5, -6}); // up: more margin
    release();
    ASSERT_TRUE(isJudged());
    EXPECT_GT(margins().phaseMargin_deg, before_deg + 1.0);
    EXPECT_NEAR(*margins().gainCrossover_rad_s, crossover_rad_s, 1e-4 * crossover_rad_s);
}

TEST_F(TuneShapingTest, howeverManyMovesADragIsOneStepBackAndForth) {
    identify();
    EXPECT_FALSE(undo()->isEnabled());
    take(0);
    for (int i = 0; i < 25; ++i) { // faster than any worker
        moveBy({-1, 0});
    }
    release();
    ASSERT_TRUE(isJudged());
    const double dragged = shown("gain.kp");
    EXPECT_LT(dragged, 39.0);
    EXPECT_EQ(undo()->text(), "&Undo: Move the crossover");
    EXPECT_FALSE(redo()->isEnabled());
    undo()->trigger();
    EXPECT_TRUE(wait([&] { return std::abs(shown("gain.kp") - 40.0) < 1e-4; }));
    EXPECT_EQ(panel.findChild<TuneForm*>()->method(), "recommended");
    EXPECT_FALSE(undo()->isEnabled());
    redo()->trigger();
    EXPECT_NEAR(shown("gain.kp"), dragged, 1e-9);
}

TEST_F(TuneShapingTest, theSlidersAreMovedByTheKeyboardAndSayWhatTheLoopHas) {
    identify();
    const double before_rad_s = *margins().gainCrossover_rad_s;
    QSlider* speed = slider("speed");
    ASSERT_TRUE(speed->isEnabled());
    EXPECT_EQ(speed->accessibleName(), "Speed: gain crossover");
    EXPECT_EQ(speed->accessibleDescription(), "7.27 Hz"); // 45.7 rad/s (htm-theory.md 8.4)
    EXPECT_EQ(slider("robustness")->accessibleDescription(), "37.9\u00b0");
    speed->setFocus();
    QTest::keyClick(speed, Qt::Key_Left);
    ASSERT_TRUE(isJudged());
    // A step of the keyboard is 2 %, a place of the slider 0.3 %.
    EXPECT_NEAR(*margins().gainCrossover_rad_s / before_rad_s, 1.0 / 1.02, 0.004);
    slider("robustness")->setFocus();
    QTest::keyClick(slider("robustness"), Qt::Key_Right);
    ASSERT_TRUE(wait([&] { return margins().phaseMargin_deg > 38.7; }));
    EXPECT_NEAR(margins().phaseMargin_deg, 38.9, 0.06);
    EXPECT_EQ(undo()->text(), "&Undo: Move the phase margin");
}

TEST_F(TuneShapingTest, theHandlesAreMovedByTheKeyboardToo) {
    identify();
    EXPECT_TRUE(picture().accessibleDescription().contains("gain crossover, phase margin"))
        << picture().accessibleDescription().toStdString();
    const double before_rad_s = *margins().gainCrossover_rad_s;
    picture().setFocus();
    QTest::keyClick(&picture(), Qt::Key_Left, Qt::ControlModifier);
    ASSERT_TRUE(isJudged());
    EXPECT_NEAR(*margins().gainCrossover_rad_s, before_rad_s / 1.02, 1e-4 * before_rad_s);
    const double before_deg = margins().phaseMargin_deg;
    QTest::keyClick(&picture(), Qt::Key_Up, Qt::ControlModifier);
    ASSERT_TRUE(wait([&] { return margins().phaseMargin_deg > before_deg + 0.5; }));
    EXPECT_NEAR(margins().phaseMargin_deg, before_deg + 1.0, 1e-4);
}

TEST_F(TuneShapingTest, whatCannotBeReachedIsSaidInPlaceAndTheLoopStaysStable) {
    identify();
    QSlider* speed = slider("speed");
    speed->setFocus();
    QTest::keyClick(speed, Qt::Key_End);
    EXPECT_TRUE(note().startsWith("Limited to ")) << note().toStdString();
    ASSERT_TRUE(isJudged());
    EXPECT_TRUE(bench.design()->predicted.isStable);
    EXPECT_GE(margins().phaseMargin_deg, 37.8); // the margin is kept
    EXPECT_GE(margins().gainMargin_ratio, 1.49);
    EXPECT_LT(speed->value(), speed->maximum()); // back to where the loop is
    type("gain.kp", "30");
    EXPECT_EQ(note(), QString()); // something else was done
}

TEST_F(TuneShapingTest, aPoleIsDraggedAlongItsBranch) {
    identify();
    choose("Open-loop plot", "Root locus");
    const auto poles = bench.design()->predicted.roots.closedLoop;
    ASSERT_EQ(picture().handles().size(),
              static_cast<std::size_t>(
                  std::count_if(poles.begin(), poles.end(), [](auto pole) { return pole.imag() >= -1e-9; })));
    const auto handles = picture().handles();
    const auto pair = std::max_element(handles.begin(), handles.end(),
                                       [](const auto& one, const auto& other) { return one.y < other.y; });
    take(static_cast<int>(pair - handles.begin()));
    moveBy({-20, -60}); // further along the branch
    release();
    ASSERT_TRUE(isJudged());
    const auto& gains = bench.design()->law.gains;
    EXPECT_GT(std::abs(gains.proportional - 40.0), 1.0);
    EXPECT_NEAR(gains.integral / gains.proportional, 60.0 / 40.0, 1e-6); // all of them together
    EXPECT_NEAR(gains.derivative / gains.proportional, 1.4 / 40.0, 1e-6);
    EXPECT_TRUE(bench.design()->predicted.isStable);
    EXPECT_EQ(undo()->text(), "&Undo: Move a pole");
}

TEST_F(TuneShapingTest, noPullMakesTheLoopUnstable) {
    identify();
    choose("Open-loop plot", "Root locus");
    for (const QPoint& way : {QPoint{400, 0}, {-600, 0}, {0, -600}, {0, 900}}) {
        for (int handle = 0; handle < static_cast<int>(picture().handles().size()); ++handle) {
            if (!picture().handlePlace(handle)) {
                continue;
            }
            take(handle);
            moveBy(way);
            release();
            ASSERT_TRUE(isJudged());
            EXPECT_TRUE(bench.design()->predicted.isStable) << handle << " " << way.x() << " " << way.y();
            EXPECT_TRUE(std::isfinite(shown("gain.kp")));
        }
    }
}

TEST_F(TuneShapingTest, theBandOfTheMotorsFollowsWhileSomethingIsHeldAndTheLargeStepsComesAfterwards) {
    identify();
    const std::string band = "5-95 % band (motor uncertainty)";
    ASSERT_TRUE(wait([&] { return !curve("Predicted step with", band).empty(); }));
    const auto before = curve("Open loop", band);
    ASSERT_FALSE(before.empty());
    take(0);
    moveBy({-30, 0});
    ASSERT_TRUE(wait([&] { return curve("Open loop", band) != before; }));
    EXPECT_FALSE(curve("Predicted step of", band).empty());
    release();
    ASSERT_TRUE(isJudged());
    EXPECT_TRUE(wait([&] { return !curve("Predicted step with", band).empty(); }));
}

TEST_F(TuneShapingTest, withoutALoopThereIsNothingToShape) {
    EXPECT_FALSE(slider("speed")->isEnabled());
    identify();
    EXPECT_TRUE(slider("speed")->isEnabled());
    bench.setIdentification(std::nullopt);
    EXPECT_FALSE(slider("speed")->isEnabled());
}

TEST_F(TuneShapingTest, editsMethodsAndTargetsAreTakenBackInOrder) {
    identify();
    type("gain.kp", "20");
    ASSERT_TRUE(isJudged());
    EXPECT_EQ(undo()->text(), "&Undo: Edit Proportional K_P"); // two keys, one step
    choose("Source of the gains", "Method: bandwidth");
    type("bandwidth-hz", "6");
    ASSERT_TRUE(wait([&] { return bench.design() && bench.design()->targets.bandwidth_Hz == 6.0; }));
    QApplication::setActiveWindow(&panel);
    QTest::keyClick(edit("bandwidth-hz"), Qt::Key_Z, Qt::ControlModifier); // of the gains, not of the text
    // The arrow keys passed through the methods before bandwidth; each was one.
    while (panel.findChild<TuneForm*>()->origin() != TuneForm::Origin::Edited) {
        ASSERT_TRUE(undo()->isEnabled());
        undo()->trigger();
    }
    EXPECT_NEAR(shown("gain.kp"), 20.0, 1e-12);
    undo()->trigger();
    EXPECT_TRUE(wait([&] { return std::abs(shown("gain.kp") - 40.0) < 1e-4; }));
    EXPECT_FALSE(undo()->isEnabled());
}

TEST_F(TuneShapingTest, anotherMotorHasAnotherHistory) {
    identify();
    type("gain.kp", "20");
    ASSERT_TRUE(isJudged());
    EXPECT_TRUE(undo()->isEnabled());
    bench.setIdentification(publishedMotor());
    EXPECT_FALSE(undo()->isEnabled());
    EXPECT_NEAR(shown("gain.kp"), 20.0, 1e-12); // the gains themselves stay
}

} // namespace
} // namespace halbench::app
