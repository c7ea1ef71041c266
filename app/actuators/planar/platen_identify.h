#pragma once

#include "app/procedures/identify/axes_identification.h"

#include <string_view>

namespace halbench::app {

/// Constants that may be given: "m" (moving mass, kg) or "Iz" (inertia about the vertical, kg m^2); one of
/// them turns the ratios of the motion into absolute values.
Result<void> setPlatenConstant(IdentifyConfig& config, std::string_view symbol, double value);

/// Errors: UnknownName (axis), Usage (options that only a motor has, two given constants).
Result<void> checkPlatenIdentify(const devices::Catalogue& catalogue, const IdentifyConfig& config);

IdentifyPrediction predictPlatenIdentify(const IdentifyConfig& config, double start_degC);

/// Damping, friction, stiffness, effort gain of every axis, force constant of each coil and set, inertia,
/// centre of mass and delay from one motion of all axes: constant speeds both ways in x, y and phi while the
/// others are shaken. The chips are calibrated from the same motion first, for the poses of the fit only; the
/// board keeps its own. Restores the board's parameters and disarms on every way out.
/// Errors: of the device, of the abort, Refused when nothing can be armed; an estimate that the data do not
/// support is a result with verdict Refused.
Result<IdentifyOutcome> identifyPlaten(devices::Device& device, const IdentifyConfig& config,
                                       const ProcedureObserver& observer);

} // namespace halbench::app
