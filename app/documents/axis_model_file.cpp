#include "app/documents/axis_model_file.h"

#include "app/documents/document_limits.h"
#include "app/documents/document_parts.h"
#include "app/documents/document_units.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/output_file.h"
#include "app/procedures/base/doubtful_source.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace halbench::app {
namespace {

constexpr const char* Remedy = "make the file with 'halbench identify DEVICE --out'";

JsonValue axisBody(const IdentifiedAxis& axis) {
    JsonValue parameters = JsonValue::object();
    parameters.set("damping_rate", toJson(axis.dampingRate));
    parameters.set("acceleration_gain", toJson(axis.accelerationGain));
    parameters.set("breakaway_effort", toJson(axis.breakawayEffort));
    JsonValue body = JsonValue::object();
    body.set("axis", axis.axis).set("position_unit", axis.positionUnit).set("effort_unit", axis.effortUnit);
    body.set("sample_period_s", finiteOrNull(axis.timing.period_s));
    body.set("delay_samples",
             axis.timing.delay_samples ? JsonValue(*axis.timing.delay_samples) : JsonValue());
    return body.set("parameters", parameters);
}

/// Within its limits, which readModel() has judged.
MeasuredTiming timingOf(const JsonValue& axis) {
    MeasuredTiming timing;
    timing.period_s = numberIn(&axis, "sample_period_s");
    if (const std::optional<double> delay = numberIn(&axis, "delay_samples")) {
        timing.delay_samples = static_cast<int>(*delay);
    }
    return timing;
}

Result<IdentifiedAxis> readAxis(const JsonValue& value) {
    IdentifiedAxis axis;
    axis.axis = textIn(&value, "axis");
    axis.positionUnit = textIn(&value, "position_unit");
    axis.effortUnit = textIn(&value, "effort_unit");
    const JsonValue* parameters = member(&value, "parameters");
    constexpr std::array Names = {std::pair("damping_rate", "damping rate"),
                                  std::pair("acceleration_gain", "acceleration gain"),
                                  std::pair("breakaway_effort", "breakaway effort")};
    for (const auto& [key, name] : Names) {
        const JsonValue* quantity = member(parameters, key);
        if (const auto problem = quantity != nullptr ? intervalProblem(*quantity) : std::nullopt) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("axis {}: {}: ci95 {}", axis.axis, name, *problem), Remedy);
        }
    }
    axis.dampingRate = estimateOf(member(parameters, "damping_rate"));
    axis.accelerationGain = estimateOf(member(parameters, "acceleration_gain"));
    axis.breakawayEffort = estimateOf(member(parameters, "breakaway_effort"));
    axis.timing = timingOf(value);
    return axis;
}

/// What is no number becomes a gap in the matrix, which checkAxisModel refuses.
void readCovariance(AxisModel& model, const JsonValue* covariance) {
    for (const JsonValue& name : itemsIn(covariance, "names")) {
        model.covarianceNames.push_back(name.isText() ? name.text() : std::string());
    }
    for (const JsonValue& row : itemsIn(covariance, "matrix")) {
        std::vector<double> numbers;
        for (const JsonValue& number : row.isArray() ? row.items() : JsonValue::Array()) {
            if (number.isNumber()) {
                numbers.push_back(number.number());
            }
        }
        model.covariance.push_back(std::move(numbers));
    }
}

Result<AxisModel> readModel(const JsonValue& body, const std::string& origin) {
    for (const auto& possible : {checkLimits(body, origin), checkCovarianceLimits(body, origin)}) {
        if (!possible) {
            return failure(possible.error());
        }
    }
    AxisModel model;
    for (const JsonValue& value : itemsIn(&body, "axes")) {
        auto axis = readAxis(value);
        if (!axis) {
            return failure(axis.error().code, origin + ": " + axis.error().message, axis.error().hint);
        }
        model.axes.push_back(*std::move(axis));
    }
    readCovariance(model, member(&body, "covariance"));
    if (const auto valid = checkAxisModel(model); !valid) {
        return failure(valid.error().code, origin + ": " + valid.error().message, valid.error().hint);
    }
    return model;
}

} // namespace

JsonValue axisModelBody(const AxisModel& model) {
    JsonValue axes = JsonValue::array();
    for (const IdentifiedAxis& axis : model.axes) {
        axes.push(axisBody(axis));
    }
    JsonValue matrix = JsonValue::array();
    for (const std::vector<double>& row : model.covariance) {
        matrix.push(JsonValue(row));
    }
    JsonValue covariance = JsonValue::object();
    covariance.set("names", model.covarianceNames).set("matrix", matrix);
    JsonValue body = JsonValue::object();
    return body.set("axes", axes).set("covariance", covariance);
}

JsonValue axisModelDocument(ResultHeader header, const AxisModel& model) {
    header.schema = AxisModelSchema;
    JsonValue document = toJson(header);
    const JsonValue body = axisModelBody(model);
    for (const JsonMember& entry : body.members()) {
        document.set(entry.key, entry.value);
    }
    return document;
}

bool isAxisModel(const std::string& text) {
    const Result<JsonValue> root = parseJson(text, "");
    return root && textIn(&*root, "schema").starts_with("halbench.axis-model/");
}

Result<AxisModelFile> parseAxisModel(const std::string& text, const std::string& origin) {
    const Result<JsonValue> root = parseJson(text, origin);
    if (!root) {
        return failure(root.error());
    }
    const std::string schema = textIn(&*root, "schema");
    if (schema != AxisModelSchema) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: \"schema\" is \"{}\", this version reads \"{}\"", origin, schema,
                                   AxisModelSchema),
                       Remedy);
    }
    AxisModelFile file{headerOf(*root), {}};
    if (file.header.quality.verdict == Verdict::Refused) {
        return failure(ErrorCode::Refused, origin + ": this estimate was rejected",
                       "check its findings, then identify again");
    }
    auto model = readModel(*root, origin);
    if (!model) {
        return failure(model.error());
    }
    file.model = *std::move(model);
    file.model.doubts = doubtsOfModel(file.header.quality);
    return file;
}

Result<std::optional<AxisModel>> axisModelOf(const JsonValue& body, const std::string& origin) {
    if (body.find("axes") == nullptr) {
        return std::optional<AxisModel>();
    }
    auto model = readModel(body, origin);
    return model ? Result<std::optional<AxisModel>>(*std::move(model)) : failure(model.error());
}

Result<AxisModelFile> readAxisModelFile(const std::string& path) {
    const Result<std::string> text = readFile(path);
    return text ? parseAxisModel(*text, path) : Result<AxisModelFile>(failure(text.error()));
}

} // namespace halbench::app
