#include "devices/formats/convert_recording.h"

#include "devices/formats/mat_writer.h"
#include "devices/formats/mdf4_writer.h"
#include "devices/formats/recording_file.h"
#include "devices/recording/recording_csv.h"
#include "devices/recording/recording_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::devices {

namespace {

bool endsWith(const std::string& text, std::string_view ending) {
    return text.size() > ending.size() &&
           text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// What can be written; `suffix` is that of a working file, where the format has one.
using Writer = Result<void> (*)(const std::string& path, const Recording& recording, RecordingMeta meta,
                                const std::string& suffix);

/// By the ending of the name; nullptr when it is none of ours.
Writer writerFor(const std::string& path) {
    if (endsWith(path, ".csv")) {
        return writeExactRecordingFile;
    }
    if (isMdf4Recording(path)) {
        return [](const std::string& file, const Recording& recording, RecordingMeta meta,
                  const std::string&) { return writeMdf4File(file, recording, std::move(meta)); };
    }
    if (endsWith(path, ".mat")) {
        return [](const std::string& file, const Recording& recording, RecordingMeta meta,
                  const std::string&) { return writeMatFile(file, recording, std::move(meta)); };
    }
    return nullptr;
}

Result<void> checkWritten(const std::string& path) {
    return writerFor(path) != nullptr
               ? Result<void>()
               : failure(ErrorCode::Usage, fmt::format("'{}' has a format that cannot be written", path),
                         "this version writes .csv, .mf4 and .mat");
}

Result<void> checkFormats(const ConvertRequest& request) {
    const std::string& input = request.input;
    if (!endsWith(input, ".csv") && !isPartialRecording(input) && !isMdf4Recording(input)) {
        return failure(ErrorCode::Usage, fmt::format("'{}' has a format that cannot be read", input),
                       "this version reads .csv, .mf4 and .csv.partial (an interrupted recording)");
    }
    return checkWritten(request.output);
}

struct Source {
    RecordedFile file;
    std::optional<Recovery> recovery;
};

Result<Source> readSource(const std::string& path, const std::function<Result<void>()>& checkAbort) {
    if (!isPartialRecording(path)) {
        Result<RecordedFile> file = readRecordingFile(path, checkAbort);
        return file ? Result<Source>(Source{*std::move(file), {}}) : failure(file.error());
    }
    Result<PartialRecording> partial = readPartialRecording(path);
    if (!partial) {
        return failure(partial.error());
    }
    const Recording& recording = partial->file.recording;
    const Recovery recovery{recording.rows(), recording.time_s.back() - recording.time_s.front(),
                            partial->cutOctets, partial->damagedOctets, partial->uncheckedRows};
    return Source{std::move(partial->file), recovery};
}

Result<std::vector<std::size_t>> columnsOf(const StreamLayout& layout,
                                           const std::vector<std::string>& signals) {
    std::vector<std::size_t> columns;
    if (signals.empty()) {
        for (std::size_t i = 0; i < layout.columns.size(); ++i) {
            columns.push_back(i);
        }
        return columns;
    }
    for (const std::string& signal : signals) {
        const auto named = [&](const auto& nameOf) {
            return std::find_if(layout.columns.begin(), layout.columns.end(),
                                [&](const StreamLayout::Column& column) { return nameOf(column) == signal; });
        };
        auto found = named([](const StreamLayout::Column& column) { return column.name; });
        if (found == layout.columns.end()) { // a.b and a_b have columns that are alike: names come first
            found = named(
                [](const StreamLayout::Column& column) { return csvColumnName(column.name, column.unit); });
        }
        if (found == layout.columns.end()) {
            std::vector<std::string> known;
            for (const StreamLayout::Column& column : layout.columns) {
                known.push_back(column.name);
            }
            return failure(ErrorCode::UnknownName, fmt::format("the recording has no signal '{}'", signal),
                           fmt::format("available: {}", fmt::join(known, ", ")));
        }
        columns.push_back(static_cast<std::size_t>(found - layout.columns.begin()));
    }
    return columns;
}

RecordingMeta partMeta(RecordingMeta meta, const StreamLayout& layout) {
    meta.gaps.clear();          // found again while writing
    meta.automaticName.clear(); // somebody asked for this file
    std::vector<RecordingMeta::SignalNote> notes;
    for (const StreamLayout::Column& column : layout.columns) {
        const std::string header = csvColumnName(column.name, column.unit);
        const auto known = std::find_if(meta.signals.begin(), meta.signals.end(), [&](const auto& note) {
            return note.name == column.name && note.unit == column.unit;
        });
        notes.push_back(known != meta.signals.end()
                            ? *known
                            : RecordingMeta::SignalNote{column.name, header, column.unit, {}, {}});
    }
    meta.signals = std::move(notes);
    return meta;
}

/// What lies outside the interval says nothing of what is kept.
void cutMarkers(const ConvertRequest& request, RecordingMeta& meta) {
    std::erase_if(meta.markers, [&](const RecordingMeta::Marker& marker) {
        return (request.from_s && marker.time_s < *request.from_s) ||
               (request.to_s && marker.time_s >= *request.to_s);
    });
}

void noteExpressions(const std::vector<DerivedSignal>& derived, RecordingMeta& meta) {
    for (RecordingMeta::SignalNote& note : meta.signals) {
        for (const DerivedSignal& one : derived) {
            note.expression = note.name == one.name ? one.expression : note.expression;
        }
    }
}

} // namespace

std::vector<std::string> withNamesOf(std::vector<std::string> signals,
                                     const std::vector<DerivedSignal>& derived) {
    for (const DerivedSignal& one : derived) {
        if (!signals.empty() && std::find(signals.begin(), signals.end(), one.name) == signals.end()) {
            signals.push_back(one.name);
        }
    }
    return signals;
}

Result<Recording> selectPart(const Recording& recording, const std::vector<std::string>& signals,
                             std::optional<double> from_s, std::optional<double> to_s) {
    const double begin_s = from_s.value_or(-std::numeric_limits<double>::infinity());
    const double end_s = to_s.value_or(std::numeric_limits<double>::infinity());
    if (std::isnan(begin_s) || std::isnan(end_s)) {
        return failure(ErrorCode::NotFinite, "the interval needs numbers", "give seconds, e.g. --from 1.5");
    }
    const Result<std::vector<std::size_t>> columns = columnsOf(*recording.layout, signals);
    if (!columns) {
        return failure(columns.error());
    }
    StreamLayout layout;
    layout.period_s = recording.layout->period_s;
    for (const std::size_t column : *columns) {
        layout.columns.push_back(recording.layout->columns[column]);
    }
    Recording part;
    const std::size_t width = recording.layout->columns.size();
    for (std::size_t row = 0; row < recording.rows(); ++row) {
        if (recording.time_s[row] < begin_s || recording.time_s[row] >= end_s) {
            continue;
        }
        part.time_s.push_back(recording.time_s[row]);
        for (const std::size_t column : *columns) {
            part.values.push_back(recording.values[row * width + column]);
        }
    }
    if (part.time_s.empty()) {
        return failure(ErrorCode::OutOfRange, "the recording has no rows in this interval",
                       recording.time_s.empty()
                           ? std::string("it has no rows")
                           : fmt::format("its range is {} s to {} s", recording.time_s.front(),
                                         recording.time_s.back()));
    }
    part.layout = std::make_shared<const StreamLayout>(std::move(layout));
    part.rates = recording.rates;
    return part;
}

Result<void> exportRecording(const std::string& path, const Recording& recording, RecordingMeta meta) {
    const Result<void> known = checkWritten(path);
    return known ? writerFor(path)(path, recording, std::move(meta), ".partial") : known;
}

Result<Conversion> convertRecording(const ConvertRequest& request,
                                    const std::function<Result<void>()>& checkAbort) {
    if (const Result<void> formats = checkFormats(request); !formats) {
        return failure(formats.error());
    }
    Result<Source> source = readSource(request.input, checkAbort);
    if (!source) {
        return failure(source.error());
    }
    Result<Recording> longer = withDerived(std::move(source->file.recording), request.derived);
    if (!longer) {
        return failure(longer.error());
    }
    const Result<Recording> part =
        selectPart(*longer, withNamesOf(request.signals, request.derived), request.from_s, request.to_s);
    if (!part) {
        return failure(part.error());
    }
    RecordingMeta meta = partMeta(std::move(source->file.meta), *part->layout);
    noteExpressions(request.derived, meta);
    cutMarkers(request, meta);
    // An interrupted recording that gets its name back is no working file of this conversion.
    const bool isItsOwn = request.input == partialPathOf(request.output);
    const Result<void> written = writerFor(request.output)(request.output, *part, std::move(meta),
                                                           isItsOwn ? ".recovering" : ".partial");
    if (!written) {
        return failure(written.error());
    }
    const bool isWhole = request.signals.empty() && !request.from_s && !request.to_s;
    const bool isDamaged = source->recovery && source->recovery->damagedOctets > 0;
    if (isItsOwn && isWhole && !isDamaged) {
        retirePartialRecording(request.input, false);
    }
    return Conversion{part->rows(), source->recovery, std::move(source->file.warnings)};
}

} // namespace halbench::devices
