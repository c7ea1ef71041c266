#pragma once

#include "app/actuators/htm/motor_analysis.h"
#include "app/procedures/apply/apply_axes.h"
#include "app/procedures/apply/apply_procedure.h"
#include "app/procedures/calibrate/calibrate_procedure.h"
#include "app/procedures/frequency/axes_frequency.h"
#include "app/procedures/frequency/frequency_procedure.h"
#include "app/procedures/identify/axes_identification.h"
#include "app/procedures/move/move_repetition.h"
#include "app/procedures/relay/relay_procedure.h"
#include "app/procedures/tune/loop_uncertainty.h"
#include "app/procedures/tune/tune.h"
#include "app/report/report.h"
#include "models/htm/htm_ideal_loop.h"

#include <optional>
#include <string>

namespace halbench::app {

/// What a report says about the result of each kind of step: verdict and findings, figures in words, tables,
/// plots. Angles are shown in degrees, everything else in SI.

/// Parameters and ratios with intervals and provenance, regression with residuals, joint confidence region,
/// the excitation as recorded.
ReportSection identificationSection(const std::string& heading, const IdentifyResult& result);

/// Damping rate, gain and friction of each axis, constants and ratios of the actuator.
ReportSection axesFrequencySection(const std::string& heading, const AxesFrequencyResult& result);
ReportSection axesIdentificationSection(const std::string& heading, const AxesIdentifyResult& result);

/// Margins with their intervals or why they are withheld, the rotor that fits, open loop and plant point by
/// point with coherence, how strongly each band was excited, the excitation as recorded.
ReportSection frequencySection(const std::string& heading, const FrequencyResult& result);

/// Ultimate gain and period with intervals, the cycle, whether they agree with the model.
ReportSection relaySection(const std::string& heading, const RelayResult& result);

/// What was found and is proposed or applied, and the static friction over the angle.
ReportSection calibrationSection(const std::string& heading, const CalibrateResult& result);

/// Gains, margins with their robust bounds, open loop and predicted step; `present` is the loop of the gains
/// that ran before, drawn beside it; `uncertainty` the band of the motors that the data allow.
ReportSection tuningSection(const std::string& heading, const TuneResult& result,
                            const std::optional<AnalysisResult>& present = std::nullopt,
                            const std::optional<LoopUncertainty>& uncertainty = std::nullopt);

/// Margins, open loop and predicted step of one loop.
ReportSection analysisSection(const std::string& heading, const AnalysisResult& result);

/// What follows from the parts of a simulated motor.
ReportSection motorSection(const std::string& heading, const MotorAnalysis& result);

/// Position over reference and prediction, error, current and the response's figures; of a repeated move the
/// last run is drawn and the others are listed.
ReportSection moveSection(const std::string& heading, const MoveResult& result,
                          const std::optional<models::IdealTrace>& predicted = std::nullopt,
                          const std::optional<MoveRepetition>& repetition = std::nullopt);

/// Parameters before and after, whether they stayed, and the verifying move.
ReportSection applySection(const std::string& heading, const ApplyResult& result);

/// Gains and margins of the loops of several axes, in the units of each.
ReportSection axesTuningSection(const std::string& heading, const TuneAxesResult& result);
/// Whether they stayed, and how each axis answered its step beside its prediction.
ReportSection axesApplySection(const std::string& heading, const ApplyAxesResult& result);

/// What the published sources of a device say that cannot be true together, and what the program does about
/// it; nothing for a device without such sources. Source: resources/help/htm-theory.md section 6.
std::optional<ReportSection> contradictionsSection(const std::string& deviceModel);

} // namespace halbench::app
