#include "app/documents/axis_loop_documents.h"

#include "app/documents/document_limits.h"
#include "app/documents/document_parts.h"
#include "app/documents/filtered_gains.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/output_file.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace halbench::app {
namespace {

constexpr const char* GainsSchema = "halbench.gains/1";
constexpr const char* Remedy = "write the file with 'halbench tune MODEL.json --out GAINS.json'";

/// A unit of a motor's loop and how it is put together of position and effort.
struct UnitPair {
    const char* motor;
    const char* pattern; ///< {0}: unit of the effort, {1}: of the position
};
constexpr std::array UnitPairs = {UnitPair{"A/rad", "{0}/{1}"},
                                  UnitPair{"A/(rad*s)", "{0}/({1}*s)"},
                                  UnitPair{"A*s/rad", "{0}*s/{1}"},
                                  UnitPair{"A*s^2/rad", "{0}*s^2/{1}"},
                                  UnitPair{"A", "{0}"},
                                  UnitPair{"rad/s", "{1}/s"},
                                  UnitPair{"rad", "{1}"},
                                  UnitPair{"s", "s"}};

std::string unitOf(const UnitPair& pair, const std::string& effort, const std::string& position) {
    return fmt::format(fmt::runtime(pair.pattern), effort, position);
}

/// "N*m" is "Nm" in a key.
std::string inKey(std::string unit) {
    std::erase(unit, '*');
    return unit;
}

bool replaceEnd(std::string& text, std::string_view end, const std::string& by) {
    if (!text.ends_with(end)) {
        return false;
    }
    text.replace(text.size() - end.size(), end.size(), by);
    return true;
}

std::string keyOf(const LoopAxis& axis, std::string key) {
    const std::string effort = inKey(axis.effortUnit);
    const std::string& position = axis.positionUnit;
    const bool isChanged = replaceEnd(key, "_A_per_rad", fmt::format("_{}_per_{}", effort, position)) ||
                           replaceEnd(key, "_rad", "_" + position) || replaceEnd(key, "_A", "_" + effort);
    const std::size_t current = isChanged ? key.find("current") : std::string::npos;
    if (current != std::string::npos) {
        key.replace(current, std::string_view("current").size(), "effort");
    }
    return key;
}

JsonValue unitFor(const LoopAxis& axis, const std::string& motor) {
    const auto pair = std::find_if(UnitPairs.begin(), UnitPairs.end(),
                                   [&](const UnitPair& known) { return motor == known.motor; });
    return pair == UnitPairs.end() ? JsonValue(motor)
                                   : JsonValue(unitOf(*pair, axis.effortUnit, axis.positionUnit));
}

/// Angles that a motor's document has in degrees.
bool isDegrees(const std::string& key) {
    return key == "amplitude_deg" || key == "step_deg";
}

JsonValue axisHead(const LoopAxis& axis) {
    JsonValue entry = JsonValue::object();
    entry.set("axis", axis.id).set("position_unit", axis.positionUnit);
    return entry.set("effort_unit", axis.effortUnit);
}

JsonValue joined(JsonValue head, const JsonValue& body) {
    for (const JsonMember& member : body.members()) {
        head.set(member.key, member.value);
    }
    return head;
}

JsonValue jointOf(const TuneAxesResult& result) {
    if (!result.joint) {
        return {};
    }
    JsonValue joint = JsonValue::object();
    joint.set("draws", result.joint->draws);
    return joint.set("unstable_fraction", result.joint->unstable_fraction);
}

template <typename Body>
JsonValue axesBody(const TuneAxesResult& result, const Body& bodyOf) {
    JsonValue axes = JsonValue::array();
    for (const TuneResult& axis : result.axes) {
        const LoopAxis& of = axis.conditions.axis.value();
        JsonValue entry = axisHead(of);
        entry.set("data_quality", toJson(axis.quality));
        axes.push(joined(entry, inUnitsOf(of, bodyOf(axis))));
    }
    JsonValue body = JsonValue::object();
    return body.set("axes", axes).set("joint", jointOf(result));
}

JsonValue document(ResultHeader header, const char* schema, const TuneAxesResult& result,
                   const JsonValue& body) {
    header.schema = schema;
    header.quality = result.quality;
    return joined(toJson(header), body);
}

/// The unit that a motor's document has in its place. Error: InvalidInput.
Result<std::string> motorUnit(const LoopAxis& axis, const std::string& unit, const std::string& key) {
    for (const UnitPair& pair : UnitPairs) {
        if (unit == unitOf(pair, axis.effortUnit, axis.positionUnit)) {
            return std::string(pair.motor);
        }
    }
    return failure(ErrorCode::InvalidInput,
                   fmt::format("\"gains.{}\" is in \"{}\", which is no unit of an axis in {} and {}", key,
                               unit, axis.positionUnit, axis.effortUnit),
                   "write it in the units of the axis");
}

/// The gains with the units of a motor's document, so that its reader judges them.
Result<JsonValue> motorGains(const LoopAxis& axis, const JsonValue& gains) {
    JsonValue result = JsonValue::object();
    for (const JsonMember& gain : gains.members()) {
        JsonValue value = gain.value;
        if (const JsonValue* unit = value.find("unit"); unit != nullptr && unit->isText()) {
            const auto known = motorUnit(axis, unit->text(), gain.key);
            if (!known) {
                return failure(known.error());
            }
            value.set("unit", *known);
        }
        result.set(gain.key, value);
    }
    return result;
}

/// The element of one axis as the document of a single loop.
Result<GainsFile> readAxis(const JsonValue& root, const JsonValue& element, const LoopAxis& axis,
                           const std::string& origin) {
    JsonValue single = JsonValue::object();
    single.set("schema", GainsSchema);
    if (const JsonValue* device = root.find("device")) {
        single.set("device", *device);
    }
    single.set("started", textIn(&root, "started"));
    for (const char* key : {"method", "form", "sample_period_s", "delay_samples"}) {
        if (const JsonValue* value = element.find(key)) {
            single.set(key, *value);
        }
    }
    if (const JsonValue* gains = element.find("gains"); gains != nullptr && gains->isObject()) {
        auto motor = motorGains(axis, *gains);
        if (!motor) {
            return failure(motor.error().code, origin + ": " + motor.error().message, motor.error().hint);
        }
        single.set("gains", *std::move(motor));
    }
    const auto text = toJsonText(single);
    return text ? parseFilteredGains(*text, origin) : Result<GainsFile>(failure(text.error()));
}

JsonValue agreementOf(const VerificationBand& band, const std::string& unit) {
    JsonValue body = JsonValue::object();
    body.set("friction_band_" + unit, finiteOrNull(band.friction_rad));
    body.set("allowed_error_" + unit, finiteOrNull(band.allowed_rad));
    body.set("allowed_overshoot_percent", finiteOrNull(band.allowedOvershoot_percent));
    body.set("largest_difference_" + unit, finiteOrNull(band.largestOff_rad));
    body.set("effort_ratio", band.effort ? finiteOrNull(band.effort->ratio) : JsonValue());
    JsonValue allowed = JsonValue::array();
    if (band.effort) {
        allowed.push(band.effort->low).push(band.effort->high);
    }
    body.set("allowed_effort_ratio", band.effort ? allowed : JsonValue());
    return body.set("largest_difference_s", finiteOrNull(band.largestOffTime_s));
}

JsonValue crossAxesOf(const MoveResult& move) {
    JsonValue list = JsonValue::array();
    for (const CrossAxisPeak& other : move.others) {
        JsonValue entry = JsonValue::object();
        entry.set("axis", other.axis.id);
        entry.set("measured_peak_" + other.axis.positionUnit, finiteOrNull(other.measured));
        list.push(entry.set("allowed_" + other.axis.positionUnit, crossAxisTolerance(other.axis)));
    }
    return list;
}

JsonValue verifiedAxis(const AxisVerification& verified) {
    const ApplyResult& assessment = verified.assessment;
    const std::string& unit = verified.axis.positionUnit;
    JsonValue entry = JsonValue::object();
    entry.set("axis", verified.axis.id).set("data_quality", toJson(assessment.quality));
    entry.set("predicted", assessment.predicted ? moveFigures(*assessment.predicted, unit) : JsonValue());
    entry.set("agreement", assessment.band ? agreementOf(*assessment.band, unit) : JsonValue());
    entry.set("verification", assessment.verification ? moveBody(*assessment.verification) : JsonValue());
    return entry.set("cross_axes",
                     assessment.verification ? crossAxesOf(*assessment.verification) : JsonValue());
}

} // namespace

JsonValue appliedAxesBody(const ApplyAxesResult& result) {
    JsonValue axes = JsonValue::array();
    for (const AxisVerification& verified : result.axes) {
        axes.push(verifiedAxis(verified));
    }
    JsonValue body = JsonValue::object();
    body.set("kept", result.isKept).set("before", toJson(result.before)).set("after", toJson(result.after));
    return body.set("axes", axes);
}

JsonValue inUnitsOf(const LoopAxis& axis, const JsonValue& body) {
    if (body.isArray()) {
        JsonValue list = JsonValue::array();
        for (const JsonValue& item : body.items()) {
            list.push(inUnitsOf(axis, item));
        }
        return list;
    }
    if (!body.isObject()) {
        return body;
    }
    JsonValue result = JsonValue::object();
    for (const JsonMember& entry : body.members()) {
        if (isDegrees(entry.key)) {
            const std::string key = entry.key.substr(0, entry.key.find('_') + 1) + axis.positionUnit;
            result.set(key, entry.value.isNumber() ? JsonValue(degreesToRadians(entry.value.number()))
                                                   : entry.value);
        } else if (entry.key == "unit" && entry.value.isText()) {
            result.set(entry.key, unitFor(axis, entry.value.text()));
        } else {
            result.set(keyOf(axis, entry.key), inUnitsOf(axis, entry.value));
        }
    }
    return result;
}

JsonValue axisGainsBody(const TuneAxesResult& result) {
    return axesBody(result, [](const TuneResult& axis) { return gainsBody(axis); });
}

JsonValue axisAnalysisBody(const TuneAxesResult& result) {
    return axesBody(result, [](const TuneResult& axis) {
        JsonValue body = analysisBody(axis.predicted);
        body.set("warnings", toJson(axis.warnings));
        setJudgement(body, axis);
        return body;
    });
}

JsonValue axisGainsDocument(ResultHeader header, const TuneAxesResult& result) {
    return document(std::move(header), GainsSchema, result, axisGainsBody(result));
}

JsonValue axisAnalysisDocument(ResultHeader header, const TuneAxesResult& result) {
    return document(std::move(header), "halbench.analysis/1", result, axisAnalysisBody(result));
}

bool isAxisGains(const std::string& text) {
    const Result<JsonValue> root = parseJson(text, "");
    const JsonValue* axes = root ? root->find("axes") : nullptr;
    return axes != nullptr && axes->isArray() && textIn(&*root, "schema").starts_with("halbench.gains/");
}

Result<AxisGainsFile> parseAxisGains(const std::string& text, const std::string& origin) {
    const Result<JsonValue> root = parseJson(text, origin);
    if (!root) {
        return failure(root.error());
    }
    if (const std::string schema = textIn(&*root, "schema"); schema != GainsSchema) {
        return failure(
            ErrorCode::InvalidInput,
            fmt::format("{}: \"schema\" is \"{}\", this version reads \"{}\"", origin, schema, GainsSchema),
            Remedy);
    }
    if (itemsIn(&*root, "axes").empty()) {
        return failure(ErrorCode::InvalidInput,
                       origin + ": holds the gains of a single loop, the model has several axes", Remedy);
    }
    if (const Result<void> possible = checkLimits(*root, origin); !possible) {
        return failure(possible.error());
    }
    AxisGainsFile file;
    file.device = deviceOf(member(&*root, "device"));
    for (const JsonValue& element : itemsIn(&*root, "axes")) {
        LoopAxis axis;
        axis.id = textIn(&element, "axis");
        axis.positionUnit = textIn(&element, "position_unit");
        axis.effortUnit = textIn(&element, "effort_unit");
        if (axis.id.empty() || std::find(file.axes.begin(), file.axes.end(), axis.id) != file.axes.end()) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("{}: \"axes\": every axis needs a name of its own", origin), Remedy);
        }
        auto gains = readAxis(*root, element, axis, fmt::format("{}: axis {}", origin, axis.id));
        if (!gains) {
            return failure(gains.error());
        }
        file.axes.push_back(axis.id);
        file.gains.push_back(*std::move(gains));
    }
    return file;
}

Result<AxisGainsFile> readAxisGains(const std::string& path) {
    const Result<std::string> text = readFile(path);
    return text ? parseAxisGains(*text, path) : Result<AxisGainsFile>(failure(text.error()));
}

} // namespace halbench::app
