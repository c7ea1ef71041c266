#pragma once

#include "app/procedures/identify/identify_estimate.h"

namespace halbench::app {

/// Findings on friction that is more than c omega + K_f: the term that was fitted with its size, or that none
/// fits. Verdict and sizes go into the result; also `notes`, per unit of inertia.
void judgeFrictionLaw(IdentifyResult& result, const IdentifyFits& fits);

/// What is left of the torque at speed may be a lag that is longer than that of the published board, or an
/// angle kappa I of a stray field that is compensated wrongly: its torque kappa I tau omega looks the same,
/// and takes (kappa I)^2/2 of phi at any speed. Adds what the second would do to c/J and phi/J as an error.
void addLossAmbiguity(control::MotorRatios& ratios, const IdentifyFits& fits);

} // namespace halbench::app
