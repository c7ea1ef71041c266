#include "app/workbench/shared_results.h"
#include "app/workspaces/tune/tune_session.h"
#include "tests/app/workspaces/panel_fixture.h"
#include "tests/app/workspaces/published_motor.h"

#include <QStringList>

namespace halbench::app {
namespace {

class TuneSessionTest : public PanelTest {
protected:
    void SetUp() override {
        PanelTest::SetUp();
        note(&TuneSession::sketched, "sketched");
        note(&TuneSession::judged, "judged");
        note(&TuneSession::sketchFailed, "no sketch");
        note(&TuneSession::refused, "refused");
    }
    void note(void (TuneSession::*signal)(), const char* name) {
        QObject::connect(&session, signal, &session, [this, name] { told << name; });
    }
    void identify() {
        bench.setIdentification(publishedMotor());
        session.readConditions({});
    }
    static GainSource recommended() { return {"recommended"}; }
    static GainSource edited(double proportional) {
        GainSource source{"edited"};
        source.law.emplace();
        source.law->law.gains.proportional = proportional;
        source.law->law.gains.integral = 20.0;
        source.law->law.gains.derivative = 2.0;
        return source;
    }
    bool isAnswered() {
        return wait([&] { return session.proposed() || (session.problem() && !session.isComputing()); });
    }

    TuneSession session{bench};
    QStringList told;
};

TEST_F(TuneSessionTest, judgementFollowsItsSketch) {
    identify();
    session.ask(recommended(), nullptr);
    EXPECT_TRUE(session.isSketching());
    EXPECT_FALSE(session.proposed());
    ASSERT_TRUE(isAnswered());
    EXPECT_EQ(told, QStringList({"sketched", "judged"}));
    EXPECT_EQ(session.proposed()->method, "recommended");
    ASSERT_TRUE(session.drawnLaw());
    EXPECT_TRUE(session.isDrawn(*session.drawnLaw()));
    EXPECT_FALSE(session.isDrawn(*edited(33.0).law));
    EXPECT_GT(session.bandwidth_rad_s().value_or(0.0), 0.0);
    EXPECT_FALSE(session.obstacle(false)) << "no device is connected";
}

TEST_F(TuneSessionTest, newestQuestionAloneIsAnswered) {
    identify();
    session.ask(edited(20.0), nullptr);
    session.ask(edited(33.0), nullptr);
    ASSERT_TRUE(isAnswered());
    EXPECT_EQ(told, QStringList({"sketched", "judged"}));
    EXPECT_EQ(session.proposed()->law.gains.proportional, 33.0);
}

TEST_F(TuneSessionTest, sourceWithoutGainsIsRefusedAtOnce) {
    identify();
    session.ask(recommended(), nullptr);
    ASSERT_TRUE(isAnswered());
    told.clear();
    session.ask(failure(ErrorCode::InvalidInput, "K_P is no number", "write one"), nullptr);
    EXPECT_EQ(told, QStringList("refused"));
    EXPECT_EQ(session.problem()->message, "K_P is no number");
    EXPECT_FALSE(session.proposed());
    EXPECT_TRUE(session.sketch()) << "the last picture stays";
    EXPECT_FALSE(session.drawnLaw());
    EXPECT_FALSE(session.isComputing());
}

TEST_F(TuneSessionTest, gainsThatNoLoopCanHaveHaveNoSketch) {
    identify();
    session.ask(edited(-1.0), nullptr);
    ASSERT_TRUE(isAnswered());
    EXPECT_EQ(told.mid(0, 2), QStringList({"no sketch", "refused"}));
    EXPECT_FALSE(session.sketch());
}

TEST_F(TuneSessionTest, judgementWaitsWhileGainsMove) {
    identify();
    session.setMoving(true);
    session.ask(recommended(), nullptr);
    bool isComputing = true;
    QObject::connect(
        &session, &TuneSession::sketched, &session, [&] { isComputing = session.isComputing(); },
        Qt::QueuedConnection);
    ASSERT_TRUE(wait([&] { return !isComputing; }));
    session.setMoving(false);
    session.completeMove();
    EXPECT_TRUE(session.isComputing() || session.proposed());
    ASSERT_TRUE(isAnswered());
    EXPECT_EQ(told, QStringList({"sketched", "judged"}));
}

TEST_F(TuneSessionTest, nothingIsProposedWithoutAMotor) {
    session.ask(recommended(), nullptr);
    EXPECT_FALSE(session.isComputing());
    identify();
    session.ask(recommended(), nullptr);
    ASSERT_TRUE(isAnswered());
    bench.setIdentification({});
    session.forgetProposed();
    session.forget();
    EXPECT_FALSE(session.sketch());
    EXPECT_FALSE(session.proposed());
}

TEST_F(TuneSessionTest, conditionsAreThoseOfTheDeviceOrOfTheDefaultActuator) {
    int changes = 0;
    QObject::connect(&session, &TuneSession::conditionsChanged, &session, [&] { ++changes; });
    EXPECT_EQ(session.model(), "htm");
    EXPECT_TRUE(session.readConditions({}));
    EXPECT_EQ(changes, 1);
    EXPECT_FALSE(session.readConditions({})) << "nothing is another";
    connectMotor("sim:htm?seed=4", 0.0);
    EXPECT_TRUE(session.readConditions(bench.deviceValues())) << "there are gains on the device";
    EXPECT_FALSE(session.readConditions(bench.deviceValues()));
}

} // namespace
} // namespace halbench::app
