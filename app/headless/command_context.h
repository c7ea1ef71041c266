#pragma once

#include "app/documents/result_header.h"
#include "app/headless/global_options.h"
#include "app/procedures/base/procedure.h"
#include "devices/open/open_device.h"

#include <atomic>
#include <functional>
#include <memory>
#include <string>

namespace halbench::app {

/// Surroundings of a command: console, options, interruption. Thread: the main one.
struct CommandContext {
    GlobalOptions global;
    Console& console;
    const std::atomic<int>& interruptSignal;
    std::function<std::string()> wallClock = wallTime; ///< a test sets its own
};

/// A command ends with an exit code of its own (0 or 1), or with the error that stopped it.
using CommandResult = Result<ExitCode>;

/// The seed, pace and interrupt flag of the command line.
devices::OpenOptions openOptionsFor(const CommandContext& context);

/// Finding about a device whose description is of another firmware (DeviceInfo::otherFirmware).
Finding otherFirmware(const devices::DeviceInfo& device);

/// Opens a device with them, and says on stderr what makes its values doubtful.
Result<std::unique_ptr<devices::Device>> openDeviceFor(const CommandContext& context, const std::string& uri);

/// The user's consent to arm: always given for a simulated device, with --arm for any other. --arm is also
/// the purposeful act that releases a latched stop or fault of a run before; what is released is said.
/// Errors: ConsentMissing, DeviceRefused (the cause is still there), of the device.
Result<void> requireConsent(const CommandContext& context, devices::Device& device);

/// Judges the device that was opened, before anything is asked or changed of it.
using Admission = std::function<Result<void>(const devices::DeviceInfo& device)>;

/// Opens a device that the command moves, with consent. A real board without consent is not even connected:
/// that would take it from whoever works with it. Errors: as the two above; of `admits`.
Result<std::unique_ptr<devices::Device>> openToMove(const CommandContext& context, const std::string& uri,
                                                    const Admission& admits = {});

/// Writes warnings on the console, which must outlive it.
std::function<void(const std::string&)> warningsTo(Console& console);

/// Refuses with Interrupted or Terminated once a signal arrived.
Result<void> checkInterrupt(const CommandContext& context);

/// Progress bar, block and abort hooks of a procedure that runs under the command line.
ProcedureObserver observerFor(CommandContext& context);

} // namespace halbench::app
