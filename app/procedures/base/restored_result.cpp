#include "app/procedures/base/restored_result.h"

#include <fmt/format.h>

namespace halbench::app {

Error unconfirmedRestore(const Error& cause, const Error& obstacle) {
    const bool isInterrupted = cause.code == ErrorCode::Interrupted || cause.code == ErrorCode::Terminated;
    return {isInterrupted ? obstacle.code : cause.code,
            fmt::format("{}; restoring the previous values is not confirmed: {}", cause.message,
                        obstacle.message),
            "connect again and compare the parameters before arming"};
}

} // namespace halbench::app
