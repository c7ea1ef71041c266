#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/gain_settings.h"
#include "app/workspaces/tune/loop/loop_sliders.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "app/workspaces/tune/loop_shaping.h"
#include "app/workspaces/tune/tune_messages.h"
#include "tests/app/workspaces/panel_fixture.h"
#include "tests/app/workspaces/published_motor.h"

namespace halbench::app {
namespace {

class LoopShapingTest : public PanelTest {
protected:
    void SetUp() override {
        PanelTest::SetUp();
        QObject::connect(&shaping, &LoopShaping::moved, &shaping, [this] {
            ++moves;
            ask();
        });
        QObject::connect(&shaping, &LoopShaping::released, &shaping, [this] { ++releases; });
        bench.setIdentification(publishedMotor());
        session.readConditions({});
        ask();
        ASSERT_TRUE(wait([&] { return session.proposed().has_value(); }));
    }
    void ask() { session.ask(settings.source(), nullptr); }
    double crossover_rad_s() const { return *session.sketch()->predicted.margins.gainCrossover_rad_s; }
    double proportional() const { return settings.editedLaw()->law.gains.proportional; }

    TuneSession session{bench};
    widgets::MessageBar bar;
    TuneMessages messages{bar};
    GainSettings settings{bench, session, messages};
    LoopView view;
    LoopShaping shaping{bench, session, settings, view};
    int moves = 0;
    int releases = 0;
};

TEST_F(LoopShapingTest, gainsFollowTheCrossoverAndOneDragIsOneStep) {
    const double before = crossover_rad_s();
    Q_EMIT settings.sliders().taken();
    EXPECT_TRUE(session.isMoving());
    Q_EMIT settings.sliders().crossoverMoved(1.1 * before);
    EXPECT_EQ(moves, 1);
    EXPECT_TRUE(settings.isEdited());
    ASSERT_TRUE(wait([&] { return !session.isSketching(); }));
    EXPECT_NEAR(crossover_rad_s(), 1.1 * before, 1e-3 * before); // as fine as the board counts
    Q_EMIT settings.sliders().crossoverMoved(1.2 * before);
    Q_EMIT settings.sliders().released();
    EXPECT_FALSE(session.isMoving());
    EXPECT_EQ(releases, 1);
    EXPECT_EQ(settings.history().undo().text(), "&Undo: Move the crossover");
    settings.history().undo().trigger();
    EXPECT_FALSE(settings.isEdited()) << "both moves are undone";
}

TEST_F(LoopShapingTest, moveWaitsForThePictureOfTheOneBefore) {
    const double before = crossover_rad_s();
    Q_EMIT settings.sliders().taken();
    Q_EMIT settings.sliders().crossoverMoved(1.05 * before);
    Q_EMIT settings.sliders().crossoverMoved(1.1 * before);
    Q_EMIT settings.sliders().crossoverMoved(1.2 * before);
    EXPECT_EQ(moves, 1);
    ASSERT_TRUE(wait([&] { return !session.isSketching(); }));
    shaping.takeWaiting();
    EXPECT_EQ(moves, 2) << "the last one alone";
    ASSERT_TRUE(wait([&] { return !session.isSketching(); }));
    EXPECT_NEAR(crossover_rad_s(), 1.2 * before, 1e-3 * before);
}

TEST_F(LoopShapingTest, otherGainsEndTheDrag) {
    Q_EMIT settings.sliders().taken();
    settings.choose("lqr", {});
    EXPECT_FALSE(session.isMoving());
    Q_EMIT settings.sliders().released();
    EXPECT_EQ(releases, 0);
}

TEST_F(LoopShapingTest, poleScalesAllGainsAndStaysStable) {
    settings.edit(session.sketch()->loopLaw());
    const double before = proportional();
    Q_EMIT view.gainMoved(1.1);
    EXPECT_NEAR(proportional(), 1.1 * before, 1e-6 * before);
    ASSERT_TRUE(wait([&] { return !session.isSketching(); }));
    Q_EMIT view.gainMoved(1000.0);
    EXPECT_LT(proportional(), 1000.0 * before);
}

} // namespace
} // namespace halbench::app
