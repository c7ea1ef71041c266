#pragma once

#include "control/base/random.h"
#include "models/drives/dac.h"
#include "models/planar/air_bearings.h"
#include "models/planar/planar_specimen.h"
#include "models/planar/wrench_map.h"
#include "models/sensors/adc.h"

#include <array>
#include <cstdint>
#include <span>

namespace halbench::models {

/// The state that no board can measure.
struct PlanarTruth {
    PlatenState platen;
    PlanarWrench wrench; ///< of the coils, mean of the last sub-step, about C
    CoilCurrents_A current_A = CoilCurrents_A::Zero();
    Eigen::Matrix<double, CoilCount, 1> induced_V = Eigen::Matrix<double, CoilCount, 1>::Zero();
    std::array<double, CoilCount> coil_degC{};
    BearingState bearings;
    Eigen::Vector2d slowForce_N = Eigen::Vector2d::Zero();
};

/// The whole positioner between the board's DAC and its ADC: amplifiers, coils, forces by a WrenchModel,
/// platen, bearings, Hall chips, temperature sensors, heat. Advances in sub-steps, usually of 0.25 ms.
/// Converters are bipolar: code 2^bits/2 is 0 V. Same parameters and seed give the same bits. Thread: any
/// one. Source: resources/help/planar-theory.md sections 5.3, 7 and 8.
class PlanarPlant {
public:
    static constexpr double SubStep_s = 0.25e-3;
    /// Codes of Bx'1, By'1, ... By'3, then of the temperatures of coils 1 ... 6.
    static constexpr int ReadingCount = FieldCount + CoilCount;
    static constexpr int DriveCount = CoilCount; ///< DAC codes of the amplifiers

    /// Parameters have passed setPlanarParameter(). Errors: OutOfRange of checkPlanarParameters().
    static Result<PlanarPlant> make(const PlanarParameters& parameters, std::uint64_t seed,
                                    double subStep_s = SubStep_s);

    /// Samples all sensors at this instant into ReadingCount codes; draws their noise.
    void read(std::span<float> codes);
    /// DriveCount codes; they take effect at once and hold.
    void drive(std::span<const float> codes);
    /// Lets this many sub-steps pass.
    void advance(int subSteps);
    void setFault(int chip, ChipFault fault);

    const PlanarTruth& truth() const { return m_truth; }
    const PlanarSpecimen& specimen() const { return m_specimen; }
    const PlanarParameters& parameters() const { return m_parameters; }
    const AirBearings& bearings() const { return m_bearings; }
    /// Coil forces for one ampere, with the coils' own gains.
    CoilWrench wrenchAt(const PlanarPose& pose) const;

    AdcConfig adc() const { return m_adc; }
    DacConfig dac() const { return m_dac; }

private:
    PlanarPlant(const PlanarParameters& parameters, std::uint64_t seed, double subStep_s);
    void takeFaults();
    void advanceOnce();
    void stepCurrents(const CoilWrench& map, CoilCurrents_A& mean_A);
    void stepSlowForce();
    void heat(const CoilCurrents_A& current_A);

    double m_subStep_s;
    PlanarParameters m_parameters;
    PlanarSpecimen m_specimen;
    WrenchMap m_map;
    AirBearings m_bearings;
    AdcConfig m_adc;
    DacConfig m_dac;
    std::array<double, DriveCount> m_demand_A{};
    std::array<CoilHeatingState, CoilCount> m_coil;
    std::array<ChipFault, ChipCount> m_fault{};
    std::int64_t m_stepsToFault;
    std::array<Eigen::Vector2d, ChipCount> m_report_T;
    PlanarTruth m_truth;
    Random m_sensorNoise;
    Random m_slowNoise;
    double m_slowKept = 0.0; ///< share of the slow force that outlasts a sub-step
};

} // namespace halbench::models
