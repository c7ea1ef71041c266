#include "models/spherical/field_sensor.h"

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

double lowestCode(const FieldConverter& converter) {
    return -std::round(converter.range_T / converter.step_T);
}

double highestCode(const FieldConverter& converter) {
    return std::round(converter.range_T / converter.step_T) - 1.0;
}

double converted_T(const FieldConverter& converter, double field_T) {
    if (!converter.isQuantised) {
        return field_T;
    }
    const double code = std::round(field_T / converter.step_T);
    return converter.step_T * std::clamp(code, lowestCode(converter), highestCode(converter));
}

/// The end of the range on the side of the field. Without a converter there is no end: infinite.
double rangeEnd_T(const FieldConverter& converter, double field_T) {
    return converted_T(converter, std::copysign(HUGE_VAL, field_T));
}

} // namespace

FieldConverter converterPreset(ConverterPreset preset) {
    switch (preset) {
    case ConverterPreset::Range400mT:
        return {0.4, 0.8 / 4096.0, true};
    case ConverterPreset::Range130mT:
        return {0.13, 98e-6, true};
    case ConverterPreset::Range100mT:
        return {0.1, 0.2 / 4096.0, true};
    case ConverterPreset::Range300mT:
        break;
    }
    return {};
}

Result<void> checkFieldSensor(const FieldSensorConfig& config) {
    if (!config.gain_ratio.allFinite() || !config.crossAxis_ratio.allFinite() ||
        !config.offset_T.allFinite() || !std::isfinite(config.noise_T) ||
        !std::isfinite(config.converter.range_T) || !std::isfinite(config.converter.step_T)) {
        return failure(ErrorCode::NotFinite, "A field sensor setting is not a finite number.");
    }
    if (config.gain_ratio.minCoeff() <= 0.0 || config.noise_T < 0.0 || config.converter.step_T <= 0.0 ||
        config.converter.range_T < 2.0 * config.converter.step_T) {
        return failure(ErrorCode::OutOfRange,
                       "A field sensor needs positive gains, noise of at least zero and a range of at least "
                       "two steps of its converter.");
    }
    return {};
}

bool isAtRangeEnd(const FieldConverter& converter, double value_T) {
    if (!converter.isQuantised) {
        return false;
    }
    // Half a step of slack: values arrive in single precision.
    return value_T <= converter.step_T * (lowestCode(converter) + 0.5) ||
           value_T >= converter.step_T * (highestCode(converter) - 0.5);
}

FieldSample sampleFieldSensor(const FieldSensorConfig& config, FieldSensorState& state,
                              const Eigen::Vector3d& field_T, Random& noise) {
    const Eigen::Vector3d scaled_T = config.gain_ratio.cwiseProduct(field_T);
    Eigen::Vector3d seen_T = scaled_T + config.crossAxis_ratio * scaled_T + config.offset_T;
    if (config.noise_T > 0.0) {
        for (int i = 0; i < 3; ++i) {
            seen_T[i] += config.noise_T * noise.gaussian();
        }
    }
    FieldSample sample;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        double value_T = converted_T(config.converter, seen_T[row]);
        if (config.fault[i] == ChannelFault::Dead) {
            value_T = 0.0;
        } else if (config.fault[i] == ChannelFault::Stuck && state.hasValue) {
            value_T = state.held_T[row];
        } else if (config.fault[i] == ChannelFault::Clipped) {
            value_T = rangeEnd_T(config.converter, seen_T[row]);
        }
        sample.value_T[row] = value_T;
        sample.isClipped[i] = std::isinf(value_T) || isAtRangeEnd(config.converter, value_T);
    }
    state.held_T = sample.value_T;
    state.hasValue = true;
    return sample;
}

} // namespace halbench::models
