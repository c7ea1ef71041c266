#include "models/planar/planar_specimen.h"

#include "control/base/random.h"
#include "control/base/units.h"

#include <cmath>

namespace halbench::models {
namespace {

// One stream of the generator for each kind of error.
enum class Stream : std::uint64_t { Gain = 1, Offset, CrossAxis, Place, Height, Temperature };

double cutGaussian(Random& random, double sigma) {
    constexpr double Cut = 2.0;
    double value = random.gaussian();
    while (std::fabs(value) > Cut) {
        value = random.gaussian();
    }
    return sigma * value;
}

// The written value, or what the stream gives: drawn in any case, so that the others keep theirs.
double drawn(const std::optional<double>& written, Random& random, double sigma) {
    const double value = cutGaussian(random, sigma);
    return written.value_or(value);
}

std::array<HallChip, ChipCount> drawChips(const PlanarParameters& p, std::uint64_t seed) {
    const auto stream = [seed](Stream which) { return Random(seed).fork(static_cast<std::uint64_t>(which)); };
    Random gain = stream(Stream::Gain);
    Random offset = stream(Stream::Offset);
    Random cross = stream(Stream::CrossAxis);
    Random place = stream(Stream::Place);
    Random height = stream(Stream::Height);
    std::array<HallChip, ChipCount> chips;
    for (std::size_t i = 0; i < chips.size(); ++i) {
        const ChipErrorParameters& error = p.chipErrors[i];
        HallChip& chip = chips[i];
        const double gainX = drawn(error.gainX_ratio, gain, p.hallGainSpread_ratio);
        const double gainY = drawn(error.gainY_ratio, gain, p.hallGainSpread_ratio);
        const double crossXy = drawn(error.crossXy_ratio, cross, p.hallCrossSpread_ratio);
        const double crossYx = drawn(error.crossYx_ratio, cross, p.hallCrossSpread_ratio);
        chip.sensitivity << 1.0 + gainX, crossXy, crossYx, 1.0 + gainY;
        chip.offset_T.x() = drawn(error.offsetX_T, offset, p.hallOffsetSpread_T);
        chip.offset_T.y() = drawn(error.offsetY_T, offset, p.hallOffsetSpread_T);
        chip.place_m.x() = p.chipX_m[i] + drawn(error.placeX_m, place, p.hallPlaceSpread_m);
        chip.place_m.y() = p.chipY_m[i] + drawn(error.placeY_m, place, p.hallPlaceSpread_m);
        const double higher_m = drawn(error.height_m, height, p.hallHeightSpread_m);
        chip.amplitude_T = p.hallField_T * std::exp(-waveNumber_per_m(p.geometry.matrix) * higher_m);
        chip.noise_T = p.hallNoise_T;
        chip.range_T = p.hallRange_T;
    }
    return chips;
}

PlatenConfig platenConfig(const PlanarParameters& p) {
    PlatenConfig platen;
    platen.mass_kg = p.mass_kg;
    platen.inertia_kg_m2 = p.inertia_kg_m2;
    platen.massCentre_m = {p.massCentreX_m, p.massCentreY_m};
    platen.damping_Ns_per_m = p.damping_Ns_per_m;
    platen.damping_Nms_per_rad = p.damping_Nms_per_rad;
    platen.cableStiffness_N_per_m = p.cableStiffness_N_per_m;
    platen.cableTorsion_Nm_per_rad = p.cableTorsion_Nm_per_rad;
    platen.anchor_m = {p.cableX_m, p.cableY_m};
    platen.travel_m = p.travel_m;
    platen.travel_rad = p.travel_rad;
    platen.stopStiffness_N_per_m = p.stopStiffness_N_per_m;
    platen.stopStiffness_Nm_per_rad = p.stopStiffness_Nm_per_rad;
    platen.stopDamping_Ns_per_m = 2.0 * p.stopDamping_ratio * std::sqrt(p.stopStiffness_N_per_m * p.mass_kg);
    platen.stopDamping_Nms_per_rad =
        2.0 * p.stopDamping_ratio * std::sqrt(p.stopStiffness_Nm_per_rad * p.inertia_kg_m2);
    return platen;
}

CoilHeatingConfig coilConfig(const PlanarParameters& p) {
    CoilHeatingConfig coil;
    coil.heatCapacity_J_per_K = p.coilHeatCapacity_J_per_K;
    coil.thermalResistance_K_per_W = p.coilThermalResistance_K_per_W;
    coil.resistanceAt25_Ohm = p.coilResistance_Ohm;
    coil.copperCoefficient_per_K = p.copperTemperature_per_K;
    coil.ambient_degC = p.ambient_degC;
    return coil;
}

} // namespace

PlanarSpecimen drawSpecimen(const PlanarParameters& parameters, std::uint64_t seed) {
    PlanarSpecimen specimen;
    specimen.platen = platenConfig(parameters);
    specimen.amplifier.bandwidth_rad_s = 2.0 * Pi * parameters.amplifierBandwidth_Hz;
    specimen.amplifier.inductance_H = parameters.coilInductance_H;
    specimen.amplifier.supply_V = parameters.amplifierSupply_V;
    specimen.amplifier.output_Ohm = parameters.amplifierOutput_Ohm;
    specimen.amplifier.limit_A = parameters.currentLimit_A;
    specimen.coil = coilConfig(parameters);
    specimen.chips = drawChips(parameters, seed);
    std::array<Eigen::Vector2d, ChipCount> place_m;
    for (std::size_t i = 0; i < place_m.size(); ++i) {
        place_m[i] = specimen.chips[i].place_m;
    }
    specimen.crosstalk_T_per_A =
        parameters.crosstalk_ratio *
        coilFieldAtChips_T_per_A(parameters.geometry, place_m,
                                 chipHeight_m(parameters.geometry.matrix, parameters.hallField_T));
    Random temperature = Random(seed).fork(static_cast<std::uint64_t>(Stream::Temperature));
    for (TemperatureSensorConfig& sensor : specimen.temperature) {
        sensor.error_K = drawn(parameters.temperatureError_K, temperature, parameters.temperatureSpread_K);
    }
    return specimen;
}

} // namespace halbench::models
