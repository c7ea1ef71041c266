#include "app/recordings/run_comparison.h"

#include <QtCore/QFileInfo>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace halbench::app {

namespace {

constexpr double NearPeriods = 1.5;

std::optional<double> markerTime_s(const ComparedRun& run, const std::string& text) {
    for (const auto& marker : run.meta.markers) {
        if (marker.text == text) {
            return marker.time_s;
        }
    }
    return std::nullopt;
}

/// Its times are kept too.
std::size_t valuesOf(const Recording& recording) {
    return recording.rows() * (recording.layout->columns.size() + 1);
}

Result<ComparedRun> readRun(const std::string& path, const std::function<Result<void>()>& checkAbort,
                            std::size_t room) {
    Result<devices::RecordedFile> file = devices::readRecordingFile(path, checkAbort);
    if (!file) {
        return failure(file.error());
    }
    const std::size_t values = valuesOf(file->recording);
    if (values == 0) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' has no rows", path),
                       "give a recording with data");
    }
    if (values > room) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("'{}' has {} numbers, too many for the comparison", path, values),
                       "compare fewer recordings, or parts of them (halbench convert --from --to)");
    }
    const std::string name = QFileInfo(QString::fromStdString(path)).completeBaseName().toStdString();
    return ComparedRun{name, std::move(file->recording), std::move(file->meta),
                       std::make_shared<devices::FileHold>(path), std::move(file->warnings)};
}

} // namespace

ReadRuns readRuns(const std::vector<std::string>& paths, const std::function<Result<void>()>& checkAbort,
                  std::size_t mostValues) {
    ReadRuns read;
    std::size_t values = 0;
    for (const std::string& path : paths) {
        if (checkAbort && !checkAbort()) {
            break; // small files never ask
        }
        const std::size_t room = read.runs.empty() ? std::numeric_limits<std::size_t>::max()
                                                   : mostValues - std::min(values, mostValues);
        Result<ComparedRun> run = readRun(path, checkAbort, room);
        if (run) {
            values += valuesOf(run->recording);
            read.runs.push_back(*std::move(run));
        } else {
            read.refused.push_back(run.error());
        }
    }
    return read;
}

std::optional<double> alignedZero_s(const ComparedRun& run, const RunAlignment& alignment) {
    switch (alignment.moment) {
    case RunAlignment::Moment::Trigger: {
        const std::optional<double> trigger_s = markerTime_s(run, "trigger");
        return trigger_s ? trigger_s : markerTime_s(run, "record");
    }
    case RunAlignment::Moment::Marker:
        return markerTime_s(run, alignment.marker);
    case RunAlignment::Moment::Start:
        break;
    }
    return run.recording.rows() > 0 ? std::optional(run.recording.time_s.front()) : std::nullopt;
}

std::vector<std::string> commonSignals(const std::vector<ComparedRun>& runs) {
    std::vector<std::string> names;
    if (runs.empty()) {
        return names;
    }
    for (const StreamLayout::Column& column : runs.front().recording.layout->columns) {
        const bool isCommon = std::all_of(runs.begin(), runs.end(), [&](const ComparedRun& run) {
            return run.recording.layout->indexOf(column.name) >= 0;
        });
        if (isCommon) {
            names.push_back(column.name);
        }
    }
    return names;
}

std::vector<std::string> commonMarkers(const std::vector<ComparedRun>& runs) {
    std::vector<std::string> texts;
    if (runs.empty()) {
        return texts;
    }
    for (const auto& marker : runs.front().meta.markers) {
        const bool isNew = std::find(texts.begin(), texts.end(), marker.text) == texts.end();
        const bool isCommon = std::all_of(runs.begin(), runs.end(), [&](const ComparedRun& run) {
            return markerTime_s(run, marker.text).has_value();
        });
        if (isNew && isCommon) {
            texts.push_back(marker.text);
        }
    }
    return texts;
}

std::optional<double> valueAt(const ComparedRun& run, const std::string& signal, double zero_s,
                              double time_s) {
    const Recording& recording = run.recording;
    const int column = recording.layout->indexOf(signal);
    if (column < 0 || recording.rows() == 0) {
        return std::nullopt;
    }
    const double wanted_s = time_s + zero_s;
    const auto after = std::lower_bound(recording.time_s.begin(), recording.time_s.end(), wanted_s);
    auto nearest = after == recording.time_s.end() ? after - 1 : after;
    if (nearest != recording.time_s.begin() && wanted_s - *(nearest - 1) < *nearest - wanted_s) {
        --nearest;
    }
    const auto row = static_cast<std::size_t>(nearest - recording.time_s.begin());
    const double value =
        recording.values[row * recording.layout->columns.size() + static_cast<std::size_t>(column)];
    const bool isNear = std::abs(*nearest - wanted_s) <= NearPeriods * recording.layout->period_s;
    return isNear && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace halbench::app
