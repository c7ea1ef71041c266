#include "models/fields/ring_harmonics.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <cmath>

namespace halbench::models {

double RingHarmonics::magnitude_T(int order) const {
    return std::abs(amplitude_T.at(static_cast<std::size_t>(order - 1)));
}

std::vector<double> radialFieldPerTurn_T(const HalbachRing& ring, double radius_m, double height_m,
                                         int samples) {
    // Turning the rotor by theta under a sensor at 0 is the same as going to -theta on the rotor at rest.
    const std::vector<CuboidMagnet> magnets = ringMagnets(ring, 0.0);
    std::vector<double> radial_T(static_cast<std::size_t>(samples));
    for (std::size_t i = 0; i < radial_T.size(); ++i) {
        const double place_rad = -2.0 * Pi * static_cast<double>(i) / samples;
        const Eigen::Vector3d outward(std::cos(place_rad), std::sin(place_rad), 0.0);
        const Eigen::Vector3d point_m = radius_m * outward + Eigen::Vector3d(0.0, 0.0, height_m);
        radial_T[i] = outward.dot(magnetsField_T(magnets, point_m));
    }
    return radial_T;
}

RingHarmonics harmonicsOf(const std::vector<double>& perTurn_T, int orders) {
    const std::size_t count = perTurn_T.size();
    HB_ASSERT(orders > 0 && 2 * static_cast<std::size_t>(orders) < count);
    RingHarmonics harmonics;
    harmonics.amplitude_T.resize(static_cast<std::size_t>(orders));
    for (const double value_T : perTurn_T) {
        harmonics.mean_T += value_T / static_cast<double>(count);
    }
    for (std::size_t order = 1; order <= harmonics.amplitude_T.size(); ++order) {
        std::complex<double> sum = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            // The product is reduced modulo the turn first: exact angles for high orders.
            sum += std::polar(perTurn_T[i],
                              2.0 * Pi * static_cast<double>(order * i % count) / static_cast<double>(count));
        }
        harmonics.amplitude_T[order - 1] = 2.0 * sum / static_cast<double>(count);
    }
    return harmonics;
}

std::vector<double> arctangentErrors_rad(const std::vector<double>& perTurn_T) {
    const std::size_t count = perTurn_T.size();
    HB_ASSERT(count > 0 && count % 4 == 0);
    std::vector<double> error_rad(count);
    double mean_rad = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        // Sensor b sits a quarter turn ahead: it sees now what sensor a saw a quarter turn before.
        const double fieldB_T = perTurn_T[(i + count - count / 4) % count];
        const double psi_rad = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(count);
        error_rad[i] = std::remainder(std::atan2(fieldB_T, perTurn_T[i]) - psi_rad, 2.0 * Pi);
        mean_rad += error_rad[i] / static_cast<double>(count);
    }
    for (double& value_rad : error_rad) {
        value_rad -= mean_rad;
    }
    return error_rad;
}

} // namespace halbench::models
