#include "models/spherical/coverage/coverage_map.h"
#include "models/spherical/coverage/coverage_proof.h"
#include "models/spherical/orientation_estimator.h"
#include "tests/models/spherical/orientation_cases.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <atomic>
#include <cmath>

namespace halbench::models {
namespace {

constexpr double Threshold_T = 0.01;

CoverageModel exactModel(const SensorTriple& placement, SensorFrames frames = SensorFrames::Zyx) {
    return CoverageModel({Q, 0.05, {}}, sensorPoses(placement, frames, 0.05));
}

struct CoverageRow {
    const char* name;
    CoverageModel model;
    double uncovered;
    double spin_ratio;
    std::array<double, 3> least_T;
    double alpha_deg; ///< half extent of the hole
    double beta_deg;
};

// Section 6 of resources/help/spherical-theory.md; counts within 3, other numbers as printed.
std::vector<CoverageRow> coverageTable() {
    return {{"paper", CoverageModel(AdditiveModel{}), 2500, 0.0525, {0.1052, 0.0, 0.0860}, 4.0, 4.0},
            {"zyx", exactModel(publishedPlacement()), 3568, 0.0525, {0.0293, 0.0, 0.0726}, 7.5, 3.1},
            {"xyz",
             exactModel(publishedPlacement(), SensorFrames::Xyz),
             3588,
             0.0525,
             {0.0293, 0.0, 0.0726},
             0,
             0},
            {"nat",
             exactModel(publishedPlacement(), SensorFrames::Natural),
             4298,
             0.0643,
             {0.0293, 0.0, 0.0726},
             0,
             0}};
}

TEST(CoverageMap, countsOfThePublishedPlacementAreTheKnownOnes) {
    for (const CoverageRow& row : coverageTable()) {
        const CoverageCount count =
            *countCoverage(row.model, Threshold_T, workspaceGrid(degreesToRadians(0.5)));
        EXPECT_EQ(count.poses, 11793960U);
        EXPECT_NEAR(static_cast<double>(count.uncovered), row.uncovered, 3.0) << row.name;
        EXPECT_EQ(count.uncovered, count.uncoveredBy[1]) << row.name; // only Theta fails
        EXPECT_EQ(count.uncoveredBy[0] + count.uncoveredBy[2], 0U) << row.name;
        // Four digits printed, and a grid of 0.5 degrees misses a minimum by up to its slope.
        EXPECT_NEAR(count.least_T[0], row.least_T[0], 1e-3) << row.name;
        EXPECT_NEAR(count.least_T[2], row.least_T[2], 1e-3) << row.name;
        EXPECT_LT(count.least_T[1], 1e-3) << row.name;
        if (row.alpha_deg > 0.0) {
            EXPECT_NEAR(radiansToDegrees(count.high.alpha_rad), row.alpha_deg, 0.5) << row.name;
            EXPECT_NEAR(radiansToDegrees(count.high.beta_rad), row.beta_deg, 0.5) << row.name;
        }
        PoseGrid spin;
        spin.gamma = {-0.5 * Pi, Pi / 180000.0, 180000};
        const CoverageCount upright = *countCoverage(row.model, Threshold_T, spin);
        EXPECT_NEAR(upright.uncovered_ratio(), row.spin_ratio, 5.1e-5) << row.name;
    }
}

TEST(CoverageMap, uncoveredVolumeOfAFinerGridIsThePrintedOne) {
    // Only around the hole, 0.2 degrees: alpha, beta within 9, all spins; the rest is covered.
    const std::array<double, 4> known = {0.0218e-2, 0.0306e-2, 0.0312e-2, 0.0380e-2};
    const double step_rad = degreesToRadians(0.2);
    const AngleRange tilt{-45 * step_rad, step_rad, 91};
    const PoseGrid grid{tilt, tilt, {-0.5 * Pi, step_rad, 900}};
    const double cells = 450.0 * 450.0 * 900.0;
    std::size_t i = 0;
    for (const CoverageRow& row : coverageTable()) {
        const CoverageCount count = *countCoverage(row.model, Threshold_T, grid);
        EXPECT_NEAR(static_cast<double>(count.uncovered) / cells, known[i], 0.02 * known[i]) << row.name;
        ++i;
    }
}

TEST(CoverageProof, publishedClaimFallsAtZeroTilt) {
    for (const bool isAdditive : {true, false}) {
        const CoverageModel model =
            isAdditive ? CoverageModel(AdditiveModel{}) : exactModel(publishedPlacement());
        const CoverageProof proof = *proveCoverage(model, {});
        EXPECT_EQ(proof.component[0].verdict, CoverageVerdict::Proven);
        EXPECT_EQ(proof.component[1].verdict, CoverageVerdict::Refuted);
        EXPECT_EQ(proof.component[2].verdict, CoverageVerdict::Proven);
        EXPECT_FALSE(proof.isProven());
        // gamma = atan(sqrt(1/2))/2 = 17.6322 degrees, or 90 degrees less.
        const OrientationAngles& at = proof.component[1].leastAt;
        const double known_deg = radiansToDegrees(0.5 * std::atan(std::sqrt(0.5)));
        EXPECT_NEAR(known_deg, 17.6322, 5e-5);
        EXPECT_NEAR(radiansToDegrees(at.alpha_rad), 0.0, 1e-6);
        EXPECT_NEAR(radiansToDegrees(at.beta_rad), 0.0, 1e-6);
        const double gamma_deg = radiansToDegrees(at.gamma_rad);
        EXPECT_NEAR(gamma_deg < 0.0 ? gamma_deg + 90.0 : gamma_deg, known_deg, 1e-6);
        EXPECT_LT(proof.component[1].least_T, 1e-9);
    }
}

TEST(CoverageProof, recommendedPlacementsAreProven) {
    CoverageProofConfig config;
    config.gap_T = 1e-4;
    config.cellLimit = 3000000;
    const CoverageProof recommended = *proveCoverage(exactModel(recommendedPlacement()), config);
    EXPECT_TRUE(recommended.isProven());
    // 0.0408 T printed: bounds from both sides.
    EXPECT_GT(recommended.bound_T(), 0.0405);
    double least_T = 1.0;
    for (const ComponentProof& component : recommended.component) {
        least_T = std::min(least_T, component.least_T);
    }
    EXPECT_NEAR(least_T, 0.0408, 1.5e-4);
    EXPECT_TRUE(
        proveCoverage(
            exactModel({PlacementAngles{},
                        PlacementAngles{degreesToRadians(-45), degreesToRadians(25), degreesToRadians(-60)},
                        PlacementAngles{degreesToRadians(-40), degreesToRadians(-25), degreesToRadians(55)}}),
            {})
            ->isProven());
    AdditiveModel additive;
    additive.placement[1] = {degreesToRadians(-45), degreesToRadians(-25), degreesToRadians(-25)};
    additive.placement[2] = {degreesToRadians(-15), degreesToRadians(-45), degreesToRadians(80)};
    const CoverageProof paper = *proveCoverage(CoverageModel(additive), {});
    EXPECT_TRUE(paper.isProven());
}

TEST(CoverageProof, boundOfTheSlopeHolds) {
    Random random(81);
    for (const bool isAdditive : {true, false}) {
        const CoverageModel model =
            isAdditive ? CoverageModel(AdditiveModel{}) : exactModel(publishedPlacement());
        double largest_ratio = 0.0;
        for (int i = 0; i < 20000; ++i) {
            const OrientationAngles at = drawn(random);
            const OrientationJacobian byAngles = model.jacobian(at) * rateMatrix(at);
            for (int k = 0; k < 9; ++k) {
                const double ratio = byAngles.row(k).cwiseAbs().maxCoeff() / model.slopeBound()[k];
                largest_ratio = std::max(largest_ratio, ratio);
            }
        }
        EXPECT_LE(largest_ratio, 1.0);
        EXPECT_GT(largest_ratio, 0.9); // and it is reached
    }
}

TEST(CoverageMap, estimatorWorksInTheHoleAsElsewhere) {
    const SphericalSensing sensing;
    const CoverageModel model = exactModel(publishedPlacement());
    const double hole_rad =
        coverageValue(model, CoverageQuantity::PredictedDeviation_rad, 100e-6, angles_deg(0, 0, 17.63));
    EXPECT_LT(radiansToDegrees(hole_rad), 0.0332);
    OrientationConfig config;
    config.fit.isStrengthFree = false;
    const OrientationEstimator estimator = *OrientationEstimator::make(sensing, config);
    const RotorField field(sensing.field);
    Random random(82);
    for (int i = 0; i < 200; ++i) {
        const OrientationAngles angles = drawn(random);
        const OrientationEstimate estimate =
            estimator.estimate(field.readings_T(rotationOf(angles), sensing.poses));
        EXPECT_NEAR(coverageValue(model, CoverageQuantity::PredictedDeviation_rad, 100e-6, angles),
                    std::sqrt(estimate.covariance_rad2.trace()), 1e-12);
    }
}

TEST(CoverageMap, singularValuesOfTheJacobianStayInTheirRange) {
    const CoverageModel model = exactModel(publishedPlacement());
    const auto values = *coverageMap(model, CoverageQuantity::SmallestSingularValue, 1e-4,
                                     workspaceGrid(degreesToRadians(3)));
    EXPECT_EQ(values.size(), 31U * 31U * 60U);
    // Printed: 0.217 ... 0.930 T/rad; the grid may miss the least one.
    EXPECT_NEAR(*std::min_element(values.begin(), values.end()), 0.217, 2e-3);
}

TEST(CoverageMap, additiveJacobianIsByRotation) {
    const CoverageModel model{AdditiveModel{}};
    const OrientationAngles at = angles_deg(10, 20, 30);
    const double h = 1e-6;
    const OrientationJacobian jacobian = model.jacobian(at);
    for (int k = 0; k < 3; ++k) {
        const Eigen::Matrix3d turned = rotationOfVector(h * Eigen::Vector3d::Unit(k)) * rotationOf(at);
        const SphericalReadings slope = (model.readings_T(anglesOf(turned)) - model.readings_T(at)) / h;
        EXPECT_LT((slope - jacobian.col(k)).norm(), 5e-6); // first-order difference
    }
}

TEST(CoverageMap, canBeStoppedAndTellsItsProgress) {
    std::atomic<int> questions{0};
    WorkControl control;
    control.isStopped = [&] { return ++questions > 3; };
    const CoverageModel model{AdditiveModel{}};
    EXPECT_EQ(countCoverage(model, Threshold_T, workspaceGrid(degreesToRadians(1)), control).error().code,
              ErrorCode::Interrupted);
    CoverageProofConfig endless;
    endless.gap_T = 1e-9;
    endless.threshold_T = 0.0;
    questions = 0;
    EXPECT_EQ(proveCoverage(model, endless, control).error().code, ErrorCode::Interrupted);
    double last = 0.0;
    control = {};
    control.threads = 1;
    control.onProgress = [&](double share) {
        EXPECT_GT(share, last);
        last = share;
    };
    EXPECT_TRUE(countCoverage(model, Threshold_T, workspaceGrid(degreesToRadians(3)), control).has_value());
    EXPECT_EQ(last, 1.0);
    PoseGrid huge = workspaceGrid(degreesToRadians(0.1));
    EXPECT_EQ(countCoverage(model, Threshold_T, huge).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::models
