#include "app/documents/import_documents.h"

#include "app/documents/text/numbers.h"
#include "devices/recording/recording_csv.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

JsonValue toJson(const devices::CsvDialect& dialect, const devices::CsvSight& sight) {
    JsonValue document = JsonValue::object();
    document.set("separator", devices::separatorWord(dialect.separator))
        .set("decimal", std::string(1, dialect.decimal))
        .set("header", devices::headerWord(dialect.header))
        .set("line_end", sight.hasCrLf ? "CR LF" : "LF")
        .set("byte_order_mark", sight.hasByteOrderMark);
    return document.set("comment_lines", static_cast<std::uint64_t>(sight.comments));
}

JsonValue columnsToJson(const devices::CsvPlan& plan) {
    JsonValue columns = JsonValue::array();
    for (std::size_t i = 0; i < plan.columns.size(); ++i) {
        const devices::CsvColumn& column = plan.columns[i];
        const bool isTime = plan.time == i;
        JsonValue entry = JsonValue::object();
        entry.set("column", static_cast<std::uint64_t>(i + 1))
            .set("header", textOrNull(column.header))
            .set("written_unit", textOrNull(column.written))
            .set("role", isTime ? "time" : "signal")
            .set("signal", isTime ? JsonValue() : JsonValue(column.signal))
            .set("unit", column.isUnitKnown ? JsonValue(column.unit) : JsonValue());
        columns.push(std::move(entry));
    }
    return columns;
}

JsonValue toJson(const std::vector<devices::CsvQuestion>& questions) {
    JsonValue list = JsonValue::array();
    for (const devices::CsvQuestion& question : questions) {
        JsonValue answers = JsonValue::array();
        for (const devices::CsvQuestion::Answer& answer : question.answers) {
            answers.push(JsonValue::object().set("option", answer.option).set("meaning", answer.meaning));
        }
        list.push(JsonValue::object()
                      .set("about", question.about)
                      .set("question", question.text)
                      .set("answers", std::move(answers)));
    }
    return list;
}

std::string columnLine(const devices::CsvPlan& plan, std::size_t index) {
    const devices::CsvColumn& column = plan.columns[index];
    const std::string header = column.header.empty() ? "" : " '" + column.header + "'";
    const std::string unit = !column.isUnitKnown   ? std::string("unit not known")
                             : column.unit.empty() ? std::string("no unit")
                             : column.factor != 1.0 || column.divisor != 1.0 || column.offset != 0.0
                                 ? fmt::format("{}, from {}", column.unit, column.written)
                                 : column.unit;
    return fmt::format("  {}{}: {} ({})\n", index + 1, header, plan.time == index ? "time" : column.signal,
                       unit);
}

void addFinding(DataQuality& quality, Finding finding) {
    quality.verdict = Verdict::Doubtful;
    quality.findings.push_back(std::move(finding));
}

} // namespace

DataQuality qualityOf(const devices::CsvPlan& plan, const devices::CsvImport* import) {
    DataQuality quality;
    for (const devices::CsvColumn& column : plan.columns) {
        if (!column.isUnitKnown && !column.written.empty()) {
            addFinding(quality,
                       {"unit_not_known",
                        fmt::format("unknown unit '{}' of column '{}': numbers are kept without a unit",
                                    column.written, column.header),
                        "give its unit with --unit"});
        }
    }
    if (import == nullptr) {
        return quality;
    }
    if (!import->isUniform) {
        addFinding(quality,
                   {"time_not_uniform",
                    fmt::format("uneven time steps: {} s to {} s", formatNumber(import->shortestStep_s),
                                formatNumber(import->longestStep_s)),
                    "times are not changed; functions that need a constant rate may reject the recording"});
    }
    if (import->missing > 0) {
        quality.findings.push_back(
            {"missing_values", fmt::format("cells without a number: {}, the first in {}", import->missing,
                                           import->firstMissing),
             "they are missing values of the recording; enter them in the table where they are known"});
    }
    if (import->recording.lostRows > 0) {
        addFinding(quality, {"rows_lost", fmt::format("{} rows are missing", import->recording.lostRows),
                             "positions in the .meta.json file"});
    }
    return quality;
}

JsonValue importDocument(const ResultHeader& header, const devices::CsvPlan& plan,
                         const devices::CsvImport* import) {
    JsonValue document = toJson(header);
    document.set("dialect", plan.dialect ? toJson(*plan.dialect, plan.sight) : JsonValue())
        .set("columns", columnsToJson(plan))
        .set("first_lines", plan.firstLines)
        .set("questions", toJson(plan.questions));
    if (import != nullptr) {
        document.set("rows", static_cast<std::uint64_t>(import->recording.rows()))
            .set("missing_values", import->missing)
            .set("period_s", import->recording.layout->period_s)
            .set("shortest_step_s", import->shortestStep_s)
            .set("longest_step_s", import->longestStep_s)
            .set("uniform", import->isUniform)
            .set("lost_rows", import->recording.lostRows);
    }
    return document;
}

devices::RecordingMeta importedMeta(const ResultHeader& header, const Recording& recording) {
    devices::RecordingMeta meta;
    meta.started = header.started;
    meta.software = HALBENCH_VERSION;
    for (const StreamLayout::Column& column : recording.layout->columns) {
        meta.signals.push_back(
            {column.name, devices::csvColumnName(column.name, column.unit), column.unit, ""});
    }
    return meta;
}

std::string previewText(const devices::CsvPlan& plan) {
    std::string text;
    if (plan.dialect) {
        text += fmt::format("separator {}, decimal sign {}, header {}, line ends {}{}, {} comment lines\n",
                            devices::separatorWord(plan.dialect->separator), plan.dialect->decimal,
                            devices::headerWord(plan.dialect->header), plan.sight.hasCrLf ? "CR LF" : "LF",
                            plan.sight.hasByteOrderMark ? ", byte order mark" : "", plan.sight.comments);
    }
    text += plan.columns.empty() ? "" : "columns:\n";
    for (std::size_t i = 0; i < plan.columns.size(); ++i) {
        text += columnLine(plan, i);
    }
    text += "first lines:\n";
    for (const std::string& line : plan.firstLines) {
        text += "  " + line + "\n";
    }
    for (const devices::CsvQuestion& question : plan.questions) {
        text += question.text + ":\n";
        for (const devices::CsvQuestion::Answer& answer : question.answers) {
            text += fmt::format("  {}: {}\n", answer.option, answer.meaning);
        }
    }
    return text;
}

} // namespace halbench::app
