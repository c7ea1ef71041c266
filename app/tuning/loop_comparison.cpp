#include "app/tuning/loop_comparison.h"

#include "app/documents/result_documents.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace halbench::app {

namespace {

using Figure = std::optional<double>;

struct Row {
    const char* name;
    Figure (*value)(const AnalysisResult&);
};

using StepFigure = Figure (*)(const control::StepMetrics&);

Figure ofStep(const AnalysisResult& result, StepFigure figure) {
    return result.step ? figure(*result.step) : std::nullopt;
}

Figure largeOvershoot_percent(const AnalysisResult& result) {
    return result.largeStep ? result.largeStep->overshoot_percent() : std::nullopt;
}

Figure rise_s(const control::StepMetrics& step) {
    return step.riseTime_s;
}

Figure overshoot_percent(const control::StepMetrics& step) {
    return step.overshoot_percent;
}

Figure settling_s(const control::StepMetrics& step) {
    return step.settlingTime_s;
}

constexpr Row Rows[] = {
    {"gain margin", [](const AnalysisResult& r) { return Figure(r.margins.gainMargin_ratio); }},
    {"phase margin [deg]", [](const AnalysisResult& r) { return Figure(r.margins.phaseMargin_deg); }},
    {"gain crossover [rad/s]", [](const AnalysisResult& r) { return r.margins.gainCrossover_rad_s; }},
    {"delay margin [s]", [](const AnalysisResult& r) { return Figure(r.margins.delayMargin_s); }},
    {"modulus margin", [](const AnalysisResult& r) { return Figure(r.margins.modulusMargin); }},
    {"rise time [s]", [](const AnalysisResult& r) { return ofStep(r, rise_s); }},
    {"overshoot [%]", [](const AnalysisResult& r) { return ofStep(r, overshoot_percent); }},
    {"settling time [s]", [](const AnalysisResult& r) { return ofStep(r, settling_s); }},
    {"large step, overshoot [%]", largeOvershoot_percent},
    {"large step, settling [s]",
     [](const AnalysisResult& r) { return r.largeStep ? r.largeStep->metrics.settlingTime_s : Figure(); }},
    {"friction band [deg]",
     [](const AnalysisResult& r) { return Figure(radiansToDegrees(r.frictionBand_rad)); }},
    {"gain at once [A/rad]", [](const AnalysisResult& r) { return Figure(r.highFrequencyGain_A_per_rad); }},
};

/// Files are told apart by their names; by their paths where two have the same name.
std::vector<std::string> headings(const std::vector<ComparedLoop>& loops) {
    std::vector<std::string> names;
    for (const ComparedLoop& loop : loops) {
        const std::string name = std::filesystem::path(loop.path).stem().string();
        const auto same = std::count_if(loops.begin(), loops.end(), [&name](const ComparedLoop& other) {
            return std::filesystem::path(other.path).stem() == name;
        });
        names.push_back(same > 1 ? loop.path : name);
    }
    return names;
}

} // namespace

JsonValue comparedLoops(const std::vector<ComparedLoop>& loops) {
    JsonValue list = JsonValue::array();
    for (const ComparedLoop& loop : loops) {
        JsonValue entry = JsonValue::object();
        entry.set("gains_file", loop.path).set("method", loop.gains.method);
        entry.set("data_quality", toJson(loop.result.quality));
        const JsonValue body = analysisBody(loop.result);
        for (const JsonMember& member : body.members()) {
            entry.set(member.key, member.value);
        }
        list.push(entry);
    }
    return list;
}

std::string comparisonTable(const std::vector<ComparedLoop>& loops) {
    const std::vector<std::string> names = headings(loops);
    std::size_t width = 12;
    for (const std::string& name : names) {
        width = std::max(width, name.size());
    }
    std::string text = fmt::format("{:<28}", "compared");
    const auto end = [&text] { text += '\n'; };
    for (const std::string& name : names) {
        text += fmt::format("  {:>{}}", name, width);
    }
    end();
    text += fmt::format("  {:<26}", "stable");
    for (const ComparedLoop& loop : loops) {
        text += fmt::format("  {:>{}}", loop.result.isStable ? "yes" : "NO", width);
    }
    end();
    for (const Row& row : Rows) {
        text += fmt::format("  {:<26}", row.name);
        for (const ComparedLoop& loop : loops) {
            const Figure value = row.value(loop.result);
            const bool isNumber = value && std::isfinite(*value);
            text += fmt::format("  {:>{}}", isNumber ? fmt::format("{:.5g}", *value) : "none", width);
        }
        end();
    }
    text += fmt::format("  {:<26}", "warnings");
    for (const ComparedLoop& loop : loops) {
        text += fmt::format("  {:>{}}", loop.result.warnings.size(), width);
    }
    end();
    return text;
}

} // namespace halbench::app
