#pragma once

#include "models/spherical/field_sensor.h"
#include "models/spherical/rotor_motion.h"
#include "models/spherical/spherical_parameters.h"

#include <array>
#include <cstdint>
#include <span>

namespace halbench::models {

/// One device as built: what the seed made of the spreads.
struct SphericalSpecimen {
    SensorPoses poses; ///< true ones
    std::array<FieldSensorConfig, 3> sensors;
    double temperatureError_K = 0.0;
};
/// Draws the individual errors: Gaussian with the given 1 sigma, cut at twice it. Each kind of error has its
/// own stream of the generator: writing one down does not change the others.
SphericalSpecimen drawSphericalSpecimen(const SphericalParameters& parameters, std::uint64_t seed);

/// The state that no board can measure.
struct SphericalTruth {
    double time_s = 0.0;
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d rate_rad_s = Eigen::Vector3d::Zero(); ///< stator frame
    double strength_T = 0.0;                              ///< q at 50 mm and this temperature
    double magnet_degC = 25.0;
    SphericalReadings field_T = SphericalReadings::Zero(); ///< in the sensors' true axes, before their errors
};

/// The spherical motor's rotor, which moves as prescribed, between its three field sensors and a stator coil:
///   reading = converter(errors(axes^T (rotor field + coil field + uniform field)) + noise).
/// The additive device ignores mounting errors: its sensors have no physical axes. Same parameters and seed
/// give the same bits. Thread: any one. Source: resources/help/spherical-theory.md sections 3 and 4.
class SphericalPlant {
public:
    static constexpr double SubStep_s = 0.25e-3;
    /// Codes of (R, Theta, Phi) of sensors 0, 1, 2, then coil current (A) and temperature (degC).
    static constexpr int ReadingCount = 11;
    static constexpr int CurrentIndex = 9;
    static constexpr int TemperatureIndex = 10;

    /// Parameters have passed setSphericalParameter(). Errors: OutOfRange of checkSphericalParameters().
    static Result<SphericalPlant> make(const SphericalParameters& parameters, std::uint64_t seed,
                                       double subStep_s = SubStep_s);
    /// A motion by table instead of that of the parameters. Errors: also those of checkRotorMotion().
    static Result<SphericalPlant> make(const SphericalParameters& parameters, const RotorMotionConfig& motion,
                                       std::uint64_t seed, double subStep_s = SubStep_s);

    /// Samples all sensors at this instant; draws their noise. Field = code * converter().step_T.
    void read(std::span<float> codes);
    void advance(int subSteps);
    /// As RotorMotion::turnTo() and setRate().
    void turnTo(const OrientationAngles& target, double rate_rad_s) { m_motion.turnTo(target, rate_rad_s); }
    void setRate(double rate_rad_s) { m_motion.setRate(rate_rad_s); }
    void setCoilCurrent_A(double current_A) { m_current_A = current_A; }
    void setFault(int channel, ChannelFault fault);

    const SphericalTruth& truth() const { return m_truth; }
    const SphericalParameters& parameters() const { return m_parameters; }
    const SphericalSpecimen& specimen() const { return m_specimen; }
    const FieldConverter& converter() const { return m_specimen.sensors[0].converter; }

private:
    SphericalPlant(const SphericalParameters& parameters, const RotorMotionConfig& motion, std::uint64_t seed,
                   double subStep_s);
    void refresh();

    double m_subStep_s;
    SphericalParameters m_parameters;
    SphericalSpecimen m_specimen;
    RotorField m_field;
    RotorMotion m_motion;
    SphericalReadings m_coil_T_per_A;
    SphericalReadings m_uniform_T;
    std::array<FieldSensorState, 3> m_state;
    double m_current_A;
    SphericalTruth m_truth;
    Random m_noise;
};

} // namespace halbench::models
