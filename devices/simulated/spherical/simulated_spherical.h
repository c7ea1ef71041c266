#pragma once

#include "devices/firmware/spherical/hb_spherical.h"
#include "devices/simulated/simulated_model.h"
#include "models/spherical/spherical_plant.h"

namespace halbench::devices {

/// The spherical motor's sensing board between a rotor that moves as prescribed and three field sensors.
/// Overrides: the keys of models/spherical/spherical_parameters.h, `poses` (a CSV of the motion: time_s,
/// alpha_deg, beta_deg, gamma_deg) and `seed`, `imperfections` (on, off), `chain` (full, ideal). More signals
/// than a real board: the true angles, rates and strength; and parameters `simulation.*` that a host changes
/// while it runs: set-point and rate of the rotor, current of the coil, fault of each channel. Source:
/// resources/help/spherical-theory.md sections 2 to 4.
SimulatedModel sphericalModel();

/// What tests look at and break in a board of this model.
const hb_spherical& sphericalFirmware(const SimulatedBoard& board);
models::SphericalPlant& sphericalPlant(SimulatedBoard& board);

} // namespace halbench::devices
