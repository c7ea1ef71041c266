#pragma once

#include "control/base/random.h"
#include "models/htm/htm_specimen.h"
#include "models/htm/rotor_step.h"
#include "models/sensors/adc.h"

#include <array>
#include <cstdint>

namespace halbench::models {

/// Readings of the board's converter: codes as real numbers; the ideal chain keeps their fractions.
struct HtmReadings {
    std::array<double, 2> hallCode{};
    std::array<double, 2> temperatureCode{};
};

/// Outputs of the board. `amplitude_A` is used by the ideal chain only, where torque = phi I.
struct HtmDrive {
    std::array<double, 2> dacCode{2048.0, 2048.0};
    double amplitude_A = 0.0;
};

/// The state nobody can measure on a real motor.
struct HtmTruth {
    RotorState rotor;
    std::array<double, 2> current_A{};
    std::array<double, 2> coil_degC{};
    double torque_Nm = 0.0; ///< mean of the last sub-step
};

/// The whole motor between the board's DAC and its ADC: converters, amplifiers, coils, rotor, magnets, Hall
/// and temperature sensors, heat. Advances in sub-steps, usually of 0.25 ms: exact amplifier update, torque
/// from the exact mean currents at the predicted mid-step angle, event-exact friction
/// (resources/help/htm-theory.md sections 3, 9). Same parameters and seed give the same bits. Thread: any
/// one.
class HtmPlant {
public:
    static constexpr double SubStep_s = 0.25e-3;

    /// Parameters have passed setHtmParameter(). A board that runs instruction by instruction looks and
    /// drives between the usual sub-steps and asks for shorter ones. Errors: OutOfRange (amplifier parts that
    /// make no amplifier).
    static Result<HtmPlant> make(const HtmParameters& parameters, std::uint64_t seed,
                                 double subStep_s = SubStep_s);

    /// Samples sensors at this instant; draws their noise.
    HtmReadings read();
    /// Takes effect at once and holds.
    void drive(const HtmDrive& drive);
    /// Lets this many sub-steps pass.
    void advance(int subSteps);
    /// A new plateau begins: friction of this run is drawn anew (also done at each start from rest).
    void redrawFriction();

    const HtmTruth& truth() const { return m_truth; }
    const HtmSpecimen& specimen() const { return m_specimen; }
    const HtmParameters& parameters() const { return m_parameters; }

private:
    HtmPlant(const HtmParameters& parameters, const AmplifierModel& amplifier, std::uint64_t seed,
             double subStep_s);
    double torqueOfSubStep_Nm();
    void heat(const std::array<double, 2>& current_A);

    double m_subStep_s;
    HtmParameters m_parameters;
    HtmSpecimen m_specimen;
    AmplifierStepper m_amplifier;
    RotorStep m_rotorStep;
    std::array<AmplifierState, 2> m_amplifierState;
    std::array<CoilHeatingState, 2> m_coil;
    AdcConfig m_adc;
    HtmDrive m_drive;
    std::array<double, 2> m_amplifierInput_V{}; ///< of the codes in m_drive
    HtmTruth m_truth;
    Random m_sensorNoise;
    Random m_friction;
};

} // namespace halbench::models
