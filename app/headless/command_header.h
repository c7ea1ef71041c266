#pragma once

#include "app/documents/result_header.h"
#include "app/headless/command_context.h"

#include <string>

namespace halbench::app {

/// Header of the result of a command that works on a device: virtual time begins at 1970-01-01T00:00:00Z, any
/// other at the wall clock's now.
ResultHeader headerFor(const CommandContext& context, const std::string& schema,
                       const devices::Device& device);
/// Header of the result of a command that works on files alone.
ResultHeader headerFor(const CommandContext& context, const std::string& schema);

} // namespace halbench::app
