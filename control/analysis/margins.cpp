#include "control/analysis/margins.h"

#include "control/analysis/frequency_scan.h"
#include "control/analysis/loop_scan.h"
#include "control/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;

Crossing gainCrossing(Complex value, double frequency_rad_s) {
    Crossing crossing;
    crossing.kind = Crossing::Kind::Gain;
    crossing.frequency_rad_s = frequency_rad_s;
    const double margin_rad = std::arg(-value);
    crossing.phaseMargin_deg = radiansToDegrees(margin_rad);
    crossing.delayMargin_s = (margin_rad < 0.0 ? margin_rad + 2.0 * Pi : margin_rad) / frequency_rad_s;
    return crossing;
}

Crossing phaseCrossing(double magnitude_ratio, double frequency_rad_s) {
    Crossing crossing;
    crossing.kind = Crossing::Kind::Phase;
    crossing.frequency_rad_s = frequency_rad_s;
    crossing.gainMargin_ratio = 1.0 / magnitude_ratio;
    return crossing;
}

bool changesSign(double first, double second) {
    return (first < 0.0 && second >= 0.0) || (first > 0.0 && second <= 0.0);
}

/// Truly on the negative real axis; a jump of the phase by 180 degrees at an undamped pole is none.
bool isOnNegativeAxis(Complex value) {
    return value.real() < 0.0 && std::abs(value.imag()) < 1e-3 * std::abs(value);
}

bool isLower(const Crossing& a, const Crossing& b) {
    return a.frequency_rad_s < b.frequency_rad_s;
}

std::vector<Crossing> crossingsOn(const LoopScan& scan) {
    const std::vector<double>& frequencies = scan.frequency_rad_s;
    const auto level = [&scan](double w) { return std::abs(scan.at(w)) - 1.0; };
    const auto height = [&scan](double w) { return scan.at(w).imag(); };
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        const Complex here = scan.value[i];
        const Complex before = scan.value[i == 0 ? 0 : i - 1];
        const bool isNyquist = scan.endsAtNyquist && i + 1 == frequencies.size();
        if (i > 0 && changesSign(std::norm(before) - 1.0, std::norm(here) - 1.0)) {
            const double frequency = rootBetween(level, frequencies[i - 1], frequencies[i]);
            crossings.push_back(gainCrossing(scan.at(frequency), frequency));
        }
        if (i > 0 && !isNyquist && changesSign(before.imag(), here.imag())) {
            const double frequency = rootBetween(height, frequencies[i - 1], frequencies[i]);
            if (isOnNegativeAxis(scan.at(frequency))) {
                crossings.push_back(phaseCrossing(std::abs(scan.at(frequency)), frequency));
            }
        }
        if (isNyquist && here.real() < 0.0) {
            crossings.push_back(phaseCrossing(std::abs(here), frequencies[i]));
        }
    }
    std::sort(crossings.begin(), crossings.end(), isLower);
    return crossings;
}

/// A loop of which the zero lies at z = -1, as that of a rotor without damping, leaves nothing but the
/// rounding of its terms there, and that has no sign: L is 0 then. The coefficients are sums of some products
/// of rounded numbers, hence the factor.
LoopScan scanned(const TransferFunction& openLoop) {
    LoopScan scan = scanLoop(openLoop);
    if (scan.endsAtNyquist && !scan.value.empty()) {
        constexpr double Roundings = 32.0;
        double sum = 0.0;
        double terms = 0.0;
        for (const double coefficient : openLoop.numerator()) { // Horner's rule at z = -1
            sum = coefficient - sum;
            terms += std::abs(coefficient);
        }
        if (std::abs(sum) <= Roundings * std::numeric_limits<double>::epsilon() * terms) {
            scan.value.back() = 0.0;
        }
    }
    return scan;
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

/// Smallest value of a function over a scan, and its place: the best point, refined between its neighbours,
/// or an end of the curve, whose place is the first or last frequency that was looked at.
struct Least {
    double value = 0.0;
    double frequency_rad_s = 0.0;
};

/// `distance` gives a complex number of which the modulus counts.
template <typename Distance>
Least leastOn(const LoopScan& scan, Distance distance) {
    std::size_t best = 0;
    double leastSquare = HUGE_VAL; // the same order without the root
    for (std::size_t i = 0; i < scan.value.size(); ++i) {
        if (const double square = std::norm(distance(scan.value[i])); square < leastSquare) {
            leastSquare = square;
            best = i;
        }
    }
    const Least least{std::abs(distance(scan.value[best])), scan.frequency_rad_s[best]};
    const auto at = [&](double w) { return std::abs(distance(scan.at(w))); };
    const double refined_rad_s =
        goldenMinimum(at, scan.frequency_rad_s[best == 0 ? 0 : best - 1],
                      scan.frequency_rad_s[std::min(best + 1, scan.value.size() - 1)]);
    const double refined = at(refined_rad_s);
    Least result = refined < least.value ? Least{refined, refined_rad_s} : least;
    const auto takeEnd = [&](const std::optional<Complex>& end, double frequency_rad_s) {
        if (end && std::abs(distance(*end)) < result.value) {
            result = {std::abs(distance(*end)), frequency_rad_s};
        }
    };
    takeEnd(scan.atRest, scan.frequency_rad_s.front());
    takeEnd(scan.atInfinity, scan.frequency_rad_s.back());
    return result;
}

StabilityMargins marginsOn(const LoopScan& scan) {
    StabilityMargins margins;
    for (const Crossing& crossing : crossingsOn(scan)) {
        takeIfSmaller(margins, crossing);
    }
    margins.modulusMargin = leastOn(scan, [](Complex L) { return 1.0 + L; }).value;
    margins.knownFrom_rad_s = scan.knownFrom_rad_s;
    return margins;
}

SensitivityPeaks peaksOn(const LoopScan& scan) {
    const Least modulus = leastOn(scan, [](Complex L) { return 1.0 + L; });
    const Least inverse = leastOn(scan, [](Complex L) { return 1.0 + 1.0 / L; });
    return {1.0 / modulus.value, modulus.frequency_rad_s, 1.0 / inverse.value, inverse.frequency_rad_s};
}

/// One stretch between two measured points, straight in log |L| and phase over log frequency.
struct Stretch {
    double low_log = 0.0;
    double high_log = 0.0;
    Complex from;         ///< log L at the low end
    Complex to;           ///< log L at the high end, its phase the nearest to the low end's
    bool isJoined = true; ///< false: too far apart to say anything about the middle

    Complex logAt(double share) const { return from + share * (to - from); }
    double frequency_rad_s(double share) const { return std::exp(low_log + share * (high_log - low_log)); }
};

Stretch stretch(const FrequencyResponse& response, std::size_t i) {
    const double octave_log = std::log(2.0) * (1.0 + 1e-9);
    Stretch result{std::log(response.frequency_rad_s[i - 1]), std::log(response.frequency_rad_s[i]),
                   std::log(response.value[i - 1]), std::log(response.value[i])};
    const double turn_rad = result.to.imag() - result.from.imag();
    result.to -= Complex(0.0, 2.0 * Pi * std::round(turn_rad / (2.0 * Pi)));
    result.isJoined = result.high_log - result.low_log <= octave_log &&
                      std::abs(result.to.imag() - result.from.imag()) <= 0.5 * Pi;
    return result;
}

void addCrossings(std::vector<Crossing>& crossings, const Stretch& stretch) {
    const Complex change = stretch.to - stretch.from;
    if (changesSign(stretch.from.real(), stretch.to.real())) {
        const double share = -stretch.from.real() / change.real();
        crossings.push_back(gainCrossing(std::exp(stretch.logAt(share)), stretch.frequency_rad_s(share)));
    }
    // The phase counted from the nearest odd multiple of 180 degrees.
    const double middle_rad = 0.5 * (stretch.from.imag() + stretch.to.imag());
    const double axis_rad = Pi * (2.0 * std::round((middle_rad - Pi) / (2.0 * Pi)) + 1.0);
    if (changesSign(stretch.from.imag() - axis_rad, stretch.to.imag() - axis_rad)) {
        const double share = (axis_rad - stretch.from.imag()) / change.imag();
        crossings.push_back(
            phaseCrossing(std::exp(stretch.logAt(share).real()), stretch.frequency_rad_s(share)));
    }
}

} // namespace

std::vector<Crossing> allCrossings(const TransferFunction& openLoop) {
    return crossingsOn(scanned(openLoop));
}

std::vector<Crossing> allCrossings(const DeltaSystem& openLoop) {
    return crossingsOn(scanLoop(openLoop));
}

std::vector<Crossing> allCrossings(const DeadTimeSystem& openLoop) {
    return crossingsOn(scanLoop(openLoop));
}

std::vector<Crossing> allCrossings(const FrequencyResponse& openLoop) {
    std::vector<Crossing> crossings;
    for (std::size_t i = 1; i < openLoop.value.size(); ++i) {
        if (const Stretch here = stretch(openLoop, i); here.isJoined) {
            addCrossings(crossings, here);
        }
    }
    std::sort(crossings.begin(), crossings.end(), isLower);
    return crossings;
}

StabilityMargins smallestMargins(const TransferFunction& openLoop) {
    return marginsOn(scanned(openLoop));
}

StabilityMargins smallestMargins(const DeltaSystem& openLoop) {
    return marginsOn(scanLoop(openLoop));
}

StabilityMargins smallestMargins(const DeadTimeSystem& openLoop) {
    return marginsOn(scanLoop(openLoop));
}

StabilityMargins smallestMargins(const FrequencyResponse& openLoop) {
    StabilityMargins margins;
    for (const Crossing& crossing : allCrossings(openLoop)) {
        takeIfSmaller(margins, crossing);
    }
    margins.modulusMargin = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < openLoop.value.size(); ++i) {
        margins.modulusMargin = std::min(margins.modulusMargin, std::abs(1.0 + openLoop.value[i]));
    }
    for (std::size_t i = 1; i < openLoop.value.size(); ++i) {
        const Stretch here = stretch(openLoop, i);
        const auto distance = [&here](double share) { return std::abs(1.0 + std::exp(here.logAt(share))); };
        const double least = here.isJoined ? distance(goldenMinimum(distance, 0.0, 1.0)) : HUGE_VAL;
        margins.modulusMargin = std::min(margins.modulusMargin, least);
    }
    return margins;
}

SensitivityPeaks sensitivityPeaks(const TransferFunction& openLoop) {
    return peaksOn(scanLoop(openLoop));
}

SensitivityPeaks sensitivityPeaks(const DeltaSystem& openLoop) {
    return peaksOn(scanLoop(openLoop));
}

SensitivityPeaks sensitivityPeaks(const DeadTimeSystem& openLoop) {
    return peaksOn(scanLoop(openLoop));
}

std::optional<StableGains> stableGains(const DeltaSystem& openLoop, const std::vector<Crossing>& crossings) {
    std::vector<double> limits;
    for (const Crossing& crossing : crossings) {
        if (crossing.kind == Crossing::Kind::Phase) {
            limits.push_back(crossing.gainMargin_ratio);
        }
    }
    if (const double rest = openLoop.dcGain(); std::isfinite(rest) && rest < 0.0) {
        limits.push_back(-1.0 / rest);
    }
    std::sort(limits.begin(), limits.end());
    std::optional<StableGains> nearest;
    double nearest_log = HUGE_VAL;
    for (std::size_t i = 0; i <= limits.size(); ++i) {
        const StableGains between{i == 0 ? 0.0 : limits[i - 1], i == limits.size() ? HUGE_VAL : limits[i]};
        const double middle = i == limits.size() ? (i == 0 ? 1.0 : 2.0 * limits[i - 1])
                              : i == 0           ? 0.5 * limits[0]
                                                 : std::sqrt(limits[i - 1] * limits[i]);
        const double away_log = between.holds(1.0) ? 0.0
                                                   : std::min(std::abs(std::log(between.from_ratio)),
                                                              std::abs(std::log(between.to_ratio)));
        if (away_log < nearest_log && isStableClosed(openLoop, middle)) {
            nearest = between;
            nearest_log = away_log;
        }
    }
    return nearest;
}

StabilityMargins withStableGains(StabilityMargins margins, const std::vector<Crossing>& crossings,
                                 const std::optional<StableGains>& gains) {
    if (gains && gains->holds(1.0)) {
        return margins;
    }
    margins.gainMargin_ratio = std::numeric_limits<double>::infinity();
    margins.phaseCrossover_rad_s.reset();
    margins.delayMargin_s = 0.0;
    if (gains) {
        margins.gainMargin_ratio = gains->to_ratio <= 1.0 ? gains->to_ratio : gains->from_ratio;
        for (const Crossing& crossing : crossings) {
            if (crossing.kind == Crossing::Kind::Phase &&
                crossing.gainMargin_ratio == margins.gainMargin_ratio) {
                margins.phaseCrossover_rad_s = crossing.frequency_rad_s;
            }
        }
    }
    return margins;
}

} // namespace halbench::control
