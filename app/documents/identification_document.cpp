#include "app/documents/axes_frequency_documents.h"
#include "app/documents/axis_model_file.h"
#include "app/documents/relay_document.h"
#include "app/documents/result_documents.h"

namespace halbench::app {

JsonValue toJson(const control::Estimate& estimate) {
    JsonValue interval;
    if (estimate.interval95) {
        interval = JsonValue::array();
        interval.push(estimate.interval95->first).push(estimate.interval95->second);
    }
    JsonValue document = JsonValue::object();
    document.set("value", estimate.value).set("unit", estimate.unit).set("ci95", interval);
    return document.set("source", control::estimateSourceName(estimate.source));
}

JsonValue toJson(const std::vector<ParameterValue>& values) {
    JsonValue list = JsonValue::array();
    for (const ParameterValue& value : values) {
        JsonValue entry = JsonValue::object();
        list.push(entry.set("name", value.name).set("value", value.value));
    }
    return list;
}

namespace {

JsonValue ratiosOf(const IdentifyResult& result) {
    JsonValue ratios = JsonValue::object();
    for (const char* name : {"c_over_J", "Kf_over_J", "phi_over_J", "c_over_phi", "Kf_over_phi"}) {
        const auto found = result.ratios.find(name);
        ratios.set(name, toJson(found == result.ratios.end() ? control::Estimate{} : found->second));
    }
    return ratios;
}

JsonValue pointsOf(const IdentifyResult& result) {
    JsonValue points = JsonValue::array();
    for (const SweepPoint& point : result.points) {
        JsonValue entry = JsonValue::object();
        entry.set("current_A", point.current_A).set("speed_rad_s", finiteOrNull(point.speed_rad_s));
        entry.set("used", point.isUsed).set("weight", finiteOrNull(point.weight));
        points.push(entry.set("note", textOrNull(point.note)));
    }
    return points;
}

JsonValue covarianceOf(const IdentifyResult& result) {
    JsonValue matrix = JsonValue::array();
    for (const std::vector<double>& row : result.covariance) {
        matrix.push(JsonValue(row));
    }
    JsonValue covariance = JsonValue::object();
    return covariance.set("names", result.covarianceNames).set("matrix", matrix);
}

} // namespace

JsonValue identificationBody(const IdentifyResult& result) {
    JsonValue parameters = JsonValue::object();
    parameters.set("viscous_damping", toJson(result.viscousDamping));
    parameters.set("coulomb_friction", toJson(result.coulombFriction));
    parameters.set("torque_constant", toJson(result.torqueConstant));
    parameters.set("inertia", toJson(result.inertia));
    JsonValue body = JsonValue::object();
    body.set("parameters", parameters).set("ratios", ratiosOf(result));
    body.set("asymmetry", result.asymmetry ? toJson(*result.asymmetry) : JsonValue());
    body.set("r_squared", finiteOrNull(result.rSquared));
    body.set("residual_rms_rad_s", finiteOrNull(result.residualRms_rad_s));
    body.set("points", pointsOf(result)).set("covariance", covarianceOf(result));
    body.set("duration_s", result.duration_s);
    body.set("sample_period_s", finiteOrNull(result.timing.period_s));
    body.set("delay_samples",
             result.timing.delay_samples ? JsonValue(*result.timing.delay_samples) : JsonValue());
    body.set("highest_temperature_degC", finiteOrNull(result.highestTemperature_degC));
    JsonValue notes = JsonValue::object();
    for (const auto& [name, value] : result.notes) {
        notes.set(name, finiteOrNull(value));
    }
    return body.set("notes", notes);
}

namespace {

JsonValue axesBody(const AxesIdentifyResult& result) {
    JsonValue body = axisModelBody(result.model);
    const auto setAll = [&body](const char* key, const std::vector<NamedEstimate>& estimates) {
        JsonValue list = JsonValue::object();
        for (const NamedEstimate& each : estimates) {
            list.set(each.name, toJson(each.estimate));
        }
        body.set(key, list);
    };
    setAll("constants", result.constants);
    setAll("ratios", result.ratios);
    body.set("duration_s", result.duration_s);
    body.set("highest_temperature_degC", finiteOrNull(result.highestTemperature_degC));
    JsonValue notes = JsonValue::object();
    for (const auto& [name, value] : result.notes) {
        notes.set(name, finiteOrNull(value));
    }
    return body.set("notes", notes);
}

} // namespace

JsonValue identificationBody(const IdentifyOutcome& outcome) {
    const auto* axes = std::get_if<AxesIdentifyResult>(&outcome);
    return axes != nullptr ? axesBody(*axes) : identificationBody(std::get<IdentifyResult>(outcome));
}

namespace {

/// Header first, then the body's members.
JsonValue joined(ResultHeader header, const DataQuality& quality, const JsonValue& body) {
    header.quality = quality;
    JsonValue document = toJson(header);
    for (const JsonMember& member : body.members()) {
        document.set(member.key, member.value);
    }
    return document;
}

} // namespace

JsonValue identificationDocument(ResultHeader header, const IdentifyOutcome& outcome) {
    if (std::holds_alternative<AxesIdentifyResult>(outcome)) {
        header.schema = AxisModelSchema;
    }
    return joined(std::move(header), qualityOf(outcome), identificationBody(outcome));
}

JsonValue identificationDocument(ResultHeader header, const IdentifyResult& result) {
    return joined(std::move(header), result.quality, identificationBody(result));
}

JsonValue frequencyDocument(ResultHeader header, const FrequencyResult& result) {
    return joined(std::move(header), result.quality, frequencyBody(result));
}

JsonValue axesFrequencyDocument(ResultHeader header, const AxesFrequencyResult& result) {
    header.schema = AxisFrequencySchema;
    return joined(std::move(header), result.quality, axesFrequencyBody(result));
}

JsonValue relayDocument(ResultHeader header, const RelayResult& result) {
    return joined(std::move(header), result.quality, relayBody(result));
}

JsonValue calibrationDocument(ResultHeader header, const CalibrateResult& result) {
    return joined(std::move(header), result.quality, calibrationBody(result));
}

JsonValue gainsDocument(ResultHeader header, const TuneResult& result) {
    return joined(std::move(header), result.quality, gainsBody(result));
}

JsonValue analysisDocument(ResultHeader header, const AnalysisResult& result) {
    return joined(std::move(header), result.quality, analysisBody(result));
}

} // namespace halbench::app
