#include "app/analyses/spherical/coverage_analysis.h"

#include "app/analyses/spherical/placement_choice.h"
#include "app/analyses/spherical/proof_json.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/result_text.h"
#include "control/base/units.h"
#include "models/spherical/coverage/placement_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

/// Shares of the progress: count, map, proof.
constexpr double CountShare = 0.5;
constexpr double MapShare = 0.9;

struct Coverage {
    PlacementChoice choice;
    double threshold_T = 0.01;
    double noise_T = 100e-6;
    models::CoverageQuantity quantity = models::CoverageQuantity::LeastComponent_T;
    models::PoseGrid grid;
    models::CoverageCount count;
    std::vector<float> map;
    models::CoverageProof proof;
    models::PlacementResult figures;
};

std::vector<AnalysisKey> coverageKeys() {
    using enum AnalysisKeyType;
    std::vector<AnalysisKey> keys = placementKeys();
    const std::vector<AnalysisKey> own = {
        {"threshold_mT", Number, 0, 1e3, "", "least reading that counts; default 10"},
        {"step_deg", Number, 0.1, 45, "", "distance of the poses of the count, divides 45; default 1"},
        {"noise_uT", Number, 1e-3, 1e5, "", "noise of a reading for the predicted error, rms; default 100"},
        {"map", Choice, 0, 0, "component|singular|error",
         "quantity of the map: least component, least singular value, predicted error"},
        {"map_step_deg", Number, 0.5, 45, "", "distance of the poses of the map, divides 45; default 5"},
    };
    keys.insert(keys.end(), own.begin(), own.end());
    return keys;
}

models::WorkControl workControl(const AnalysisControl& control, double from, double to) {
    models::WorkControl work;
    work.isStopped = control.isStopped;
    if (control.onProgress) {
        work.onProgress = [&control, from, to](double share) {
            control.onProgress(from + share * (to - from));
        };
    }
    return work;
}

Result<models::PoseGrid> gridOf(double step_deg, const char* key) {
    const double cells = 45.0 / step_deg;
    if (std::abs(cells - std::round(cells)) > 1e-9 * cells) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} = {} does not divide 45 degrees", key, step_deg),
                       "use 0.5, 1, 2.5, 5 or 9");
    }
    return models::workspaceGrid(degreesToRadians(step_deg));
}

Result<void> compute(const AnalysisValues& values, const AnalysisControl& control, Coverage& work) {
    const models::CoverageModel model = work.choice.coverageModel();
    const Result<models::PoseGrid> fine = gridOf(values.numberOr("step_deg", 1.0), "step_deg");
    const Result<models::PoseGrid> coarse = gridOf(values.numberOr("map_step_deg", 5.0), "map_step_deg");
    if (!fine || !coarse) {
        return failure(!fine ? fine.error() : coarse.error());
    }
    work.grid = *coarse;
    const auto count =
        models::countCoverage(model, work.threshold_T, *fine, workControl(control, 0.0, CountShare));
    if (!count) {
        return failure(count.error());
    }
    work.count = *count;
    auto map = models::coverageMap(model, work.quantity, work.noise_T, work.grid,
                                   workControl(control, CountShare, MapShare));
    if (!map) {
        return failure(map.error());
    }
    work.map = *std::move(map);
    models::CoverageProofConfig config;
    config.threshold_T = work.threshold_T;
    const auto proof = models::proveCoverage(model, config, workControl(control, MapShare, 1.0));
    if (!proof) {
        return failure(proof.error());
    }
    work.proof = *proof;
    work.figures = models::assessPlacement(work.choice.device, work.choice.placement, work.noise_T);
    return {};
}

JsonValue countJson(const Coverage& work) {
    const models::CoverageCount& count = work.count;
    JsonValue components = JsonValue::array();
    for (std::size_t i = 0; i < models::ComponentCount; ++i) {
        JsonValue component = JsonValue::object();
        component.set("component", ComponentNames[i]).set("uncovered", count.uncoveredBy[i]);
        const models::OrientationAngles& at = count.leastAt[i];
        component.set("least_T", count.least_T[i]);
        components.push(component.set("least_at", anglesJson(at.alpha_rad, at.beta_rad, at.gamma_rad)));
    }
    JsonValue document = JsonValue::object();
    document.set("poses", count.poses).set("uncovered", count.uncovered);
    document.set("uncovered_ratio", count.uncovered_ratio());
    JsonValue box;
    if (count.uncovered > 0) {
        box = JsonValue::object();
        box.set("low", anglesJson(count.low.alpha_rad, count.low.beta_rad, count.low.gamma_rad));
        box.set("high", anglesJson(count.high.alpha_rad, count.high.beta_rad, count.high.gamma_rad));
    }
    return document.set("uncovered_box", box).set("components", components);
}

JsonValue toBody(const Coverage& work) {
    JsonValue body = JsonValue::object();
    body.set("placement", placementJson(work.choice.device, work.choice.placement));
    body.set("threshold_T", work.threshold_T).set("noise_T", work.noise_T);
    body.set("count", countJson(work)).set("proof", proofJson(work.proof));
    JsonValue map = JsonValue::object();
    const auto [low, high] = std::minmax_element(work.map.begin(), work.map.end());
    map.set("quantity", models::CoverageQuantityNames[static_cast<std::size_t>(work.quantity)]);
    map.set("poses", static_cast<std::uint64_t>(work.map.size()));
    body.set("map", map.set("least", static_cast<double>(*low)).set("largest", static_cast<double>(*high)));
    const bool hasTensor = work.figures.conditioning > 0.0;
    body.set("conditioning", hasTensor ? JsonValue(work.figures.conditioning) : JsonValue());
    return body.set("predicted_error_deg",
                    hasTensor ? JsonValue(radiansToDegrees(work.figures.deviation_rad)) : JsonValue());
}

AnalysisTable toTable(const Coverage& work) {
    constexpr std::array Columns = {"least_T", "singular_T_per_rad", "error_rad"};
    AnalysisTable table;
    table.columns = {"alpha_rad", "beta_rad", "gamma_rad", Columns[static_cast<std::size_t>(work.quantity)]};
    const auto gammas = static_cast<std::size_t>(work.grid.gamma.count);
    const auto betas = static_cast<std::size_t>(work.grid.beta.count);
    for (std::size_t i = 0; i < work.map.size(); ++i) {
        table.values.insert(table.values.end(), {work.grid.alpha.at(static_cast<int>(i / gammas / betas)),
                                                 work.grid.beta.at(static_cast<int>(i / gammas % betas)),
                                                 work.grid.gamma.at(static_cast<int>(i % gammas)),
                                                 static_cast<double>(work.map[i])});
    }
    return table;
}

/// Over the spin: what the sensors read at least, whatever the tilt.
AnalysisPlot plotOf(const Coverage& work) {
    constexpr double SpinStep_rad = Pi / 180.0;
    constexpr double TiltStep_rad = 2.5 * Pi / 180.0;
    const models::CoverageModel model = work.choice.coverageModel();
    const models::AngleRange spins = models::workspaceGrid(SpinStep_rad).gamma;
    const models::PoseGrid tilts = models::workspaceGrid(TiltStep_rad);
    AnalysisPlot plot{"Least reading over all tilts", {"gamma", "deg"}, {}};
    for (std::size_t c = 0; c < models::ComponentCount; ++c) {
        plot.panels.push_back(
            {{ComponentNames[c], "mT"}, {AnalysisCurve{"", {}, {}}}, 1e3 * work.threshold_T});
    }
    for (int spin = 0; spin < spins.count; ++spin) {
        std::array<double, models::ComponentCount> least_T;
        least_T.fill(HUGE_VAL);
        for (int a = 0; a < tilts.alpha.count; ++a) {
            for (int b = 0; b < tilts.beta.count; ++b) {
                const models::SphericalReadings readings_T =
                    model.readings_T({tilts.alpha.at(a), tilts.beta.at(b), spins.at(spin)});
                for (std::size_t c = 0; c < least_T.size(); ++c) {
                    least_T[c] =
                        std::min(least_T[c], models::largestOfComponent_T(readings_T, static_cast<int>(c)));
                }
            }
        }
        for (std::size_t c = 0; c < least_T.size(); ++c) {
            AnalysisCurve& curve = plot.panels[c].curves.front();
            curve.x.push_back(radiansToDegrees(spins.at(spin)));
            curve.y.push_back(1e3 * least_T[c]);
        }
    }
    for (std::size_t c = 0; c < models::ComponentCount; ++c) {
        const models::ComponentProof& proof = work.proof.component[c];
        if (proof.verdict == models::CoverageVerdict::Refuted) {
            plot.panels[c].curves.push_back(
                {"counterexample", {radiansToDegrees(proof.leastAt.gamma_rad)}, {1e3 * proof.least_T}, true});
        }
    }
    plot.caption = "Largest magnitude of the three sensors at each spin, at that of the tilts every 2.5 "
                   "degrees where it is least.";
    return plot;
}

std::string summaryOf(const Coverage& work) {
    std::string text =
        fmt::format("coverage of the workspace at {} mT\n", formatNumber(1e3 * work.threshold_T));
    text += fmt::format("  {} of {} poses uncovered ({:.4f} %)\n", work.count.uncovered, work.count.poses,
                        100.0 * work.count.uncovered_ratio());
    text += placementText(work.choice.device, work.choice.placement);
    text += proofText(work.proof, work.threshold_T);
    if (work.figures.conditioning > 0.0) {
        text += fmt::format("  conditioning {:.3f}, predicted angle error {:.4f} deg rms at {} uT\n",
                            work.figures.conditioning, radiansToDegrees(work.figures.deviation_rad),
                            formatNumber(1e6 * work.noise_T));
        text += "  the tensor solver works in uncovered poses with the same accuracy\n";
    }
    return text;
}

Result<AnalysisOutcome> runCoverage(const AnalysisValues& values, const devices::RecordedFile*,
                                    const std::string&, const AnalysisControl& control) {
    Coverage work;
    const Result<PlacementChoice> choice = placementChoice(values);
    if (!choice) {
        return failure(choice.error());
    }
    work.choice = *choice;
    work.threshold_T = values.numberOr("threshold_mT", 10.0) / 1e3;
    work.noise_T = noiseChoice_T(values);
    work.quantity =
        static_cast<models::CoverageQuantity>(choiceIndex(models::CoverageQuantityNames, values.text("map")));
    if (const Result<void> done = compute(values, control, work); !done) {
        return failure(done.error());
    }
    AnalysisOutcome result;
    result.body = toBody(work);
    result.summary = summaryOf(work);
    result.table = toTable(work);
    result.plots.push_back(plotOf(work));
    return result;
}

} // namespace

Analysis coverageAnalysis() {
    return {"coverage",
            "halbench.coverage/1",
            "Coverage of three field sensors: proof or counterexample, and the error to expect",
            RecordingUse::None,
            true,
            coverageKeys(),
            runCoverage,
            sensingDevice(),
            true};
}

} // namespace halbench::app
