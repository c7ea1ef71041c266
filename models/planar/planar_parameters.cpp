#include "models/planar/planar_parameters.h"

#include "control/base/assert.h"
#include "control/base/choice_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

using P = PlanarParameters;

constexpr std::string_view WrenchWords = "windings|prism|published"; // as WrenchModel
constexpr std::string_view FaultWords = "none|dead|stuck|clipped";   // as ChipFault

// A value that every specimen shares / an error that is drawn unless it is written down.
#define HB_SHARED(member) [](P& p) -> double& { return p.member; }, nullptr
#define HB_SPECIMEN(member) nullptr, [](P& p) -> std::optional<double>& { return p.member; }
#define HB_CHOICE(key, words, meaning, member)                                                               \
    PlanarParameterSpec {                                                                                    \
        key, "", 0.0, lastChoice(words), 1.0, 'A', meaning, HB_SHARED(member), words                         \
    }

// The errors of one chip, in the same words for each: plus and minus a limit.
#define HB_ERROR(key, unit, limit, toSi, meaning, member)                                                    \
    PlanarParameterSpec {                                                                                    \
        key, unit, -(limit), limit, toSi, 'A', meaning "; drawn if not given", HB_SPECIMEN(member)           \
    }
#define HB_CHIP(n, i)                                                                                        \
    HB_ERROR("hall" n "_gain_error_x", "", 0.2, 1.0, "x' gain error of chip " n, chipErrors[i].gainX_ratio), \
        HB_ERROR("hall" n "_gain_error_y", "", 0.2, 1.0, "y' gain error of chip " n,                         \
                 chipErrors[i].gainY_ratio),                                                                 \
        HB_ERROR("hall" n "_offset_x_uT", "uT", 2e3, Micro, "x' zero offset of chip " n,                     \
                 chipErrors[i].offsetX_T),                                                                   \
        HB_ERROR("hall" n "_offset_y_uT", "uT", 2e3, Micro, "y' zero offset of chip " n,                     \
                 chipErrors[i].offsetY_T),                                                                   \
        HB_ERROR("hall" n "_cross_xy", "", 0.2, 1.0, "share of By' in Bx' of chip " n,                       \
                 chipErrors[i].crossXy_ratio),                                                               \
        HB_ERROR("hall" n "_cross_yx", "", 0.2, 1.0, "share of Bx' in By' of chip " n,                       \
                 chipErrors[i].crossYx_ratio),                                                               \
        HB_ERROR("hall" n "_place_error_x_mm", "mm", 2.0, Milli, "x' place error of chip " n,                \
                 chipErrors[i].placeX_m),                                                                    \
        HB_ERROR("hall" n "_place_error_y_mm", "mm", 2.0, Milli, "y' place error of chip " n,                \
                 chipErrors[i].placeY_m),                                                                    \
        HB_ERROR("hall" n "_height_error_mm", "mm", 2.0, Milli, "height error of chip " n,                   \
                 chipErrors[i].height_m),                                                                    \
        HB_CHOICE("hall" n "_fault", FaultWords, "fault of chip " n, chipFault[i])

constexpr double Milli = 1e-3;
constexpr double Micro = 1e-6;

const std::array Specs = {
    // machine
    PlanarParameterSpec{"m", "kg", 0.1, 10.0, 1.0, 'G', "moving mass", HB_SHARED(mass_kg)},
    PlanarParameterSpec{"Iz", "kg*m^2", 2e-4, 0.1, 1.0, 'X', "inertia about the vertical",
                        HB_SHARED(inertia_kg_m2)},
    PlanarParameterSpec{"cm_x_mm", "mm", -20.0, 20.0, Milli, 'A', "real centre of mass along x'",
                        HB_SHARED(massCentreX_m)},
    PlanarParameterSpec{"cm_y_mm", "mm", -20.0, 20.0, Milli, 'A', "real centre of mass along y'",
                        HB_SHARED(massCentreY_m)},
    PlanarParameterSpec{"x0_mm", "mm", -100.0, 100.0, Milli, 'A', "x at the start", HB_SHARED(initialX_m)},
    PlanarParameterSpec{"y0_mm", "mm", -100.0, 100.0, Milli, 'A', "y at the start", HB_SHARED(initialY_m)},
    PlanarParameterSpec{"phi0_mrad", "mrad", -45.0, 45.0, Milli, 'A', "rotation at the start",
                        HB_SHARED(initialAngle_rad)},
    PlanarParameterSpec{"L_mm", "mm", 30.0, 100.0, Milli, 'G', "pitch of the magnet matrix",
                        HB_SHARED(geometry.matrix.pitch_m)},
    PlanarParameterSpec{"magnet_thickness_mm", "mm", 1.0, 50.0, Milli, 'G', "height of the magnet blocks",
                        HB_SHARED(geometry.matrix.thickness_m)},
    PlanarParameterSpec{"mu0M0", "T", 0.1, 1.2, 1.0, 'D', "peak magnetisation of one array",
                        HB_SHARED(geometry.matrix.magnetisation_T)},
    PlanarParameterSpec{"lattice_pitches", "", 4.0, 40.0, 1.0, 'A', "edge of the magnet matrix in pitches",
                        HB_SHARED(latticePitches)},
    PlanarParameterSpec{"coil_width_mm", "mm", 0.5, 20.0, Milli, 'D', "width of a coil's winding",
                        HB_SHARED(geometry.winding.width_m)},
    PlanarParameterSpec{"coil_height_mm", "mm", 0.5, 30.0, Milli, 'D', "height of a coil's winding",
                        HB_SHARED(geometry.winding.height_m)},
    PlanarParameterSpec{"lambda", "1/m", 100.0, 2e4, 1.0, 'G', "turns per width",
                        HB_SHARED(geometry.winding.turnsPerWidth_1_m)},
    PlanarParameterSpec{"beta", "1/m", 100.0, 2e4, 1.0, 'G', "layers per height",
                        HB_SHARED(geometry.winding.layersPerHeight_1_m)},
    PlanarParameterSpec{"z1_mm", "mm", 0.1, 20.0, Milli, 'D', "gap from the magnets to the coils",
                        HB_SHARED(geometry.gap_m)},
    PlanarParameterSpec{"c56_mm", "mm", 10.0, 200.0, Milli, 'G', "arm of coils 5 and 6",
                        HB_SHARED(geometry.arm56_m)},
    // coils and amplifiers
    PlanarParameterSpec{"R", "Ohm", 0.1, 100.0, 1.0, 'G', "resistance of a coil",
                        HB_SHARED(coilResistance_Ohm)},
    PlanarParameterSpec{"L_c", "H", 1e-6, 1.0, 1.0, 'G', "inductance of a coil", HB_SHARED(coilInductance_H)},
    PlanarParameterSpec{"Imax", "A", 0.1, 2.5, 1.0, 'G', "current limit of a coil",
                        HB_SHARED(currentLimit_A)},
    PlanarParameterSpec{"coil_gain_1", "", 0.5, 1.5, 1.0, 'A', "force of coil 1 over its nominal one",
                        HB_SHARED(coilGain_ratio[0])},
    PlanarParameterSpec{"coil_gain_2", "", 0.5, 1.5, 1.0, 'A', "force of coil 2 over its nominal one",
                        HB_SHARED(coilGain_ratio[1])},
    PlanarParameterSpec{"coil_gain_3", "", 0.5, 1.5, 1.0, 'A', "force of coil 3 over its nominal one",
                        HB_SHARED(coilGain_ratio[2])},
    PlanarParameterSpec{"coil_gain_4", "", 0.5, 1.5, 1.0, 'A', "force of coil 4 over its nominal one",
                        HB_SHARED(coilGain_ratio[3])},
    PlanarParameterSpec{"coil_gain_5", "", 0.5, 1.5, 1.0, 'A', "force of coil 5 over its nominal one",
                        HB_SHARED(coilGain_ratio[4])},
    PlanarParameterSpec{"coil_gain_6", "", 0.5, 1.5, 1.0, 'A', "force of coil 6 over its nominal one",
                        HB_SHARED(coilGain_ratio[5])},
    PlanarParameterSpec{"amplifier_gain", "A/V", 0.01, 10.0, 1.0, 'G', "current per volt of an amplifier",
                        HB_SHARED(amplifierGain_A_per_V)},
    PlanarParameterSpec{"amplifier_bandwidth_Hz", "Hz", 50.0, 1e5, 1.0, 'G', "bandwidth of an amplifier",
                        HB_SHARED(amplifierBandwidth_Hz)},
    PlanarParameterSpec{"amplifier_supply_V", "V", 5.0, 200.0, 1.0, 'A', "largest voltage at a coil",
                        HB_SHARED(amplifierSupply_V)},
    PlanarParameterSpec{"amplifier_output_Ohm", "Ohm", 100.0, 1e9, 1.0, 'A',
                        "output resistance of an amplifier", HB_SHARED(amplifierOutput_Ohm)},
    PlanarParameterSpec{"dac_bits", "", 8.0, 20.0, 1.0, 'G', "resolution of the outputs", HB_SHARED(dacBits)},
    PlanarParameterSpec{"dac_range_V", "V", 1.0, 20.0, 1.0, 'A', "range of the outputs, plus and minus",
                        HB_SHARED(dacRange_V)},
    PlanarParameterSpec{"delay_samples", "", 0.0, 2.0, 1.0, 'A', "computation delay of the position loop",
                        HB_SHARED(delaySamples)},
    // Hall chips
    PlanarParameterSpec{"hall_field_mT", "mT", 1.0, 24.0, Milli, 'A', "in-plane field amplitude at the chips",
                        HB_SHARED(hallField_T)},
    PlanarParameterSpec{"hall1_x_mm", "mm", -200.0, 200.0, Milli, 'A', "place of chip 1 along x'",
                        HB_SHARED(chipX_m[0])},
    PlanarParameterSpec{"hall1_y_mm", "mm", -200.0, 200.0, Milli, 'A', "place of chip 1 along y'",
                        HB_SHARED(chipY_m[0])},
    PlanarParameterSpec{"hall2_x_mm", "mm", -200.0, 200.0, Milli, 'A', "place of chip 2 along x'",
                        HB_SHARED(chipX_m[1])},
    PlanarParameterSpec{"hall2_y_mm", "mm", -200.0, 200.0, Milli, 'A', "place of chip 2 along y'",
                        HB_SHARED(chipY_m[1])},
    PlanarParameterSpec{"hall3_x_mm", "mm", -200.0, 200.0, Milli, 'A', "place of chip 3 along x'",
                        HB_SHARED(chipX_m[2])},
    PlanarParameterSpec{"hall3_y_mm", "mm", -200.0, 200.0, Milli, 'A', "place of chip 3 along y'",
                        HB_SHARED(chipY_m[2])},
    PlanarParameterSpec{"hall_noise_uT", "uT", 0.0, 5000.0, Micro, 'A', "Hall noise per reading, rms",
                        HB_SHARED(hallNoise_T)},
    PlanarParameterSpec{"hall_range_mT", "mT", 1.0, 1000.0, Milli, 'A', "field at which a chip clips",
                        HB_SHARED(hallRange_T)},
    PlanarParameterSpec{"hall_V_per_T", "V/T", 1.0, 1000.0, 1.0, 'A', "sensitivity after conditioning",
                        HB_SHARED(hallSensitivity_V_per_T)},
    PlanarParameterSpec{"adc_bits", "", 8.0, 20.0, 1.0, 'G', "resolution of the inputs", HB_SHARED(adcBits)},
    PlanarParameterSpec{"adc_range_V", "V", 1.0, 20.0, 1.0, 'A', "range of the inputs, plus and minus",
                        HB_SHARED(adcRange_V)},
    PlanarParameterSpec{"crosstalk", "", 0.0, 5.0, 1.0, 'A',
                        "field of the coils at the chips over the calculated one",
                        HB_SHARED(crosstalk_ratio)},
    HB_CHIP("1", 0),
    HB_CHIP("2", 1),
    HB_CHIP("3", 2),
    PlanarParameterSpec{"fault_after_s", "s", 0.0, 1e4, 1.0, 'A', "time after which chips have their faults",
                        HB_SHARED(faultAfter_s)},
    PlanarParameterSpec{"hall_gain_sigma", "", 0.0, 0.1, 1.0, 'A', "spread of the drawn gains, 1 sigma",
                        HB_SHARED(hallGainSpread_ratio)},
    PlanarParameterSpec{"hall_offset_sigma_uT", "uT", 0.0, 2000.0, Micro, 'A',
                        "spread of the drawn offsets, 1 sigma", HB_SHARED(hallOffsetSpread_T)},
    PlanarParameterSpec{"hall_cross_sigma", "", 0.0, 0.1, 1.0, 'A', "spread of the drawn cross-axis shares",
                        HB_SHARED(hallCrossSpread_ratio)},
    PlanarParameterSpec{"hall_place_sigma_mm", "mm", 0.0, 1.0, Milli, 'A', "spread of the drawn places",
                        HB_SHARED(hallPlaceSpread_m)},
    PlanarParameterSpec{"hall_height_sigma_mm", "mm", 0.0, 1.0, Milli, 'A', "spread of the drawn heights",
                        HB_SHARED(hallHeightSpread_m)},
    // cable, air films, stops, bearings
    PlanarParameterSpec{"cable_N_per_m", "N/m", 0.0, 500.0, 1.0, 'A', "stiffness of the cable",
                        HB_SHARED(cableStiffness_N_per_m)},
    PlanarParameterSpec{"cable_Nm_per_rad", "N*m/rad", 0.0, 10.0, 1.0, 'A', "torsion of the cable",
                        HB_SHARED(cableTorsion_Nm_per_rad)},
    PlanarParameterSpec{"cable_x_mm", "mm", -200.0, 200.0, Milli, 'A', "anchor of the cable along x'",
                        HB_SHARED(cableX_m)},
    PlanarParameterSpec{"cable_y_mm", "mm", -200.0, 200.0, Milli, 'A', "anchor of the cable along y'",
                        HB_SHARED(cableY_m)},
    PlanarParameterSpec{"slow_force_mN", "mN", 0.0, 100.0, Milli, 'A', "slow random force per axis, rms",
                        HB_SHARED(slowForce_N)},
    PlanarParameterSpec{"slow_force_Hz", "Hz", 0.01, 50.0, 1.0, 'A', "corner of the slow random force",
                        HB_SHARED(slowForceCorner_Hz)},
    PlanarParameterSpec{"damping", "N*s/m", 0.0, 100.0, 1.0, 'A', "damping of the motion in the plane",
                        HB_SHARED(damping_Ns_per_m)},
    PlanarParameterSpec{"damping_phi", "N*m*s/rad", 0.0, 1.0, 1.0, 'A', "damping of the rotation",
                        HB_SHARED(damping_Nms_per_rad)},
    PlanarParameterSpec{"travel_mm", "mm", 5.0, 100.0, Milli, 'A', "travel from the middle to a stop",
                        HB_SHARED(travel_m)},
    PlanarParameterSpec{"travel_mrad", "mrad", 1.0, 45.0, Milli, 'A', "rotation from the middle to a stop",
                        HB_SHARED(travel_rad)},
    PlanarParameterSpec{"stop_N_per_m", "N/m", 1e3, 1e5, 1.0, 'A', "stiffness of the stops",
                        HB_SHARED(stopStiffness_N_per_m)},
    PlanarParameterSpec{"stop_Nm_per_rad", "N*m/rad", 1.0, 400.0, 1.0, 'A', "stiffness of the stops in angle",
                        HB_SHARED(stopStiffness_Nm_per_rad)},
    PlanarParameterSpec{"stop_damping", "", 0.0, 1.0, 1.0, 'A', "damping of the stops over the critical one",
                        HB_SHARED(stopDamping_ratio)},
    PlanarParameterSpec{"k_b", "N/m", 1e5, 1e9, 1.0, 'G', "stiffness of each air bearing",
                        HB_SHARED(bearingStiffness_N_per_m)},
    HB_CHOICE("wrench", WrenchWords, "model of the coils' forces, section 5", wrench),
    // heat
    PlanarParameterSpec{"ambient_C", "degC", -20.0, 60.0, 1.0, 'A', "ambient temperature",
                        HB_SHARED(ambient_degC)},
    PlanarParameterSpec{"coil_heat_capacity", "J/K", 0.1, 1e4, 1.0, 'A', "heat capacity of a coil",
                        HB_SHARED(coilHeatCapacity_J_per_K)},
    PlanarParameterSpec{"coil_thermal_resistance", "K/W", 0.1, 1e3, 1.0, 'A', "from a coil to ambient",
                        HB_SHARED(coilThermalResistance_K_per_W)},
    PlanarParameterSpec{"copper_TC", "1/K", 0.0, 0.01, 1.0, 'A', "temperature coefficient of the resistance",
                        HB_SHARED(copperTemperature_per_K)},
    PlanarParameterSpec{"thermal_acceleration", "", 0.0, 1e4, 1.0, 'A',
                        "thermal seconds per second; 0: no heating", HB_SHARED(thermalAcceleration_ratio)},
    PlanarParameterSpec{"temperature_error_C", "degC", -10.0, 10.0, 1.0, 'A',
                        "error of the temperature sensors; drawn for each if not given",
                        HB_SPECIMEN(temperatureError_K)},
    PlanarParameterSpec{"temperature_sigma_C", "degC", 0.0, 5.0, 1.0, 'A',
                        "spread of the drawn temperature errors", HB_SHARED(temperatureSpread_K)},
};

constexpr std::array Symbols = {
    PlanarSymbol{"L", "L_mm", "m"},
    PlanarSymbol{"Delta", "magnet_thickness_mm", "m"},
    PlanarSymbol{"a", "coil_width_mm", "m"},
    PlanarSymbol{"d", "coil_height_mm", "m"},
    PlanarSymbol{"z1", "z1_mm", "m"},
    PlanarSymbol{"c56", "c56_mm", "m"},
    PlanarSymbol{"b_s", "hall_field_mT", "T"},
    PlanarSymbol{"sigma_B", "hall_noise_uT", "T"},
};

#undef HB_CHIP
#undef HB_CHOICE
#undef HB_ERROR
#undef HB_SHARED
#undef HB_SPECIMEN

bool isCount(std::string_view key) {
    return key == "delay_samples" || key == "dac_bits" || key == "adc_bits" || key == "lattice_pitches" ||
           !planarParameterWords(key).empty();
}

const PlanarSymbol* findSymbol(std::string_view key) {
    const auto found =
        std::find_if(Symbols.begin(), Symbols.end(), [&](const auto& each) { return each.symbol == key; });
    return found == Symbols.end() ? nullptr : &*found;
}

/// A value under the name and in the unit in which it is written.
struct WrittenValue {
    const PlanarParameterSpec* spec;
    std::string_view name, unit;
    double toSi, min, max;
};

WrittenValue writtenAs(const PlanarParameterSpec& spec, std::string_view key) {
    if (const PlanarSymbol* symbol = findSymbol(key)) {
        return {&spec, key, symbol->unit, 1.0, spec.min * spec.toSi, spec.max * spec.toSi};
    }
    return {&spec, key, spec.unit, spec.toSi, spec.min, spec.max};
}

Result<void> checkRange(const WrittenValue& written, double value) {
    const bool isWhole = isCount(written.spec->key);
    const std::string hint = fmt::format("Allowed: {:.6g} to {:.6g}{}{}{}. Known keys: {}.", written.min,
                                         written.max, written.unit.empty() ? "" : " ", written.unit,
                                         isWhole ? ", whole numbers" : "", planarParameterKeys());
    if (!std::isfinite(value)) {
        return failure(ErrorCode::NotFinite, fmt::format("{} is not a finite number", written.name), hint);
    }
    if (value < written.min || value > written.max || (isWhole && value != std::floor(value))) {
        return failure(ErrorCode::OutOfRange, fmt::format("{} = {} is out of range", written.name, value),
                       hint);
    }
    return {};
}

} // namespace

std::span<const PlanarParameterSpec> planarParameterSpecs() {
    return Specs;
}

std::span<const PlanarSymbol> planarSymbols() {
    return Symbols;
}

const PlanarParameterSpec* findPlanarParameter(std::string_view key) {
    const PlanarSymbol* symbol = findSymbol(key);
    const std::string_view name = symbol == nullptr ? key : symbol->key;
    const auto found =
        std::find_if(Specs.begin(), Specs.end(), [&](const auto& spec) { return spec.key == name; });
    return found == Specs.end() ? nullptr : &*found;
}

std::vector<std::string> planarParameterWords(std::string_view key) {
    const PlanarParameterSpec* spec = findPlanarParameter(key);
    return spec == nullptr ? std::vector<std::string>() : choiceWords(spec->words);
}

std::string planarParameterKeys() {
    std::string keys;
    for (const PlanarParameterSpec& spec : Specs) {
        keys += (keys.empty() ? "" : ", ") + std::string(spec.key);
    }
    for (const PlanarSymbol& symbol : Symbols) {
        keys += ", " + std::string(symbol.symbol);
    }
    return keys + ", seed, imperfections, chain";
}

Result<void> setPlanarParameter(PlanarParameters& parameters, std::string_view key, double value) {
    const PlanarParameterSpec* spec = findPlanarParameter(key);
    if (spec == nullptr) {
        return failure(ErrorCode::UnknownName,
                       fmt::format("the planar positioner has no parameter '{}'", key),
                       "Known keys: " + planarParameterKeys() + ".");
    }
    const WrittenValue written = writtenAs(*spec, key);
    if (auto checked = checkRange(written, value); !checked) {
        return checked;
    }
    if (spec->value != nullptr) {
        spec->value(parameters) = value * written.toSi;
    } else {
        spec->specimen(parameters) = value * written.toSi;
    }
    return {};
}

std::optional<double> planarParameter(const PlanarParameters& parameters, std::string_view key) {
    const PlanarParameterSpec* spec = findPlanarParameter(key);
    HB_ASSERT(spec != nullptr);
    const double toSi = writtenAs(*spec, key).toSi;
    PlanarParameters copy = parameters;
    if (spec->value != nullptr) {
        return spec->value(copy) / toSi;
    }
    const std::optional<double> si = spec->specimen(copy);
    return si ? std::optional<double>(*si / toSi) : std::nullopt;
}

Result<void> checkPlanarParameters(const PlanarParameters& parameters) {
    if (parameters.geometry.shortStraight_m() <= 0.0) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("a coil of {} mm width leaves no winding window within half a pitch of {} mm",
                        1e3 * parameters.geometry.winding.width_m, 1e3 * parameters.geometry.matrix.pitch_m),
            fmt::format("Make coil_width_mm smaller than {} mm.",
                        0.5e3 * parameters.geometry.matrix.pitch_m));
    }
    if (std::fabs(parameters.initialX_m) > parameters.travel_m ||
        std::fabs(parameters.initialY_m) > parameters.travel_m ||
        std::fabs(parameters.initialAngle_rad) > parameters.travel_rad) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("the start pose lies beyond the stops at {} mm and {} mrad",
                                   1e3 * parameters.travel_m, 1e3 * parameters.travel_rad),
                       fmt::format("Keep x0_mm and y0_mm within {} mm, phi0_mrad within {} mrad.",
                                   1e3 * parameters.travel_m, 1e3 * parameters.travel_rad));
    }
    return {};
}

PlanarParameters withoutImperfections(PlanarParameters parameters) {
    parameters.massCentreX_m = 0.0;
    parameters.massCentreY_m = 0.0;
    parameters.coilGain_ratio.fill(1.0);
    parameters.hallNoise_T = 0.0;
    parameters.crosstalk_ratio = 0.0;
    for (ChipErrorParameters& chip : parameters.chipErrors) {
        chip = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    }
    parameters.cableStiffness_N_per_m = 0.0;
    parameters.cableTorsion_Nm_per_rad = 0.0;
    parameters.slowForce_N = 0.0;
    parameters.thermalAcceleration_ratio = 0.0;
    parameters.temperatureError_K = 0.0;
    return parameters;
}

PlanarParameters withIdealChain(PlanarParameters parameters) {
    parameters = withoutImperfections(parameters);
    parameters.isIdealChain = true;
    return parameters;
}

} // namespace halbench::models
