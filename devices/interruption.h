#pragma once

#include "control/base/result.h"

#include <csignal>
#include <string>

namespace halbench::devices {

/// "SIGTERM" of a signal that ends a command.
inline std::string signalName(int signal) {
    switch (signal) {
    case SIGTERM:
        return "SIGTERM";
    case SIGHUP:
        return "SIGHUP";
    case SIGQUIT:
        return "SIGQUIT";
    default:
        return "SIGINT";
    }
}

/// Ctrl-C is the user's wish; every other signal ends the program from outside.
inline ErrorCode codeOfSignal(int signal) {
    return signal == SIGINT ? ErrorCode::Interrupted : ErrorCode::Terminated;
}

} // namespace halbench::devices
