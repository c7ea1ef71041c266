#include "models/spherical/spherical_plant.h"

#include "control/base/assert.h"
#include "models/spherical/additive_model.h"
#include "models/spherical/tensor_system.h"

#include <cmath>

namespace halbench::models {
namespace {

// One stream of the generator for each kind of error.
enum class Stream : std::uint64_t {
    Gain = 1,
    Offset,
    CrossAxis,
    Turn,
    Shift,
    Temperature,
    Noise = 101,
    Walk
};

constexpr double ReferenceTemperature_degC = 25.0;

double cutGaussian(Random& random, double sigma) {
    constexpr double Cut = 2.0;
    double value = random.gaussian();
    while (std::abs(value) > Cut) {
        value = random.gaussian();
    }
    return sigma * value;
}

// The written values, or what the stream gives: drawn in any case, so that the others keep theirs.
Eigen::Vector3d drawn(const std::array<std::optional<double>, 3>& written, Random& random, double sigma) {
    Eigen::Vector3d values;
    for (int k = 0; k < 3; ++k) {
        const double value = cutGaussian(random, sigma);
        values[k] = written[static_cast<std::size_t>(k)].value_or(value);
    }
    return values;
}

} // namespace

SphericalSpecimen drawSphericalSpecimen(const SphericalParameters& p, std::uint64_t seed) {
    const auto stream = [seed](Stream which) { return Random(seed).fork(static_cast<std::uint64_t>(which)); };
    Random gain = stream(Stream::Gain);
    Random offset = stream(Stream::Offset);
    Random cross = stream(Stream::CrossAxis);
    Random turn = stream(Stream::Turn);
    Random shift = stream(Stream::Shift);
    SphericalSpecimen specimen;
    const SensorPoses nominal =
        sensorPoses(p.placement, static_cast<SensorFrames>(static_cast<int>(p.frames)), p.sensorRadius_m);
    for (std::size_t i = 0; i < nominal.size(); ++i) {
        FieldSensorConfig& sensor = specimen.sensors[i];
        const FieldSensorErrors& errors = p.errors[i];
        sensor.gain_ratio = Eigen::Vector3d::Ones() + drawn(errors.gain_ratio, gain, p.gainSpread_ratio);
        sensor.offset_T = drawn(errors.offset_T, offset, p.offsetSpread_T);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                if (row != column) {
                    sensor.crossAxis_ratio(row, column) = cutGaussian(cross, p.crossSpread_ratio);
                }
            }
        }
        const Eigen::Vector3d turn_rad = drawn(errors.turn_rad, turn, p.turnSpread_rad);
        specimen.poses[i] =
            displacedPose(nominal[i], turn_rad, drawn(errors.shift_m, shift, p.shiftSpread_m));
        sensor.noise_T = p.noise_T;
        sensor.converter = converterPreset(static_cast<ConverterPreset>(static_cast<int>(p.converter)));
        sensor.converter.isQuantised = !p.isIdealChain;
        for (std::size_t k = 0; k < 3; ++k) {
            sensor.fault[k] = static_cast<ChannelFault>(static_cast<int>(p.fault[3 * i + k]));
        }
    }
    Random temperature = stream(Stream::Temperature);
    const double error_K = cutGaussian(temperature, p.temperatureSpread_K);
    specimen.temperatureError_K = p.temperatureError_K.value_or(error_K);
    return specimen;
}

Result<SphericalPlant> SphericalPlant::make(const SphericalParameters& parameters, std::uint64_t seed,
                                            double subStep_s) {
    return make(parameters, motionOf(parameters), seed, subStep_s);
}

Result<SphericalPlant> SphericalPlant::make(const SphericalParameters& parameters,
                                            const RotorMotionConfig& motion, std::uint64_t seed,
                                            double subStep_s) {
    if (auto checked = checkSphericalParameters(parameters); !checked) {
        return failure(checked.error());
    }
    if (auto checked = checkRotorMotion(motion); !checked) {
        return failure(checked.error());
    }
    SphericalPlant plant(parameters, motion, seed, subStep_s);
    // Errors may push a sensor into the rotor.
    if (auto checked = checkSensorPoses(plant.m_specimen.poses, parameters.magnet.outerRadius_m); !checked) {
        return failure(checked.error());
    }
    return plant;
}

SphericalPlant::SphericalPlant(const SphericalParameters& parameters, const RotorMotionConfig& motion,
                               std::uint64_t seed, double subStep_s)
    : m_subStep_s(subStep_s), m_parameters(parameters), m_specimen(drawSphericalSpecimen(parameters, seed)),
      m_field(rotorFieldOf(parameters)),
      m_motion(motion, Random(seed).fork(static_cast<std::uint64_t>(Stream::Walk)).bits()),
      m_uniform_T(uniformFieldDesign(m_specimen.poses) * parameters.strayField_T),
      m_current_A(parameters.coilCurrent_A),
      m_noise(Random(seed).fork(static_cast<std::uint64_t>(Stream::Noise))) {
    const CurrentLoop coil = statorCoilOf(parameters);
    for (int i = 0; i < 3; ++i) {
        const SensorPose& pose = m_specimen.poses[static_cast<std::size_t>(i)];
        m_coil_T_per_A.segment<3>(3 * i) = pose.axes.transpose() * loopField_T_per_A(coil, pose.position_m);
    }
    refresh();
}

void SphericalPlant::refresh() {
    const SphericalParameters& p = m_parameters;
    m_truth.time_s = m_motion.time_s();
    m_truth.rotation = m_motion.rotation();
    m_truth.rate_rad_s = m_motion.rate_rad_s();
    m_truth.magnet_degC = p.ambient_degC - p.warmRise_K * std::expm1(-m_truth.time_s / p.warmTime_s);
    const double scale =
        1.0 + p.strengthTemperature_per_K * (m_truth.magnet_degC - ReferenceTemperature_degC);
    m_truth.strength_T = scale * m_field.config().strength_T;
}

void SphericalPlant::read(std::span<float> codes) {
    HB_ASSERT(codes.size() == static_cast<std::size_t>(ReadingCount));
    const double scale = m_truth.strength_T / m_field.config().strength_T;
    if (static_cast<SphericalDevice>(static_cast<int>(m_parameters.device)) == SphericalDevice::Additive) {
        const double fall = m_field.config().referenceRadius_m / m_parameters.sensorRadius_m;
        const AdditiveModel model{m_truth.strength_T * std::pow(fall, 4), m_parameters.placement};
        m_truth.field_T = additiveReadings_T(model, anglesOf(m_truth.rotation));
    } else {
        m_truth.field_T = scale * m_field.readings_T(m_truth.rotation, m_specimen.poses);
    }
    m_truth.field_T += m_current_A * m_coil_T_per_A + m_uniform_T;
    for (std::size_t i = 0; i < m_specimen.sensors.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(3 * i);
        const FieldSample sample =
            sampleFieldSensor(m_specimen.sensors[i], m_state[i], m_truth.field_T.segment<3>(row), m_noise);
        for (std::size_t k = 0; k < 3; ++k) {
            codes[3 * i + k] =
                static_cast<float>(sample.value_T[static_cast<Eigen::Index>(k)] / converter().step_T);
        }
    }
    codes[CurrentIndex] = static_cast<float>(m_current_A);
    codes[TemperatureIndex] = static_cast<float>(m_truth.magnet_degC + m_specimen.temperatureError_K);
}

void SphericalPlant::advance(int subSteps) {
    for (int i = 0; i < subSteps; ++i) {
        m_motion.advance(m_subStep_s);
    }
    refresh();
}

void SphericalPlant::setFault(int channel, ChannelFault fault) {
    HB_ASSERT(channel >= 0 && channel < 9);
    m_specimen.sensors[static_cast<std::size_t>(channel / 3)].fault[static_cast<std::size_t>(channel % 3)] =
        fault;
}

} // namespace halbench::models
