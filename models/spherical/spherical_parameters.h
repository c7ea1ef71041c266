#pragma once

#include "control/base/result.h"
#include "models/fields/spherical_harmonic_rotor.h"
#include "models/spherical/current_loop.h"
#include "models/spherical/rotor_field.h"
#include "models/spherical/rotor_motion.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::models {

/// The device: physical, or the published model with additive angles.
enum class SphericalDevice { Exact, Additive };
inline constexpr std::array<std::string_view, 2> SphericalDeviceNames = {"exact", "paper"};

/// Noise of a reading, rms: none, an averaged part, a single shot, a poor part.
inline constexpr std::array<double, 4> NoisePresets_T = {0.0, 25e-6, 100e-6, 1e-3};

/// Individual errors of one sensor, (R, Theta, Phi) or stator x, y, z; a value without a number is drawn from
/// the seed.
struct FieldSensorErrors {
    std::array<std::optional<double>, 3> gain_ratio;
    std::array<std::optional<double>, 3> offset_T;
    std::array<std::optional<double>, 3> turn_rad; ///< mounting: rotation vector
    std::array<std::optional<double>, 3> shift_m;  ///< mounting: place
};

/// Every number of the simulated spherical motor sensing, SI. Source: resources/help/spherical-theory.md
/// sections 2 to 4.
struct SphericalParameters {
    SphericalRotorMagnet magnet;
    double device = 0.0; ///< SphericalDevice
    double sensorRadius_m = 0.05;
    double frames = 0.0; ///< SensorFrames
    SensorTriple placement = publishedPlacement();
    double harmonics = 0.0; ///< HarmonicPreset
    /// Amplitudes at 50 mm instead of those of the preset: (4,2), (6,2), (6,6), (10,10).
    std::array<std::optional<double>, 4> amplitude_T;

    std::array<FieldSensorErrors, 3> errors;
    double gainSpread_ratio = 0.01; ///< spreads: 1 sigma, cut at 2
    double offsetSpread_T = 1e-3;
    double crossSpread_ratio = 2e-3;
    double turnSpread_rad = 0.01745329251994329577;
    double shiftSpread_m = 1e-4;
    double noisePreset = 2.0; ///< index of NoisePresets_T
    double noise_T = NoisePresets_T[2];
    double converter = 0.0;        ///< ConverterPreset
    std::array<double, 9> fault{}; ///< ChannelFault of each channel

    Eigen::Vector3d strayField_T = Eigen::Vector3d::Zero();
    double coilTheta_rad = 1.48352986419518; ///< 85 degrees
    double coilPhi_rad = 0.05235987755982988;
    double coilDistance_m = 75e-3; ///< of its centre from that of the rotor; the axis is radial
    double coilRadius_m = 10e-3;
    double coilTurns = 200.0;
    double coilCurrent_A = 0.0;

    double ambient_degC = 25.0; ///< of the magnet at the start
    double warmRise_K = 0.0;    ///< it approaches ambient + rise
    double warmTime_s = 600.0;  ///< time constant
    double strengthTemperature_per_K = -1.1e-3;
    std::optional<double> temperatureError_K;
    double temperatureSpread_K = 1.0;

    double motion = 0.0; ///< MotionKind; a table is given to the plant
    OrientationAngles start;
    double rate_rad_s = 1.0;
    double spin_rad = 0.0;
    double sampleTime_s = 0.1;
    double tilt_rad = 0.69813170079773179;
    double tumbleFrequency_Hz = 0.2;
    double walk_rad_per_rootS = 0.5;

    bool isIdealChain = false; ///< converters neither round nor clip
};

/// One editable value: how it is named in a device address and which values are possible.
struct SphericalParameterSpec {
    std::string_view key;
    std::string_view unit; ///< of the value as written
    double min = 0.0;
    double max = 0.0;
    double toSi = 1.0;
    char provenance = 'A'; ///< S stated by the source, D derived, A assumed
    std::string_view meaning;
    double& (*value)(SphericalParameters&) = nullptr;
    std::optional<double>& (*specimen)(SphericalParameters&) = nullptr; ///< instead of `value`
    bool isWhole = false;
    std::string_view words = {}; ///< of a choice, separated by '|'; the value is the word's index
};

/// The closed list of values, in the order of the help page.
std::span<const SphericalParameterSpec> sphericalParameterSpecs();
/// nullptr if there is no such key.
const SphericalParameterSpec* findSphericalParameter(std::string_view key);
/// Every key of an address, for messages.
std::string sphericalParameterKeys();

/// The words of a choice; empty for a number or an unknown key.
std::vector<std::string> sphericalParameterWords(std::string_view key);

/// Sets one value by its key, given in the key's unit. The preset `noise` sets `noise_uT`. Errors:
/// UnknownName, NotFinite, OutOfRange.
Result<void> setSphericalParameter(SphericalParameters& parameters, std::string_view key, double value);
/// The value in the key's unit; empty for one that seed or preset decide. The key must exist.
std::optional<double> sphericalParameter(const SphericalParameters& parameters, std::string_view key);

/// OutOfRange when values make no device together: no shell of magnet, sensors inside the rotor or at one
/// place, a coil inside the rotor.
Result<void> checkSphericalParameters(const SphericalParameters& parameters);

/// Sensors without errors, noise, stray and coil field; the converters stay.
SphericalParameters withoutImperfections(SphericalParameters parameters);
/// No imperfections, and the exact field as readings.
SphericalParameters withIdealChain(SphericalParameters parameters);

/// Field of the rotor at 25 degC with the reference radius 50 mm, where harmonics are given.
RotorFieldConfig rotorFieldOf(const SphericalParameters& parameters);
CurrentLoop statorCoilOf(const SphericalParameters& parameters);
RotorMotionConfig motionOf(const SphericalParameters& parameters);

} // namespace halbench::models
