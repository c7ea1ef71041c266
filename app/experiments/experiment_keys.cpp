#include "app/experiments/experiment_keys.h"

#include "app/analyses/registry/analyses.h"
#include "app/documents/presets.h"
#include "app/documents/text/names.h"

#include <array>

namespace halbench::app {

namespace {

constexpr double Any = std::numeric_limits<double>::max();
constexpr std::string_view Kinds =
    "identify|frequency|relay|calibrate|tune|apply|move|record|set|wait|analyse";
constexpr std::string_view Methods =
    "recommended|pole-placement|bandwidth|phase-margin|simc|lambda|ziegler-nichols|ziegler-nichols-pi|"
    "ziegler-nichols-p|lqr|min-iae|min-itae|lead|lag|published|designed|micro-step|published-degrees";
using enum KeyType;

// clang-format off
constexpr std::array KnownKeys = {
    KeySpec{"experiment", "schema", Choice, true, 0, 0, "halbench.experiment/1", "form of this file"},
    KeySpec{"experiment", "title", Text, false, 0, 0, "", "heading of the report"},
    KeySpec{"experiment", "description", Text, false, 0, 0, "", "what it shows, for the report"},
    KeySpec{"experiment", "device", Text, false, 0, 0, "", "address of the device; `--device` overrides it"},

    KeySpec{"check", "quantity", Text, true, 0, 0, "", "STEP.QUANTITY"},
    KeySpec{"check", "min", Number, false, -Any, Any, "", "smallest value that passes"},
    KeySpec{"check", "max", Number, false, -Any, Any, "", "largest value that passes"},
    KeySpec{"check", "reason", Text, false, 0, 0, "", "where the limit comes from, for the report"},

    KeySpec{"step", "kind", Choice, true, 0, 0, Kinds, "what the step does"},
    KeySpec{"step", "name", Name, true, 0, 0, "", "names its results and files; unique"},

    KeySpec{"identify", "currents_A", Table, false, 0, 0, "", "plateaus of the sweep, ends included"},
    KeySpec{"identify", "currents_A.from", Number, true, 0, 1000, "", "first current, A"},
    KeySpec{"identify", "currents_A.to", Number, true, 0, 1000, "", "last current, A"},
    KeySpec{"identify", "currents_A.step", Number, true, 1e-6, 1000, "", "distance, A"},
    KeySpec{"identify", "directions", Choice, false, 0, 0, "both|forward|reverse", "directions of the sweep; default both"},
    KeySpec{"identify", "axis", Name, false, 0, 0, "", "axis of a device with several, or all; default all"},
    KeySpec{"identify", "given", Numbers, false, 0, 0, "", "known constants in SI, taken as exact: J, c, Kf, phi of a motor, m or Iz of a platen"},
    KeySpec{"identify", "current_tolerance_percent", Number, false, 0, 50, "", "limit of the drive's gain error, in per cent of the current; default: 0.15 % at one sigma"},
    KeySpec{"identify", "bare", Name, false, 0, 0, "", "identify step of the same motor without the added inertia"},
    KeySpec{"identify", "added_inertia_kg_m2", Number, false, 1e-12, 1e6, "", "inertia fixed to the rotor since `bare`"},
    KeySpec{"identify", "speed_limit_rad_s", Number, false, 0.1, 1e4, "", "speed window; default 40"},
    KeySpec{"identify", "usable_speed_rad_s", Number, false, 0, 1e4, "", "slower plateaus are not fitted; default 3"},

    KeySpec{"frequency", "axis", Name, false, 0, 0, "", "axis of a device with several, or all; default all"},
    KeySpec{"frequency", "excitation", Choice, false, 0, 0, "multisine|stepped-sine|chirp", "how the loop is excited; default multisine"},
    KeySpec{"frequency", "from_hz", Number, false, 0.1, 500, "", "lowest frequency, Hz; default 0.5, of several axes 1"},
    KeySpec{"frequency", "to_hz", Number, false, 0.1, 500, "", "highest frequency, Hz; default 40, of several axes 50"},
    KeySpec{"frequency", "base_rad_s", Number, false, -1e4, 1e4, "", "constant speed below the excitation, at least 3 rad/s either way; default 5"},
    KeySpec{"frequency", "amplitude_deg", Number, false, 1e-3, 57, "", "of a sine of the same rms in every band; default as large as is safe"},
    KeySpec{"frequency", "effort_ratio", Number, false, 1e-3, 0.5, "", "of several axes: amplitude over the effort that each has; default 0.25"},
    KeySpec{"frequency", "periods", Integer, false, 4, 256, "", "that are averaged, at most 64 of a motor; default 8, of several axes 24"},
    KeySpec{"frequency", "coherence", Number, false, 0.5, 0.999, "", "least coherence of a point that is used; default 0.9"},
    KeySpec{"frequency", "speed_limit_rad_s", Number, false, 6, 1e4, "", "speed window; default 40"},

    KeySpec{"relay", "model", Name, false, 0, 0, "", "identify step whose result plans it and is compared; default the published motor"},
    KeySpec{"relay", "base_rad_s", Number, false, -1e4, 1e4, "", "speed that it swings around, at least 3 rad/s either way; default what is safe"},
    KeySpec{"relay", "current_A", Number, false, 0.01, 1000, "", "height of the relay; default what is safe"},
    KeySpec{"relay", "gain_A_per_rad", Number, false, 0.01, 2000, "", "gain where it does not saturate; default 1.5 times the foreseen ultimate gain"},
    KeySpec{"relay", "cycles", Integer, false, 40, 400, "", "that are measured; default 100"},
    KeySpec{"relay", "speed_limit_rad_s", Number, false, 6, 1e4, "", "speed window; default 40"},

    KeySpec{"calibrate", "what", Choice, true, 0, 0, "hall|stray|static-friction|all", "which calibration"},
    KeySpec{"calibrate", "apply", Boolean, false, 0, 0, "", "keep the result on the device; default false"},

    KeySpec{"tune", "model", Name, false, 0, 0, "", "identify step whose result is used"},
    KeySpec{"tune", "model_file", Text, false, 0, 0, "", "of a device with several axes: its model as identify wrote it; one of model and model_file"},
    KeySpec{"tune", "axis", Name, false, 0, 0, "", "of a device with several axes: the one that is tuned, or all; default all"},
    KeySpec{"tune", "method", Choice, false, 0, 0, Methods, "design method; default recommended"},
    KeySpec{"tune", "zeta", Number, false, 1e-6, 10, "", "target: damping ratio"},
    KeySpec{"tune", "omega_rad_s", Number, false, 1e-6, 1e6, "", "target: natural frequency, rad/s"},
    KeySpec{"tune", "bandwidth_hz", Number, false, 1e-6, 1e6, "", "target: bandwidth, Hz"},
    KeySpec{"tune", "phase_margin_deg", Number, false, 1e-3, 179, "", "target: phase margin, degrees"},
    KeySpec{"tune", "max_sensitivity", Number, false, 1.1, 3, "", "target of min-iae, min-itae: largest peak of the sensitivity; default 1.7"},
    KeySpec{"tune", "current_limit_A", Number, false, 1e-3, 1e3, "", "target of min-iae, min-itae: current that a step of step_deg may ask for; default the board's limit"},
    KeySpec{"tune", "step_deg", Number, false, 1e-3, 360, "", "target of min-iae, min-itae: that step, degrees; default 2"},
    KeySpec{"tune", "ultimate_gain_A_per_rad", Number, false, 1e-6, 1e5, "", "Ziegler-Nichols: gain at which the loop swings, as measured"},
    KeySpec{"tune", "ultimate_period_s", Number, false, 1e-6, 1e3, "", "Ziegler-Nichols: period of that, s"},
    KeySpec{"tune", "relay", Name, false, 0, 0, "", "Ziegler-Nichols: relay step that measured both"},

    KeySpec{"analyse", "what", Choice, true, 0, 0, "loop|amplifier|torque|sensing|poles|field|coil", "the sampled position loop, or what follows from the parts of a simulated htm"},
    KeySpec{"analyse", "model", Name, false, 0, 0, "", "loop: identify step whose result is used"},
    KeySpec{"analyse", "gains", Name, false, 0, 0, "", "loop: tune step whose gains are used"},
    KeySpec{"analyse", "speed_rpm", Number, false, 0, 1e6, "", "torque: speed whose torque and current are wanted, r/min"},
    KeySpec{"analyse", "torque_Nm", Number, false, 0, 1e6, "", "torque: torque whose current is wanted, N*m"},
    KeySpec{"analyse", "temperature_degC", Number, false, -40, 125, "", "sensing: temperature of the sensors; default 25"},
    KeySpec{"analyse", "zeta", Number, false, 1e-6, 10, "", "poles: damping ratio to design for; default 0.06"},
    KeySpec{"analyse", "omega_rad_s", Number, false, 1e-6, 1e6, "", "poles: natural frequency to design for, rad/s; default 15"},
    KeySpec{"analyse", "rate_deg_s", Number, false, 0, 1e6, "", "poles: ramp whose lag is wanted, degrees/s"},
    KeySpec{"analyse", "accuracy_deg", Number, false, 1e-6, 1e6, "", "poles: error that a proportional loop shall not exceed"},
    KeySpec{"analyse", "ring_radius_mm", Number, false, 10, 1000, "", "field: radius of the bars' centres; default 33.71"},
    KeySpec{"analyse", "remanence_T", Number, false, 0.01, 3, "", "field: remanence of the bars; default 1.32"},
    KeySpec{"analyse", "pitch_mm", Number, false, 0.01, 100, "", "coil: pitch of the wires whose fill factor is wanted"},

    KeySpec{"apply", "gains", Name, false, 0, 0, "", "tune step whose gains are written"},
    KeySpec{"apply", "preset", PresetName, false, 0, 0, "", "shipped parameter set that is written; one of gains and preset"},

    KeySpec{"apply", "verify_step_deg", Number, false, -3600, 3600, "", "step that the new values must answer as predicted, or the old ones run again"},
    KeySpec{"apply", "model", Name, false, 0, 0, "", "identify step that the prediction is made from; default that of the gains"},

    KeySpec{"move", "axis", Name, false, 0, 0, "", "which axis moves, on a device with several; default the only one"},
    KeySpec{"move", "reference", Table, true, 0, 0, "", "what to follow, relative to the position at the start"},
    KeySpec{"move", "reference.shape", Choice, true, 0, 0, "step|ramp|sine|staircase|chirp|multisine|trapezoid|s-curve|circle|raster|arc|line|table|rest", "shape"},
    KeySpec{"move", "reference.amplitude_deg", Number, false, -1e6, 1e6, "", "height of a step or stair, amplitude, end of a ramp, distance of a travel; degrees"},
    KeySpec{"move", "reference.amplitude_rad", Number, false, -1e5, 1e5, "", "the same in rad"},
    KeySpec{"move", "reference.amplitude_mrad", Number, false, -1e6, 1e6, "", "the same in mrad"},
    KeySpec{"move", "reference.amplitude_urad", Number, false, -1e9, 1e9, "", "the same in µrad"},
    KeySpec{"move", "reference.amplitude_m", Number, false, -1e3, 1e3, "", "the same of an axis that moves along a line, m"},
    KeySpec{"move", "reference.amplitude_mm", Number, false, -1e6, 1e6, "", "the same in mm"},
    KeySpec{"move", "reference.amplitude_um", Number, false, -1e9, 1e9, "", "the same in µm"},
    KeySpec{"move", "reference.rate_deg_s", Number, false, -1e6, 1e6, "", "ramp: slope; travel or path: largest speed; degrees/s"},
    KeySpec{"move", "reference.rate_rad_s", Number, false, -1e5, 1e5, "", "the same in rad/s"},
    KeySpec{"move", "reference.rate_mrad_s", Number, false, -1e6, 1e6, "", "the same in mrad/s"},
    KeySpec{"move", "reference.rate_urad_s", Number, false, -1e9, 1e9, "", "the same in µrad/s"},
    KeySpec{"move", "reference.rate_m_s", Number, false, -1e3, 1e3, "", "the same of an axis that moves along a line, m/s"},
    KeySpec{"move", "reference.rate_mm_s", Number, false, -1e6, 1e6, "", "the same in mm/s"},
    KeySpec{"move", "reference.rate_um_s", Number, false, -1e9, 1e9, "", "the same in µm/s"},
    KeySpec{"move", "reference.frequency_hz", Number, false, 1e-4, 500, "", "sine; first frequency of chirp and multisine, Hz"},
    KeySpec{"move", "reference.frequency_end_hz", Number, false, 1e-4, 500, "", "last frequency of chirp and multisine, Hz"},
    KeySpec{"move", "reference.period_s", Number, false, 1e-3, 1e4, "", "sine: period instead of frequency; staircase: time on each stair, s"},
    KeySpec{"move", "reference.count", Integer, false, 1, 10000, "", "number of stairs or of multisine lines"},
    KeySpec{"move", "reference.base_deg_s", Number, false, -1e5, 1e5, "", "constant motion added, degrees/s"},
    KeySpec{"move", "reference.base_rad_s", Number, false, -1e4, 1e4, "", "the same in rad/s"},
    KeySpec{"move", "reference.base_mrad_s", Number, false, -1e6, 1e6, "", "the same in mrad/s"},
    KeySpec{"move", "reference.base_urad_s", Number, false, -1e9, 1e9, "", "the same in µrad/s"},
    KeySpec{"move", "reference.base_m_s", Number, false, -1e3, 1e3, "", "the same of an axis that moves along a line, m/s"},
    KeySpec{"move", "reference.base_mm_s", Number, false, -1e6, 1e6, "", "the same in mm/s"},
    KeySpec{"move", "reference.base_um_s", Number, false, -1e9, 1e9, "", "the same in µm/s"},
    KeySpec{"move", "reference.acceleration_m_s2", Number, false, 0, 1e3, "", "trapezoid, s-curve and paths: largest acceleration, m/s^2"},
    KeySpec{"move", "reference.acceleration_mm_s2", Number, false, 0, 1e6, "", "the same in mm/s^2"},
    KeySpec{"move", "reference.acceleration_rad_s2", Number, false, 0, 1e3, "", "the same of an axis that turns, rad/s^2"},
    KeySpec{"move", "reference.acceleration_mrad_s2", Number, false, 0, 1e6, "", "the same in mrad/s^2"},
    KeySpec{"move", "reference.jerk_m_s3", Number, false, 0, 1e6, "", "s-curve, and paths where the acceleration shall not jump: largest jerk, m/s^3"},
    KeySpec{"move", "reference.jerk_mm_s3", Number, false, 0, 1e9, "", "the same in mm/s^3"},
    KeySpec{"move", "reference.jerk_rad_s3", Number, false, 0, 1e6, "", "the same of an axis that turns, rad/s^3"},
    KeySpec{"move", "reference.jerk_mrad_s3", Number, false, 0, 1e9, "", "the same in mrad/s^3"},
    KeySpec{"move", "reference.radius_m", Number, false, -1e3, 1e3, "", "circle: radius, m; the centre lies so far along the first axis; arc: radius, m"},
    KeySpec{"move", "reference.radius_mm", Number, false, -1e6, 1e6, "", "the same in mm"},
    KeySpec{"move", "reference.radius_um", Number, false, -1e9, 1e9, "", "the same in µm"},
    KeySpec{"move", "reference.turns", Integer, false, 1, 1000, "", "circle: turns; default 1"},
    KeySpec{"move", "reference.width_m", Number, false, -1e3, 1e3, "", "raster: length of a line along the first axis, m"},
    KeySpec{"move", "reference.width_mm", Number, false, -1e6, 1e6, "", "the same in mm"},
    KeySpec{"move", "reference.width_um", Number, false, -1e9, 1e9, "", "the same in µm"},
    KeySpec{"move", "reference.pitch_m", Number, false, -1, 1, "", "raster: from line to line along the second axis, m"},
    KeySpec{"move", "reference.pitch_mm", Number, false, -1e3, 1e3, "", "the same in mm"},
    KeySpec{"move", "reference.pitch_um", Number, false, -1e6, 1e6, "", "the same in µm"},
    KeySpec{"move", "reference.lines", Integer, false, 1, 1000, "", "raster: lines; default 1"},
    KeySpec{"move", "reference.angle_deg", Number, false, -5e4, 5e4, "", "arc: angle, counter-clockwise, degrees"},
    KeySpec{"move", "reference.angle_rad", Number, false, -1e3, 1e3, "", "the same in rad"},
    KeySpec{"move", "reference.heading_deg", Number, false, -5e4, 5e4, "", "arc and line: direction in which they begin, from the first axis to the second; default 0, degrees"},
    KeySpec{"move", "reference.heading_rad", Number, false, -1e3, 1e3, "", "the same in rad"},
    KeySpec{"move", "reference.length_m", Number, false, -1e3, 1e3, "", "line: length, m"},
    KeySpec{"move", "reference.length_mm", Number, false, -1e6, 1e6, "", "the same in mm"},
    KeySpec{"move", "reference.length_um", Number, false, -1e9, 1e9, "", "the same in µm"},
    KeySpec{"move", "reference.file", Text, false, 0, 0, "", "table: CSV file of poses, from the working folder"},
    KeySpec{"move", "reference.dwell_s", Number, false, 0, 3600, "", "table without time_s: rest in every row, s; default 0"},
    KeySpec{"move", "reference.seed", Integer, false, 0, 4294967295.0, "", "phases of a multisine"},
    KeySpec{"move", "duration_s", Number, false, 0.01, 36000, "", "how long, s; default of trapezoid, s-curve, paths and tables: the travel and 1 s of rest; others need it"},
    KeySpec{"move", "evaluate_from_s", Number, false, 0, 36000, "", "errors count from here; default half of the duration, of travels, paths and tables 0"},
    KeySpec{"move", "evaluate_to_s", Number, false, 0, 36000, "", "errors count up to here; default the end, of travels, paths and tables that of the way"},
    KeySpec{"move", "lock_threshold_deg", Number, false, 1e-6, 1e6, "", "error below which the rotor counts as locked to the reference: `lock_time_s`"},
    KeySpec{"move", "repeat", Integer, false, 1, 1000, "", "so many times, each from where the axis came to rest: `repetition`"},
    KeySpec{"move", "alternate", Boolean, false, 0, 0, "", "with `repeat`: every second run goes back; default true on an axis with ends"},
    KeySpec{"move", "settled_deg", Number, false, 1e-6, 1e6, "", "with `repeat`: a run has settled when its error stays below this where errors count, of a travel after its way"},
    KeySpec{"move", "settled_rad", Number, false, 1e-9, 1e5, "", "the same in rad"},
    KeySpec{"move", "settled_mrad", Number, false, 1e-6, 1e6, "", "the same in mrad"},
    KeySpec{"move", "settled_urad", Number, false, 1e-3, 1e9, "", "the same in µrad"},
    KeySpec{"move", "settled_m", Number, false, 1e-9, 1e3, "", "the same of an axis that moves along a line, m"},
    KeySpec{"move", "settled_mm", Number, false, 1e-6, 1e6, "", "the same in mm"},
    KeySpec{"move", "settled_um", Number, false, 1e-3, 1e9, "", "the same in µm"},

    KeySpec{"record", "duration_s", Number, true, 0.001, 360000, "", "how long, s; with a trigger from that on"},
    KeySpec{"record", "signals", TextList, false, 0, 0, "", "signals; default those of the profile"},
    KeySpec{"record", "rate_hz", Number, false, 1e-3, 1e6, "", "rows per second; default 100"},
    KeySpec{"record", "reconnect", Boolean, false, 0, 0, "", "a device that is lost is waited for, as `record --reconnect` does; default false"},
    KeySpec{"record", "trigger", Text, false, 0, 0, "", "begin when it comes: SIGNAL>LEVEL (rising) or SIGNAL<LEVEL; as `record --trigger`"},
    KeySpec{"record", "pre_trigger_s", Number, false, 0, 360000, "", "what is kept from before the trigger, as far as the step goes back, s; default 0"},
    KeySpec{"record", "wait_s", Number, false, 0.001, 360000, "", "longest wait for the trigger, s; default 10"},

    KeySpec{"set", "values", Numbers, true, 0, 0, "", "parameters and values, written in one transaction; they stay for the steps that follow"},

    KeySpec{"wait", "duration_s", Number, true, 0.001, 360000, "", "how long, s"},
};
// clang-format on

/// The kinds above, then the analyses.
const std::string& allKinds() {
    static const std::string kinds = [] {
        std::string text(Kinds);
        for (const Analysis& analysis : analyses()) {
            text += '|' + std::string(analysis.name);
        }
        return text;
    }();
    return kinds;
}

KeyType typeOf(const AnalysisKey& key) {
    switch (key.type) {
    case AnalysisKeyType::Number:
        return Number;
    case AnalysisKeyType::Integer:
        return Integer;
    case AnalysisKeyType::Choice:
        return Choice;
    case AnalysisKeyType::Flag:
        return Boolean;
    case AnalysisKeyType::Text:
        break;
    }
    return Text;
}

std::vector<KeySpec> allKeys() {
    std::vector<KeySpec> keys(KnownKeys.begin(), KnownKeys.end());
    for (KeySpec& key : keys) {
        if (key.section == "step" && key.key == "kind") {
            key.choices = allKinds();
        }
    }
    for (const Analysis& analysis : analyses()) {
        if (analysis.recording != RecordingUse::None) {
            const bool isRequired = analysis.recording == RecordingUse::Required;
            keys.push_back(
                {analysis.name, "recording", Name, isRequired, 0, 0, "", "step whose recording is used"});
        }
        if (analysis.device) {
            keys.push_back({analysis.name, "from_device", Boolean, false, 0, 0, "",
                            "settings that are not given are those of the run's device; default false"});
        }
        for (const AnalysisKey& key : analysis.keys) {
            const bool isText = key.type == AnalysisKeyType::Text || key.type == AnalysisKeyType::Choice;
            keys.push_back({analysis.name, key.name, typeOf(key), false, isText ? 0.0 : key.min,
                            isText ? 0.0 : key.max, key.choices, key.help});
        }
    }
    return keys;
}

} // namespace

std::span<const KeySpec> experimentKeys() {
    static const std::vector<KeySpec> keys = allKeys();
    return keys;
}

std::vector<std::string> stepKinds() {
    return splitList(allKinds(), '|');
}

std::vector<std::string> choicesOf(const KeySpec& spec) {
    return spec.type == PresetName ? presetNames() : splitList(spec.choices, '|');
}

std::vector<const KeySpec*> keysOf(std::string_view section, std::string_view table) {
    std::vector<const KeySpec*> keys;
    for (const KeySpec& spec : experimentKeys()) {
        const std::size_t dot = spec.key.rfind('.');
        const std::string_view parent = dot == std::string_view::npos ? "" : spec.key.substr(0, dot);
        if (spec.section == section && parent == table) {
            keys.push_back(&spec);
        }
    }
    return keys;
}

} // namespace halbench::app
