#include "control/signals/excitation.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>

namespace halbench::control {

namespace {

Result<std::size_t> sampleCount(const Sampling& sampling) {
    constexpr double MaxSamples = 1e7;
    if (!std::isfinite(sampling.period_s) || !std::isfinite(sampling.duration_s)) {
        return failure(ErrorCode::NotFinite, "period or duration of the excitation is not a finite number");
    }
    const double count = sampling.period_s > 0.0 ? std::round(sampling.duration_s / sampling.period_s) : 0.0;
    if (count < 1.0 || count > MaxSamples) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("an excitation of {} s in steps of {} s is not possible",
                                   sampling.duration_s, sampling.period_s));
    }
    return static_cast<std::size_t>(count);
}

Result<void> checkBand(const Sampling& sampling, double from_Hz, double to_Hz) {
    const double nyquist_Hz = 0.5 / sampling.period_s;
    if (!std::isfinite(from_Hz) || !std::isfinite(to_Hz)) {
        return failure(ErrorCode::NotFinite, "a frequency of the excitation is not a finite number");
    }
    if (from_Hz < 0.0 || to_Hz < 0.0 || from_Hz >= nyquist_Hz || to_Hz >= nyquist_Hz) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} to {} Hz does not lie between 0 and the Nyquist frequency of {} Hz",
                                   from_Hz, to_Hz, nyquist_Hz));
    }
    return {};
}

/// Harmonics of the period nearest to `count` evenly spread frequencies.
std::set<long> harmonics(double duration_s, double from_Hz, double to_Hz, int count) {
    std::set<long> lines;
    for (int i = 0; i < count; ++i) {
        const double share = count == 1 ? 0.0 : static_cast<double>(i) / static_cast<double>(count - 1);
        lines.insert(std::max(1L, std::lround((from_Hz + share * (to_Hz - from_Hz)) * duration_s)));
    }
    return lines;
}

} // namespace

Result<std::vector<double>> chirp(const Sampling& sampling, double from_Hz, double to_Hz) {
    const auto count = sampleCount(sampling);
    if (!count) {
        return failure(count.error());
    }
    if (const auto valid = checkBand(sampling, from_Hz, to_Hz); !valid) {
        return failure(valid.error());
    }
    std::vector<double> result(*count);
    for (std::size_t i = 0; i < *count; ++i) {
        const double t = static_cast<double>(i) * sampling.period_s;
        const double turns = from_Hz * t + 0.5 * (to_Hz - from_Hz) * t * t / sampling.duration_s;
        result[i] = std::sin(2.0 * Pi * turns);
    }
    return result;
}

Result<std::vector<double>> multisine(const Sampling& sampling, double from_Hz, double to_Hz, int count) {
    const auto samples = sampleCount(sampling);
    if (!samples) {
        return failure(samples.error());
    }
    if (const auto valid = checkBand(sampling, from_Hz, to_Hz); !valid) {
        return failure(valid.error());
    }
    const auto lines = count > 0 ? harmonics(sampling.duration_s, from_Hz, to_Hz, count) : std::set<long>{};
    if (count < 1 || lines.size() != static_cast<std::size_t>(count)) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("{} to {} Hz cannot contain {} lines {:.4g} Hz apart", from_Hz, to_Hz,
                                   count, 1.0 / sampling.duration_s),
                       "use a longer excitation, a wider band or fewer lines");
    }
    std::vector<double> result(*samples, 0.0);
    int k = 0;
    for (const long line : lines) {
        const double phase_rad =
            -Pi * static_cast<double>(k) * static_cast<double>(k + 1) / static_cast<double>(count);
        for (std::size_t i = 0; i < *samples; ++i) {
            const double turns =
                static_cast<double>(line) * static_cast<double>(i) / static_cast<double>(*samples);
            result[i] += std::sin(2.0 * Pi * turns + phase_rad);
        }
        ++k;
    }
    double peak = 0.0;
    for (const double value : result) {
        peak = std::max(peak, std::abs(value));
    }
    for (double& value : result) {
        value /= peak;
    }
    return result;
}

Result<std::vector<double>> binarySequence(int stages, int hold) {
    // Taps of primitive polynomials, as a mask of a Galois register (Golomb, "Shift Register Sequences").
    constexpr std::array<std::uint32_t, 15> Taps = {0x3,   0x6,   0xC,   0x14,   0x30,   0x60,   0xB8,  0x110,
                                                    0x240, 0x500, 0xE08, 0x1C80, 0x3802, 0x6000, 0xD008};
    constexpr int MaxHold = 10000;
    if (stages < 2 || stages > 16 || hold < 1 || hold > MaxHold) {
        return failure(
            ErrorCode::OutOfRange,
            fmt::format("a binary sequence of {} stages held for {} samples is not possible", stages, hold),
            "2 to 16 stages, 1 to 10000 samples");
    }
    const std::uint32_t taps = Taps[static_cast<std::size_t>(stages - 2)];
    const std::size_t bits = (std::size_t{1} << stages) - 1;
    std::vector<double> result;
    result.reserve(bits * static_cast<std::size_t>(hold));
    std::uint32_t state = 1;
    for (std::size_t i = 0; i < bits; ++i) {
        const bool isOne = (state & 1U) != 0;
        result.insert(result.end(), static_cast<std::size_t>(hold), isOne ? 1.0 : -1.0);
        state = (state >> 1) ^ (isOne ? taps : 0U);
    }
    return result;
}

} // namespace halbench::control
