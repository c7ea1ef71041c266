#include "control/lti/conjugate_pairs.h"

#include <cstddef>

namespace halbench::control {

using Complex = std::complex<double>;

std::vector<std::complex<double>> inConjugatePairs(const std::vector<std::complex<double>>& points) {
    std::vector<Complex> result;
    std::vector<bool> isTaken(points.size(), false);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (isTaken[i]) {
            continue;
        }
        std::size_t partner = i;
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            if (!isTaken[j] && std::abs(points[j] - std::conj(points[i])) <
                                   std::abs(points[partner] - std::conj(points[i]))) {
                partner = j;
            }
        }
        isTaken[i] = true;
        if (partner == i) {
            result.emplace_back(points[i].real(), 0.0);
            continue;
        }
        isTaken[partner] = true;
        const Complex mean = 0.5 * (points[i] + std::conj(points[partner]));
        result.push_back(mean);
        result.push_back(std::conj(mean));
    }
    return result;
}

} // namespace halbench::control
