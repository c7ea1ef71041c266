#include "app/cli/axis_tuning.h"

#include "app/actuators/actuator.h"
#include "app/cli/axis_tuning_text.h"
#include "app/cli/command_support.h"
#include "app/cli/identify_options.h"
#include "app/cli/loop_pictures.h"
#include "app/cli/loop_tables.h"
#include "app/documents/axis_loop_documents.h"
#include "app/documents/text/numbers.h"
#include "app/documents/text/output_file.h"
#include "app/headless/command_header.h"
#include "app/procedures/apply/apply_axes.h"
#include "app/procedures/base/doubtful_source.h"
#include "app/procedures/tune/loop_axis.h"
#include "app/tuning/axis_conditions.h"
#include "app/tuning/gains_judgement.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

namespace halbench::app {
namespace {

constexpr const char* NotOfAxes = "does not belong to the model of several axes";

/// What needs a motor.
Result<void> refuseForAxes(const TuneOptions& options) {
    return refuseGiven({{"--relay", !options.design.relayFile.empty()},
                        {"--calibration", !options.calibrationFile.empty()},
                        {"--max-sensitivity", !options.design.maxSensitivity.empty()},
                        {"--current-limit-a", !options.design.currentLimit.empty()},
                        {"--step-deg", !options.design.limitedStep.empty()},
                        {"--code", !options.outputs.codeFile.empty()},
                        {"--live", options.isLive},
                        {"--given", !options.given.empty()}},
                       NotOfAxes, "leave it out");
}

Result<void> refuseForAxes(const AnalyseOptions& options) {
    return refuseGiven({{"--calibration", !options.calibrationFile.empty()},
                        {"--code", !options.outputs.codeFile.empty()},
                        {"--compare", !options.compared.empty()},
                        {"--what-if", !options.whatIf.recording.empty()},
                        {"--ran", !options.whatIf.ranFile.empty()},
                        {"--motion", !options.whatIf.motionFile.empty()}},
                       NotOfAxes, "leave it out");
}

Result<std::optional<double>> positive(const std::string& option, const std::string& text) {
    const Result<std::optional<double>> value = optionalNumber(option, text);
    if (value && value->value_or(1.0) <= 0.0) {
        return failure(ErrorCode::OutOfRange, fmt::format("{}: {} is not positive", option, text),
                       "give a positive number");
    }
    return value;
}

Result<TuneAxesConfig> configFrom(const DesignOptions& options, const std::string& disturbance,
                                  std::uint64_t seed) {
    const auto zeta = positive("--zeta", options.zeta);
    const auto omega = positive("--omega-rad-s", options.omega);
    const auto bandwidth = positive("--bandwidth-hz", options.bandwidth);
    const auto margin = positive("--phase-margin-deg", options.phaseMargin);
    const auto load = positive("--disturbance", disturbance);
    for (const auto* value : {&zeta, &omega, &bandwidth, &margin, &load}) {
        if (!*value) {
            return failure(value->error());
        }
    }
    TuneAxesConfig config;
    config.targets = {*zeta, *omega, *bandwidth, *margin};
    config.method = options.method.empty() ? config.method : options.method;
    config.load = *load;
    config.seed = seed;
    return config;
}

/// --gains holds the gains: nothing is designed.
Result<void> refuseDesign(const DesignOptions& options) {
    return refuseGiven({{"--method", !options.method.empty()},
                        {"--zeta", !options.zeta.empty()},
                        {"--omega-rad-s", !options.omega.empty()},
                        {"--bandwidth-hz", !options.bandwidth.empty()},
                        {"--phase-margin-deg", !options.phaseMargin.empty()}},
                       "would design other gains than those of --gains", "leave out one or the other");
}

/// Model, axes, conditions and configuration of one command.
struct AxisWork {
    ResultHeader header;
    std::vector<std::string> axes;
    AxisConditions conditions;
    TuneAxesConfig config;
};

/// `design` and `load`: as the user wrote them.
Result<AxisWork> workOf(CommandContext& context, const AxisModelFile& model, const char* schema,
                        const std::string& axis, const DesignOptions& design, const std::string& load) {
    AxisWork work;
    work.header = headerFor(context, schema);
    work.header.device = model.header.device;
    work.header.seed = context.global.seed.value_or(model.header.seed);
    const auto axes = chosenAxesOf(model.model, axis);
    if (!axes) {
        return failure(axes.error().code, "--axis: " + axes.error().message, axes.error().hint);
    }
    work.axes = *axes;
    auto conditions = axisConditionsOf(model, work.axes);
    auto config = configFrom(design, load, work.header.seed);
    if (!conditions || !config) {
        return failure(!conditions ? conditions.error() : config.error());
    }
    work.conditions = *std::move(conditions);
    work.config = *std::move(config);
    return work;
}

/// Gains that are to run on a device are for its sampling period, unless with --foreign-model.
Result<void> admitGains(const TuneOptions& options, const AxisLaws& laws, const AxisWork& work) {
    const bool isAsked = !options.applyDevice.empty() && !options.takesForeignModel;
    for (std::size_t i = 0; i < work.axes.size() && isAsked; ++i) {
        const auto same = checkPeriodOfGains(laws.timings[i], work.conditions[i].timing);
        if (!same) {
            return failure(same.error().code,
                           fmt::format("--apply: axis {}: {}", work.axes[i], same.error().message),
                           same.error().hint + ", or repeat the command with --foreign-model");
        }
    }
    return {};
}

/// Tables and pictures are of one loop.
Result<std::vector<LoopPicture>> picturesOf(const LoopOutputs& outputs, const LoopTableFiles& tables,
                                            const AxisWork& work) {
    const bool isAsked = !outputs.pictures.empty() || tables.isAny();
    if (isAsked && work.axes.size() > 1) {
        return failure(
            ErrorCode::Usage,
            fmt::format("a table or picture is of one loop, the model has {}", fmt::join(work.axes, ", ")),
            "choose the axis with --axis");
    }
    auto pictures = loopPicturesOf(outputs.pictures);
    for (const LoopPicture& picture : pictures ? *pictures : std::vector<LoopPicture>()) {
        if (picture.view == "large-step" || picture.view == "disturbance") {
            return failure(ErrorCode::Usage, fmt::format("--picture: an axis has no view '{}'", picture.view),
                           "use step: the test step with friction and effort limit");
        }
    }
    return pictures;
}

/// Of the one chosen axis; without any, nothing is written.
Result<void> writeOutputs(const std::vector<LoopPicture>& pictures, const LoopTableFiles& tables,
                          const AxisModel& model, const TuneResult& judged, const AxisWork& work) {
    if (pictures.empty() && !tables.isAny()) {
        return {};
    }
    const MotorEstimate estimate = estimateOfAxis(model, *model.find(work.axes.front()));
    const TuneConfig draws;
    const double load = judged.disturbance ? judged.disturbance->load_A : DisturbanceLoad_A;
    const auto written = writeLoopTables(
        tables, {estimate, {judged.law, judged.filtered}, judged.conditions, {work.header.seed, load}},
        judged.predicted);
    return written ? writeLoopPictures(pictures, {&judged, &estimate, {}, {draws.draws, work.header.seed}})
                   : written;
}

/// `admit`: what the gains need besides, before they are judged.
Result<TuneAxesResult> judgedGains(const std::string& path, const AxisModelFile& model, const AxisWork& work,
                                   const std::function<Result<void>(const AxisLaws&)>& admit) {
    const auto file = readAxisGains(path);
    const auto& identified = model.header.device;
    if (file && file->device && identified && file->device->model != identified->model) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("{}: the gains are for a device '{}', the model is of a '{}'", path,
                                   file->device->model, identified->model),
                       "tune with this model");
    }
    const auto laws = file ? lawsOf(*file, work.axes) : failure(file.error());
    if (!laws) {
        return failure(laws.error());
    }
    if (const auto admitted = admit(*laws); !admitted) {
        return failure(admitted.error());
    }
    auto judged = judgeAxes(model.model, work.conditions, laws->laws, laws->methods, work.config);
    for (std::size_t i = 0; judged && i < judged->axes.size(); ++i) {
        if (const auto timing = otherTiming(laws->timings[i], work.conditions[i].timing)) {
            addOtherTiming(judged->axes[i], *timing);
            judged->quality.verdict = std::max(judged->quality.verdict, Verdict::Doubtful);
            judged->quality.findings.push_back(*timing);
        }
    }
    return judged;
}

/// A model of another kind of actuator has no place here; one of another device of the kind needs a word.
Result<void> admit(const TuneOptions& options, const AxisModelFile& model,
                   const devices::DeviceInfo& device) {
    const auto& identified = model.header.device;
    if (identified && identified->model != device.model) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("--apply: the model is of a device '{}', this one is a '{}'",
                                   identified->model, device.model),
                       "identify this device and use its model for tuning");
    }
    const std::optional<Finding> foreign = foreignMotor(identified, device);
    if (!foreign || device.isSimulated || options.takesForeignModel) {
        return {};
    }
    return failure(ErrorCode::ConsentMissing, "--apply: " + foreign->message,
                   foreign->hint + ", or repeat the command with --foreign-model");
}

/// All axes of the device are written together, unless one is named.
Result<void> checkComplete(const TuneOptions& options, const devices::Catalogue& catalogue,
                           const std::vector<std::string>& axes) {
    if (!options.axis.empty() && options.axis != "all") {
        return {};
    }
    for (const devices::AxisSpec& axis : catalogue.axes) {
        if (std::find(axes.begin(), axes.end(), axis.id) == axes.end()) {
            return failure(ErrorCode::InvalidInput,
                           fmt::format("--apply: there is nothing for axis {} of the device, only for {}",
                                       axis.id, fmt::join(axes, ", ")),
                           "identify all of its axes, or choose the one that is meant with --axis");
        }
    }
    return {};
}

/// The loops are judged as they run on the device.
Result<std::unique_ptr<devices::Device>> openForAxes(CommandContext& context, const TuneOptions& options,
                                                     const AxisModelFile& model, AxisWork& work,
                                                     std::unique_ptr<devices::Device> identified) {
    const bool isSame = identified && options.applyDevice == options.device;
    auto device = isSame ? Result<std::unique_ptr<devices::Device>>(std::move(identified))
                         : openToMove(context, options.applyDevice, [&](const devices::DeviceInfo& opened) {
                               return admit(options, model, opened);
                           });
    if (!device) {
        return device;
    }
    if (const auto complete = checkComplete(options, (*device)->catalogue(), work.axes); !complete) {
        return failure(complete.error());
    }
    auto conditions = axisConditionsOf(**device, work.axes);
    if (!conditions) {
        return failure(conditions.error().code, "--apply: " + conditions.error().message,
                       conditions.error().hint);
    }
    for (std::size_t i = 0; i < work.axes.size(); ++i) {
        const auto same = checkTimingOfModel(model.model.find(work.axes[i])->timing, (*conditions)[i].timing);
        if (!same && !options.takesForeignModel) {
            return failure(same.error().code,
                           fmt::format("--apply: axis {}: {}", work.axes[i], same.error().message),
                           same.error().hint + ", or repeat the command with --foreign-model");
        }
    }
    work.conditions = *std::move(conditions);
    return device;
}

Result<ApplyAxesResult> applyAxes(CommandContext& context, devices::Device& device, const AxisModel& model,
                                  const TuneAxesResult& result) {
    if (result.quality.verdict == Verdict::Refused) {
        const auto& findings = result.quality.findings;
        return failure(
            ErrorCode::Refused,
            (findings.empty() ? std::string("these gains are refused") : findings.front().message) +
                "; nothing was written",
            findings.empty() ? std::string() : findings.front().hint);
    }
    const auto config = applyAxesConfig(device.catalogue(), model, result);
    if (!config) {
        return failure(config.error().code, "--apply: " + config.error().message, config.error().hint);
    }
    if (const Result<void> kept = backUp(context, device); !kept) {
        return failure(kept.error());
    }
    return runApplyAxes(device, *config, observerFor(context));
}

} // namespace

Result<std::optional<AxisModelFile>> axisModelIn(const std::string& path) {
    const Result<std::string> text = readFile(path);
    if (!text || !isAxisModel(*text)) {
        return std::optional<AxisModelFile>();
    }
    auto model = parseAxisModel(*text, path);
    return model ? Result<std::optional<AxisModelFile>>(*std::move(model)) : failure(model.error());
}

Result<void> refuseAxis(const std::string& axis) {
    return refuseGiven({{"--axis", !axis.empty()}}, "belongs to a model of several axes",
                       "leave it out: this one has a single loop");
}

CommandResult tuneAxesOf(CommandContext& context, const TuneOptions& options, const AxisModelFile& model,
                         std::unique_ptr<devices::Device> identified) {
    if (!options.gainsFile.empty()) {
        if (const auto fits = refuseDesign(options.design); !fits) {
            return failure(fits.error());
        }
    }
    if (const auto fits = refuseForAxes(options); !fits) {
        return failure(fits.error());
    }
    auto work =
        workOf(context, model, "halbench.gains/1", options.axis, options.design, options.outputs.load);
    if (!work) {
        return failure(work.error());
    }
    const auto pictures = picturesOf(options.outputs, {}, *work);
    if (!pictures) {
        return failure(pictures.error());
    }
    std::unique_ptr<devices::Device> device;
    if (!options.applyDevice.empty()) {
        auto opened = openForAxes(context, options, model, *work, std::move(identified));
        if (!opened) {
            return failure(opened.error());
        }
        device = *std::move(opened);
    }
    const auto admit = [&](const AxisLaws& laws) { return admitGains(options, laws, *work); };
    auto result = options.gainsFile.empty() ? tuneAxes(model.model, work->conditions, work->config)
                                            : judgedGains(options.gainsFile, model, *work, admit);
    if (!result) {
        return failure(result.error());
    }
    if (const auto drawn = writeOutputs(*pictures, {}, model.model, result->axes.front(), *work); !drawn) {
        return failure(drawn.error());
    }
    std::string text = axisGainsText(*result);
    std::optional<JsonValue> assessment;
    bool isKept = true;
    if (device) {
        const auto applied = applyAxes(context, *device, model.model, *result);
        if (!applied) {
            return failure(applied.error());
        }
        isKept = applied->isKept;
        assessment = appliedAxesBody(*applied);
        addVerification(result->quality, applied->quality);
        text += appliedAxesText(*applied, result->quality.verdict);
    }
    JsonValue document = axisGainsDocument(work->header, *result);
    if (assessment) {
        document.set("applied", *assessment);
    }
    if (const auto done = deliver(context, document, text, options.out); !done) {
        return failure(done.error());
    }
    return isKept ? exitCodeFor(result->quality) : ExitCode::CheckFailed;
}

CommandResult tuneAxesOfDevice(CommandContext& context, const TuneOptions& options,
                               std::unique_ptr<devices::Device> device) {
    TuneOptions tuning = options;
    tuning.given.clear(); // it is the identification's
    if (const auto fits = refuseForAxes(tuning); !fits) {
        return failure(fits.error());
    }
    const Actuator& actuator = actuatorOf(device->info().model);
    SweepOptions sweep;
    sweep.given = options.given;
    Result<IdentifyConfig> config = identifyConfigFrom(sweep, options.axis, actuator);
    if (!config) {
        return failure(config.error());
    }
    AxisModelFile model{headerFor(context, AxisModelSchema, *device), {}};
    config->seed = model.header.seed;
    if (const auto possible = configFrom(tuning.design, tuning.outputs.load, model.header.seed); !possible) {
        return failure(possible.error());
    }
    if (const auto possible = actuator.identify.check(device->catalogue(), *config); !possible) {
        return failure(possible.error());
    }
    const Result<IdentifyOutcome> outcome = actuator.identify.run(*device, *config, observerFor(context));
    if (!outcome) {
        return failure(outcome.error());
    }
    const auto* identified = std::get_if<AxesIdentifyResult>(&*outcome);
    if (identified == nullptr) {
        return failure(ErrorCode::Usage, "this device has several axes, but its identification is of one",
                       "identify it and tune with the file");
    }
    if (identified->quality.verdict == Verdict::Refused) {
        const auto& findings = identified->quality.findings;
        return failure(ErrorCode::Refused,
                       findings.empty() ? std::string("the identification was refused")
                                        : findings.front().message,
                       findings.empty() ? std::string() : findings.front().hint);
    }
    model.model = identified->model;
    model.model.doubts = doubtsOfModel(identified->quality);
    model.header.quality = identified->quality;
    return tuneAxesOf(context, tuning, model, std::move(device));
}

CommandResult analyseAxesOf(CommandContext& context, const AnalyseOptions& options,
                            const AxisModelFile& model) {
    if (const auto fits = refuseForAxes(options); !fits) {
        return failure(fits.error());
    }
    const auto work = workOf(context, model, "halbench.analysis/1", options.axis, {}, options.outputs.load);
    if (!work) {
        return failure(work.error());
    }
    const LoopTableFiles tables{options.bodeFile, options.stepFile, options.polesFile};
    const auto pictures = picturesOf(options.outputs, tables, *work);
    if (!pictures) {
        return failure(pictures.error());
    }
    const auto admitAll = [](const AxisLaws&) { return Result<void>(); };
    auto result = judgedGains(options.gainsFile, model, *work, admitAll);
    if (!result) {
        return failure(result.error());
    }
    // An analysis refuses none: what it is asked to show may be unstable.
    for (TuneResult& axis : result->axes) {
        axis.quality.verdict = std::min(axis.quality.verdict, Verdict::Doubtful);
    }
    result->quality.verdict = std::min(result->quality.verdict, Verdict::Doubtful);
    if (const auto written = writeOutputs(*pictures, tables, model.model, result->axes.front(), *work);
        !written) {
        return failure(written.error());
    }
    const JsonValue document = axisAnalysisDocument(work->header, *result);
    if (const auto done = deliver(context, document, axisAnalysisText(*result), ""); !done) {
        return failure(done.error());
    }
    return ExitCode::Done;
}

} // namespace halbench::app
