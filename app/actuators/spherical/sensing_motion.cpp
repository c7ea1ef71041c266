#include "app/actuators/spherical/sensing_motion.h"

#include "app/actuators/spherical/sensing_board.h"
#include "app/procedures/base/procedure_steps.h"
#include "models/spherical/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double Rate_Hz = 10.0;
/// No field of a permanent magnet outside it: the numbers are in another unit.
constexpr double LargestField_T = 3.0;
constexpr std::array<const char*, 3> References = {"reference.alpha", "reference.beta", "reference.gamma"};
constexpr const char* LeftOut = "channels_left_out";
constexpr const char* Current = "coil.current";
constexpr const char* Temperature = "temperature";

/// "field.0.r", or "field_0_r" of a recording without a sidecar.
std::vector<double> columnOf(const Recording& recording, std::string name) {
    std::vector<double> column = recording.column(name);
    if (column.empty()) {
        std::replace(name.begin(), name.end(), '.', '_');
        column = recording.column(name);
    }
    return column;
}

double spanOf(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return values.empty() ? 0.0 : *high - *low;
}

Result<void> takeFields(const Recording& recording, SensedMotion& motion) {
    const std::vector<std::string> names = fieldSignals();
    for (std::size_t c = 0; c < names.size(); ++c) {
        const std::vector<double> field_T = columnOf(recording, names[c]);
        if (field_T.empty()) {
            return failure(ErrorCode::UnknownName, fmt::format("there is no signal '{}'", names[c]),
                           "A calibration needs nine fields in tesla, field.0.r, field.0.theta ... "
                           "field.2.phi; rename columns with halbench import --map.");
        }
        for (std::size_t n = 0; n < field_T.size(); ++n) {
            if (std::abs(field_T[n]) > LargestField_T) {
                return failure(
                    ErrorCode::InvalidInput,
                    fmt::format("'{}' reads {:.3g} T: it is in another unit", names[c], field_T[n]),
                    "Convert it with halbench import --unit COLUMN=mT.");
            }
            models::CalibrationSample& sample = motion.samples[n];
            sample.used[c] = std::isfinite(field_T[n]);
            sample.readings_T[static_cast<Eigen::Index>(c)] = sample.used[c] ? field_T[n] : 0.0;
        }
    }
    return {};
}

void takeLeftOut(const Recording& recording, SensedMotion& motion) {
    const std::vector<double> leftOut = columnOf(recording, LeftOut);
    for (std::size_t n = 0; n < leftOut.size(); ++n) {
        const auto bits = static_cast<unsigned>(std::lround(leftOut[n]));
        for (unsigned c = 0; c < models::ChannelCount; ++c) {
            motion.samples[n].used[c] = motion.samples[n].used[c] && ((bits >> c) & 1U) == 0U;
        }
    }
}

Result<void> takeReferences(const Recording& recording, SensedMotion& motion) {
    std::array<std::vector<double>, 3> angles;
    for (std::size_t k = 0; k < angles.size(); ++k) {
        angles[k] = columnOf(recording, References[k]);
        motion.hasReference = k == 0 ? !angles[k].empty() : motion.hasReference && !angles[k].empty();
    }
    for (std::size_t n = 0; motion.hasReference && n < motion.samples.size(); ++n) {
        if (!std::isfinite(angles[0][n] + angles[1][n] + angles[2][n])) {
            return failure(
                ErrorCode::InvalidInput,
                fmt::format("the known orientation at {:.3f} s is not a number", recording.time_s[n]),
                "Cut the recording with halbench convert, or leave the reference columns out.");
        }
        motion.samples[n].reference = models::rotationOf({angles[0][n], angles[1][n], angles[2][n]});
    }
    return {};
}

} // namespace

Result<SensedMotion> sensedMotion(const Recording& recording) {
    if (recording.rows() == 0) {
        return failure(ErrorCode::InvalidInput, "there are no rows", "Check the link, or record longer.");
    }
    SensedMotion motion;
    motion.samples.resize(recording.rows());
    if (auto taken = takeFields(recording, motion); !taken) {
        return failure(taken.error());
    }
    takeLeftOut(recording, motion);
    if (auto taken = takeReferences(recording, motion); !taken) {
        return failure(taken.error());
    }
    const std::vector<double> current_A = columnOf(recording, Current);
    const std::vector<double> temperature_degC = columnOf(recording, Temperature);
    motion.hasTemperature = !temperature_degC.empty();
    motion.currentSpan_A = spanOf(current_A);
    motion.temperatureSpan_K = spanOf(temperature_degC);
    for (std::size_t n = 0; n < motion.samples.size(); ++n) {
        models::CalibrationSample& sample = motion.samples[n];
        sample.coilCurrent_A = current_A.empty() ? 0.0 : current_A[n];
        sample.temperature_degC = motion.hasTemperature ? temperature_degC[n] : sample.temperature_degC;
        motion.current_A += sample.coilCurrent_A / static_cast<double>(motion.samples.size());
    }
    motion.lostRows = recording.lostRows;
    return motion;
}

Result<SensedMotion> recordSensedMotion(devices::Device& device, double duration_s,
                                        const ProcedureObserver& observer) {
    const devices::LinkStatistics before = device.statistics();
    std::vector<std::string> names = fieldSignals();
    names.insert(names.end(), {LeftOut, Current, Temperature, "orientation.w", "orientation.x",
                               "orientation.y", "orientation.z"});
    if (auto entered = enterState(observer, ProcedureState::Record); !entered) {
        return failure(entered.error());
    }
    StreamRecorder recorder(device, observer);
    if (auto started = recorder.start(names, Rate_Hz); !started) {
        return failure(started.error());
    }
    if (auto waited = waitObserved(device, observer, duration_s, 0.0, 0.9, "move the rotor"); !waited) {
        return failure(recorder.causeOf(waited.error()));
    }
    const auto recording = recorder.finish();
    if (!recording) {
        return failure(recording.error());
    }
    auto motion = sensedMotion(*recording);
    if (motion) {
        motion->loss = causeOfRowLoss(before, device.statistics());
    }
    return motion;
}

} // namespace halbench::app
