#include "app/analyses/spherical/orientation_readings.h"

#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

/// No field of a permanent magnet outside it: the numbers are in another unit.
constexpr double LargestField_T = 3.0;
/// The last step of a converter lies below the positive end of its range: 0.05 % of it with 12 bit, 0.08 %
/// with 98 uT steps up to 130 mT.
constexpr double RangeEnd_ratio = 0.999;
/// Rows at the largest magnitude from which on a channel counts as suspect, and their share.
constexpr std::size_t SuspectRows = 10;
constexpr double SuspectShare = 0.01;

/// "field.0.r" and "field_0_r" are one signal: a recording without a sidecar knows the column alone.
std::string plainName(std::string name) {
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

Result<std::size_t> columnOf(const Recording& recording, const std::string& name, const std::string& unit,
                             const std::string& origin) {
    const auto& columns = recording.layout->columns;
    const std::string wanted = plainName(name);
    std::string known;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string column = plainName(columns[i].name);
        if (column == wanted && (columns[i].unit == unit || (unit == "rad" && columns[i].unit == "deg"))) {
            return i;
        }
        if (column == wanted || column.starts_with(wanted + "_")) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{}: '{}' is not in {}", origin, columns[i].name, unit),
                           fmt::format("convert it first: halbench import --unit COLUMN={} --map {}=COLUMN",
                                       unit, name));
        }
        known += (known.empty() ? "" : ", ") + columns[i].name;
    }
    return failure(ErrorCode::UnknownName, fmt::format("{}: there is no signal '{}'", origin, name),
                   fmt::format("there are {}; name others with --readings or --truth-signals", known));
}

template <std::size_t Count>
Result<std::array<std::string, Count>>
namesOf(const std::string& text, const std::array<std::string, Count>& usual, const char* option) {
    if (text.empty()) {
        return usual;
    }
    const std::vector<std::string> given = splitList(text);
    std::array<std::string, Count> names;
    if (given.size() != Count) {
        return failure(ErrorCode::Usage, fmt::format("{} has {} names, not {}", option, given.size(), Count),
                       fmt::format("the usual ones are {}", fmt::join(usual, ",")));
    }
    std::copy(given.begin(), given.end(), names.begin());
    return names;
}

Result<void> readTruth(const AnalysisValues& values, const Recording& recording, const std::string& origin,
                       OrientationReadings& result) {
    const std::array<std::string, 3> usual = {"truth.alpha", "truth.beta", "truth.gamma"};
    const auto names = namesOf(values.text("truth_signals"), usual, "--truth-signals");
    if (!names) {
        return failure(names.error());
    }
    std::array<std::size_t, 3> columns{};
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Result<std::size_t> column = columnOf(recording, (*names)[i], "rad", origin);
        if (!column) {
            return failure(column.error());
        }
        columns[i] = *column;
    }
    const std::size_t width = recording.layout->columns.size();
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        std::array<double, 3> angles{};
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const double value = recording.values[row * width + columns[i]];
            const bool isDegrees = recording.layout->columns[columns[i]].unit == "deg";
            if (!std::isfinite(value)) {
                return failure(ErrorCode::InvalidInput,
                               fmt::format("{}: '{}' has no value at {} s", origin, (*names)[i],
                                           formatNumber(recording.time_s[row])),
                               "cut the recording with 'halbench convert', or leave --truth out");
            }
            angles[i] = isDegrees ? degreesToRadians(value) : value;
        }
        result.truth.push_back({angles[0], angles[1], angles[2]});
    }
    return {};
}

/// Readings beyond any field, or channels at the end of the range.
Result<void> markChannels(std::optional<double> range_T, const std::string& origin,
                          OrientationReadings& result) {
    double largest = 0.0;
    for (std::size_t row = 0; row < result.readings_T.size(); ++row) {
        for (std::size_t i = 0; i < models::ChannelCount; ++i) {
            const double value = result.readings_T[row][static_cast<Eigen::Index>(i)];
            const bool isMissing = !std::isfinite(value);
            const bool isClipped = range_T && std::abs(value) >= *range_T * RangeEnd_ratio;
            result.missing[i] += isMissing;
            result.clipped[i] += isClipped;
            result.used[row][i] = !isMissing && !isClipped;
            largest = isMissing ? largest : std::max(largest, std::abs(value));
        }
    }
    if (largest > LargestField_T) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: the readings reach {} T: they are in another unit", origin,
                                   formatNumber(largest)),
                       "convert them with 'halbench import --unit COLUMN=mT'");
    }
    for (std::size_t i = 0; !range_T && largest > 0.0 && i < models::ChannelCount; ++i) {
        const auto rests = [&](const models::SphericalReadings& reading) {
            return std::abs(reading[static_cast<Eigen::Index>(i)]) >= largest;
        };
        const auto rows = static_cast<std::size_t>(
            std::count_if(result.readings_T.begin(), result.readings_T.end(), rests));
        const bool isMany =
            static_cast<double>(rows) > SuspectShare * static_cast<double>(result.used.size());
        // A rotor at rest between noiseless sensors repeats its readings and is not clipped.
        const bool isAll = rows == result.used.size();
        if (rows >= SuspectRows && isMany && !isAll) {
            result.suspect = i;
        }
    }
    return {};
}

} // namespace

std::array<std::string, models::ChannelCount> defaultReadingNames() {
    std::array<std::string, models::ChannelCount> names;
    constexpr std::array Axes = {"r", "theta", "phi"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        names[i] = fmt::format("field.{}.{}", i / 3, Axes[i % 3]);
    }
    return names;
}

Result<OrientationReadings> orientationReadings(const AnalysisValues& values,
                                                const devices::RecordedFile& file,
                                                const std::string& origin) {
    const Recording& recording = file.recording;
    OrientationReadings result;
    const auto names = namesOf(values.text("readings"), defaultReadingNames(), "--readings");
    if (!names) {
        return failure(names.error());
    }
    result.names = *names;
    result.time_s = recording.time_s;
    result.readings_T.resize(recording.rows());
    result.used.resize(recording.rows(), models::AllChannels);
    for (std::size_t i = 0; i < models::ChannelCount; ++i) {
        const Result<std::size_t> column = columnOf(recording, result.names[i], "T", origin);
        if (!column) {
            return failure(column.error());
        }
        const std::size_t width = recording.layout->columns.size();
        for (std::size_t row = 0; row < recording.rows(); ++row) {
            result.readings_T[row][static_cast<Eigen::Index>(i)] = recording.values[row * width + *column];
        }
    }
    result.coilCurrent_A.resize(recording.rows(), 0.0);
    if (const auto current = columnOf(recording, "coil.current", "A", origin)) {
        const std::size_t width = recording.layout->columns.size();
        for (std::size_t row = 0; row < recording.rows(); ++row) {
            const double current_A = recording.values[row * width + *current];
            result.coilCurrent_A[row] = std::isfinite(current_A) ? current_A : 0.0;
        }
    }
    std::optional<double> range_T;
    if (const std::optional<double> range_mT = values.number("range_mT")) {
        range_T = *range_mT / 1e3;
    }
    Result<void> done = markChannels(range_T, origin, result);
    if (done && values.isSet("truth")) {
        done = readTruth(values, recording, origin, result);
    }
    if (!done) {
        return failure(done.error());
    }
    return result;
}

} // namespace halbench::app
