#pragma once

#include "app/batch/json_value.h"
#include "control/base/result.h"

namespace halbench::app {

/// Exit codes of the program (resources/help/command-line.md, "Exit codes").
enum class ExitCode {
    Done = 0,        ///< and every check passed
    CheckFailed = 1, ///< a check missed its limit or an estimate was refused
    Usage = 2,       ///< usage, unknown name, value out of range, invalid file
    DeviceFailed = 3,
    SafetyStop = 4,
    Internal = 5,
    Interrupted = 130,
    Terminated = 143
};

ExitCode exitCodeFor(ErrorCode code);

/// halbench.error/1
JsonValue errorDocument(const Error& error);

/// "message; hint" on one line, whatever the message holds.
std::string errorLine(const Error& error);

} // namespace halbench::app
