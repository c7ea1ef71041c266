#pragma once

#include "app/actuators/htm/amplifier_analysis.h"
#include "app/actuators/htm/motor_analysis.h"
#include "app/documents/result_header.h"
#include "app/procedures/apply/apply_procedure.h"
#include "app/procedures/apply/live_apply_procedure.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/frequency/frequency_procedure.h"
#include "app/procedures/identify/axes_identification.h"
#include "app/procedures/move/move_procedure.h"
#include "app/procedures/move/move_repetition.h"
#include "app/procedures/tune/tune.h"

namespace halbench::app {

// The forms of resources/help/command-line.md, "Results": one function a result. The header's quality is
// replaced by the result's. The published schemas are resources/schemas/*.schema.json.

/// halbench.identification/1
JsonValue identificationDocument(ResultHeader header, const IdentifyResult& result);
/// Likewise, or halbench.axis-model/1 of a device with several axes.
JsonValue identificationDocument(ResultHeader header, const IdentifyOutcome& outcome);
/// halbench.frequency/1
JsonValue frequencyDocument(ResultHeader header, const FrequencyResult& result);
/// halbench.calibration/1
JsonValue calibrationDocument(ResultHeader header, const CalibrateResult& result);
/// halbench.gains/1
JsonValue gainsDocument(ResultHeader header, const TuneResult& result);
/// halbench.analysis/1
JsonValue analysisDocument(ResultHeader header, const AnalysisResult& result);

/// The same without the header, for the steps of a run and for parts of other results.
JsonValue identificationBody(const IdentifyResult& result);
JsonValue identificationBody(const IdentifyOutcome& outcome);
JsonValue frequencyBody(const FrequencyResult& result);
JsonValue calibrationBody(const CalibrateResult& result);
JsonValue gainsBody(const TuneResult& result);
JsonValue analysisBody(const AnalysisResult& result);
/// Judgement of gains beside their prediction: proof, robustness, limit cycles, hunting.
void setJudgement(JsonValue& body, const TuneResult& result);
/// The figures of the axis that moved: on a device with one axis angles in degrees, with several in SI units.
JsonValue moveBody(const MoveResult& result);
/// `axes` of a move on a device with several: figures of the one that moved, what its model foresees where
/// one is known, and how far the others went.
JsonValue movedAxes(const MoveResult& result, const std::optional<MoveFigures>& predicted = {});
/// How near both axes of a path kept to it.
JsonValue contourBody(const ContourResult& contour);
/// The figures of a move that was repeated; it holds at least one run. `unit`: "deg", or the position unit of
/// an axis.
JsonValue repetitionBody(const MoveRepetition& repetition, const std::string& unit = "deg");
/// `unit` of the positions: "deg" or that of the axis.
JsonValue moveFigures(const MoveFigures& figures, const std::string& unit = "deg");
JsonValue amplifierBody(const AmplifierAnalysis& result);
JsonValue motorAnalysisBody(const MotorAnalysis& result);
JsonValue applyBody(const ApplyResult& result);
/// The same with its steps.
JsonValue liveApplyBody(const LiveApplyResult& result);

/// {value, unit, ci95, source}; value and ci95 are null when it is not identifiable.
JsonValue toJson(const control::Estimate& estimate);
/// [{name, value}]
JsonValue toJson(const std::vector<ParameterValue>& values);

} // namespace halbench::app
