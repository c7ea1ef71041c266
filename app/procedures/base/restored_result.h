#pragma once

#include "app/procedures/base/procedure.h"

#include <utility>

namespace halbench::app {

/// `cause`, and that it is not confirmed that what was before is back. An interruption is one only with
/// everything restored: otherwise its code is that of what prevented it.
Error unconfirmedRestore(const Error& cause, const Error& obstacle);

/// Ends the guard; the result only when the board has confirmed that what was before is back.
template <typename T>
Result<T> restoredResult(RestoreGuard& guard, Result<T> result) {
    const Result<void> restored = guard.restore();
    if (restored) {
        return result;
    }
    return failure(result ? restored.error() : unconfirmedRestore(result.error(), restored.error()));
}

} // namespace halbench::app
