#pragma once

#include "control/base/parameter_spec.h"
#include "control/base/result.h"
#include "devices/axis_spec.h"
#include "models/htm/htm_ideal_loop.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

/// The reference that the board's generator follows on one axis, relative to where that is when it is armed
/// (resources/help/htm-theory.md section 8, resources/help/command-line.md). Positions are in the axis's
/// unit, rad or m.
struct MoveReference {
    enum class Shape { Step = 1, Ramp, Sine, Staircase, Chirp, Multisine }; ///< codes of reference.shape
    enum class Quantity { Unknown, Angle, Length };
    Shape shape = Shape::Step;
    double amplitude = 0.0;
    double rate = 0.0; ///< per second
    double frequency_Hz = 0.0;
    double frequencyEnd_Hz = 0.0;
    double period_s = 1.0; ///< staircase: time of one step
    int count = 1;         ///< staircase: steps; multisine: lines
    double base = 0.0;     ///< per second
    std::uint32_t seed = 0;
    Quantity quantity = Quantity::Unknown; ///< that the keys were written in
};

/// One key of a reference as written on the command line or in an experiment.
struct MoveReferenceKey {
    std::string_view key;  ///< e.g. "amplitude_deg"
    std::string_view help; ///< one sentence
};
std::span<const MoveReferenceKey> moveReferenceKeys();
/// "step", "ramp", "sine", "staircase", "chirp", "multisine"
std::span<const std::string_view> moveShapeNames();
std::string_view moveShapeName(MoveReference::Shape shape);

/// Errors: UnknownName; the hint lists the shapes.
Result<MoveReference::Shape> moveShape(std::string_view name);
/// Sets one key: amplitude, rate and base with their unit (amplitude_deg, rate_um_s ...), frequency_hz,
/// frequency_end_hz, period_s (of a sine: 1/frequency; of a staircase: time of one step), count, seed.
/// Set the shape first. Errors: UnknownName (hint lists the keys), NotFinite, OutOfRange, InvalidInput (a
/// length beside an angle).
Result<void> setMoveReference(MoveReference& reference, std::string_view key, double value);
/// "step,amplitude_deg=100" of the command line. Errors: as above, InvalidInput.
Result<MoveReference> parseMoveReference(const std::string& text);
/// Checks a reference: a figure that its shape needs and does not have, e.g. a sine without a frequency.
/// Errors: InvalidInput, OutOfRange.
Result<void> checkMoveReference(const MoveReference& reference);
/// An angle for an axis that moves along a line, or a length for one that turns. Error: InvalidInput.
Result<void> checkQuantity(const MoveReference& reference, const devices::AxisSpec& axis);

/// The largest excursion from the start that the reference asks for within the time.
double referenceExcursion(const MoveReference& reference, double duration_s);
/// What the board's generator makes of it at a time from its start; nothing for chirp and multisine.
std::optional<double> referenceAt(const MoveReference& reference, double time_s);
/// Values of the board's generator parameters, reference.start not included; `generator` begins their names.
std::vector<ParameterValue> generatorParameters(const MoveReference& reference, double duration_s,
                                                const std::string& generator = "reference");
/// The same reference for the ideal loop; nothing for chirp and multisine or when base is not zero.
std::optional<control::LoopReference> idealReference(const MoveReference& reference);

} // namespace halbench::app
