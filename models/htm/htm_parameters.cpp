#include "models/htm/htm_parameters.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::models {
namespace {

using P = HtmParameters;

// A value that every specimen shares / an error that is drawn unless it is written down.
#define HB_SHARED(member) [](P& p) -> double& { return p.member; }, nullptr
#define HB_SPECIMEN(member) nullptr, [](P& p) -> std::optional<double>& { return p.member; }

constexpr double Milli = 1e-3;
constexpr double Degree = Pi / 180.0;

const std::array Specs = {
    // machine and amplifier, section 2
    HtmParameterSpec{"J", "kg*m^2", 1e-7, 1.0, 1.0, 'G', "rotor inertia", HB_SHARED(inertia_kg_m2)},
    HtmParameterSpec{"c", "N*m*s/rad", 0.0, 1.0, 1.0, 'G', "viscous damping", HB_SHARED(viscousDamping_Nm_s)},
    HtmParameterSpec{"Kf", "N*m", 0.0, 1.0, 1.0, 'G', "Coulomb friction", HB_SHARED(coulombFriction_Nm)},
    HtmParameterSpec{"phi", "N*m/A", 1e-5, 10.0, 1.0, 'G', "torque per ampere of current amplitude",
                     HB_SHARED(torqueConstant_Nm_per_A)},
    HtmParameterSpec{"Imax", "A", 0.1, 4.0, 1.0, 'G', "current amplitude limit", HB_SHARED(currentLimit_A)},
    HtmParameterSpec{"B0", "T", 0.01, 0.169, 1.0, 'G', "field amplitude at the Hall sensors",
                     HB_SHARED(field_T)},
    HtmParameterSpec{"R_a", "Ohm", 0.01, 100.0, 1.0, 'G', "resistance of one phase",
                     HB_SHARED(amplifier.coil_Ohm)},
    HtmParameterSpec{"L_a", "H", 1e-7, 0.1, 1.0, 'X', "inductance of one phase", HB_SHARED(amplifier.coil_H)},
    HtmParameterSpec{"psi0", "rad", -1000.0, 1000.0, 1.0, 'A', "rotor angle at the start",
                     HB_SHARED(initialAngle_rad)},
    HtmParameterSpec{"R1", "Ohm", 1.0, 1e7, 1.0, 'G', "amplifier resistor R1", HB_SHARED(amplifier.R1_Ohm)},
    HtmParameterSpec{"R3", "Ohm", 1.0, 1e7, 1.0, 'G', "amplifier resistor R3", HB_SHARED(amplifier.R3_Ohm)},
    HtmParameterSpec{"R5", "Ohm", 1.0, 1e7, 1.0, 'G', "amplifier resistor R5", HB_SHARED(amplifier.R5_Ohm)},
    HtmParameterSpec{"R6", "Ohm", 1.0, 1e7, 1.0, 'G', "amplifier resistor R6", HB_SHARED(amplifier.R6_Ohm)},
    HtmParameterSpec{"R7", "Ohm", 1.0, 1e7, 1.0, 'G', "amplifier resistor R7", HB_SHARED(amplifier.R7_Ohm)},
    HtmParameterSpec{"R8", "Ohm", 1.0, 1e7, 1.0, 'G', "amplifier resistor R8", HB_SHARED(amplifier.R8_Ohm)},
    HtmParameterSpec{"R9", "Ohm", 1.0, 1e7, 1.0, 'G', "amplifier resistor R9", HB_SHARED(amplifier.R9_Ohm)},
    HtmParameterSpec{"R10", "Ohm", 1e-3, 1e3, 1.0, 'G', "amplifier current shunt",
                     HB_SHARED(amplifier.R10_Ohm)},
    HtmParameterSpec{"C2", "F", 1e-12, 1e-5, 1.0, 'G', "amplifier capacitor C2", HB_SHARED(amplifier.C2_F)},
    HtmParameterSpec{"C3", "F", 1e-12, 1e-5, 1.0, 'G', "amplifier capacitor C3", HB_SHARED(amplifier.C3_F)},
    // sensing, section 2
    HtmParameterSpec{"S25", "V/T", 1.0, 13.5, 1.0, 'G', "Hall sensitivity at 25 degC",
                     HB_SHARED(hallSensitivity_V_per_T)},
    HtmParameterSpec{"S_TC", "1/K", -0.01, 0.01, 1.0, 'G', "temperature coefficient of the Hall sensitivity",
                     HB_SHARED(hallSensitivityTemperature_per_K)},
    HtmParameterSpec{"V_Q", "V", 2.3, 2.7, 1.0, 'G', "Hall output at zero field", HB_SHARED(hallQuiescent_V)},
    HtmParameterSpec{"stray_mT_per_A", "mT/A", -20.0, 20.0, Milli, 'G', "field of a phase at its own sensor",
                     HB_SHARED(stray_T_per_A)},
    HtmParameterSpec{"delay_samples", "", 0.0, 2.0, 1.0, 'A', "computation delay of the position loop",
                     HB_SHARED(delaySamples)},
    // friction, section 9
    HtmParameterSpec{"friction_scatter", "", 0.0, 0.25, 1.0, 'A',
                     "relative run-to-run friction scatter, 1 sigma", HB_SHARED(frictionScatter_ratio)},
    HtmParameterSpec{"friction_per_turn", "", 0.0, 0.5, 1.0, 'A',
                     "relative once-per-turn friction, amplitude", HB_SHARED(frictionPerTurn_ratio)},
    HtmParameterSpec{"Ks_over_Kf", "", 1.0, 3.0, 1.0, 'A', "static over kinetic friction",
                     HB_SHARED(staticFriction_ratio)},
    HtmParameterSpec{"friction_asymmetry", "", -0.5, 0.5, 1.0, 'A',
                     "asymmetry of friction, (Kf+ - Kf-)/(Kf+ + Kf-)", HB_SHARED(frictionAsymmetry_ratio)},
    HtmParameterSpec{"stribeck_speed", "rad/s", 0.0, 10.0, 1.0, 'A', "speed at which static friction fades",
                     HB_SHARED(stribeckSpeed_rad_s)},
    // Hall sensors and magnets, section 9
    HtmParameterSpec{"hall_noise_mT", "mT", 0.0, 10.0, Milli, 'A', "Hall noise per sample, rms",
                     HB_SHARED(hallNoise_T)},
    HtmParameterSpec{"hall_offset_mT", "mT", -10.0, 10.0, Milli, 'A',
                     "zero offset of both sensors; drawn for each if not given", HB_SPECIMEN(hallOffset_T)},
    HtmParameterSpec{"hall_offset_sigma_mT", "mT", 0.0, 5.0, Milli, 'A',
                     "spread of the drawn offsets, 1 sigma", HB_SHARED(hallOffsetSpread_T)},
    HtmParameterSpec{"hall_gain_error", "", -0.2, 0.2, 1.0, 'A',
                     "gain of sensor a over sensor b, minus one; drawn for each if not given",
                     HB_SPECIMEN(hallGainError_ratio)},
    HtmParameterSpec{"hall_gain_sigma", "", 0.0, 0.1, 1.0, 'A', "spread of the drawn gains, 1 sigma",
                     HB_SHARED(hallGainSpread_ratio)},
    HtmParameterSpec{"hall_linearity_sigma", "", 0.0, 0.05, 1.0, 'A', "spread of the drawn linearity errors",
                     HB_SHARED(hallLinearitySpread_ratio)},
    HtmParameterSpec{"quadrature_deg", "deg", -10.0, 10.0, Degree, 'A',
                     "angle error between the sensors; drawn if not given", HB_SPECIMEN(quadrature_rad)},
    HtmParameterSpec{"quadrature_sigma_deg", "deg", 0.0, 5.0, Degree, 'A', "spread of the drawn angle error",
                     HB_SHARED(quadratureSpread_rad)},
    HtmParameterSpec{"sensor_radius_sigma_mm", "mm", 0.0, 1.0, Milli, 'A', "spread of the sensors' radius",
                     HB_SHARED(sensorRadiusSpread_m)},
    HtmParameterSpec{"magnet_scatter", "", 0.0, 0.2, 1.0, 'A',
                     "remanence scatter of the bars, 1 sigma; their angle scatter goes with it (0.02: 1 deg)",
                     HB_SHARED(magnetScatter_ratio)},
    // temperature and heat, section 9
    HtmParameterSpec{"magnet_TC", "1/K", -0.01, 0.01, 1.0, 'A', "temperature coefficient of field and torque",
                     HB_SHARED(magnetTemperature_per_K)},
    HtmParameterSpec{"ambient_C", "degC", -20.0, 60.0, 1.0, 'A', "ambient temperature",
                     HB_SHARED(ambient_degC)},
    HtmParameterSpec{"hall_thermal_coupling", "", 0.0, 1.0, 1.0, 'A',
                     "share of the coil's rise at its sensor", HB_SHARED(hallThermalCoupling_ratio)},
    HtmParameterSpec{"temperature_error_C", "degC", -10.0, 10.0, 1.0, 'A',
                     "error of both temperature sensors; drawn for each if not given",
                     HB_SPECIMEN(temperatureError_K)},
    HtmParameterSpec{"temperature_sigma_C", "degC", 0.0, 5.0, 1.0, 'A',
                     "spread of the drawn temperature errors", HB_SHARED(temperatureSpread_K)},
    HtmParameterSpec{"coil_heat_capacity", "J/K", 0.1, 1e4, 1.0, 'A', "heat capacity of one phase",
                     HB_SHARED(coilHeatCapacity_J_per_K)},
    HtmParameterSpec{"coil_thermal_resistance", "K/W", 0.1, 1e3, 1.0, 'A', "from one phase to ambient",
                     HB_SHARED(coilThermalResistance_K_per_W)},
    HtmParameterSpec{"copper_TC", "1/K", 0.0, 0.01, 1.0, 'A', "temperature coefficient of the resistance",
                     HB_SHARED(copperTemperature_per_K)},
    HtmParameterSpec{"thermal_acceleration", "", 0.0, 1e4, 1.0, 'A',
                     "thermal seconds per second; 0: no heating", HB_SHARED(thermalAcceleration_ratio)},
    // converters, section 9
    HtmParameterSpec{"dac_gain_error", "", -0.05, 0.05, 1.0, 'A',
                     "gain error of both outputs; drawn if not given", HB_SPECIMEN(dacGainError_ratio)},
    HtmParameterSpec{"dac_gain_sigma", "", 0.0, 0.02, 1.0, 'A', "spread of the drawn gain errors, 1 sigma",
                     HB_SHARED(dacGainSpread_ratio)},
    HtmParameterSpec{"dac_inl_codes", "", -20.0, 20.0, 1.0, 'A',
                     "integral non-linearity of both outputs; drawn if not given",
                     HB_SPECIMEN(dacNonLinearity_codes)},
    HtmParameterSpec{"dac_inl_limit_codes", "", 0.0, 20.0, 1.0, 'A', "largest drawn non-linearity",
                     HB_SHARED(dacNonLinearityLimit_codes)},
};

#undef HB_SHARED
#undef HB_SPECIMEN

Result<void> checkRange(const HtmParameterSpec& spec, double value) {
    const bool isCount = spec.key == "delay_samples";
    const std::string hint = fmt::format("Allowed: {} to {}{}{}{}. Known keys: {}.", spec.min, spec.max,
                                         spec.unit.empty() ? "" : " ", spec.unit,
                                         isCount ? ", whole numbers" : "", htmParameterKeys());
    if (!std::isfinite(value)) {
        return failure(ErrorCode::NotFinite, fmt::format("{} is not a finite number", spec.key), hint);
    }
    if (value < spec.min || value > spec.max || (isCount && value != std::floor(value))) {
        return failure(ErrorCode::OutOfRange, fmt::format("{} = {} is out of range", spec.key, value), hint);
    }
    return {};
}

} // namespace

std::span<const HtmParameterSpec> htmParameterSpecs() {
    return Specs;
}

const HtmParameterSpec* findHtmParameter(std::string_view key) {
    const auto found =
        std::find_if(Specs.begin(), Specs.end(), [&](const auto& spec) { return spec.key == key; });
    return found == Specs.end() ? nullptr : &*found;
}

std::string htmParameterKeys() {
    std::string keys;
    for (const HtmParameterSpec& spec : Specs) {
        keys += (keys.empty() ? "" : ", ") + std::string(spec.key);
    }
    return keys + ", seed, imperfections, chain";
}

Result<void> setHtmParameter(HtmParameters& parameters, std::string_view key, double value) {
    const HtmParameterSpec* spec = findHtmParameter(key);
    if (spec == nullptr) {
        return failure(ErrorCode::UnknownName, fmt::format("the motor has no parameter '{}'", key),
                       "Known keys: " + htmParameterKeys() + ".");
    }
    if (auto checked = checkRange(*spec, value); !checked) {
        return checked;
    }
    if (spec->value != nullptr) {
        spec->value(parameters) = value * spec->toSi;
    } else {
        spec->specimen(parameters) = value * spec->toSi;
    }
    return {};
}

std::optional<double> htmParameter(const HtmParameters& parameters, std::string_view key) {
    const HtmParameterSpec* spec = findHtmParameter(key);
    HB_ASSERT(spec != nullptr);
    HtmParameters copy = parameters;
    if (spec->value != nullptr) {
        return spec->value(copy) / spec->toSi;
    }
    const std::optional<double> si = spec->specimen(copy);
    return si ? std::optional<double>(*si / spec->toSi) : std::nullopt;
}

HtmParameters withoutImperfections(HtmParameters parameters) {
    parameters.stray_T_per_A = 0.0;
    parameters.staticFriction_ratio = 1.0;
    parameters.frictionScatter_ratio = 0.0;
    parameters.frictionPerTurn_ratio = 0.0;
    parameters.frictionAsymmetry_ratio = 0.0;
    parameters.stribeckSpeed_rad_s = 0.0;
    parameters.hallNoise_T = 0.0;
    parameters.hallOffset_T = 0.0;
    parameters.hallGainError_ratio = 0.0;
    parameters.hallLinearitySpread_ratio = 0.0;
    parameters.quadrature_rad = 0.0;
    parameters.sensorRadiusSpread_m = 0.0;
    parameters.magnetScatter_ratio = 0.0;
    parameters.temperatureError_K = 0.0;
    parameters.thermalAcceleration_ratio = 0.0;
    parameters.dacGainError_ratio = 0.0;
    parameters.dacNonLinearity_codes = 0.0;
    return parameters;
}

HtmParameters withIdealChain(HtmParameters parameters) {
    parameters = withoutImperfections(parameters);
    parameters.isIdealChain = true;
    return parameters;
}

} // namespace halbench::models
