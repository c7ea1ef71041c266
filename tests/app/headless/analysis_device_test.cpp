#include "app/analyses/registry/analyses.h"
#include "app/headless/analysis_device.h"
#include "app/procedures/record/record_procedure.h"
#include "devices/open/open_device.h"

#include <gmock/gmock.h>

namespace halbench::app {
namespace {

std::unique_ptr<devices::Device> opened(const char* uri) {
    auto device = devices::openDevice(uri, {});
    EXPECT_TRUE(device) << uri;
    return device ? *std::move(device) : nullptr;
}

Result<AnalysisValues> valuesOf(const char* name, devices::Device& device,
                                const std::map<std::string, std::string>& texts = {},
                                const std::map<std::string, bool>& flags = {}) {
    auto values = parseAnalysisValues(*findAnalysis(name), texts, flags);
    const auto own = deviceValuesFor(*findAnalysis(name), device);
    if (!own) {
        return failure(own.error());
    }
    values->device = *own;
    return values;
}

double numberAt(const JsonValue& body, std::initializer_list<const char*> path) {
    const JsonValue* node = &body;
    for (const char* key : path) {
        node = node == nullptr ? nullptr : node->find(key);
    }
    return node == nullptr ? std::nan("") : node->number();
}

} // namespace

// Its sensors 20 % farther out read (1/1.2)^4 of the strength: the board's radius is taken, and an option in
// its place wins. The board's numbers have single precision, 6e-8.
TEST(AnalysisDeviceTest, settingsThatAreNotGivenAreThoseOfTheDevice) {
    const auto device = opened("sim:spherical");
    const std::array farther = {ParameterValue{"sensor.radius_0", 0.06},
                                ParameterValue{"sensor.radius_1", 0.06},
                                ParameterValue{"sensor.radius_2", 0.06}};
    ASSERT_TRUE(device->writeParameters(farther));
    const Analysis& coverage = *findAnalysis("coverage");
    const auto own = valuesOf("coverage", *device, {{"step_deg", "45"}, {"map_step_deg", "45"}});
    ASSERT_TRUE(own) << own.error().message;
    const auto result = coverage.run(*own, nullptr, "", {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_NEAR(numberAt(result->body, {"placement", "radius_m"}), 0.06, 1e-8);
    EXPECT_NEAR(numberAt(result->body, {"noise_T"}), 100e-6, 1e-11);
    const auto given =
        valuesOf("coverage", *device, {{"step_deg", "45"}, {"map_step_deg", "45"}, {"radius_mm", "50"}});
    const auto nearer = coverage.run(*given, nullptr, "", {});
    ASSERT_TRUE(nearer);
    EXPECT_NEAR(numberAt(nearer->body, {"map", "largest"}) / numberAt(result->body, {"map", "largest"}),
                std::pow(1.2, 4), 1e-5);
}

// 12-bit readings with noise of 100 uT and nothing else: 0.0295 degrees rms with a free strength
// (spherical-theory.md section 7), a standard error of 2 % of 1000 poses and the quantisation on top.
TEST(AnalysisDeviceTest, orientationOfRecordedRowsIsThatOfTheDevice) {
    const auto device = opened("sim:spherical?imperfections=off&noise_uT=100&motion=5");
    const Analysis& orient = *findAnalysis("orient");
    const auto values = valuesOf("orient", *device, {}, {{"truth", true}});
    ASSERT_TRUE(values) << values.error().message;
    RecordConfig config;
    config.signals = deviceSignalsFor(orient, *values, device->catalogue());
    EXPECT_THAT(config.signals, testing::Contains("coil.current"));
    EXPECT_THAT(config.signals, testing::Contains("truth.gamma"));
    config.duration_s = 10.0;
    const auto rows = runRecord(*device, config, {});
    ASSERT_TRUE(rows) << rows.error().message;
    devices::RecordedFile file;
    file.recording = rows->recording;
    const auto result = orient.run(*values, &file, "sim:spherical", {});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(numberAt(result->body, {"determined"}), 1000.0);
    EXPECT_NEAR(numberAt(result->body, {"truth", "rms_deg"}), 0.032, 0.004);
}

TEST(AnalysisDeviceTest, anotherDeviceIsRefusedWithWhatItLacks) {
    const auto motor = opened("sim:htm");
    const auto refused = deviceValuesFor(*findAnalysis("coverage"), *motor);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::UnknownName);
    EXPECT_THAT(refused.error().message, testing::HasSubstr("sensor.alpha_0"));
    EXPECT_EQ(deviceValuesFor(*findAnalysis("forces"), *motor).error().code, ErrorCode::Usage);
}

} // namespace halbench::app
