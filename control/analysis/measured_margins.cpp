#include "control/analysis/measured_margins.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;
using Withheld = MeasuredMargin::Withheld;

/// ln L at the points, the phase unwrapped.
std::vector<Complex> logarithms(const FrequencyResponse& response) {
    std::vector<Complex> result;
    for (const Complex& value : response.value) {
        Complex next = std::log(value);
        if (!result.empty()) {
            const double turns = std::round((result.back().imag() - next.imag()) / (2.0 * Pi));
            next += Complex(0.0, 2.0 * Pi * turns);
        }
        result.push_back(next);
    }
    return result;
}

/// What the points around a place tell: slope of ln L over ln w, and the uncertainty of ln L.
struct Local {
    Complex slope;
    double uncertainty = 0.0;
};

Local around(const MeasuredLoop& loop, const std::vector<Complex>& log_L, double frequency_rad_s) {
    const std::vector<double>& w = loop.response.frequency_rad_s;
    const auto above = std::upper_bound(w.begin() + 1, w.end() - 1, frequency_rad_s);
    const auto i = static_cast<std::size_t>(above - w.begin());
    const auto slopeBelow = [&](std::size_t end) {
        return (log_L[end] - log_L[end - 1]) / std::log(w[end] / w[end - 1]);
    };
    const auto relative = [&](std::size_t point) {
        return loop.radius[point] / std::abs(loop.response.value[point]);
    };
    Local local{slopeBelow(i), std::max(relative(i - 1), relative(i))};
    double bend = 0.0;
    if (i >= 2) {
        bend = std::max(bend, std::abs(local.slope - slopeBelow(i - 1)));
    }
    if (i + 1 < w.size()) {
        bend = std::max(bend, std::abs(slopeBelow(i + 1) - local.slope));
    }
    local.uncertainty += 0.125 * bend * std::log(w[i] / w[i - 1]);
    return local;
}

/// A sign change between neighbours that are not joined: something crosses there, nobody saw where.
bool crossesUnseen(const std::vector<double>& level, const std::vector<double>& frequency_rad_s,
                   const std::vector<Crossing>& crossings, Crossing::Kind kind) {
    for (std::size_t i = 1; i < level.size(); ++i) {
        if ((level[i - 1] < 0.0) == (level[i] < 0.0)) {
            continue;
        }
        const bool isSeen = std::any_of(crossings.begin(), crossings.end(), [&](const Crossing& crossing) {
            return crossing.kind == kind && crossing.frequency_rad_s >= frequency_rad_s[i - 1] &&
                   crossing.frequency_rad_s <= frequency_rad_s[i];
        });
        if (!isSeen) {
            return true;
        }
    }
    return false;
}

void give(MeasuredMargin& margin, double value, double halfWidth, double tolerance) {
    margin.interval = {value - halfWidth, value + halfWidth};
    if (!(halfWidth <= tolerance)) {
        margin.withheld = Withheld::Uncertain;
        return;
    }
    margin.withheld = Withheld::No;
    margin.value = value;
}

double ratio(double numerator, double denominator) {
    return denominator == 0.0 ? HUGE_VAL : numerator / denominator;
}

const Crossing* smallest(const std::vector<Crossing>& crossings, Crossing::Kind kind) {
    const auto size = [kind](const Crossing& crossing) {
        return kind == Crossing::Kind::Gain ? std::abs(crossing.phaseMargin_deg)
                                            : std::abs(std::log(crossing.gainMargin_ratio));
    };
    const Crossing* least = nullptr;
    for (const Crossing& crossing : crossings) {
        if (crossing.kind == kind && (least == nullptr || size(crossing) < size(*least))) {
            least = &crossing;
        }
    }
    return least;
}

} // namespace

MeasuredMargins measuredMargins(const MeasuredLoop& loop, const MarginTolerance& tolerance) {
    const std::vector<double>& w = loop.response.frequency_rad_s;
    HB_ASSERT(loop.radius.size() == w.size() && loop.response.value.size() == w.size());
    MeasuredMargins margins;
    if (w.size() < 2) {
        return margins;
    }
    margins.crossings = allCrossings(loop.response);
    const std::vector<Complex> log_L = logarithms(loop.response);
    std::vector<double> level;
    std::vector<double> turn; // sign changes where the phase passes an odd multiple of 180 degrees
    for (const Complex& value : log_L) {
        level.push_back(value.real());
        turn.push_back(std::cos(0.5 * value.imag()));
    }
    if (crossesUnseen(level, w, margins.crossings, Crossing::Kind::Gain)) {
        margins.phase_deg.withheld = Withheld::Gap;
    } else if (const Crossing* gain = smallest(margins.crossings, Crossing::Kind::Gain)) {
        const Local local = around(loop, log_L, gain->frequency_rad_s);
        const double shift = ratio(local.slope.imag(), local.slope.real());
        margins.phase_deg.frequency_rad_s = gain->frequency_rad_s;
        give(margins.phase_deg, gain->phaseMargin_deg,
             radiansToDegrees(local.uncertainty * std::hypot(1.0, shift)), tolerance.phase_deg);
    }
    if (crossesUnseen(turn, w, margins.crossings, Crossing::Kind::Phase)) {
        margins.gain_dB.withheld = Withheld::Gap;
    } else if (const Crossing* phase = smallest(margins.crossings, Crossing::Kind::Phase)) {
        const Local local = around(loop, log_L, phase->frequency_rad_s);
        const double shift = ratio(local.slope.real(), local.slope.imag());
        const double perNeper_dB = 20.0 / std::log(10.0);
        margins.gain_dB.frequency_rad_s = phase->frequency_rad_s;
        give(margins.gain_dB, perNeper_dB * std::log(phase->gainMargin_ratio),
             perNeper_dB * local.uncertainty * std::hypot(1.0, shift), tolerance.gain_dB);
    }
    return margins;
}

} // namespace halbench::control
