#pragma once

#include "devices/firmware/htm/hb_htm.h"
#include "devices/simulated/simulated_model.h"
#include "models/htm/htm_parameters.h"

namespace halbench::devices {

/// The two-phase Halbach-cylinder motor with its controller board. Overrides: the keys of
/// models/htm/htm_parameters.h and `seed`, `imperfections` (on, off), `chain` (full, ideal).
/// Sub-steps of 0.25 ms (resources/help/htm-theory.md section 3.8). Two signals more than a real board:
/// truth.position, truth.speed. Source: resources/help/command-line.md.
SimulatedModel htmModel();

/// The motor that an address describes. Errors as of SimulatedModel::check.
Result<models::HtmParameters> htmParameters(const Overrides& overrides);

/// The board of the motor itself. Errors as of SimulatedModel::make.
Result<std::unique_ptr<SimulatedBoard>> makeSimulatedHtm(const models::HtmParameters& parameters,
                                                         std::uint64_t seed,
                                                         SimulatedBoard::Line line = {nullptr, 0});

/// What the motor's board holds, for tests. `board` is one of this model.
const hb_htm& htmFirmware(const SimulatedBoard& board);

/// Index of Hall sensor a in the readings of the plant, for tests.
constexpr std::size_t HtmHallReading = 0;

} // namespace halbench::devices
