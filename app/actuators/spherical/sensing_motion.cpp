#include "app/actuators/spherical/sensing_motion.h"

#include "app/actuators/spherical/sensing_board.h"
#include "app/actuators/spherical/sensing_columns.h"
#include "app/procedures/base/procedure_steps.h"
#include "control/base/units.h"
#include "models/spherical/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace halbench::app {
namespace {

constexpr double Rate_Hz = 10.0;
/// No field of a permanent magnet outside it: the numbers are in another unit.
constexpr double LargestField_T = 3.0;
constexpr const char* LeftOut = "channels_left_out";
constexpr const char* Current = "coil.current";
constexpr const char* Temperature = "temperature";
/// What a picture of the motion shows while it is recorded, where the board has it.
constexpr std::array Watched = {"orientation.fresh", "integrity", "shaft.cone95", "strength", "chi_square"};
constexpr const char* DrivenCurrent = "simulation.coil_current";
constexpr double CoilDwell_s = 3.0;

/// A column that may be missing, but not be in a unit of another quantity.
Result<std::vector<double>> columnOf(const Recording& recording, const std::string& name,
                                     const std::string& unit) {
    const auto column = sensingColumn(recording, name, unit, ColumnsWithoutUnit::Taken);
    if (!column && column.error().code == ErrorCode::UnknownName) {
        return std::vector<double>();
    }
    return column ? Result<std::vector<double>>(column->values(recording)) : failure(column.error());
}

double spanOf(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return values.empty() ? 0.0 : *high - *low;
}

/// Which of the nine fields are not there, by sensors where all of one are missing.
Error missingFields(const Recording& recording, const std::vector<std::string>& missing) {
    std::string message = fmt::format("there is no signal '{}'", fmt::join(missing, "', '"));
    for (int i = 0; i < 3; ++i) {
        const std::string sensor = fmt::format("field.{}.", i);
        const auto isOfSensor = [&sensor](const std::string& name) { return name.starts_with(sensor); };
        if (missing.size() < 9 && std::count_if(missing.begin(), missing.end(), isOfSensor) == 3) {
            message += fmt::format(": sensor {} is missing", i);
        }
    }
    return {
        ErrorCode::UnknownName, message,
        fmt::format("A calibration needs nine fields, field.0.r, field.0.theta ... field.2.phi; record all "
                    "sensors, or rename columns with halbench import --map. There are {}.",
                    columnNames(recording))};
}

Result<void> takeFields(const Recording& recording, SensedMotion& motion) {
    const std::vector<std::string> names = fieldSignals();
    std::vector<std::string> missing;
    for (std::size_t c = 0; c < names.size(); ++c) {
        const auto field_T = columnOf(recording, names[c], "T");
        if (!field_T) {
            return failure(field_T.error());
        }
        if (field_T->empty()) {
            missing.push_back(names[c]);
            continue;
        }
        for (std::size_t n = 0; n < field_T->size(); ++n) {
            const double reading_T = (*field_T)[n];
            if (std::abs(reading_T) > LargestField_T) {
                return failure(ErrorCode::InvalidInput,
                               fmt::format("'{}' reads {:.3g} T: it is in another unit", names[c], reading_T),
                               "Convert it with halbench import --unit COLUMN=mT.");
            }
            models::CalibrationSample& sample = motion.samples[n];
            sample.used[c] = std::isfinite(reading_T);
            sample.readings_T[static_cast<Eigen::Index>(c)] = sample.used[c] ? reading_T : 0.0;
        }
    }
    return missing.empty() ? Result<void>() : failure(missingFields(recording, missing));
}

void takeLeftOut(const std::vector<double>& leftOut, SensedMotion& motion) {
    for (std::size_t n = 0; n < leftOut.size(); ++n) {
        const auto bits = std::isfinite(leftOut[n]) ? static_cast<unsigned>(std::lround(leftOut[n])) : 0U;
        for (unsigned c = 0; c < models::ChannelCount; ++c) {
            motion.samples[n].used[c] = motion.samples[n].used[c] && ((bits >> c) & 1U) == 0U;
        }
    }
}

using AngleColumns = std::array<std::vector<double>, 3>;

/// Empty unless all three are there.
Result<AngleColumns> angleColumns(const Recording& recording, const std::string& name) {
    AngleColumns angles;
    for (std::size_t k = 0; k < angles.size(); ++k) {
        constexpr std::array Parts = {"alpha", "beta", "gamma"};
        auto column = columnOf(recording, fmt::format("{}.{}", name, Parts[k]), "rad");
        if (!column) {
            return failure(column.error());
        }
        if (column->empty()) {
            return AngleColumns();
        }
        angles[k] = *std::move(column);
    }
    return angles;
}

Result<void> checkReferences(const AngleColumns& angles, const Recording& recording) {
    for (std::size_t n = 0; n < recording.rows(); ++n) {
        if (!std::isfinite(angles[0][n] + angles[1][n] + angles[2][n])) {
            return failure(
                ErrorCode::InvalidInput,
                fmt::format("the known orientation at {:.3f} s is not a number", recording.time_s[n]),
                "Cut the recording with halbench convert, or leave the reference columns out.");
        }
        for (const std::vector<double>& angle : angles) {
            if (std::abs(angle[n]) > 2.0 * Pi) {
                return failure(
                    ErrorCode::InvalidInput,
                    fmt::format("the known orientation at {:.3f} s is beyond one turn, {:.4g} rad: "
                                "it is in degrees",
                                recording.time_s[n], angle[n]),
                    "Give the unit of its columns: halbench import --unit COLUMN=deg.");
            }
        }
    }
    return {};
}

/// Known orientations enter the fit; those of a simulation or of the board only check it.
Result<void> takeOrientations(const Recording& recording, SensedMotion& motion) {
    for (const char* name : {"reference", "truth", "orientation"}) {
        const auto angles = angleColumns(recording, name);
        const bool isReference = std::string_view(name) == "reference";
        if (!angles && isReference) {
            return failure(angles.error());
        }
        if (!angles || angles->front().empty()) {
            continue;
        }
        if (isReference) {
            if (auto checked = checkReferences(*angles, recording); !checked) {
                return checked;
            }
            motion.hasReference = true;
        }
        motion.recordedBy = name;
        for (std::size_t n = 0; n < motion.samples.size(); ++n) {
            motion.recorded.push_back(
                models::rotationOf({(*angles)[0][n], (*angles)[1][n], (*angles)[2][n]}));
            if (isReference) {
                motion.samples[n].reference = motion.recorded.back();
            }
        }
        return {};
    }
    return {};
}

} // namespace

Result<SensedMotion> sensedMotion(const Recording& recording) {
    if (recording.rows() == 0) {
        return failure(ErrorCode::InvalidInput, "there are no rows", "record longer");
    }
    SensedMotion motion;
    motion.samples.resize(recording.rows());
    if (auto taken = takeFields(recording, motion); !taken) {
        return failure(taken.error());
    }
    if (auto taken = takeOrientations(recording, motion); !taken) {
        return failure(taken.error());
    }
    const auto leftOut = columnOf(recording, LeftOut, "");
    takeLeftOut(leftOut.value_or(std::vector<double>()), motion);
    const auto current = columnOf(recording, Current, "A");
    const auto temperature = columnOf(recording, Temperature, "degC");
    if (!current || !temperature) {
        return failure(current ? temperature.error() : current.error());
    }
    const std::vector<double>& current_A = *current;
    const std::vector<double>& temperature_degC = *temperature;
    motion.hasTemperature = !temperature_degC.empty();
    motion.currentSpan_A = spanOf(current_A);
    motion.temperatureSpan_K = spanOf(temperature_degC);
    for (std::size_t n = 0; n < motion.samples.size(); ++n) {
        models::CalibrationSample& sample = motion.samples[n];
        sample.coilCurrent_A = current_A.empty() ? 0.0 : current_A[n];
        sample.temperature_degC = motion.hasTemperature ? temperature_degC[n] : sample.temperature_degC;
        for (std::size_t c = 0; c < sample.used.size(); ++c) {
            motion.channels[c] = motion.channels[c] || sample.used[c];
        }
        motion.current_A += sample.coilCurrent_A / static_cast<double>(motion.samples.size());
    }
    motion.lostRows = recording.lostRows;
    return motion;
}

namespace {

constexpr const char* Waiting = "move the rotor";
constexpr double RecordingShare = 0.9; ///< of the progress

/// Lets the time pass with the coil's current now as it was, now another by the step.
Result<void> waitSwitchingCoil(devices::Device& device, const ProcedureObserver& observer, double duration_s,
                               double coilStep_A) {
    const std::string names[] = {DrivenCurrent};
    const auto before_A = device.readParameters(names);
    if (!before_A) {
        return failure(before_A.error());
    }
    // Away from the end of what may be set.
    const auto& range = *device.catalogue().findParameter(DrivenCurrent);
    const double step_A = before_A->front() + coilStep_A <= range.max ? coilStep_A : -coilStep_A;
    const int pieces = 2 * std::max(1, static_cast<int>(duration_s / (2.0 * CoilDwell_s)));
    Result<void> done;
    for (int i = 0; done && i < pieces; ++i) {
        const ParameterValue current[] = {{DrivenCurrent, before_A->front() + (i % 2) * step_A}};
        done = device.writeParameters(current);
        done = done ? waitObserved(device, observer, duration_s / pieces, RecordingShare * i / pieces,
                                   RecordingShare * (i + 1) / pieces, Waiting)
                    : done;
    }
    const ParameterValue before[] = {{DrivenCurrent, before_A->front()}};
    const Result<void> setBack = device.writeParameters(before);
    return done ? setBack : done;
}

Result<void> waitForMotion(devices::Device& device, const ProcedureObserver& observer, double duration_s,
                           double coilStep_A) {
    const bool isDriven = device.catalogue().findParameter(DrivenCurrent) != nullptr;
    if (coilStep_A != 0.0 && isDriven) {
        return waitSwitchingCoil(device, observer, duration_s, coilStep_A);
    }
    return waitObserved(device, observer, duration_s, 0.0, RecordingShare, Waiting);
}

} // namespace

Result<SensedMotion> recordSensedMotion(devices::Device& device, double duration_s,
                                        const ProcedureObserver& observer, double coilStep_A) {
    const devices::LinkStatistics before = device.statistics();
    std::vector<std::string> names = fieldSignals();
    names.insert(names.end(), {LeftOut, Current, Temperature, "orientation.w", "orientation.x",
                               "orientation.y", "orientation.z"});
    const devices::Catalogue catalogue = device.catalogue();
    std::copy_if(Watched.begin(), Watched.end(), std::back_inserter(names),
                 [&catalogue](const char* name) { return catalogue.findSignal(name) != nullptr; });
    if (auto entered = enterState(observer, ProcedureState::Record); !entered) {
        return failure(entered.error());
    }
    StreamRecorder recorder(device, observer);
    if (auto started = recorder.start(names, Rate_Hz); !started) {
        return failure(started.error());
    }
    if (auto waited = waitForMotion(device, observer, duration_s, coilStep_A); !waited) {
        return failure(recorder.causeOf(waited.error()));
    }
    const auto recording = recorder.finish();
    if (!recording) {
        return failure(recording.error());
    }
    const RowLossCause loss = causeOfRowLoss(before, device.statistics());
    auto motion = sensedMotion(*recording);
    if (!motion) {
        return failure(recording->rows() == 0 ? withCause(motion.error(), loss) : motion.error());
    }
    motion->loss = loss;
    return motion;
}

} // namespace halbench::app
