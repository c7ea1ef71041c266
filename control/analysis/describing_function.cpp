#include "control/analysis/describing_function.h"

#include "control/analysis/frequency_scan.h"
#include "control/analysis/margins.h"
#include "control/base/assert.h"
#include "control/base/units.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;

bool isPositive(double value) {
    return std::isfinite(value) && value > 0.0;
}

tl::unexpected<Error> noElement() {
    return failure(ErrorCode::OutOfRange,
                   "the limit or level of a nonlinear element must be positive, its hysteresis not negative");
}

int unstablePoles(const TransferFunction& loop, double gain) {
    int count = 0;
    for (const Complex& pole : roots(add(loop.denominator(), scale(loop.numerator(), gain)))) {
        count += (loop.timeBase().isSampled() ? std::abs(pole) > 1.0 : pole.real() > 0.0) ? 1 : 0;
    }
    return count;
}

/// A gain that falls with the amplitude: the cycle is stable when less gain (a larger amplitude) makes the
/// loop stable and more gain unstable.
bool fallsBack(const TransferFunction& loop, double gain) {
    constexpr double Aside = 1e-4;
    return unstablePoles(loop, gain * (1.0 - Aside)) == 0 && unstablePoles(loop, gain * (1.0 + Aside)) > 0;
}

/// Crossings of the line Im L = -height on the left half, found over the scan.
std::vector<double> lineCrossings(const TransferFunction& loop, double height) {
    const auto above = [&](double w) { return loop.atFrequency(w).imag() + height; };
    const std::vector<double> grid = scanFrequencies(loop);
    std::vector<double> result;
    for (std::size_t i = 1; i < grid.size(); ++i) {
        if ((above(grid[i - 1]) < 0.0) != (above(grid[i]) < 0.0)) {
            const double frequency = rootBetween(above, grid[i - 1], grid[i]);
            if (loop.atFrequency(frequency).real() < 0.0) {
                result.push_back(frequency);
            }
        }
    }
    return result;
}

void sortByAmplitude(std::vector<LimitCycle>& cycles) {
    std::sort(cycles.begin(), cycles.end(),
              [](const LimitCycle& a, const LimitCycle& b) { return a.amplitude < b.amplitude; });
}

} // namespace

double saturationGain(double amplitude, double limit) {
    HB_ASSERT(isPositive(amplitude) && isPositive(limit));
    const double r = limit / amplitude;
    return r >= 1.0 ? 1.0 : 2.0 / Pi * (std::asin(r) + r * std::sqrt(1.0 - r * r));
}

double saturationAmplitude(double gain, double limit) {
    HB_ASSERT(gain > 0.0 && gain < 1.0 && isPositive(limit));
    // N < 4 r/pi, so the amplitude lies below 4/(pi gain) limits.
    return rootBetween([&](double amplitude) { return gain - saturationGain(amplitude, limit); }, limit,
                       1.28 * limit / gain);
}

std::complex<double> relayGain(double amplitude, double level, double hysteresis) {
    HB_ASSERT(isPositive(amplitude) && isPositive(level) && hysteresis >= 0.0 && amplitude >= hysteresis);
    const double h = hysteresis / amplitude;
    return 4.0 * level / (Pi * amplitude) * Complex(std::sqrt(1.0 - h * h), -h);
}

double coulombDamping(double level, double amplitude, double frequency_rad_s) {
    HB_ASSERT(level >= 0.0 && isPositive(amplitude) && isPositive(frequency_rad_s));
    return 4.0 * level / (Pi * amplitude * frequency_rad_s);
}

Result<std::vector<LimitCycle>> saturationCycles(const TransferFunction& loop, double limit) {
    if (!isPositive(limit)) {
        return noElement();
    }
    std::vector<LimitCycle> cycles;
    for (const Crossing& crossing : allCrossings(loop)) {
        if (crossing.kind == Crossing::Kind::Phase && crossing.gainMargin_ratio < 1.0) {
            const double gain = crossing.gainMargin_ratio;
            cycles.push_back(
                {saturationAmplitude(gain, limit), crossing.frequency_rad_s, fallsBack(loop, gain)});
        }
    }
    sortByAmplitude(cycles);
    return cycles;
}

// -1/N(A) = -(pi/(4 level)) (sqrt(A^2 - h^2) + j h): a horizontal line on which the amplitude runs to the
// left.
Result<std::vector<LimitCycle>> relayCycles(const TransferFunction& loop, double level, double hysteresis) {
    if (!isPositive(level) || !(hysteresis >= 0.0 && std::isfinite(hysteresis))) {
        return noElement();
    }
    const double perLevel = Pi / (4.0 * level);
    std::vector<LimitCycle> cycles;
    if (hysteresis == 0.0) {
        for (const Crossing& crossing : allCrossings(loop)) {
            if (crossing.kind == Crossing::Kind::Phase) {
                cycles.push_back({1.0 / (perLevel * crossing.gainMargin_ratio), crossing.frequency_rad_s,
                                  fallsBack(loop, crossing.gainMargin_ratio)});
            }
        }
        sortByAmplitude(cycles);
        return cycles;
    }
    for (const double frequency_rad_s : lineCrossings(loop, perLevel * hysteresis)) {
        const double real = loop.atFrequency(frequency_rad_s).real();
        // Loeb: L has to run upward through the line that the amplitude runs along to the left.
        const double later = loop.atFrequency(frequency_rad_s * (1.0 + 1e-6)).imag();
        cycles.push_back(
            {std::hypot(real / perLevel, hysteresis), frequency_rad_s, later > -perLevel * hysteresis});
    }
    sortByAmplitude(cycles);
    return cycles;
}

} // namespace halbench::control
