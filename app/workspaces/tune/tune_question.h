#pragma once

#include "app/procedures/move/what_if.h"
#include "app/procedures/tune/tune.h"
#include "app/workspaces/tune/steady_prediction.h"

#include <memory>
#include <optional>

namespace halbench::app {

/// Everything a prediction depends on; asked from the window, answered by a worker.
struct TuneQuestion {
    MotorEstimate motor;
    TuneConfig config;                         ///< its method names the gains when `law` is given
    std::optional<LoopLaw> law;                ///< gains to judge; none: the method designs them
    std::optional<LoopLaw> present;            ///< gains on the device, drawn beside them
    std::shared_ptr<const WhatIfBasis> record; ///< a measured move, to be replayed through the gains
    SteadyPrediction known = {}; ///< of an answer before; what is not of this question is not read
};

/// What can be drawn at once: some milliseconds.
struct TuneSketch {
    control::PositionLaw law;                     ///< parallel form, A/rad
    std::optional<control::FilteredLaw> filtered; ///< what no board runs of it
    AnalysisResult predicted;
    SteadyPrediction steady;                         ///< with the gains on the device
    std::optional<LoopUncertainty> uncertainty = {}; ///< nothing: not known of this motor
    std::optional<Result<WhatIf>> whatIf = {};       ///< of the question's record; refused for a filtered law
    std::optional<control::LoadStep> loaded = {};    ///< under load; nothing for a loop that is unstable

    LoopLaw loopLaw() const { return {law, filtered}; }
};
/// A pure function. What the device's present gains make unjudgeable is left out. Errors: as of
/// answerTuning.
Result<TuneSketch> sketchTuning(const TuneQuestion& question);

/// The whole judgement, with a thousand motors drawn from the uncertainty: some tenths of a second. Errors:
/// of runTune and judgeLaw.
Result<TuneResult> answerTuning(const TuneQuestion& question);

/// A loop with what the comparison of designs says of it: where the closed loop falls by 3 dB.
struct JudgedLoop {
    AnalysisResult predicted;
    std::optional<double> bandwidth_rad_s;
};
/// A pure function. Errors: of runAnalysis.
Result<JudgedLoop> judgeLoop(const MotorEstimate& motor, const LoopLaw& law,
                             const LoopConditions& conditions);

} // namespace halbench::app
