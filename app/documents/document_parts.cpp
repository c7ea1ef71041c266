#include "app/documents/document_parts.h"

#include "app/documents/text/numbers.h"

namespace halbench::app {

namespace {

control::EstimateSource sourceNamed(const std::string& name) {
    using control::EstimateSource;
    for (const EstimateSource source : {EstimateSource::Identified, EstimateSource::Given}) {
        if (name == control::estimateSourceName(source)) {
            return source;
        }
    }
    return EstimateSource::NotIdentifiable;
}

Verdict verdictNamed(const std::string& name) {
    for (const Verdict verdict : {Verdict::Good, Verdict::Refused}) {
        if (name == verdictName(verdict)) {
            return verdict;
        }
    }
    return Verdict::Doubtful;
}

} // namespace

std::optional<devices::DeviceInfo> deviceOf(const JsonValue* device) {
    if (device == nullptr || !device->isObject()) {
        return std::nullopt;
    }
    devices::DeviceInfo info;
    info.model = textIn(device, "model");
    info.id = textIn(device, "id");
    info.firmware = textIn(device, "firmware");
    info.isSimulated = isTrueIn(device, "simulated");
    const JsonValue* overrides = member(device, "overrides");
    if (overrides == nullptr || !overrides->isObject()) {
        return info;
    }
    for (const JsonMember& entry : overrides->members()) {
        if (entry.value.isNumber()) {
            info.overrides.emplace_back(entry.key, formatNumber(entry.value.number()));
        } else if (entry.value.isText()) {
            info.overrides.emplace_back(entry.key, entry.value.text());
        }
    }
    return info;
}

const JsonValue* member(const JsonValue* object, const char* key) {
    return object == nullptr ? nullptr : object->find(key);
}

std::optional<double> numberIn(const JsonValue* object, const char* key) {
    const JsonValue* value = member(object, key);
    return value != nullptr && value->isNumber() ? std::optional(value->number()) : std::nullopt;
}

std::string textIn(const JsonValue* object, const char* key) {
    const JsonValue* value = member(object, key);
    return value != nullptr && value->isText() ? value->text() : std::string();
}

bool isTrueIn(const JsonValue* object, const char* key) {
    const JsonValue* value = member(object, key);
    return value != nullptr && value->isBoolean() && value->boolean();
}

const JsonValue::Array& itemsIn(const JsonValue* object, const char* key) {
    static const JsonValue::Array none;
    const JsonValue* value = member(object, key);
    return value != nullptr && value->isArray() ? value->items() : none;
}

control::Estimate estimateOf(const JsonValue* value) {
    control::Estimate estimate;
    estimate.value = numberIn(value, "value");
    estimate.unit = textIn(value, "unit");
    estimate.source = sourceNamed(textIn(value, "source"));
    const JsonValue::Array& interval = itemsIn(value, "ci95");
    if (interval.size() == 2 && interval[0].isNumber() && interval[1].isNumber()) {
        estimate.interval95 = std::pair(interval[0].number(), interval[1].number());
    }
    return estimate;
}

DataQuality qualityOf(const JsonValue* value) {
    DataQuality quality;
    quality.verdict = verdictNamed(textIn(value, "verdict"));
    for (const JsonValue& finding : itemsIn(value, "findings")) {
        quality.findings.push_back(
            {textIn(&finding, "code"), textIn(&finding, "message"), textIn(&finding, "hint")});
    }
    return quality;
}

ResultHeader headerOf(const JsonValue& root) {
    ResultHeader header;
    header.schema = textIn(&root, "schema");
    header.software = textIn(&root, "halbench");
    header.device = deviceOf(member(&root, "device"));
    header.started = textIn(&root, "started");
    const JsonValue* seed = member(&root, "seed");
    const auto whole = seed != nullptr ? seed->integer() : std::nullopt;
    header.seed = whole && *whole >= 0 ? static_cast<std::uint64_t>(*whole) : 1;
    header.quality = qualityOf(member(&root, "data_quality"));
    return header;
}

} // namespace halbench::app
