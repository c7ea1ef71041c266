#include "app/experiments/run_files.h"

#include "app/documents/text/numbers.h"
#include "app/documents/text/output_file.h"
#include "app/experiments/run_report.h"
#include "app/headless/exit_code.h"
#include "app/headless/recording_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::app {

namespace {

JsonValue stepDocument(const StepOutcome& step) {
    JsonValue document = JsonValue::object();
    document.set("name", step.name).set("kind", step.kind).set("data_quality", toJson(step.quality));
    for (const JsonMember& member : step.body.members()) {
        document.set(member.key, member.value);
    }
    return document;
}

JsonValue checkDocument(const CheckOutcome& check) {
    JsonValue document = JsonValue::object();
    document.set("quantity", check.quantity).set("value", check.value).set("unit", check.unit);
    document.set("min", check.min).set("max", check.max).set("passed", check.passed);
    return document.set("reason", textOrNull(check.reason));
}

std::string xmlText(const std::string& text) {
    std::string escaped;
    for (const char character : text) {
        switch (character) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        default:
            escaped += static_cast<unsigned char>(character) < 0x20 ? ' ' : character;
        }
    }
    return escaped;
}

std::string limitText(const CheckOutcome& check) {
    return fmt::format("{} {} (min {}, max {})", check.value ? formatNumber(*check.value) : "missing",
                       check.unit, check.min ? formatNumber(*check.min) : "none",
                       check.max ? formatNumber(*check.max) : "none");
}

struct TestCase {
    std::string group;
    std::string name;
    std::string failure; ///< empty: passed
    bool isError = false;
};

/// Which files of a run were written, and what stood in the way of the others.
class WrittenFiles {
public:
    explicit WrittenFiles(std::string folder) : m_folder(std::move(folder)) {}

    void add(const std::string& name, const Result<void>& written) {
        (written ? m_written : m_missing).push_back(name);
        if (!written && !m_cause) {
            m_cause = written.error();
        }
    }

    Result<void> result() const {
        if (!m_cause) {
            return {};
        }
        const std::string rest =
            m_written.empty() ? "nothing" : fmt::format("{}", fmt::join(m_written, ", "));
        return failure(m_cause->code,
                       fmt::format("{}; missing in '{}': {}; written: {}", m_cause->message, m_folder,
                                   fmt::join(m_missing, ", "), rest),
                       m_cause->hint);
    }

private:
    std::string m_folder;
    std::vector<std::string> m_written;
    std::vector<std::string> m_missing;
    std::optional<Error> m_cause; ///< the first
};

std::vector<TestCase> testCases(const RunOutcome& outcome) {
    std::vector<TestCase> cases;
    for (const StepOutcome& step : outcome.steps) {
        const bool isRefused = step.quality.verdict == Verdict::Refused;
        cases.push_back({"steps", step.name,
                         !isRefused ? ""
                         : step.quality.findings.empty()
                             ? "refused"
                             : "refused: " + step.quality.findings.front().message});
    }
    if (outcome.stoppedBy) {
        cases.push_back({"steps", "run to the end", errorLine(*outcome.stoppedBy), true});
    }
    for (const CheckOutcome& check : outcome.checks) {
        cases.push_back({"checks", check.quantity, check.passed ? "" : limitText(check)});
    }
    return cases;
}

} // namespace

JsonValue runDocument(const ResultHeader& header, const Experiment& experiment, const RunOutcome& outcome) {
    JsonValue document = toJson(header);
    JsonValue steps = JsonValue::array();
    for (const StepOutcome& step : outcome.steps) {
        steps.push(stepDocument(step));
    }
    JsonValue checks = JsonValue::array();
    for (const CheckOutcome& check : outcome.checks) {
        checks.push(checkDocument(check));
    }
    document.set("title", textOrNull(experiment.title)).set("steps", steps).set("checks", checks);
    document.set("passed", outcome.passed);
    return document.set("error", outcome.stoppedBy ? errorDocument(*outcome.stoppedBy) : JsonValue());
}

std::string junitText(const Experiment& experiment, const RunOutcome& outcome) {
    const std::vector<TestCase> cases = testCases(outcome);
    const auto failures = std::count_if(
        cases.begin(), cases.end(), [](const TestCase& one) { return !one.failure.empty() && !one.isError; });
    const auto errors =
        std::count_if(cases.begin(), cases.end(), [](const TestCase& one) { return one.isError; });
    const std::string title = xmlText(experiment.title.empty() ? "halbench run" : experiment.title);
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    text +=
        fmt::format("<testsuites>\n  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
                    title, cases.size(), failures, errors);
    for (const TestCase& one : cases) {
        text +=
            fmt::format("    <testcase classname=\"{}\" name=\"{}\"", xmlText(one.group), xmlText(one.name));
        if (one.failure.empty()) {
            text += "/>\n";
        } else {
            const char* element = one.isError ? "error" : "failure";
            text += fmt::format(">\n      <{0} message=\"{1}\"/>\n    </testcase>\n", element,
                                xmlText(one.failure));
        }
    }
    return text + "  </testsuite>\n</testsuites>\n";
}

DataQuality runQuality(const RunOutcome& outcome) {
    DataQuality quality;
    for (const StepOutcome& step : outcome.steps) {
        quality.verdict = std::max(quality.verdict, step.quality.verdict);
        for (Finding finding : step.quality.findings) {
            finding.message = step.name + ": " + finding.message;
            quality.findings.push_back(std::move(finding));
        }
    }
    return quality;
}

std::string runText(const RunOutcome& outcome) {
    std::string text;
    for (const CheckOutcome& check : outcome.checks) {
        text +=
            fmt::format("{}  {} = {}\n", check.passed ? "pass" : "FAIL", check.quantity, limitText(check));
    }
    return text + (outcome.passed ? "passed\n" : "failed\n");
}

Result<void> writeRunFiles(const std::string& folder, const ResultHeader& header,
                           const Experiment& experiment, const RunOutcome& outcome, devices::Device& device) {
    WrittenFiles files(folder);
    const auto text = [&](const std::string& name, const Result<std::string>& content) {
        files.add(name, content ? writeFile(folder + "/" + name, *content) : failure(content.error()));
    };
    text("result.json", toJsonText(runDocument(header, experiment, outcome)));
    text("junit.xml", junitText(experiment, outcome));
    for (const StepOutcome& step : outcome.steps) {
        const std::string name = step.name + ".csv";
        if (step.isStreamed) {
            files.add(name, {});
        } else if (const Recording* recording = step.recording()) {
            files.add(name, writeRecording(folder + "/" + name, *recording, device,
                                           {header.started, {}, step.parametersBefore}));
        }
        if (const auto* analysed = std::get_if<AnalysisOutcome>(&step.detail); analysed && analysed->table) {
            files.add(name, writeFile(folder + "/" + name, analysisCsv(*analysed->table)));
        }
    }
    text("report.html", renderRunReport(header, experiment, outcome, device));
    return files.result();
}

} // namespace halbench::app
