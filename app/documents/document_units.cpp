#include "app/documents/document_units.h"

#include "app/documents/document_limits.h"
#include "control/base/unit_conversion.h"

#include <fmt/format.h>

#include <array>

namespace halbench::app {

namespace {

struct KeyUnit {
    std::string_view key;
    std::string_view unit;
};

constexpr std::array Units = {
    KeyUnit{"viscous_damping", "N*m*s/rad"},
    KeyUnit{"coulomb_friction", "N*m"},
    KeyUnit{"torque_constant", "N*m/A"},
    KeyUnit{"inertia", "kg*m^2"},
    KeyUnit{"c_over_J", "1/s"},
    KeyUnit{"Kf_over_J", "rad/s^2"},
    KeyUnit{"phi_over_J", "rad/s^2/A"},
    KeyUnit{"c_over_phi", "A*s/rad"},
    KeyUnit{"Kf_over_phi", "A"},
    KeyUnit{"asymmetry", ""},
    KeyUnit{"kp", "A/rad"},
    KeyUnit{"ki", "A/(rad*s)"},
    KeyUnit{"kd", "A*s/rad"},
    KeyUnit{"k", "A/rad"},
    KeyUnit{"ti", "s"},
    KeyUnit{"td", "s"},
    KeyUnit{"filter_s", "s"},
    KeyUnit{"feedforward_inertia", "A*s^2/rad"},
    KeyUnit{"feedforward_viscous", "A*s/rad"},
    KeyUnit{"feedforward_coulomb", "A"},
    KeyUnit{"feedforward_coulomb_speed", "rad/s"},
    KeyUnit{"stiction_current", "A"},
    KeyUnit{"stiction_threshold", "rad"},
    KeyUnit{"stiction_speed", "rad/s"},
    KeyUnit{"ultimate_gain", "A/rad"},
    KeyUnit{"ultimate_period", "s"},
    KeyUnit{"stray.coefficient", "T/A"},
    KeyUnit{"hall.offset_a", "T"},
    KeyUnit{"hall.offset_b", "T"},
    KeyUnit{"hall.gain_ratio", ""},
    KeyUnit{"hall.quadrature", "rad"},
    KeyUnit{"hall.amplitude", "T"},
    KeyUnit{"gain.kp", "A/rad"},
    KeyUnit{"gain.ki", "A/(rad*s)"},
    KeyUnit{"gain.kd", "A*s/rad"},
    KeyUnit{"gain.derivative_filter", "s"},
    KeyUnit{"feedforward.inertia", "A*s^2/rad"},
    KeyUnit{"feedforward.viscous", "A*s/rad"},
    KeyUnit{"feedforward.coulomb", "A"},
    KeyUnit{"feedforward.coulomb_speed", "rad/s"},
    KeyUnit{"stiction.current", "A"},
    KeyUnit{"stiction.threshold", "rad"},
    KeyUnit{"stiction.speed", "rad/s"},
    KeyUnit{"limit.current", "A"},
};
constexpr std::string_view AngleErrors = "angle_error."; // of a map: as many as it has points

tl::unexpected<Error> wrongUnit(const std::string& place, const std::string& unit, std::string_view due) {
    return failure(
        ErrorCode::InvalidInput,
        fmt::format("{}.unit\" is \"{}\", which is no unit of a value in \"{}\"", place, unit, due),
        due.empty() ? std::string("it is a ratio: leave its unit empty")
                    : fmt::format("write the value in {} or a unit of the same quantity", due));
}

Result<UnitConversion> conversionFor(std::string_view due, const std::string& unit,
                                     const std::string& place) {
    const std::optional<UnitConversion> conversion = conversionBetween(unit, due);
    return conversion ? Result<UnitConversion>(*conversion) : wrongUnit(place, unit, due);
}

JsonValue converted(const JsonValue& value, const UnitConversion& conversion) {
    if (value.isNumber()) {
        return conversion(value.number());
    }
    if (!value.isArray()) {
        return value;
    }
    JsonValue list = JsonValue::array();
    for (const JsonValue& item : value.items()) {
        list.push(converted(item, conversion));
    }
    return list;
}

/// Goes through a document and turns around what states a unit.
class UnitReader {
public:
    explicit UnitReader(std::string origin) : m_origin(std::move(origin)) {}

    Result<JsonValue> read(const JsonValue& value, const std::string& path, std::string_view key) const {
        if (value.isArray()) {
            return readArray(value, path);
        }
        return value.isObject() ? readObject(value, path, key) : Result<JsonValue>(value);
    }

private:
    Result<JsonValue> readArray(const JsonValue& value, const std::string& path) const {
        JsonValue list = JsonValue::array();
        std::size_t index = 0;
        for (const JsonValue& item : value.items()) {
            const JsonValue* name = item.find("name"); // {name, value, unit}
            Result<JsonValue> read =
                this->read(item, fmt::format("{}[{}]", path, index++),
                           name != nullptr && name->isText() ? std::string_view(name->text()) : "");
            if (!read) {
                return read;
            }
            list.push(*std::move(read));
        }
        return list;
    }

    Result<JsonValue> readObject(const JsonValue& value, const std::string& path,
                                 std::string_view key) const {
        const JsonValue* unit = value.find("unit");
        const std::optional<std::string_view> due = dueUnit(key);
        const JsonValue* amount = value.find("value");
        if (unit != nullptr && due && amount != nullptr) {
            if (amount->isNull() && unit->isText() && unit->text().empty()) {
                return value; // nothing is stated
            }
            return readQuantity(value, *unit, path, *due);
        }
        JsonValue object = JsonValue::object();
        for (const JsonMember& entry : value.members()) {
            Result<JsonValue> read =
                this->read(entry.value, path.empty() ? entry.key : path + '.' + entry.key, entry.key);
            if (!read) {
                return read;
            }
            object.set(entry.key, *std::move(read));
        }
        return object;
    }

    Result<JsonValue> readQuantity(const JsonValue& value, const JsonValue& unit, const std::string& path,
                                   std::string_view due) const {
        const std::string place = fmt::format("{}: \"{}", m_origin, path);
        if (!unit.isText()) {
            return failure(ErrorCode::InvalidInput, place + ".unit\" must be a text",
                           fmt::format("write \"{}\"", due));
        }
        const Result<UnitConversion> conversion = conversionFor(due, unit.text(), place);
        if (!conversion) {
            return failure(conversion.error());
        }
        if (const auto problem = intervalProblem(value)) {
            return failure(ErrorCode::InvalidInput, fmt::format("{}.ci95\" {}", place, *problem),
                           "write both ends around the value, or null");
        }
        JsonValue quantity = value;
        for (const char* number : {"value", "ci95"}) {
            const JsonValue* written = value.find(number);
            if (written != nullptr && !conversion->isIdentity()) {
                quantity.set(number, converted(*written, *conversion));
            }
        }
        return quantity.set("unit", due);
    }

    std::string m_origin;
};

} // namespace

std::optional<std::string> intervalProblem(const JsonValue& quantity) {
    constexpr double Rounding_ratio = 1e-9; // of numbers that went through a text
    const JsonValue* interval = quantity.find("ci95");
    const JsonValue* value = quantity.find("value");
    if (interval == nullptr || interval->isNull()) {
        return std::nullopt;
    }
    if (!interval->isArray() || interval->items().size() != 2 || !interval->items()[0].isNumber() ||
        !interval->items()[1].isNumber()) {
        return "must be null or two finite numbers";
    }
    const double low = interval->items()[0].number();
    const double high = interval->items()[1].number();
    if (low > high) {
        return fmt::format("must be in ascending order, {:.6g} is more than {:.6g}", low, high);
    }
    if (value == nullptr || !value->isNumber()) {
        return std::nullopt;
    }
    const JsonValue* source = quantity.find("source");
    if (source != nullptr && source->isText() && source->text() == "given") {
        return std::nullopt; // the interval of what is given is the value itself
    }
    const double estimate = value->number();
    const double rounding = Rounding_ratio * std::max({std::abs(estimate), std::abs(low), std::abs(high)});
    if (estimate < low - rounding || estimate > high + rounding) {
        return fmt::format("must contain the value: {:.6g} is not in {:.6g} ... {:.6g}", estimate, low, high);
    }
    return std::nullopt;
}

std::optional<std::string_view> dueUnit(std::string_view key) {
    if (key.starts_with(AngleErrors)) {
        return "rad";
    }
    for (const KeyUnit& entry : Units) {
        if (entry.key == key) {
            return entry.unit;
        }
    }
    return std::nullopt;
}

Result<double> inDueUnit(std::string_view key, double value, const std::string& unit,
                         const std::string& place) {
    const std::optional<std::string_view> due = dueUnit(key);
    if (!due) {
        return value;
    }
    const Result<UnitConversion> conversion = conversionFor(*due, unit, place);
    return conversion ? Result<double>((*conversion)(value)) : failure(conversion.error());
}

Result<JsonValue> parseDocument(const std::string& text, const std::string& origin) {
    const Result<JsonValue> root = parseJson(text, origin);
    Result<JsonValue> document = root ? UnitReader(origin).read(*root, "", "") : root;
    if (!document) {
        return document;
    }
    const Result<void> possible = checkLimits(*document, origin);
    return possible ? document : failure(possible.error());
}

} // namespace halbench::app
