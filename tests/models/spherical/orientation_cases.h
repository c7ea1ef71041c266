#pragma once

#include "control/base/random.h"
#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "models/spherical/sensor_placement.h"

#include <Eigen/Geometry>

namespace halbench::models {

constexpr double Q = 0.0991864782; ///< of the published rotor at 50 mm

inline OrientationAngles angles_deg(double alpha, double beta, double gamma) {
    return {degreesToRadians(alpha), degreesToRadians(beta), degreesToRadians(gamma)};
}

/// Uniform in the published workspace: |alpha|, |beta| < 45 degrees, |gamma| < 90 degrees.
inline OrientationAngles drawn(Random& random) {
    const double alpha = 90.0 * random.uniform() - 45.0;
    const double beta = 90.0 * random.uniform() - 45.0;
    return angles_deg(alpha, beta, 180.0 * random.uniform() - 90.0);
}

/// Uniform over all rotations.
inline Eigen::Matrix3d anyRotation(Random& random) {
    Eigen::Vector4d q;
    for (double& entry : q) {
        entry = random.gaussian();
    }
    return Eigen::Quaterniond(q.normalized()).toRotationMatrix();
}

inline SphericalReadings noise_T(Random& random, double deviation_T) {
    SphericalReadings noise;
    for (double& entry : noise) {
        entry = deviation_T * random.gaussian();
    }
    return noise;
}

/// rms of values added one by one.
class RootMeanSquare {
public:
    void add(double value) {
        m_sum += value * value;
        ++m_count;
    }
    double value() const { return std::sqrt(m_sum / m_count); }

private:
    double m_sum = 0.0;
    int m_count = 0;
};

} // namespace halbench::models
