#pragma once

#include "models/spherical/additive_model.h"

namespace halbench::models {

/// Readings that are harmonic in the spin: B = cosine cos 2 gamma + sine sin 2 gamma, at fixed alpha and
/// beta.
struct SpinReadings {
    SphericalReadings cosine_T;
    SphericalReadings sine_T;

    SphericalReadings at(double cos2Gamma, double sin2Gamma) const {
        return cosine_T * cos2Gamma + sine_T * sin2Gamma;
    }
};

/// Readings of a device for maps over many poses: the physical tensor field without further harmonics, or the
/// additive model. Both are harmonic in the spin with period 180 degrees.
class CoverageModel {
public:
    CoverageModel(const RotorFieldConfig& field, const SensorPoses& poses);
    explicit CoverageModel(const AdditiveModel& model);

    bool isAdditive() const { return m_isAdditive; }
    SpinReadings spinReadings(double alpha_rad, double beta_rad) const;
    SphericalReadings readings_T(const OrientationAngles& angles) const;
    /// Derivatives by the rotation vector in stator axes, T/rad; for the additive model by way of the angles.
    OrientationJacobian jacobian(const OrientationAngles& angles) const;
    /// Bound of each channel's change, T per radian of |d alpha| + |d beta| + |d gamma|: 6 q for a radial
    /// reading, 4 q for a tangential one, scaled by (r_ref/r)^4.
    const SphericalReadings& slopeBound() const { return m_slopeBound; }

private:
    bool m_isAdditive;
    AdditiveModel m_additive;
    RotorField m_field;
    SensorPoses m_poses;
    SphericalReadings m_slopeBound;
};

/// A third of the nine readings: 0 R, 1 Theta, 2 Phi.
constexpr int ComponentCount = 3;

/// Largest magnitude of a component among the three sensors.
inline double largestOfComponent_T(const SphericalReadings& readings_T, int component) {
    return std::fmax(std::fabs(readings_T[component]),
                     std::fmax(std::fabs(readings_T[component + 3]), std::fabs(readings_T[component + 6])));
}

} // namespace halbench::models
