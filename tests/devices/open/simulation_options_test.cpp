#include "devices/open/simulation_options.h"
#include "devices/simulated/registry/simulated_models.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

namespace halbench::devices {
namespace {

std::size_t rowOf(const SimulationOptions& options, const std::string& key) {
    const auto& rows = options.rows();
    return static_cast<std::size_t>(
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.spec.key == key; }) -
        rows.begin());
}

TEST(SimulationOptions, everyDeviceHasARowForEveryKeyOfItsMessages) {
    for (const SimulatedModel& model : simulatedModels()) {
        const auto options = SimulationOptions::of("sim:" + model.name);
        ASSERT_TRUE(options) << model.name;
        const std::string known = ", " + model.overrides + ",";
        for (const auto& row : options->rows()) {
            EXPECT_THAT(known, testing::HasSubstr(", " + row.spec.key + ",")) << model.name;
            EXPECT_FALSE(row.spec.meaning.empty()) << row.spec.key;
        }
    }
}

// The range that is shown is the range that is taken: both ends of each key, alone. A value that is possible
// may make no device with the others; that is said of several, not of this key out of its range.
TEST(SimulationOptions, valuesOfTheRangeAreTakenAndOthersNamed) {
    int ends = 0;
    for (const SimulatedModel& model : simulatedModels()) {
        auto options = SimulationOptions::of("sim:" + model.name);
        ASSERT_TRUE(options);
        for (std::size_t row = 0; row < options->rows().size(); ++row) {
            const OverrideSpec spec = options->rows()[row].spec;
            if (spec.isText || !spec.choices.empty() || spec.key == "seed") {
                continue;
            }
            for (const double value : {spec.min, spec.max}) {
                options->set(row, fmt::format("{:.17g}", value));
                const auto checked = options->check();
                ends += checked ? 1 : 0;
                EXPECT_TRUE(checked || checked.error().message.find(spec.key + " = ") == std::string::npos)
                    << checked.error().message;
            }
            options->set(row, fmt::format("{:.17g}", spec.max + 0.01 * std::max(1.0, spec.max - spec.min)));
            const auto refused = options->check();
            ASSERT_FALSE(refused) << spec.key;
            EXPECT_EQ(refused.error().code, ErrorCode::OutOfRange) << spec.key;
            EXPECT_THAT(refused.error().message, testing::HasSubstr(spec.key));
            options->set(row, "");
        }
        EXPECT_EQ(options->address(), "sim:" + model.name);
    }
    EXPECT_GT(ends, 200);
}

TEST(SimulationOptions, addressKeepsWhatWasWritten) {
    auto options = SimulationOptions::of("sim:htm?c=2e-3&J=1e-4&seed=7");
    ASSERT_TRUE(options);
    EXPECT_EQ(options->address(), "sim:htm?seed=7&J=1e-4&c=2e-3"); // in the order of the rows
    options->set(rowOf(*options, "c"), "");
    EXPECT_EQ(options->address(), "sim:htm?seed=7&J=1e-4");
    EXPECT_TRUE(options->check());
    options->clear();
    EXPECT_EQ(options->address(), "sim:htm");
}

TEST(SimulationOptions, unknownKeysStayAndAreNamed) {
    const auto options = SimulationOptions::of("sim:planar?frobnicate=3");
    ASSERT_TRUE(options);
    EXPECT_EQ(options->address(), "sim:planar?frobnicate=3");
    const auto checked = options->check();
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().code, ErrorCode::UnknownName);
    EXPECT_THAT(checked.error().message, testing::HasSubstr("frobnicate"));
}

TEST(SimulationOptions, wrongTextIsRefusedWithItsKey) {
    for (const auto& [key, value] : {std::pair{"seed", "-1"},
                                     {"J", "much"},
                                     {"J", "nan"},
                                     {"J", "1e-4&c=0"},
                                     {"imperfections", "few"},
                                     {"chain", "1"}}) {
        auto options = SimulationOptions::of("sim:htm");
        ASSERT_TRUE(options);
        options->set(rowOf(*options, key), value);
        const auto checked = options->check();
        ASSERT_FALSE(checked) << key << "=" << value;
        EXPECT_THAT(checked.error().message, testing::HasSubstr(key));
    }
}

TEST(SimulationOptions, otherDevicesHaveNone) {
    for (const char* address :
         {"tcp:localhost:5555", "replay:motor.csv", "sim:none", "sim:htm?J", "", "sim:"}) {
        EXPECT_FALSE(SimulationOptions::of(address)) << address;
    }
}

} // namespace
} // namespace halbench::devices
