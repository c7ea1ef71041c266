#include "models/htm/htm_plant.h"

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

constexpr std::uint64_t NoiseStream = 101;
constexpr std::uint64_t FrictionStream = 102;
/// A coil is gone there: the model of its heat ends, whatever current an impossible amplifier drives.
constexpr double CopperMelts_degC = 1085.0;

} // namespace

Result<HtmPlant> HtmPlant::make(const HtmParameters& parameters, std::uint64_t seed, double subStep_s) {
    const auto amplifier = amplifierModel(parameters.amplifier);
    if (!amplifier) {
        return failure(amplifier.error());
    }
    return HtmPlant(parameters, *amplifier, seed, subStep_s);
}

HtmPlant::HtmPlant(const HtmParameters& parameters, const AmplifierModel& amplifier, std::uint64_t seed,
                   double subStep_s)
    : m_subStep_s(subStep_s), m_parameters(parameters), m_specimen(drawSpecimen(parameters, seed)),
      m_amplifier(amplifier, subStep_s), m_rotorStep(m_specimen.rotor, subStep_s),
      m_sensorNoise(Random(seed).fork(NoiseStream)), m_friction(Random(seed).fork(FrictionStream)) {
    m_adc.isQuantised = !parameters.isIdealChain;
    m_truth.rotor.angle_rad = parameters.initialAngle_rad;
    for (std::size_t i = 0; i < m_coil.size(); ++i) {
        m_coil[i].temperature_degC = parameters.ambient_degC;
        m_truth.coil_degC[i] = parameters.ambient_degC;
    }
    drive(m_drive);
    redrawFriction();
}

void HtmPlant::drive(const HtmDrive& drive) {
    m_drive = drive;
    for (std::size_t i = 0; i < 2; ++i) {
        m_amplifierInput_V[i] = dacOutput_V(m_specimen.dac[i], m_drive.dacCode[i]);
    }
}

void HtmPlant::redrawFriction() {
    if (m_parameters.frictionScatter_ratio > 0.0) {
        // Cut at three sigma: friction stays positive for every scatter that may be asked for.
        const double draw = std::clamp(m_friction.gaussian(), -3.0, 3.0);
        m_truth.rotor.friction_ratio = 1.0 + m_parameters.frictionScatter_ratio * draw;
    }
}

HtmReadings HtmPlant::read() {
    const double angle_rad =
        m_truth.rotor.angle_rad + m_specimen.magnets.angleError_rad(m_truth.rotor.angle_rad);
    HtmReadings readings;
    for (std::size_t i = 0; i < 2; ++i) {
        const double sensor_degC = hallTemperature_degC(m_specimen.coil[i], m_coil[i]);
        const double hall_V =
            hallVoltage_V(m_specimen.hall[i], angle_rad, m_truth.current_A[i], sensor_degC, m_sensorNoise);
        readings.hallCode[i] = adcCode(m_adc, hall_V);
        readings.temperatureCode[i] =
            adcCode(m_adc, temperatureVoltage_V(m_specimen.temperature[i], m_coil[i].temperature_degC));
    }
    return readings;
}

void HtmPlant::heat(const std::array<double, 2>& current_A) {
    const double step_s = m_subStep_s * m_parameters.thermalAcceleration_ratio;
    if (step_s == 0.0) {
        return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        stepCoilHeating(m_specimen.coil[i], m_coil[i], current_A[i], step_s);
        m_coil[i].temperature_degC = std::fmin(m_coil[i].temperature_degC, CopperMelts_degC);
        m_truth.coil_degC[i] = m_coil[i].temperature_degC;
    }
}

double HtmPlant::torqueOfSubStep_Nm() {
    std::array<double, 2> mean_A{};
    for (std::size_t i = 0; i < 2; ++i) {
        const AmplifierCurrent current = m_amplifier.step(m_amplifierState[i], m_amplifierInput_V[i]);
        mean_A[i] = current.mean_A;
        m_truth.current_A[i] = current.atEnd_A;
    }
    heat(mean_A);
    if (m_parameters.isIdealChain) {
        return m_specimen.torqueConstant_Nm_per_A * m_drive.amplitude_A;
    }
    const RotorState& rotor = m_truth.rotor;
    const double middle_rad = rotor.angle_rad + 0.5 * m_subStep_s * rotor.speed_rad_s;
    return m_specimen.torqueConstant_Nm_per_A *
           (-mean_A[0] * std::sin(middle_rad) + mean_A[1] * std::cos(middle_rad));
}

void HtmPlant::advance(int subSteps) {
    for (int i = 0; i < subSteps; ++i) {
        m_truth.torque_Nm = torqueOfSubStep_Nm();
        const bool wasAtRest = m_truth.rotor.speed_rad_s == 0.0;
        m_rotorStep.move(m_truth.rotor, m_truth.torque_Nm);
        if (wasAtRest && m_truth.rotor.speed_rad_s != 0.0) {
            redrawFriction();
        }
    }
}

} // namespace halbench::models
