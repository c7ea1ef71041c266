#pragma once

#include "app/procedures/base/procedure.h"

#include <string>
#include <vector>

namespace halbench::app {

/// What starts the board's capture.
struct CaptureTrigger {
    enum class Kind { Immediate, Level, Reference };
    Kind kind = Kind::Immediate;
    std::string signal; ///< Level: the one that crosses
    double level = 0.0; ///< Level: in the signal's unit
    bool isRising = true;
};

struct CaptureConfig {
    std::vector<std::string> signals; ///< one to four
    double rate_Hz = 1000.0;          ///< the loop's, or a whole part of it
    double pretrigger_ratio = 0.0;    ///< share of the rows before the trigger, below 1
    CaptureTrigger trigger;
    double patience_s = 10.0; ///< longest wait for the trigger
};

/// "now", "reference", "SIGNAL>LEVEL" (rising through the level) or "SIGNAL<LEVEL" (falling).
/// Errors: Usage, NotFinite.
Result<CaptureTrigger> parseCaptureTrigger(const std::string& text);

/// Lets the board itself record up to four signals at the rate of its loop, 4096 rows, and reads them out
/// (resources/help/protocol.md 3.16). Time counts from the trigger, negative before it. The board's capture
/// set-up is put back; nothing is armed and nothing else is written. Walks Prepare, Record, Done.
/// Errors: DeviceRefused (a board without capture), UnknownName, Usage, OutOfRange (rate, share), Refused (no
/// trigger within the patience), NotFinite, of the device, of the abort.
Result<Recording> runCapture(devices::Device& device, const CaptureConfig& config,
                             const ProcedureObserver& observer);

} // namespace halbench::app
