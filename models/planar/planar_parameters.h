#pragma once

#include "control/base/result.h"
#include "models/planar/planar_geometry.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::models {

/// Individual errors of one two-axis Hall chip; a value without a number is drawn from the seed.
struct ChipErrorParameters {
    std::optional<double> gainX_ratio; ///< relative error of the sensitivity along x'
    std::optional<double> gainY_ratio;
    std::optional<double> offsetX_T;
    std::optional<double> offsetY_T;
    std::optional<double> crossXy_ratio; ///< share of B_y' in the reading of x'
    std::optional<double> crossYx_ratio;
    std::optional<double> placeX_m; ///< true minus nominal place, platen axes
    std::optional<double> placeY_m;
    std::optional<double> height_m; ///< true minus nominal height
};

/// Every number of the planar six-coil positioner that the simulation uses, SI. Frames and signs: PlanarPose,
/// PlanarCoil. Source: resources/help/planar-theory.md section 3. A value without a number is an individual
/// error of this specimen, drawn from the seed with the spread that stands beside it.
struct PlanarParameters {
    PlanarGeometry geometry;
    double mass_kg = 0.64;
    double inertia_kg_m2 = 1e-3;   ///< about the real centre of mass
    double massCentreX_m = 0.8e-3; ///< real centre of mass in platen axes
    double massCentreY_m = -0.6e-3;
    double initialX_m = 6.35e-3;
    double initialY_m = -6.35e-3;
    double initialAngle_rad = 0.0;
    double latticePitches = 6.0; ///< edge length of the magnet matrix

    double coilResistance_Ohm = 1.98;
    double coilInductance_H = 1.28e-3;
    double currentLimit_A = 1.0;
    std::array<double, CoilCount> coilGain_ratio{1.02, 0.985, 1.01, 0.99, 1.015, 0.98};
    double amplifierGain_A_per_V = 0.506;
    double amplifierBandwidth_Hz = 6893.0;
    double amplifierSupply_V = 24.0;  ///< largest voltage at a coil
    double amplifierOutput_Ohm = 2e3; ///< of the current source: a voltage e in the coil takes e/this off
    double dacBits = 16.0;
    double dacRange_V = 5.0;   ///< plus and minus
    double delaySamples = 1.0; ///< of the board's loop

    double hallField_T = 20e-3; ///< b_s: in-plane amplitude at the nominal height of the chips
    std::array<double, ChipCount> chipX_m{-63.5e-3, 63.5e-3, 0.0}; ///< nominal places, platen axes
    std::array<double, ChipCount> chipY_m{-19.05e-3, -19.05e-3, 19.05e-3};
    double hallNoise_T = 18e-6;             ///< rms per reading
    double hallRange_T = 40e-3;             ///< a chip clips there
    double hallSensitivity_V_per_T = 200.0; ///< after conditioning
    double adcBits = 16.0;
    double adcRange_V = 5.0;      ///< plus and minus
    double crosstalk_ratio = 0.0; ///< 1: the field of the coils at the chips as it follows from their places
    std::array<ChipErrorParameters, ChipCount> chipErrors;
    double hallGainSpread_ratio = 0.01; ///< spreads: 1 sigma, cut at 2
    double hallOffsetSpread_T = 1e-4;
    double hallCrossSpread_ratio = 5e-3;
    double hallPlaceSpread_m = 1e-4;
    double hallHeightSpread_m = 1e-4;

    double cableStiffness_N_per_m = 2.0; ///< of the cable at its anchor, relaxed at the pose zero
    double cableTorsion_Nm_per_rad = 5e-3;
    double cableX_m = 0.0; ///< anchor, platen axes
    double cableY_m = -20e-3;
    double slowForce_N = 0.5e-3; ///< rms per axis, at the anchor
    double slowForceCorner_Hz = 5.0;
    double damping_Ns_per_m = 0.1; ///< of the air films, about the real centre of mass
    double damping_Nms_per_rad = 1e-4;
    double travel_m = 50e-3; ///< plus and minus, x and y
    double travel_rad = 20e-3;
    double stopStiffness_N_per_m = 2e4;
    double stopStiffness_Nm_per_rad = 200.0;
    double stopDamping_ratio = 0.3;          ///< of critical, for the platen on the stop's spring
    double bearingStiffness_N_per_m = 1.7e7; ///< of each of the three, one under each set of coils

    double ambient_degC = 25.0;
    double coilHeatCapacity_J_per_K = 16.0; ///< 42 g of copper
    double coilThermalResistance_K_per_W = 12.0;
    double copperTemperature_per_K = 0.00393;
    double thermalAcceleration_ratio = 1.0; ///< thermal seconds per mechanical second; 0: no heating
    std::optional<double> temperatureError_K;
    double temperatureSpread_K = 1.0;

    double wrench = 0.0; ///< WrenchModel of the coils' forces, an index
    std::array<double, ChipCount> chipFault{}; ///< ChipFault of each, an index
    double faultAfter_s = 0.0; ///< from then on the chips have their faults

    bool isIdealChain = false; ///< converters keep fractions, currents follow at once
};

/// One editable value: how it is named in a device address and which values are possible.
struct PlanarParameterSpec {
    std::string_view key;
    std::string_view unit; ///< of the value as written; SI symbol unless the key names another unit
    double min = 0.0;
    double max = 0.0;
    double toSi = 1.0;        ///< SI value = written value * toSi
    char provenance = 'A';    ///< G given by the publication, D derived, A assumed, X given but doubtful
    std::string_view meaning; ///< one sentence
    double& (*value)(PlanarParameters&) = nullptr;
    std::optional<double>& (*specimen)(PlanarParameters&) = nullptr; ///< instead of `value` if drawn by seed
    std::string_view words = {}; ///< of a choice, separated by '|'; the value is the word's index
};

/// Symbol of the equations for a value whose key names a unit; written in SI.
struct PlanarSymbol {
    std::string_view symbol;
    std::string_view key; ///< of a PlanarParameterSpec
    std::string_view unit;
};

/// The closed list of values, in the order of the help page.
std::span<const PlanarParameterSpec> planarParameterSpecs();
/// Second names of some of them.
std::span<const PlanarSymbol> planarSymbols();

/// The value that a key or a symbol names; nullptr if there is none.
const PlanarParameterSpec* findPlanarParameter(std::string_view key);

/// The words of a choice; empty for a number or an unknown key.
std::vector<std::string> planarParameterWords(std::string_view key);

/// "m, Iz, ... sigma_B, seed, imperfections, chain": every key of an address, for messages.
std::string planarParameterKeys();

/// Sets one value by its key, given in the key's unit, or by its symbol, in SI. Errors: UnknownName (the hint
/// lists the known keys), NotFinite, OutOfRange.
Result<void> setPlanarParameter(PlanarParameters& parameters, std::string_view key, double value);

/// The value in the unit that setPlanarParameter() takes; empty for a specimen's error that the seed decides.
/// The key must exist.
std::optional<double> planarParameter(const PlanarParameters& parameters, std::string_view key);

/// OutOfRange when values that are possible alone make no machine together: coils wider than their window.
Result<void> checkPlanarParameters(const PlanarParameters& parameters);

/// A free mass with the published values: no noise, sensor errors, crosstalk, coil spread, cable, slow force,
/// heating or offset of the centre of mass. Converters, amplifiers and air damping stay.
PlanarParameters withoutImperfections(PlanarParameters parameters);

/// No imperfections, exact converters, currents that follow at once.
PlanarParameters withIdealChain(PlanarParameters parameters);

} // namespace halbench::models
