#include "app/documents/coil_documents.h"

#include <fmt/format.h>

namespace halbench::app {

namespace {

JsonValue toJson(const std::optional<std::pair<double, double>>& interval) {
    JsonValue pair;
    if (interval) {
        pair = JsonValue::array();
        pair.push(interval->first).push(interval->second);
    }
    return pair;
}

JsonValue toJson(const CoilForecast& coil) {
    const control::LimitForecast& forecast = coil.forecast;
    JsonValue document = JsonValue::object();
    document.set("signal", coil.signal).set("temperature_degC", forecast.now_degC);
    document.set("limit_degC", forecast.limit_degC).set("steady_s", forecast.stretch_s);
    document.set("verdict", control::forecastVerdictName(forecast.verdict));
    document.set("reason", textOrNull(std::string(control::forecastReasonName(forecast.reason))));
    document.set("time_s", finiteOrNull(forecast.time_s)).set("ci95_s", toJson(forecast.interval95_s));
    document.set("earliest_s", finiteOrNull(forecast.earliest_s));
    return document.set("final_ci95_degC", toJson(forecast.final95_degC));
}

} // namespace

JsonValue toJson(const std::vector<CoilForecast>& coils) {
    JsonValue list = JsonValue::array();
    for (const CoilForecast& coil : coils) {
        list.push(toJson(coil));
    }
    return list;
}

std::string coilLine(const std::vector<CoilForecast>& coils) {
    const CoilForecast* first = mostUrgent(coils);
    if (first == nullptr) {
        return {};
    }
    const control::LimitForecast& forecast = first->forecast;
    switch (forecast.verdict) {
    case control::LimitForecast::Verdict::AtLimit:
        return fmt::format("{} is at its limit of {:.4g} degC", first->signal, forecast.limit_degC);
    case control::LimitForecast::Verdict::Reached:
        return fmt::format("{} reaches {:.4g} degC in {:.3g} s at this load (95 %: {:.3g} to {:.3g} s)",
                           first->signal, forecast.limit_degC, *forecast.time_s, forecast.interval95_s->first,
                           forecast.interval95_s->second);
    case control::LimitForecast::Verdict::NotBefore:
        return fmt::format("{} does not reach {:.4g} degC for {:.3g} s at this load; whether at all is not "
                           "known yet",
                           first->signal, forecast.limit_degC, *forecast.earliest_s);
    default:
        return {};
    }
}

} // namespace halbench::app
