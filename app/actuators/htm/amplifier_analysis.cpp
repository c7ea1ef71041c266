#include "app/actuators/htm/amplifier_analysis.h"

#include "control/base/units.h"

#include <cmath>

namespace halbench::app {

namespace {

double magnitude_dB(const models::AmplifierModel& model, double frequency_Hz) {
    return 20.0 * std::log10(std::abs(models::amplifierResponse_A_per_V(model, frequency_Hz)));
}

/// Steps of 1/50 decade turn the phase by less than a degree or two, so the nearest branch is the right one.
double nearestBranch(double phase_deg, double previous_deg) {
    return phase_deg - 360.0 * std::round((phase_deg - previous_deg) / 360.0);
}

/// The last crossing of the level, refined by bisection; nothing when the curve stays above it.
std::optional<double> lastFall_Hz(const models::AmplifierModel& model,
                                  const std::vector<double>& frequency_Hz,
                                  const std::vector<double>& curve_dB, double level_dB) {
    for (std::size_t index = curve_dB.size(); index-- > 1;) {
        if (curve_dB[index - 1] >= level_dB && curve_dB[index] < level_dB) {
            double low = frequency_Hz[index - 1];
            double high = frequency_Hz[index];
            for (int round = 0; round < 60; ++round) {
                const double middle = std::sqrt(low * high);
                (magnitude_dB(model, middle) >= level_dB ? low : high) = middle;
            }
            return low;
        }
    }
    return std::nullopt;
}

} // namespace

Result<AmplifierAnalysis> analyseAmplifier(const models::AmplifierParts& parts, double largestCurrent_A) {
    const Result<models::AmplifierModel> model = models::amplifierModel(parts);
    if (!model) {
        return failure(model.error());
    }
    constexpr int PointsPerDecade = 50;
    constexpr int Decades = 5;
    AmplifierAnalysis result;
    double phase_deg = 0.0;
    for (int point = 0; point <= PointsPerDecade * Decades; ++point) {
        const double frequency_Hz = std::pow(10.0, static_cast<double>(point) / PointsPerDecade);
        const std::complex<double> response = models::amplifierResponse_A_per_V(*model, frequency_Hz);
        phase_deg = nearestBranch(radiansToDegrees(std::arg(response)), phase_deg);
        result.frequency_Hz.push_back(frequency_Hz);
        result.magnitude_dB.push_back(20.0 * std::log10(std::abs(response)));
        result.phase_deg.push_back(phase_deg);
    }
    result.gain_A_per_V = model->gain_A_per_V;
    result.lagAt10Hz_deg = -result.phase_deg[PointsPerDecade];
    constexpr std::size_t At1kHz = 3 * std::size_t{PointsPerDecade};
    result.magnitudeAt1kHz_dB = result.magnitude_dB[At1kHz];
    result.phaseAt1kHz_deg = result.phase_deg[At1kHz];
    result.shuntPower_W = largestCurrent_A * largestCurrent_A * parts.R10_Ohm;
    result.shuntPowerEach_W = 0.25 * result.shuntPower_W;
    const double static_dB = 20.0 * std::log10(std::abs(model->gain_A_per_V));
    result.cutoff_Hz = lastFall_Hz(*model, result.frequency_Hz, result.magnitude_dB,
                                   static_dB + 20.0 * std::log10(std::sqrt(0.5)));
    return result;
}

} // namespace halbench::app
