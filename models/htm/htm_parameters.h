#pragma once

#include "control/base/result.h"
#include "models/drives/amplifier.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace halbench::models {

/// Every number of the two-phase Halbach-cylinder motor that the simulation uses, SI.
/// Conventions, defined here once: `psi` is the rotor's mechanical angle (two poles: electrical =
/// mechanical), unbounded, positive current pushes it upward; phase currents I_A = -I sin psi, I_B = I cos
/// psi; sensor a sits at 0 degrees and sees B0 cos psi, sensor b at 90 degrees and sees B0 sin psi. Source:
/// resources/help/htm-theory.md sections 2 and 9. A value without a number (`std::nullopt`) is an individual
/// error of this specimen: it is drawn from the seed with the spread that stands beside it.
struct HtmParameters {
    double inertia_kg_m2 = 5.5e-4;
    double viscousDamping_Nm_s = 1.23e-3;
    double coulombFriction_Nm = 2.05e-2;
    double torqueConstant_Nm_per_A = 1.43e-2; ///< per ampere of current amplitude
    double currentLimit_A = 4.0;
    double field_T = 0.157; ///< B0 at the sensors
    double initialAngle_rad = 0.0;
    AmplifierParts amplifier; ///< holds R_a and L_a of one phase too

    double hallSensitivity_V_per_T = 12.5;
    double hallSensitivityTemperature_per_K = 0.0012;
    double hallQuiescent_V = 2.5;
    double stray_T_per_A = 2.5e-3; ///< field of a phase current at its own sensor
    double delaySamples = 0.0;     ///< computation delay of the board's position loop

    double staticFriction_ratio = 1.15;   ///< K_s / K_f
    double frictionScatter_ratio = 0.033; ///< 1 sigma, drawn anew at each plateau and each start from rest
    double frictionPerTurn_ratio = 0.03;  ///< amplitude of the once-per-turn part
    double frictionAsymmetry_ratio = 0.0; ///< (K+ - K-)/(K+ + K-)
    double stribeckSpeed_rad_s = 0.0;     ///< 0: friction falls from K_s to K_f at the first motion

    double hallNoise_T = 1.84e-5; ///< rms per sample
    std::optional<double> hallOffset_T;
    double hallOffsetSpread_T = 2.0e-3; ///< 1 sigma (25 mV), at most 70 mV
    std::optional<double> hallGainError_ratio;
    double hallGainSpread_ratio = 0.025;      ///< 1 sigma of each sensor, at most two sigma
    double hallLinearitySpread_ratio = 0.005; ///< 1 sigma of the cubic share, at most two sigma
    std::optional<double> quadrature_rad;
    double quadratureSpread_rad = 0.5 * 3.14159265358979323846 / 180.0;
    double sensorRadiusSpread_m = 2e-4;
    double magnetScatter_ratio =
        0.02; ///< of remanence; the angle scatter of the bars goes with it (2 %: 1 deg)

    double magnetTemperature_per_K = -0.0012; ///< of field and torque constant; magnets are at ambient
    double ambient_degC = 25.0;
    double hallThermalCoupling_ratio = 0.5; ///< share of the coil's rise that its Hall sensor follows
    std::optional<double> temperatureError_K;
    double temperatureSpread_K = 1.0; ///< 1 sigma, at most two sigma
    double coilHeatCapacity_J_per_K = 32.0;
    double coilThermalResistance_K_per_W = 15.0;
    double copperTemperature_per_K = 0.00393;
    double thermalAcceleration_ratio = 1.0; ///< thermal seconds per mechanical second; 0: no heating

    std::optional<double> dacGainError_ratio;
    double dacGainSpread_ratio = 0.002; ///< 1 sigma, at most two sigma (+-0.4 %)
    std::optional<double> dacNonLinearity_codes;
    double dacNonLinearityLimit_codes = 2.0; ///< drawn evenly between minus and plus this

    bool isIdealChain = false; ///< level A: exact angle, torque = phi I, no sampling of the field
};

/// One editable value: how it is named in a device address and which values are possible.
struct HtmParameterSpec {
    std::string_view key;  ///< e.g. "stray_mT_per_A"
    std::string_view unit; ///< of the value as written; SI symbol unless the key names another unit
    double min = 0.0;
    double max = 0.0;
    double toSi = 1.0;        ///< SI value = written value * toSi
    char provenance = 'A';    ///< G given by the publication, D derived, A assumed, X given but contradictory
    std::string_view meaning; ///< one sentence
    double& (*value)(HtmParameters&) = nullptr;
    std::optional<double>& (*specimen)(HtmParameters&) = nullptr; ///< set instead of `value` if drawn by seed
};

/// The closed list of values, in the order of the help page.
std::span<const HtmParameterSpec> htmParameterSpecs();

/// nullptr if there is no such key.
const HtmParameterSpec* findHtmParameter(std::string_view key);

/// "J, c, Kf, ... seed, imperfections, chain": every key of an address, for messages.
std::string htmParameterKeys();

/// Sets one value by its key, given in the key's unit. Errors: UnknownName (the hint lists the known keys),
/// NotFinite, OutOfRange.
Result<void> setHtmParameter(HtmParameters& parameters, std::string_view key, double value);

/// The value in the key's unit; empty for a specimen's error that the seed decides. The key must exist.
std::optional<double> htmParameter(const HtmParameters& parameters, std::string_view key);

/// No noise, offsets, gain or quadrature error, magnet or friction scatter, stray field, converter error or
/// heating, and K_s = K_f. Quantisation and amplifier stay.
HtmParameters withoutImperfections(HtmParameters parameters);

/// Level A of resources/help/htm-theory.md section 8: no imperfections, exact angle and torque.
HtmParameters withIdealChain(HtmParameters parameters);

} // namespace halbench::models
