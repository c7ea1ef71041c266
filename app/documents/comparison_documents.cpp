#include "app/documents/comparison_documents.h"

#include "app/documents/text/numbers.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

std::string textOf(const std::optional<double>& value) {
    return value ? formatNumber(*value) : "-";
}

JsonValue rowDocument(const ComparedRow& row, const std::vector<RowOutcome>& outcomes) {
    JsonValue entry = JsonValue::object();
    entry.set("name", row.name).set("unit", row.unit).set("calibration", row.isCalibration);
    entry.set("device", row.device).set("file", row.file).set("default", row.defaultValue);
    entry.set("state", rowStateName(row.state));
    const auto outcome = std::find_if(outcomes.begin(), outcomes.end(),
                                      [&](const RowOutcome& each) { return each.name == row.name; });
    if (outcome == outcomes.end()) {
        return entry.set("restored", nullptr).set("reason", textOrNull(row.reason));
    }
    return entry.set("restored", outcome->isRestored).set("reason", textOrNull(outcome->reason));
}

} // namespace

std::string comparisonText(const ConfigurationComparison& comparison,
                           const std::vector<RowOutcome>& outcomes) {
    std::string text = fmt::format("{:<28} {:<12} {:>14} {:>14} {:>14}  {}\n", "name", "unit", "device",
                                   "file", "default", "state");
    std::size_t same = 0;
    for (const ComparedRow& row : comparison.rows) {
        if (row.state == RowState::Same) {
            ++same;
            continue;
        }
        const auto outcome = std::find_if(outcomes.begin(), outcomes.end(),
                                          [&](const RowOutcome& each) { return each.name == row.name; });
        std::string state(rowStateName(row.state));
        if (outcome != outcomes.end()) {
            state = outcome->isRestored ? "restored" : "not restored: " + outcome->reason;
        } else if (!row.reason.empty()) {
            state += ": " + row.reason;
        } else if (row.isCalibration && row.state == RowState::Differs) {
            state += ", calibration";
        }
        text += fmt::format("{:<28} {:<12} {:>14} {:>14} {:>14}  {}\n", row.name, row.unit,
                            textOf(row.device), textOf(row.file), textOf(row.defaultValue), state);
    }
    text += fmt::format("{} of {} the same\n", same, comparison.rows.size());
    for (const Finding& finding : comparison.findings) {
        text += fmt::format("{}; {}\n", finding.message, finding.hint);
    }
    return text;
}

JsonValue comparisonDocument(ResultHeader header, const Configuration& file,
                             const ConfigurationComparison& comparison,
                             const std::vector<RowOutcome>& outcomes) {
    std::vector<Finding>& findings = header.quality.findings; // what is known of the device stays
    findings.insert(findings.end(), comparison.findings.begin(), comparison.findings.end());
    JsonValue source = JsonValue::object();
    source.set("model", file.device.model).set("id", file.device.id);
    source.set("firmware", file.device.firmware).set("written", textOrNull(file.written));
    JsonValue rows = JsonValue::array();
    for (const ComparedRow& row : comparison.rows) {
        rows.push(rowDocument(row, outcomes));
    }
    return toJson(header).set("file", source).set("same_device", comparison.isSameDevice).set("rows", rows);
}

} // namespace halbench::app
