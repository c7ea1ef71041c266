#pragma once

#include "control/base/random.h"
#include "control/base/result.h"
#include "control/base/units.h"

#include <array>
#include <vector>

namespace halbench::models {

/// One order of the field a sensor sees per turn, relative to the fundamental's amplitude:
/// cosine cos(order theta) + sine sin(order theta), theta = psi - placement.
struct FieldHarmonic {
    int order = 0;
    double cosine_ratio = 0.0;
    double sine_ratio = 0.0;
};

/// A linear Hall sensor that looks at the rotor's turning field, in volts:
///   B = B0 g [cos theta + harmonics] + k_s i + o + noise,   theta = psi - placement
///   V = V_Q + S25 (1 + S_TC (T_sensor - 25)) B,             clipped to clipLow ... clipHigh
/// Source: resources/help/htm-theory.md sections 2, 3.4 and 9.
struct HallConfig {
    double placement_rad = 0.0;    ///< angular position of the sensor: 0 for a, pi/2 - eps for b
    double field_T = 0.157;        ///< B0: amplitude of the fundamental at this sensor
    double gain_ratio = 1.0;       ///< g: error of sensitivity and radius
    double offset_T = 0.0;         ///< o: zero-field error expressed as field
    double stray_T_per_A = 2.5e-3; ///< k_s: field of the sensor's own phase current
    double noise_T = 0.0;          ///< rms of each sample; 18.4 uT for the real part
    std::vector<FieldHarmonic> harmonics;

    double quiescent_V = 2.5;
    double sensitivity_V_per_T = 12.5;            ///< at 25 degC
    double sensitivityTemperature_per_K = 0.0012; ///< relative change of the sensitivity
    double clipLow_V = 0.2;
    double clipHigh_V = 4.8;
};

/// OutOfRange or NotFinite when the configuration describes no possible sensor.
Result<void> checkHallConfig(const HallConfig& config);

/// Sensors a (at 0 degrees) and b (at 90 degrees) with the quadrature error eps: B_B ~ sin(psi + eps).
std::array<HallConfig, 2> hallPair(const HallConfig& nominal, double quadrature_rad);

/// The field at the sensor without noise, tesla.
double hallField_T(const HallConfig& config, double angle_rad, double ownPhaseCurrent_A);

/// The sensor's output voltage; draws one normal number from `noise` only when noise_T is not zero.
double hallVoltage_V(const HallConfig& config, double angle_rad, double ownPhaseCurrent_A,
                     double sensorTemperature_degC, Random& noise);

/// The output voltage of a given field, with the clip of the output stage.
double hallVoltageOfField_V(const HallConfig& config, double field_T, double sensorTemperature_degC);

/// The conversion back, with the temperature the board believes: B = (V - V_Q) / (S25 (1 + S_TC (T - 25))).
double hallFieldOfVoltage_T(const HallConfig& config, double voltage_V, double reportedTemperature_degC);

} // namespace halbench::models
