#pragma once

#include "app/procedures/tune/analyse.h"
#include "app/procedures/tune/disturbance.h"
#include "app/procedures/tune/loop_cycles.h"
#include "control/assess/loop_assessment.h"
#include "control/design/design_methods.h"
#include "control/design/optimal_designs.h"
#include "control/robustness/robustness.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

struct TuneConfig {
    std::string method = "recommended"; ///< a name of control::designMethods()
    control::DesignTargets targets;
    LoopConditions conditions;
    int draws = 1000;
    std::uint64_t seed = 1;
    double load_A = DisturbanceLoad_A; ///< of the disturbance
};

/// A proposed set of gains with what it promises.
struct TuneResult {
    std::string method;
    control::DesignTargets targets;
    LoopConditions conditions;
    control::PositionPlant plant;
    control::PositionLaw law; ///< parallel form, A/rad
    /// What the loop was judged with where no board's law is all of it: then it is never applied.
    std::optional<control::FilteredLaw> filtered;
    AnalysisResult predicted;
    control::Robustness robust;
    std::optional<control::LoopAssessment> assessment; ///< nothing: the loop grows beyond all numbers
    std::optional<control::LeastErrorBounds> bounds;   ///< of the methods that keep some, as the proof has it
    std::optional<std::vector<PredictedCycle>> cycles; ///< nothing: not predicted for such a law or motor
    std::optional<Disturbance> disturbance = {};       ///< nothing for an unstable loop
    double release_s = 0.0; ///< until the integral moves a rotor that rests at half of the friction band
    std::vector<Finding> warnings; ///< of design, prediction and robustness
    DataQuality quality;
};

/// The targets of a method with what the board limits itself: one that reads a current limit and is given
/// none keeps to the board's. Errors: OutOfRange for more than the board gives.
Result<control::DesignTargets> targetsOnBoard(const std::string& method, control::DesignTargets targets,
                                              const LoopConditions& conditions);

/// Identified motor in, gains out: a pure function. Errors: of plantFromEstimate and designLaw; NotFinite
/// when a design produced something that is no number.
Result<TuneResult> runTune(const MotorEstimate& estimate, const TuneConfig& config);

/// The same judgement of gains that came from elsewhere: edited by hand, a preset, the device, a file. The
/// method of `config` names them; its targets are not read. An unstable filtered loop is refused: no preset
/// has one. Errors: of plantFromEstimate and of the gains.
Result<TuneResult> judgeLaw(const MotorEstimate& estimate, const LoopLaw& law, const TuneConfig& config);

/// The law as the board's parameters (gain.kp ... stiction.speed), in the order of its table, and back.
/// `lawFromParameters` takes any map of parameter values; what is missing keeps the default of PositionLaw
/// except the three gains. Errors: UnknownName (a gain is missing), NotFinite, OutOfRange (negative).
std::vector<ParameterValue> lawParameters(const control::PositionLaw& law);
/// To what single precision leaves of a gain on a board.
bool isSameLaw(const control::PositionLaw& one, const control::PositionLaw& other);
Result<control::PositionLaw> lawFromParameters(const std::map<std::string, double>& values);

/// Checks every value against the device's limits before anything is written. Errors: of checkParameterValue;
/// UnknownName when the device lacks a parameter that the law needs (one at zero is left out instead).
Result<std::vector<ParameterValue>> lawForDevice(const control::PositionLaw& law,
                                                 const devices::Catalogue& catalogue);

} // namespace halbench::app
