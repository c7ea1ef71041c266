#include "app/actuators/spherical/rotation_order.h"
#include "models/spherical/orientation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <string>

namespace halbench::app {
namespace {

/// Turns about fixed axes in the order in which the words name them.
Eigen::Matrix3d turnedAsSaid(const std::string& words, double alpha_rad, double beta_rad, double gamma_rad) {
    const std::map<std::string, double> angles = {
        {"alpha", alpha_rad}, {"beta", beta_rad}, {"gamma", gamma_rad}};
    std::map<std::size_t, Eigen::AngleAxisd> turns; // by their place in the words
    for (const auto& [name, angle] : angles) {
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t at = words.find(name + " about " + static_cast<char>('X' + axis));
            if (at != std::string::npos) {
                turns.emplace(at, Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)));
            }
        }
    }
    EXPECT_EQ(turns.size(), 3U) << words;
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    for (const auto& [at, turn] : turns) {
        rotation = turn * rotation;
    }
    return rotation;
}

constexpr double Alpha_rad = 0.3;
constexpr double Beta_rad = -0.5;
constexpr double Gamma_rad = 0.9;

TEST(RotationOrderTest, wordsOfAnOrientationAreItsMatrix) {
    const Eigen::Matrix3d said = turnedAsSaid(orientationOrder(), Alpha_rad, Beta_rad, Gamma_rad);
    EXPECT_LT((said - models::rotationOf({Alpha_rad, Beta_rad, Gamma_rad})).norm(), 1e-14);
}

TEST(RotationOrderTest, wordsOfAPlacementAreItsMatrix) {
    using models::SensorFrames;
    for (const SensorFrames frames : {SensorFrames::Zyx, SensorFrames::Xyz}) {
        const Eigen::Matrix3d said = turnedAsSaid(placementOrder(frames), Alpha_rad, Beta_rad, Gamma_rad);
        EXPECT_LT((said - models::placementRotation({Alpha_rad, Beta_rad, Gamma_rad}, frames)).norm(), 1e-14);
    }
    // Without the roll only the place is the same.
    const Eigen::Matrix3d natural =
        models::placementRotation({Alpha_rad, Beta_rad, Gamma_rad}, SensorFrames::Natural);
    const Eigen::Matrix3d said =
        turnedAsSaid(placementOrder(SensorFrames::Natural), Alpha_rad, Beta_rad, Gamma_rad);
    EXPECT_LT((said.col(0) - natural.col(0)).norm(), 1e-14);
    EXPECT_NEAR(natural(2, 1), 0.0, 1e-14); // e_Phi stays parallel to the plane of X and Y
    EXPECT_NE(placementOrder(SensorFrames::Natural).find("without the roll"), std::string::npos);
}

} // namespace
} // namespace halbench::app
