#pragma once

#include "models/planar/current_source.h"
#include "models/planar/hall_chip.h"
#include "models/planar/planar_parameters.h"
#include "models/planar/platen_body.h"
#include "models/sensors/temperature_sensor.h"
#include "models/thermal/coil_heating.h"

#include <array>
#include <cstdint>

namespace halbench::models {

/// One positioner as built: what the seed made of the spreads.
struct PlanarSpecimen {
    PlatenConfig platen;
    CurrentSourceConfig amplifier;
    CoilHeatingConfig coil;
    std::array<HallChip, ChipCount> chips;
    Eigen::Matrix<double, FieldCount, CoilCount> crosstalk_T_per_A; ///< before the chips' own errors
    std::array<TemperatureSensorConfig, CoilCount> temperature;
};

/// Draws the individual errors: Gaussian with the given 1 sigma, cut at twice it. Each kind of error has its
/// own stream of the generator: writing one down does not change the others. Source:
/// resources/help/planar-theory.md section 3.
PlanarSpecimen drawSpecimen(const PlanarParameters& parameters, std::uint64_t seed);

} // namespace halbench::models
