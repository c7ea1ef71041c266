#include "models/spherical/spherical_sensing.h"
#include "models/spherical/swarm_estimator.h"
#include "tests/models/spherical/swarm_success.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::models {
namespace {

TEST(SwarmEstimator, successRatesAreTheKnownOnes) {
    for (const SwarmCase& known : SwarmCases) {
        const SwarmSuccess success = swarmSuccess(configOf(known), known.knowsSignOfBeta, 2500, 31);
        // 3 points; 2500 poses scatter by less than 1.
        EXPECT_NEAR(success.right_ratio, known.right_ratio, 0.03);
    }
}

TEST(SwarmEstimator, fitsAtWrongPosesAreCounted) {
    SwarmConfig config;
    config.trigger = SwarmTrigger::Absolute;
    EXPECT_NEAR(swarmSuccess(config, false, 2500, 32).wrongFit_ratio, 0.238, 0.03);
}

TEST(SwarmEstimator, jacobianOfTheMainSensorIsSingularAtTheHomePose) {
    // det = -+4 KR KT^2 cos^2 b sin 2b sin 2g with KR = 3 q, KT = -q
    const AngleModel model = angleModel(AdditiveModel{});
    Random random(33);
    for (int i = 0; i < 200; ++i) {
        const OrientationAngles angles = drawn(random);
        OrientationJacobian jacobian;
        model(angles, &jacobian);
        const double cb = std::cos(angles.beta_rad);
        const double known =
            12.0 * Q * Q * Q * cb * cb * std::sin(2.0 * angles.beta_rad) * std::sin(2.0 * angles.gamma_rad);
        EXPECT_NEAR(std::abs(jacobian.topRows<3>().determinant()), std::abs(known), 1e-15);
    }
}

TEST(SwarmEstimator, exactModelCanBeSearchedToo) {
    const SphericalSensing sensing;
    const RotorField field(sensing.field);
    const AngleModel model = angleModel(field, sensing.poses);
    SwarmConfig config;
    config.rule = SwarmRule::AllNine;
    Random random(34);
    int right = 0;
    double last_T2 = HUGE_VAL;
    for (int i = 0; i < 200; ++i) {
        const Eigen::Matrix3d truth = rotationOf(drawn(random));
        last_T2 = HUGE_VAL;
        const SwarmEstimate found = estimateBySwarm(model, config, field.readings_T(truth, sensing.poses),
                                                    random, [&](double fitness_T2) {
                                                        EXPECT_LE(fitness_T2, last_T2);
                                                        last_T2 = fitness_T2;
                                                    });
        right += symmetricError_rad(rotationOf(found.angles), truth) < degreesToRadians(0.1);
    }
    // Only poses whose image lies across the border of the box may be missed: about 3 % for spins near +-90.
    EXPECT_GE(right, 185);
}

TEST(SwarmEstimator, refusesEmptyBoxesAndSwarms) {
    SwarmConfig config;
    config.particles = 0;
    EXPECT_EQ(checkSwarmConfig(config).error().code, ErrorCode::OutOfRange);
    config = {};
    config.box.low.beta_rad = config.box.high.beta_rad;
    EXPECT_EQ(checkSwarmConfig(config).error().code, ErrorCode::OutOfRange);
    config = {};
    config.nullSpaceGain = std::nan("");
    EXPECT_EQ(checkSwarmConfig(config).error().code, ErrorCode::NotFinite);
}

} // namespace
} // namespace halbench::models
