#pragma once

#include "app/procedures/base/axis_model.h"
#include "app/procedures/tune/tune.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Surroundings of the loops of several axes; each has its `axis`.
using AxisConditions = std::vector<LoopConditions>;

/// Where the effort that an axis has is not known.
constexpr double UnknownEffortLimit = 1e9;

struct TuneAxesConfig {
    std::string method = "recommended"; ///< a name of control::axisDesignMethods()
    control::DesignTargets targets;
    std::optional<double> load; ///< of the disturbance, in effort; absent: a tenth of what the axis has
    int draws = 1000;
    std::uint64_t seed = 1;
};

/// Stability of all loops together over the joint uncertainty of their axes.
struct JointRobustness {
    int draws = 0;
    double unstable_fraction = 0.0; ///< of the draws, in which at least one loop is unstable
};

/// Loops of several axes; the axis of each is in its conditions.
struct TuneAxesResult {
    std::vector<TuneResult> axes;
    std::optional<JointRobustness> joint; ///< absent: the model has no covariance
    DataQuality quality;                  ///< the worst verdict; findings name their axis first
};

/// The axes that are meant: one, or with "" or "all" every axis of the model. Errors: UnknownName, whose hint
/// lists the axes.
Result<std::vector<std::string>> chosenAxesOf(const AxisModel& model, const std::string& name);

/// Designs the loop of each axis of `conditions`. Errors: of runTune, the axis named first; UnknownName.
Result<TuneAxesResult> tuneAxes(const AxisModel& model, const AxisConditions& conditions,
                                const TuneAxesConfig& config);
/// Judges laws that came from elsewhere, one for each of `conditions`; `methods` says how they were found.
/// Errors: of judgeLaw, likewise.
Result<TuneAxesResult> judgeAxes(const AxisModel& model, const AxisConditions& conditions,
                                 const std::vector<LoopLaw>& laws, const std::vector<std::string>& methods,
                                 const TuneAxesConfig& config);

} // namespace halbench::app
