#pragma once

#include "app/analyses/registry/analyses.h"
#include "control/base/random.h"
#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "models/spherical/rotor_field.h"
#include "models/spherical/spherical_plant.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {

constexpr std::uint64_t Seed = 20;
constexpr double Noise_T = 100e-6;

/// Poses spread over the workspace, read by ideal sensors at the published places with the given noise.
inline devices::RecordedFile recordedPoses(int rows, double noise_T) {
    auto layout = std::make_shared<StreamLayout>();
    for (int i = 0; i < 9; ++i) {
        constexpr std::array Axes = {"r", "theta", "phi"};
        layout->columns.push_back(
            {"field." + std::to_string(i / 3) + "." + Axes[static_cast<std::size_t>(i % 3)], "T"});
    }
    for (const char* angle : {"truth.alpha", "truth.beta", "truth.gamma"}) {
        layout->columns.push_back({angle, "rad"});
    }
    devices::RecordedFile file;
    const models::RotorField field{models::RotorFieldConfig{}};
    const models::SensorPoses poses =
        models::sensorPoses(models::publishedPlacement(), models::SensorFrames::Zyx, 0.05);
    Random random(Seed);
    for (int row = 0; row < rows; ++row) {
        const auto angle = [&](double limit_deg) {
            return degreesToRadians(limit_deg * (2.0 * random.uniform() - 1.0));
        };
        const models::OrientationAngles angles{angle(44.0), angle(44.0), angle(89.0)};
        const models::SphericalReadings readings = field.readings_T(models::rotationOf(angles), poses);
        file.recording.time_s.push_back(0.001 * row);
        for (int i = 0; i < 9; ++i) {
            file.recording.values.push_back(readings[i] + noise_T * random.gaussian());
        }
        for (const double value : {angles.alpha_rad, angles.beta_rad, angles.gamma_rad}) {
            file.recording.values.push_back(value);
        }
    }
    file.recording.layout = layout;
    return file;
}

inline Result<AnalysisOutcome> run(const char* name, const std::map<std::string, std::string>& texts,
                                   const std::map<std::string, bool>& flags = {},
                                   const devices::RecordedFile* file = nullptr,
                                   const AnalysisControl& control = {}) {
    const Analysis* analysis = findAnalysis(name);
    const Result<AnalysisValues> values = parseAnalysisValues(*analysis, texts, flags);
    if (!values) {
        return failure(values.error());
    }
    return analysis->run(*values, file, "motion.csv", control);
}

inline double number(const JsonValue& body, std::initializer_list<const char*> path) {
    const JsonValue* node = &body;
    for (const char* key : path) {
        node = node->find(key);
        if (node == nullptr) {
            ADD_FAILURE() << "no " << key;
            return NAN;
        }
    }
    return node->number();
}

/// Readings of specimens as assembled, another one every ten poses.
inline devices::RecordedFile recordedSpecimens(const models::RotorFieldConfig& config = {}) {
    devices::RecordedFile file = recordedPoses(3000, Noise_T);
    const models::RotorField field{config};
    const models::RotorField plain{models::RotorFieldConfig{}};
    for (std::size_t row = 0; row < 3000; ++row) {
        double* values = &file.recording.values[12 * row];
        const models::SphericalSpecimen specimen = models::drawSphericalSpecimen({}, row / 10);
        const models::SphericalReadings readings =
            field.readings_T(models::rotationOf({values[9], values[10], values[11]}), specimen.poses);
        const models::SphericalReadings ideal = plain.readings_T(
            models::rotationOf({values[9], values[10], values[11]}),
            models::sensorPoses(models::publishedPlacement(), models::SensorFrames::Zyx, 0.05));
        for (Eigen::Index i = 0; i < 9; ++i) {
            const models::FieldSensorConfig& sensor = specimen.sensors[static_cast<std::size_t>(i / 3)];
            const Eigen::Vector3d scaled = sensor.gain_ratio.cwiseProduct(readings.segment<3>(3 * (i / 3)));
            values[i] += scaled[i % 3] + sensor.crossAxis_ratio.row(i % 3).dot(scaled) +
                         sensor.offset_T[i % 3] - ideal[i];
        }
    }
    return file;
}

} // namespace halbench::app
