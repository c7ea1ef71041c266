#pragma once

#include "app/procedures/apply/apply_procedure.h"
#include "app/procedures/tune/tune_axes.h"

#include <string>
#include <vector>

namespace halbench::app {

/// Gains of several axes, and how they prove themselves before they stay.
struct ApplyAxesConfig {
    std::vector<ParameterValue> values;          ///< of all axes, written in one transaction
    std::vector<ApplyVerification> verification; ///< a step of each axis, one after the other
};

/// The step of one axis with its prediction.
struct AxisVerification {
    devices::AxisSpec axis;
    ApplyResult assessment; ///< its prediction, measurement and band; values and `isKept` are of the whole
};

struct ApplyAxesResult {
    std::vector<ParameterValue> before;
    std::vector<ParameterValue> after; ///< as read back
    std::vector<AxisVerification> axes;
    bool isKept = false; ///< false: the old values run again, `quality` says why
    DataQuality quality; ///< findings name their axis first
};

/// The laws of a result as parameters of the device, and a step of each axis, as large as its profile says,
/// within 4 % of its height around the predicted band, in the end also within the axis' own tolerance. An
/// effort for smooth references is left out where the board has no parameter for it. Errors: Usage (a device
/// without axes), UnknownName (an axis that it does not have); of lawForDevice, the axis named first.
Result<ApplyAxesConfig> applyAxesConfig(const devices::Catalogue& catalogue, const AxisModel& model,
                                        const TuneAxesResult& result);

/// How far another axis may go while one makes its step: its end tolerance or a twentieth of its test step.
double crossAxisTolerance(const devices::AxisSpec& axis);

/// One transaction: snapshot, range and finite checks, write, read back, a verification step of each axis,
/// whose neighbours must stay where they are, keep or restore all. The first axis that fails ends it. Walks
/// the states of runApply. Errors: as of runApply; Refused (a device that finds no zero of its axes).
Result<ApplyAxesResult> runApplyAxes(devices::Device& device, const ApplyAxesConfig& config,
                                     const ProcedureObserver& observer);

} // namespace halbench::app
