#include "app/procedures/base/restored_result.h"

#include <fmt/format.h>

namespace halbench::app {

Error unconfirmedRestore(const Error& cause, const Error& obstacle) {
    const bool isInterrupted = cause.code == ErrorCode::Interrupted || cause.code == ErrorCode::Terminated;
    return {isInterrupted ? obstacle.code : cause.code,
            fmt::format("{}; it is not confirmed that the values from before are back: {}", cause.message,
                        obstacle.message),
            "connect again and compare the parameters before the actuator is armed"};
}

} // namespace halbench::app
