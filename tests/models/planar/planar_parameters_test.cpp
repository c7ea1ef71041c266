#include "models/planar/planar_parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace halbench::models {
namespace {

TEST(PlanarParameters, everyKeyCanBeReadWrittenAndHasALegalDefault) {
    std::set<std::string_view> keys;
    for (const PlanarParameterSpec& spec : planarParameterSpecs()) {
        EXPECT_TRUE(keys.insert(spec.key).second) << spec.key;
        EXPECT_TRUE((spec.value == nullptr) != (spec.specimen == nullptr)) << spec.key;
        EXPECT_FALSE(spec.meaning.empty()) << spec.key;
        PlanarParameters parameters;
        const auto before = planarParameter(parameters, spec.key);
        if (before) {
            EXPECT_TRUE(setPlanarParameter(parameters, spec.key, *before)) << spec.key;
        }
        for (const double value : {spec.min, spec.max}) {
            ASSERT_TRUE(setPlanarParameter(parameters, spec.key, value)) << spec.key;
            EXPECT_NEAR(*planarParameter(parameters, spec.key), value, 1e-12 * std::fabs(value)) << spec.key;
        }
    }
}

TEST(PlanarParameters, defaultsAreThoseOfTheTheoryPage) {
    // Section 3.
    const PlanarParameters parameters;
    const std::pair<const char*, double> expected[] = {{"L_mm", 50.8},
                                                       {"magnet_thickness_mm", 12.7},
                                                       {"mu0M0", 0.715},
                                                       {"coil_width_mm", 6.096},
                                                       {"coil_height_mm", 7.5946},
                                                       {"lambda", 1968.50},
                                                       {"beta", 1711.74},
                                                       {"z1_mm", 3.025},
                                                       {"R", 1.98},
                                                       {"L_c", 1.28e-3},
                                                       {"Imax", 1.0},
                                                       {"m", 0.64},
                                                       {"Iz", 0.001},
                                                       {"c56_mm", 44.4},
                                                       {"k_b", 1.7e7},
                                                       {"hall_field_mT", 20.0},
                                                       {"hall_noise_uT", 18.0},
                                                       {"cable_N_per_m", 2.0},
                                                       {"cable_y_mm", -20.0},
                                                       {"slow_force_mN", 0.5},
                                                       {"damping", 0.1},
                                                       {"damping_phi", 1e-4},
                                                       {"cm_x_mm", 0.8},
                                                       {"cm_y_mm", -0.6},
                                                       {"coil_gain_1", 1.02},
                                                       {"coil_gain_6", 0.98},
                                                       {"travel_mm", 50.0},
                                                       {"travel_mrad", 20.0},
                                                       {"amplifier_gain", 0.506},
                                                       {"amplifier_bandwidth_Hz", 6893.0},
                                                       {"delay_samples", 1.0}};
    for (const auto& [key, value] : expected) {
        EXPECT_NEAR(planarParameter(parameters, key).value_or(0.0), value, 1e-12 * std::fabs(value)) << key;
    }
}

// Section 10, contradiction 16: what the publication leaves out has the value [A] of section 3 and can be
// another one.
TEST(PlanarParameters, whatThePublicationLeavesOutIsAssumedAndEditable) {
    const std::pair<const char*, double> expected[] = {
        {"travel_mm", 50.0},     {"travel_mrad", 20.0},       {"lattice_pitches", 6.0},
        {"hall1_x_mm", -63.5},   {"hall2_x_mm", 63.5},        {"hall3_x_mm", 0.0},
        {"cable_N_per_m", 2.0},  {"cable_Nm_per_rad", 0.005}, {"cable_x_mm", 0.0},
        {"cable_y_mm", -20.0},   {"slow_force_mN", 0.5},      {"slow_force_Hz", 5.0},
        {"hall_field_mT", 20.0}, {"hall_noise_uT", 18.0}};
    for (const auto& [key, value] : expected) {
        const PlanarParameterSpec* spec = findPlanarParameter(key);
        ASSERT_NE(spec, nullptr) << key;
        EXPECT_EQ(spec->provenance, 'A') << key;
        PlanarParameters parameters;
        EXPECT_NEAR(planarParameter(parameters, key).value_or(NAN), value, 1e-12 * std::fabs(value)) << key;
        const double other = value + 1.0; // whole where a count is
        EXPECT_TRUE(setPlanarParameter(parameters, key, other)) << key;
        EXPECT_NEAR(planarParameter(parameters, key).value_or(NAN), other, 1e-12 * std::fabs(other)) << key;
    }
}

TEST(PlanarParameters, refusesUnknownKeysAndImpossibleValues) {
    PlanarParameters parameters;
    EXPECT_EQ(setPlanarParameter(parameters, "mass", 1.0).error().code, ErrorCode::UnknownName);
    EXPECT_EQ(setPlanarParameter(parameters, "m", 0.0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(setPlanarParameter(parameters, "m", std::nan("")).error().code, ErrorCode::NotFinite);
    EXPECT_EQ(setPlanarParameter(parameters, "dac_bits", 12.5).error().code, ErrorCode::OutOfRange);
    EXPECT_NE(setPlanarParameter(parameters, "mass", 1.0).error().hint.find("imperfections"),
              std::string::npos);
}

TEST(PlanarParameters, refusesWhatMakesNoMachineTogether) {
    PlanarParameters parameters;
    EXPECT_TRUE(checkPlanarParameters(parameters));
    ASSERT_TRUE(setPlanarParameter(parameters, "coil_width_mm", 20.0));
    ASSERT_TRUE(setPlanarParameter(parameters, "L_mm", 40.0));
    EXPECT_EQ(checkPlanarParameters(parameters).error().code, ErrorCode::OutOfRange);
    PlanarParameters outside;
    ASSERT_TRUE(setPlanarParameter(outside, "x0_mm", 60.0));
    EXPECT_EQ(checkPlanarParameters(outside).error().code, ErrorCode::OutOfRange);
}

TEST(PlanarParameters, variantsRemoveWhatTheySay) {
    const PlanarParameters clean = withoutImperfections(PlanarParameters{});
    for (const char* key : {"cm_x_mm", "hall_noise_uT", "cable_N_per_m", "slow_force_mN", "hall2_offset_x_uT",
                            "hall3_place_error_y_mm", "thermal_acceleration"}) {
        EXPECT_EQ(planarParameter(clean, key), 0.0) << key;
    }
    EXPECT_EQ(planarParameter(clean, "coil_gain_1"), 1.0);
    EXPECT_EQ(planarParameter(clean, "damping"), 0.1);
    EXPECT_FALSE(clean.isIdealChain);
    EXPECT_TRUE(withIdealChain(PlanarParameters{}).isIdealChain);
}

TEST(PlanarParameters, choicesAreWordsAndEveryWordIsAllowed) {
    EXPECT_EQ(planarParameterWords("wrench"), (std::vector<std::string>{"windings", "prism", "published"}));
    for (const char* key : {"hall1_fault", "hall2_fault", "hall3_fault"}) {
        EXPECT_EQ(planarParameterWords(key), (std::vector<std::string>{"none", "dead", "stuck", "clipped"}));
        PlanarParameters parameters;
        EXPECT_TRUE(setPlanarParameter(parameters, key, 3.0));
        EXPECT_FALSE(setPlanarParameter(parameters, key, 4.0));
        EXPECT_FALSE(setPlanarParameter(parameters, key, 0.5));
    }
    EXPECT_TRUE(planarParameterWords("m").empty());
    EXPECT_TRUE(planarParameterWords("nothing").empty());
}

} // namespace
} // namespace halbench::models
