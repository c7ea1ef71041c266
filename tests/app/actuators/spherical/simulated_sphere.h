#pragma once

#include "app/actuators/actuator.h"
#include "control/base/units.h"
#include "devices/open/open_device.h"
#include "models/spherical/orientation.h"
#include "models/spherical/spherical_plant.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

namespace halbench::app {

inline std::unique_ptr<devices::Device> openSphere(const std::string& query) {
    auto device = devices::openDevice("sim:spherical?" + query, {});
    EXPECT_TRUE(device) << device.error().message;
    return device ? std::move(*device) : nullptr;
}

inline CalibrateConfig sensorsOnly(bool isApplied) {
    CalibrateConfig config;
    config.which = {Calibration::Hall};
    config.apply = isApplied;
    return config;
}

inline CalibrateResult calibratedSphere(devices::Device& device, const CalibrateConfig& config) {
    const auto result = actuatorOf("spherical").calibrate.run(device, config, {});
    EXPECT_TRUE(result) << result.error().message << " " << result.error().hint;
    return result ? *result : CalibrateResult{};
}

inline bool hasSphereFinding(const CalibrateResult& result, const std::string& code) {
    return std::any_of(result.quality.findings.begin(), result.quality.findings.end(),
                       [&](const Finding& finding) { return finding.code == code; });
}

/// Errors of the board's orientation against the simulation's truth over the motion that follows.
struct BoardErrors {
    double rms_deg = 0.0; ///< modulo the symmetry of the rotor
    double inCone = 0.0;  ///< share of the samples whose shaft lies in the 95 % cone
    double meanCone_deg = 0.0;
};

inline BoardErrors boardErrors(devices::Device& device, int samples) {
    const std::string names[] = {"orientation.alpha", "orientation.beta", "orientation.gamma", "truth.alpha",
                                 "truth.beta",        "truth.gamma",      "shaft.cone95"};
    BoardErrors errors;
    for (int i = 0; i < samples; ++i) {
        EXPECT_TRUE(device.clock().waitFor(0.1));
        const auto v = device.readSignals(names);
        if (!v) {
            ADD_FAILURE() << v.error().message;
            return errors;
        }
        const Eigen::Matrix3d truth = models::rotationOf({(*v)[3], (*v)[4], (*v)[5]});
        const Eigen::Matrix3d found =
            models::nearestImage(models::rotationOf({(*v)[0], (*v)[1], (*v)[2]}), truth);
        const double off_deg = radiansToDegrees(models::vectorOfRotation(found * truth.transpose()).norm());
        errors.rms_deg += off_deg * off_deg / samples;
        const double tilt_rad = std::acos(std::clamp(found.col(2).dot(truth.col(2)), -1.0, 1.0));
        errors.inCone += tilt_rad <= (*v)[6] ? 1.0 / samples : 0.0;
        errors.meanCone_deg += radiansToDegrees((*v)[6]) / samples;
    }
    errors.rms_deg = std::sqrt(errors.rms_deg);
    return errors;
}

/// What the calibration must find of a specimen, by the figure's name: the symmetric part of the cross-axis
/// shares is the skew, the antisymmetric part a turn; a radial error of the place is one of the gains
/// (fourth power of the distance); the mean of all gains is one and belongs to the strength.
inline std::map<std::string, double> sphereTruth(const models::SphericalParameters& parameters,
                                                 std::uint64_t seed) {
    const models::SphericalSpecimen specimen = models::drawSphericalSpecimen(parameters, seed);
    const models::SensorPoses nominal =
        models::sensorPoses(parameters.placement, models::SensorFrames::Zyx, parameters.sensorRadius_m);
    constexpr std::array Channels = {"r", "theta", "phi"};
    std::array<Eigen::Vector3d, 3> gain;
    double mean = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double fall = parameters.sensorRadius_m / specimen.poses[i].position_m.norm();
        gain[i] = std::pow(fall, 4) * specimen.sensors[i].gain_ratio;
        mean += gain[i].sum() / 9.0;
    }
    std::map<std::string, double> truth;
    truth["rotor.strength"] = mean * models::rotorFieldOf(parameters).strength_T;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Matrix3d& cross = specimen.sensors[i].crossAxis_ratio;
        const Eigen::Matrix3d skew = 0.5 * (cross + cross.transpose());
        const Eigen::Matrix3d turn = 0.5 * (cross - cross.transpose());
        // (I + A) axes^T = (axes exp(-A))^T to first order.
        const Eigen::Vector3d own(turn(2, 1), turn(0, 2), turn(1, 0));
        const Eigen::Matrix3d axes = specimen.poses[i].axes * models::rotationOfVector(-own);
        const Eigen::Vector3d turned = models::vectorOfRotation(axes * nominal[i].axes.transpose());
        for (std::size_t k = 0; k < 3; ++k) {
            const auto row = static_cast<Eigen::Index>(k);
            truth[fmt::format("sensor{}.gain_{}", i, Channels[k])] = gain[i][row] / mean - 1.0;
            truth[fmt::format("sensor{}.offset_{}", i, Channels[k])] = specimen.sensors[i].offset_T[row];
            truth[fmt::format("sensor{}.turn_{}", i, "xyz"[k])] = turned[row];
        }
        truth[fmt::format("sensor{}.skew_r_theta", i)] = skew(0, 1);
        truth[fmt::format("sensor{}.skew_r_phi", i)] = skew(0, 2);
        truth[fmt::format("sensor{}.skew_theta_phi", i)] = skew(1, 2);
    }
    return truth;
}

struct SphereCoverage {
    int inside = 0;
    int all = 0;
    double coneBefore = 0.0; ///< mean share of the shafts in their cone
    double coneAfter = 0.0;
    double worstAfter_deg = 0.0;
    double ratio() const { return static_cast<double>(inside) / all; }
};

/// Calibrations of many specimens with the default tolerances of the simulated device.
inline SphereCoverage sphereCoverage(int seeds) {
    SphereCoverage coverage;
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto device = openSphere(fmt::format("motion=5&adc=1&temp_error_K=0&seed={}", seed));
        if (device == nullptr) {
            continue;
        }
        coverage.coneBefore += boardErrors(*device, 100).inCone / seeds;
        const CalibrateResult result = calibratedSphere(*device, sensorsOnly(true));
        EXPECT_TRUE(result.isApplied) << seed;
        const auto truth = sphereTruth(models::SphericalParameters{}, static_cast<std::uint64_t>(seed));
        for (const CalibrationFigure& figure : result.figures) {
            const auto known = truth.find(figure.name);
            if (known != truth.end() && figure.estimate.interval95) {
                ++coverage.all;
                coverage.inside += figure.estimate.interval95->first <= known->second &&
                                   known->second <= figure.estimate.interval95->second;
            }
        }
        const BoardErrors after = boardErrors(*device, 100);
        coverage.coneAfter += after.inCone / seeds;
        coverage.worstAfter_deg = std::max(coverage.worstAfter_deg, after.rms_deg);
    }
    return coverage;
}

} // namespace halbench::app
