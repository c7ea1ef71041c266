#pragma once

#include "app/procedures/base/procedure.h"

#include <string>
#include <vector>

namespace halbench::app {

// The steps of a transaction that changes gains, for procedures that hold a RestoreGuard.

/// Every value against the device's limits, before the first byte is sent. Errors: UnknownName, NotFinite,
/// OutOfRange.
Result<void> checkValues(const devices::Catalogue& catalogue, const std::vector<ParameterValue>& values);

std::vector<std::string> namesOf(const std::vector<ParameterValue>& values);

/// The same parameters as the device has them. Errors: of the device.
Result<std::vector<ParameterValue>> readBack(devices::Device& device,
                                             const std::vector<ParameterValue>& values);

/// Errors: DeviceRefused when the device has something else than was asked, to single precision.
Result<void> compareValues(const std::vector<ParameterValue>& asked,
                           const std::vector<ParameterValue>& found);

/// What a verification changed beside `values` goes back, the new values stay. Errors: of the device.
Result<void> keepValues(devices::Device& device, const RestoreGuard& guard,
                        const std::vector<ParameterValue>& values);

} // namespace halbench::app
