#include "devices/simulated/htm/simulated_htm.h"
#include "devices/simulated/registry/simulated_device.h"
#include "devices/simulated/registry/simulated_models.h"

#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

Result<SimulatedSetup> setup(const std::string& text, std::optional<std::uint64_t> seed = {}) {
    const auto uri = parseDeviceUri(text);
    EXPECT_TRUE(uri) << text;
    return parseSimulatedAddress(*uri, seed);
}

models::HtmParameters parametersOf(const Result<SimulatedSetup>& given) {
    const Result<models::HtmParameters> parameters = htmParameters(given->overrides);
    EXPECT_TRUE(parameters);
    return *parameters;
}

TEST(SimulatedAddress, takesDefaultsFromThePublication) {
    const auto plain = setup("sim:htm");
    ASSERT_TRUE(plain);
    EXPECT_EQ(plain->seed, 1U);
    EXPECT_EQ(parametersOf(plain).inertia_kg_m2, 5.5e-4);
    EXPECT_EQ(parametersOf(plain).staticFriction_ratio, 1.15);
    EXPECT_TRUE(plain->overrides.empty());
}

TEST(SimulatedAddress, keepsOverridesAsWrittenSortedByKey) {
    const auto given = setup("sim:htm?seed=7&c=2.2e-3&Kf=0&stray_mT_per_A=5");
    ASSERT_TRUE(given);
    EXPECT_EQ(given->seed, 7U);
    EXPECT_EQ(parametersOf(given).viscousDamping_Nm_s, 2.2e-3);
    EXPECT_EQ(parametersOf(given).coulombFriction_Nm, 0.0);
    EXPECT_EQ(parametersOf(given).stray_T_per_A, 5e-3);
    const std::vector<std::pair<std::string, std::string>> expected = {
        {"Kf", "0"}, {"c", "2.2e-3"}, {"seed", "7"}, {"stray_mT_per_A", "5"}};
    EXPECT_EQ(given->overrides, expected);
}

TEST(SimulatedAddress, seedOfTheCommandLineWins) {
    EXPECT_EQ(setup("sim:htm?seed=7", 3)->seed, 3U);
}

TEST(SimulatedAddress, writtenValuesWinOverTheSetsInAnyOrder) {
    for (const char* text : {"sim:htm?imperfections=off&Ks_over_Kf=1.15&stray_mT_per_A=2.5",
                             "sim:htm?Ks_over_Kf=1.15&stray_mT_per_A=2.5&imperfections=off"}) {
        const auto given = setup(text);
        ASSERT_TRUE(given);
        EXPECT_EQ(parametersOf(given).staticFriction_ratio, 1.15);
        EXPECT_EQ(parametersOf(given).stray_T_per_A, 2.5e-3);
        EXPECT_EQ(parametersOf(given).frictionScatter_ratio, 0.0);
        EXPECT_EQ(parametersOf(given).hallOffset_T, 0.0);
    }
    EXPECT_TRUE(parametersOf(setup("sim:htm?chain=ideal")).isIdealChain);
    EXPECT_FALSE(parametersOf(setup("sim:htm?chain=full&imperfections=on")).isIdealChain);
}

struct BadAddress {
    const char* text;
    ErrorCode code;
};

class SimulatedBadAddress : public ::testing::TestWithParam<BadAddress> {};

TEST_P(SimulatedBadAddress, isRefusedWithTheKnownKeys) {
    const auto refused = setup(GetParam().text);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, GetParam().code);
    EXPECT_NE(refused.error().hint.find("friction_scatter"), std::string::npos) << refused.error().hint;
    EXPECT_NE(refused.error().hint.find("imperfections"), std::string::npos) << refused.error().hint;
}

INSTANTIATE_TEST_SUITE_P(Cases, SimulatedBadAddress,
                         ::testing::Values(BadAddress{"sim:htm?kf=1", ErrorCode::UnknownName},
                                           BadAddress{"sim:htm?c=-1", ErrorCode::OutOfRange},
                                           BadAddress{"sim:htm?J=0", ErrorCode::OutOfRange},
                                           BadAddress{"sim:htm?c=nan", ErrorCode::NotFinite},
                                           BadAddress{"sim:htm?c=inf", ErrorCode::NotFinite},
                                           BadAddress{"sim:htm?c=1e999", ErrorCode::OutOfRange},
                                           BadAddress{"sim:htm?c=abc", ErrorCode::InvalidInput},
                                           BadAddress{"sim:htm?c=1e-3x", ErrorCode::InvalidInput},
                                           BadAddress{"sim:htm?c=1,5", ErrorCode::InvalidInput},
                                           BadAddress{"sim:htm?seed=-1", ErrorCode::InvalidInput},
                                           BadAddress{"sim:htm?seed=1.5", ErrorCode::InvalidInput},
                                           BadAddress{"sim:htm?imperfections=none", ErrorCode::InvalidInput},
                                           BadAddress{"sim:htm?chain=perfect", ErrorCode::InvalidInput},
                                           BadAddress{"sim:htm?delay_samples=3", ErrorCode::OutOfRange},
                                           BadAddress{"sim:htm?delay_samples=1.5", ErrorCode::OutOfRange}));

TEST(SimulatedAddress, namesSimulatorsThatAreNotBuilt) {
    for (const char* text : {"sim:linear", "sim:nothing"}) {
        const auto refused = setup(text);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::UnknownName);
        EXPECT_NE(refused.error().hint.find("sim:htm"), std::string::npos);
    }
    ASSERT_EQ(listSimulatedDevices().size(), simulatedModels().size());
    EXPECT_EQ(listSimulatedDevices()[0].uri, "sim:htm");
}

} // namespace
} // namespace halbench::devices
