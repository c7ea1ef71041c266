#pragma once

#include "app/procedures/identify/identify_estimate.h"

namespace halbench::app {

/// Columns that show a fault by themselves, before any value counts: an angle that wraps (a finding), a speed
/// where the angle belongs, plateaus that turn against their current (both refused: false, no value is left).
bool judgeColumns(IdentifyResult& result, const IdentifyFits& fits);

/// Currents that the board of the recording cannot have commanded or, where its limit is not known, that no
/// actuator of this kind bears: doubtful, since a unit or a factor of the column is likely wrong, and every
/// constant of the torque with it.
void judgeCurrents(IdentifyResult& result, const IdentifyFits& fits,
                   const std::optional<double>& recordedLimit_A);

/// What physics excludes: J and phi are positive, c and K_f not negative. A torque constant below zero is
/// refused as "sign of current or angle", a friction, damping or inertia below zero by more than its interval
/// too, with what is likely wrong with the data; an interval of J or phi that reaches zero is doubtful.
/// Friction or damping that cannot be told from zero is zero, within an interval that begins there.
void judgePhysics(IdentifyResult& result, const IdentifyFits& fits);

} // namespace halbench::app
