#include "app/documents/model_file.h"
#include "app/workspaces/tune/steady_prediction.h"
#include "app/workspaces/tune/tune_question.h"
#include "tests/app/workspaces/published_motor.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace halbench::app {
namespace {

control::PositionLaw lawOf(double proportional) {
    control::PositionLaw law;
    law.gains.proportional = proportional;
    law.gains.integral = 20.0;
    law.gains.derivative = 0.6;
    return law;
}

TuneQuestion asked() {
    TuneQuestion question;
    question.motor = motorEstimate(publishedMotor());
    question.law = lawOf(20.0);
    question.present = lawOf(10.0);
    return question;
}

/// Everything that could be changed between two sketches, one at a time.
const std::vector<std::pair<const char*, std::function<void(TuneQuestion&)>>>& changes() {
    static const std::vector<std::pair<const char*, std::function<void(TuneQuestion&)>>> all = {
        {"the device's gains", [](TuneQuestion& q) { q.present = lawOf(11.0); }},
        {"its integral gain", [](TuneQuestion& q) { q.present->law.gains.integral = 21.0; }},
        {"its assist", [](TuneQuestion& q) { q.present->law.stictionCurrent_A = 0.2; }},
        {"the delay", [](TuneQuestion& q) { q.config.conditions.timing.delay_samples = 1; }},
        {"the period", [](TuneQuestion& q) { q.config.conditions.timing.period_s = 0.008; }},
        {"the current limit", [](TuneQuestion& q) { q.config.conditions.currentLimit_A = 2.0; }},
        {"the stray field",
         [](TuneQuestion& q) {
             q.config.conditions.stray = StrayField{0.15, 0.01, {}, false};
         }},
        {"the motor", [](TuneQuestion& q) { q.motor.values["phi_over_J"] *= 1.1; }},
        {"its covariance", [](TuneQuestion& q) { q.motor.covariance[2][2] *= 4.0; }},
        {"no covariance",
         [](TuneQuestion& q) {
             q.motor.covarianceNames.clear();
             q.motor.covariance.clear();
         }},
        {"the seed", [](TuneQuestion& q) { q.config.seed = 2; }},
        {"the number of motors", [](TuneQuestion& q) { q.config.draws = 1100; }},
        {"no device", [](TuneQuestion& q) { q.present.reset(); }},
    };
    return all;
}

void expectSame(const TuneSketch& one, const TuneSketch& other, const char* what) {
    EXPECT_EQ(one.predicted.bode.magnitude_dB, other.predicted.bode.magnitude_dB) << what;
    EXPECT_EQ(one.predicted.stepCurve.response_rad, other.predicted.stepCurve.response_rad) << what;
    ASSERT_EQ(bool(one.steady.present), bool(other.steady.present)) << what;
    if (one.steady.present) {
        ASSERT_TRUE(one.steady.present->predicted && other.steady.present->predicted) << what;
        const AnalysisResult& mine = *one.steady.present->predicted;
        const AnalysisResult& theirs = *other.steady.present->predicted;
        EXPECT_EQ(mine.bode.magnitude_dB, theirs.bode.magnitude_dB) << what;
        EXPECT_EQ(mine.bode.phase_deg, theirs.bode.phase_deg) << what;
        EXPECT_EQ(mine.stepCurve.current_A, theirs.stepCurve.current_A) << what;
        EXPECT_EQ(mine.largeStep->trace.angle_rad, theirs.largeStep->trace.angle_rad) << what;
        EXPECT_EQ(mine.warnings.size(), theirs.warnings.size()) << what;
        ASSERT_EQ(bool(one.steady.present->loaded), bool(other.steady.present->loaded)) << what;
        if (one.steady.present->loaded) {
            EXPECT_EQ(one.steady.present->loaded->angle_rad, other.steady.present->loaded->angle_rad) << what;
        }
    }
    ASSERT_EQ(bool(one.uncertainty), bool(other.uncertainty)) << what;
    if (one.uncertainty) {
        EXPECT_EQ(one.uncertainty->loop.magnitude_dB.p5, other.uncertainty->loop.magnitude_dB.p5) << what;
        EXPECT_EQ(one.uncertainty->loop.phase_deg.p95, other.uncertainty->loop.phase_deg.p95) << what;
        EXPECT_EQ(one.uncertainty->step->response_rad.p95, other.uncertainty->step->response_rad.p95) << what;
    }
}

TEST(SteadyPrediction, isMadeOnceForAllGainsInTheHand) {
    TuneQuestion question = asked();
    const auto first = sketchTuning(question);
    ASSERT_TRUE(first && first->steady.present && first->steady.motors);
    question.known = first->steady;
    question.law = lawOf(24.0);
    const auto second = sketchTuning(question);
    ASSERT_TRUE(second);
    EXPECT_EQ(second->steady.present, first->steady.present); // the same object: nothing was computed
    EXPECT_EQ(second->steady.motors, first->steady.motors);
    EXPECT_NE(second->predicted.bode.magnitude_dB, first->predicted.bode.magnitude_dB);
    EXPECT_NE(second->uncertainty->loop.magnitude_dB.p5, first->uncertainty->loop.magnitude_dB.p5);
    question.known = {};
    expectSame(*second, *sketchTuning(question), "known or not");
}

// Whatever changes, the answer is that of a question that knows nothing; and the changes are none in vain.
TEST(SteadyPrediction, ofAnythingElseIsNotRead) {
    const TuneQuestion before = asked();
    const auto first = sketchTuning(before);
    ASSERT_TRUE(first);
    for (const auto& [what, change] : changes()) {
        TuneQuestion question = before;
        change(question);
        const auto fresh = sketchTuning(question);
        question.known = first->steady;
        const auto sketch = sketchTuning(question);
        ASSERT_TRUE(fresh && sketch) << what;
        expectSame(*sketch, *fresh, what);
        EXPECT_TRUE(sketch->steady.present != first->steady.present ||
                    sketch->steady.motors != first->steady.motors)
            << what;
    }
}

TEST(SteadyPrediction, otherGainsOrAnotherMotorHaveOtherCurves) {
    TuneQuestion question = asked();
    const auto first = sketchTuning(question);
    question.known = first->steady;
    question.present = lawOf(11.0);
    const auto gains = sketchTuning(question);
    EXPECT_NE(gains->steady.present->predicted->bode.magnitude_dB,
              first->steady.present->predicted->bode.magnitude_dB);
    EXPECT_EQ(gains->steady.motors, first->steady.motors); // which have nothing to do with the device's gains
    question.known = gains->steady;
    question.motor.values["phi_over_J"] *= 1.1;
    const auto motor = sketchTuning(question);
    EXPECT_NE(motor->steady.present->predicted->bode.magnitude_dB,
              gains->steady.present->predicted->bode.magnitude_dB);
    question.known = motor->steady;
    question.config.seed = 7;
    const auto seed = sketchTuning(question);
    EXPECT_EQ(seed->steady.present, motor->steady.present);
    EXPECT_NE(seed->uncertainty->loop.magnitude_dB.p5, motor->uncertainty->loop.magnitude_dB.p5);
}

TEST(SteadyPrediction, gainsThatCannotBeJudgedAreNotDrawnAndNotAskedAgain) {
    const TuneQuestion question = asked();
    const auto none = presentLoop(question.motor, lawOf(-1.0), question.config.conditions, nullptr);
    EXPECT_FALSE(none->predicted);
    EXPECT_FALSE(none->loaded);
    EXPECT_EQ(presentLoop(question.motor, lawOf(-1.0), question.config.conditions, none), none);
    MotorEstimate torn = question.motor;
    torn.covariance[0][0] = std::numeric_limits<double>::quiet_NaN();
    const auto drawn = drawnMotors(torn, {1000, 1}, nullptr);
    EXPECT_FALSE(drawn->plants);
    EXPECT_NE(drawnMotors(torn, {1000, 1}, drawn), drawn); // what is no number is the same as nothing
}

} // namespace
} // namespace halbench::app
