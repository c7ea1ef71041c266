#pragma once

#include "devices/firmware/planar/hb_planar.h"
#include "devices/simulated/simulated_model.h"
#include "models/planar/planar_parameters.h"
#include "models/planar/planar_plant.h"

namespace halbench::devices {

/// The planar six-coil positioner with its controller board. Overrides: the keys of
/// models/planar/planar_parameters.h and `seed`, `imperfections` (on, off), `chain` (full, ideal). Nine
/// signals more than a real board: true pose, speed and wrench of the coils about the platen's origin.
/// Source: resources/help/planar-theory.md section 8.
SimulatedModel planarModel();

/// What tests look at and break in a board of this model.
const hb_planar& planarFirmware(const SimulatedBoard& board);
const models::PlanarTruth& planarTruth(const SimulatedBoard& board);
void setChipFault(SimulatedBoard& board, int chip, models::ChipFault fault);

} // namespace halbench::devices
