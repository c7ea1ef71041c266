#pragma once

#include "control/base/result.h"
#include "control/base/sample_block.h"
#include "devices/acquisition/derived_signals.h"
#include "devices/recording/recording_meta.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace halbench::devices {

/// What `halbench convert` was asked for.
struct ConvertRequest {
    std::string input;
    std::string output;
    std::vector<std::string> signals; ///< names or columns; empty = all; derived ones are always there
    std::optional<double> from_s;     ///< first time kept
    std::optional<double> to_s;       ///< first time not kept
    std::vector<DerivedSignal> derived = {};
};

/// The signals asked for (none: all) and those derived that are not among them.
std::vector<std::string> withNamesOf(std::vector<std::string> signals,
                                     const std::vector<DerivedSignal>& derived);

/// Rows of [from, to) and the signals asked for, in their order; the time axis stays as recorded.
/// Errors: UnknownName (signal), OutOfRange (no rows in the interval), NotFinite.
Result<Recording> selectPart(const Recording& recording, const std::vector<std::string>& signals,
                             std::optional<double> from_s, std::optional<double> to_s);

/// How much of an interrupted recording was there.
struct Recovery {
    std::size_t rows = 0;
    double duration_s = 0.0;         ///< from the first row to the last
    std::uint64_t cutOctets = 0;     ///< behind the last whole row
    std::uint64_t damagedOctets = 0; ///< left out: their checksum does not fit, or they are no row
    std::size_t uncheckedRows = 0;   ///< the last ones, which no checksum covers
};

struct Conversion {
    std::size_t rows = 0;                   ///< written
    std::optional<Recovery> recovery;       ///< when the input was an interrupted recording
    std::vector<std::string> warnings = {}; ///< of the input, e.g. it was changed since it was recorded
};

/// Reads, selects, writes. Formats go by the file's ending; this version reads .csv, .mf4 and .csv.partial,
/// what an interrupted recording is called, and writes .csv, .mf4 and .mat. The input stays as it is, except
/// that `run.csv.partial` is gone once all of it has become `run.csv`; where octets inside it were damaged it
/// stays. Errors: Usage (format), FileSystem, InvalidInput, those above and of withDerived(); that of
/// `checkAbort`, which is asked while the input is read.
Result<Conversion> convertRecording(const ConvertRequest& request,
                                    const std::function<Result<void>()>& checkAbort = {});

/// What is already in memory, in the format that the file's ending names, every number in all its digits.
/// Errors: Usage (format), FileSystem.
Result<void> exportRecording(const std::string& path, const Recording& recording, RecordingMeta meta);

} // namespace halbench::devices
