#pragma once

#include "control/base/random.h"
#include "control/base/result.h"

#include <Eigen/Core>
#include <array>
#include <string_view>

namespace halbench::models {

/// Converter of a three-axis field sensor: value = step round(B/step), clipped to -range ... range - step.
struct FieldConverter {
    double range_T = 0.3;
    double step_T = 0.6 / 4096.0;
    bool isQuantised = true; ///< false: value = B, neither rounded nor clipped
};

/// 12 bit over +-0.3, +-0.4 and +-0.1 T; 98 uT steps up to +-0.13 T as the TLV493D.
enum class ConverterPreset { Range300mT, Range400mT, Range130mT, Range100mT };
inline constexpr std::array<std::string_view, 4> ConverterPresetNames = {"300mT", "400mT", "130mT", "100mT"};
FieldConverter converterPreset(ConverterPreset preset);

/// Health of one channel.
enum class ChannelFault {
    None,
    Dead,    ///< reads zero field
    Stuck,   ///< keeps its first value
    Clipped, ///< reads the end of its range on the side of the field; no number without a converter
};
inline constexpr std::array<std::string_view, 4> ChannelFaultNames = {"none", "dead", "stuck", "clipped"};

/// Errors of one sensor in its own axes (R, Theta, Phi):
///   seen = (I + cross) diag(gain) axes^T B + offset + noise,   then the converter.
struct FieldSensorConfig {
    Eigen::Vector3d gain_ratio = Eigen::Vector3d::Ones();
    Eigen::Matrix3d crossAxis_ratio = Eigen::Matrix3d::Zero(); ///< (i, j): share of axis j in channel i
    Eigen::Vector3d offset_T = Eigen::Vector3d::Zero();
    double noise_T = 0.0; ///< rms of each sample
    FieldConverter converter;
    std::array<ChannelFault, 3> fault{};
};

/// OutOfRange or NotFinite when the configuration describes no possible sensor.
Result<void> checkFieldSensor(const FieldSensorConfig& config);

/// Last values of the channels, for those that are stuck.
struct FieldSensorState {
    Eigen::Vector3d held_T = Eigen::Vector3d::Zero();
    bool hasValue = false;
};

struct FieldSample {
    Eigen::Vector3d value_T = Eigen::Vector3d::Zero();
    std::array<bool, 3> isClipped{};
};

/// One sample of the field given in the sensor's axes; draws three normal numbers when noise_T is not zero.
FieldSample sampleFieldSensor(const FieldSensorConfig& config, FieldSensorState& state,
                              const Eigen::Vector3d& field_T, Random& noise);

/// Whether a value lies at either end of the converter's range.
bool isAtRangeEnd(const FieldConverter& converter, double value_T);

} // namespace halbench::models
