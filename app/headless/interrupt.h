#pragma once

#include <atomic>

namespace halbench::app {

/// Makes SIGINT, SIGTERM, SIGQUIT and SIGHUP (a closed terminal, a lost ssh) set the returned flag instead of
/// ending the process, so that whoever moves an actuator can stop it and put its gains back. A second one
/// that is no SIGHUP ends the process at once. A SIGHUP that is ignored from the start (nohup) stays so.
/// SIGPIPE is ignored (a closed pipe shows as a failed write) and an assertion ends with exit code 5. Call
/// once, from main().
const std::atomic<int>& catchSignals();

} // namespace halbench::app
