#pragma once

#include <atomic>
#include <string>
#include <vector>

namespace halbench::app {

/// The whole program behind main(): understands the arguments, runs the command, reports what went wrong in
/// one line and returns the exit code. Never throws.
int runProgram(const std::vector<std::string>& arguments, const std::atomic<int>& interruptSignal) noexcept;

} // namespace halbench::app
