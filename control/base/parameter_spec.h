#pragma once

#include "control/base/result.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench {

enum class ParameterAccess { ReadWrite, ReadOnly };

/// What is known about one tunable value; the value itself lives on the device.
struct ParameterSpec {
    std::string name; ///< e.g. "gain.kp"
    std::string role; ///< meaning procedures ask for, from the profile; empty if none
    std::string unit; ///< SI unit symbol, e.g. "A/rad"
    double defaultValue = 0.0;
    double min = 0.0;
    double max = 0.0;
    bool isInteger = false;
    bool isTransactional = false; ///< lives on the calibration pages: changed atomically with others
    bool isCalibration = false;   ///< measured on one device; wrong on another
    std::string group;
    ParameterAccess access = ParameterAccess::ReadWrite;
    std::string help;
    std::vector<std::string> choices; ///< words for 0, 1, 2 ... of an enumeration; empty otherwise
};

/// What is known about one measured value.
struct SignalSpec {
    std::string name; ///< e.g. "hall.a"
    std::string role;
    std::string unit;
    double min = 0.0;
    double max = 0.0;
    double maxRate_Hz = 0.0;
    std::string help;
    std::vector<std::string> choices;
    std::vector<int> events = {}; ///< of the board at which it can be sampled; only those of one go together
};

/// A name and the value it shall take.
struct ParameterValue {
    std::string name;
    double value = 0.0;
};

/// The one place where a parameter value is judged: setter, file loader, window and batch use it.
/// Errors: NotFinite, OutOfRange (also for a fraction where an integer is needed), DeviceRefused (read only).
Result<void> checkParameterValue(const ParameterSpec& spec, double value);

} // namespace halbench
