#include "models/spherical/calibration_remainder.h"
#include "models/spherical/orientation_estimator.h"
#include "models/spherical/orientation_uncertainty.h"
#include "models/spherical/spherical_plant.h"
#include "tests/models/spherical/orientation_cases.h"

#include <gtest/gtest.h>

namespace halbench::models {
namespace {

SphericalCalibration nominalDevice() {
    return nominalCalibration(sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05), {Q, 0.05, {}});
}

/// Readings without noise of a specimen with the default spreads of the simulated device.
SphericalReadings specimenReadings_T(const SphericalSpecimen& specimen, const Eigen::Matrix3d& rotation) {
    const RotorField field(nominalDevice().field);
    SphericalReadings readings_T = field.readings_T(rotation, specimen.poses);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = static_cast<Eigen::Index>(3 * i);
        const FieldSensorConfig& sensor = specimen.sensors[i];
        const Eigen::Vector3d scaled = sensor.gain_ratio.cwiseProduct(readings_T.segment<3>(at));
        readings_T.segment<3>(at) = scaled + sensor.crossAxis_ratio * scaled + sensor.offset_T;
    }
    return readings_T;
}

// The second route: the errors that specimens really have. Gaussians cut at twice their deviation have 0.88
// of it; the rms over 400 specimens is known to 3 % and poses of one specimen belong together.
TEST(RemainingError, isThatOfManySpecimens) {
    const SphericalCalibration nominal = nominalDevice();
    const RemainingError remaining(nominal, assemblyRemainder(nominal, {}));
    const OrientationEstimator estimator = *OrientationEstimator::make(sensingOf(nominal, 100e-6), {});
    double seen = 0.0;
    double expected = 0.0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        const SphericalSpecimen specimen = drawSphericalSpecimen({}, seed);
        Random random(seed);
        for (int i = 0; i < 5; ++i) {
            const Eigen::Matrix3d truth = rotationOf(drawn(random));
            double strength_T = 0.0;
            const Eigen::Matrix3d found = estimator.solve(specimenReadings_T(specimen, truth), strength_T);
            seen += std::pow(symmetricError_rad(found, truth), 2);
            expected += remaining.covariance_rad2(truth).trace();
        }
    }
    EXPECT_NEAR(std::sqrt(seen / expected), 0.88, 0.05);
}

// Default of the board's `sensor.tolerance`, as the same error in uncorrelated readings.
TEST(RemainingError, ofTheAssemblyIsTheDefaultOfTheBoard) {
    const SphericalCalibration nominal = nominalDevice();
    const double tolerance_T = RemainingError(nominal, assemblyRemainder(nominal, {})).readingDeviation_T();
    EXPECT_NEAR(tolerance_T, 3.65e-3, 0.01e-3);
}

// Offsets alone are uncorrelated errors of the readings.
TEST(RemainingError, ofOffsetsIsTheirSize) {
    const SphericalCalibration nominal = nominalDevice();
    AssemblyTolerance offsets{0.0, 0.0, 2e-3, 0.0, 0.0};
    const RemainingError remaining(nominal, assemblyRemainder(nominal, offsets));
    EXPECT_NEAR(remaining.readingDeviation_T(), 2e-3, 1e-12);
    // And their effect that of noise of this size.
    const OrientationEstimator estimator = *OrientationEstimator::make(sensingOf(nominal, 2e-3), {});
    const RotorField field(nominal.field);
    SensorPoses poses = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
    const Eigen::Matrix3d rotation = rotationOf(angles_deg(10, -20, 30));
    const OrientationEstimate estimate = estimator.estimate(field.readings_T(rotation, poses));
    EXPECT_LT((estimate.covariance_rad2 - remaining.covariance_rad2(rotation)).norm(),
              1e-6 * estimate.covariance_rad2.norm());
}

} // namespace
} // namespace halbench::models
