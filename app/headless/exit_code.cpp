#include "app/headless/exit_code.h"

#include <algorithm>

namespace halbench::app {

ExitCode exitCodeFor(ErrorCode code) {
    switch (code) {
    case ErrorCode::Usage:
    case ErrorCode::UnknownName:
    case ErrorCode::OutOfRange:
    case ErrorCode::NotFinite:
    case ErrorCode::InvalidInput:
    case ErrorCode::FileSystem:
    case ErrorCode::ConsentMissing:
        return ExitCode::Usage;
    case ErrorCode::Refused:
        return ExitCode::CheckFailed;
    case ErrorCode::DeviceLost:
    case ErrorCode::Protocol:
    case ErrorCode::DeviceRefused:
        return ExitCode::DeviceFailed;
    case ErrorCode::SafetyStop:
        return ExitCode::SafetyStop;
    case ErrorCode::Interrupted:
        return ExitCode::Interrupted;
    case ErrorCode::Terminated:
        return ExitCode::Terminated;
    case ErrorCode::Internal:
        return ExitCode::Internal;
    }
    return ExitCode::Internal;
}

ExitCode exitCodeFor(ErrorCode code, int signal) {
    const bool isBySignal = code == ErrorCode::Interrupted || code == ErrorCode::Terminated;
    return isBySignal && signal != 0 ? static_cast<ExitCode>(128 + signal) : exitCodeFor(code);
}

JsonValue errorDocument(const Error& error) {
    return errorDocument(error, exitCodeFor(error.code));
}

JsonValue errorDocument(const Error& error, ExitCode code) {
    return JsonValue::object()
        .set("schema", "halbench.error/1")
        .set("code", errorCodeName(error.code))
        .set("message", error.message)
        .set("hint", error.hint)
        .set("exit_code", static_cast<int>(code));
}

std::string errorLine(const Error& error) {
    std::string line = error.hint.empty() ? error.message : error.message + "; " + error.hint;
    std::replace_if(
        line.begin(), line.end(), [](char character) { return character == '\n' || character == '\r'; }, ' ');
    return line;
}

} // namespace halbench::app
