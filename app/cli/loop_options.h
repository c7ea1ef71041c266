#pragma once

#include "app/cli/command_syntax.h"
#include "app/headless/command_outputs.h"

#include <string>
#include <vector>

namespace halbench::app {

/// The method of `tune` and its targets.
struct DesignOptions {
    std::string method;
    std::string zeta, omega, bandwidth, phaseMargin;
    std::string maxSensitivity, currentLimit, limitedStep; ///< the last: --step-deg
    std::string relayFile;                                 ///< --relay RELAY.json
};

/// How `tune` and `analyse` show a judged loop.
struct LoopOutputs {
    std::vector<std::string> pictures; ///< VIEW=FILE
    std::string load;                  ///< --disturbance
    std::string codeFile;
};

struct TuneOptions {
    std::string device; ///< or MODEL.json
    std::string axis;
    std::vector<std::string> given; ///< of a device, which is identified first
    DesignOptions design;
    std::string gainsFile; ///< --gains GAINS.json
    std::string calibrationFile;
    std::string applyDevice;
    bool isLive = false;
    bool takesForeignModel = false;
    std::string out;
    LoopOutputs outputs;
};

/// `analyse --what-if`
struct WhatIfOptions {
    std::string recording;
    std::string ranFile;    ///< --ran GAINS.json
    std::string motionFile; ///< --motion F.csv
};

struct AnalyseOptions {
    std::string model; ///< MODEL.json
    std::string gainsFile;
    std::string axis;
    std::string calibrationFile;
    std::string bodeFile, stepFile, polesFile;
    std::vector<std::string> compared; ///< --compare GAINS.json
    WhatIfOptions whatIf;
    LoopOutputs outputs;
};

/// --axis of a model.
void addModelAxis(CommandSyntax& syntax, std::string& axis);
void addLoopOutputs(CommandSyntax& syntax, LoopOutputs& options);
/// The files of --picture are outputs too.
void addPictureFiles(CommandOutputs& outputs, const LoopOutputs& options);

} // namespace halbench::app
