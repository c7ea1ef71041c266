#include "app/analyses/spherical/angle_error.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace halbench::app {
namespace {

/// Estimates turned by `errors_deg` about X against the true orientation, whose spin is `gamma_deg`; the cone
/// is 0.02 rad.
Recording turnedRows(const std::vector<double>& errors_deg, double gamma_deg) {
    Recording rows;
    auto layout = std::make_shared<StreamLayout>();
    for (const std::string& role : angleErrorRoles()) {
        layout->columns.push_back({role, ""});
    }
    rows.layout = layout;
    for (std::size_t i = 0; i < errors_deg.size(); ++i) {
        const double half_rad = 0.5 * degreesToRadians(errors_deg[i]);
        rows.time_s.push_back(0.1 * static_cast<double>(i));
        rows.values.insert(rows.values.end(), {std::cos(half_rad), std::sin(half_rad), 0.0, 0.0, 0.0, 0.0,
                                               degreesToRadians(gamma_deg), 0.02});
    }
    return rows;
}

TEST(AngleErrorTest, isTheAngleOfTheRotationBetweenEstimateAndTruth) {
    const AngleErrors errors = angleErrors(turnedRows({1.0, 2.0, 2.0}, 0.0), 100);
    ASSERT_EQ(errors.time_s.size(), 3U);
    EXPECT_NEAR(radiansToDegrees(errors.rotation_rad[0]), 1.0, 1e-9);
    EXPECT_NEAR(radiansToDegrees(errors.shaft_rad[1]), 2.0, 1e-9); // a turn about X tilts the shaft as far
    EXPECT_EQ(errors.cone_rad[2], 0.02);
    EXPECT_EQ(errors.rows, 3U);
    EXPECT_NEAR(radiansToDegrees(errors.rms_rad), std::sqrt(3.0), 1e-9); // (1 + 4 + 4) / 3
    EXPECT_NEAR(radiansToDegrees(errors.worst_rad), 2.0, 1e-9);
}

// Half a turn about the shaft has the same field: no error.
TEST(AngleErrorTest, isMeasuredModuloTheSymmetryOfTheRotor) {
    const AngleErrors errors = angleErrors(turnedRows({1.0}, 180.0), 100);
    EXPECT_NEAR(radiansToDegrees(errors.rotation_rad[0]), 1.0, 1e-9);
    EXPECT_NEAR(radiansToDegrees(errors.shaft_rad[0]), 1.0, 1e-9);
}

// A spin error leaves the shaft where it is.
TEST(AngleErrorTest, spinIsNoErrorOfTheShaft) {
    const AngleErrors errors = angleErrors(turnedRows({0.0}, 3.0), 100);
    EXPECT_NEAR(radiansToDegrees(errors.rotation_rad[0]), 3.0, 1e-9);
    EXPECT_NEAR(errors.shaft_rad[0], 0.0, 1e-12);
}

TEST(AngleErrorTest, aPointIsTheLargestErrorOfItsPart) {
    std::vector<double> errors_deg(1000, 0.1);
    errors_deg[317] = 5.0;
    const AngleErrors errors = angleErrors(turnedRows(errors_deg, 0.0), 100);
    ASSERT_EQ(errors.time_s.size(), 100U);
    EXPECT_NEAR(radiansToDegrees(errors.rotation_rad[31]), 5.0, 1e-9);
    EXPECT_NEAR(errors.time_s[31], 31.7, 1e-9);
    EXPECT_TRUE(angleErrors(turnedRows({}, 0.0), 100).time_s.empty());
}

} // namespace
} // namespace halbench::app
