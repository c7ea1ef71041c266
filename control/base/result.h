#pragma once

#include <tl/expected.hpp>

#include <string>
#include <string_view>
#include <utility>

namespace halbench {

/// Why something could not be done. Callers branch on the code; people read message and hint.
enum class ErrorCode {
    Usage,          ///< a command, option or combination that does not exist
    UnknownName,    ///< a parameter, signal, device or file name that is not known here
    OutOfRange,     ///< a number outside the allowed interval
    NotFinite,      ///< NaN or infinity where a number is needed
    InvalidInput,   ///< a file, packet or text that does not parse or contradicts itself
    FileSystem,     ///< cannot read, write, create or rename; disk full
    Refused,        ///< the data do not support the answer, or a check missed its limit
    DeviceLost,     ///< unplugged, closed, link gone, no answer
    Protocol,       ///< the other side sent what the protocol does not allow
    DeviceRefused,  ///< the board answered with an error, e.g. arming while a stop is latched
    SafetyStop,     ///< a limit was hit and the actuator was stopped
    ConsentMissing, ///< a real device would be armed without `--arm`
    Interrupted,    ///< SIGINT or the user's abort
    Terminated,     ///< SIGTERM
    Internal        ///< our own bug, reported instead of continued
};

/// `snake_case` name used in JSON, e.g. "out_of_range".
std::string_view errorCodeName(ErrorCode code);

/// One sentence that says what and where, and one that says what to do.
struct Error {
    ErrorCode code = ErrorCode::Internal;
    std::string message;
    std::string hint;
};

/// A value, or the cause why there is none. Nothing above ever throws for bad input.
template <typename T = void>
using Result = tl::expected<T, Error>;

/// `return failure(ErrorCode::OutOfRange, "...", "...");`
inline tl::unexpected<Error> failure(ErrorCode code, std::string message, std::string hint = {}) {
    return tl::unexpected<Error>(Error{code, std::move(message), std::move(hint)});
}

/// Passes an error of another result type on.
inline tl::unexpected<Error> failure(Error error) {
    return tl::unexpected<Error>(std::move(error));
}

} // namespace halbench
