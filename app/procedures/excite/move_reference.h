#pragma once

#include "control/base/parameter_spec.h"
#include "control/base/result.h"
#include "devices/axis_spec.h"
#include "models/htm/htm_ideal_loop.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halbench::app {

struct TabledMotion;

/// The reference that the board's generator follows on one axis, relative to where that is when it is armed
/// (resources/help/htm-theory.md section 8, resources/help/command-line.md). Positions are in the axis's
/// unit, rad or m.
struct MoveReference {
    /// Codes of reference.shape up to SCurve. Trapezoid and SCurve are travels from rest to rest; Circle,
    /// Raster, Arc and Line are paths of two axes, Table one of any number of them; at Rest the axis stays
    /// where it is, so that its noise can be measured.
    enum class Shape {
        Step = 1,
        Ramp,
        Sine,
        Staircase,
        Chirp,
        Multisine,
        Trapezoid = 8,
        SCurve,
        Circle,
        Raster,
        Arc,
        Line,
        Table,
        Rest
    };
    enum class Quantity { Unknown, Angle, Length };
    /// Limits of axes that turn, where a table moves axes of both kinds.
    struct Turning {
        double rate = 0.0;
        double acceleration = 0.0;
        std::optional<double> jerk = {};
    };
    Shape shape = Shape::Step;
    double amplitude =
        0.0; ///< distance of a travel, radius of circle and arc, width of a raster, length of a line
    double rate = 0.0; ///< per second; of travels and paths the largest
    double frequency_Hz = 0.0;
    double frequencyEnd_Hz = 0.0;
    double period_s = 1.0; ///< staircase: time of one step
    int count = 1;         ///< staircase: steps; multisine and raster: lines; circle: turns
    double base = 0.0;     ///< per second
    std::uint32_t seed = 0;
    double acceleration = 0.0;              ///< of travels and paths, the largest
    std::optional<double> jerk = {};        ///< of the S-curve; of a path, whose acceleration else jumps
    double pitch = 0.0;                     ///< raster: from line to line
    std::optional<double> angle_rad = {};   ///< of an arc, counter-clockwise
    std::optional<double> heading_rad = {}; ///< direction in which arc and line begin, from the first axis; 0
    Quantity quantity = Quantity::Unknown;  ///< that the keys were written in
    std::string file = {};                  ///< of a table
    double dwell_s = 0.0;                   ///< of a table without times, in every row but the last
    Turning turning = {};                   ///< of a table; rate, acceleration and jerk are of its lengths
    std::shared_ptr<const TabledMotion> table = {}; ///< of the file, once it was read (table_reference.h)
};

/// "step", "ramp", "sine", "staircase", "chirp", "multisine", "trapezoid", "s-curve", "circle", "raster",
/// "arc", "line", "table", "rest"
std::span<const std::string_view> moveShapeNames();
std::string_view moveShapeName(MoveReference::Shape shape);

/// Errors: UnknownName; the hint lists the shapes.
Result<MoveReference::Shape> moveShape(std::string_view name);
/// "step,amplitude_deg=100" of the command line. Errors: as above, InvalidInput.
Result<MoveReference> parseMoveReference(const std::string& text);
/// Checks a reference: a figure that its shape needs and does not have, e.g. a sine without a frequency.
/// Errors: InvalidInput, OutOfRange.
Result<void> checkMoveReference(const MoveReference& reference);
/// An angle for an axis that moves along a line, or a length for one that turns. Error: InvalidInput.
Result<void> checkQuantity(const MoveReference& reference, const devices::AxisSpec& axis);

/// The largest excursion from the start that the reference asks for within the time. `axis`: of a table, that
/// of one of its axes alone.
double referenceExcursion(const MoveReference& reference, double duration_s, std::string_view axis = {});
/// Output of the board's generator at a time from its start; nothing for chirp, multisine and the paths of
/// two axes. `axis`: which one of a table is meant.
std::optional<double> referenceAt(const MoveReference& reference, double time_s, std::string_view axis = {});
/// Values of the board's generator parameters, reference.start not included; `generator` begins their names.
std::vector<ParameterValue> generatorParameters(const MoveReference& reference, double duration_s,
                                                const std::string& generator = "reference");
/// The same reference for the ideal loop; nothing for other shapes than step, ramp, sine and staircase or
/// when base is not zero.
std::optional<control::LoopReference> idealReference(const MoveReference& reference);

} // namespace halbench::app
