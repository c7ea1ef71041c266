#include "app/documents/identification_file.h"

#include "app/documents/document_parts.h"
#include "app/documents/document_units.h"
#include "app/documents/model_file.h"
#include "app/documents/text/output_file.h"

namespace halbench::app {

namespace {

std::vector<SweepPoint> pointsOf(const JsonValue& root) {
    std::vector<SweepPoint> points;
    for (const JsonValue& entry : itemsIn(&root, "points")) {
        const auto current = numberIn(&entry, "current_A");
        const auto speed = numberIn(&entry, "speed_rad_s");
        if (current && speed) {
            points.push_back({*current, *speed, isTrueIn(&entry, "used"),
                              numberIn(&entry, "weight").value_or(0.0), textIn(&entry, "note")});
        }
    }
    return points;
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
    result.highestTemperature_degC = numberIn(&root, "highest_temperature_degC");
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
    const Result<JsonValue> root = parseDocument(text, origin);
    if (!root) {
        return failure(root.error());
    }
    IdentificationFile file;
    file.result = resultOf(*root);
    file.result.covarianceNames = model->estimate.covarianceNames;
    file.result.covariance = model->estimate.covariance;
    file.result.timing = model->estimate.timing;
    file.header = headerOf(*root);
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
