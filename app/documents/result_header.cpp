#include "app/documents/result_header.h"

#include "app/documents/text/numbers.h"

#include <fmt/format.h>

#include <array>
#include <ctime>
#include <map>

namespace halbench::app {

std::string wallTime() {
    const std::time_t now = std::time(nullptr);
    std::tm utc = {};
    gmtime_r(&now, &utc);
    std::array<char, 32> text{};
    const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
    return std::string(text.data(), length);
}

namespace {

/// As a result keeps them: "0.50" in an address is 0.5.
std::map<std::string, std::string> knownOverrides(const devices::DeviceInfo& device) {
    std::map<std::string, std::string> overrides;
    for (const auto& [key, value] : device.overrides) {
        const std::optional<double> number = parseNumber(value);
        overrides[key] = number ? formatNumber(*number) : value;
    }
    return overrides;
}

} // namespace

JsonValue toJson(const devices::DeviceInfo& device) {
    JsonValue overrides = JsonValue::object();
    for (const auto& [key, value] : device.overrides) {
        const std::optional<double> number = parseNumber(value);
        overrides.set(key, number ? JsonValue(*number) : JsonValue(value));
    }
    JsonValue result = JsonValue::object();
    result.set("model", device.model).set("id", device.id).set("firmware", device.firmware);
    result.set("simulated", device.isSimulated).set("overrides", overrides);
    return result;
}

JsonValue toJson(const std::vector<Finding>& findings) {
    JsonValue list = JsonValue::array();
    for (const Finding& finding : findings) {
        JsonValue entry = JsonValue::object();
        entry.set("code", finding.code).set("message", finding.message).set("hint", finding.hint);
        list.push(entry);
    }
    return list;
}

JsonValue toJson(const DataQuality& quality) {
    JsonValue result = JsonValue::object();
    result.set("verdict", verdictName(quality.verdict)).set("findings", toJson(quality.findings));
    return result;
}

JsonValue toJson(const ResultHeader& header) {
    JsonValue result = JsonValue::object();
    result.set("schema", header.schema).set("halbench", header.software);
    result.set("device", header.device ? toJson(*header.device) : JsonValue());
    result.set("started", header.started).set("seed", header.seed);
    result.set("data_quality", toJson(header.quality));
    return result;
}

bool isSameDevice(const devices::DeviceInfo& one, const devices::DeviceInfo& other) {
    return one.model == other.model && one.id == other.id && knownOverrides(one) == knownOverrides(other);
}

std::optional<Finding> foreignMotor(const std::optional<devices::DeviceInfo>& identified,
                                    const devices::DeviceInfo& device) {
    if (!identified || identified->id.empty()) {
        return std::nullopt;
    }
    const char* hint = "identify this device and use its model for tuning";
    if (identified->model != device.model || identified->id != device.id) {
        return Finding{"other_device",
                       fmt::format("the model was identified on the {} '{}', this device is the {} '{}'",
                                   identified->model, identified->id, device.model, device.id),
                       hint};
    }
    const bool isOtherMotor =
        identified->isSimulated && device.isSimulated && !isSameDevice(*identified, device);
    return isOtherMotor
               ? std::optional(Finding{"other_device",
                                       fmt::format("the model was identified on '{}' with other overrides "
                                                   "than this device has",
                                                   identified->id),
                                       hint})
               : std::nullopt;
}

} // namespace halbench::app
