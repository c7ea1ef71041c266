#pragma once

#include "devices/formats/recording_file.h"
#include "devices/recording/file_access.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// What counts as the same moment in every run.
struct RunAlignment {
    enum class Moment {
        Start,   ///< the first row
        Trigger, ///< the first marker "trigger"; without one "record", where Record was pressed
        Marker   ///< the first marker with this text
    };
    Moment moment = Moment::Start;
    std::string marker;
};

/// A run to lay over others.
struct ComparedRun {
    std::string name;
    Recording recording;
    devices::RecordingMeta meta;
    std::shared_ptr<const devices::FileHold> hold = {}; ///< of the file it came from
    std::vector<std::string> warnings = {};             ///< of its reading (devices::RecordedFile)
};

/// Runs that were read to be compared, and why others were not.
struct ReadRuns {
    std::vector<ComparedRun> runs; ///< in the order asked for
    std::vector<Error> refused;
};
/// What is kept of all runs together, in numbers.
constexpr std::size_t MostComparedValues = std::size_t{64} << 20;
/// Reads recordings one after the other; what no more fits into `mostValues` is refused, the first never. For
/// a thread of its own: `checkAbort` ends it soon.
ReadRuns readRuns(const std::vector<std::string>& paths, const std::function<Result<void>()>& checkAbort = {},
                  std::size_t mostValues = MostComparedValues);

/// Time of that moment on the run's own axis; nothing when it has none.
std::optional<double> alignedZero_s(const ComparedRun& run, const RunAlignment& alignment);

/// Signals that all of them have, in the order of the first.
std::vector<std::string> commonSignals(const std::vector<ComparedRun>& runs);
/// Texts of markers that all of them have.
std::vector<std::string> commonMarkers(const std::vector<ComparedRun>& runs);

/// The sample nearest to a time after the moment, not farther away than 1.5 periods; nothing in a gap,
/// outside, or when it is no number. In SI.
std::optional<double> valueAt(const ComparedRun& run, const std::string& signal, double zero_s,
                              double time_s);

} // namespace halbench::app
