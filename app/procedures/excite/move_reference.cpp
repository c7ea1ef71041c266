#include "app/procedures/excite/move_reference.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace halbench::app {
namespace {

constexpr std::array<std::string_view, 6> ShapeNames = {"step",      "ramp",  "sine",
                                                        "staircase", "chirp", "multisine"};

// What the board's generator takes; resources/help/protocol.md 3.15.
constexpr double LargestAngle_rad = 10000.0;
constexpr double LargestSpeed_rad_s = 1000.0;
constexpr double LargestLength_m = 1000.0;
constexpr double LargestSpeed_m_s = 1000.0;
constexpr double LargestFrequency_Hz = 200.0;

using Quantity = MoveReference::Quantity;

struct Key {
    MoveReferenceKey text;
    double min;
    double max;
    bool isWhole;
    void (*set)(MoveReference&, double);
    double perUnit = 1.0; ///< what is set for a value of one
    Quantity quantity = Quantity::Unknown;
};

void setAmplitude(MoveReference& reference, double amplitude) {
    reference.amplitude = amplitude;
}

void setRate(MoveReference& reference, double rate) {
    reference.rate = rate;
}

void setBase(MoveReference& reference, double base) {
    reference.base = base;
}

void setPeriod(MoveReference& reference, double period_s) {
    reference.period_s = period_s;
    if (reference.shape == MoveReference::Shape::Sine) {
        reference.frequency_Hz = 1.0 / period_s;
    }
}

constexpr double Degree_rad = Pi / 180.0;

constexpr Key amplitudeKey(std::string_view key, std::string_view help, Quantity quantity, double perUnit) {
    const double largest = (quantity == Quantity::Angle ? LargestAngle_rad : LargestLength_m) / perUnit;
    return {{key, help}, -largest, largest, false, setAmplitude, perUnit, quantity};
}

constexpr Key speedKey(std::string_view key, std::string_view help, Quantity quantity, double perUnit,
                       void (*set)(MoveReference&, double)) {
    const double largest = (quantity == Quantity::Angle ? LargestSpeed_rad_s : LargestSpeed_m_s) / perUnit;
    return {{key, help}, -largest, largest, false, set, perUnit, quantity};
}

const std::array Keys = {
    amplitudeKey("amplitude_deg",
                 "height of the step or of one stair, amplitude of sine and chirp, rms of a multisine",
                 Quantity::Angle, Degree_rad),
    amplitudeKey("amplitude_rad", "the same in radians", Quantity::Angle, 1.0),
    amplitudeKey("amplitude_mrad", "the same in milliradians", Quantity::Angle, 1e-3),
    amplitudeKey("amplitude_urad", "the same in microradians", Quantity::Angle, 1e-6),
    amplitudeKey("amplitude_m", "the same of an axis that moves along a line", Quantity::Length, 1.0),
    amplitudeKey("amplitude_mm", "the same in millimetres", Quantity::Length, 1e-3),
    amplitudeKey("amplitude_um", "the same in micrometres", Quantity::Length, 1e-6),
    speedKey("rate_deg_s", "slope of a ramp", Quantity::Angle, Degree_rad, setRate),
    speedKey("rate_rad_s", "the same in radians", Quantity::Angle, 1.0, setRate),
    speedKey("rate_mrad_s", "the same in milliradians", Quantity::Angle, 1e-3, setRate),
    speedKey("rate_urad_s", "the same in microradians", Quantity::Angle, 1e-6, setRate),
    speedKey("rate_m_s", "the same of an axis that moves along a line", Quantity::Length, 1.0, setRate),
    speedKey("rate_mm_s", "the same in millimetres", Quantity::Length, 1e-3, setRate),
    speedKey("rate_um_s", "the same in micrometres", Quantity::Length, 1e-6, setRate),
    Key{{"frequency_hz", "of a sine; the first one of chirp and multisine"},
        0.0,
        LargestFrequency_Hz,
        false,
        [](MoveReference& r, double v) { r.frequency_Hz = v; }},
    Key{{"frequency_end_hz", "the last one of chirp and multisine"},
        0.0,
        LargestFrequency_Hz,
        false,
        [](MoveReference& r, double v) { r.frequencyEnd_Hz = v; }},
    Key{{"period_s", "of a sine: 1/frequency; of a staircase: time of one step"},
        0.005,
        3600.0,
        false,
        setPeriod},
    Key{{"count", "steps of a staircase, lines of a multisine"},
        1.0,
        1000.0,
        true,
        [](MoveReference& r, double v) { r.count = static_cast<int>(v); }},
    speedKey("base_deg_s", "constant motion added", Quantity::Angle, Degree_rad, setBase),
    speedKey("base_rad_s", "the same in radians", Quantity::Angle, 1.0, setBase),
    speedKey("base_mrad_s", "the same in milliradians", Quantity::Angle, 1e-3, setBase),
    speedKey("base_urad_s", "the same in microradians", Quantity::Angle, 1e-6, setBase),
    speedKey("base_m_s", "the same of an axis that moves along a line", Quantity::Length, 1.0, setBase),
    speedKey("base_mm_s", "the same in millimetres", Quantity::Length, 1e-3, setBase),
    speedKey("base_um_s", "the same in micrometres", Quantity::Length, 1e-6, setBase),
    Key{{"seed", "phases of a multisine; 0: those of least peak"},
        0.0,
        4294967295.0,
        true,
        [](MoveReference& r, double v) { r.seed = static_cast<std::uint32_t>(v); }},
};

std::string knownKeys() {
    std::string keys;
    for (const Key& key : Keys) {
        keys += (keys.empty() ? "" : ", ") + std::string(key.text.key);
    }
    return keys;
}

Result<void> need(bool isThere, MoveReference::Shape shape, const char* key) {
    if (isThere) {
        return {};
    }
    return failure(ErrorCode::InvalidInput, fmt::format("a {} needs {}", moveShapeName(shape), key),
                   fmt::format("Add {}=... to the reference.", key));
}

Result<void> applyPair(MoveReference& reference, std::string_view pair) {
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == pair.size()) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' is not KEY=VALUE", pair),
                       "Write a reference like step,amplitude_deg=100. Known keys: " + knownKeys() + ".");
    }
    const std::string_view text = pair.substr(equals + 1);
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, value);
    if (status != std::errc() || stop != end) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' is not a number", text),
                       fmt::format("Write {}=1.5.", pair.substr(0, equals)));
    }
    return setMoveReference(reference, pair.substr(0, equals), value);
}

} // namespace

std::span<const MoveReferenceKey> moveReferenceKeys() {
    static const auto texts = [] {
        std::array<MoveReferenceKey, Keys.size()> all;
        std::transform(Keys.begin(), Keys.end(), all.begin(), [](const Key& key) { return key.text; });
        return all;
    }();
    return texts;
}

std::span<const std::string_view> moveShapeNames() {
    return ShapeNames;
}

std::string_view moveShapeName(MoveReference::Shape shape) {
    return ShapeNames[static_cast<std::size_t>(shape) - 1];
}

Result<MoveReference::Shape> moveShape(std::string_view name) {
    const auto found = std::find(ShapeNames.begin(), ShapeNames.end(), name);
    if (found == ShapeNames.end()) {
        return failure(ErrorCode::UnknownName, fmt::format("there is no reference shape '{}'", name),
                       fmt::format("Known shapes: {}.", fmt::join(ShapeNames, ", ")));
    }
    return static_cast<MoveReference::Shape>(found - ShapeNames.begin() + 1);
}

Result<void> setMoveReference(MoveReference& reference, std::string_view name, double value) {
    const auto key = std::find_if(Keys.begin(), Keys.end(), [&](const Key& k) { return k.text.key == name; });
    if (key == Keys.end()) {
        return failure(ErrorCode::UnknownName, fmt::format("a reference has no key '{}'", name),
                       "Known keys: " + knownKeys() + ".");
    }
    if (!std::isfinite(value)) {
        return failure(ErrorCode::NotFinite, fmt::format("{} is not a finite number", name),
                       fmt::format("Allowed: {} to {}.", key->min, key->max));
    }
    if (value < key->min || value > key->max || (key->isWhole && value != std::floor(value))) {
        return failure(
            ErrorCode::OutOfRange, fmt::format("{} = {} is out of range", name, value),
            fmt::format("Allowed: {} to {}{}.", key->min, key->max, key->isWhole ? ", whole numbers" : ""));
    }
    if (key->quantity != Quantity::Unknown) {
        if (reference.quantity != Quantity::Unknown && reference.quantity != key->quantity) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{} does not go with the other keys: a length beside an angle", name),
                           "Give the whole reference in angles or in lengths.");
        }
        reference.quantity = key->quantity;
    }
    key->set(reference, value * key->perUnit);
    return {};
}

Result<MoveReference> parseMoveReference(const std::string& text) {
    const std::size_t firstComma = std::min(text.find(','), text.size());
    const auto shape = moveShape(std::string_view(text).substr(0, firstComma));
    if (!shape) {
        return failure(shape.error());
    }
    MoveReference reference;
    reference.shape = *shape;
    std::string_view rest = std::string_view(text).substr(std::min(firstComma + 1, text.size()));
    std::vector<std::string_view> seen;
    while (!rest.empty()) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        const std::string_view pair = rest.substr(0, comma);
        const std::string_view key = pair.substr(0, pair.find('='));
        if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
            return failure(ErrorCode::InvalidInput, fmt::format("reference: '{}' is given twice", key),
                           "give every key once");
        }
        seen.push_back(key);
        if (auto applied = applyPair(reference, pair); !applied) {
            return failure(applied.error());
        }
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    if (auto complete = checkMoveReference(reference); !complete) {
        return failure(complete.error());
    }
    return reference;
}

Result<void> checkMoveReference(const MoveReference& reference) {
    using Shape = MoveReference::Shape;
    const bool hasAmplitude = reference.amplitude != 0.0;
    switch (reference.shape) {
    case Shape::Step:
    case Shape::Staircase:
        return need(hasAmplitude, reference.shape, "amplitude_deg");
    case Shape::Ramp:
        return need(reference.rate != 0.0, reference.shape, "rate_deg_s");
    case Shape::Sine:
        if (auto amplitude = need(hasAmplitude, reference.shape, "amplitude_deg"); !amplitude) {
            return amplitude;
        }
        return need(reference.frequency_Hz > 0.0, reference.shape, "frequency_hz");
    case Shape::Chirp:
    case Shape::Multisine:
        if (auto amplitude = need(hasAmplitude, reference.shape, "amplitude_deg"); !amplitude) {
            return amplitude;
        }
        if (auto first = need(reference.frequency_Hz > 0.0, reference.shape, "frequency_hz"); !first) {
            return first;
        }
        return need(reference.frequencyEnd_Hz > 0.0, reference.shape, "frequency_end_hz");
    }
    return {};
}

Result<void> checkQuantity(const MoveReference& reference, const devices::AxisSpec& axis) {
    const bool isAngle = axis.positionUnit == "rad";
    const Quantity wanted = isAngle ? Quantity::Angle : Quantity::Length;
    if (reference.quantity == Quantity::Unknown || reference.quantity == wanted) {
        return {};
    }
    return failure(ErrorCode::InvalidInput,
                   isAngle
                       ? fmt::format("axis {} turns, and the reference is a length", axis.id)
                       : fmt::format("axis {} moves along a line, and the reference is an angle", axis.id),
                   isAngle ? "Write it as an angle, e.g. amplitude_mrad=1 or amplitude_deg=1."
                           : "Write it as a length, e.g. amplitude_um=100 or amplitude_mm=1.");
}

double referenceExcursion(const MoveReference& reference, double duration_s) {
    using Shape = MoveReference::Shape;
    double excursion = std::fabs(reference.amplitude);
    if (reference.shape == Shape::Ramp) {
        const double reached = std::fabs(reference.rate) * duration_s;
        excursion = reference.amplitude == 0.0 ? reached : std::min(excursion, reached);
    } else if (reference.shape == Shape::Staircase) {
        excursion *=
            std::min(1.0 + std::floor(duration_s / reference.period_s), static_cast<double>(reference.count));
    } else if (reference.shape == Shape::Multisine) {
        excursion *= std::sqrt(2.0 * reference.count); // all lines at their peak together
    }
    return excursion + std::fabs(reference.base) * duration_s;
}

std::optional<double> referenceAt(const MoveReference& reference, double time_s) {
    using Shape = MoveReference::Shape;
    const double base = reference.base * time_s;
    switch (reference.shape) {
    case Shape::Step:
        return reference.amplitude + base;
    case Shape::Ramp: {
        const double end = std::fabs(reference.amplitude);
        const double ramp = reference.rate * time_s;
        return (end > 0.0 ? std::clamp(ramp, -end, end) : ramp) + base;
    }
    case Shape::Sine:
        return reference.amplitude * std::sin(2.0 * Pi * reference.frequency_Hz * time_s) + base;
    case Shape::Staircase: {
        const double steps = 1.0 + std::floor(time_s / reference.period_s + 1e-9);
        return reference.amplitude * std::min(steps, static_cast<double>(reference.count)) + base;
    }
    case Shape::Chirp:
    case Shape::Multisine:
        break;
    }
    return std::nullopt;
}

std::vector<ParameterValue> generatorParameters(const MoveReference& reference, double duration_s,
                                                const std::string& generator) {
    using Shape = MoveReference::Shape;
    const bool isSwept = reference.shape == Shape::Chirp || reference.shape == Shape::Multisine;
    // A second more, so that the generator does not end while the last samples are on their way.
    const double generator_s = isSwept ? duration_s : duration_s + 1.0;
    return {{generator + ".shape", static_cast<double>(reference.shape)},
            {generator + ".amplitude", reference.amplitude},
            {generator + ".rate", reference.rate},
            {generator + ".frequency", reference.frequency_Hz},
            {generator + ".frequency_end", reference.frequencyEnd_Hz},
            {generator + ".period", reference.period_s},
            {generator + ".count", static_cast<double>(reference.count)},
            {generator + ".duration", generator_s},
            {generator + ".base", reference.base},
            {generator + ".seed", static_cast<double>(reference.seed)}};
}

std::optional<control::LoopReference> idealReference(const MoveReference& reference) {
    using Shape = MoveReference::Shape;
    control::LoopReference ideal{control::LoopReference::Shape::Step,
                                 reference.amplitude,
                                 reference.rate,
                                 reference.frequency_Hz,
                                 reference.period_s,
                                 reference.count};
    switch (reference.shape) {
    case Shape::Step:
        break;
    case Shape::Ramp:
        ideal.shape = control::LoopReference::Shape::Ramp;
        break;
    case Shape::Sine:
        ideal.shape = control::LoopReference::Shape::Sine;
        break;
    case Shape::Staircase:
        ideal.shape = control::LoopReference::Shape::Staircase;
        break;
    case Shape::Chirp:
    case Shape::Multisine:
        return std::nullopt;
    }
    return reference.base == 0.0 ? std::optional(ideal) : std::nullopt;
}

} // namespace halbench::app
