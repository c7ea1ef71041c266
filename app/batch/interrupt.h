#pragma once

#include <atomic>

namespace halbench::app {

/// Makes SIGINT and SIGTERM set the returned flag instead of ending the process, so that whoever moves an
/// actuator can stop it and put its gains back; a second signal ends the process at once. SIGPIPE is ignored
/// (a closed pipe shows as a failed write) and an assertion ends with exit code 5. Call once, from main().
const std::atomic<int>& catchSignals();

} // namespace halbench::app
