#include "control/lti/matched_roots.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {

namespace {

using Complex = std::complex<double>;
using Roots = ZeroPoleGain::Roots;

/// prod (rest - root) over the roots that do not lie at rest themselves.
Complex productAtRest(const Roots& roots, Complex rest) {
    Complex product = 1.0;
    for (const Complex& root : roots) {
        product *= root == rest ? Complex(1.0) : rest - root;
    }
    return product;
}

int countAt(const Roots& roots, Complex place) {
    return static_cast<int>(std::count(roots.begin(), roots.end(), place));
}

/// Gain at rest without the roots at rest.
double gainAtRest(const Roots& zeros, const Roots& poles, Complex rest) {
    return (productAtRest(zeros, rest) / productAtRest(poles, rest)).real();
}

Roots imagesOf(const Roots& roots, double period_s) {
    Roots images;
    for (const Complex& root : roots) {
        images.push_back(root == 0.0 ? Complex(1.0) : std::exp(root * period_s));
    }
    return images;
}

} // namespace

Result<ZeroPoleGain> matchedSampled(const ZeroPoleGain& system, double period_s) {
    const Roots poles = imagesOf(system.poles(), period_s);
    Roots zeros = imagesOf(system.zeros(), period_s);
    while (zeros.size() + 1 < poles.size()) {
        zeros.emplace_back(-1.0, 0.0);
    }
    const int order = countAt(system.poles(), 0.0) - countAt(system.zeros(), 0.0);
    const double gain = system.gain() * gainAtRest(system.zeros(), system.poles(), 0.0) *
                        std::pow(period_s, order) / gainAtRest(zeros, poles, 1.0);
    return ZeroPoleGain::make(std::move(zeros), poles, gain, TimeBase::sampled(period_s));
}

Result<ZeroPoleGain> matchedContinuous(const ZeroPoleGain& system) {
    const double period_s = system.timeBase().period_s();
    Roots zeros;
    Roots poles;
    for (const bool isPole : {false, true}) {
        for (const Complex& root : isPole ? system.poles() : system.zeros()) {
            const bool isNegative = root.imag() == 0.0 && root.real() < 0.0;
            constexpr double AtInfinity = 1e-2; // of several zeros at -1 a matrix keeps few digits each
            if (!isPole && std::abs(root + 1.0) < AtInfinity) {
                continue;
            }
            if (root == 0.0 || isNegative) {
                return failure(ErrorCode::Refused,
                               "this sampled system does not correspond to a continuous one");
            }
            (isPole ? poles : zeros).push_back(root == 1.0 ? Complex(0.0) : std::log(root) / period_s);
        }
    }
    const int order = countAt(poles, 0.0) - countAt(zeros, 0.0);
    const double gain = system.gain() * gainAtRest(system.zeros(), system.poles(), 1.0) /
                        std::pow(period_s, order) / gainAtRest(zeros, poles, 0.0);
    return ZeroPoleGain::make(std::move(zeros), std::move(poles), gain, TimeBase::continuous());
}

} // namespace halbench::control
