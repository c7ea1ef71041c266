#include "control/analysis/nyquist.h"

#include "control/analysis/loop_scan.h"
#include "control/base/units.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;

/// The open loop as a function of s (sampled: z = exp(s T)) with what the contour has to pass.
struct Contour {
    std::function<Complex(Complex)> loop;
    LoopScan scan;
    std::vector<double> axisPoles_rad_s; ///< ascending, without repetition, of the upper half
    int unstablePoles = 0;
    std::optional<double> atInfinity; ///< L where the contour ends; a sampled one ends at Nyquist
    bool hasAllDigits = false;        ///< of L as near to z = 1 as one likes
};

/// In ascending order, each once.
std::vector<double> ordered(std::vector<double> frequencies_rad_s) {
    std::sort(frequencies_rad_s.begin(), frequencies_rad_s.end());
    const auto isSame = [](double a, double b) { return b - a <= 1e-6 * b; };
    frequencies_rad_s.erase(std::unique(frequencies_rad_s.begin(), frequencies_rad_s.end(), isSame),
                            frequencies_rad_s.end());
    return frequencies_rad_s;
}

Contour contourOf(const TransferFunction& rational, LoopScan scan, std::function<Complex(Complex)> loop) {
    const TimeBase& base = rational.timeBase();
    Contour contour{std::move(loop), std::move(scan), {}, 0, {}, false};
    for (const Complex& pole : poles(rational)) {
        if (base.isSampled() && pole == 0.0) {
            continue;
        }
        const Complex s = base.isSampled() ? std::log(pole) / base.period_s() : pole;
        const double scale_rad_s = base.isSampled() ? 1.0 / base.period_s() : std::abs(s);
        constexpr double OnAxis_ratio = 1e-6; // a double pole is only found to 1e-8
        if (std::abs(s.real()) > OnAxis_ratio * scale_rad_s) {
            contour.unstablePoles += s.real() > 0.0 ? 1 : 0;
        } else if (s.imag() >= 0.0) {
            contour.axisPoles_rad_s.push_back(s.imag() < OnAxis_ratio * scale_rad_s ? 0.0 : s.imag());
        }
    }
    contour.axisPoles_rad_s = ordered(std::move(contour.axisPoles_rad_s));
    if (base.isContinuous()) {
        const bool isProper = rational.numerator().size() == rational.denominator().size();
        contour.atInfinity = isProper ? rational.numerator().front() / rational.denominator().front() : 0.0;
    }
    return contour;
}

Contour contourOf(const DeltaSystem& system, LoopScan scan, std::function<Complex(Complex)> loop) {
    const double period_s = system.timeBase().period_s();
    Contour contour{std::move(loop), std::move(scan), {}, 0, {}, true};
    for (const Complex& pole : system.poles()) {
        if (pole == -1.0) {
            continue;
        }
        const Complex s = rateOf(pole, period_s);
        constexpr double OnAxis_ratio = 1e-12; // of roots that are known to rounding
        if (pole != 0.0 && std::abs(s.real()) > OnAxis_ratio / period_s) {
            contour.unstablePoles += s.real() > 0.0 ? 1 : 0;
        } else if (s.imag() >= 0.0) {
            contour.axisPoles_rad_s.push_back(s.imag());
        }
    }
    contour.axisPoles_rad_s = ordered(std::move(contour.axisPoles_rad_s));
    return contour;
}

/// Adds the turns of 1 + L up along the contour.
class Walk {
public:
    Walk(const Contour& contour, NyquistResult& result) : m_contour(contour), m_result(result) {}

    void start(Complex s, bool isIndented) { arrive(s, m_contour.loop(s), isIndented); }

    /// Along a path s(x), 0 <= x <= 1, from where the walk stands.
    void along(const std::function<Complex(double)>& path, bool isIndented) {
        const Complex begin = m_here;
        follow(path, 0.0, begin, 1.0, m_contour.loop(path(1.0)), isIndented, 0);
    }

    /// Straight to a value of L, for the end of the contour.
    void finish(double value) {
        m_turn_rad += std::arg((1.0 + value) / (1.0 + m_here));
        m_here = value;
    }

    double turn_rad() const { return m_turn_rad; }
    bool touchesMinusOne() const { return m_touches; }

private:
    void follow(const std::function<Complex(double)>& path, double from, Complex fromValue, double to,
                Complex toValue, bool isIndented, int depth) {
        constexpr int MaxDepth = 40;
        const double middle = 0.5 * (from + to);
        const Complex middleValue = m_contour.loop(path(middle));
        const double first_rad = std::arg((1.0 + middleValue) / (1.0 + fromValue));
        const double second_rad = std::arg((1.0 + toValue) / (1.0 + middleValue));
        if (std::abs(first_rad) + std::abs(second_rad) <= 0.25 * Pi) {
            m_turn_rad += first_rad + second_rad;
            arrive(path(to), toValue, isIndented);
            return;
        }
        if (depth == MaxDepth) {
            m_touches = true;
            return;
        }
        follow(path, from, fromValue, middle, middleValue, isIndented, depth + 1);
        if (!m_touches) {
            follow(path, middle, middleValue, to, toValue, isIndented, depth + 1);
        }
    }

    void arrive(Complex s, Complex value, bool isIndented) {
        m_here = value;
        m_result.curve.push_back({s.imag(), value, isIndented});
    }

    const Contour& m_contour;
    NyquistResult& m_result;
    Complex m_here;
    double m_turn_rad = 0.0;
    bool m_touches = false;
};

/// Radius of the arc around a pole on the axis: at most a thousandth of the way to the next one, and so small
/// that |L| > 10 all around it; then 1 + L has no zero inside (the maximum of |1/L| lies on the circle).
double arcRadius(const Contour& contour, std::size_t index) {
    const double pole_rad_s = contour.axisPoles_rad_s[index];
    const double least_rad_s = contour.scan.frequency_rad_s.front();
    double radius = pole_rad_s > 0.0 ? 1e-3 * pole_rad_s : least_rad_s;
    if (index > 0) {
        radius = std::min(radius, 1e-3 * (pole_rad_s - contour.axisPoles_rad_s[index - 1]));
    }
    if (index + 1 < contour.axisPoles_rad_s.size()) {
        radius = std::min(radius, 1e-3 * (contour.axisPoles_rad_s[index + 1] - pole_rad_s));
    }
    // Coefficients of z lose their digits near z = 1; the scan begins where they have enough.
    const bool canShrink = pole_rad_s > 0.0 || contour.atInfinity.has_value() || contour.hasAllDigits;
    const auto isFar = [&](double r) {
        for (int i = 0; i < 16; ++i) {
            if (std::abs(contour.loop(Complex(0.0, pole_rad_s) + std::polar(r, 2.0 * Pi * i / 16.0))) <
                10.0) {
                return false;
            }
        }
        return true;
    };
    const double smallest = pole_rad_s > 0.0 ? 1e-11 * pole_rad_s : 1e-12 * least_rad_s;
    while (canShrink && radius > smallest && !isFar(radius)) {
        radius *= 0.1;
    }
    return radius;
}

/// The small arc on the right of a pole, from below it (at zero: from the real axis) to above it.
void passPole(Walk& walk, double pole_rad_s, double radius) {
    const bool isAtZero = pole_rad_s == 0.0;
    walk.along(
        [=](double x) {
            const double angle_rad = isAtZero ? 0.5 * Pi * x : Pi * (x - 0.5);
            return Complex(0.0, pole_rad_s) + std::polar(radius, angle_rad);
        },
        true);
}

void climb(Walk& walk, const Contour& contour, double from_rad_s, double to_rad_s) {
    double last_rad_s = from_rad_s;
    const auto goTo = [&](double next_rad_s) {
        const double start_rad_s = last_rad_s;
        walk.along([=](double x) { return Complex(0.0, start_rad_s + x * (next_rad_s - start_rad_s)); },
                   false);
        last_rad_s = next_rad_s;
    };
    for (const double frequency : contour.scan.frequency_rad_s) {
        if (frequency > from_rad_s && frequency < to_rad_s && !walk.touchesMinusOne()) {
            goTo(frequency);
        }
    }
    if (to_rad_s > last_rad_s) {
        goTo(to_rad_s);
    }
}

Result<NyquistResult> walkAlong(const Contour& contour) {
    NyquistResult result;
    result.unstableOpenLoopPoles = contour.unstablePoles;
    Walk walk(contour, result);
    const bool hasPoleAtZero = !contour.axisPoles_rad_s.empty() && contour.axisPoles_rad_s.front() == 0.0;
    const double top_rad_s = contour.scan.frequency_rad_s.back();
    double here_rad_s = 0.0;
    walk.start(hasPoleAtZero ? arcRadius(contour, 0) : 0.0, hasPoleAtZero);
    for (std::size_t i = 0; i < contour.axisPoles_rad_s.size(); ++i) {
        const double pole_rad_s = contour.axisPoles_rad_s[i];
        const double radius = arcRadius(contour, i);
        if (pole_rad_s > 0.0) {
            climb(walk, contour, here_rad_s, pole_rad_s - radius);
        }
        passPole(walk, pole_rad_s, radius);
        here_rad_s = pole_rad_s + radius;
    }
    if (here_rad_s < top_rad_s) { // a sampled pole may sit at the Nyquist frequency itself
        climb(walk, contour, here_rad_s, top_rad_s);
    }
    if (contour.atInfinity) {
        walk.finish(*contour.atInfinity);
    }
    if (walk.touchesMinusOne()) {
        return failure(ErrorCode::Refused,
                       "the Nyquist curve passes through -1: the loop is at the stability limit",
                       "change the gain slightly");
    }
    // The half contour turns 1 + L by pi for each encirclement of the whole one.
    result.encirclements = static_cast<int>(std::lround(walk.turn_rad() / Pi));
    result.unstableClosedLoopPoles = result.unstableOpenLoopPoles - result.encirclements;
    return result;
}

} // namespace

Result<NyquistResult> nyquist(const TransferFunction& openLoop) {
    const TimeBase& base = openLoop.timeBase();
    std::function<Complex(Complex)> loop = [&openLoop](Complex s) { return openLoop.at(s); };
    if (base.isSampled()) {
        loop = [&openLoop, T = base.period_s()](Complex s) { return openLoop.at(std::exp(s * T)); };
    }
    return walkAlong(contourOf(openLoop, scanLoop(openLoop), std::move(loop)));
}

Result<NyquistResult> nyquist(const DeltaSystem& openLoop) {
    const auto loop = [&openLoop, T = openLoop.timeBase().period_s()](Complex s) {
        return openLoop.at(deltaOf(s, T));
    };
    return walkAlong(contourOf(openLoop, scanLoop(openLoop), loop));
}

Result<NyquistResult> nyquist(const DeadTimeSystem& openLoop) {
    if (openLoop.deadTime_s() == 0.0) {
        return nyquist(openLoop.rational());
    }
    Contour contour =
        contourOf(openLoop.rational(), scanLoop(openLoop), [&openLoop](Complex s) { return openLoop.at(s); });
    if (std::abs(*contour.atInfinity) >= 1.0 || std::abs(contour.scan.value.back()) >= 1.0) {
        return failure(ErrorCode::InvalidInput,
                       "with dead time the gain of this loop must fall below 1 at high frequency",
                       "add the filter or actuator of the real system");
    }
    contour.atInfinity =
        0.0; // far to the right the dead time extinguishes L, and 1 + L never leaves that half
    return walkAlong(contour);
}

} // namespace halbench::control
