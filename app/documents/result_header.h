#pragma once

#include "app/documents/text/json_value.h"
#include "app/procedures/base/procedure.h"
#include "devices/device.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// The wall clock's now: ISO 8601, UTC.
std::string wallTime();

/// Head of every result: schema, version, device, start, seed and the quality of the data
/// (resources/help/command-line.md, "Results").
struct ResultHeader {
    std::string schema;
    std::optional<devices::DeviceInfo> device; ///< absent: a result without a device
    std::string started = "1970-01-01T00:00:00Z";
    std::uint64_t seed = 1;
    DataQuality quality;
    std::string software = HALBENCH_VERSION; ///< version that made the result
};

/// Same model, identity and overrides: what was measured on one holds for the other. A simulated motor with
/// other overrides is another motor.
bool isSameDevice(const devices::DeviceInfo& one, const devices::DeviceInfo& other);

/// What is to be said when gains of a motor that was identified on one device are for another one, code
/// `other_device`; nothing for the same one, and nothing when it is not known who was identified. Overrides
/// tell simulated devices apart, a real one is its model and identity.
std::optional<Finding> foreignMotor(const std::optional<devices::DeviceInfo>& identified,
                                    const devices::DeviceInfo& device);

JsonValue toJson(const ResultHeader& header);
JsonValue toJson(const devices::DeviceInfo& device);
JsonValue toJson(const DataQuality& quality);
JsonValue toJson(const std::vector<Finding>& findings);

} // namespace halbench::app
