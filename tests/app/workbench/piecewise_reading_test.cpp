#include "app/workbench/piecewise_reading.h"
#include "tests/app/workspaces/panel_fixture.h"

#include <algorithm>
#include <optional>

namespace halbench::app {
namespace {

class PiecewiseReadingTest : public PanelTest {
protected:
    DeviceValues read(const std::vector<std::string>& names) {
        std::optional<DeviceValues> answer;
        readInPieces(bench.session(), names, [&answer](const DeviceValues& values) { answer = values; });
        EXPECT_TRUE(wait([&answer] { return answer.has_value(); }));
        return answer.value_or(DeviceValues(std::vector<double>()));
    }
};

TEST_F(PiecewiseReadingTest, valuesComeInTheOrderOfTheNamesHoweverManyThereAre) {
    connectMotor("sim:htm", 5.0);
    std::vector<std::string> names;
    for (const ParameterSpec& spec : bench.session().catalogue().parameters) {
        if (spec.isTransactional) { // the others may change by themselves
            names.push_back(spec.name);
        }
    }
    ASSERT_GT(names.size(), 24U) << "more than two pieces";
    std::reverse(names.begin(), names.end());
    const DeviceValues values = read(names);
    ASSERT_TRUE(values) << values.error().message;
    ASSERT_EQ(values->size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ((*values)[i], bench.deviceValues().at(names[i])) << names[i];
    }
    EXPECT_TRUE(read({})->empty());
}

TEST_F(PiecewiseReadingTest, ofOneUnknownNameTheErrorIsTheAnswer) {
    connectMotor("sim:htm", 5.0);
    std::vector<std::string> names(30, "gain.kp");
    names[3] = "no.such";
    const DeviceValues values = read(names);
    ASSERT_FALSE(values);
    EXPECT_NE(values.error().message.find("no.such"), std::string::npos) << values.error().message;
}

} // namespace
} // namespace halbench::app
