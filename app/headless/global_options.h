#pragma once

#include "app/headless/console.h"

#include <cstdint>
#include <optional>

namespace halbench::app {

/// Flags that every command understands, before or after its name.
struct GlobalOptions {
    ConsoleStyle style;
    std::optional<std::uint64_t> seed;
    bool isRealtime = false;
    bool mayArm = false;
    bool mayOverwrite = false; ///< --force
};

} // namespace halbench::app
