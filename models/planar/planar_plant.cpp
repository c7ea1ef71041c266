#include "models/planar/planar_plant.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

constexpr std::uint64_t NoiseStream = 101;
constexpr std::uint64_t SlowForceStream = 102;
/// A coil is gone there: the model of its heat ends.
constexpr double CopperMelts_degC = 1085.0;

} // namespace

Result<PlanarPlant> PlanarPlant::make(const PlanarParameters& parameters, std::uint64_t seed,
                                      double subStep_s) {
    if (auto checked = checkPlanarParameters(parameters); !checked) {
        return failure(checked.error());
    }
    return PlanarPlant(parameters, seed, subStep_s);
}

PlanarPlant::PlanarPlant(const PlanarParameters& parameters, std::uint64_t seed, double subStep_s)
    : m_subStep_s(subStep_s), m_parameters(parameters), m_specimen(drawSpecimen(parameters, seed)),
      m_map(static_cast<WrenchModel>(static_cast<int>(parameters.wrench)), parameters.geometry),
      m_bearings(parameters.geometry, parameters.bearingStiffness_N_per_m, parameters.mass_kg,
                 m_specimen.platen.massCentre_m),
      m_stepsToFault(std::llround(parameters.faultAfter_s / subStep_s)),
      m_sensorNoise(Random(seed).fork(NoiseStream)), m_slowNoise(Random(seed).fork(SlowForceStream)),
      m_slowKept(std::exp(-2.0 * Pi * parameters.slowForceCorner_Hz * subStep_s)) {
    m_adc.reference_V = 2.0 * parameters.adcRange_V;
    m_adc.bits = static_cast<int>(parameters.adcBits);
    m_adc.isQuantised = !parameters.isIdealChain;
    m_dac.reference_V = 2.0 * parameters.dacRange_V;
    m_dac.bits = static_cast<int>(parameters.dacBits);
    m_dac.offset_V = parameters.dacRange_V;
    m_truth.platen.pose = {parameters.initialX_m, parameters.initialY_m, parameters.initialAngle_rad};
    for (std::size_t k = 0; k < m_coil.size(); ++k) {
        m_coil[k].temperature_degC = parameters.ambient_degC;
        m_truth.coil_degC[k] = parameters.ambient_degC;
    }
    for (Eigen::Vector2d& report_T : m_report_T) {
        report_T.setZero();
    }
    m_truth.slowForce_N =
        parameters.slowForce_N * Eigen::Vector2d(m_slowNoise.gaussian(), m_slowNoise.gaussian());
    m_truth.bearings = m_bearings.under(Eigen::Matrix<double, CoilCount, 1>::Zero());
    if (m_stepsToFault == 0) {
        takeFaults();
    }
}

CoilWrench PlanarPlant::wrenchAt(const PlanarPose& pose) const {
    CoilWrench map = m_map.at(pose);
    for (int k = 0; k < CoilCount; ++k) {
        map.wrench.col(k) *= m_parameters.coilGain_ratio[static_cast<std::size_t>(k)];
        map.lift_N_per_A(k) *= m_parameters.coilGain_ratio[static_cast<std::size_t>(k)];
    }
    return map;
}

void PlanarPlant::read(std::span<float> codes) {
    HB_ASSERT(codes.size() == static_cast<std::size_t>(ReadingCount));
    const double gamma = waveNumber_per_m(m_parameters.geometry.matrix);
    const Eigen::Matrix<double, FieldCount, 1> stray_T = m_specimen.crosstalk_T_per_A * m_truth.current_A;
    for (std::size_t i = 0; i < m_specimen.chips.size(); ++i) {
        const HallChip& chip = m_specimen.chips[i];
        const Eigen::Vector2d field_T =
            chipField_T(gamma, chip.amplitude_T, chip.place_m, m_truth.platen.pose) +
            stray_T.segment<2>(2 * static_cast<Eigen::Index>(i));
        m_report_T[i] = chipReading_T(chip, field_T, m_fault[i], m_report_T[i], m_sensorNoise);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double output_V =
                m_parameters.hallSensitivity_V_per_T * m_report_T[i](static_cast<Eigen::Index>(axis));
            codes[2 * i + axis] = static_cast<float>(adcCode(m_adc, output_V + m_parameters.adcRange_V));
        }
    }
    for (std::size_t k = 0; k < m_coil.size(); ++k) {
        const double output_V = temperatureVoltage_V(m_specimen.temperature[k], m_coil[k].temperature_degC);
        codes[FieldCount + k] = static_cast<float>(adcCode(m_adc, output_V + m_parameters.adcRange_V));
    }
}

void PlanarPlant::drive(std::span<const float> codes) {
    HB_ASSERT(codes.size() == static_cast<std::size_t>(DriveCount));
    const double last = std::ldexp(1.0, m_dac.bits) - 1.0;
    for (std::size_t k = 0; k < codes.size(); ++k) {
        const double asked = static_cast<double>(codes[k]);
        const double code = m_parameters.isIdealChain ? asked : std::clamp(std::round(asked), 0.0, last);
        m_demand_A[k] = m_parameters.amplifierGain_A_per_V * dacOutput_V(m_dac, code);
    }
}

void PlanarPlant::setFault(int chip, ChipFault fault) {
    HB_ASSERT(chip >= 0 && chip < ChipCount);
    m_fault[static_cast<std::size_t>(chip)] = fault;
}

void PlanarPlant::takeFaults() {
    for (int chip = 0; chip < ChipCount; ++chip) {
        setFault(chip, static_cast<ChipFault>(
                           static_cast<int>(m_parameters.chipFault[static_cast<std::size_t>(chip)])));
    }
}

void PlanarPlant::stepCurrents(const CoilWrench& map, CoilCurrents_A& mean_A) {
    const PlanarVelocity& velocity = m_truth.platen.velocity;
    m_truth.induced_V =
        map.wrench.transpose() * Eigen::Vector3d(velocity.x_m_s, velocity.y_m_s, velocity.angle_rad_s);
    for (int k = 0; k < CoilCount; ++k) {
        const auto coil = static_cast<std::size_t>(k);
        if (m_parameters.isIdealChain) {
            mean_A(k) =
                std::clamp(m_demand_A[coil], -m_parameters.currentLimit_A, m_parameters.currentLimit_A);
            m_truth.current_A(k) = mean_A(k);
            continue;
        }
        const SourceCurrent current = stepCurrentSource(
            m_specimen.amplifier, m_truth.current_A(k), m_demand_A[coil],
            coilResistance_Ohm(m_specimen.coil, m_coil[coil]), m_truth.induced_V(k), m_subStep_s);
        mean_A(k) = current.mean_A;
        m_truth.current_A(k) = current.atEnd_A;
    }
}

void PlanarPlant::stepSlowForce() {
    // First-order noise with the given rms: exact from step to step.
    const double drawn_N = m_parameters.slowForce_N * std::sqrt(1.0 - m_slowKept * m_slowKept);
    m_truth.slowForce_N = m_slowKept * m_truth.slowForce_N +
                          drawn_N * Eigen::Vector2d(m_slowNoise.gaussian(), m_slowNoise.gaussian());
}

void PlanarPlant::heat(const CoilCurrents_A& current_A) {
    const double step_s = m_subStep_s * m_parameters.thermalAcceleration_ratio;
    if (step_s == 0.0) {
        return;
    }
    for (std::size_t k = 0; k < m_coil.size(); ++k) {
        stepCoilHeating(m_specimen.coil, m_coil[k], current_A(static_cast<Eigen::Index>(k)), step_s);
        m_coil[k].temperature_degC = std::fmin(m_coil[k].temperature_degC, CopperMelts_degC);
        m_truth.coil_degC[k] = m_coil[k].temperature_degC;
    }
}

void PlanarPlant::advanceOnce() {
    const CoilWrench map = wrenchAt(middlePose(m_specimen.platen, m_truth.platen, m_subStep_s));
    CoilCurrents_A mean_A;
    stepCurrents(map, mean_A);
    if (m_parameters.slowForce_N > 0.0) {
        stepSlowForce();
    }
    m_truth.wrench = wrenchOf(map.wrench * mean_A);
    stepPlaten(m_specimen.platen, m_truth.platen, m_truth.wrench, m_truth.slowForce_N, m_subStep_s);
    m_truth.bearings = m_bearings.under(map.lift_N_per_A.transpose().cwiseProduct(mean_A));
    heat(mean_A);
    if (m_stepsToFault > 0 && --m_stepsToFault == 0) {
        takeFaults();
    }
}

void PlanarPlant::advance(int subSteps) {
    for (int i = 0; i < subSteps; ++i) {
        advanceOnce();
    }
}

} // namespace halbench::models
