#include "app/actuators/planar/platen_equations.h"
#include "app/actuators/planar/platen_estimate.h"
#include "control/base/random.h"
#include "models/planar/platen_body.h"
#include "models/planar/wrench_map.h"
#include "tests/app/actuators/planar/simulated_platen.h"

#include <Eigen/LU>
#include <cmath>

namespace halbench::app {
namespace {

/// A platen under known currents, integrated finely, without any sensor: the second route to the unknowns.
struct FreePlaten {
    models::PlatenConfig body;
    models::PlanarGeometry geometry;
    double gain = 1.0; ///< of all coils

    PlatenMotion run(std::size_t rows, double slowForce_N, std::vector<models::PlanarPose>& poses) const {
        constexpr int SubSteps = 4;
        const models::WrenchMap map(models::WrenchModel::Windings, geometry);
        Random noise(7);
        models::PlatenState state{};
        Eigen::Vector2d slow_N = Eigen::Vector2d::Zero();
        PlatenMotion motion;
        auto layout = std::make_shared<StreamLayout>();
        layout->period_s = 1e-3;
        motion.recording.layout = layout;
        for (std::size_t n = 0; n < rows; ++n) {
            const double t = 1e-3 * static_cast<double>(n);
            // A loop of its own keeps it in reach: accelerations of a sum of sines and a slow wander.
            const Eigen::Vector3d wanted(30e-3 * std::sin(1.1 * t) + 0.5e-3 * std::sin(31.0 * t),
                                         28e-3 * std::sin(0.83 * t + 1.0) + 0.5e-3 * std::sin(37.0 * t),
                                         4e-3 * std::sin(5.3 * t) + 1e-3 * std::sin(23.0 * t));
            const Eigen::Vector3d off =
                wanted - Eigen::Vector3d(state.pose.x_m, state.pose.y_m, state.pose.angle_rad);
            const Eigen::Vector3d speed(state.velocity.x_m_s, state.velocity.y_m_s,
                                        state.velocity.angle_rad_s);
            Eigen::Vector3d demand = 1600.0 * off - 40.0 * speed;
            demand.head<2>() *= body.mass_kg;
            demand.z() *= body.inertia_kg_m2;
            const Eigen::Matrix<double, 3, models::CoilCount> k = map.at(state.pose).wrench;
            const models::CoilCurrents_A current_A = k.transpose() * (k * k.transpose()).inverse() * demand;
            poses.push_back(state.pose);
            motion.recording.time_s.push_back(t);
            motion.current_A.push_back(current_A);
            for (int i = 0; i < SubSteps; ++i) {
                slow_N = 0.992 * slow_N + slowForce_N * std::sqrt(1.0 - 0.992 * 0.992) *
                                              Eigen::Vector2d(noise.gaussian(), noise.gaussian());
                const Eigen::Vector3d wrench = gain * (map.at(state.pose).wrench * current_A);
                models::stepPlaten(body, state, models::wrenchOf(wrench), slow_N, 1e-3 / SubSteps);
            }
        }
        return motion;
    }
};

FreePlaten publishedPlaten() {
    FreePlaten platen;
    platen.body = models::drawSpecimen(models::PlanarParameters{}, 1).platen;
    return platen;
}

TEST(PlatenEquations, areThoseOfABodyThatIsIntegratedStepByStep) {
    FreePlaten platen = publishedPlaten();
    std::vector<models::PlanarPose> poses;
    const PlatenMotion motion = platen.run(30000, 0.0, poses);
    const auto fit = fitPlaten(motion, poses, platen.geometry);
    ASSERT_TRUE(fit) << fit.error().message;
    const PlatenVector& p = fit->value;
    const double m = platen.body.mass_kg;
    // Without noise what remains are products of rotation and place that the equations leave out: forces of
    // 1e-5 N (half the square of 5 mrad times 0.5 N) beside a damping of 2e-3 N, and moments of the cable of
    // 4e-6 N m (k y times the 20 mm of its anchor times 4 mrad), half of them in step with nothing.
    EXPECT_NEAR(p(platen::DampingX) * m, platen.body.damping_Ns_per_m, 1e-2 * platen.body.damping_Ns_per_m);
    EXPECT_NEAR(p(platen::DampingY) * m, platen.body.damping_Ns_per_m, 1e-2 * platen.body.damping_Ns_per_m);
    EXPECT_NEAR(p(platen::StiffnessX) * m, platen.body.cableStiffness_N_per_m, 5e-3);
    EXPECT_NEAR(p(platen::Inertia) * m / platen.body.inertia_kg_m2, 1.0, 1e-3);
    EXPECT_NEAR(p(platen::CentreX), platen.body.massCentre_m.x(), 5e-6);
    EXPECT_NEAR(p(platen::CentreY), platen.body.massCentre_m.y(), 5e-6);
    EXPECT_NEAR(p(platen::DampingPhi) * m, platen.body.damping_Nms_per_rad, 3e-5);
    EXPECT_NEAR(p(platen::Delay), 0.0, 5e-6); // currents follow at once here
    for (int k = 0; k < models::CoilCount; ++k) {
        EXPECT_NEAR(p(k) * m, 1.0, 1e-3) << "coil " << k + 1;
    }
}

TEST(PlatenEquations, leaveOutWindowsWithMissingRowsAndRefuseWhenFewRemain) {
    const FreePlaten platen = publishedPlaten();
    std::vector<models::PlanarPose> poses;
    PlatenMotion motion = platen.run(16000, 0.0, poses);
    for (std::size_t n = 8000; n < motion.recording.time_s.size(); ++n) {
        motion.recording.time_s[n] += 5e-3; // five rows are missing there
    }
    const auto fit = fitPlaten(motion, poses, platen.geometry);
    ASSERT_TRUE(fit) << fit.error().message;
    EXPECT_EQ(fit->leftOut, 1);
    for (std::size_t n = 0; n < motion.recording.time_s.size(); ++n) {
        motion.recording.time_s[n] += 1e-3 * std::floor(static_cast<double>(n) / 300.0);
    }
    const auto refused = fitPlaten(motion, poses, platen.geometry);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Refused);
}

TEST(PlatenEquations, refuseAPlatenThatIsHeld) {
    const FreePlaten platen = publishedPlaten();
    std::vector<models::PlanarPose> poses;
    PlatenMotion motion = platen.run(16000, 0.0, poses);
    for (models::PlanarPose& pose : poses) {
        pose = {6.35e-3, -6.35e-3, 0.0};
    }
    const auto fit = fitPlaten(motion, poses, platen.geometry);
    EXPECT_FALSE(fit);
}

TEST(PlatenEstimate, countsTheEffortAsTheBoardDoes) {
    PlatenFit fit;
    fit.freedom = 60.0;
    fit.value.segment<6>(platen::Gain1).setConstant(1.0 / 0.64);
    fit.value(platen::Inertia) = 1e-3 / 0.64;
    fit.value(platen::DampingX) = 0.1 / 0.64;
    fit.covariance.diagonal() = (1e-3 * fit.value).cwiseAbs2() + PlatenVector::Constant(1e-20);
    PlatenBoard board;
    board.forceConstant_N_per_A = -3.09772;
    board.mass_kg = 0.64;
    board.inertia_kg_m2 = 1e-3;
    devices::AxisSpec x;
    x.id = "x";
    x.positionUnit = "m";
    x.effortUnit = "N";
    const AxesIdentifyResult result = platenEstimate(fit, board, {0.64, {}}, {x}, {1e-3, 1});
    ASSERT_EQ(result.model.axes.size(), 1U);
    // 1.1373/m: the board's newton is 13.7 % more (resources/help/planar-theory.md 5.3).
    EXPECT_NEAR(*result.model.axes[0].accelerationGain.value, 1.1373 / 0.64, 1e-4);
    EXPECT_NEAR(*result.model.axes[0].dampingRate.value, 0.1 / 0.64, 1e-12);
    const control::Estimate* set = estimateIn(result.constants, "force_constant_56");
    ASSERT_NE(set, nullptr);
    EXPECT_NEAR(*set->value, 3.52301, 1e-5);
    // Two independent gains of 0.1 % each: 0.07 % of their mean, times Student's 2.000 of 60 degrees.
    EXPECT_NEAR(set->interval95->second - *set->value, 2.000 * 1e-3 / std::sqrt(2.0) * 3.52301, 5e-6);
    EXPECT_EQ(estimateIn(result.constants, "mass")->source, control::EstimateSource::Given);
    EXPECT_TRUE(checkAxisModel(result.model));
    ASSERT_EQ(result.model.covarianceNames.size(), 3U);
    EXPECT_NEAR(result.model.covariance[0][0], std::pow(1e-3 * 0.1 / 0.64, 2), 1e-12);
}

} // namespace
} // namespace halbench::app
