#include "app/documents/frequency_table.h"

#include "app/documents/text/numbers.h"
#include "control/base/units.h"
#include "control/lti/frequency_response.h"

#include <cmath>

namespace halbench::app {

namespace {

/// Relative error as decibels either way; nothing when the circle holds zero.
std::string decibels(double ratio) {
    return ratio < 1.0 ? formatNumber(-20.0 * std::log10(1.0 - ratio)) : std::string();
}

std::string degrees(double ratio) {
    return ratio < 1.0 ? formatNumber(radiansToDegrees(std::asin(ratio))) : std::string();
}

} // namespace

std::string frequencyTable(const FrequencyResult& result) {
    control::FrequencyResponse openLoop, plant;
    for (const FrequencyResultPoint& point : result.points) {
        openLoop.frequency_rad_s.push_back(point.measured.frequency_rad_s);
        openLoop.value.push_back(point.openLoop);
        plant.value.push_back(point.measured.value);
    }
    const std::vector<double> loop_dB = control::magnitude_dB(openLoop);
    const std::vector<double> loop_deg = control::phase_deg(openLoop);
    const std::vector<double> plant_dB = control::magnitude_dB(plant);
    const std::vector<double> plant_deg = control::phase_deg(plant);
    std::string text =
        "frequency_hz,magnitude_db,phase_deg,plant_magnitude_db,plant_phase_deg,error_db,error_deg,"
        "coherence,used\n";
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        const FrequencyResultPoint& point = result.points[i];
        const double ratio = point.radius / std::abs(point.measured.value);
        for (const double value : {point.measured.frequency_rad_s / (2.0 * Pi), loop_dB[i], loop_deg[i],
                                   plant_dB[i], plant_deg[i]}) {
            text += formatNumber(value) + ",";
        }
        text += decibels(ratio) + "," + degrees(ratio) + "," + formatNumber(point.measured.coherence) +
                (point.isUsed ? ",1\n" : ",0\n");
    }
    return text;
}

} // namespace halbench::app
