#include "control/design/uncertainty_bands.h"

#include "control/lti/frequency_response.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {

namespace {

bool isMotor(const PositionPlant& plant) {
    return checkPlant(plant).has_value();
}

tl::unexpected<Error> noMotor() {
    return failure(ErrorCode::Refused, "none of the drawn plants is a motor",
                   "identify the motor again, or correct the model file");
}

/// Curves beside each other, one a plant: percentile point by point (nearest rank).
class Curves {
public:
    Curves(std::size_t points, std::size_t plants) : m_points(points), m_values(points) {
        for (auto& values : m_values) {
            values.reserve(plants);
        }
    }

    void add(const std::vector<double>& curve) {
        for (std::size_t i = 0; i < m_points; ++i) {
            m_values[i].push_back(curve[i]);
        }
    }

    bool isEmpty() const { return m_points == 0 || m_values.front().empty(); }

    Band band() {
        Band result;
        for (auto& values : m_values) {
            result.p5.push_back(percentile(values, 0.05));
            result.p95.push_back(percentile(values, 0.95));
        }
        return result;
    }

private:
    static double percentile(std::vector<double>& values, double share_ratio) {
        const auto rank = std::ceil(share_ratio * static_cast<double>(values.size())) - 1.0;
        const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
        std::nth_element(values.begin(), at, values.end());
        return *at;
    }

    std::size_t m_points;
    std::vector<std::vector<double>> m_values;
};

} // namespace

Result<LoopBands> loopBands(const std::vector<PositionPlant>& plants, const PidGains& gains,
                            const LoopTiming& timing, const std::vector<double>& frequency_rad_s) {
    if (const auto valid = checkTiming(timing); !valid) {
        return failure(valid.error());
    }
    const auto controller = sampledController(gains, timing.period_s);
    const auto delayed =
        controller ? series(*controller, TransferFunction::delay(timing.delay_samples, timing.period_s))
                   : controller;
    const auto common = delayed ? frequencyResponse(*delayed, frequency_rad_s) : failure(delayed.error());
    if (!common) {
        return failure(common.error());
    }
    Curves magnitudes(frequency_rad_s.size(), plants.size());
    Curves phases(frequency_rad_s.size(), plants.size());
    for (const PositionPlant& plant : plants) {
        if (!isMotor(plant)) {
            continue;
        }
        FrequencyResponse loop = *frequencyResponse(sampledPlant(plant, timing.period_s), frequency_rad_s);
        for (std::size_t i = 0; i < loop.value.size(); ++i) {
            loop.value[i] *= common->value[i];
        }
        magnitudes.add(magnitude_dB(loop));
        phases.add(phase_deg(loop));
    }
    if (magnitudes.isEmpty()) {
        return noMotor();
    }
    return LoopBands{frequency_rad_s, magnitudes.band(), phases.band()};
}

Result<StepBand> stepBand(const std::vector<PositionPlant>& plants, const PidGains& gains,
                          const LoopTiming& timing, double amplitude_rad, double duration_s,
                          int pointsPerSample) {
    std::vector<LoopStep> steps;
    for (const PositionPlant& plant : plants) {
        if (!isMotor(plant)) {
            continue;
        }
        auto step = linearStep(plant, gains, timing, amplitude_rad, duration_s, pointsPerSample);
        if (step) {
            steps.push_back(std::move(*step));
        } else if (step.error().code != ErrorCode::Refused) {
            return failure(step.error());
        }
    }
    if (steps.empty()) {
        return noMotor();
    }
    Curves curves(steps.front().time_s.size(), steps.size());
    for (const LoopStep& step : steps) {
        curves.add(step.response_rad);
    }
    return StepBand{steps.front().time_s, curves.band()};
}

} // namespace halbench::control
