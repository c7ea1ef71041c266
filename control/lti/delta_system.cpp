#include "control/lti/delta_system.h"

#include "control/base/assert.h"
#include "control/lti/conjugate_pairs.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;
using Roots = DeltaSystem::Roots;

bool isFinite(const Roots& roots) {
    return std::all_of(roots.begin(), roots.end(),
                       [](Complex r) { return std::isfinite(r.real()) && std::isfinite(r.imag()); });
}

Roots joined(Roots first, const Roots& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

Roots moved(Roots roots, double by) {
    for (Complex& root : roots) {
        root += by;
    }
    return roots;
}

/// Of a polynomial without leading zeros, of at most second order; the smaller of two real roots from the
/// product, so that it keeps its digits.
Roots rootsOf(const Polynomial& p) {
    if (p.size() <= 1) {
        return {};
    }
    if (p.size() == 2) {
        return {-p[1] / p[0]};
    }
    const double half = 0.5 * p[1] / p[0];
    const double product = p[2] / p[0];
    const double square = half * half - product;
    if (square < 0.0) {
        const double height = std::sqrt(-square);
        return {Complex(-half, height), Complex(-half, -height)};
    }
    const double larger = -(half + std::copysign(std::sqrt(square), half));
    return {larger, larger == 0.0 ? 0.0 : product / larger};
}

/// Written out: the compiler's complex product checks every factor for infinities, five times the work.
Complex product(Complex a, Complex b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// prod(d - root) with its derivative.
struct Product {
    Complex value{1.0, 0.0};
    Complex slope{0.0, 0.0};
};

Product productOf(const Roots& roots, Complex d) {
    double re = 1.0;
    double im = 0.0;
    double slopeRe = 0.0;
    double slopeIm = 0.0;
    for (const Complex& root : roots) {
        const double x = d.real() - root.real();
        const double y = d.imag() - root.imag();
        const double nextSlope = slopeRe * x - slopeIm * y + re;
        slopeIm = slopeRe * y + slopeIm * x + im;
        slopeRe = nextSlope;
        const double next = re * x - im * y;
        im = re * y + im * x;
        re = next;
    }
    return {{re, im}, {slopeRe, slopeIm}};
}

Complex quotient(Complex numerator, Complex denominator) {
    const double square = std::norm(denominator);
    if (!std::isnormal(square)) {
        return numerator / denominator;
    }
    return {(numerator.real() * denominator.real() + numerator.imag() * denominator.imag()) / square,
            (numerator.imag() * denominator.real() - numerator.real() * denominator.imag()) / square};
}

/// Points that lie together could not part, and real ones could not leave the axis.
void setApart(Roots& points) {
    constexpr double Share = 0.05;
    constexpr double Together = 1e-8;
    constexpr double Least = 1e-8; // of points at d = 0
    const Roots from = points;
    for (std::size_t i = 0; i < from.size(); ++i) {
        double room = HUGE_VAL;
        for (std::size_t j = 0; j < from.size(); ++j) {
            room = j == i ? room : std::min(room, std::abs(from[i] - from[j]));
        }
        const double size = std::abs(from[i]) + Least;
        const double turn_rad = 1.0 + 2.4 * static_cast<double>(i); // no two alike
        if (room <= Together * size) {
            points[i] += std::polar(1e-4 * size, turn_rad);
        } else if (from[i].imag() == 0.0) {
            points[i] += Complex(0.0, std::copysign(Share * std::min(room, size), std::sin(turn_rad)));
        }
    }
}

/// One round of Aberth's iteration; returns the largest move relative to its point.
double improve(const DeltaSystem& loop, double factor, Roots& points) {
    const double roundings = 4.0 * static_cast<double>(points.size() + 1);
    const double gain = factor * loop.gain();
    double largest = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Product D = productOf(loop.poles(), points[i]);
        const Product N = productOf(loop.zeros(), points[i]);
        const Complex value = D.value + gain * N.value;
        const double terms = std::abs(D.value) + std::abs(gain) * std::abs(N.value);
        if (std::abs(value) <= roundings * std::numeric_limits<double>::epsilon() * terms) {
            continue;
        }
        Complex repulsion = 0.0;
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (j != i && points[i] != points[j]) {
                repulsion += quotient(1.0, points[i] - points[j]);
            }
        }
        const Complex step = quotient(value, D.slope + gain * N.slope);
        const Complex move = quotient(step, 1.0 - product(step, repulsion));
        if (std::isfinite(move.real()) && std::isfinite(move.imag())) {
            points[i] -= move;
            largest = std::max(largest, std::abs(move) / std::max(std::abs(points[i]), 1e-300));
        }
    }
    return largest;
}

} // namespace

DeltaSystem::DeltaSystem(Roots zeros, Roots poles, double gain, const TimeBase& timeBase)
    : m_zeros(std::move(zeros)), m_poles(std::move(poles)), m_gain(gain), m_timeBase(timeBase) {}

Result<DeltaSystem> DeltaSystem::make(Roots zeros, Roots poles, double gain, const TimeBase& timeBase) {
    if (!isFinite(zeros) || !isFinite(poles) || !std::isfinite(gain)) {
        return failure(ErrorCode::NotFinite, "a zero, a pole or the gain of a system is not a finite number");
    }
    if (zeros.size() > poles.size()) {
        return failure(ErrorCode::InvalidInput, "the transfer function has more zeros than poles",
                       "add the filter or actuator of the real system");
    }
    HB_ASSERT(timeBase.isSampled());
    return DeltaSystem(std::move(zeros), std::move(poles), gain, timeBase);
}

Result<DeltaSystem> DeltaSystem::factor(const Polynomial& numerator, const Polynomial& denominator,
                                        const TimeBase& timeBase) {
    const Polynomial N = trimmed(numerator);
    const Polynomial D = trimmed(denominator);
    HB_ASSERT(N.size() <= 3 && D.size() <= 3);
    if (D.front() == 0.0) {
        return failure(ErrorCode::InvalidInput, "the denominator of the transfer function is zero");
    }
    return make(rootsOf(N), rootsOf(D), N.front() / D.front(), timeBase);
}

std::complex<double> DeltaSystem::at(std::complex<double> d) const {
    // Factor by factor, so that a long product neither overflows nor vanishes on the way.
    Complex value = m_gain;
    for (std::size_t i = 0; i < m_poles.size(); ++i) {
        if (i < m_zeros.size()) {
            const Complex zero = d - m_zeros[i];
            value = product(value, zero);
        }
        value = quotient(value, d - m_poles[i]);
    }
    return value;
}

std::complex<double> DeltaSystem::atFrequency(double frequency_rad_s) const {
    return at(deltaOf({0.0, frequency_rad_s}, m_timeBase.period_s()));
}

std::vector<std::complex<double>>
DeltaSystem::atFrequencies(const std::vector<double>& frequency_rad_s) const {
    std::vector<Complex> values;
    values.reserve(frequency_rad_s.size());
    for (std::size_t first = 0; first + 4 <= frequency_rad_s.size(); first += 4) {
        Eigen::Array4d x;
        Eigen::Array4d y;
        for (Eigen::Index i = 0; i < 4; ++i) {
            const Complex d =
                deltaOf({0.0, frequency_rad_s[first + static_cast<std::size_t>(i)]}, m_timeBase.period_s());
            x[i] = d.real();
            y[i] = d.imag();
        }
        Eigen::Array4d re = Eigen::Array4d::Constant(m_gain);
        Eigen::Array4d im = Eigen::Array4d::Zero();
        for (std::size_t i = 0; i < m_poles.size(); ++i) {
            if (i < m_zeros.size()) {
                const Eigen::Array4d u = x - m_zeros[i].real();
                const Eigen::Array4d v = y - m_zeros[i].imag();
                const Eigen::Array4d next = re * u - im * v;
                im = re * v + im * u;
                re = next;
            }
            const Eigen::Array4d u = x - m_poles[i].real();
            const Eigen::Array4d v = y - m_poles[i].imag();
            const Eigen::Array4d square = u * u + v * v;
            const Eigen::Array4d next = (re * u + im * v) / square;
            im = (im * u - re * v) / square;
            re = next;
        }
        for (Eigen::Index i = 0; i < 4; ++i) {
            values.emplace_back(re[i], im[i]);
        }
    }
    for (std::size_t i = values.size(); i < frequency_rad_s.size(); ++i) {
        values.push_back(atFrequency(frequency_rad_s[i]));
    }
    return values;
}

double DeltaSystem::dcGain() const {
    const bool integrates = std::find(m_poles.begin(), m_poles.end(), Complex(0.0)) != m_poles.end();
    return integrates ? std::numeric_limits<double>::infinity() : at(0.0).real();
}

Result<DeltaSystem> series(const DeltaSystem& first, const DeltaSystem& second) {
    const auto base = commonTimeBase(first.timeBase(), second.timeBase());
    if (!base) {
        return failure(base.error());
    }
    return DeltaSystem::make(joined(first.zeros(), second.zeros()), joined(first.poles(), second.poles()),
                             first.gain() * second.gain(), *base);
}

Result<DeltaSystem> toDeltaSystem(const ZeroPoleGain& system) {
    return DeltaSystem::make(moved(system.zeros(), -1.0), moved(system.poles(), -1.0), system.gain(),
                             system.timeBase());
}

std::vector<std::complex<double>> poles(const DeltaSystem& system) {
    return moved(system.poles(), 1.0);
}

std::vector<std::complex<double>> zeros(const DeltaSystem& system) {
    return moved(system.zeros(), 1.0);
}

DeltaSystem::Roots closedLoopRoots(const DeltaSystem& openLoop, double factor, DeltaSystem::Roots start) {
    HB_ASSERT(start.size() == openLoop.poles().size());
    constexpr int MostRounds = 200; // from neighbours some four are enough
    setApart(start);
    for (int round = 0; round < MostRounds && improve(openLoop, factor, start) > 1e-15; ++round) {
    }
    return inConjugatePairs(start);
}

DeltaSystem::Roots closedLoopRoots(const DeltaSystem& openLoop, double factor) {
    return closedLoopRoots(openLoop, factor, openLoop.poles());
}

bool isStableClosed(const DeltaSystem& openLoop, double factor) {
    const Roots roots = closedLoopRoots(openLoop, factor);
    return std::all_of(roots.begin(), roots.end(),
                       [](Complex d) { return 2.0 * d.real() + std::norm(d) < 0.0; });
}

std::complex<double> deltaOf(std::complex<double> s_rad_s, double period_s) {
    const double growth = s_rad_s.real() * period_s;
    const double turn_rad = s_rad_s.imag() * period_s;
    const double half = std::sin(0.5 * turn_rad);
    if (growth == 0.0) {
        return {-2.0 * half * half, std::sin(turn_rad)};
    }
    const double radius = std::exp(growth);
    return {std::expm1(growth) - 2.0 * radius * half * half, radius * std::sin(turn_rad)};
}

std::complex<double> rateOf(std::complex<double> d, double period_s) {
    const double excess = 2.0 * d.real() + std::norm(d); // |z|^2 - 1
    return Complex(0.5 * std::log1p(excess), std::atan2(d.imag(), 1.0 + d.real())) / period_s;
}

} // namespace halbench::control
