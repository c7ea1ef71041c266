#include "control/robustness/uncertainty_bands.h"

#include "control/base/units.h"
#include "control/lti/frequency_response.h"
#include "control/robustness/loop_batch.h"
#include "control/robustness/percentiles.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace halbench::control {

namespace {

void add(Band& band, const MiddleNineTenths& values) {
    band.p5.push_back(values.p5);
    band.p95.push_back(values.p95);
}

/// By how much the phase of each lane lies above that of the first.
void turnFromFirst(Eigen::ArrayXd& real, Eigen::ArrayXd& imaginary, Eigen::ArrayXd& turn) {
    const double real0 = real[0];
    const double imaginary0 = imaginary[0];
    turn = imaginary * real0 - real * imaginary0;
    imaginary = real * real0 + imaginary * imaginary0;
    real = turn;
    turn = real / imaginary; // its tangent grows with the angle within a quarter turn
}

/// `commonAt`: what all lanes have in common at a frequency.
template <typename Common>
Result<LoopBands> bandsOf(const LoopBatch& batch, const Common& commonAt,
                          const std::vector<double>& frequency_rad_s) {
    const auto valid =
        frequencyResponse(sampledPlant(batch.plant(0), batch.timing().period_s), frequency_rad_s);
    if (!valid) {
        return failure(valid.error());
    }
    FrequencyResponse first{frequency_rad_s, {}};
    LoopBands bands{frequency_rad_s, {}, {}};
    Eigen::ArrayXd real;
    Eigen::ArrayXd imaginary;
    Eigen::ArrayXd sorted;
    for (const double frequency : frequency_rad_s) {
        const std::complex<double> common = commonAt(frequency);
        batch.rest(frequency, real, imaginary);
        first.value.push_back(common * std::complex<double>(real[0], imaginary[0]));
        sorted = real * real + imaginary * imaginary;
        const MiddleNineTenths square = middleNineTenths(sorted); // grows with the decibels
        const double common_dB = 10.0 * std::log10(std::norm(common));
        add(bands.magnitude_dB,
            {common_dB + 10.0 * std::log10(square.p5), common_dB + 10.0 * std::log10(square.p95)});
        turnFromFirst(real, imaginary, sorted);
        if ((imaginary > 0.0).all()) {
            const MiddleNineTenths tangent = middleNineTenths(sorted);
            add(bands.phase_deg,
                {radiansToDegrees(std::atan(tangent.p5)), radiansToDegrees(std::atan(tangent.p95))});
        } else {
            sorted = real.binaryExpr(imaginary, [](double y, double x) { return std::atan2(y, x); });
            const MiddleNineTenths turn = middleNineTenths(sorted);
            add(bands.phase_deg, {radiansToDegrees(turn.p5), radiansToDegrees(turn.p95)});
        }
    }
    const std::vector<double> phases = phase_deg(first);
    for (std::size_t i = 0; i < phases.size(); ++i) {
        bands.phase_deg.p5[i] += phases[i];
        bands.phase_deg.p95[i] += phases[i];
    }
    return bands;
}

} // namespace

Result<LoopBands> loopBands(const std::vector<PositionPlant>& plants, const PidGains& gains,
                            const LoopTiming& timing, const std::vector<double>& frequency_rad_s) {
    const auto batch = LoopBatch::make(plants, gains, timing);
    if (!batch) {
        return failure(batch.error());
    }
    return bandsOf(
        *batch, [&batch](double frequency) { return batch->common(frequency); }, frequency_rad_s);
}

Result<LoopBands> loopBands(const std::vector<PositionPlant>& plants, const DeltaSystem& controller,
                            const LoopTiming& timing, const std::vector<double>& frequency_rad_s) {
    PidGains one; // of which delay and integrator are left
    one.proportional = 1.0;
    const auto batch = LoopBatch::make(plants, one, timing);
    if (!batch) {
        return failure(batch.error());
    }
    return bandsOf(
        *batch,
        [&](double frequency) { return controller.atFrequency(frequency) * batch->common(frequency); },
        frequency_rad_s);
}

} // namespace halbench::control
