// What the Tune panel does between two places of the hand: gains, predictions, a thousand motors, pictures.
#include "app/figures/tuning_figures.h"
#include "app/procedures/tune/large_step.h"
#include "app/workspaces/tune/loop/loop_view.h"
#include "app/workspaces/tune/tune_question.h"
#include "control/base/units.h"
#include "control/design/crossover_design.h"
#include "control/design/design_methods.h"
#include "control/robustness/robustness.h"
#include "tests/bench/goal.h"
#include "widgets/figure/figure_view.h"

#include <QApplication>
#include <QImage>

#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <vector>

namespace halbench::bench {
namespace {

using namespace halbench::app;

MotorEstimate motor() {
    MotorEstimate estimate;
    const double c_over_J = 1.23e-3 / 5.5e-4;
    estimate.values = {{"c_over_J", c_over_J}, {"phi_over_J", 26.0}, {"Kf_over_phi", 1.434}};
    estimate.covarianceNames = {"c_over_J", "phi_over_J", "Kf_over_phi"};
    const auto square = [](double value) { return std::pow(0.02 * value, 2); };
    estimate.covariance = {{square(c_over_J), 0, 0}, {0, square(26.0), 0}, {0, 0, square(1.434)}};
    return estimate;
}

/// A verification move of 3 s, as the window has one while the gains are filtered after an apply.
std::shared_ptr<const WhatIfBasis> verifiedMove() {
    const control::PositionLaw ran = *control::designLaw("published", *plantFromEstimate(motor()), {}, {});
    const std::vector<control::ReferencePoint> reference(1, {0.5, 0.0, 0.0});
    const RunMotor measured{*plantFromEstimate(motor()), 1.0, 1.0};
    const control::LoopReplay seen = replayRun(measured, {*simulatedLaw(ran, {}), reference, {}, 3001});
    const RecordedMove move{std::vector<double>(3001, 0.5), seen.angle_rad, seen.current_A};
    return std::make_shared<const WhatIfBasis>(*prepareWhatIf({move, ran, {}, motor(), {1000, 1}}));
}

/// The two pictures of a wide window: magnitude and phase, angle and current.
struct Pictures {
    LoopView loop;
    widgets::FigureView step;
    QImage screen = QImage(560, 640, QImage::Format_RGB32); ///< the window has one as long as it is shown

    Pictures() {
        loop.picture().resize(screen.size());
        step.resize(screen.size());
    }
    void draw(const TuneSketch& sketch, const std::vector<NamedLoop>& others = {}) {
        const std::optional<AnalysisResult> none;
        const auto& present = sketch.steady.present ? sketch.steady.present->predicted : none;
        loop.setLoops(sketch.predicted, present, others, std::nullopt, sketch.uncertainty);
        step.setFigure(*linearStepFigure(sketch.predicted, present, widgets::AngleUnit::Degree, others,
                                         sketch.uncertainty));
        loop.picture().render(&screen);
        step.render(&screen);
        benchmark::DoNotOptimize(screen.bits());
    }
};

/// The page Verification or What if where it is seen instead of those two: a recorded move of three panels
/// and what the gains in the hand would have made of it.
struct RecordedPicture {
    widgets::FigureView view;
    QImage screen = QImage(560, 640, QImage::Format_RGB32);

    RecordedPicture() { view.resize(screen.size()); }
    void draw(widgets::Figure figure, const WhatIfBasis& record, const WhatIf& whatIf) {
        addWhatIfCurves(figure, whatIf, std::nullopt, record.config.move.reference_rad);
        view.setFigure(std::move(figure));
        view.render(&screen);
        benchmark::DoNotOptimize(screen.bits());
    }
};

/// What the panel has of the verification move itself.
struct Verified {
    VerificationBand band;
    Recording measured;

    explicit Verified(const RecordedMove& move) {
        auto layout = std::make_shared<StreamLayout>();
        layout->columns = {{"position", "rad"}, {"current_command", "A"}};
        measured.layout = layout;
        for (std::size_t row = 0; row < move.rows(); ++row) {
            measured.time_s.push_back(1e-3 * static_cast<double>(row));
            measured.values.insert(measured.values.end(), {move.position_rad[row], move.current_A[row]});
        }
        band.predicted = {measured.time_s, move.position_rad, {}, move.reference_rad, move.current_A};
        band.allowed_rad = 0.03;
        band.friction_rad = 0.01;
    }
};

/// `predict_s`: of everything that is predicted while the hand moves, the what-if of the verification with
/// it.
void benchRecorded(Goals& goals, const TuneQuestion& question, const TuneSketch& sketch, double predict_s) {
    const WhatIfBasis& record = *question.record;
    const Verified verified(record.config.move);
    RecordedPicture picture;
    const double verification_s = processorTime_s(
        [&] { picture.draw(verificationFigure(verified.band, verified.measured), record, **sketch.whatIf); },
        25);
    goals.below("refresh while dragging, the verification move and its what-if in sight, one core",
                1e3 * (predict_s + verification_s), 16.0, "ms");
    const double recording_s = processorTime_s(
        [&] {
            const Result<WhatIf> whatIfNow = whatIf(record, sketch.law);
            picture.draw(recordedMoveFigure(record.config.move), record, *whatIfNow);
        },
        25);
    goals.below("refresh while dragging, a recorded move and its what-if in sight, one core",
                1e3 * (predict_s + recording_s), 16.0, "ms");
}

/// Three kept designs and the gains of the device drawn beside what is in the hand. The kept ones were judged
/// when they were kept; the device's are predicted once for all moves.
void benchCompared(Goals& goals, TuneQuestion& question, const std::function<void()>& predict,
                   const std::vector<TuneSketch>& sketches) {
    std::vector<JudgedLoop> judged;
    for (const char* method : {"lqr", "simc", "lead"}) {
        const auto law = control::designLaw(method, *plantFromEstimate(question.motor), {}, {});
        judged.push_back(*judgeLoop(question.motor, *law, question.config.conditions));
    }
    const std::vector<NamedLoop> others = {
        {"lqr", &judged[0].predicted}, {"simc", &judged[1].predicted}, {"lead", &judged[2].predicted}};
    question.present = *control::designLaw("published", *plantFromEstimate(question.motor), {}, {});
    const double predict_s = processorTime_s(predict, 25);
    const TuneSketch& sketch = sketches.back();
    if (!sketch.steady.present || !sketch.steady.present->predicted) {
        goals.failed("the gains of the device beside those in the hand", "they are not predicted");
    }
    Pictures pictures;
    std::size_t next = 0; // each picture is of other gains than the one before
    const double draw_s =
        processorTime_s([&] { pictures.draw(sketches[next++ % sketches.size()], others); }, 25);
    goals.below("full refresh while dragging, three kept designs and the device's gains beside, one core",
                1e3 * (predict_s + draw_s), 16.0, "ms");
}

/// A law with weights, a notch and a low-pass, whose gain is in the hand.
void benchFiltered(Goals& goals) {
    TuneQuestion question;
    question.motor = motor();
    control::FilteredLaw filtered;
    filtered.gains = control::designLaw("recommended", *plantFromEstimate(question.motor), {}, {})->gains;
    filtered.gains.proportional *= 0.3;
    filtered.gains.integral *= 0.1;
    filtered.gains.derivative *= 0.4;
    filtered.gains.filter_s = 0.002;
    filtered.proportionalWeight = 0.8;
    filtered.filters = {control::NotchFilter{180.0, 0.2, 0.5}, control::LowPassFilter{250.0, 2}};
    double factor = 1.0;
    Pictures pictures;
    const double refresh_s = processorTime_s(
        [&] {
            factor = factor > 1.3 ? 1.0 : factor * 1.02;
            control::FilteredLaw now = filtered;
            now.gains.proportional *= factor;
            question.law = LoopLaw{control::PositionLaw{now.gains}, now};
            const auto sketch = sketchTuning(question);
            question.known = sketch->steady;
            if (!sketch->uncertainty || !sketch->predicted.isStable) {
                goals.failed("the bands of a shaped loop", "they are not predicted");
                return;
            }
            pictures.draw(*sketch);
        },
        25);
    goals.below("full refresh while dragging a loop with weights and two filters, one core", 1e3 * refresh_s,
                16.0, "ms");
}

void benchRefresh(Goals& goals) {
    TuneQuestion question;
    question.motor = motor();
    question.record = verifiedMove();
    const control::PositionPlant plant = *plantFromEstimate(question.motor);
    const control::UncertainPlant uncertain = *uncertainPlantFromEstimate(question.motor);
    const LoopConditions& conditions = question.config.conditions;
    Pictures pictures;
    double crossover_rad_s = 30.0;
    TuneSketch sketch;
    std::vector<TuneSketch> sketches;
    const auto predict = [&] {
        crossover_rad_s = crossover_rad_s > 44.0 ? 30.0 : crossover_rad_s * 1.02;
        const auto design = control::designCrossover(plant, conditions.timing, {crossover_rad_s, 38.0, 0.033},
                                                     control::CrossoverPriority::Margin);
        question.law = control::PositionLaw{design->gains};
        sketch = *sketchTuning(question);
        question.known = sketch.steady; // as the panel hands it on
        sketches.push_back(sketch);
        if (!sketch.whatIf || !*sketch.whatIf) {
            goals.failed("the verification move with the gains in the hand", "it is not predicted");
        }
        benchmark::DoNotOptimize(
            control::assessRobustness(uncertain, design->gains, conditions.timing, 1000, Random(1))
                ->unstable_fraction);
    };
    const double predict_s = processorTime_s(predict, 25);
    std::size_t next = 0;
    const double draw_s = processorTime_s([&] { pictures.draw(sketches[next++ % sketches.size()]); }, 25);
    goals.below("prediction while dragging, with 1000 motors", 1e3 * predict_s, 12.0, "ms");
    goals.below("full refresh while dragging: four panels, 1000 motors, one core", 1e3 * (predict_s + draw_s),
                16.0, "ms");
    benchRecorded(goals, question, sketch, predict_s);
    sketches.clear();
    benchCompared(goals, question, predict, sketches);
}

} // namespace
} // namespace halbench::bench

int main(int count, char** words) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(count, words);
    halbench::bench::Goals goals;
    halbench::bench::benchRefresh(goals);
    halbench::bench::benchFiltered(goals);
    return goals.exitCode();
}
