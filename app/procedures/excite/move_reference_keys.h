#pragma once

#include "app/procedures/excite/move_reference.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

/// One key of a reference as written on the command line or in an experiment.
struct MoveReferenceKey {
    std::string_view key;  ///< e.g. "amplitude_deg"
    std::string_view help; ///< one sentence
};
std::span<const MoveReferenceKey> moveReferenceKeys();
/// Separated by commas.
std::string moveReferenceKeyNames();

/// A number that a path or table takes; its keys begin with the stem: radius_m, radius_mm ...
struct ReferenceSetting {
    std::string_view stem;
    /// Where the shape has it for lengths and for angles; else unknown.
    MoveReference::Quantity quantity = MoveReference::Quantity::Unknown;

    bool operator==(const ReferenceSetting&) const = default;
};
/// In the order in which they are asked for; nothing of other shapes than paths and tables.
std::vector<ReferenceSetting> settingsOf(MoveReference::Shape shape);

/// Its key in SI, with the limits and the words of the table of keys.
struct SettingSpec {
    std::string_view key;
    std::string_view help; ///< one sentence without its capital
    std::string unit;      ///< SI; empty: a count
    double min = 0.0;
    double max = 0.0;
    bool isWhole = false;
};
SettingSpec settingSpec(const ReferenceSetting& setting);

/// The key of a table's file, whose value is a text.
constexpr std::string_view FileKey = "file";
/// Errors: InvalidInput (another shape than a table).
Result<void> setMoveReferenceFile(MoveReference& reference, std::string_view path);

/// Sets one key: amplitude, rate and base with their unit (amplitude_deg, rate_um_s ...), frequency_hz,
/// frequency_end_hz, period_s (of a sine: 1/frequency; of a staircase: time of one step), count, seed; of
/// travels and paths acceleration, jerk, radius, width, pitch with their unit, turns, lines; of
/// tables dwell_s. Set the shape first. Errors: UnknownName (hint lists the keys), NotFinite, OutOfRange,
/// InvalidInput (a length beside an angle).
Result<void> setMoveReference(MoveReference& reference, std::string_view key, double value);

} // namespace halbench::app
