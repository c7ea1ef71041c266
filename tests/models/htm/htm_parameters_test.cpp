#include "models/htm/htm_parameters.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

namespace halbench::models {
namespace {

TEST(HtmParameters, hasEveryKeyOfTheCommandLine) {
    // resources/help/command-line.md, device addresses
    for (const char* key :
         {"J", "c", "Kf", "phi", "Imax", "B0", "R_a", "L_a", "psi0", "friction_scatter", "Ks_over_Kf",
          "hall_noise_mT", "hall_offset_mT", "hall_gain_error", "quadrature_deg", "magnet_scatter",
          "stray_mT_per_A", "ambient_C", "delay_samples"}) {
        EXPECT_NE(findHtmParameter(key), nullptr) << key;
    }
}

TEST(HtmParameters, holdsTheNumbersOfThePublication) {
    const HtmParameters p;
    const std::pair<const char*, double> expected[] = {{"J", 5.5e-4},
                                                       {"c", 1.23e-3},
                                                       {"Kf", 2.05e-2},
                                                       {"phi", 1.43e-2},
                                                       {"Imax", 4.0},
                                                       {"B0", 0.157},
                                                       {"R_a", 1.5},
                                                       {"L_a", 152e-6},
                                                       {"S25", 12.5},
                                                       {"S_TC", 0.0012},
                                                       {"V_Q", 2.5},
                                                       {"stray_mT_per_A", 2.5},
                                                       {"Ks_over_Kf", 1.15},
                                                       {"friction_scatter", 0.033},
                                                       {"hall_noise_mT", 0.0184},
                                                       {"magnet_scatter", 0.02},
                                                       {"coil_heat_capacity", 32.0},
                                                       {"coil_thermal_resistance", 15.0},
                                                       {"copper_TC", 0.00393},
                                                       {"magnet_TC", -0.0012},
                                                       {"ambient_C", 25.0},
                                                       {"psi0", 0.0}};
    for (const auto& [key, value] : expected) {
        ASSERT_TRUE(htmParameter(p, key).has_value()) << key;
        EXPECT_NEAR(*htmParameter(p, key), value, 1e-12 * std::fmax(1.0, value)) << key;
    }
}

TEST(HtmParameters, everyKeyIsUniqueAndEveryDefaultIsAllowed) {
    std::set<std::string_view> keys;
    for (const HtmParameterSpec& spec : htmParameterSpecs()) {
        EXPECT_TRUE(keys.insert(spec.key).second) << spec.key;
        EXPECT_NE(spec.value == nullptr, spec.specimen == nullptr) << spec.key;
        HtmParameters p;
        if (const auto value = htmParameter(p, spec.key)) {
            EXPECT_TRUE(setHtmParameter(p, spec.key, *value)) << spec.key;
        }
    }
}

TEST(HtmParameters, setsEachValueAloneAndReadsItBack) {
    for (const HtmParameterSpec& spec : htmParameterSpecs()) {
        HtmParameters p;
        ASSERT_TRUE(setHtmParameter(p, spec.key, spec.max)) << spec.key;
        EXPECT_NEAR(*htmParameter(p, spec.key), spec.max, 1e-12 * std::fabs(spec.max)) << spec.key;
        for (const HtmParameterSpec& other : htmParameterSpecs()) {
            if (other.key != spec.key) {
                EXPECT_EQ(htmParameter(p, other.key), htmParameter(HtmParameters{}, other.key)) << other.key;
            }
        }
    }
}

TEST(HtmParameters, refusesUnknownKeysAndListsTheKnownOnes) {
    HtmParameters p;
    const auto result = setHtmParameter(p, "kf", 1.0);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::UnknownName);
    EXPECT_NE(result.error().hint.find("Ks_over_Kf"), std::string::npos);
}

TEST(HtmParameters, refusesWhatIsOutOfRangeOrNotFinite) {
    HtmParameters p;
    for (const HtmParameterSpec& spec : htmParameterSpecs()) {
        const double step = 1e-3 * std::fmax(1.0, std::fabs(spec.max));
        EXPECT_EQ(setHtmParameter(p, spec.key, spec.max + step).error().code, ErrorCode::OutOfRange);
        EXPECT_EQ(setHtmParameter(p, spec.key, spec.min - step).error().code, ErrorCode::OutOfRange);
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL}) {
            EXPECT_EQ(setHtmParameter(p, spec.key, bad).error().code, ErrorCode::NotFinite);
        }
    }
    EXPECT_EQ(setHtmParameter(p, "delay_samples", 0.5).error().code, ErrorCode::OutOfRange);
    EXPECT_TRUE(setHtmParameter(p, "Kf", 0.0));
    EXPECT_TRUE(setHtmParameter(p, "c", 0.0));
}

TEST(HtmParameters, everyKeyAndItsDefaultStandInTheHelp) {
    std::ifstream file(HALBENCH_SOURCE_DIR "/resources/help/command-line.md");
    const std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    for (const HtmParameterSpec& spec : htmParameterSpecs()) {
        const auto value = htmParameter(HtmParameters{}, spec.key);
        const std::string row =
            fmt::format("| `{}` | {} |", spec.key, value ? fmt::format("{:g}", *value) : "drawn");
        EXPECT_NE(page.find(row), std::string::npos) << row;
    }
}

TEST(HtmParameters, withoutImperfectionsNothingIsDrawn) {
    const HtmParameters off = withoutImperfections(HtmParameters{});
    for (const char* key :
         {"stray_mT_per_A", "friction_scatter", "friction_per_turn", "hall_noise_mT", "hall_offset_mT",
          "hall_gain_error", "quadrature_deg", "magnet_scatter", "dac_gain_error", "dac_inl_codes",
          "temperature_error_C", "thermal_acceleration"}) {
        EXPECT_EQ(htmParameter(off, key), 0.0) << key;
    }
    EXPECT_EQ(htmParameter(off, "Ks_over_Kf"), 1.0);
    EXPECT_FALSE(off.isIdealChain);
    EXPECT_TRUE(withIdealChain(HtmParameters{}).isIdealChain);
}

} // namespace
} // namespace halbench::models
