#pragma once

#include "app/documents/result_header.h"
#include "control/identify/joint_estimate.h"

#include <optional>
#include <string>

namespace halbench::app {

// Parts that results have in common, read back. What is absent or of another kind only stays empty: whoever
// needs it has judged the document before. `object` may be nullptr, then everything is absent.

const JsonValue* member(const JsonValue* object, const char* key);
std::optional<double> numberIn(const JsonValue* object, const char* key);
std::string textIn(const JsonValue* object, const char* key);
bool isTrueIn(const JsonValue* object, const char* key);
const JsonValue::Array& itemsIn(const JsonValue* object, const char* key);

/// {value, unit, ci95, source}
control::Estimate estimateOf(const JsonValue* value);
/// {verdict, findings}
DataQuality qualityOf(const JsonValue* value);
/// {model, id, firmware, simulated, overrides}; nothing where there is none.
std::optional<devices::DeviceInfo> deviceOf(const JsonValue* device);
/// Header of a result, with the overrides of a simulated device.
ResultHeader headerOf(const JsonValue& root);

} // namespace halbench::app
