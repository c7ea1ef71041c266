#include "app/procedures/excite/move_reference_keys.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {
namespace {

// What the board's generator takes; resources/help/protocol.md 3.15.
constexpr double LargestAngle_rad = 10000.0;
constexpr double LargestSpeed_rad_s = 1000.0;
constexpr double LargestLength_m = 1000.0;
constexpr double LargestSpeed_m_s = 1000.0;
constexpr double LargestFrequency_Hz = 200.0;
// Of travels and paths.
constexpr double LargestAcceleration = 1000.0;
constexpr double LargestJerk = 1e6;
constexpr double LargestPathAngle_rad = 1000.0;

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

void setAcceleration(MoveReference& reference, double acceleration) {
    reference.acceleration = acceleration;
}

void setJerk(MoveReference& reference, double jerk) {
    reference.jerk = jerk;
}

void setAngle(MoveReference& reference, double angle_rad) {
    reference.angle_rad = angle_rad;
}

void setHeading(MoveReference& reference, double heading_rad) {
    reference.heading_rad = heading_rad;
}

void setPitch(MoveReference& reference, double pitch) {
    reference.pitch = pitch;
}

void setCount(MoveReference& reference, double count) {
    reference.count = static_cast<int>(count);
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

constexpr Key accelerationKey(std::string_view key, std::string_view help, Quantity quantity,
                              double perUnit) {
    return {{key, help}, 0.0, LargestAcceleration / perUnit, false, setAcceleration, perUnit, quantity};
}

constexpr Key jerkKey(std::string_view key, std::string_view help, Quantity quantity, double perUnit) {
    return {{key, help}, 0.0, LargestJerk / perUnit, false, setJerk, perUnit, quantity};
}

constexpr Key pitchKey(std::string_view key, std::string_view help, double perUnit) {
    return {{key, help}, -1.0 / perUnit, 1.0 / perUnit, false, setPitch, perUnit, Quantity::Length};
}

/// Angles of a path in the plane, beside lengths.
constexpr Key directionKey(std::string_view key, std::string_view help, double perUnit,
                           void (*set)(MoveReference&, double)) {
    return {{key, help}, -LargestPathAngle_rad / perUnit, LargestPathAngle_rad / perUnit, false, set,
            perUnit};
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
    speedKey("rate_deg_s", "slope of a ramp, largest speed of a travel or path", Quantity::Angle, Degree_rad,
             setRate),
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
    Key{{"count", "steps of a staircase, lines of a multisine"}, 1.0, 1000.0, true, setCount},
    speedKey("base_deg_s", "constant motion added", Quantity::Angle, Degree_rad, setBase),
    speedKey("base_rad_s", "the same in radians", Quantity::Angle, 1.0, setBase),
    speedKey("base_mrad_s", "the same in milliradians", Quantity::Angle, 1e-3, setBase),
    speedKey("base_urad_s", "the same in microradians", Quantity::Angle, 1e-6, setBase),
    speedKey("base_m_s", "the same of an axis that moves along a line", Quantity::Length, 1.0, setBase),
    speedKey("base_mm_s", "the same in millimetres", Quantity::Length, 1e-3, setBase),
    speedKey("base_um_s", "the same in micrometres", Quantity::Length, 1e-6, setBase),
    accelerationKey("acceleration_m_s2", "largest acceleration of a travel or path", Quantity::Length, 1.0),
    accelerationKey("acceleration_mm_s2", "the same in millimetres", Quantity::Length, 1e-3),
    accelerationKey("acceleration_rad_s2", "the same of an axis that turns", Quantity::Angle, 1.0),
    accelerationKey("acceleration_mrad_s2", "the same in milliradians", Quantity::Angle, 1e-3),
    jerkKey("jerk_m_s3", "largest jerk of an S-curve or path", Quantity::Length, 1.0),
    jerkKey("jerk_mm_s3", "the same in millimetres", Quantity::Length, 1e-3),
    jerkKey("jerk_rad_s3", "the same of an axis that turns", Quantity::Angle, 1.0),
    jerkKey("jerk_mrad_s3", "the same in milliradians", Quantity::Angle, 1e-3),
    amplitudeKey("radius_m", "radius; of a circle the centre lies along the first axis", Quantity::Length,
                 1.0),
    amplitudeKey("radius_mm", "the same in millimetres", Quantity::Length, 1e-3),
    amplitudeKey("radius_um", "the same in micrometres", Quantity::Length, 1e-6),
    Key{{"turns", "turns of a circle"}, 1.0, 1000.0, true, setCount},
    amplitudeKey("width_m", "length of the lines of a raster, along the first axis", Quantity::Length, 1.0),
    amplitudeKey("width_mm", "the same in millimetres", Quantity::Length, 1e-3),
    amplitudeKey("width_um", "the same in micrometres", Quantity::Length, 1e-6),
    pitchKey("pitch_m", "from line to line of a raster, along the second axis", 1.0),
    pitchKey("pitch_mm", "the same in millimetres", 1e-3),
    pitchKey("pitch_um", "the same in micrometres", 1e-6),
    Key{{"lines", "lines of a raster"}, 1.0, 1000.0, true, setCount},
    directionKey("angle_deg", "angle of an arc, counter-clockwise", Degree_rad, setAngle),
    directionKey("angle_rad", "the same in radians", 1.0, setAngle),
    directionKey("heading_deg", "start direction of arc and line, from first to second axis", Degree_rad,
                 setHeading),
    directionKey("heading_rad", "the same in radians", 1.0, setHeading),
    amplitudeKey("length_m", "length of a line", Quantity::Length, 1.0),
    amplitudeKey("length_mm", "the same in millimetres", Quantity::Length, 1e-3),
    amplitudeKey("length_um", "the same in micrometres", Quantity::Length, 1e-6),
    Key{{"dwell_s", "rest in every row of a table without time_s"},
        0.0,
        3600.0,
        false,
        [](MoveReference& r, double v) { r.dwell_s = v; }},
    Key{{"seed", "phases of a multisine; 0: those of least peak"},
        0.0,
        4294967295.0,
        true,
        [](MoveReference& r, double v) { r.seed = static_cast<std::uint32_t>(v); }},
};

/// A table moves axes along lines and axes that turn: each kind has its own limits.
void setTurning(const Key& key, MoveReference& reference, double value) {
    MoveReference angles;
    key.set(angles, value * key.perUnit);
    MoveReference::Turning& turning = reference.turning;
    turning.rate = angles.rate != 0.0 ? angles.rate : turning.rate;
    turning.acceleration = angles.acceleration != 0.0 ? angles.acceleration : turning.acceleration;
    turning.jerk = angles.jerk ? angles.jerk : turning.jerk;
    reference.amplitude += angles.amplitude; // refused by checkTableKeys()
    reference.base += angles.base;
}

} // namespace

Result<void> setMoveReferenceFile(MoveReference& reference, std::string_view path) {
    if (reference.shape != MoveReference::Shape::Table) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("a {} has no file", moveShapeName(reference.shape)),
                       "Only a table has a file of poses.");
    }
    reference.file = std::string(path);
    return {};
}

namespace {

/// "m/s" of "_m_s", "s" of "_s", nothing of "".
std::string unitOf(std::string_view suffix) {
    std::string unit(suffix.substr(std::min<std::size_t>(1, suffix.size())));
    if (const std::size_t per = unit.rfind("_s"); per != std::string::npos) {
        const std::string power = unit.substr(per + 2);
        unit = unit.substr(0, per) + "/s" + (power.empty() ? "" : "^" + power);
    }
    return unit;
}

bool isOf(const Key& key, std::string_view stem) {
    return key.text.key == stem || (key.text.key.starts_with(stem) && key.text.key[stem.size()] == '_');
}

} // namespace

std::vector<ReferenceSetting> settingsOf(MoveReference::Shape shape) {
    using Shape = MoveReference::Shape;
    const auto along = [](std::initializer_list<std::string_view> stems) {
        std::vector<ReferenceSetting> settings;
        for (const std::string_view stem : stems) {
            settings.push_back({stem, Quantity::Length});
        }
        return settings;
    };
    std::vector<ReferenceSetting> settings;
    switch (shape) {
    case Shape::Circle:
        settings = along({"radius", "turns"});
        break;
    case Shape::Raster:
        settings = along({"width", "lines", "pitch"});
        break;
    case Shape::Arc:
        settings = along({"radius", "angle", "heading"});
        break;
    case Shape::Line:
        settings = along({"length", "heading"});
        break;
    case Shape::Table:
        settings = along({"dwell"});
        break;
    default:
        return {};
    }
    for (const Quantity quantity : {Quantity::Length, Quantity::Angle}) {
        for (const std::string_view stem : {"rate", "acceleration", "jerk"}) {
            if (quantity == Quantity::Length || shape == Shape::Table) {
                settings.push_back({stem, quantity});
            }
        }
    }
    return settings;
}

SettingSpec settingSpec(const ReferenceSetting& setting) {
    const auto first =
        std::find_if(Keys.begin(), Keys.end(), [&](const Key& key) { return isOf(key, setting.stem); });
    const auto key = std::find_if(first, Keys.end(), [&](const Key& each) {
        return isOf(each, setting.stem) && each.perUnit == 1.0 &&
               (each.quantity == Quantity::Unknown || each.quantity == setting.quantity);
    });
    HB_ASSERT(key != Keys.end());
    return {key->text.key, first->text.help, unitOf(key->text.key.substr(setting.stem.size())),
            key->min,      key->max,         key->isWhole};
}

std::string moveReferenceKeyNames() {
    std::string keys(FileKey);
    for (const Key& key : Keys) {
        keys += ", " + std::string(key.text.key);
    }
    return keys;
}

std::span<const MoveReferenceKey> moveReferenceKeys() {
    static const auto texts = [] {
        std::array<MoveReferenceKey, Keys.size()> all;
        std::transform(Keys.begin(), Keys.end(), all.begin(), [](const Key& key) { return key.text; });
        return all;
    }();
    return texts;
}

Result<void> setMoveReference(MoveReference& reference, std::string_view name, double value) {
    const auto key = std::find_if(Keys.begin(), Keys.end(), [&](const Key& k) { return k.text.key == name; });
    if (key == Keys.end()) {
        return failure(ErrorCode::UnknownName, fmt::format("a reference has no key '{}'", name),
                       "Known keys: " + moveReferenceKeyNames() + ".");
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
    if (reference.shape == MoveReference::Shape::Table && key->quantity == Quantity::Angle) {
        setTurning(*key, reference, value);
        return {};
    }
    if (key->quantity != Quantity::Unknown) {
        if (reference.quantity != Quantity::Unknown && reference.quantity != key->quantity) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{} does not fit the other keys: a length with an angle", name),
                           "Give the whole reference in angles or in lengths.");
        }
        reference.quantity = key->quantity;
    }
    key->set(reference, value * key->perUnit);
    return {};
}

} // namespace halbench::app
