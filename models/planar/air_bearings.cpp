#include "models/planar/air_bearings.h"

#include <Eigen/LU>

namespace halbench::models {
namespace {

constexpr double Gravity_m_s2 = 9.81;

// Force and moments about the origin of a vertical unit force: (1, y, -x).
Eigen::Vector3d balance(const Eigen::Vector2d& place_m) {
    return {1.0, place_m.y(), -place_m.x()};
}

} // namespace

AirBearings::AirBearings(const PlanarGeometry& geometry, double stiffness_N_per_m, double mass_kg,
                         const Eigen::Vector2d& massCentre_m)
    : m_stiffness_N_per_m(stiffness_N_per_m), m_weight_N(Gravity_m_s2 * mass_kg) {
    const auto coils = geometry.coils();
    Eigen::Matrix3d bearings;
    for (int i = 0; i < 3; ++i) {
        const auto set = static_cast<std::size_t>(i);
        m_place_m[set] = 0.5 * (coils[2 * set].centre_m + coils[2 * set + 1].centre_m);
        bearings.col(i) = balance(m_place_m[set]);
    }
    const Eigen::Matrix3d loads = bearings.inverse();
    m_restLoad_N = m_weight_N * (loads * balance(massCentre_m));
    for (int k = 0; k < CoilCount; ++k) {
        m_share.col(k) = loads * balance(coils[static_cast<std::size_t>(k)].centre_m);
    }
    // z = lift + tiltX y - tiltY x at each bearing: the transposed balance.
    m_plane = bearings.transpose().inverse();
}

BearingState AirBearings::under(const Eigen::Matrix<double, CoilCount, 1>& lift_N) const {
    const Eigen::Vector3d relief_N = m_share * lift_N;
    const Eigen::Vector3d plane = m_plane * relief_N / m_stiffness_N_per_m;
    BearingState state;
    for (int i = 0; i < 3; ++i) {
        const auto bearing = static_cast<std::size_t>(i);
        state.load_N[bearing] = m_restLoad_N(i) - relief_N(i);
        state.gapChange_m[bearing] = relief_N(i) / m_stiffness_N_per_m;
        state.isCarried = state.isCarried && state.load_N[bearing] > 0.0;
    }
    state.liftForce_N = lift_N.sum();
    state.lift_m = plane(0);
    state.tiltX_rad = plane(1);
    state.tiltY_rad = plane(2);
    return state;
}

} // namespace halbench::models
