#include "app/analyses/spherical/placement_analysis.h"

#include "app/analyses/spherical/placement_choice.h"
#include "app/analyses/spherical/proof_json.h"
#include "app/documents/text/names.h"
#include "app/documents/text/numbers.h"
#include "control/base/units.h"
#include "models/spherical/coverage/placement_search.h"

#include <fmt/format.h>

#include <array>

namespace halbench::app {

namespace {

constexpr std::array<std::string_view, 3> ObjectiveNames = {"coverage", "conditioning", "error"};
constexpr std::size_t ShownRows = 10;

std::vector<AnalysisKey> searchKeys() {
    using enum AnalysisKeyType;
    std::vector<AnalysisKey> keys = {
        {"objective", Choice, 0, 0, "coverage|conditioning|error",
         "largest worst reading (default), best conditioning or smallest predicted error"},
    };
    for (const AnalysisKey& key : placementKeys()) {
        if (key.name != "placement") {
            keys.push_back(key);
        }
    }
    const std::vector<AnalysisKey> own = {
        {"step_deg", Number, 1, 45, "", "step of the lattice of placements, divides 45; default 5"},
        {"theta_deg", Text, 0, 0, "", "region where sensors may sit, from Z; default 0:180"},
        {"phi_deg", Text, 0, 0, "", "region where sensors may sit, from X; default -180:180"},
        {"distance_mm", Number, 0, 1000, "", "least distance between two sensors; default 5"},
        {"range_mT", Number, 1, 1e4, "", "range that no reading of any sensor may exceed; default any"},
        {"threshold_mT", Number, 0, 1e3, "", "least reading that the proof asks for; default 10"},
        {"noise_uT", Number, 1e-3, 1e5, "", "noise of a reading for the predicted error, rms; default 100"},
    };
    keys.insert(keys.end(), own.begin(), own.end());
    return keys;
}

/// "20:160" in degrees, from `least_deg` to 180.
Result<void> readRegion(const AnalysisValues& values, const char* key, double least_deg, double& low_rad,
                        double& high_rad) {
    const std::string text = values.text(key);
    if (text.empty()) {
        return {};
    }
    const std::vector<std::string> parts = splitList(text, ':');
    const std::optional<double> low = parts.size() == 2 ? parseNumber(parts[0]) : std::nullopt;
    const std::optional<double> high = parts.size() == 2 ? parseNumber(parts[1]) : std::nullopt;
    const bool isRange = low && high && *low <= *high && *low >= least_deg && *high <= 180.0;
    if (!isRange) {
        return failure(
            ErrorCode::Usage, fmt::format("{} = {} is no range of angles", optionOf(AnalysisKey{key}), text),
            fmt::format("write FROM:TO in degrees within {:g}:180, the smaller one first", least_deg));
    }
    low_rad = degreesToRadians(*low);
    high_rad = degreesToRadians(*high);
    return {};
}

Result<models::PlacementSearchConfig> configFrom(const AnalysisValues& values) {
    const Result<models::PlacementDevice> device = deviceChoice(values);
    if (!device) {
        return failure(device.error());
    }
    models::PlacementSearchConfig config;
    config.device = *device;
    config.objective =
        static_cast<models::PlacementObjective>(choiceIndex(ObjectiveNames, values.text("objective")));
    models::PlacementConstraints& limits = config.constraints;
    Result<void> read = readRegion(values, "theta_deg", 0.0, limits.lowestTheta_rad, limits.highestTheta_rad);
    read = read ? readRegion(values, "phi_deg", -180.0, limits.lowestPhi_rad, limits.highestPhi_rad) : read;
    if (!read) {
        return failure(read.error());
    }
    limits.leastDistance_m = values.numberOr("distance_mm", 5.0) / 1e3;
    if (const std::optional<double> range_mT = values.number("range_mT")) {
        limits.sensorRange_T = *range_mT / 1e3;
    }
    config.latticeStep_rad = degreesToRadians(values.numberOr("step_deg", 5.0));
    config.threshold_T = values.numberOr("threshold_mT", 10.0) / 1e3;
    config.noise_T = noiseChoice_T(values);
    return config;
}

JsonValue rowJson(const models::PlacementDevice& device, const models::PlacementResult& row) {
    JsonValue document = JsonValue::object();
    document.set("least_T", row.least_T);
    const bool hasTensor = row.conditioning > 0.0;
    document.set("conditioning", hasTensor ? JsonValue(row.conditioning) : JsonValue());
    document.set("predicted_error_deg",
                 hasTensor ? JsonValue(radiansToDegrees(row.deviation_rad)) : JsonValue());
    return document.set("placement", placementJson(device, row.placement));
}

std::string rowText(const models::PlacementResult& row) {
    const auto sensor = [&](std::size_t i) {
        const models::PlacementAngles& at = row.placement[i];
        return anglesText(at.alpha_rad, at.beta_rad, at.gamma_rad);
    };
    const std::string conditioning = row.conditioning > 0.0 ? fmt::format("{:.3f}", row.conditioning) : "-";
    return fmt::format("  {:>8.2f} {:>12} {:>9.4f}  {:<16} {}\n", 1e3 * row.least_T, conditioning,
                       radiansToDegrees(row.deviation_rad), sensor(1), sensor(2));
}

std::string summaryOf(const models::PlacementSearchConfig& config, const models::PlacementSearch& search) {
    std::string text = fmt::format("best of {} pairs of places by {}\n", search.pairs,
                                   ObjectiveNames[static_cast<std::size_t>(config.objective)]);
    const std::string head = fmt::format("  {:>8} {:>12} {:>9}  {:<16} {}\n", "least mT", "conditioning",
                                         "error deg", "sensor 1", "sensor 2");
    text += head + rowText(search.best) + proofText(search.proof, config.threshold_T);
    text += fmt::format("Pareto set, {} placements\n", search.pareto.size()) + head;
    for (std::size_t i = 0; i < std::min(ShownRows, search.pareto.size()); ++i) {
        text += rowText(search.pareto[i]);
    }
    return text + placementOrderText(config.device);
}

/// The Pareto set over the least reading, with the winner.
AnalysisPlot plotOf(const models::PlacementSearch& search) {
    AnalysisPlot plot{"Pareto set of the placements", {"least reading", "mT"}, {}};
    const auto panel = [&search](const AnalysisScale& y, auto value) {
        const auto curve = [&](const char* name, const std::vector<models::PlacementResult>& rows) {
            AnalysisCurve points{name, {}, {}, true};
            for (const models::PlacementResult& row : rows) {
                if (row.conditioning > 0.0) { // the tensor can be told
                    points.x.push_back(1e3 * row.least_T);
                    points.y.push_back(value(row));
                }
            }
            return points;
        };
        return AnalysisPanel{y, {curve("Pareto set", search.pareto), curve("best", {search.best})}};
    };
    plot.panels.push_back(
        panel({"conditioning", ""}, [](const models::PlacementResult& row) { return row.conditioning; }));
    plot.panels.push_back(panel({"predicted error", "deg"}, [](const models::PlacementResult& row) {
        return radiansToDegrees(row.deviation_rad);
    }));
    return plot;
}

Result<AnalysisOutcome> runPlacement(const AnalysisValues& values, const devices::RecordedFile*,
                                     const std::string&, const AnalysisControl& control) {
    const Result<models::PlacementSearchConfig> config = configFrom(values);
    if (!config) {
        return failure(config.error());
    }
    const auto search = models::searchPlacement(*config, {control.isStopped, control.onProgress});
    if (!search) {
        return failure(search.error());
    }
    AnalysisOutcome result;
    result.body.set("objective", ObjectiveNames[static_cast<std::size_t>(config->objective)]);
    const JsonValue best = rowJson(config->device, search->best);
    for (const JsonMember& member : best.members()) {
        result.body.set(member.key, member.value);
    }
    JsonValue pareto = JsonValue::array();
    for (const models::PlacementResult& row : search->pareto) {
        pareto.push(rowJson(config->device, row));
    }
    result.body.set("threshold_T", config->threshold_T).set("noise_T", config->noise_T);
    result.body.set("proof", proofJson(search->proof)).set("pareto", pareto).set("pairs", search->pairs);
    result.summary = summaryOf(*config, *search);
    result.plots.push_back(plotOf(*search));
    return result;
}

} // namespace

Analysis placementAnalysis() {
    return {"place",
            "halbench.placement/1",
            "Search for the places of field sensors, with the proof of the winner",
            RecordingUse::None,
            false,
            searchKeys(),
            runPlacement,
            sensingDevice(),
            true};
}

} // namespace halbench::app
