#pragma once

#include "app/documents/text/json_value.h"
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
    HungUp = 129, ///< 128 and the signal
    Interrupted = 130,
    Quit = 131,
    Terminated = 143
};

ExitCode exitCodeFor(ErrorCode code);
/// The same where a signal may have come (0: none): an end by one is 128 and its number.
ExitCode exitCodeFor(ErrorCode code, int signal);

/// halbench.error/1
JsonValue errorDocument(const Error& error);
JsonValue errorDocument(const Error& error, ExitCode code);

/// "message; hint" on one line, whatever the message holds.
std::string errorLine(const Error& error);

} // namespace halbench::app
