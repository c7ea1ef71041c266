#pragma once

#include "models/drives/dac.h"
#include "models/htm/htm_parameters.h"
#include "models/htm/htm_rotor.h"
#include "models/sensors/hall_sensor.h"
#include "models/sensors/temperature_sensor.h"
#include "models/thermal/coil_heating.h"

#include <array>
#include <cstdint>

namespace halbench::models {

/// Angle error of the rotor's field as the sensors see it, from scatter of the magnet bars:
///   d(psi) = sum over order 1, 3, 4, 5 of cosine cos(order psi) + sine sin(order psi).
struct MagnetScatter {
    struct Order {
        int order = 0;
        double cosine_rad = 0.0;
        double sine_rad = 0.0;
    };
    std::array<Order, 4> orders{{{1, 0.0, 0.0}, {3, 0.0, 0.0}, {4, 0.0, 0.0}, {5, 0.0, 0.0}}};

    double angleError_rad(double angle_rad) const;
};

/// One motor as built: what the seed made of the spreads. Each error has its own stream of the generator, so
/// that writing one of them down does not change the others.
struct HtmSpecimen {
    RotorConfig rotor;
    double torqueConstant_Nm_per_A = 0.0; ///< at the magnets' temperature
    std::array<HallConfig, 2> hall;
    MagnetScatter magnets;
    std::array<TemperatureSensorConfig, 2> temperature;
    std::array<DacConfig, 2> dac;
    std::array<CoilHeatingConfig, 2> coil;
};

/// Draws the individual errors. Gaussian with the given 1 sigma, cut at twice it (Hall offset: at 2.8 times,
/// 70 mV), as a data sheet's limits cut a production; DAC non-linearity evenly within its limits.
/// Magnet scatter: rms amplitudes 0.24, 0.25, 0.22 and 0.09 deg of orders 1, 3, 4, 5 for 2 % and 1 deg per
/// bar. Source: resources/help/htm-theory.md sections 4.3 and 9.
HtmSpecimen drawSpecimen(const HtmParameters& parameters, std::uint64_t seed);

} // namespace halbench::models
