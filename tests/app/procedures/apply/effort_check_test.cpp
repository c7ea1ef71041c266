#include "app/procedures/apply/effort_check.h"
#include "control/base/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {
namespace {

constexpr double Gain = 1000.0; ///< of the model, rad/s^2 per N m
constexpr double Step_rad = 5e-3;
constexpr double Until_s = 0.7;

/// A PD loop of 15 rad/s with a plant whose gain is `gain_ratio` times that of the model: semi-implicit Euler
/// in tenths of a millisecond, a row each millisecond. The law sees the readings and their noise.
Recording stepOf(double gain_ratio, double noise_rad, std::uint64_t seed) {
    constexpr double Omega_rad_s = 15.0;
    constexpr double Substeps = 10.0;
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"position", "rad"}, {"effort", "N*m"}};
    layout->period_s = 1e-3;
    Recording move;
    move.layout = layout;
    Random random(seed);
    double position = 0.0;
    double speed = 0.0;
    for (int row = 0; row < 1000; ++row) {
        const double read = position + noise_rad * random.gaussian();
        const double effort =
            (Omega_rad_s * Omega_rad_s * (Step_rad - read) - 2.0 * Omega_rad_s * speed) / Gain;
        // The effort of a row is the one that acted until then.
        for (int i = 0; i < static_cast<int>(Substeps); ++i) {
            speed += gain_ratio * Gain * effort * 1e-3 / Substeps;
            position += speed * 1e-3 / Substeps;
        }
        move.time_s.push_back(1e-3 * row);
        move.values.insert(move.values.end(), {position + noise_rad * random.gaussian(), effort});
    }
    return move;
}

std::optional<EffortAgreement> agreementOf(const Recording& move, double gainDeviation_ratio = 0.002) {
    return effortAgreement(move, {"position", "effort"}, {0.0, Gain, 0.0}, gainDeviation_ratio, Until_s);
}

// Half the mass is twice the gain: the same motion takes half the effort. 1 %: rows of a millisecond.
TEST(EffortCheck, isTheRatioOfTheGains) {
    for (const double gain_ratio : {0.5, 0.8, 1.0, 1.25, 2.0}) {
        const auto agreement = agreementOf(stepOf(gain_ratio, 0.0, 1));
        ASSERT_TRUE(agreement);
        EXPECT_NEAR(agreement->ratio * gain_ratio, 1.0, 0.01) << gain_ratio;
    }
}

// The noise at rest of a platen's angle is 77 urad (resources/help/planar-theory.md section 11), three times
// that where two chips stand at the top of their field.
TEST(EffortCheck, noiseRefusesNoRightModel) {
    for (const double noise_rad : {77e-6, 230e-6}) {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            const auto agreement = agreementOf(stepOf(1.0, noise_rad, seed));
            ASSERT_TRUE(agreement);
            EXPECT_TRUE(agreement->isWithin()) << noise_rad << " " << seed << ": " << agreement->ratio;
        }
    }
}

TEST(EffortCheck, noiseExcusesNoHalfOrDoubleMass) {
    for (const double gain_ratio : {0.5, 2.0}) {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            const auto agreement = agreementOf(stepOf(gain_ratio, 77e-6, seed));
            ASSERT_TRUE(agreement);
            EXPECT_FALSE(agreement->isWithin()) << gain_ratio << " " << seed << ": " << agreement->ratio;
        }
    }
}

TEST(EffortCheck, allowsMoreWhereTheModelOrTheFitKnowsLess) {
    const auto known = agreementOf(stepOf(1.0, 0.0, 1), 0.0);
    const auto vague = agreementOf(stepOf(1.0, 0.0, 1), 0.05);
    const auto noisy = agreementOf(stepOf(1.0, 230e-6, 1), 0.0);
    ASSERT_TRUE(known && vague && noisy);
    EXPECT_NEAR(known->high, 1.25, 1e-3);
    EXPECT_NEAR(vague->high, 1.25 + 2.0 * 0.05, 1e-3);
    EXPECT_GT(noisy->high, known->high);
    EXPECT_NEAR(known->low * known->high, 1.0, 1e-12);
    // A model that knows nothing still does not excuse half the mass.
    EXPECT_NEAR(agreementOf(stepOf(1.0, 0.0, 1), 5.0)->high, 1.5, 1e-12);
}

TEST(EffortCheck, saysNothingOfTooFewRows) {
    Recording move = stepOf(1.0, 0.0, 1);
    EXPECT_FALSE(effortAgreement(move, {"position", "effort"}, {0.0, Gain, 0.0}, 0.0, 0.018));
    EXPECT_FALSE(effortAgreement(move, {"position", "no such column"}, {0.0, Gain, 0.0}, 0.0, Until_s));
}

} // namespace
} // namespace halbench::app
