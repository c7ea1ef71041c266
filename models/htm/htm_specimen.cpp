#include "models/htm/htm_specimen.h"

#include "control/base/random.h"
#include "control/base/units.h"

#include <cmath>

namespace halbench::models {
namespace {

// One stream of the generator for each kind of error.
enum class Stream : std::uint64_t {
    HallOffset = 1,
    HallGain,
    Linearity,
    Quadrature,
    Magnets,
    Temperature,
    Dac,
    Turn
};

Random stream(std::uint64_t seed, Stream which) {
    return Random(seed).fork(static_cast<std::uint64_t>(which));
}

double cutGaussian(Random& random, double sigma, double cut) {
    double value = random.gaussian();
    while (std::fabs(value) > cut) {
        value = random.gaussian();
    }
    return sigma * value;
}

std::array<double, 2> drawPair(Random random, double sigma, double cut) {
    const double first = cutGaussian(random, sigma, cut);
    return {first, cutGaussian(random, sigma, cut)};
}

// The field on the sensor circle grows with r by 2 % per mm at 14.5 mm: radial field 1.171 of the centre's
// and quadratic in r (resources/help/htm-theory.md section 4.3).
constexpr double GainPerRadius_per_m = 20.0;

std::array<double, 2> hallGains(const HtmParameters& p, std::uint64_t seed) {
    if (p.hallGainError_ratio) {
        // a/b = 1 + error, mean 1
        return {2.0 - 2.0 / (2.0 + *p.hallGainError_ratio), 2.0 / (2.0 + *p.hallGainError_ratio)};
    }
    Random random = stream(seed, Stream::HallGain);
    const auto part = drawPair(random, p.hallGainSpread_ratio, 2.0);
    const auto radius_m = drawPair(random.fork(1), p.sensorRadiusSpread_m, 2.0);
    return {1.0 + part[0] + GainPerRadius_per_m * radius_m[0],
            1.0 + part[1] + GainPerRadius_per_m * radius_m[1]};
}

// A cubic share l of the sensor's curve, B + l (B^3/B0^2 - B), turns cos into (1 - l/4) cos + (l/4) cos 3.
std::vector<FieldHarmonic> linearityHarmonics(double share) {
    if (share == 0.0) {
        return {};
    }
    return {{1, -share / 4.0, 0.0}, {3, share / 4.0, 0.0}};
}

std::array<HallConfig, 2> drawHall(const HtmParameters& p, double magnetRatio, std::uint64_t seed) {
    HallConfig nominal;
    nominal.field_T = p.field_T * magnetRatio;
    nominal.stray_T_per_A = p.stray_T_per_A;
    nominal.noise_T = p.hallNoise_T;
    nominal.quiescent_V = p.hallQuiescent_V;
    nominal.sensitivity_V_per_T = p.hallSensitivity_V_per_T;
    nominal.sensitivityTemperature_per_K = p.hallSensitivityTemperature_per_K;

    Random quadrature = stream(seed, Stream::Quadrature);
    const double drawn_rad = cutGaussian(quadrature, p.quadratureSpread_rad, 2.0);
    std::array<HallConfig, 2> hall = hallPair(nominal, p.quadrature_rad.value_or(drawn_rad));

    const auto offset_T = drawPair(stream(seed, Stream::HallOffset), p.hallOffsetSpread_T, 2.8);
    const auto linearity = drawPair(stream(seed, Stream::Linearity), p.hallLinearitySpread_ratio, 2.0);
    const auto gain = hallGains(p, seed);
    for (std::size_t i = 0; i < hall.size(); ++i) {
        hall[i].offset_T = p.hallOffset_T.value_or(offset_T[i]);
        hall[i].gain_ratio = gain[i];
        hall[i].harmonics = linearityHarmonics(linearity[i]);
    }
    return hall;
}

MagnetScatter drawMagnets(const HtmParameters& p, std::uint64_t seed) {
    constexpr std::array Amplitude_deg = {0.24, 0.25, 0.22, 0.09}; // rms over specimens, at 2 %
    constexpr double Reference_ratio = 0.02;
    MagnetScatter scatter;
    Random random = stream(seed, Stream::Magnets);
    for (std::size_t i = 0; i < scatter.orders.size(); ++i) {
        const double sigma_rad =
            degreesToRadians(Amplitude_deg[i]) / std::sqrt(2.0) * (p.magnetScatter_ratio / Reference_ratio);
        scatter.orders[i].cosine_rad = sigma_rad * random.gaussian();
        scatter.orders[i].sine_rad = sigma_rad * random.gaussian();
    }
    return scatter;
}

std::array<DacConfig, 2> drawDac(const HtmParameters& p, std::uint64_t seed) {
    Random random = stream(seed, Stream::Dac);
    const auto gain = drawPair(random.fork(1), p.dacGainSpread_ratio, 2.0);
    std::array<DacConfig, 2> dac;
    for (std::size_t i = 0; i < dac.size(); ++i) {
        const double bow = p.dacNonLinearityLimit_codes * (2.0 * random.uniform() - 1.0);
        dac[i].gainError_ratio = p.dacGainError_ratio.value_or(gain[i]);
        dac[i].integralNonLinearity_codes = p.dacNonLinearity_codes.value_or(bow);
    }
    return dac;
}

CoilHeatingConfig coilHeating(const HtmParameters& p) {
    CoilHeatingConfig coil;
    coil.heatCapacity_J_per_K = p.coilHeatCapacity_J_per_K;
    coil.thermalResistance_K_per_W = p.coilThermalResistance_K_per_W;
    coil.resistanceAt25_Ohm = p.amplifier.coil_Ohm;
    coil.copperCoefficient_per_K = p.copperTemperature_per_K;
    coil.ambient_degC = p.ambient_degC;
    coil.sensorCoupling_ratio = p.hallThermalCoupling_ratio;
    return coil;
}

RotorConfig rotorConfig(const HtmParameters& p, std::uint64_t seed) {
    RotorConfig rotor;
    rotor.inertia_kg_m2 = p.inertia_kg_m2;
    rotor.viscousDamping_Nm_s = p.viscousDamping_Nm_s;
    rotor.coulombFriction_Nm = p.coulombFriction_Nm;
    rotor.staticFriction_ratio = p.staticFriction_ratio;
    rotor.asymmetry_ratio = p.frictionAsymmetry_ratio;
    rotor.perTurn_ratio = p.frictionPerTurn_ratio;
    rotor.perTurnPhase_rad = 2.0 * Pi * stream(seed, Stream::Turn).uniform();
    rotor.stribeckSpeed_rad_s = p.stribeckSpeed_rad_s;
    return rotor;
}

} // namespace

double MagnetScatter::angleError_rad(double angle_rad) const {
    double error_rad = 0.0;
    for (const Order& order : orders) {
        if (order.cosine_rad != 0.0 || order.sine_rad != 0.0) {
            error_rad += order.cosine_rad * std::cos(order.order * angle_rad) +
                         order.sine_rad * std::sin(order.order * angle_rad);
        }
    }
    return error_rad;
}

HtmSpecimen drawSpecimen(const HtmParameters& parameters, std::uint64_t seed) {
    const double magnetRatio = 1.0 + parameters.magnetTemperature_per_K * (parameters.ambient_degC - 25.0);
    HtmSpecimen specimen;
    specimen.rotor = rotorConfig(parameters, seed);
    specimen.torqueConstant_Nm_per_A = parameters.torqueConstant_Nm_per_A * magnetRatio;
    specimen.hall = drawHall(parameters, magnetRatio, seed);
    specimen.magnets = drawMagnets(parameters, seed);
    specimen.dac = drawDac(parameters, seed);
    const auto error_K = drawPair(stream(seed, Stream::Temperature), parameters.temperatureSpread_K, 2.0);
    for (std::size_t i = 0; i < specimen.temperature.size(); ++i) {
        specimen.temperature[i].error_K = parameters.temperatureError_K.value_or(error_K[i]);
        specimen.coil[i] = coilHeating(parameters);
    }
    return specimen;
}

} // namespace halbench::models
