#include "control/identify/added_inertia.h"
#include "control/identify/joint_estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

// resources/help/htm-theory.md section 2
constexpr double J = 5.5e-4;
constexpr double C = 1.23e-3;
constexpr double Kf = 2.05e-2;
constexpr double Phi = 1.43e-2;

MotorRatios transients(double relative, double freedom = 40.0) {
    using enum MotorConstant;
    MotorRatios data;
    data.ratios = {{Damping, Inertia, C / J}, {Friction, Inertia, Kf / J}, {Torque, Inertia, Phi / J}};
    const Eigen::Vector3d sigma = relative * Eigen::Vector3d(C / J, Kf / J, Phi / J);
    data.errors.push_back({sigma.array().square().matrix().asDiagonal(), freedom});
    return data;
}

MotorRatios steadyOnly(double relative) {
    using enum MotorConstant;
    MotorRatios data;
    data.ratios = {{Damping, Torque, C / Phi}, {Friction, Torque, Kf / Phi}};
    const Eigen::Vector2d sigma = relative * Eigen::Vector2d(C / Phi, Kf / Phi);
    data.errors.push_back({sigma.array().square().matrix().asDiagonal(), 23.0});
    return data;
}

const Estimate& of(const JointEstimate& joint, MotorConstant constant) {
    return joint.constants[static_cast<std::size_t>(constant)];
}

TEST(ResolveConstants, withInertiaGivenTransientsDecideAllOthers) {
    GivenConstants given;
    given.inertia_kg_m2 = J;
    const JointEstimate joint = resolveConstants(transients(0.01), given);
    EXPECT_NEAR(*of(joint, MotorConstant::Damping).value, C, 1e-9 * C);
    EXPECT_NEAR(*of(joint, MotorConstant::Friction).value, Kf, 1e-9 * Kf);
    EXPECT_NEAR(*of(joint, MotorConstant::Torque).value, Phi, 1e-9 * Phi);
    EXPECT_EQ(of(joint, MotorConstant::Inertia).source, EstimateSource::Given);
    // 1 % with 40 degrees of freedom: t = 2.021 (printed table)
    EXPECT_NEAR(of(joint, MotorConstant::Torque).interval95->second, Phi * 1.02021, 1e-5 * Phi);
    EXPECT_FALSE(joint.consistency);
}

TEST(ResolveConstants, withTorqueConstantGivenTransientsDecideTheInertia) {
    GivenConstants given;
    given.torqueConstant_Nm_per_A = Phi;
    const JointEstimate joint = resolveConstants(transients(0.01), given);
    EXPECT_NEAR(*of(joint, MotorConstant::Inertia).value, J, 1e-9 * J);
    EXPECT_NEAR(*of(joint, MotorConstant::Damping).value, C, 1e-9 * C);
    // c = phi (c/J)/(phi/J): two independent errors of 1 %
    const auto interval = *of(joint, MotorConstant::Damping).interval95;
    const double half = 0.5 * (interval.second - interval.first);
    EXPECT_NEAR(half / C, std::sqrt(2.0) * 0.02021, 1e-4);
}

TEST(ResolveConstants, withoutGivenConstantsOnlyRatiosComeOut) {
    const JointEstimate joint = resolveConstants(transients(0.01), {});
    for (const Estimate& constant : joint.constants) {
        EXPECT_EQ(constant.source, EstimateSource::NotIdentifiable);
        EXPECT_FALSE(constant.value);
        EXPECT_FALSE(constant.interval95);
    }
    EXPECT_NEAR(*joint.ratios.at("c_over_J").value, C / J, 1e-9);
    EXPECT_NEAR(*joint.ratios.at("Kf_over_phi").value, Kf / Phi, 1e-9);
    EXPECT_EQ(joint.covarianceNames.size(), 3u);
}

TEST(ResolveConstants, steadySpeedsNeverShowTheInertia) {
    GivenConstants phi;
    phi.torqueConstant_Nm_per_A = Phi;
    const JointEstimate withPhi = resolveConstants(steadyOnly(0.02), phi);
    EXPECT_NEAR(*of(withPhi, MotorConstant::Damping).value, C, 1e-9 * C);
    EXPECT_FALSE(of(withPhi, MotorConstant::Inertia).value);
    EXPECT_FALSE(withPhi.ratios.at("c_over_J").value);
    GivenConstants inertia;
    inertia.inertia_kg_m2 = J;
    const JointEstimate withJ = resolveConstants(steadyOnly(0.02), inertia);
    EXPECT_FALSE(of(withJ, MotorConstant::Damping).value);
    EXPECT_FALSE(of(withJ, MotorConstant::Torque).value);
    EXPECT_TRUE(withJ.ratios.at("c_over_phi").value);
}

TEST(ResolveConstants, testsWhetherInertiaAndTorqueConstantFitTogether) {
    GivenConstants given;
    given.inertia_kg_m2 = J;
    given.torqueConstant_Nm_per_A = Phi;
    const JointEstimate good = resolveConstants(transients(0.01), given);
    ASSERT_TRUE(good.consistency);
    EXPECT_EQ(good.consistency->freedom, 1);
    EXPECT_GT(good.consistency->probability, 0.99);
    given.torqueConstant_Nm_per_A = Phi * 1.05;
    const JointEstimate bad = resolveConstants(transients(0.01), given);
    ASSERT_TRUE(bad.consistency);
    // five standard errors with 40 degrees of freedom
    EXPECT_LT(bad.consistency->probability, 1e-4);
}

TEST(ResolveConstants, noFrictionGivesTheOthersNoScale) {
    for (const auto& none : {&GivenConstants::coulombFriction_Nm, &GivenConstants::viscousDamping_Nm_s}) {
        GivenConstants given;
        given.*none = 0.0;
        const JointEstimate joint = resolveConstants(transients(0.01), given);
        for (const Estimate& constant : joint.constants) {
            EXPECT_NE(constant.source, EstimateSource::Identified);
        }
        // the ratio is 100 standard errors from zero
        ASSERT_TRUE(joint.consistency);
        EXPECT_LT(joint.consistency->probability, 1e-12);
    }
}

TEST(ResolveConstants, noFrictionGivenFitsAMotorThatShowsNone) {
    MotorRatios data = transients(0.01);
    data.ratios[1].value = -0.5 * 0.01 * Kf / J; // half a standard error below zero
    GivenConstants given;
    given.coulombFriction_Nm = 0.0;
    const JointEstimate joint = resolveConstants(data, given);
    ASSERT_TRUE(joint.consistency);
    // |t| > 0.5 with 40 degrees of freedom: 0.6198 (printed table)
    EXPECT_NEAR(joint.consistency->probability, 0.6198, 1e-3);
    given.inertia_kg_m2 = J;
    const JointEstimate scaled = resolveConstants(data, given);
    EXPECT_NEAR(*of(scaled, MotorConstant::Damping).value, C, 1e-9 * C);
}

TEST(ResolveConstants, refusesAnInertiaFromAFrictionThatIsHardlyThere) {
    MotorRatios data = transients(0.01);
    data.ratios[1].value = 0.001;
    data.errors[0].covariance(1, 1) = 0.01;
    GivenConstants given;
    given.coulombFriction_Nm = 1e-3;
    EXPECT_FALSE(of(resolveConstants(data, given), MotorConstant::Inertia).value);
}

TEST(ResolveConstants, anErrorFromADataSheetUsesTheNormalDistribution) {
    MotorRatios data = transients(0.0);
    Eigen::Matrix3d supply = Eigen::Matrix3d::Zero();
    supply(2, 2) = std::pow(0.002 * Phi / J, 2);
    data.errors.push_back({supply, std::numeric_limits<double>::infinity()});
    GivenConstants given;
    given.inertia_kg_m2 = J;
    const auto interval = *of(resolveConstants(data, given), MotorConstant::Torque).interval95;
    EXPECT_NEAR((interval.second / Phi - 1.0) / 0.002, 1.95996, 1e-3);
}

MountingRatios mounting(double inertia, double relative) {
    MountingRatios ratios;
    ratios.values = Eigen::Vector3d(C, Kf, Phi) / inertia;
    ratios.covariance = (relative * relative * ratios.values.array().square()).matrix().asDiagonal();
    return ratios;
}

TEST(AddedInertia, returnsAllFourConstants) {
    const auto estimate = inertiaFromAdded(mounting(J, 1e-3), mounting(J + 3e-4, 1e-3), 3e-4);
    ASSERT_TRUE(estimate);
    EXPECT_NEAR(estimate->values(0), J, 1e-9 * J);
    EXPECT_NEAR(estimate->values(1), C, 1e-9 * C);
    EXPECT_NEAR(estimate->values(3), Phi, 1e-9 * Phi);
    EXPECT_TRUE(estimate->usesDamping);
    // J = added r2/(r1 - r2): relative error (J + added)/added sqrt(2) 1e-3 from one ratio, two ratios
    // averaged
    const double one = (J + 3e-4) / 3e-4 * std::sqrt(2.0) * 1e-3;
    EXPECT_NEAR(std::sqrt(estimate->covariance(0, 0)) / J, one / std::sqrt(2.0), 0.02 * one);
}

TEST(AddedInertia, leavesTheDampingOutWhenTheMountingChangedIt) {
    MountingRatios loaded = mounting(J + 3e-4, 1e-3);
    loaded.values(0) *= 1.05;
    const auto estimate = inertiaFromAdded(mounting(J, 1e-3), loaded, 3e-4);
    ASSERT_TRUE(estimate);
    EXPECT_FALSE(estimate->usesDamping);
    EXPECT_NEAR(estimate->values(0), J, 1e-9 * J);
}

TEST(AddedInertia, refusesWhatDoesNotShow) {
    EXPECT_FALSE(inertiaFromAdded(mounting(J, 1e-2), mounting(J + 1e-6, 1e-2), 1e-6));
    EXPECT_FALSE(inertiaFromAdded(mounting(J, 1e-3), mounting(J, 1e-3), 1e-4));
    const auto zero = inertiaFromAdded(mounting(J, 1e-3), mounting(J, 1e-3), 0.0);
    ASSERT_FALSE(zero);
    EXPECT_EQ(zero.error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
