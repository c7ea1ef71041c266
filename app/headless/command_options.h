#pragma once

#include "app/headless/console.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// Flags that every command understands, before or after its name.
struct GlobalOptions {
    ConsoleStyle style;
    std::optional<std::uint64_t> seed;
    bool isRealtime = false;
    bool mayArm = false;
    bool mayOverwrite = false; ///< --force
};

/// The options of all commands as the user wrote them; numbers stay text until the command judges them, so
/// that its message can name the option. A command reads the fields it has an option for.
struct CommandOptions {
    std::string device;             ///< DEVICE, or MODEL.json / FILE.csv where the command takes those
    std::vector<std::string> names; ///< NAME... or NAME=VALUE...
    bool printsUdevRules = false;   ///< devices --udev-rules
    bool printsDesktopFile = false; ///< devices --desktop-file
    bool isSaved = false;           ///< --save
    bool isApplied = false;         ///< calibrate --apply
    std::string applyDevice;        ///< tune --apply DEVICE
    bool takesForeignModel = false; ///< tune --foreign-model
    std::string out;
    std::string duration;
    std::string signals;
    std::string rate;
    bool isReconnecting = false;           ///< record --reconnect
    std::string outMask;                   ///< record --out-mask
    std::string capture;                   ///< record --capture A,B
    std::string trigger, preTrigger, wait; ///< record
    std::string reference;
    std::string axis;  ///< --axis, of a device with several
    std::string model; ///< move --model MODEL.json
    std::string what;  ///< hall, stray, static-friction or all; of config: save, compare or restore
    std::string only;  ///< config restore --only A,B
    bool withCalibration = false; ///< config restore --calibration
    std::vector<std::string> given;
    std::string currents;
    std::string directions;
    std::string recordFile;
    std::string bare;         ///< --bare MODEL.json
    std::string addedInertia; ///< --added-inertia KGM2
    bool isFrequency = false; ///< identify --frequency; the next line only with it
    bool isRelay = false;     ///< identify --relay; the next line only with it, and --base-rad-s
    std::string relayModel, relayGain, relayCurrent, cycles;
    std::string relayFile; ///< tune --relay RELAY.json
    std::string excitation, fromFrequency, toFrequency, base, amplitude, periods, coherence;
    std::string effortRatio; ///< --effort-ratio, of several axes
    std::string method;
    std::string zeta, omega, bandwidth, phaseMargin;
    std::string maxSensitivity, currentLimit,
        limitedStep;                   ///< --max-sensitivity, --current-limit-a, --step-deg
    std::string gainsFile;             ///< analyse GAINS.json, tune --gains
    std::vector<std::string> pictures; ///< tune, analyse --picture VIEW=FILE
    std::string load;                  ///< tune, analyse --disturbance A
    std::string calibrationFile;       ///< tune, analyse --calibration CAL.json
    std::string bodeFile, stepFile, polesFile;
    std::string codeFile;              ///< tune, analyse --code
    std::vector<std::string> compared; ///< analyse --compare
    std::string whatIfRecording;       ///< analyse --what-if RECORDING
    std::string ranFile;               ///< analyse --ran GAINS.json
    std::string whatIfFile;            ///< analyse --motion F.csv
    bool isLive = false;               ///< tune --apply DEVICE --live
    std::string experiment;
    std::string deviceOverride; ///< run --device
    std::vector<std::string> assignments;
    bool isDryRun = false;
    std::string tcp, udp;
    bool usesPty = false;
    std::string framing, sxiHeader, checksum; ///< serve --pty, in the words of a serial address
    std::string drop, corrupt, latency;       ///< serve
    std::string input;
    std::vector<std::string> derived; ///< --derive
    std::string title;                ///< plot
    std::string right;                ///< plot
    std::string from, to;
    std::string signal, kind, window, segment, overlap; ///< spectrum
    std::string separator, decimal, header;             ///< import
    std::string timeColumn;                             ///< import --time
    std::vector<std::string> mappings;                  ///< import --map OUR=THEIR
    std::vector<std::string> columnUnits;               ///< import --unit COLUMN=UNIT
    bool isPreview = false;                             ///< import --preview
    std::string search;                                 ///< recordings --search
    std::string retain;                                 ///< recordings --retain; the next line only with it
    bool isDeleted = false, isTrashed = false;          ///< --delete, --trash
    std::string align;                                  ///< overlay --align
    std::map<std::string, std::string> values;          ///< of an analysis, by its keys
    std::map<std::string, bool> flags;
};

struct CommandLine {
    GlobalOptions global;
    std::string command; ///< "get"; "version", "help" for --version and --help or no arguments
    CommandOptions options;
    std::string helpText;
};

/// Options that count before the others are read: whether --json was asked for, colours, terminal.
ConsoleStyle styleFromArguments(const std::vector<std::string>& arguments);

/// Errors: Usage, naming what was not understood.
Result<CommandLine> parseCommandLine(const std::vector<std::string>& arguments);

} // namespace halbench::app
