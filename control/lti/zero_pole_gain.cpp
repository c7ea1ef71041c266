#include "control/lti/zero_pole_gain.h"

#include "control/base/assert.h"
#include "control/lti/realization.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;
using Roots = ZeroPoleGain::Roots;

bool isFinite(const Roots& roots) {
    return std::all_of(roots.begin(), roots.end(),
                       [](Complex r) { return std::isfinite(r.real()) && std::isfinite(r.imag()); });
}

/// Conjugate pairs next to each other, slowest first; false when a partner is missing. Partners that differ
/// by rounding are made exact.
bool pairUp(Roots& roots) {
    std::sort(roots.begin(), roots.end(), [](Complex a, Complex b) { return std::abs(a) < std::abs(b); });
    Roots paired;
    while (!roots.empty()) {
        const Complex root = roots.front();
        roots.erase(roots.begin());
        const double rounding = 1e-9 * std::abs(root);
        if (std::abs(root.imag()) <= 1e-14 * std::abs(root)) {
            paired.emplace_back(root.real(), 0.0);
            continue;
        }
        const auto partner = std::min_element(roots.begin(), roots.end(), [&](Complex a, Complex b) {
            return std::abs(a - std::conj(root)) < std::abs(b - std::conj(root));
        });
        if (partner == roots.end() || std::abs(*partner - std::conj(root)) > rounding) {
            return false;
        }
        const Complex mean = 0.5 * (root + std::conj(*partner));
        roots.erase(partner);
        paired.push_back(mean);
        paired.push_back(std::conj(mean));
    }
    roots = std::move(paired);
    return true;
}

Roots joined(Roots first, const Roots& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// Real sections of two roots, slowest first, and one of a single root last when their number is odd.
std::vector<Roots> sections(const Roots& roots) {
    std::vector<Roots> result;
    Roots waiting;
    for (std::size_t i = 0; i < roots.size(); ++i) {
        if (roots[i].imag() != 0.0) {
            result.push_back({roots[i], roots[i + 1]});
            ++i;
            continue;
        }
        waiting.push_back(roots[i]);
        if (waiting.size() == 2) {
            result.push_back(std::move(waiting));
            waiting.clear();
        }
    }
    if (!waiting.empty()) {
        result.push_back(std::move(waiting));
    }
    return result;
}

} // namespace

ZeroPoleGain::ZeroPoleGain(Roots zeros, Roots poles, double gain, TimeBase timeBase)
    : m_zeros(std::move(zeros)), m_poles(std::move(poles)), m_gain(gain), m_timeBase(timeBase) {}

Result<ZeroPoleGain> ZeroPoleGain::make(Roots zeros, Roots poles, double gain, TimeBase timeBase) {
    if (!isFinite(zeros) || !isFinite(poles) || !std::isfinite(gain)) {
        return failure(ErrorCode::NotFinite, "a zero, a pole or the gain of a system is not a finite number");
    }
    if (zeros.size() > poles.size()) {
        return failure(ErrorCode::InvalidInput, "the transfer function has more zeros than poles",
                       "add the filter or actuator of the real system");
    }
    if (!pairUp(zeros) || !pairUp(poles)) {
        return failure(ErrorCode::InvalidInput, "a complex zero or pole lacks its conjugate partner");
    }
    return ZeroPoleGain(std::move(zeros), std::move(poles), gain, timeBase);
}

std::complex<double> ZeroPoleGain::at(std::complex<double> point) const {
    // Factor by factor, so that a long product neither overflows nor vanishes on the way.
    Complex value = m_gain;
    for (std::size_t i = 0; i < m_poles.size(); ++i) {
        value = (i < m_zeros.size() ? value * (point - m_zeros[i]) : value) / (point - m_poles[i]);
    }
    return value;
}

std::complex<double> ZeroPoleGain::atFrequency(double frequency_rad_s) const {
    return m_timeBase.isContinuous() ? at({0.0, frequency_rad_s})
                                     : at(std::polar(1.0, frequency_rad_s * m_timeBase.period_s()));
}

double ZeroPoleGain::dcGain() const {
    const Complex point = m_timeBase.isContinuous() ? 0.0 : 1.0;
    const bool integrates = std::find(m_poles.begin(), m_poles.end(), point) != m_poles.end();
    return integrates ? std::numeric_limits<double>::infinity() : at(point).real();
}

ZeroPoleGain toZeroPoleGain(const TransferFunction& system) {
    const auto result =
        ZeroPoleGain::make(zeros(system), poles(system),
                           system.numerator().front() / system.denominator().front(), system.timeBase());
    HB_ASSERT(result.has_value());
    return *result;
}

Result<ZeroPoleGain> toZeroPoleGain(const StateSpace& system, Eigen::Index output, Eigen::Index input) {
    if (output < 0 || output >= system.outputs() || input < 0 || input >= system.inputs()) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("there is no path from input {} to output {}", input, output));
    }
    const PathZeros path = pathZeros(system, output, input);
    return ZeroPoleGain::make(path.zeros, poles(system), path.gain, system.timeBase);
}

Result<TransferFunction> toTransferFunction(const ZeroPoleGain& system) {
    return TransferFunction::make(scale(fromRoots(system.zeros()), system.gain()), fromRoots(system.poles()),
                                  system.timeBase());
}

StateSpace toStateSpace(const ZeroPoleGain& system) {
    // There are at least as many sections of poles as of zeros, and a single zero always finds the last
    // place.
    const std::vector<Roots> poles = sections(system.poles());
    std::vector<Roots> zeros = sections(system.zeros());
    zeros.resize(poles.size());
    if (!zeros.empty()) {
        const auto single =
            std::find_if(zeros.begin(), zeros.end(), [](const Roots& z) { return z.size() == 1; });
        std::swap(single == zeros.end() ? zeros.back() : *single, zeros.back());
    }
    StateSpace chain = toStateSpace(TransferFunction::gain(system.gain(), system.timeBase()));
    for (std::size_t i = 0; i < poles.size(); ++i) {
        const auto section =
            TransferFunction::make(fromRoots(zeros[i]), fromRoots(poles[i]), system.timeBase());
        HB_ASSERT(section.has_value());
        chain = *series(chain, toStateSpace(*section));
    }
    return prescaled(chain);
}

Result<ZeroPoleGain> series(const ZeroPoleGain& first, const ZeroPoleGain& second) {
    const auto base = commonTimeBase(first.timeBase(), second.timeBase());
    if (!base) {
        return failure(base.error());
    }
    return ZeroPoleGain::make(joined(first.zeros(), second.zeros()), joined(first.poles(), second.poles()),
                              first.gain() * second.gain(), *base);
}

Result<ZeroPoleGain> parallel(const ZeroPoleGain& first, const ZeroPoleGain& second) {
    const auto base = commonTimeBase(first.timeBase(), second.timeBase());
    if (!base) {
        return failure(base.error());
    }
    const Polynomial sum = add(scale(fromRoots(joined(first.zeros(), second.poles())), first.gain()),
                               scale(fromRoots(joined(second.zeros(), first.poles())), second.gain()));
    return ZeroPoleGain::make(roots(sum), joined(first.poles(), second.poles()), sum.front(), *base);
}

Result<ZeroPoleGain> feedback(const ZeroPoleGain& forward, const ZeroPoleGain& back) {
    const auto base = commonTimeBase(forward.timeBase(), back.timeBase());
    if (!base) {
        return failure(base.error());
    }
    const Roots openPoles = joined(forward.poles(), back.poles());
    const Polynomial closed =
        add(fromRoots(openPoles),
            scale(fromRoots(joined(forward.zeros(), back.zeros())), forward.gain() * back.gain()));
    if (closed == Polynomial{0.0} || degree(closed) < static_cast<int>(openPoles.size())) {
        return failure(ErrorCode::InvalidInput, "the feedback closes an algebraic loop with 1 + L = 0",
                       "an algebraic loop: one of the two systems needs a delay");
    }
    return ZeroPoleGain::make(joined(forward.zeros(), back.poles()), roots(closed),
                              forward.gain() / closed.front(), *base);
}

ZeroPoleGain minimalRealization(const ZeroPoleGain& system, double tolerance_ratio) {
    Roots poles = system.poles();
    Roots zeros;
    for (const Complex& zero : system.zeros()) {
        const double size = system.timeBase().isSampled() ? 1.0 : std::abs(zero);
        const auto pole = std::find_if(poles.begin(), poles.end(), [&](Complex p) {
            return std::abs(p - zero) <= tolerance_ratio * size && (p.imag() == 0.0) == (zero.imag() == 0.0);
        });
        if (pole == poles.end()) {
            zeros.push_back(zero);
        } else {
            poles.erase(pole);
        }
    }
    const auto result =
        ZeroPoleGain::make(std::move(zeros), std::move(poles), system.gain(), system.timeBase());
    HB_ASSERT(result.has_value()); // partners leave together: they lie equally far apart
    return *result;
}

Result<FrequencyResponse> frequencyResponse(const ZeroPoleGain& system,
                                            const std::vector<double>& frequency_rad_s) {
    return frequencyResponse([&system](double w) { return system.atFrequency(w); }, system.timeBase(),
                             frequency_rad_s);
}

} // namespace halbench::control
