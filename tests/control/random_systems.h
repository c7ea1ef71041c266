#pragma once

#include "control/base/random.h"
#include "control/lti/transfer_function.h"

#include <cmath>
#include <vector>

namespace halbench::control {

/// Poles or zeros with rates of 0.3 to 30 1/s, half of them oscillating with a damping of 0.05 to 1.
inline std::vector<std::complex<double>> randomRoots(Random& random, int count, bool isStable) {
    std::vector<std::complex<double>> roots;
    while (static_cast<int>(roots.size()) < count) {
        const double rate_1_s = 0.3 * std::pow(100.0, random.uniform());
        const double sign = isStable || random.below(3) > 0 ? -1.0 : 1.0;
        if (count - static_cast<int>(roots.size()) >= 2 && random.below(2) == 0) {
            const double zeta = 0.05 + 0.95 * random.uniform();
            const std::complex<double> root(sign * zeta * rate_1_s, rate_1_s * std::sqrt(1.0 - zeta * zeta));
            roots.push_back(root);
            roots.push_back(std::conj(root));
        } else {
            roots.emplace_back(sign * rate_1_s, 0.0);
        }
    }
    return roots;
}

/// A continuous system of the given order with fewer zeros than poles (or as many) and a gain around one.
inline TransferFunction randomSystem(Random& random, int order, bool isStable = true, bool isProper = false) {
    const auto poles = fromRoots(randomRoots(random, order, isStable));
    const int zeros = isProper ? order : static_cast<int>(random.below(static_cast<std::uint64_t>(order)));
    const auto numerator = fromRoots(randomRoots(random, zeros, false));
    const double gain = std::exp(random.gaussian()) * std::abs(poles.back() / numerator.back());
    return *TransferFunction::make(scale(numerator, gain), poles, TimeBase::continuous());
}

} // namespace halbench::control
