#include "models/spherical/additive_model.h"
#include "models/spherical/any_estimator.h"
#include "models/spherical/spherical_parameters.h"
#include "models/spherical/tensor_rotation.h"
#include "tests/models/spherical/orientation_cases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

namespace halbench::models {
namespace {

struct KnownReadings {
    std::string_view device;
    std::array<double, 3> angles_deg;
    std::array<double, 9> readings_T;
};

// Calculated by another program from the printed equations in spherical coordinates of the rotor
// (sections 3.2 and 3.4 of resources/help/spherical-theory.md) with sines and cosines, where the models work
// with tensors and solid harmonics.
constexpr std::array<KnownReadings, 12> Known = {{
    {"zyx",
     {12, -20, 33},
     {0.106870700915, 0.060771203152, -0.161180789753, 0.218706524617, 0.070050277096, 0.086623573952,
      0.004006922690, 0.064040760676, 0.157911232229}},
    {"xyz",
     {12, -20, 33},
     {0.106870700915, 0.060771203152, -0.161180789753, 0.218706524617, 0.070050277096, 0.086623573952,
      0.004006922690, -0.157911232229, 0.064040760676}},
    {"nat",
     {12, -20, 33},
     {0.106870700915, 0.060771203152, -0.161180789753, 0.218706524617, 0.070050277096, 0.086623573952,
      0.004006922690, -0.066376446989, 0.156943759281}},
    {"paper",
     {12, -20, 33},
     {0.106870700915, 0.060771203152, -0.161180789753, 0.240035524308, 0.041207304696, 0.086272354627,
      -0.021616408736, 0.015794253595, 0.081063845130}},
    {"H1",
     {12, -20, 33},
     {0.106081226876, 0.061748578872, -0.160569470228, 0.217768276585, 0.072750028769, 0.087163760589,
      0.003930696459, 0.063442567272, 0.156319063946}},
    {"H2",
     {12, -20, 33},
     {0.109839583689, 0.103584951408, -0.156182809397, 0.205567944290, 0.159857995603, 0.073992695558,
      0.002395684191, 0.051312216480, 0.121539480382}},
    {"zyx",
     {-37, 41, -76},
     {-0.149647125002, 0.111560447607, 0.003941345441, 0.026622287055, 0.005645438594, -0.121454286813,
      -0.080541325173, 0.119755353828, -0.012136251662}},
    {"xyz",
     {-37, 41, -76},
     {-0.149647125002, 0.111560447607, 0.003941345441, 0.026622287055, 0.005645438594, -0.121454286813,
      -0.080541325173, 0.012136251662, 0.119755353828}},
    {"nat",
     {-37, 41, -76},
     {-0.149647125002, 0.111560447607, 0.003941345441, 0.026622287055, 0.005645438594, -0.121454286813,
      -0.080541325173, 0.093261448624, 0.076098196927}},
    {"paper",
     {-37, 41, -76},
     {-0.149647125002, 0.111560447607, 0.003941345441, -0.079568787785, -0.042726951581, -0.133322231902,
      0.261450954399, -0.090303187483, -0.024999354441}},
    {"H1",
     {-37, 41, -76},
     {-0.146297342125, 0.111384461339, 0.003343053968, 0.025900016783, 0.005504585121, -0.119368338990,
      -0.078394772781, 0.118075514831, -0.011742376807}},
    {"H2",
     {-37, 41, -76},
     {-0.030736614339, 0.110494819554, -0.036626474652, -0.002502441901, -0.006426590172, -0.040552319599,
      0.001287162219, 0.062063620508, 0.018732152414}},
}};

TEST(SphericalDevices, readingsAreThoseOfAnotherRoute) {
    for (const KnownReadings& known : Known) {
        SphericalParameters parameters;
        parameters.harmonics = known.device == "H1" ? 1.0 : known.device == "H2" ? 2.0 : 0.0;
        const RotorField field(rotorFieldOf(parameters));
        const SensorFrames frames = known.device == "xyz"   ? SensorFrames::Xyz
                                    : known.device == "nat" ? SensorFrames::Natural
                                                            : SensorFrames::Zyx;
        const OrientationAngles angles =
            angles_deg(known.angles_deg[0], known.angles_deg[1], known.angles_deg[2]);
        const SphericalReadings readings_T =
            known.device == "paper"
                ? additiveReadings_T({field.config().strength_T, publishedPlacement()}, angles)
                : field.readings_T(rotationOf(angles), sensorPoses(publishedPlacement(), frames, 0.05));
        for (int i = 0; i < 9; ++i) {
            EXPECT_NEAR(readings_T[i], known.readings_T[static_cast<std::size_t>(i)], 1e-10)
                << known.device << i;
        }
    }
}

TEST(Tracking, threeStepsFromThePoseBeforeAreExact) {
    const SphericalSensing sensing;
    const TensorSystem system(sensing);
    Random random(95);
    double worst_rad = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        const TensorVector tensor_T = Q * unitTensor(truth);
        Eigen::Vector3d off_rad;
        for (double& entry : off_rad) {
            entry = degreesToRadians(6.0 * random.uniform() - 3.0);
        }
        Eigen::Matrix3d rotation = rotationOfVector(off_rad) * truth;
        for (int step = 0; step < 3; ++step) {
            refineRotation(tensor_T, system.information(), Q, rotation);
        }
        worst_rad = std::max(worst_rad, symmetricError_rad(rotation, truth));
    }
    EXPECT_LT(radiansToDegrees(worst_rad),
              2e-7); // 1.3e-7 degrees are known for starts up to 3 degrees an axis
}

TEST(AnyEstimator, isCrossedWithBothDevices) {
    const RotorField field({Q, 0.05, {}});
    const SensorPoses poses = sensorPoses(publishedPlacement(), SensorFrames::Zyx, 0.05);
    std::vector<Eigen::Matrix3d> truth;
    std::vector<SphericalReadings> exact_T;
    std::vector<SphericalReadings> additive_T;
    Random random(96);
    for (int i = 0; i < 400; ++i) {
        const OrientationAngles angles = drawn(random);
        truth.push_back(rotationOf(angles));
        exact_T.push_back(field.readings_T(truth.back(), poses));
        additive_T.push_back(additiveReadings_T({}, angles));
    }
    for (std::size_t kind = 0; kind < EstimatorNames.size(); ++kind) {
        AnyEstimatorConfig config;
        config.kind = static_cast<EstimatorKind>(static_cast<int>(kind));
        config.settings.chiSquareLimit = 1e12; // the additive device contradicts the exact model
        config.swarm.rule = SwarmRule::AllNine;
        const AnyEstimator estimator = *makeAnyEstimator(config);
        const bool isExact = config.kind <= EstimatorKind::LevenbergMarquardt;
        const double limit_rad = degreesToRadians(0.1);
        const EstimatorErrors own =
            estimatorErrors(estimator, isExact ? exact_T : additive_T, truth, limit_rad);
        const EstimatorErrors other =
            estimatorErrors(estimator, isExact ? additive_T : exact_T, truth, limit_rad);
        EXPECT_EQ(own.poses, 400);
        // The swarm misses some 3 %.
        EXPECT_LE(own.failures, config.kind == EstimatorKind::Swarm ? 30 : 0) << EstimatorNames[kind];
        EXPECT_GT(other.failures, 380) << EstimatorNames[kind];
        EXPECT_GT(radiansToDegrees(other.rms_rad), 5.0) << EstimatorNames[kind];
    }
    AnyEstimatorConfig elsewhere;
    elsewhere.kind = EstimatorKind::Closed;
    elsewhere.additive.placement = recommendedPlacement();
    EXPECT_EQ(makeAnyEstimator(elsewhere).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::models
