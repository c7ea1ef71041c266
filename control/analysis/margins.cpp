#include "control/analysis/margins.h"

#include "control/analysis/frequency_scan.h"
#include "control/base/units.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;

Crossing gainCrossing(const TransferFunction& openLoop, double frequency_rad_s) {
    Crossing crossing;
    crossing.kind = Crossing::Kind::Gain;
    crossing.frequency_rad_s = frequency_rad_s;
    const double margin_rad = std::arg(-openLoop.atFrequency(frequency_rad_s));
    crossing.phaseMargin_deg = radiansToDegrees(margin_rad);
    crossing.delayMargin_s = (margin_rad < 0.0 ? margin_rad + 2.0 * Pi : margin_rad) / frequency_rad_s;
    return crossing;
}

Crossing phaseCrossing(const TransferFunction& openLoop, double frequency_rad_s) {
    Crossing crossing;
    crossing.kind = Crossing::Kind::Phase;
    crossing.frequency_rad_s = frequency_rad_s;
    crossing.gainMargin_ratio = 1.0 / std::abs(openLoop.atFrequency(frequency_rad_s));
    return crossing;
}

bool changesSign(double first, double second) {
    return (first < 0.0 && second >= 0.0) || (first > 0.0 && second <= 0.0);
}

/// Truly on the negative real axis; a jump of the phase by 180 degrees at an undamped pole is none.
bool isOnNegativeAxis(Complex value) {
    return value.real() < 0.0 && std::abs(value.imag()) < 1e-3 * std::abs(value);
}

std::vector<Crossing> crossingsOn(const TransferFunction& openLoop, const std::vector<double>& frequencies) {
    const auto level = [&openLoop](double w) { return std::log(std::abs(openLoop.atFrequency(w))); };
    const auto height = [&openLoop](double w) { return openLoop.atFrequency(w).imag(); };
    const bool isSampled = openLoop.timeBase().isSampled();
    std::vector<Crossing> crossings;
    Complex before;
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        const Complex here = openLoop.atFrequency(frequencies[i]);
        const bool isNyquist = isSampled && i + 1 == frequencies.size();
        if (i > 0 && changesSign(std::log(std::abs(before)), std::log(std::abs(here)))) {
            crossings.push_back(gainCrossing(openLoop, bisect(level, frequencies[i - 1], frequencies[i])));
        }
        if (i > 0 && !isNyquist && changesSign(before.imag(), here.imag())) {
            const double frequency = bisect(height, frequencies[i - 1], frequencies[i]);
            if (isOnNegativeAxis(openLoop.atFrequency(frequency))) {
                crossings.push_back(phaseCrossing(openLoop, frequency));
            }
        }
        if (isNyquist && here.real() < 0.0) {
            crossings.push_back(phaseCrossing(openLoop, frequencies[i]));
        }
        before = here;
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.frequency_rad_s < b.frequency_rad_s; });
    return crossings;
}

void takeIfSmaller(StabilityMargins& margins, const Crossing& crossing) {
    if (crossing.kind == Crossing::Kind::Phase) {
        if (std::abs(std::log(crossing.gainMargin_ratio)) < std::abs(std::log(margins.gainMargin_ratio))) {
            margins.gainMargin_ratio = crossing.gainMargin_ratio;
            margins.phaseCrossover_rad_s = crossing.frequency_rad_s;
        }
        return;
    }
    if (std::abs(crossing.phaseMargin_deg) < std::abs(margins.phaseMargin_deg)) {
        margins.phaseMargin_deg = crossing.phaseMargin_deg;
        margins.gainCrossover_rad_s = crossing.frequency_rad_s;
    }
    margins.delayMargin_s = std::min(margins.delayMargin_s, crossing.delayMargin_s);
}

} // namespace

std::vector<Crossing> allCrossings(const TransferFunction& openLoop) {
    return crossingsOn(openLoop, scanFrequencies(openLoop));
}

StabilityMargins smallestMargins(const TransferFunction& openLoop) {
    const std::vector<double> frequencies = scanFrequencies(openLoop);
    StabilityMargins margins;
    for (const Crossing& crossing : crossingsOn(openLoop, frequencies)) {
        takeIfSmaller(margins, crossing);
    }
    const auto distance = [&openLoop](double w) { return std::abs(1.0 + openLoop.atFrequency(w)); };
    margins.modulusMargin = distance(scanMinimum(distance, frequencies));
    return margins;
}

} // namespace halbench::control
