#include "app/documents/frequency_parts.h"
#include "app/documents/result_documents.h"
#include "control/base/units.h"

#include <cmath>
#include <complex>

namespace halbench::app {

namespace {

using Complex = std::complex<double>;

JsonValue pointsOf(const FrequencyResult& result) {
    JsonValue points = JsonValue::array();
    for (const FrequencyResultPoint& point : result.points) {
        JsonValue closedLoop = JsonValue::object();
        closedLoop.set("re", point.closedLoop.real()).set("im", point.closedLoop.imag());
        JsonValue entry = JsonValue::object();
        entry.set("frequency_hz", point.measured.frequency_rad_s / (2.0 * Pi));
        entry.set("coherence", point.measured.coherence).set("used", point.isUsed);
        entry.set("averages", point.measured.averages);
        entry.set("scatter_radius", point.measured.radius);
        entry.set("plant", circleBody(point.measured.value, point.radius));
        entry.set("open_loop", circleBody(point.openLoop, point.openLoopRadius));
        points.push(entry.set("closed_loop", closedLoop));
    }
    return points;
}

const char* withheldName(control::MeasuredMargin::Withheld withheld) {
    switch (withheld) {
    case control::MeasuredMargin::Withheld::NoCrossing:
        return "no_crossing";
    case control::MeasuredMargin::Withheld::Gap:
        return "gap";
    case control::MeasuredMargin::Withheld::Uncertain:
        return "uncertain";
    case control::MeasuredMargin::Withheld::No:
        break;
    }
    return nullptr;
}

JsonValue rotorOf(const std::optional<control::FrequencyFit>& fit) {
    if (!fit) {
        return {};
    }
    JsonValue body = JsonValue::object();
    body.set("c_over_J", toJson(fit->dampingRate)).set("phi_over_J", toJson(fit->accelerationGain));
    body.set("feedthrough", toJson(fit->feedthrough)).set("lag_s", fit->rotor.lag_s);
    return body.set("misfit_ratio", fit->misfit_ratio).set("points", fit->points);
}

JsonValue excitationOf(const FrequencyResult& result) {
    const FrequencyConfig& config = result.config;
    JsonValue body = JsonValue::object();
    body.set("kind", excitationName(config.excitation));
    body.set("from_hz", config.from_Hz).set("to_hz", config.to_Hz);
    body.set("base_rad_s", result.turn_rad_s);
    body.set("amplitude_rad", config.amplitude_rad).set("periods", config.periods);
    JsonValue bands = JsonValue::array();
    for (const FrequencyBand& band : result.bands) {
        JsonValue entry = JsonValue::object();
        entry.set("from_hz", band.from_Hz).set("to_hz", band.to_Hz).set("lines", band.lines);
        bands.push(entry.set("amplitude_rad", band.amplitude_rad));
    }
    body.set("bands", bands);
    return body.set("least_coherence", config.leastCoherence);
}

} // namespace

JsonValue circleBody(Complex value, double radius) {
    JsonValue body = JsonValue::object();
    body.set("re", value.real()).set("im", value.imag()).set("radius", radius);
    const double size = std::abs(value);
    body.set("magnitude_db", finiteOrNull(20.0 * std::log10(size)));
    body.set("phase_deg", radiansToDegrees(std::arg(value)));
    JsonValue error_dB, error_deg;
    if (radius < size) {
        error_dB = JsonValue::array();
        error_dB.push(20.0 * std::log10(size - radius)).push(20.0 * std::log10(size + radius));
        const double half_deg = radiansToDegrees(std::asin(radius / size));
        const double phase_deg = radiansToDegrees(std::arg(value));
        error_deg = JsonValue::array();
        error_deg.push(phase_deg - half_deg).push(phase_deg + half_deg);
    }
    return body.set("magnitude_ci95_db", error_dB).set("phase_ci95_deg", error_deg);
}

JsonValue marginBody(const control::MeasuredMargin& margin) {
    JsonValue interval;
    if (margin.interval && std::isfinite(margin.interval->second - margin.interval->first)) {
        interval = JsonValue::array();
        interval.push(margin.interval->first).push(margin.interval->second);
    }
    const char* withheld = withheldName(margin.withheld);
    JsonValue body = JsonValue::object();
    body.set("value", margin.value).set("ci95", interval);
    body.set("frequency_rad_s", margin.frequency_rad_s);
    return body.set("withheld", withheld == nullptr ? JsonValue() : JsonValue(withheld));
}

JsonValue frequencyBody(const FrequencyResult& result) {
    JsonValue gains = JsonValue::object();
    gains.set("kp_A_per_rad", result.law.kp_A_per_rad).set("ki_A_per_rad_s", result.law.ki_A_per_rad_s);
    gains.set("kd_A_s_per_rad", result.law.kd_As_per_rad);
    JsonValue margins = JsonValue::object();
    margins.set("phase_margin_deg", marginBody(result.margins.phase_deg));
    margins.set("gain_margin_db", marginBody(result.margins.gain_dB));
    JsonValue systematic = JsonValue::object();
    systematic.set("gain_ratio", result.config.gainError_ratio);
    systematic.set("feedthrough_rad_per_A", result.strayError_rad_per_A);
    JsonValue body = JsonValue::object();
    body.set("excitation", excitationOf(result)).set("gains", gains);
    body.set("sample_period_s", result.period_s).set("delay_samples", result.law.delaySamples);
    body.set("margins", margins).set("rotor", rotorOf(result.fit));
    body.set("systematic_errors", systematic).set("points", pointsOf(result));
    body.set("duration_s", result.duration_s);
    body.set("lowest_speed_rad_s", result.lowestSpeed_rad_s);
    body.set("highest_current_A", result.highestCurrent_A);
    return body.set("highest_temperature_degC", finiteOrNull(result.highestTemperature_degC));
}

} // namespace halbench::app
