#include "app/batch/command_support.h"
#include "app/batch/judgement_text.h"
#include "app/batch/law_code.h"
#include "app/batch/loop_comparison.h"
#include "app/batch/loop_conditions.h"
#include "app/batch/model_file.h"
#include "app/batch/numbers.h"
#include "app/batch/output_file.h"
#include "app/batch/result_documents.h"
#include "app/batch/what_if_report.h"
#include "app/procedures/disturbance.h"
#include "control/base/assert.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

Result<void> writeColumns(const std::string& path, const std::string& header,
                          const std::vector<const std::vector<double>*>& columns) {
    if (path.empty()) {
        return {};
    }
    std::string text = header + "\n";
    for (std::size_t row = 0; row < columns.front()->size(); ++row) {
        for (std::size_t column = 0; column < columns.size(); ++column) {
            text += (column == 0 ? "" : ",") + formatNumber((*columns[column])[row]);
        }
        text += '\n';
    }
    return writeFile(path, text);
}

/// Closed loop: factor 1. A line each, so that any program can draw it.
Result<void> writePoles(const std::string& path, const AnalysisResult::Roots& roots) {
    if (path.empty()) {
        return {};
    }
    std::string text = "kind,branch,gain_factor,real,imaginary\n";
    const auto add = [&text](const char* kind, std::size_t branch, double factor,
                             std::complex<double> place) {
        text += fmt::format("{},{},{},{},{}\n", kind, branch, formatNumber(factor),
                            formatNumber(place.real()), formatNumber(place.imag()));
    };
    const auto addAll = [&add](const char* kind, double factor,
                               const std::vector<std::complex<double>>& places) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            add(kind, i, factor, places[i]);
        }
    };
    addAll("zero", 0.0, roots.zeros);
    addAll("open", 0.0, roots.openLoop);
    addAll("closed", 1.0, roots.closedLoop);
    for (std::size_t branch = 0; branch < roots.locus.branch.size(); ++branch) {
        for (std::size_t i = 0; i < roots.locus.gain.size(); ++i) {
            add("locus", branch, roots.locus.gain[i], roots.locus.branch[branch][i]);
        }
    }
    return writeFile(path, text);
}

std::string analysisText(const AnalysisResult& result) {
    std::string text = fmt::format("{}\n", result.isStable ? "stable" : "UNSTABLE");
    const JsonValue body = analysisBody(result);
    text += figureLines("margins of the sampled loop", *body.find("margins"));
    if (const JsonValue* step = body.find("step"); step->isObject()) {
        text += figureLines("small step, without friction and current limit", *step);
    }
    if (const JsonValue* step = body.find("large_step"); step->isObject()) {
        text += figureLines("large step, with friction and current limit", *step);
    }
    return text;
}

/// The same judgement as of gains that are designed. An analysis refuses none: what it is asked to show may
/// be unstable.
Result<TuneResult> judgeLoop(ComparedLoop& loop, const ModelFile& model, LoopConditions conditions,
                             std::uint64_t seed) {
    TuneConfig config;
    config.method = loop.gains.method;
    config.conditions = std::move(conditions);
    config.conditions.timing = loop.gains.timing;
    config.seed = seed;
    Result<TuneResult> judged = judgeLaw(model.estimate, loop.gains.law, config);
    if (judged) {
        loop.result.warnings = judged->warnings;
        loop.result.quality.findings = judged->warnings;
        if (judged->quality.verdict != Verdict::Good) {
            loop.result.quality.verdict = Verdict::Doubtful;
        }
    }
    return judged;
}

/// What runs on the board takes its timing with it: each loop is the one its gains were designed for.
Result<ComparedLoop> analyseGains(const std::string& path, const ModelFile& model,
                                  LoopConditions conditions) {
    const Result<GainsFile> gains = readGainsFile(path);
    if (!gains) {
        return failure(gains.error());
    }
    conditions.timing = gains->timing;
    Result<AnalysisResult> result = runAnalysis(model.estimate, gains->law, conditions);
    if (!result) {
        return failure(result.error().code, path + ": " + result.error().message, result.error().hint);
    }
    return ComparedLoop{path, *gains, *std::move(result)};
}

Result<std::vector<ComparedLoop>> analyseAll(const CommandOptions& options, const ModelFile& model,
                                             const LoopConditions& conditions) {
    std::vector<std::string> paths{options.gainsFile};
    paths.insert(paths.end(), options.compared.begin(), options.compared.end());
    std::vector<ComparedLoop> loops;
    for (const std::string& path : paths) {
        Result<ComparedLoop> loop = analyseGains(path, model, conditions);
        if (!loop) {
            return failure(loop.error());
        }
        loops.push_back(*std::move(loop));
    }
    return loops;
}

/// A step of the reference, and beside it what a load does, on the same times; none of an unstable loop.
Result<void> writeStep(const std::string& path, const AnalysisResult::Step& step,
                       const control::LoadStep& loaded) {
    HB_ASSERT(loaded.time_s.size() == step.time_s.size());
    return writeColumns(
        path, "time_s,response_rad,current_A,load_angle_rad,load_current_A",
        {&step.time_s, &step.response_rad, &step.current_A, &loaded.angle_rad, &loaded.current_A});
}

/// Each as it is judged alone; the answer is that of the first.
Result<TuneResult> judgeAll(std::vector<ComparedLoop>& loops, const ModelFile& model,
                            const LoopConditions& conditions, std::uint64_t seed) {
    auto first = judgeLoop(loops.front(), model, conditions, seed);
    for (std::size_t i = 1; i < loops.size(); ++i) {
        if (const auto valid = judgeLoop(loops[i], model, conditions, seed); !valid) {
            return failure(valid.error());
        }
    }
    return first;
}

/// What the other programs and controllers draw and run: of the first gains.
Result<void> writeFiles(const CommandOptions& options, const ModelFile& model, const ComparedLoop& loop,
                        LoopConditions conditions) {
    const AnalysisResult& result = loop.result;
    conditions.timing = loop.gains.timing;
    Result<void> done =
        writeColumns(options.bodeFile, "frequency_hz,magnitude_db,phase_deg",
                     {&result.bode.frequency_Hz, &result.bode.magnitude_dB, &result.bode.phase_deg});
    const auto loaded = disturbanceStep(model.estimate, loop.gains.law, conditions, result);
    done = done ? writeStep(options.stepFile, result.stepCurve, loaded.value_or(control::LoadStep{})) : done;
    done = done ? writePoles(options.polesFile, result.roots) : done;
    return done ? writeLaw(options.codeFile, loop.gains.law, conditions, {loop.gains.method, model.device})
                : done;
}

/// Without --what-if nothing.
Result<std::optional<WhatIfReport>> askWhatIf(const CommandOptions& options, const ModelFile& model,
                                              const ComparedLoop& own, LoopConditions conditions,
                                              std::uint64_t seed) {
    if (options.whatIfRecording.empty()) {
        if (!options.ranFile.empty() || !options.whatIfFile.empty()) {
            return failure(ErrorCode::Usage, "--ran and --motion belong to --what-if",
                           "name the recorded move: --what-if RECORDING");
        }
        return std::optional<WhatIfReport>();
    }
    conditions.timing = own.gains.timing;
    const Result<RanMove> ran = readRanMove(options.whatIfRecording, options.ranFile, conditions);
    if (!ran) {
        return failure(ran.error());
    }
    Result<WhatIfReport> report =
        reportWhatIf(*ran, model.estimate, own.gains.law, {TuneConfig().draws, seed});
    if (!report) {
        return failure(report.error());
    }
    if (!options.whatIfFile.empty()) {
        if (const Result<void> written = writeFile(options.whatIfFile, whatIfTable(*report)); !written) {
            return failure(written.error());
        }
    }
    return std::optional<WhatIfReport>(*std::move(report));
}

bool isAnyRefused(const std::vector<ComparedLoop>& loops) {
    return std::any_of(loops.begin(), loops.end(), [](const ComparedLoop& loop) {
        return loop.result.quality.verdict == Verdict::Refused;
    });
}

} // namespace

CommandResult runAnalyseCommand(CommandContext& context, const CommandOptions& options) {
    const Result<ModelFile> model = readModelFile(options.device);
    if (!model) {
        return failure(model.error());
    }
    Result<LoopConditions> conditions = loopConditionsOf(model->device ? model->device->model : "");
    if (!conditions) {
        return failure(conditions.error());
    }
    if (const Result<void> taken = takeCalibration(*conditions, options.calibrationFile); !taken) {
        return failure(taken.error());
    }
    Result<std::vector<ComparedLoop>> loops = analyseAll(options, *model, *conditions);
    if (!loops) {
        return failure(loops.error());
    }
    const ComparedLoop& own = loops->front();
    ResultHeader header = headerFor(context, "halbench.analysis/1");
    header.device = model->device;
    header.seed = context.global.seed.value_or(model->seed);
    const auto judged = judgeAll(*loops, *model, *conditions, header.seed);
    if (!judged) {
        return failure(judged.error());
    }
    JsonValue document = analysisDocument(header, own.result);
    setJudgement(document, *judged);
    std::string text = analysisText(own.result) + proofLines(*judged) + cycleLines(*judged) +
                       intervalLines(judged->robust) + loopFindingLines(own.result.quality, false);
    if (loops->size() > 1) {
        document.set("compared", comparedLoops({loops->begin() + 1, loops->end()}));
        text += comparisonTable(*loops);
    }
    const auto motion = askWhatIf(options, *model, own, *conditions, header.seed);
    if (!motion) {
        return failure(motion.error());
    }
    if (*motion) {
        document.set("what_if", whatIfBody(**motion));
        text += whatIfText(**motion);
    }
    Result<void> done = writeFiles(options, *model, own, *conditions);
    done = done ? deliver(context, document, text, "") : done;
    if (!done) {
        return failure(done.error());
    }
    const bool isWithheld = *motion && (*motion)->withheld;
    return isAnyRefused(*loops) || isWithheld ? ExitCode::CheckFailed : ExitCode::Done;
}

} // namespace halbench::app
