#include "app/procedures/frequency/measured_loop.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace halbench::app {

MeasuredPlant measuredPlant(const FrequencyResult& result) {
    MeasuredPlant plant;
    plant.period_s = result.period_s;
    plant.leastCoherence = result.config.leastCoherence;
    for (const FrequencyResultPoint& point : result.points) {
        const std::complex<double> value = point.measured.value;
        if (std::isfinite(std::norm(value)) && std::norm(value) > 0.0) {
            plant.points.push_back(
                {point.measured.frequency_rad_s / (2.0 * Pi), value, point.isUsed, point.measured.coherence});
        }
    }
    return plant;
}

std::map<std::string, MeasuredPlant> measuredPlants(const AxesFrequencyResult& result) {
    std::map<std::string, MeasuredPlant> plants;
    for (std::size_t i = 0; i < result.axes.size(); ++i) {
        const control::SampledPositionLaw& law = result.axes[i].law;
        MeasuredPlant plant;
        plant.period_s = result.period_s;
        plant.leastCoherence = result.config.leastCoherence;
        for (const AxesFrequencyPoint& point : result.points) {
            const double w = point.plant.frequency_rad_s;
            const std::complex<double> late = std::polar(1.0, -w * result.period_s * law.delaySamples);
            const std::complex<double> value =
                point.loop.loops[i].value / (late * control::feedbackResponse(law, w));
            if (std::isfinite(std::norm(value)) && std::norm(value) > 0.0) {
                plant.points.push_back({w / (2.0 * Pi), value, point.isUsed[i],
                                        point.plant.coherence(static_cast<Eigen::Index>(i))});
            }
        }
        plants.emplace(result.axes[i].axis.id, std::move(plant));
    }
    return plants;
}

namespace {

Result<void> checkRate(const MeasuredPlant& plant, const control::LoopTiming& timing) {
    constexpr double Rounding_ratio = 1e-9;
    if (std::abs(plant.period_s - timing.period_s) > Rounding_ratio * timing.period_s) {
        return failure(ErrorCode::InvalidInput,
                       fmt::format("sampling period of the response {:.4g} ms, of this loop {:.4g} ms",
                                   1e3 * plant.period_s, 1e3 * timing.period_s),
                       "measure the response on this device");
    }
    return {};
}

MeasuredLoop loopOf(const MeasuredPlant& plant, const control::TransferFunction& controller,
                    const control::LoopTiming& timing) {
    MeasuredLoop loop;
    loop.leastCoherence = plant.leastCoherence;
    double near_deg = -180.0;
    for (const MeasuredPlant::Point& point : plant.points) {
        const double w = 2.0 * Pi * point.frequency_Hz;
        const std::complex<double> late = std::polar(1.0, -w * timing.period_s * timing.delay_samples);
        const std::complex<double> L = controller.atFrequency(w) * late * point.value;
        double phase_deg = radiansToDegrees(std::arg(L));
        phase_deg += 360.0 * std::round((near_deg - phase_deg) / 360.0);
        near_deg = point.isUsed ? phase_deg : near_deg;
        loop.frequency_Hz.push_back(point.frequency_Hz);
        loop.magnitude_dB.push_back(20.0 * std::log10(std::abs(L)));
        loop.phase_deg.push_back(phase_deg);
        loop.isUsed.push_back(point.isUsed);
        loop.coherence.push_back(point.coherence.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    return loop;
}

} // namespace

Result<MeasuredLoop> measuredLoop(const MeasuredPlant& plant, const control::PidGains& gains,
                                  const control::LoopTiming& timing) {
    const auto suits = checkRate(plant, timing);
    const auto controller =
        suits ? control::sampledController(gains, timing.period_s) : failure(suits.error());
    return controller ? Result<MeasuredLoop>(loopOf(plant, *controller, timing))
                      : failure(controller.error());
}

Result<MeasuredLoop> measuredLoop(const MeasuredPlant& plant, const control::FilteredLaw& law,
                                  const control::LoopTiming& timing) {
    const auto suits = checkRate(plant, timing);
    const auto controller =
        suits ? control::filteredController(law, timing.period_s) : failure(suits.error());
    return controller ? Result<MeasuredLoop>(loopOf(plant, *controller, timing))
                      : failure(controller.error());
}

} // namespace halbench::app
