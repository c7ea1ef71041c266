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

/// The loop over its scan, looked at once.
struct Scan {
    std::vector<double> frequency_rad_s;
    std::vector<Complex> value;
};

Scan scan(const TransferFunction& openLoop) {
    Scan result{scanFrequencies(openLoop), {}};
    result.value.reserve(result.frequency_rad_s.size());
    for (const double frequency : result.frequency_rad_s) {
        result.value.push_back(openLoop.atFrequency(frequency));
    }
    return result;
}

std::vector<Crossing> crossingsOn(const TransferFunction& openLoop, const Scan& scanned) {
    const std::vector<double>& frequencies = scanned.frequency_rad_s;
    const auto level = [&openLoop](double w) { return std::log(std::abs(openLoop.atFrequency(w))); };
    const auto height = [&openLoop](double w) { return openLoop.atFrequency(w).imag(); };
    const bool isSampled = openLoop.timeBase().isSampled();
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        const Complex here = scanned.value[i];
        const Complex before = scanned.value[i == 0 ? 0 : i - 1];
        const bool isNyquist = isSampled && i + 1 == frequencies.size();
        if (i > 0 && changesSign(std::norm(before) - 1.0, std::norm(here) - 1.0)) {
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
    return crossingsOn(openLoop, scan(openLoop));
}

StabilityMargins smallestMargins(const TransferFunction& openLoop) {
    const Scan scanned = scan(openLoop);
    StabilityMargins margins;
    for (const Crossing& crossing : crossingsOn(openLoop, scanned)) {
        takeIfSmaller(margins, crossing);
    }
    const auto distance = [&openLoop](double w) { return std::abs(1.0 + openLoop.atFrequency(w)); };
    const auto nearest =
        std::min_element(scanned.value.begin(), scanned.value.end(),
                         [](Complex a, Complex b) { return std::norm(1.0 + a) < std::norm(1.0 + b); });
    const auto at = static_cast<std::size_t>(nearest - scanned.value.begin());
    const std::size_t last = scanned.value.size() - 1;
    const double refined_rad_s = goldenMinimum(distance, scanned.frequency_rad_s[at == 0 ? 0 : at - 1],
                                               scanned.frequency_rad_s[std::min(at + 1, last)]);
    margins.modulusMargin = std::min(distance(refined_rad_s), std::abs(1.0 + *nearest));
    return margins;
}

} // namespace halbench::control
