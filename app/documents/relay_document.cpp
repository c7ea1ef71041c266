#include "app/documents/relay_document.h"

#include "app/documents/document_parts.h"
#include "app/documents/document_units.h"
#include "app/documents/result_documents.h"
#include "app/documents/text/output_file.h"
#include "app/procedures/base/doubtful_source.h"
#include "control/base/units.h"

#include <cmath>

namespace halbench::app {

namespace {

constexpr const char* Schema = "halbench.relay/1";
constexpr const char* Remedy = "make the file with 'halbench identify DEVICE --relay --out'";

JsonValue intervalOf(const std::optional<std::pair<double, double>>& interval) {
    if (!interval) {
        return {};
    }
    JsonValue body = JsonValue::array();
    return body.push(interval->first).push(interval->second);
}

JsonValue relayOf(const RelayResult& result) {
    JsonValue body = JsonValue::object();
    body.set("gain_A_per_rad", result.plan.gain_A_per_rad).set("current_A", result.plan.limit_A);
    body.set("base_rad_s", result.plan.turn_rad_s).set("weave_ratio", result.plan.weave_ratio);
    return body.set("cycles", result.config.cycles);
}

JsonValue cycleOf(const RelayResult& result) {
    const control::LimitCyclePoint& cycle = result.cycle;
    JsonValue plant = JsonValue::object();
    plant.set("re", cycle.plant.real()).set("im", cycle.plant.imag()).set("radius", cycle.radius);
    JsonValue body = JsonValue::object();
    body.set("frequency_rad_s", cycle.frequency_rad_s);
    body.set("frequency_scatter_ratio", cycle.frequencyScatter_ratio);
    body.set("amplitude_rad", cycle.amplitude).set("current_A", cycle.input);
    body.set("growth_ratio", cycle.growth_ratio).set("cycles", cycle.cycles).set("blocks", cycle.blocks);
    body.set("plant", plant);
    const auto& ultimate = result.ultimate;
    body.set("phase_deg", ultimate ? JsonValue(ultimate->phase_deg) : JsonValue());
    return body.set("phase_ci95_deg", ultimate ? intervalOf(ultimate->phase95_deg) : JsonValue());
}

const char* agreementName(RelayAgreement agreement) {
    switch (agreement) {
    case RelayAgreement::Agrees:
        return "agrees";
    case RelayAgreement::Disagrees:
        return "disagrees";
    case RelayAgreement::Unknown:
        break;
    }
    return "unknown";
}

JsonValue modelOf(const RelayResult& result) {
    const RelayPrediction& predicted = result.plan.predicted;
    JsonValue body = JsonValue::object();
    body.set("source", predicted.isOfThisMotor ? "identified" : "published");
    body.set("ultimate_gain_A_per_rad", predicted.at.gain).set("ci95", intervalOf(predicted.gain95));
    body.set("ultimate_period_s", 2.0 * Pi / predicted.at.frequency_rad_s);
    return body.set("agreement", agreementName(result.agreement));
}

} // namespace

JsonValue relayBody(const RelayResult& result) {
    JsonValue body = JsonValue::object();
    body.set("ultimate_gain", toJson(ultimateGainOf(result)));
    body.set("ultimate_period", toJson(ultimatePeriodOf(result)));
    body.set("relay", relayOf(result)).set("cycle", cycleOf(result)).set("model", modelOf(result));
    body.set("sample_period_s", result.period_s).set("delay_samples", result.delaySamples);
    body.set("duration_s", result.duration_s);
    body.set("lowest_speed_rad_s", result.lowestSpeed_rad_s);
    body.set("highest_speed_rad_s", result.highestSpeed_rad_s);
    return body.set("highest_temperature_degC", finiteOrNull(result.highestTemperature_degC));
}

Result<RelayFile> parseRelay(const std::string& text, const std::string& origin) {
    const Result<JsonValue> root = parseDocument(text, origin);
    if (!root) {
        return failure(root.error());
    }
    if (textIn(&*root, "schema") != Schema) {
        return failure(ErrorCode::InvalidInput, origin + ": schema: is not " + Schema, Remedy);
    }
    if (qualityOf(member(&*root, "data_quality")).verdict == Verdict::Refused) {
        return failure(ErrorCode::Refused, origin + ": this relay experiment was refused",
                       "check its findings, then measure again");
    }
    const auto gain = numberIn(member(&*root, "ultimate_gain"), "value");
    const auto period_s = numberIn(member(&*root, "ultimate_period"), "value");
    if (!gain || !period_s || !(*gain > 0.0) || !(*period_s > 0.0)) {
        return failure(ErrorCode::InvalidInput,
                       origin + ": ultimate_gain, ultimate_period: must be more than zero", Remedy);
    }
    const auto sample_s = numberIn(&*root, "sample_period_s");
    const auto delay = numberIn(&*root, "delay_samples");
    if (!sample_s || !delay) {
        return failure(ErrorCode::InvalidInput, origin + ": sample_period_s, delay_samples: are missing",
                       Remedy);
    }
    return RelayFile{headerOf(*root),
                     *gain,
                     *period_s,
                     {*sample_s, static_cast<int>(std::lround(*delay))},
                     doubtsOfRelay(qualityOf(member(&*root, "data_quality")))};
}

Result<RelayFile> readRelayFile(const std::string& path) {
    const Result<std::string> text = readFile(path);
    return text ? parseRelay(*text, path) : Result<RelayFile>(failure(text.error()));
}

} // namespace halbench::app
