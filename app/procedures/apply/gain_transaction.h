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

/// The values before and after a change.
struct ChangedValues {
    std::vector<ParameterValue> before;
    std::vector<ParameterValue> after; ///< as read back
};
/// Enters Apply and writes the values in one transaction; those of before are known from the guard, which
/// must have been taken with their names. Errors: of the device, of the abort, of compareValues.
Result<ChangedValues> writeVerified(devices::Device& device, const RestoreGuard& guard,
                                    const std::vector<ParameterValue>& values,
                                    const ProcedureObserver& observer);

/// Puts back the parameters that a verification changed beside `values`; the new values stay. Errors: of the
/// device.
Result<void> keepValues(devices::Device& device, const RestoreGuard& guard,
                        const std::vector<ParameterValue>& values);

} // namespace halbench::app
