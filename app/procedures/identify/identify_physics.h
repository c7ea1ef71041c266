#pragma once

#include "app/procedures/identify/identify_estimate.h"

namespace halbench::app {

/// What the columns themselves show before any value counts: an angle that wraps (a finding), a speed where
/// the angle belongs, plateaus that turn against their current (both refused: false, no value is left).
bool judgeColumns(IdentifyResult& result, const IdentifyFits& fits);

/// What physics excludes: J and phi are positive, c and K_f not negative. A torque constant below zero is
/// refused as "sign of current or angle", a friction, damping or inertia below zero by more than its interval
/// too, with what is likely wrong with the data; an interval of J or phi that reaches zero is doubtful.
/// Friction or damping that cannot be told from zero is zero, within an interval that begins there.
void judgePhysics(IdentifyResult& result, const IdentifyFits& fits);

} // namespace halbench::app
