#include "app/cli/axis_tuning.h"
#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/judgement_text.h"
#include "app/cli/loop_options.h"
#include "app/cli/loop_pictures.h"
#include "app/cli/loop_tables.h"
#include "app/documents/filtered_gains.h"
#include "app/documents/law_code.h"
#include "app/documents/model_file.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/output_file.h"
#include "app/headless/command_header.h"
#include "app/tuning/gains_judgement.h"
#include "app/tuning/loop_comparison.h"
#include "app/tuning/loop_conditions.h"
#include "app/tuning/what_if_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace halbench::app {

namespace {

std::string analysisText(const AnalysisResult& result) {
    std::string text = fmt::format("{}\n", result.isStable ? "stable" : "UNSTABLE");
    const JsonValue body = analysisBody(result);
    const JsonValue& margins = *body.find("margins");
    text += figureLines("margins of the sampled loop", margins);
    const JsonValue* limit = margins.find("gain_limit");
    text += fmt::format("{:<26} {}\n", "limit of the gain",
                        limit->isNull() ? "none" : limit->text() + " of the gain");
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
                             const JudgedWith& with) {
    TuneConfig config;
    config.load_A = with.load_A;
    config.method = loop.gains.method;
    config.conditions = std::move(conditions);
    config.conditions.timing = loop.gains.timing;
    config.seed = with.seed;
    Result<TuneResult> judged = judgeLaw(model.estimate, loop.gains.loopLaw(), config);
    if (judged && loop.timing) {
        addOtherTiming(*judged, *loop.timing);
    }
    if (judged) {
        loop.result.warnings = judged->warnings;
        loop.result.quality.findings = judged->warnings;
        if (judged->quality.verdict != Verdict::Good) {
            loop.result.quality.verdict = Verdict::Doubtful;
        }
    }
    return judged;
}

/// What runs on the board takes its timing with it: each loop is the one its gains were designed for, unless
/// the model knows which one its board has.
Result<ComparedLoop> analyseGains(const std::string& path, const ModelFile& model,
                                  LoopConditions conditions) {
    Result<GainsFile> file = readFilteredGains(path);
    if (!file) {
        return failure(file.error());
    }
    conditions.timing = timingOr(model.estimate.timing, file->timing);
    auto other = otherTiming(file->timing, conditions.timing);
    file->timing = conditions.timing;
    Result<AnalysisResult> result = runAnalysis(model.estimate, file->loopLaw(), conditions);
    if (!result) {
        return failure(result.error().code, path + ": " + result.error().message, result.error().hint);
    }
    return ComparedLoop{path, *std::move(file), *std::move(result), std::move(other)};
}

Result<std::vector<ComparedLoop>> analyseAll(const AnalyseOptions& options, const ModelFile& model,
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

/// Each as it is judged alone; the answer is that of the first.
Result<TuneResult> judgeAll(std::vector<ComparedLoop>& loops, const ModelFile& model,
                            const LoopConditions& conditions, const JudgedWith& with) {
    auto first = judgeLoop(loops.front(), model, conditions, with);
    for (std::size_t i = 1; i < loops.size(); ++i) {
        if (const auto valid = judgeLoop(loops[i], model, conditions, with); !valid) {
            return failure(valid.error());
        }
    }
    return first;
}

/// What the other programs and controllers draw and run: of the first gains.
Result<void> writeFiles(const AnalyseOptions& options, const ModelFile& model, const ComparedLoop& loop,
                        LoopConditions conditions, const JudgedWith& with) {
    conditions.timing = loop.gains.timing;
    const auto written =
        writeLoopTables({options.bodeFile, options.stepFile, options.polesFile},
                        {model.estimate, loop.gains.loopLaw(), conditions, with}, loop.result);
    return written ? writeLaw(options.outputs.codeFile, loop.gains.loopLaw(), conditions,
                              {loop.gains.method, model.device})
                   : written;
}

/// Without --what-if nothing.
Result<std::optional<WhatIfReport>> askWhatIf(const AnalyseOptions& options, const ModelFile& model,
                                              const ComparedLoop& own, LoopConditions conditions,
                                              std::uint64_t seed) {
    if (options.whatIf.recording.empty()) {
        if (!options.whatIf.ranFile.empty() || !options.whatIf.motionFile.empty()) {
            return failure(ErrorCode::Usage, "--ran and --motion belong to --what-if",
                           "name the recorded move: --what-if RECORDING");
        }
        return std::optional<WhatIfReport>();
    }
    conditions.timing = own.gains.timing;
    const Result<RanMove> ran = readRanMove(options.whatIf.recording, options.whatIf.ranFile, conditions);
    if (!ran) {
        return failure(ran.error());
    }
    Result<WhatIfReport> report =
        reportWhatIf(*ran, model.estimate, own.gains.law, {TuneConfig().draws, seed});
    if (!report) {
        return failure(report.error());
    }
    if (!options.whatIf.motionFile.empty()) {
        if (const Result<void> written = writeFile(options.whatIf.motionFile, whatIfTable(*report));
            !written) {
            return failure(written.error());
        }
    }
    return std::optional<WhatIfReport>(*std::move(report));
}

/// The judged loop with those it is compared with beside it.
Result<void> drawPictures(const std::vector<LoopPicture>& pictures, const ModelFile& model,
                          const TuneResult& judged, const std::vector<ComparedLoop>& loops,
                          std::uint64_t seed) {
    DrawnLoop drawn{&judged, &model.estimate, {}, {TuneConfig().draws, seed}};
    for (std::size_t i = 1; i < loops.size(); ++i) {
        drawn.others.push_back({std::filesystem::path(loops[i].path).filename().string(), &loops[i].result});
    }
    return writeLoopPictures(pictures, drawn);
}

/// --disturbance, and the seed of the drawn motors.
Result<JudgedWith> judgedWith(const AnalyseOptions& options, std::uint64_t seed) {
    const Result<std::optional<double>> load = optionalNumber("--disturbance", options.outputs.load);
    if (!load) {
        return failure(load.error());
    }
    if (load->value_or(1.0) <= 0.0) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("--disturbance: {} is not positive", options.outputs.load),
                       "give a positive number");
    }
    return JudgedWith{seed, load->value_or(DisturbanceLoad_A)};
}

bool isAnyRefused(const std::vector<ComparedLoop>& loops) {
    return std::any_of(loops.begin(), loops.end(), [](const ComparedLoop& loop) {
        return loop.result.quality.verdict == Verdict::Refused;
    });
}

CommandResult runAnalyseCommand(CommandContext& context, const AnalyseOptions& options) {
    const auto axes = axisModelIn(options.model);
    if (!axes) {
        return failure(axes.error());
    }
    if (*axes) {
        return analyseAxesOf(context, options, **axes);
    }
    if (const Result<void> fits = refuseAxis(options.axis); !fits) {
        return failure(fits.error());
    }
    const Result<ModelFile> model = readModelFile(options.model);
    if (!model) {
        return failure(model.error());
    }
    Result<LoopConditions> conditions = loopConditionsOf(*model);
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
    const auto pictures = loopPicturesOf(options.outputs.pictures);
    const auto with = judgedWith(options, header.seed);
    if (!pictures || !with) {
        return failure(pictures ? with.error() : pictures.error());
    }
    const auto judged = judgeAll(*loops, *model, *conditions, *with);
    if (!judged) {
        return failure(judged.error());
    }
    JsonValue document = analysisDocument(header, own.result);
    setJudgement(document, *judged);
    std::string text = analysisText(own.result) + proofLines(*judged) + cycleLines(*judged) +
                       disturbanceLines(*judged) + intervalLines(judged->robust) +
                       loopFindingLines(own.result.quality, false);
    text += own.gains.filtered ? shapingLines(*own.gains.filtered) : std::string();
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
    Result<void> done = writeFiles(options, *model, own, *conditions, *with);
    done = done ? drawPictures(*pictures, *model, *judged, *loops, header.seed) : done;
    done = done ? deliver(context, document, text, "") : done;
    if (!done) {
        return failure(done.error());
    }
    const bool isWithheld = *motion && (*motion)->withheld;
    return isAnyRefused(*loops) || isWithheld ? ExitCode::CheckFailed : ExitCode::Done;
}

void addOptions(CommandSyntax& syntax, AnalyseOptions& options) {
    syntax.argument("MODEL.json", options.model, "Identified model");
    syntax.argument("GAINS.json", options.gainsFile, "Gains");
    addModelAxis(syntax, options.axis);
    addCalibration(syntax, options.calibrationFile);
    syntax.option("--bode", options.bodeFile, "Open loop, frequency response", "F.csv");
    syntax.option("--step", options.stepFile, "Closed loop, step response", "F.csv");
    syntax.option("--poles", options.polesFile, "Poles, zeros and root locus", "F.csv");
    syntax.repeatable("--compare", options.compared, "Other gains beside them; repeatable", "GAINS.json");
    syntax.option("--what-if", options.whatIf.recording, "A recorded move, as it would be with these gains",
                  "RECORDING");
    syntax.option("--ran", options.whatIf.ranFile, "Gains of that move; default: as recorded beside it",
                  "GAINS.json");
    syntax.option("--motion", options.whatIf.motionFile, "Recorded and predicted motion of --what-if",
                  "F.csv");
    addLoopOutputs(syntax, options.outputs);
}

CommandOutputs outputsOf(const AnalyseOptions& options) {
    CommandOutputs outputs{{options.bodeFile, options.stepFile, options.polesFile, options.outputs.codeFile,
                            options.whatIf.motionFile},
                           {}};
    addPictureFiles(outputs, options.outputs);
    return outputs;
}

} // namespace

Command analyseCommand() {
    return makeCommand<AnalyseOptions>("analyse", "Margins and step response of a model with gains",
                                       {addOptions, runAnalyseCommand, outputsOf});
}

} // namespace halbench::app
