#include "app/cli/command_syntax.h"
#include "app/documents/text/numbers.h"
#include "app/headless/command_options.h"

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <map>

namespace halbench::app {

namespace {

/// Texts that CLI11 fills before they are judged.
struct RawGlobals {
    std::string seed;
    std::string level = "info";
    bool isJson = false;
    bool isVersion = false;
    bool isColorless = false;
    bool isQuiet = false;
    bool isRealtime = false;
    bool mayArm = false;
    bool mayOverwrite = false;
};

void addGlobalOptions(CLI::App& app, RawGlobals& raw) {
    app.add_flag("--json", raw.isJson, "One JSON document on stdout, nothing else there");
    app.add_option("--seed", raw.seed, "Seed of a simulated device; wins over ?seed=, default 1")
        ->type_name("N");
    app.add_flag("--realtime", raw.isRealtime, "Pace a simulated device by the wall clock");
    app.add_flag("--arm", raw.mayArm, "Consent: a device that is not simulated may be armed and move");
    app.add_flag("--force", raw.mayOverwrite, "Consent: output files that are there already are overwritten");
    app.add_flag("--quiet", raw.isQuiet, "Warnings and errors only on stderr");
    app.add_option("--log-level", raw.level, "error, warning, info or debug")->type_name("LEVEL");
    app.add_flag("--no-color", raw.isColorless, "No colours on a terminal");
    app.add_flag("--version", raw.isVersion, "Print the version and exit");
}

void addDevice(CLI::App* command, CommandOptions& options) {
    command->add_option("DEVICE", options.device, "sim:htm, tcp:HOST:PORT, replay:FILE ...")->required();
}

void addLookingCommands(CLI::App& app, CommandOptions& options) {
    CLI::App* devices = addCommand(app, "devices", "List what can be connected; opens nothing");
    devices->add_flag("--udev-rules", options.printsUdevRules,
                      "Print the rules that let a user open boards without being root");
    devices->add_flag("--desktop-file", options.printsDesktopFile,
                      "Print the entry that puts the window into the desktop's menu");
    addDevice(addCommand(app, "describe", "Identity, signals and parameters of a device"), options);
    CLI::App* get = addCommand(app, "get", "Read signals and parameters");
    addDevice(get, options);
    get->add_option("NAME", options.names, "Signal or parameter")->required();
    CLI::App* set = addCommand(app, "set", "Write parameters in one transaction and read them back");
    addDevice(set, options);
    set->add_option("NAME=VALUE", options.names, "What to write")->required();
    set->add_flag("--save", options.isSaved, "Store in the board's non-volatile memory as well");
}

void addConfigCommand(CLI::App& app, CommandOptions& options) {
    CLI::App* config = addCommand(app, "config", "Save, compare and restore all settings of a device");
    config->add_option("WHAT", options.what, "save, compare or restore")->required();
    addDevice(config, options);
    config->add_option("FILE", options.input, "Configuration")->required()->type_name("FILE.toml");
    config->add_option("--only", options.only, "Restore these rows, separated by commas")->type_name("A,B");
    config->add_flag("--calibration", options.withCalibration,
                     "Restore the calibration too when it was measured on another device");
    config->add_flag("--save", options.isSaved, "Store in the board's non-volatile memory as well");
}

void addMovingCommands(CLI::App& app, CommandOptions& options) {
    CLI::App* record = addCommand(app, "record", "Record signals into a CSV file; never arms");
    addDevice(record, options);
    record->add_option("--duration", options.duration, "Seconds, from the trigger on; not with --capture")
        ->type_name("S");
    record->add_option("--signals", options.signals, "Names, separated by commas")->type_name("A,B");
    record->add_option("--rate", options.rate, "Rows per second, default 100; of a capture 1000")
        ->type_name("HZ");
    record
        ->add_option("--capture", options.capture,
                     "The board itself records 4096 rows of 1 to 4 signals at the rate of its loop")
        ->type_name("A,B");
    record
        ->add_option("--trigger", options.trigger,
                     "Begin when it comes: A>LEVEL, A<LEVEL; of a capture also now (default), reference")
        ->type_name("T");
    record
        ->add_option("--pre-trigger", options.preTrigger,
                     "What is kept from before the trigger, in seconds; of a capture: share of its rows")
        ->type_name("S|RATIO");
    record->add_option("--wait", options.wait, "Longest wait for the trigger, default 10")->type_name("S");
    record->add_flag("--reconnect", options.isReconnecting,
                     "Wait for a device that is lost and record on, with the gap marked; not with --capture");
    addRecordingOut(record, "--out", options.out, "Recording");
    record
        ->add_option("--out-mask", options.outMask,
                     "Instead of --out: a name of its own with {device}, {date}, {time} and {number}")
        ->type_name("FOLDER/MASK");
    CLI::App* move = addCommand(app, "move", "Follow a reference and measure how well");
    addDevice(move, options);
    move->add_option(
            "--reference", options.reference,
            "step,amplitude_deg=100; s-curve,amplitude_mm=5,rate_mm_s=50,...; circle; raster; rest ...")
        ->required()
        ->type_name("SHAPE,KEY=VALUE...");
    move->add_option("--axis", options.axis,
                     "Which axis moves, on a device with several; all: one after the other")
        ->type_name("NAME|all");
    move->add_option("--model", options.model, "Model of the axes: the move is predicted too")
        ->type_name("MODEL.json");
    move->add_option("--duration", options.duration,
                     "Seconds; default of trapezoid, s-curve, circle, raster: the travel and 1 s of rest")
        ->type_name("S");
    addRecordingOut(move, "--out", options.out, "Recording");
}

void addCalibration(CLI::App* command, CommandOptions& options) {
    command
        ->add_option("--calibration", options.calibrationFile,
                     "How well the stray field is known, from calibrate --out")
        ->type_name("CAL.json");
}

void addFrequency(CLI::App* identify, CommandOptions& options) {
    identify->add_flag("--frequency", options.isFrequency,
                       "Measure the frequency response instead: plant, loops, margins");
    identify->add_option("--excitation", options.excitation, "multisine (default), stepped-sine or chirp");
    identify
        ->add_option("--from-hz", options.fromFrequency, "Lowest frequency, default 0.5, of several axes 1")
        ->type_name("HZ");
    identify->add_option("--to-hz", options.toFrequency, "Highest frequency, default 40, of several axes 50")
        ->type_name("HZ");
    identify->add_option("--base-rad-s", options.base, "Constant speed below the excitation, default 5")
        ->type_name("RAD_S");
    identify
        ->add_option("--amplitude-deg", options.amplitude, "Of a sine of the same rms; default: what is safe")
        ->type_name("DEG");
    identify
        ->add_option("--effort-ratio", options.effortRatio,
                     "Of several axes: amplitude over the effort that each has, default 0.25")
        ->type_name("RATIO");
    identify
        ->add_option("--periods", options.periods,
                     "That are averaged, 4 to 64, default 8; of several axes 4 to 256, default 24")
        ->type_name("N");
    identify->add_option("--coherence", options.coherence, "Least of a point that is used, default 0.9")
        ->type_name("RATIO");
    identify->add_option("--bode", options.bodeFile, "Measured responses as a table")->type_name("F.csv");
    addCalibration(identify, options);
}

void addRelay(CLI::App* identify, CommandOptions& options) {
    identify->add_flag("--relay", options.isRelay,
                       "The relay experiment instead: ultimate gain and period of the position loop");
    identify
        ->add_option("--model", options.relayModel,
                     "Of --relay: plans it and is compared, from identify --out")
        ->type_name("MODEL.json");
    identify
        ->add_option("--relay-current", options.relayCurrent, "Height of the relay; default: what is safe")
        ->type_name("A");
    identify
        ->add_option("--relay-gain", options.relayGain,
                     "Gain where it does not saturate; default: 1.5 times the foreseen ultimate gain")
        ->type_name("A_PER_RAD");
    identify->add_option("--cycles", options.cycles, "Of --relay: measured, 40 to 400, default 100")
        ->type_name("N");
}

void addIdentifyingCommands(CLI::App& app, CommandOptions& options) {
    CLI::App* calibrate = addCommand(app, "calibrate", "Calibrate the sensors");
    calibrate->add_option("DEVICE|FILE.csv", options.device, "Device, or recording of one that senses")
        ->required();
    calibrate->add_option("WHAT", options.what, "hall, stray, static-friction or all")->required();
    calibrate->add_flag("--apply", options.isApplied, "Write the result to the device");
    calibrate->add_option("--out", options.out, "Result")->type_name("CAL.json");
    CLI::App* identify =
        addCommand(app, "identify", "Identify friction, damping, torque constant and inertia");
    identify->add_option("DEVICE|FILE.csv", options.device, "Device or recording")->required();
    identify->add_option("--axis", options.axis, "Axis of a device with several, or all; default all")
        ->type_name("NAME");
    identify
        ->add_option("--given", options.given,
                     "Known constant in SI: J, c, Kf or phi of a motor, m or Iz of a platen; repeatable")
        ->take_all()
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
    identify->add_option("--currents", options.currents, "Sweep in ampere, default 1.6:4:0.2")
        ->type_name("FROM:TO:STEP");
    identify->add_option("--directions", options.directions, "both, forward or reverse");
    addRecordingOut(identify, "--record", options.recordFile, "Recording of the sweep");
    identify->add_option("--bare", options.bare, "Result of the same motor without the added inertia")
        ->type_name("MODEL.json");
    identify->add_option("--added-inertia", options.addedInertia, "Inertia added since --bare, kg*m^2")
        ->type_name("KGM2");
    identify->add_option("--out", options.out, "Result")->type_name("MODEL.json");
    addFrequency(identify, options);
    addRelay(identify, options);
}

void addCode(CLI::App* command, CommandOptions& options) {
    command->add_option("--code", options.codeFile, "The law for another controller")->type_name("LAW.c");
}

void addAxis(CLI::App* command, CommandOptions& options) {
    command->add_option("--axis", options.axis, "Of a model with several axes; default all")
        ->type_name("NAME|all");
}

/// What tune and analyse have in common: how a judged loop is shown.
void addLoopOutputs(CLI::App* command, CommandOptions& options) {
    command
        ->add_option("--picture", options.pictures,
                     "bode, nyquist, nichols, sensitivity, root-locus, step, large-step or disturbance; "
                     "repeatable")
        ->take_all()
        ->allow_extra_args(false)
        ->type_name("VIEW=F.svg|.pdf|.png");
    command->add_option("--disturbance", options.load, "Load that is looked at, as a current; default 0.5")
        ->type_name("A");
    addCode(command, options);
}

void addTuningCommands(CLI::App& app, CommandOptions& options) {
    CLI::App* tune = addCommand(app, "tune", "Design gains for an identified motor");
    tune->add_option("MODEL.json|DEVICE", options.device, "Identified model, or a device to identify")
        ->required();
    tune->add_option("--method", options.method, "recommended (default), pole-placement, bandwidth ...")
        ->type_name("M");
    tune->add_option("--zeta", options.zeta, "Damping ratio")->type_name("RATIO");
    tune->add_option("--omega-rad-s", options.omega, "Natural frequency")->type_name("RAD_S");
    tune->add_option("--bandwidth-hz", options.bandwidth, "Bandwidth")->type_name("HZ");
    tune->add_option("--phase-margin-deg", options.phaseMargin, "Phase margin")->type_name("DEG");
    tune->add_option("--max-sensitivity", options.maxSensitivity,
                     "min-iae, min-itae: largest peak of the sensitivity, 1.1 to 3; default 1.7")
        ->type_name("RATIO");
    tune->add_option(
            "--current-limit-a", options.currentLimit,
            "min-iae, min-itae: current that a step of --step-deg may ask for; default the board's limit")
        ->type_name("A");
    tune->add_option("--step-deg", options.limitedStep, "min-iae, min-itae: that step; default 2")
        ->type_name("DEG");
    tune->add_option("--relay", options.relayFile, "Ziegler-Nichols: ultimate gain and period as measured")
        ->type_name("RELAY.json");
    tune->add_option("--gains", options.gainsFile, "Judge and apply these instead of designing some")
        ->type_name("GAINS.json");
    addCalibration(tune, options);
    tune->add_option("--apply", options.applyDevice, "Write the gains to this device")->type_name("DEVICE");
    tune->add_flag("--live", options.isLive, "With --apply: in small steps, each proved by a move");
    tune->add_flag("--foreign-model", options.takesForeignModel,
                   "Apply to a real device what was identified on another one");
    tune->add_option("--given", options.given, "Known constant when DEVICE is identified first")
        ->take_all()
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
    addAxis(tune, options);
    tune->add_option("--out", options.out, "Gains")->type_name("GAINS.json");
    addLoopOutputs(tune, options);
    CLI::App* analyse = addCommand(app, "analyse", "Margins and step response of a model with gains");
    analyse->add_option("MODEL.json", options.device, "Identified model")->required();
    analyse->add_option("GAINS.json", options.gainsFile, "Gains")->required();
    addAxis(analyse, options);
    addCalibration(analyse, options);
    analyse->add_option("--bode", options.bodeFile, "Open loop, frequency response")->type_name("F.csv");
    analyse->add_option("--step", options.stepFile, "Closed loop, step response")->type_name("F.csv");
    analyse->add_option("--poles", options.polesFile, "Poles, zeros and root locus")->type_name("F.csv");
    analyse->add_option("--compare", options.compared, "Other gains beside them; repeatable")
        ->take_all()
        ->allow_extra_args(false)
        ->type_name("GAINS.json");
    analyse
        ->add_option("--what-if", options.whatIfRecording, "A recorded move, as it would be with these gains")
        ->type_name("RECORDING");
    analyse->add_option("--ran", options.ranFile, "Gains of that move; default: as recorded beside it")
        ->type_name("GAINS.json");
    analyse->add_option("--motion", options.whatIfFile, "Recorded and predicted motion of --what-if")
        ->type_name("F.csv");
    addLoopOutputs(analyse, options);
}

void addServe(CLI::App& app, CommandOptions& options) {
    CLI::App* serve = addCommand(app, "serve", "Offer a simulated board to other XCP tools");
    addDevice(serve, options);
    serve->add_option("--tcp", options.tcp, "Listen there; port 0 picks one")->type_name("HOST:PORT");
    serve->add_option("--udp", options.udp, "Listen there; port 0 picks one")->type_name("HOST:PORT");
    serve->add_flag("--pty", options.usesPty, "A pseudo terminal");
    serve->add_option("--framing", options.framing, "With --pty: SYNC and escapes, or none")
        ->type_name("on|off");
    serve->add_option("--header", options.sxiHeader, "With --pty: what is in front of a packet")
        ->type_name("len_byte|len_ctr_byte|...");
    serve->add_option("--checksum", options.checksum, "With --pty: what is behind it")
        ->type_name("none|byte|word");
    serve->add_option("--drop", options.drop, "Share of the messages that vanish, 0 to 1")->type_name("P");
    serve->add_option("--corrupt", options.corrupt, "Share of the messages with a flipped bit, 0 to 1")
        ->type_name("P");
    serve->add_option("--latency-ms", options.latency, "Every message arrives so much later, each way")
        ->type_name("MS");
}

void addFileCommands(CLI::App& app, CommandOptions& options) {
    CLI::App* run = addCommand(app, "run", "Run an experiment file and judge its checks");
    run->add_option("EXPERIMENT.toml", options.experiment, "Experiment")->required();
    run->add_option("--device", options.deviceOverride, "Device instead of the file's")->type_name("DEVICE");
    run->add_option("--set", options.assignments, "Change a value, e.g. step.sweep.given.J=6e-4; repeatable")
        ->take_all()
        ->allow_extra_args(false)
        ->type_name("KEY=VALUE");
    run->add_flag("--dry-run", options.isDryRun, "Validate and predict, move nothing");
    run->add_option("--out", options.out, "Folder of the results")->type_name("DIR");
    addServe(app, options);
    addRecordingCommands(app, options);
    addAnalysisCommands(app, options);
}

Result<GlobalOptions> globalsFrom(const RawGlobals& raw, ConsoleStyle style) {
    GlobalOptions global;
    const std::map<std::string, LogLevel> levels = {{"error", LogLevel::Error},
                                                    {"warning", LogLevel::Warning},
                                                    {"info", LogLevel::Info},
                                                    {"debug", LogLevel::Debug}};
    const auto level = levels.find(raw.level);
    if (level == levels.end()) {
        return failure(ErrorCode::Usage, "--log-level: '" + raw.level + "' is not a level",
                       "use error, warning, info or debug");
    }
    if (!raw.seed.empty()) {
        const std::optional<std::int64_t> seed = parseInteger(raw.seed);
        if (!seed || *seed < 0) {
            return failure(ErrorCode::Usage, "--seed: '" + raw.seed + "' is not a whole number from 0",
                           "give a number like 7");
        }
        global.seed = static_cast<std::uint64_t>(*seed);
    }
    style.level = level->second;
    style.isQuiet = raw.isQuiet;
    global.style = style;
    global.isRealtime = raw.isRealtime;
    global.mayArm = raw.mayArm;
    global.mayOverwrite = raw.mayOverwrite;
    return global;
}

/// An option that was given must say something: an empty text never means "as if it were not there".
Result<void> refuseEmptyValues(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& value : option->results()) {
            if (value.empty()) {
                return failure(ErrorCode::Usage, option->get_name() + " is given without a value",
                               "give a value or leave it out");
            }
        }
    }
    return {};
}

std::string withoutNewlines(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

} // namespace

ConsoleStyle styleFromArguments(const std::vector<std::string>& arguments) {
    const auto has = [&](const char* flag) {
        return std::find(arguments.begin(), arguments.end(), flag) != arguments.end();
    };
    ConsoleStyle style;
    style.isJson = has("--json");
    style.isQuiet = has("--quiet");
    style.isTerminal = isatty(STDERR_FILENO) != 0;
    style.useColor = style.isTerminal && !has("--no-color") && std::getenv("NO_COLOR") == nullptr;
    return style;
}

Result<CommandLine> parseCommandLine(const std::vector<std::string>& arguments) {
    CLI::App app("Identify and retune precision Lorentz-force actuators.", "halbench");
    CommandLine line;
    RawGlobals raw;
    addGlobalOptions(app, raw);
    addLookingCommands(app, line.options);
    addConfigCommand(app, line.options);
    addMovingCommands(app, line.options);
    addIdentifyingCommands(app, line.options);
    addTuningCommands(app, line.options);
    addFileCommands(app, line.options);
    app.footer("Help: resources/help/command-line.md. Without a command the window opens; it takes --project "
               "FILE and --connect DEVICE.");
    line.helpText = app.help();
    try {
        std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        const std::vector<CLI::App*> commands = app.get_subcommands();
        line.command = "help";
        line.helpText = commands.empty() ? line.helpText : commands.front()->help();
        return line;
    } catch (const CLI::ParseError& error) {
        return failure(ErrorCode::Usage, withoutNewlines(error.what()), "see 'halbench --help'");
    }
    Result<GlobalOptions> global = globalsFrom(raw, styleFromArguments(arguments));
    if (!global) {
        return failure(global.error());
    }
    line.global = *global;
    const std::vector<CLI::App*> commands = app.get_subcommands();
    if (commands.size() > 1) {
        return failure(ErrorCode::Usage,
                       "'" + commands[0]->get_name() + "' and '" + commands[1]->get_name() +
                           "' are two commands",
                       "give one");
    }
    for (const CLI::App* given :
         {static_cast<const CLI::App*>(&app),
          commands.empty() ? nullptr : static_cast<const CLI::App*>(commands.front())}) {
        if (const Result<void> valid = given == nullptr ? Result<void>() : refuseEmptyValues(*given);
            !valid) {
            return failure(valid.error());
        }
    }
    line.command = raw.isVersion ? "version" : commands.empty() ? "help" : commands.front()->get_name();
    return line;
}

} // namespace halbench::app
