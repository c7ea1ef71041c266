#pragma once

#include "app/procedures/base/procedure_entry.h"
#include "app/procedures/identify/axes_identification.h"

namespace halbench::app {

/// Identification of a device whose axes do not act on each other, axis by axis: damping rate, acceleration
/// per effort and breakaway effort of each from constant speeds both ways with a sine on them. A given moving
/// mass "m" (kg, of every axis along a line) makes damping, friction and force per effort absolute.
///
/// Restores the board's parameters and disarms on every way out. Errors of the run: of the device, of the
/// abort; an estimate that the data do not support is a result with verdict Refused.
ProcedureEntry<IdentifyConfig, IdentifyOutcome, IdentifyPrediction> axesIdentification();

} // namespace halbench::app
