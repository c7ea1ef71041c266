#pragma once

#include "app/procedures/identify/identify_estimate.h"

namespace halbench::app {

/// Departure of the torque from the commanded current that chance explains badly without excluding it: what
/// it would move the constants by is one more error (resources/help/identification.md section 5.3).
void addDepartureError(control::MotorRatios& ratios, const IdentifyFits& fits);

/// The asymmetry of friction that currents of the two directions make which are known to `currentError_ratio`
/// of the largest one: less says nothing of friction.
double smallestAsymmetry(const IdentifyFits& fits, double currentError_ratio);

/// Findings `torque_not_proportional` and `friction_scatters`: the constants then belong to no motor.
void judgeTorqueLaw(IdentifyResult& result, const IdentifyFits& fits);

} // namespace halbench::app
