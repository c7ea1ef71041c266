#include "app/workspaces/tune/tune_question.h"

#include "control/analysis/loop_functions.h"
#include "control/law/filtered_delta.h"

#include <map>
#include <utility>

namespace halbench::app {

namespace {

Result<LoopLaw> lawOf(const TuneQuestion& question) {
    if (question.law) {
        return question.law->filtered ? checkedLaw(*question.law, question.config.conditions.timing.period_s)
                                      : *question.law;
    }
    const auto plant = plantFromEstimate(question.motor);
    if (!plant) {
        return failure(plant.error());
    }
    const auto targets =
        targetsOnBoard(question.config.method, question.config.targets, question.config.conditions);
    if (!targets) {
        return failure(targets.error());
    }
    const auto law =
        control::designLaw(question.config.method, *plant, question.config.conditions.timing, *targets);
    if (!law) {
        return failure(law.error());
    }
    std::map<std::string, double> values; // in the board's notation
    for (const ParameterValue& value : lawParameters(*law)) {
        values[value.name] = value.value;
    }
    const auto board = lawFromParameters(values);
    return board ? Result<LoopLaw>(*board) : failure(board.error());
}

SteadyPrediction steadyPrediction(const TuneQuestion& question) {
    SteadyPrediction steady;
    steady.motors =
        drawnMotors(question.motor, {question.config.draws, question.config.seed}, question.known.motors);
    if (question.present) {
        steady.present = presentLoop(question.motor, *question.present, question.config.conditions,
                                     question.known.present);
    }
    return steady;
}

} // namespace

Result<TuneSketch> sketchTuning(const TuneQuestion& question) {
    const auto law = lawOf(question);
    if (!law) {
        return failure(law.error());
    }
    auto predicted = runAnalysis(question.motor, *law, question.config.conditions);
    if (!predicted) {
        return failure(predicted.error());
    }
    TuneSketch sketch{law->law, law->filtered, std::move(*predicted), steadyPrediction(question)};
    if (const auto& plants = sketch.steady.motors->plants) {
        auto uncertainty = loopUncertainty(*plants, *law, question.config.conditions, sketch.predicted);
        if (uncertainty) {
            sketch.uncertainty = *std::move(uncertainty);
        }
    }
    sketch.loaded = disturbanceStep(question.motor, *law, question.config.conditions, sketch.predicted);
    if (question.record) {
        sketch.whatIf = whatIf(*question.record, *law);
    }
    return sketch;
}

Result<TuneResult> answerTuning(const TuneQuestion& question) {
    return question.law ? judgeLaw(question.motor, *question.law, question.config)
                        : runTune(question.motor, question.config);
}

Result<JudgedLoop> judgeLoop(const MotorEstimate& motor, const LoopLaw& law,
                             const LoopConditions& conditions) {
    auto predicted = runAnalysis(motor, law, conditions);
    if (!predicted) {
        return failure(predicted.error());
    }
    const auto plant = plantFromEstimate(motor);
    const auto open =
        control::deltaOpenLoop(*plant, asFiltered(law), conditions.timing); // as it was analysed
    return JudgedLoop{*std::move(predicted), open ? control::closedBandwidth_rad_s(*open) : std::nullopt};
}

} // namespace halbench::app
