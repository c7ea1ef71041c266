#include "app/experiments/step_configs.h"

#include "app/documents/pose_table_file.h"
#include "app/documents/presets.h"
#include "app/documents/text/names.h"
#include "app/documents/text/procedure_choices.h"
#include "app/procedures/base/axis_choice.h"
#include "app/procedures/excite/move_reference_keys.h"
#include "app/procedures/excite/travel_reference.h"
#include "app/procedures/frequency/axes_frequency.h"
#include "app/procedures/frequency/frequency_board.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace halbench::app {

namespace {

tl::unexpected<Error> at(const ConfigNode& node, Error error) {
    error.message = node.where() + ": " + error.message;
    return failure(std::move(error));
}

Result<void> checkValues(const ConfigNode& place, const std::vector<ParameterValue>& values,
                         const devices::Catalogue& catalogue) {
    for (const ParameterValue& value : values) {
        const ParameterSpec* spec = catalogue.findParameter(value.name);
        if (spec == nullptr) {
            return at(place, unknownName(catalogue, value.name));
        }
        if (const Result<void> valid = checkParameterValue(*spec, value.value); !valid) {
            return at(place, valid.error());
        }
    }
    return {};
}

Result<void> checkIdentify(const ExperimentStep& step, const devices::Catalogue& catalogue,
                           const Actuator& actuator) {
    const Result<IdentifyConfig> config = identifyConfigOf(step, actuator);
    if (!config) {
        return failure(config.error());
    }
    const Result<void> valid = actuator.identify.check(catalogue, *config);
    const ConfigNode* sweep = step.find("currents_A");
    return valid ? valid : at(sweep != nullptr ? *sweep : step.keys, valid.error());
}

Result<void> checkCalibrate(const ExperimentStep& step, const devices::Catalogue& catalogue,
                            const Actuator& actuator) {
    const Result<CalibrateConfig> config = calibrateConfigOf(step);
    if (!config) {
        return failure(config.error());
    }
    const Result<void> valid = actuator.calibrate.check(catalogue, *config);
    return valid ? valid : at(step.keys, valid.error());
}

/// With any gains: what the law allows is seen when its turn comes.
Result<void> checkFrequency(const ExperimentStep& step, const devices::Catalogue& catalogue) {
    const bool hasAxes = catalogue.axes.size() > 1;
    struct Key {
        const char* name;
        bool isOfAxes;
    };
    constexpr std::array Keys = {Key{"base_rad_s", false}, Key{"amplitude_deg", false},
                                 Key{"speed_limit_rad_s", false}, Key{"effort_ratio", true}};
    for (const Key& key : Keys) {
        const ConfigNode* node = step.find(key.name);
        if (node != nullptr && key.isOfAxes != hasAxes) {
            return at(*node,
                      {ErrorCode::InvalidInput,
                       hasAxes ? fmt::format("'{}' does not belong to a device with several axes", key.name)
                               : fmt::format("'{}' belongs to a device with several axes", key.name),
                       "leave it out"});
        }
    }
    if (const auto axes = chosenAxes(catalogue, step.text("axis").value_or("")); !axes) {
        return at(*step.find("axis"), axes.error());
    }
    if (hasAxes) {
        const Result<void> valid = checkAxesFrequency(catalogue, axesFrequencyConfigOf(step));
        return valid ? valid : at(step.keys, valid.error());
    }
    const FrequencyConfig config = frequencyConfigOf(step);
    const Result<void> able = checkFrequencyBoard(catalogue, config);
    if (!able) {
        return at(step.keys, able.error());
    }
    const auto plan = planFrequency(config, frequencyMargins(catalogue, control::SampledPositionLaw{}));
    return plan ? Result<void>() : at(step.keys, plan.error());
}

Result<void> checkSignals(const ExperimentStep& step, const devices::Catalogue& catalogue) {
    for (const std::string& name : step.texts("signals")) {
        if (catalogue.findSignal(name) == nullptr) {
            return at(*step.find("signals"), unknownName(catalogue, name));
        }
    }
    const RecordConfig config = recordConfigOf(step);
    if (config.trigger && catalogue.findSignal(config.trigger->event.signal) == nullptr) {
        return at(*step.find("trigger"), unknownName(catalogue, config.trigger->event.signal));
    }
    return {};
}

Result<void> checkPreset(const ExperimentStep& step, const devices::Catalogue& catalogue,
                         const std::string& model) {
    const std::optional<std::string> name = step.text("preset");
    if (!name) {
        return {};
    }
    const Result<Preset> preset = findPreset(model, *name);
    return preset ? checkValues(*step.find("preset"), preset->values, catalogue)
                  : at(*step.find("preset"), preset.error());
}

/// One member of a step's reference; a file is a text, all else a number.
Result<void> setReferenceKey(MoveReference& reference, const ConfigNode::Member& member) {
    if (member.first == "shape") {
        return {};
    }
    return member.first == FileKey ? setMoveReferenceFile(reference, member.second.text)
                                   : setMoveReference(reference, member.first, member.second.number);
}

Result<void> checkStep(const ExperimentStep& step, const devices::Catalogue& catalogue,
                       const std::string& model) {
    if (step.kind == "identify") {
        return checkIdentify(step, catalogue, actuatorOf(model));
    }
    if (step.kind == "calibrate") {
        return checkCalibrate(step, catalogue, actuatorOf(model));
    }
    if (step.kind == "frequency") {
        return checkFrequency(step, catalogue);
    }
    if (step.kind == "move") {
        const Result<MoveConfig> config = moveConfigOf(step);
        return config ? Result<void>() : failure(config.error());
    }
    if (step.kind == "record") {
        return checkSignals(step, catalogue);
    }
    if (step.kind == "set") {
        return checkValues(*step.find("values"), valuesOf(step), catalogue);
    }
    return checkPreset(step, catalogue, model);
}

} // namespace

Result<IdentifyConfig> identifyConfigOf(const ExperimentStep& step, const Actuator& actuator) {
    IdentifyConfig config;
    config.axis = step.text("axis").value_or("");
    config.sweep.from_A = step.number("currents_A.from").value_or(config.sweep.from_A);
    config.sweep.to_A = step.number("currents_A.to").value_or(config.sweep.to_A);
    config.sweep.step_A = step.number("currents_A.step").value_or(config.sweep.step_A);
    config.speedLimit_rad_s = step.number("speed_limit_rad_s").value_or(config.speedLimit_rad_s);
    config.usableSpeed_rad_s = step.number("usable_speed_rad_s").value_or(config.usableSpeed_rad_s);
    config.currentTolerance_percent = step.number("current_tolerance_percent");
    config.directions = *sweepDirections(step.text("directions").value_or("both"));
    for (const auto& [symbol, value] : step.numbers("given")) {
        if (const Result<void> set = actuator.identify.setGiven(config, symbol, value); !set) {
            return at(*step.find("given"), set.error());
        }
    }
    return config;
}

FrequencyConfig frequencyConfigOf(const ExperimentStep& step) {
    FrequencyConfig config;
    config.excitation = *excitation(step.text("excitation").value_or("multisine")); // a choice of its table
    config.from_Hz = step.number("from_hz").value_or(config.from_Hz);
    config.to_Hz = step.number("to_hz").value_or(config.to_Hz);
    config.base_rad_s = step.number("base_rad_s").value_or(config.base_rad_s);
    config.periods = static_cast<int>(step.number("periods").value_or(config.periods));
    config.leastCoherence = step.number("coherence").value_or(config.leastCoherence);
    config.speedLimit_rad_s = step.number("speed_limit_rad_s").value_or(config.speedLimit_rad_s);
    if (const std::optional<double> amplitude_deg = step.number("amplitude_deg")) {
        config.amplitude_rad = degreesToRadians(*amplitude_deg);
    }
    return config;
}

AxesFrequencyConfig axesFrequencyConfigOf(const ExperimentStep& step) {
    AxesFrequencyConfig config;
    config.axis = step.text("axis").value_or("");
    config.from_Hz = step.number("from_hz").value_or(config.from_Hz);
    config.to_Hz = step.number("to_hz").value_or(config.to_Hz);
    config.effort_ratio = step.number("effort_ratio").value_or(config.effort_ratio);
    config.periods = static_cast<int>(step.number("periods").value_or(config.periods));
    config.leastCoherence = step.number("coherence").value_or(config.leastCoherence);
    return config;
}

RelayConfig relayConfigOf(const ExperimentStep& step) {
    RelayConfig config;
    config.base_rad_s = step.number("base_rad_s");
    config.limit_A = step.number("current_A");
    config.gain_A_per_rad = step.number("gain_A_per_rad");
    config.cycles = static_cast<int>(step.number("cycles").value_or(config.cycles));
    config.speedLimit_rad_s = step.number("speed_limit_rad_s").value_or(config.speedLimit_rad_s);
    return config;
}

Result<CalibrateConfig> calibrateConfigOf(const ExperimentStep& step) {
    CalibrateConfig config;
    Result<std::vector<Calibration>> which = calibrationsFrom(step.text("what").value_or("all"));
    if (!which) {
        return at(step.keys, which.error());
    }
    config.which = *std::move(which);
    config.apply = step.isTrue("apply");
    return config;
}

Result<MoveConfig> moveConfigOf(const ExperimentStep& step) {
    MoveConfig config;
    const ConfigNode& reference = *step.find("reference");
    const Result<MoveReference::Shape> shape = moveShape(*step.text("reference.shape"));
    if (!shape) {
        return at(reference, shape.error());
    }
    config.reference.shape = *shape;
    for (const ConfigNode::Member& member : reference.members) {
        const Result<void> set = setReferenceKey(config.reference, member);
        if (!set) {
            return at(member.second, set.error());
        }
    }
    if (const Result<void> valid = checkMoveReference(config.reference); !valid) {
        return at(reference, valid.error());
    }
    if (const Result<void> read = readTableOf(config.reference); !read) {
        return at(*reference.find("file"), read.error());
    }
    config.axis = step.text("axis").value_or("");
    const auto duration_s = step.number("duration_s");
    const auto travel_s = defaultDuration_s(config.reference);
    if (!duration_s && !travel_s) {
        return at(step.keys,
                  Error{ErrorCode::InvalidInput,
                        fmt::format("a {} needs duration_s", moveShapeName(config.reference.shape)),
                        "Only travels, paths and tables end by themselves."});
    }
    config.duration_s = duration_s ? *duration_s : *travel_s;
    config.evaluateFrom_s = step.number("evaluate_from_s");
    config.evaluateTo_s = step.number("evaluate_to_s");
    if (const std::optional<double> threshold_deg = step.number("lock_threshold_deg")) {
        config.lockThreshold = degreesToRadians(*threshold_deg);
    }
    return config;
}

namespace {

/// Whose runs are compared: of several axes the first that moves.
Result<devices::AxisSpec> judgedAxis(const devices::Catalogue& catalogue, const MoveConfig& config) {
    if (!isTable(config.reference)) {
        return chosenAxis(catalogue, isPath(config.reference) ? catalogue.axes.front().id : config.axis);
    }
    const auto axes = tableAxes(catalogue, config.reference);
    return axes ? Result<devices::AxisSpec>(axes->front()) : failure(axes.error());
}

/// Before the first step moves anything.
Result<void> checkRepeat(const devices::Catalogue& catalogue, const MoveConfig& config,
                         const ExperimentStep& step) {
    const auto repeat = repeatConfigOf(catalogue, step);
    if (!repeat) {
        return failure(repeat.error());
    }
    if (repeat->alternates && movesSeveralAxes(config.reference)) {
        return at(*step.find("alternate"),
                  {ErrorCode::InvalidInput, "a path does not alternate its direction",
                   "repeat it as it is: it ends where its last line ends"});
    }
    return {};
}

} // namespace

Result<void> checkAxisOf(const devices::Catalogue& catalogue, const ExperimentStep& step) {
    const Result<MoveConfig> config = moveConfigOf(step);
    if (!config) {
        return failure(config.error());
    }
    if (isPath(config->reference)) {
        const auto axes = pathAxes(catalogue);
        return axes ? checkRepeat(catalogue, *config, step) : failure(axes.error());
    }
    if (isTable(config->reference)) {
        const auto axes = tableAxes(catalogue, config->reference);
        return axes ? checkRepeat(catalogue, *config, step) : at(*step.find("reference.file"), axes.error());
    }
    const Result<devices::AxisSpec> axis = chosenAxis(catalogue, config->axis);
    const Result<void> suits = axis ? checkQuantity(config->reference, *axis) : failure(axis.error());
    return suits ? checkRepeat(catalogue, *config, step) : suits;
}

Result<RepeatConfig> repeatConfigOf(const devices::Catalogue& catalogue, const ExperimentStep& step) {
    struct Limit {
        const char* key;
        const char* unit; ///< of the axis
        double perUnit;
    };
    constexpr std::array Limits = {Limit{"settled_deg", "rad", degreesToRadians(1.0)},
                                   Limit{"settled_rad", "rad", 1.0},
                                   Limit{"settled_mrad", "rad", 1e-3},
                                   Limit{"settled_urad", "rad", 1e-6},
                                   Limit{"settled_m", "m", 1.0},
                                   Limit{"settled_mm", "m", 1e-3},
                                   Limit{"settled_um", "m", 1e-6}};
    const Result<MoveConfig> config = moveConfigOf(step);
    if (!config) {
        return failure(config.error());
    }
    const bool isOfPath = movesSeveralAxes(config->reference);
    const auto axis = judgedAxis(catalogue, *config);
    if (!axis) {
        return failure(axis.error());
    }
    RepeatConfig repeat;
    repeat.count = static_cast<int>(step.number("repeat").value_or(1.0));
    repeat.alternates =
        step.find("alternate") != nullptr ? step.isTrue("alternate") : !axis->turnsForever && !isOfPath;
    for (const Limit& limit : Limits) {
        const std::optional<double> value = step.number(limit.key);
        if (value && axis->positionUnit != limit.unit) {
            return at(*step.find(limit.key), {ErrorCode::InvalidInput,
                                              fmt::format("'{}' is no unit of axis {}, which is in {}",
                                                          limit.key, axis->id, axis->positionUnit),
                                              "give the limit in a unit of the axis"});
        }
        if (value) {
            repeat.settled = *value * limit.perUnit;
            repeat.settledUnit = limit.unit;
        }
    }
    return repeat;
}

bool isWaitingStep(const ExperimentStep& step) {
    return step.kind == "record" && step.isTrue("reconnect");
}

RecordConfig recordConfigOf(const ExperimentStep& step) {
    RecordConfig config;
    config.signals = step.texts("signals");
    config.rate_Hz = step.number("rate_hz").value_or(config.rate_Hz);
    config.duration_s = *step.number("duration_s");
    if (const std::optional<std::string> trigger = step.text("trigger")) {
        config.trigger.emplace();
        config.trigger->event = *parseCaptureTrigger(*trigger); // judged when the file was read
        config.trigger->preTrigger_s = step.number("pre_trigger_s").value_or(config.trigger->preTrigger_s);
        config.trigger->patience_s = step.number("wait_s").value_or(config.trigger->patience_s);
    }
    return config;
}

control::DesignTargets designTargetsOf(const ExperimentStep& step) {
    return {step.number("zeta"),
            step.number("omega_rad_s"),
            step.number("bandwidth_hz"),
            step.number("phase_margin_deg"),
            step.number("max_sensitivity"),
            step.number("current_limit_A"),
            step.number("step_deg"),
            step.number("ultimate_gain_A_per_rad"),
            step.number("ultimate_period_s")};
}

std::vector<ParameterValue> valuesOf(const ExperimentStep& step) {
    std::vector<ParameterValue> values;
    for (const auto& [name, value] : step.numbers("values")) {
        values.push_back({name, value});
    }
    return values;
}

Result<void> checkAgainstDevice(const Experiment& experiment, const devices::Device& device) {
    for (const ExperimentStep& step : experiment.steps) {
        const Result<void> valid = checkStep(step, device.catalogue(), device.info().model);
        if (!valid) {
            return valid;
        }
    }
    return {};
}

} // namespace halbench::app
