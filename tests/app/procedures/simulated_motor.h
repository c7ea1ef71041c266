#pragma once

#include "app/procedures/move/move_procedure.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "control/base/units.h"
#include "devices/open/open_device.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace halbench::app {

/// A simulated motor as a device; `query` is what follows "sim:htm?".
inline std::unique_ptr<devices::Device> openMotor(const std::string& query) {
    auto device = devices::openDevice(query.empty() ? "sim:htm" : "sim:htm?" + query, {});
    EXPECT_TRUE(device) << device.error().message;
    return device ? std::move(*device) : nullptr;
}

/// "The full sensing chain, stray compensated" of resources/help/htm-theory.md section 8.
inline const std::string FullChain = "imperfections=off&stray_mT_per_A=2.5&hall_noise_mT=0.0184";

inline void setLaw(devices::Device& device, const control::SampledPositionLaw& law) {
    const auto values = positionLawValues(device.catalogue(), law);
    const auto written = device.writeParameters(values);
    ASSERT_TRUE(written) << written.error().message;
}

inline void setParameter(devices::Device& device, const std::string& name, double value) {
    const ParameterValue change[] = {{name, value}};
    const auto written = device.writeParameters(change);
    ASSERT_TRUE(written) << written.error().message;
}

inline double parameter(devices::Device& device, const std::string& name) {
    const std::string names[] = {name};
    const auto value = device.readParameters(names);
    EXPECT_TRUE(value) << value.error().message;
    return value ? value->front() : 0.0;
}

inline MoveConfig move(const std::string& reference, double duration_s) {
    MoveConfig config;
    const auto parsed = parseMoveReference(reference);
    EXPECT_TRUE(parsed) << parsed.error().message;
    config.reference = *parsed;
    config.duration_s = duration_s;
    return config;
}

inline MoveResult moved(devices::Device& device, const MoveConfig& config) {
    const auto result = runMove(device, config, {});
    EXPECT_TRUE(result) << result.error().message << " " << result.error().hint;
    return result ? *result : MoveResult{};
}

} // namespace halbench::app
