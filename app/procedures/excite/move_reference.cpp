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
constexpr double LargestFrequency_Hz = 200.0;

struct Key {
    MoveReferenceKey text;
    double min;
    double max;
    bool isWhole;
    void (*set)(MoveReference&, double);
};

constexpr double Inf_deg = LargestAngle_rad * 180.0 / Pi;
constexpr double Rate_deg_s = LargestSpeed_rad_s * 180.0 / Pi;

void setPeriod(MoveReference& reference, double period_s) {
    reference.period_s = period_s;
    if (reference.shape == MoveReference::Shape::Sine) {
        reference.frequency_Hz = 1.0 / period_s;
    }
}

const std::array Keys = {
    Key{{"amplitude_deg",
         "height of the step or of one stair, amplitude of sine and chirp, rms of a multisine"},
        -Inf_deg,
        Inf_deg,
        false,
        [](MoveReference& r, double v) { r.amplitude_rad = degreesToRadians(v); }},
    Key{{"amplitude_rad", "the same in radians"},
        -LargestAngle_rad,
        LargestAngle_rad,
        false,
        [](MoveReference& r, double v) { r.amplitude_rad = v; }},
    Key{{"rate_deg_s", "slope of a ramp"},
        -Rate_deg_s,
        Rate_deg_s,
        false,
        [](MoveReference& r, double v) { r.rate_rad_s = degreesToRadians(v); }},
    Key{{"rate_rad_s", "the same in radians"},
        -LargestSpeed_rad_s,
        LargestSpeed_rad_s,
        false,
        [](MoveReference& r, double v) { r.rate_rad_s = v; }},
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
    Key{{"base_deg_s", "constant motion added"},
        -Rate_deg_s,
        Rate_deg_s,
        false,
        [](MoveReference& r, double v) { r.base_rad_s = degreesToRadians(v); }},
    Key{{"base_rad_s", "the same in radians"},
        -LargestSpeed_rad_s,
        LargestSpeed_rad_s,
        false,
        [](MoveReference& r, double v) { r.base_rad_s = v; }},
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
    key->set(reference, value);
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
    const bool hasAmplitude = reference.amplitude_rad != 0.0;
    switch (reference.shape) {
    case Shape::Step:
    case Shape::Staircase:
        return need(hasAmplitude, reference.shape, "amplitude_deg");
    case Shape::Ramp:
        return need(reference.rate_rad_s != 0.0, reference.shape, "rate_deg_s");
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

double referenceExcursion_rad(const MoveReference& reference, double duration_s) {
    using Shape = MoveReference::Shape;
    double excursion_rad = std::fabs(reference.amplitude_rad);
    if (reference.shape == Shape::Ramp) {
        const double reached_rad = std::fabs(reference.rate_rad_s) * duration_s;
        excursion_rad = reference.amplitude_rad == 0.0 ? reached_rad : std::min(excursion_rad, reached_rad);
    } else if (reference.shape == Shape::Staircase) {
        excursion_rad *=
            std::min(1.0 + std::floor(duration_s / reference.period_s), static_cast<double>(reference.count));
    } else if (reference.shape == Shape::Multisine) {
        excursion_rad *= std::sqrt(2.0 * reference.count); // all lines at their peak together
    }
    return excursion_rad + std::fabs(reference.base_rad_s) * duration_s;
}

std::optional<double> referenceAt_rad(const MoveReference& reference, double time_s) {
    using Shape = MoveReference::Shape;
    const double base_rad = reference.base_rad_s * time_s;
    switch (reference.shape) {
    case Shape::Step:
        return reference.amplitude_rad + base_rad;
    case Shape::Ramp: {
        const double end_rad = std::fabs(reference.amplitude_rad);
        const double ramp_rad = reference.rate_rad_s * time_s;
        return (end_rad > 0.0 ? std::clamp(ramp_rad, -end_rad, end_rad) : ramp_rad) + base_rad;
    }
    case Shape::Sine:
        return reference.amplitude_rad * std::sin(2.0 * Pi * reference.frequency_Hz * time_s) + base_rad;
    case Shape::Staircase: {
        const double steps = 1.0 + std::floor(time_s / reference.period_s + 1e-9);
        return reference.amplitude_rad * std::min(steps, static_cast<double>(reference.count)) + base_rad;
    }
    case Shape::Chirp:
    case Shape::Multisine:
        break;
    }
    return std::nullopt;
}

std::vector<ParameterValue> generatorParameters(const MoveReference& reference, double duration_s) {
    using Shape = MoveReference::Shape;
    const bool isSwept = reference.shape == Shape::Chirp || reference.shape == Shape::Multisine;
    // A second more, so that the generator does not end while the last samples are on their way.
    const double generator_s = isSwept ? duration_s : duration_s + 1.0;
    return {{"reference.shape", static_cast<double>(reference.shape)},
            {"reference.amplitude", reference.amplitude_rad},
            {"reference.rate", reference.rate_rad_s},
            {"reference.frequency", reference.frequency_Hz},
            {"reference.frequency_end", reference.frequencyEnd_Hz},
            {"reference.period", reference.period_s},
            {"reference.count", static_cast<double>(reference.count)},
            {"reference.duration", generator_s},
            {"reference.base", reference.base_rad_s},
            {"reference.seed", static_cast<double>(reference.seed)}};
}

std::optional<control::LoopReference> idealReference(const MoveReference& reference) {
    using Shape = MoveReference::Shape;
    control::LoopReference ideal{control::LoopReference::Shape::Step,
                                 reference.amplitude_rad,
                                 reference.rate_rad_s,
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
    return reference.base_rad_s == 0.0 ? std::optional(ideal) : std::nullopt;
}

} // namespace halbench::app
