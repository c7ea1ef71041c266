#include "app/analyses/spherical/orientation_readings.h"

#include "app/actuators/spherical/sensing_columns.h"
#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace halbench::app {

namespace {

/// No field of a permanent magnet outside it: the numbers are in another unit.
constexpr double LargestField_T = 3.0;
/// The last step of a converter lies below the positive end of its range: 0.05 % of it with 12 bit, 0.08 %
/// with 98 uT steps up to 130 mT.
constexpr double RangeEnd_ratio = 0.999;
/// Rows with exactly its largest reading from which on a channel is saturated, their share of all rows, and
/// how many times the readings just below. A sine that is rounded to 12 bit has 0.8 times as many at its top.
constexpr std::size_t LeastPile = 10;
constexpr double LeastPileShare = 0.01;
constexpr std::size_t PileToNeighbours = 2;
constexpr double Neighbours_ratio = 0.997;
/// Channels at rest with one common magnitude: three of a rotor's field may be alike, four are saturated.
constexpr std::size_t LeastAlike = 4;
constexpr const char* LeftOutSignal = "channels_left_out";

/// As sensingColumn(), with the recording named.
Result<SensingColumn> columnOf(const Recording& recording, const std::string& name, const std::string& unit,
                               const std::string& origin) {
    const auto column = sensingColumn(recording, name, unit, ColumnsWithoutUnit::Refused);
    if (column) {
        return column;
    }
    Error error = column.error();
    error.message = origin + ": " + error.message;
    if (error.code == ErrorCode::UnknownName) {
        error.hint += "; name others with --readings or --truth-signals";
    }
    return failure(error);
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
    std::array<std::vector<double>, 3> columns;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Result<SensingColumn> column = columnOf(recording, (*names)[i], "rad", origin);
        if (!column) {
            return failure(column.error());
        }
        columns[i] = column->values(recording);
    }
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        std::array<double, 3> angles{};
        for (std::size_t i = 0; i < angles.size(); ++i) {
            if (!std::isfinite(columns[i][row])) {
                return failure(ErrorCode::InvalidInput,
                               fmt::format("{}: '{}' has no value at {} s", origin, (*names)[i],
                                           formatNumber(recording.time_s[row])),
                               "cut the recording with 'halbench convert', or leave --truth out");
            }
            angles[i] = columns[i][row];
        }
        result.truth.push_back({angles[0], angles[1], angles[2]});
    }
    return {};
}

struct Pile {
    std::size_t rows = 0; ///< with the channel's own largest or smallest value, at the common end
    std::size_t neighbours = 0;
    bool isAll = false;
};

Pile pileOf(const OrientationReadings& result, std::size_t channel, double largest_T) {
    const auto value = [&](const models::SphericalReadings& reading) {
        return reading[static_cast<Eigen::Index>(channel)];
    };
    double lowest = 0.0;
    double highest = 0.0;
    for (const models::SphericalReadings& reading : result.readings_T) {
        lowest = std::fmin(lowest, value(reading)); // numbers win over missing values
        highest = std::fmax(highest, value(reading));
    }
    Pile pile;
    for (const models::SphericalReadings& reading : result.readings_T) {
        const double size = std::abs(value(reading));
        const bool isExtreme = value(reading) == lowest || value(reading) == highest;
        pile.rows += isExtreme && size >= largest_T * RangeEnd_ratio;
        pile.neighbours += !isExtreme && size >= largest_T * Neighbours_ratio;
    }
    pile.isAll = pile.rows == result.readings_T.size();
    return pile;
}

/// Leaves out readings that pile up at the common largest magnitude.
void markSaturated(double largest_T, OrientationReadings& result) {
    const auto rows = static_cast<double>(result.readings_T.size());
    std::vector<std::size_t> saturated;
    bool isAtRest = true;
    for (std::size_t i = 0; i < models::ChannelCount; ++i) {
        const Pile pile = pileOf(result, i, largest_T);
        const bool isMany = pile.rows >= LeastPile && static_cast<double>(pile.rows) > LeastPileShare * rows;
        if (pile.rows > 0 && (isMany || pile.isAll) && pile.rows > PileToNeighbours * pile.neighbours) {
            saturated.push_back(i);
            isAtRest = isAtRest && pile.isAll;
        }
    }
    // A rotor at rest between noiseless sensors repeats its readings and is not saturated.
    if (saturated.empty() || (isAtRest && saturated.size() < LeastAlike)) {
        return;
    }
    result.saturation_T = largest_T;
    for (const std::size_t i : saturated) {
        for (std::size_t row = 0; row < result.readings_T.size(); ++row) {
            const double size = std::abs(result.readings_T[row][static_cast<Eigen::Index>(i)]);
            if (size >= largest_T * RangeEnd_ratio) {
                result.used[row][i] = false;
                ++result.clipped[i];
            }
        }
    }
    result.saturated = std::move(saturated);
}

/// The board's channel in the place of each reading, which may be named in another order; none where a
/// reading is no channel of the board.
std::array<std::optional<unsigned>, models::ChannelCount>
boardChannels(const Recording& recording, const OrientationReadings& result, const std::string& origin) {
    const auto own = defaultReadingNames();
    std::array<std::optional<unsigned>, models::ChannelCount> channels;
    for (unsigned channel = 0; channel < own.size(); ++channel) {
        const Result<SensingColumn> column = columnOf(recording, own[channel], "T", origin);
        for (std::size_t i = 0; column && i < channels.size(); ++i) {
            if (columnOf(recording, result.names[i], "T", origin)->index == column->index) {
                channels[i] = channel;
            }
        }
    }
    return channels;
}

/// The board knows the ends of its converters and the channels that were switched off.
Result<void> markLeftOut(const Recording& recording, const std::string& origin, OrientationReadings& result) {
    const Result<SensingColumn> column = columnOf(recording, LeftOutSignal, "", origin);
    if (!column) {
        return column.error().code == ErrorCode::UnknownName ? Result<void>() : failure(column.error());
    }
    const auto channels = boardChannels(recording, result, origin);
    const std::vector<double> flags = column->values(recording);
    for (std::size_t row = 0; row < flags.size(); ++row) {
        if (std::isnan(flags[row])) { // a lost row leaves a gap
            continue;
        }
        constexpr double Combinations = 1 << models::ChannelCount;
        if (!(flags[row] >= 0.0 && flags[row] < Combinations) || flags[row] != std::floor(flags[row])) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{}: row {}: {} = {} is no whole number from 0 to {}", origin, row + 1,
                                       LeftOutSignal, formatNumber(flags[row]), Combinations - 1.0),
                           "record it again, or leave the column out");
        }
        const auto bits = static_cast<unsigned>(flags[row]);
        for (std::size_t i = 0; i < channels.size(); ++i) {
            const bool isOut = channels[i] && ((bits >> *channels[i]) & 1U) != 0U && result.used[row][i];
            result.leftOut[i] += isOut;
            result.used[row][i] = result.used[row][i] && !isOut;
        }
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
    if (!range_T && largest > 0.0) {
        markSaturated(largest, result);
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
    if (recording.rows() == 0) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: there are no rows of {}", origin, fmt::join(*names, ", ")),
                       fmt::format("record again; the file has the columns {}", columnNames(recording)));
    }
    result.names = *names;
    result.time_s = recording.time_s;
    result.readings_T.resize(recording.rows());
    result.used.resize(recording.rows(), models::AllChannels);
    for (std::size_t i = 0; i < models::ChannelCount; ++i) {
        const Result<SensingColumn> column = columnOf(recording, result.names[i], "T", origin);
        if (!column) {
            return failure(column.error());
        }
        const std::vector<double> readings_T = column->values(recording);
        for (std::size_t row = 0; row < readings_T.size(); ++row) {
            result.readings_T[row][static_cast<Eigen::Index>(i)] = readings_T[row];
        }
    }
    result.coilCurrent_A.resize(recording.rows(), 0.0);
    const Result<SensingColumn> current = columnOf(recording, "coil.current", "A", origin);
    if (!current && current.error().code != ErrorCode::UnknownName) {
        return failure(current.error()); // it is there: not taken for none
    }
    if (current) {
        result.coilCurrent_A = current->values(recording);
        std::replace_if(
            result.coilCurrent_A.begin(), result.coilCurrent_A.end(),
            [](double current_A) { return !std::isfinite(current_A); }, 0.0);
    }
    std::optional<double> range_T;
    if (const std::optional<double> range_mT = values.number("range_mT")) {
        range_T = *range_mT / 1e3;
    }
    Result<void> done = markChannels(range_T, origin, result);
    done = done ? markLeftOut(recording, origin, result) : done;
    if (done && values.isSet("truth")) {
        done = readTruth(values, recording, origin, result);
    }
    if (!done) {
        return failure(done.error());
    }
    return result;
}

} // namespace halbench::app
