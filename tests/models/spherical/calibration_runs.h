#pragma once

#include "models/spherical/calibration_fit.h"
#include "models/spherical/orientation_estimator.h"
#include "models/spherical/spherical_plant.h"
#include "tests/models/spherical/orientation_cases.h"

#include <map>

namespace halbench::models {

/// A specimen with 1 % gain, 1 mT offset and 1 degree mounting errors.
inline SphericalParameters erroneousDevice() {
    SphericalParameters parameters;
    parameters.crossSpread_ratio = 0.0;
    parameters.shiftSpread_m = 0.0;
    parameters.isIdealChain = true;
    parameters.motion = static_cast<double>(MotionKind::Tumble);
    parameters.rate_rad_s = 1.1;
    return parameters;
}

inline std::vector<CalibrationSample> recordedMotion(SphericalPlant& plant, int samples, bool isKnown) {
    std::vector<CalibrationSample> recorded;
    std::array<float, SphericalPlant::ReadingCount> codes{};
    for (int i = 0; i < samples; ++i) {
        plant.advance(400); // 0.1 s
        plant.read(codes);
        CalibrationSample sample;
        for (int k = 0; k < 9; ++k) {
            sample.readings_T[k] =
                static_cast<double>(codes[static_cast<std::size_t>(k)]) * plant.converter().step_T;
        }
        sample.coilCurrent_A = static_cast<double>(codes[SphericalPlant::CurrentIndex]);
        sample.temperature_degC = static_cast<double>(codes[SphericalPlant::TemperatureIndex]);
        if (isKnown) {
            sample.reference = plant.truth().rotation;
        }
        recorded.push_back(sample);
    }
    return recorded;
}

inline SphericalCalibration nominalOf(const SphericalPlant& plant) {
    return nominalCalibration(sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05),
                              rotorFieldOf(plant.parameters()));
}

/// rms rotation error of the refined tensor over fresh noisy poses of the workspace, degrees.
inline double calibratedError_deg(const SphericalPlant& plant, const SphericalCalibration& calibration,
                                  std::uint64_t seed) {
    const OrientationEstimator estimator = *OrientationEstimator::make(sensingOf(calibration, 100e-6), {});
    const RotorField field(rotorFieldOf(plant.parameters()));
    Random random(seed);
    RootMeanSquare error;
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        SphericalReadings readings_T = field.readings_T(truth, plant.specimen().poses);
        for (int k = 0; k < 9; ++k) {
            const FieldSensorConfig& sensor = plant.specimen().sensors[static_cast<std::size_t>(k / 3)];
            readings_T[k] = sensor.gain_ratio[k % 3] * readings_T[k] + sensor.offset_T[k % 3];
        }
        readings_T = correctedReadings_T(calibration, readings_T + noise_T(random, 100e-6));
        double strength_T = 0.0;
        error.add(symmetricError_rad(estimator.solve(readings_T, strength_T), truth));
    }
    return radiansToDegrees(error.value());
}

/// True value of an unknown with the gauge of the calibration: the mean gain is one.
inline double trueValue(const SphericalPlant& plant, const CalibrationUnknown& unknown) {
    double meanGain = 0.0;
    for (const FieldSensorConfig& sensor : plant.specimen().sensors) {
        meanGain += sensor.gain_ratio.sum() / 9.0;
    }
    const auto i = static_cast<std::size_t>(unknown.sensor);
    const FieldSensorConfig& sensor = plant.specimen().sensors[i];
    switch (unknown.kind) {
    case CalibrationKind::Strength:
        return meanGain * plant.truth().strength_T;
    case CalibrationKind::Harmonic:
        return meanGain * rotorFieldOf(plant.parameters())
                              .harmonics[static_cast<std::size_t>(unknown.component)]
                              .amplitude_T;
    case CalibrationKind::Gain:
        return sensor.gain_ratio[unknown.component] / meanGain;
    case CalibrationKind::Offset:
        return sensor.offset_T[unknown.component];
    default:
        break;
    }
    const SensorPoses nominal = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
    return vectorOfRotation(plant.specimen().poses[i].axes * nominal[i].axes.transpose())[unknown.component];
}

struct IntervalCount {
    int inside = 0;
    int all = 0;
    double ratio() const { return static_cast<double>(inside) / all; }
};

/// Intervals that hold the truth, by kind of unknown, over several seeds.
inline std::map<CalibrationKind, IntervalCount> intervalCounts(int seeds) {
    std::map<CalibrationKind, IntervalCount> counts;
    for (int seed = 1; seed <= seeds; ++seed) {
        SphericalPlant plant = *SphericalPlant::make(erroneousDevice(), static_cast<std::uint64_t>(seed));
        const auto samples = recordedMotion(plant, 200, false);
        const CalibrationFit fit = *calibrate(nominalOf(plant), samples, {});
        for (const CalibratedValue& value : fit.values) {
            IntervalCount& count = counts[value.unknown.kind];
            ++count.all;
            count.inside += std::abs(value.value - trueValue(plant, value.unknown)) < value.half95;
        }
    }
    return counts;
}

} // namespace halbench::models
