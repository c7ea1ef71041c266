#include "app/analyses/spherical/differences_analysis.h"

#include "app/analyses/spherical/placement_choice.h"
#include "control/base/units.h"
#include "models/spherical/coverage/difference_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {

namespace {

constexpr std::array<std::string_view, 2> FunctionNames = {"first", "second"};
constexpr double DefaultStep_deg = 5.0;
constexpr double WholeSteps_deg = 45.0;
constexpr std::size_t ListedPlaces = 40;

std::vector<AnalysisKey> differenceKeys() {
    using enum AnalysisKeyType;
    std::vector<AnalysisKey> keys = {
        {"function", Choice, 0, 0, "first|second",
         "first places sensor 1 against the main one, second sensor 2 against both; default first"}};
    for (const AnalysisKey& key : placementKeys()) {
        if (key.name != "placement") { // it is the published one that is ranked
            keys.push_back(key);
        }
    }
    keys.push_back({"step_deg", Number, 1, 45, "", "step of the lattice of places, divides 45; default 5"});
    keys.push_back({"pose_step_deg", Number, 1, 45, "", "step of the poses, divides 45; default 5"});
    return keys;
}

Result<double> stepOf(const AnalysisValues& values, const char* key) {
    const double step_deg = values.numberOr(key, DefaultStep_deg);
    if (std::abs(std::remainder(WholeSteps_deg, step_deg)) > 1e-9) {
        return failure(ErrorCode::Usage, fmt::format("{} = {:g} does not divide 45", key, step_deg),
                       "use 1, 1.5, 2.5, 3, 5, 7.5, 9, 15, 22.5 or 45");
    }
    return degreesToRadians(step_deg);
}

struct Row {
    bool isAbsolute;
    models::DifferenceReduction reduction;
    models::DifferenceRanking ranking;
};

JsonValue rowJson(const Row& row) {
    JsonValue places = JsonValue::array();
    for (std::size_t i = 0; i < std::min(ListedPlaces, row.ranking.bestAt.size()); ++i) {
        const models::PlacementAngles& at = row.ranking.bestAt[i];
        places.push(anglesJson(at.alpha_rad, at.beta_rad, at.gamma_rad));
    }
    JsonValue document = JsonValue::object();
    document.set("difference", row.isAbsolute ? "absolute" : "signed");
    document.set("reduction", models::DifferenceReductionNames[static_cast<std::size_t>(row.reduction)]);
    document.set("best_T2", row.ranking.best_T2);
    document.set("ties", static_cast<std::uint64_t>(row.ranking.bestAt.size()));
    document.set("claimed_T2", row.ranking.claimed_T2);
    return document.set("claimed_rank", row.ranking.rank).set("best_at", places);
}

std::string rowText(const Row& row) {
    const models::PlacementAngles& at = row.ranking.bestAt.front();
    return fmt::format("  {:<9} {:<5} {:>9.5f}  {:<16} {:>5} {:>10.5f} {:>6}\n",
                       row.isAbsolute ? "absolute" : "signed",
                       models::DifferenceReductionNames[static_cast<std::size_t>(row.reduction)],
                       row.ranking.best_T2, anglesText(at.alpha_rad, at.beta_rad, at.gamma_rad),
                       row.ranking.bestAt.size(), row.ranking.claimed_T2, row.ranking.rank);
}

Result<AnalysisOutcome> runDifferences(const AnalysisValues& values, const devices::RecordedFile*,
                                       const std::string&, const AnalysisControl& control) {
    const Result<models::PlacementDevice> device = deviceChoice(values);
    const Result<double> step_rad = stepOf(values, "step_deg");
    const Result<double> pose_rad = stepOf(values, "pose_step_deg");
    if (!device || !step_rad || !pose_rad) {
        return failure(!device ? device.error() : !step_rad ? step_rad.error() : pose_rad.error());
    }
    const std::size_t which = choiceIndex(FunctionNames, values.text("function"));
    const models::SensorTriple published = models::publishedPlacement();
    const models::PoseGrid lattice = models::placementLattice(*step_rad);
    const auto all = models::differenceValues(*device, static_cast<models::DifferenceFunction>(which),
                                              published[1], lattice, models::workspaceGrid(*pose_rad),
                                              {control.isStopped, control.onProgress});
    if (!all) {
        return failure(all.error());
    }
    AnalysisOutcome outcome;
    JsonValue rows = JsonValue::array();
    outcome.summary = fmt::format("difference function {} of sensor {}, {} places\n"
                                  "  {:<9} {:<5} {:>9}  {:<16} {:>5} {:>10} {:>6}\n",
                                  FunctionNames[which], which + 1, all->size(), "", "", "best T^2", "at",
                                  "ties", "published", "rank");
    for (const bool isAbsolute : {false, true}) {
        for (std::size_t k = 0; k < models::DifferenceReductionNames.size(); ++k) {
            const auto reduction = static_cast<models::DifferenceReduction>(k);
            auto ranking = models::rankDifference(*all, lattice, isAbsolute, reduction, published[which + 1]);
            if (!ranking) {
                return failure(ranking.error());
            }
            const Row row{isAbsolute, reduction, *std::move(ranking)};
            rows.push(rowJson(row));
            outcome.summary += rowText(row);
        }
    }
    outcome.body.set("function", FunctionNames[which]);
    outcome.body.set("places", static_cast<std::uint64_t>(all->size())).set("rows", rows);
    return outcome;
}

} // namespace

Analysis differencesAnalysis() {
    return {"differences",
            "halbench.differences/1",
            "Published difference functions of a sensor placement, with every reduction and all ranks",
            RecordingUse::None,
            false,
            differenceKeys(),
            runDifferences};
}

} // namespace halbench::app
