#pragma once

#include "app/analyses/analysis_plot.h"
#include "app/documents/text/json_value.h"
#include "app/procedures/base/procedure.h"
#include "devices/formats/recording_file.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

enum class AnalysisKeyType { Text, Number, Integer, Choice, Flag };

/// One setting of an analysis: the option `--noise-uT` of its command and the key `noise_uT` of its step.
struct AnalysisKey {
    std::string_view name; ///< with '_'
    AnalysisKeyType type = AnalysisKeyType::Number;
    double min = 0.0;
    double max = 0.0;
    std::string_view choices{}; ///< separated by '|'; the first one is the default
    std::string_view help{};
};

/// The settings that were given, judged by the table of keys.
struct AnalysisValues {
    std::map<std::string, double, std::less<>> numbers;
    std::map<std::string, std::string, std::less<>> texts;
    std::map<std::string, bool, std::less<>> flags;
    /// Values that an earlier step of a run found, when the text `calibration` names it.
    std::optional<std::vector<ParameterValue>> calibrated;
    /// Those of AnalysisDevice::parameters when a device is named, or as a recording notes them: settings
    /// that are not given are its own.
    std::optional<std::vector<ParameterValue>> device;

    std::optional<double> number(std::string_view key) const;
    double numberOr(std::string_view key, double value) const { return number(key).value_or(value); }
    /// Empty when it was not given.
    std::string text(std::string_view key) const;
    bool isSet(std::string_view key) const;
};

/// How a long analysis is watched and ended. `isStopped` is asked from several threads.
struct AnalysisControl {
    std::function<bool()> isStopped;
    std::function<void(double)> onProgress;
    std::function<double()> now_s = {}; ///< a running time; empty: nothing is timed
};

/// A table that goes into a CSV file.
struct AnalysisTable {
    std::vector<std::string> columns;
    std::vector<double> values; ///< row by row; NaN is an empty field
};
std::string analysisCsv(const AnalysisTable& table);

struct AnalysisOutcome {
    DataQuality quality;
    JsonValue body = JsonValue::object();
    std::string summary;                ///< for people
    std::optional<AnalysisTable> table; ///< written by `--out FILE.csv`
    std::vector<AnalysisPlot> plots;    ///< in the report of a run, and for `--picture`
    /// How long it took on this machine: said on the terminal, never in a result, which equal seeds repeat.
    std::string timing = {};
};

/// The part of an analysis that a device can give in place of settings or a recording.
struct AnalysisDevice {
    std::string_view hint; ///< which devices are meant, for the message that refuses another one
    std::vector<std::string> parameters;
    /// Recorded when a recording is required; of the second list what the device has.
    std::vector<std::string> (*signals)(const AnalysisValues& values) = nullptr;
    std::vector<std::string> extraSignals = {};
};

enum class RecordingUse { None, Optional, Required };

/// A computation of one actuator that needs no device: a command and a kind of experiment step. This table is
/// the only place that knows its settings.
struct Analysis {
    std::string_view name;   ///< "orient": command and kind of step
    std::string_view schema; ///< "halbench.orientation/1"
    std::string_view help;
    RecordingUse recording = RecordingUse::None;
    bool writesTable = false; ///< --out takes the table; else the result
    std::vector<AnalysisKey> keys;
    /// `file` is the recording, `origin` names it in messages.
    Result<AnalysisOutcome> (*run)(const AnalysisValues& values, const devices::RecordedFile* file,
                                   const std::string& origin, const AnalysisControl& control) = nullptr;
    std::optional<AnalysisDevice> device = {}; ///< nothing: it takes no device
    bool hasPicture = false;                   ///< `--picture` draws its plots
};

/// "noise_uT" -> "--noise-uT"
std::string optionOf(const AnalysisKey& key);

/// Judges settings as written on a command line. Errors: Usage, OutOfRange, NotFinite, naming the option.
Result<AnalysisValues> parseAnalysisValues(const Analysis& analysis,
                                           const std::map<std::string, std::string>& texts,
                                           const std::map<std::string, bool>& flags);

} // namespace halbench::app
