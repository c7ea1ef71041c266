#include "app/analyses/registry/analyses.h"
#include "app/experiments/step_runs.h"
#include "app/headless/analysis_control.h"
#include "app/headless/analysis_device.h"
#include "devices/recording/recording_meta.h"

#include <algorithm>

namespace halbench::app {

namespace {

/// The keys of a step as the settings of its analysis; the file was judged by the same table.
AnalysisValues valuesOf(const ExperimentStep& step, const Analysis& analysis) {
    AnalysisValues values;
    for (const AnalysisKey& key : analysis.keys) {
        const std::string name(key.name);
        switch (key.type) {
        case AnalysisKeyType::Number:
        case AnalysisKeyType::Integer:
            if (const std::optional<double> number = step.number(key.name)) {
                values.numbers[name] = *number;
            }
            break;
        case AnalysisKeyType::Text:
        case AnalysisKeyType::Choice:
            if (const std::optional<std::string> text = step.text(key.name)) {
                values.texts[name] = *text;
            }
            break;
        case AnalysisKeyType::Flag:
            values.flags[name] = step.isTrue(key.name);
            break;
        }
    }
    return values;
}

/// The recording of an earlier step, as if it had been read from its file.
Result<devices::RecordedFile> recordingOf(StepRun& run, const std::string& name) {
    const auto found = std::find_if(run.earlier.begin(), run.earlier.end(),
                                    [&](const StepOutcome& step) { return step.name == name; });
    const Recording* recording = found == run.earlier.end() ? nullptr : found->recording();
    if (recording == nullptr) {
        return failure(missingResult(name));
    }
    devices::RecordedFile file;
    file.recording = *recording;
    file.meta = devices::describeRecording(run.device, *recording->layout, "");
    file.hasMeta = true;
    return file;
}

} // namespace

Result<StepOutcome> runAnalysisStep(StepRun& run, const ExperimentStep& step, const Analysis& analysis) {
    std::optional<devices::RecordedFile> file;
    const std::string source = step.text("recording").value_or("");
    if (analysis.recording != RecordingUse::None && !source.empty()) {
        Result<devices::RecordedFile> recording = recordingOf(run, source);
        if (!recording) {
            return failure(recording.error());
        }
        file = *std::move(recording);
    }
    AnalysisValues values = valuesOf(step, analysis);
    if (step.isTrue("from_device")) {
        const auto own = deviceValuesFor(analysis, run.device);
        if (!own) {
            return failure(own.error());
        }
        values.device = *own;
    } else if (file) {
        values.device = notedValues(analysis, file->meta);
    }
    const std::string named = values.text("calibration");
    if (const auto* calibration = run.find<CalibrateResult>(named)) {
        if (calibration->quality.verdict == Verdict::Refused) {
            return failure(missingResult(named));
        }
        values.calibrated = calibration->proposed;
    }
    Result<AnalysisOutcome> result =
        analysis.run(values, file ? &*file : nullptr, source, analysisControl(run.context, analysis));
    if (!result) {
        return failure(result.error());
    }
    if (!result->timing.empty()) { // of this machine: not in the files, which equal seeds repeat
        run.context.console.log(LogLevel::Info, step.name + ": " + result->timing);
    }
    StepOutcome outcome;
    outcome.quality = result->quality;
    outcome.body = result->body;
    outcome.detail = *std::move(result);
    return outcome;
}

} // namespace halbench::app
