#include "control/analysis/loop_scan.h"

#include "control/analysis/frequency_scan.h"
#include "control/base/units.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace halbench::control {

namespace {

void look(LoopScan& scan) {
    scan.value.reserve(scan.frequency_rad_s.size());
    for (const double frequency : scan.frequency_rad_s) {
        scan.value.push_back(scan.at(frequency));
    }
}

/// Four points at once: one point alone waits for each of its products in turn. The operations of a point and
/// their order are those of TransferFunction::at, and so are its digits.
struct FourPoints {
    Eigen::Array4d real;
    Eigen::Array4d imaginary;
};

FourPoints evaluate(const Polynomial& polynomial, const FourPoints& x) {
    FourPoints value{Eigen::Array4d::Zero(), Eigen::Array4d::Zero()};
    for (const double coefficient : polynomial) {
        const Eigen::Array4d next = value.real * x.real - value.imaginary * x.imaginary + coefficient;
        value.imaginary = value.real * x.imaginary + value.imaginary * x.real;
        value.real = next;
    }
    return value;
}

FourPoints pointsAt(const double* frequency_rad_s, const TimeBase& base) {
    FourPoints x{Eigen::Array4d::Zero(), Eigen::Map<const Eigen::Array4d>(frequency_rad_s)};
    for (Eigen::Index i = 0; i < 4 && base.isSampled(); ++i) {
        const std::complex<double> z = std::polar(1.0, frequency_rad_s[i] * base.period_s());
        x.real[i] = z.real();
        x.imaginary[i] = z.imag();
    }
    return x;
}

void lookAtRational(LoopScan& scan, const TransferFunction& loop) {
    const std::vector<double>& frequency_rad_s = scan.frequency_rad_s;
    scan.value.reserve(frequency_rad_s.size());
    for (std::size_t first = 0; first + 4 <= frequency_rad_s.size(); first += 4) {
        const FourPoints x = pointsAt(&frequency_rad_s[first], loop.timeBase());
        const FourPoints n = evaluate(loop.numerator(), x);
        const FourPoints d = evaluate(loop.denominator(), x);
        const Eigen::Array4d square = d.real * d.real + d.imaginary * d.imaginary;
        const Eigen::Array4d real = (n.real * d.real + n.imaginary * d.imaginary) / square;
        const Eigen::Array4d imaginary = (n.imaginary * d.real - n.real * d.imaginary) / square;
        for (Eigen::Index i = 0; i < 4; ++i) {
            const auto row = first + static_cast<std::size_t>(i);
            scan.value.push_back(std::isnormal(square[i]) ? std::complex<double>(real[i], imaginary[i])
                                                          : loop.atFrequency(frequency_rad_s[row]));
        }
    }
    for (std::size_t row = scan.value.size(); row < frequency_rad_s.size(); ++row) {
        scan.value.push_back(loop.atFrequency(frequency_rad_s[row]));
    }
}

/// The grid with points between its own, so that no step turns the dead time by more than 0.25 rad.
std::vector<double> closedUp(std::vector<double> grid, double deadTime_s) {
    constexpr double LargestTurn_rad = 0.25;
    constexpr double MostTurns = 200.0;
    const double end_rad_s = 2.0 * Pi * MostTurns / deadTime_s;
    // The dead time alone makes crossings around 1/deadTime, wherever the poles are.
    if (0.01 / deadTime_s < grid.front()) {
        grid.insert(grid.begin(), 0.01 / deadTime_s);
    }
    if (100.0 / deadTime_s > grid.back()) {
        grid.push_back(100.0 / deadTime_s);
    }
    std::vector<double> close = {std::min(grid.front(), end_rad_s)};
    for (const double frequency : grid) {
        const double to_rad_s = std::min(frequency, end_rad_s);
        const double span_rad_s = to_rad_s - close.back();
        const double step_rad_s = std::min(LargestTurn_rad / deadTime_s, 0.0116 * to_rad_s + grid.front());
        const auto parts = static_cast<int>(std::ceil(span_rad_s / step_rad_s));
        const double from_rad_s = close.back();
        for (int part = 1; part <= parts; ++part) {
            close.push_back(part == parts ? to_rad_s : from_rad_s + span_rad_s * part / parts);
        }
    }
    return close;
}

/// Last frequency of the ascending grid with |L| >= 0.01, and one more.
std::size_t relevantPoints(const DeadTimeSystem& loop, const std::vector<double>& grid) {
    constexpr double Irrelevant = 0.01;
    std::size_t count = grid.size();
    while (count > 2 && std::abs(loop.rational().atFrequency(grid[count - 2])) < Irrelevant) {
        --count;
    }
    return count;
}

/// Sampled loops end at the Nyquist frequency, which the grid holds.
void lookAtEnds(LoopScan& scan, const TransferFunction& loop, double deadTime_s) {
    scan.atRest = loop.dcGain();
    const bool isDirect = degree(loop.numerator()) == loop.order();
    if (loop.timeBase().isContinuous() && !(isDirect && deadTime_s > 0.0)) {
        scan.atInfinity = isDirect ? loop.numerator().front() / loop.denominator().front() : 0.0;
    }
}

} // namespace

LoopScan scanLoop(const TransferFunction& openLoop) {
    FrequencyScan grid = frequencyScan(openLoop);
    LoopScan scan{[&openLoop](double w) { return openLoop.atFrequency(w); },
                  std::move(grid.frequency_rad_s),
                  {},
                  openLoop.timeBase().isSampled()};
    if (grid.isCut) {
        scan.knownFrom_rad_s = scan.frequency_rad_s.front();
    }
    lookAtRational(scan, openLoop);
    lookAtEnds(scan, openLoop, 0.0);
    return scan;
}

LoopScan scanLoop(const DeltaSystem& openLoop) {
    LoopScan scan{[&openLoop](double w) { return openLoop.atFrequency(w); },
                  frequencyScan(openLoop).frequency_rad_s,
                  {},
                  true};
    scan.value = openLoop.atFrequencies(scan.frequency_rad_s);
    // A zero at z = -1, of a rotor without damping and of low-passes, leaves rounding there without a sign.
    constexpr double Roundings = 64.0;
    const auto isAtNyquist = [](std::complex<double> zero) {
        return std::abs(zero + 2.0) <= Roundings * std::numeric_limits<double>::epsilon();
    };
    if (std::any_of(openLoop.zeros().begin(), openLoop.zeros().end(), isAtNyquist)) {
        scan.value.back() = 0.0;
    }
    scan.atRest = openLoop.dcGain();
    return scan;
}

LoopScan scanLoop(const DeadTimeSystem& openLoop) {
    LoopScan scan{[&openLoop](double w) { return openLoop.atFrequency(w); },
                  scanFrequencies(openLoop.rational()),
                  {},
                  false};
    if (openLoop.deadTime_s() > 0.0) {
        scan.frequency_rad_s = closedUp(scan.frequency_rad_s, openLoop.deadTime_s());
        scan.frequency_rad_s.resize(relevantPoints(openLoop, scan.frequency_rad_s));
    }
    look(scan);
    lookAtEnds(scan, openLoop.rational(), openLoop.deadTime_s());
    return scan;
}

} // namespace halbench::control
