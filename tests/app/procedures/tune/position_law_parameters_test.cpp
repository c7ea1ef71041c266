#include "app/procedures/apply/apply_procedure.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "control/law/board_law.h"
#include "tests/app/procedures/simulated_motor.h"
#include "tests/app/procedures/uncertain_motor.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::app {
namespace {

/// A law with everything that the board's may have.
LoopLaw filtered() {
    control::PositionLaw plain;
    plain.gains.proportional = 12.0;
    plain.gains.integral = 20.0;
    plain.gains.derivative = 0.8;
    control::FilteredLaw filtered;
    filtered.gains = plain.gains;
    filtered.gains.filter_s = 0.004;
    filtered.proportionalWeight = 0.7;
    filtered.derivativeWeight = 0.25;
    filtered.filters = {control::NotchFilter{188.5, 0.2, 0.4}, control::LowPassFilter{250.0, 1}};
    return {plain, filtered};
}

LoopLaw plain() {
    return LoopLaw(filtered().law);
}

std::map<std::string, double> valuesOf(devices::Device& device) {
    std::vector<std::string> names;
    for (const ParameterSpec& spec : device.catalogue().parameters) {
        names.push_back(spec.name);
    }
    const auto read = device.readParameters(names);
    EXPECT_TRUE(read) << read.error().message;
    std::map<std::string, double> values;
    for (std::size_t i = 0; read && i < names.size(); ++i) {
        values[names[i]] = (*read)[i];
    }
    return values;
}

void write(devices::Device& device, const LoopLaw& law) {
    const auto values = lawForDevice(law, device.catalogue());
    ASSERT_TRUE(values) << values.error().message;
    ASSERT_TRUE(device.writeParameters(*values));
}

// Written to the board and read back the filters have their names and figures again.
TEST(PositionLawParameters, areALawAndBackAgain) {
    const auto device = openMotor("");
    write(*device, filtered());
    const auto law = loopLawFromParameters(valuesOf(*device), 0.01);
    ASSERT_TRUE(law && law->filtered) << (law ? "plain" : law.error().message);
    EXPECT_EQ(law->filtered->filters, filtered().filtered->filters);
    EXPECT_FLOAT_EQ(static_cast<float>(law->filtered->proportionalWeight), 0.7F);
    EXPECT_FLOAT_EQ(static_cast<float>(law->filtered->derivativeWeight), 0.25F);
    EXPECT_FLOAT_EQ(static_cast<float>(*law->filtered->gains.filter_s), 0.004F);
    EXPECT_TRUE(isSameLaw(*law, filtered(), 0.01));
    EXPECT_FALSE(isSameLaw(*law, plain(), 0.01));
    const auto running = readPositionLaw(*device);
    ASSERT_TRUE(running);
    EXPECT_EQ(control::filteredLaw(*running).filters, filtered().filtered->filters);
}

TEST(PositionLawParameters, aPlainLawTakesTheFiltersOut) {
    const auto device = openMotor("");
    const auto before = valuesOf(*device);
    write(*device, filtered());
    write(*device, plain());
    const auto law = loopLawFromParameters(valuesOf(*device), 0.01);
    ASSERT_TRUE(law);
    EXPECT_FALSE(law->filtered);
    for (const char* name :
         {"gain.reference_weight", "gain.derivative_filter", "filter.1.b0", "filter.1.a1"}) {
        EXPECT_EQ(valuesOf(*device).at(name), before.at(name)) << name;
    }
    std::vector<ParameterValue> preset = {{"gain.kp", 10.0}, {"gain.reference_weight", 0.5}};
    addPlainShaping(preset, device->catalogue());
    EXPECT_EQ(preset[1].value, 0.5) << "what a preset names stays";
    EXPECT_EQ(preset.size(), 2U + 2U + 20U);
}

// The verification predicts the filtered loop that runs; what does not stay is restored with its filters.
TEST(PositionLawParameters, aFilteredLawIsAppliedAndVerified) {
    const auto device = openMotor("seed=3");
    ApplyConfig config;
    config.values = *lawForDevice(filtered(), device->catalogue());
    config.verification = stepVerification(uncertainMotor(0.02));
    const auto applied = runApply(*device, config, {});
    ASSERT_TRUE(applied) << applied.error().message;
    EXPECT_TRUE(applied->isKept) << (applied->quality.findings.empty()
                                         ? ""
                                         : applied->quality.findings[0].message);
    ASSERT_TRUE(applied->band);
    EXPECT_LE(applied->band->widening_ratio, 1.0);
    config.values = *lawForDevice(plain(), device->catalogue());
    config.verification->overshootTolerance_percent = -1000.0; // nothing may pass
    const auto refused = runApply(*device, config, {});
    ASSERT_TRUE(refused);
    EXPECT_FALSE(refused->isKept);
    EXPECT_TRUE(isSameLaw(*loopLawFromParameters(valuesOf(*device), 0.01), filtered(), 0.01));
}

TEST(PositionLawParameters, aBoardWithoutFiltersRefusesThemAndNamesThem) {
    const auto device = openMotor("");
    devices::Catalogue small = device->catalogue();
    std::erase_if(small.parameters, [](const ParameterSpec& spec) {
        return spec.name.starts_with("filter.3") || spec.name == "gain.derivative_filter";
    });
    const BoardLawSpec spec = boardLawSpec(small);
    EXPECT_EQ(spec.filters, 2U);
    EXPECT_TRUE(spec.hasReferenceWeight);
    EXPECT_FALSE(spec.hasDerivativeFilter);
    LoopLaw law = filtered();
    EXPECT_NE(lawForDevice(law, small).error().message.find("no derivative filter"), std::string::npos);
    law.filtered->gains.filter_s.reset();
    EXPECT_TRUE(lawForDevice(law, small));
    law.filtered->filters.push_back(control::LowPassFilter{200.0, 1});
    EXPECT_NE(lawForDevice(law, small).error().message.find("more than 2 filters"), std::string::npos);
    EXPECT_TRUE(lawForDevice(plain(), small));
}

TEST(PositionLawParameters, wrongNumbersOfABoardAreNoLaw) {
    const auto device = openMotor("");
    auto values = valuesOf(*device);
    values["filter.1.a1"] = 0.1; // and a2 above it: not stable
    values["filter.1.a2"] = 0.2;
    EXPECT_EQ(loopLawFromParameters(values, 0.01).error().code, ErrorCode::OutOfRange);
    values.erase("gain.kp");
    EXPECT_EQ(loopLawFromParameters(values, 0.01).error().code, ErrorCode::UnknownName);
}

} // namespace
} // namespace halbench::app
