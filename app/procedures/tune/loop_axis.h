#pragma once

#include "app/procedures/base/axis_model.h"
#include "app/procedures/tune/analyse.h"
#include "devices/axis_spec.h"

#include <string>
#include <vector>

namespace halbench::app {

/// The axis of a device, as its loop is judged.
LoopAxis loopAxisOf(const devices::AxisSpec& axis);

/// One axis of a model as an estimate of the same equation: its damping rate as c_over_J, its gain as
/// phi_over_J, its breakaway effort as Kf_over_phi, with their part of the covariance.
MotorEstimate estimateOfAxis(const AxisModel& model, const IdentifiedAxis& axis);

/// A length or an angle with the prefix that suits it: "12.3 µm", "1.5 mrad".
std::string positionText(const LoopAxis& axis, double position);

// Warnings on the loop of an axis, in its units; those of a motor are in loop_prediction.h.

/// Stability, margins, delay, friction and effort limit. `later`: pole radius with one more sample of delay.
void addAxisWarnings(AnalysisResult& result, const LoopAxis& axis, double effortLimit,
                     std::optional<double> later);
/// Of its robustness.
void addAxisRobustness(std::vector<Finding>& warnings, const control::Robustness& robust, bool isStable,
                       bool hasCovariance);

} // namespace halbench::app
