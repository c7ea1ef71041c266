#include "control/base/units.h"
#include "models/fields/ring_harmonics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::models {
namespace {

constexpr double SensorRadius_m = 14.5e-3;

double rms(const std::vector<double>& values) {
    double squares = 0.0;
    for (const double value : values) {
        squares += value * value;
    }
    return std::sqrt(squares / static_cast<double>(values.size()));
}

double peak(const std::vector<double>& values) {
    double largest = 0.0;
    for (const double value : values) {
        largest = std::fmax(largest, std::abs(value));
    }
    return largest;
}

TEST(RingHarmonics, findsKnownAmplitudes) {
    std::vector<double> samples;
    for (int i = 0; i < 64; ++i) {
        const double theta = 2.0 * Pi * i / 64;
        samples.push_back(0.5 + 2.0 * std::cos(theta) - 0.3 * std::sin(5.0 * theta));
    }
    const RingHarmonics harmonics = harmonicsOf(samples, 7);
    EXPECT_NEAR(harmonics.mean_T, 0.5, 1e-14);
    EXPECT_NEAR(std::abs(harmonics.amplitude_T[0] - 2.0), 0.0, 1e-14);
    EXPECT_NEAR(std::abs(harmonics.amplitude_T[4] - std::complex<double>(0.0, -0.3)), 0.0, 1e-14);
    EXPECT_NEAR(harmonics.magnitude_T(3), 0.0, 1e-14);
}

TEST(RingHarmonics, sensorSeesAnAlmostPureSine) {
    const auto turn_T = radialFieldPerTurn_T(HalbachRing{}, SensorRadius_m, 0.0, 128);
    const RingHarmonics harmonics = harmonicsOf(turn_T, 24);
    const double fundamental_T = harmonics.magnitude_T(1);
    EXPECT_NEAR(harmonics.magnitude_T(5) / fundamental_T, 5.6e-4, 1e-5);
    // Symmetry leaves orders 5, 9, 13 ..., 21 and a 3rd below 1e-5 from the ends.
    for (int order = 2; order <= 24; ++order) {
        if (order != 5) {
            EXPECT_LT(harmonics.magnitude_T(order) / fundamental_T, 1e-5) << order;
        }
    }
    // Orders 4k + 1 give a 4-per-turn angle error of 5.6e-4 rad = 0.032 degrees.
    EXPECT_NEAR(radiansToDegrees(peak(arctangentErrors_rad(turn_T))), 0.032, 5e-4);
}

TEST(RingHarmonics, growTowardTheCoilsAsQuoted) {
    const double centre_T = magnetsField_T(ringMagnets(HalbachRing{}, 0.0), Eigen::Vector3d::Zero()).x();
    struct Row {
        double radius_mm, first, fifth, twentyFirst;
    };
    for (const Row& row :
         {Row{18.0, 1.267, 1.6e-3, 1e-4}, Row{20.0, 1.330, 2.4e-3, 9e-4}, Row{22.5, 1.415, 3.9e-3, 9.5e-3}}) {
        const auto turn_T = radialFieldPerTurn_T(HalbachRing{}, 1e-3 * row.radius_mm, 0.0, 128);
        const RingHarmonics harmonics = harmonicsOf(turn_T, 24);
        // Half of the last printed digit; 1.415 and its neighbours are quoted to 1e-3.
        EXPECT_NEAR(harmonics.magnitude_T(1) / centre_T, row.first, 1e-3);
        EXPECT_NEAR(harmonics.magnitude_T(5) / centre_T, row.fifth, 0.5e-4);
        EXPECT_NEAR(harmonics.magnitude_T(21) / centre_T, row.twentyFirst, 0.5e-4);
    }
}

TEST(RingHarmonics, scatterOfManufactureMakesTheQuotedAngleError) {
    const int rings = 300;
    const Random root(20);
    std::vector<double> rms_deg;
    std::vector<double> peak_deg;
    std::array<double, 6> orderSquares_deg2{};
    for (int i = 0; i < rings; ++i) {
        Random random = root.fork(static_cast<std::uint64_t>(i));
        const HalbachRing ring = scatteredRing(HalbachRing{}, RingScatter{}, random);
        const auto error_rad = arctangentErrors_rad(radialFieldPerTurn_T(ring, SensorRadius_m, 0.0, 48));
        rms_deg.push_back(radiansToDegrees(rms(error_rad)));
        peak_deg.push_back(radiansToDegrees(peak(error_rad)));
        const RingHarmonics spectrum = harmonicsOf(error_rad, 6);
        for (std::size_t k = 0; k < orderSquares_deg2.size(); ++k) {
            orderSquares_deg2[k] += std::norm(radiansToDegrees(1.0) * spectrum.amplitude_T[k]) / rings;
        }
    }
    std::sort(rms_deg.begin(), rms_deg.end());
    std::sort(peak_deg.begin(), peak_deg.end());
    const auto quantile = [rings](const std::vector<double>& sorted, double share) {
        return sorted[static_cast<std::size_t>(share * (rings - 1))];
    };
    // 300 rings: a median is known to about 3 %, a 95 % quantile to about 5 %, an rms amplitude to about 4 %;
    // the quoted figures are rounded to 2 digits. Tolerances are about three of these.
    EXPECT_NEAR(rms(rms_deg), 0.28, 0.03);
    EXPECT_NEAR(quantile(rms_deg, 0.95), 0.44, 0.06);
    EXPECT_NEAR(quantile(peak_deg, 0.50), 0.60, 0.06);
    EXPECT_NEAR(quantile(peak_deg, 0.95), 1.0, 0.12);
    EXPECT_NEAR(std::sqrt(orderSquares_deg2[0]), 0.24, 0.03);
    EXPECT_NEAR(std::sqrt(orderSquares_deg2[2]), 0.25, 0.03);
    EXPECT_NEAR(std::sqrt(orderSquares_deg2[3]), 0.22, 0.03);
    EXPECT_NEAR(std::sqrt(orderSquares_deg2[4]), 0.09, 0.015);
}

} // namespace
} // namespace halbench::models
