#include "app/batch/identification_file.h"

#include "app/batch/model_file.h"
#include "app/batch/numbers.h"
#include "app/batch/output_file.h"

#include <array>

namespace halbench::app {

namespace {

// parseModel() has judged schema and numbers; what is absent here only stays empty.
const JsonValue* member(const JsonValue* object, const char* key) {
    return object == nullptr ? nullptr : object->find(key);
}

std::optional<double> numberIn(const JsonValue* object, const char* key) {
    const JsonValue* value = member(object, key);
    return value != nullptr && value->isNumber() ? std::optional(value->number()) : std::nullopt;
}

std::string textIn(const JsonValue* object, const char* key) {
    const JsonValue* value = member(object, key);
    return value != nullptr && value->isText() ? value->text() : std::string();
}

const JsonValue::Array& itemsIn(const JsonValue* object, const char* key, const JsonValue::Array& none) {
    const JsonValue* value = member(object, key);
    return value != nullptr && value->isArray() ? value->items() : none;
}

control::EstimateSource sourceNamed(const std::string& name) {
    using control::EstimateSource;
    for (const EstimateSource source : {EstimateSource::Identified, EstimateSource::Given}) {
        if (name == control::estimateSourceName(source)) {
            return source;
        }
    }
    return EstimateSource::NotIdentifiable;
}

control::Estimate estimateOf(const JsonValue* value) {
    control::Estimate estimate;
    estimate.value = numberIn(value, "value");
    estimate.unit = textIn(value, "unit");
    estimate.source = sourceNamed(textIn(value, "source"));
    const JsonValue::Array none;
    const JsonValue::Array& interval = itemsIn(value, "ci95", none);
    if (interval.size() == 2 && interval[0].isNumber() && interval[1].isNumber()) {
        estimate.interval95 = std::pair(interval[0].number(), interval[1].number());
    }
    return estimate;
}

DataQuality qualityOf(const JsonValue* value) {
    DataQuality quality;
    quality.verdict =
        textIn(value, "verdict") == verdictName(Verdict::Good) ? Verdict::Good : Verdict::Doubtful;
    const JsonValue::Array none;
    for (const JsonValue& finding : itemsIn(value, "findings", none)) {
        quality.findings.push_back(
            {textIn(&finding, "code"), textIn(&finding, "message"), textIn(&finding, "hint")});
    }
    return quality;
}

std::vector<SweepPoint> pointsOf(const JsonValue& root) {
    std::vector<SweepPoint> points;
    const JsonValue::Array none;
    for (const JsonValue& entry : itemsIn(&root, "points", none)) {
        const JsonValue* used = member(&entry, "used");
        const auto current = numberIn(&entry, "current_A");
        const auto speed = numberIn(&entry, "speed_rad_s");
        if (current && speed) {
            points.push_back({*current, *speed, used != nullptr && used->isBoolean() && used->boolean(),
                              numberIn(&entry, "weight").value_or(0.0), textIn(&entry, "note")});
        }
    }
    return points;
}

/// Also the overrides of a simulated device, which a model for tuning does not need.
void addOverrides(devices::DeviceInfo& device, const JsonValue& root) {
    const JsonValue* overrides = member(member(&root, "device"), "overrides");
    if (overrides == nullptr || !overrides->isObject()) {
        return;
    }
    for (const JsonMember& entry : overrides->members()) {
        if (entry.value.isNumber()) {
            device.overrides.emplace_back(entry.key, formatNumber(entry.value.number()));
        } else if (entry.value.isText()) {
            device.overrides.emplace_back(entry.key, entry.value.text());
        }
    }
}

IdentifyResult resultOf(const JsonValue& root) {
    IdentifyResult result;
    const JsonValue* parameters = member(&root, "parameters");
    result.viscousDamping = estimateOf(member(parameters, "viscous_damping"));
    result.coulombFriction = estimateOf(member(parameters, "coulomb_friction"));
    result.torqueConstant = estimateOf(member(parameters, "torque_constant"));
    result.inertia = estimateOf(member(parameters, "inertia"));
    for (const char* name : {"c_over_J", "Kf_over_J", "phi_over_J", "c_over_phi", "Kf_over_phi"}) {
        const control::Estimate ratio = estimateOf(member(member(&root, "ratios"), name));
        if (ratio.value) {
            result.ratios[name] = ratio;
        }
    }
    const control::Estimate asymmetry = estimateOf(member(&root, "asymmetry"));
    result.asymmetry = asymmetry.value ? std::optional(asymmetry) : std::nullopt;
    result.rSquared = numberIn(&root, "r_squared");
    result.residualRms_rad_s = numberIn(&root, "residual_rms_rad_s");
    result.points = pointsOf(root);
    result.quality = qualityOf(member(&root, "data_quality"));
    result.duration_s = numberIn(&root, "duration_s").value_or(0.0);
    result.highestTemperature_degC = numberIn(&root, "highest_temperature_degC").value_or(0.0);
    const JsonValue* notes = member(&root, "notes");
    if (notes != nullptr && notes->isObject()) {
        for (const JsonMember& note : notes->members()) {
            if (note.value.isNumber()) {
                result.notes[note.key] = note.value.number();
            }
        }
    }
    return result;
}

} // namespace

Result<IdentificationFile> parseIdentification(const std::string& text, const std::string& origin) {
    const Result<ModelFile> model = parseModel(text, origin);
    if (!model) {
        return failure(model.error());
    }
    const Result<JsonValue> root = parseJson(text, origin);
    if (!root) {
        return failure(root.error());
    }
    IdentificationFile file;
    file.result = resultOf(*root);
    file.result.covarianceNames = model->estimate.covarianceNames;
    file.result.covariance = model->estimate.covariance;
    file.header.schema = textIn(&*root, "schema");
    file.header.device = model->device;
    if (file.header.device) {
        addOverrides(*file.header.device, *root);
    }
    file.header.started = textIn(&*root, "started");
    file.header.seed = model->seed;
    file.header.quality = file.result.quality;
    return file;
}

Result<IdentificationFile> readIdentificationFile(const std::string& path) {
    const Result<std::string> text = readFile(path);
    if (!text) {
        return failure(text.error());
    }
    return parseIdentification(*text, path);
}

} // namespace halbench::app
