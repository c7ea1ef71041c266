#pragma once

#include "models/planar/coil_wrench.h"
#include "models/planar/planar_geometry.h"

#include <array>

namespace halbench::models {

/// Forces of closed windings with rounded corners, from their flux linkage in the lattice:
///   Phi_k = sum_n C_n [cos(n gamma X_k) G_x,n(phi) + cos(n gamma Y_k) G_y,n(phi)]
///   wrench_k = dPhi_k/d(x, y, phi),  Fz = dPhi_k/dz,  back-EMF = dPhi_k/dt, all for one ampere.
/// (X_k, Y_k): the coil's centre. C_n = sense beta (-1)^k b_n(z1) (1 - e^(-n gamma d))/(n gamma). G: integral
/// of the field's shape over all turns; for coils 1 ... 4 G_x = G_along, G_y = G_across, for 5 and 6 swapped.
/// Exactly consistent in energy. Source: resources/help/planar-theory.md section 5.3.
///
/// G is even in phi: a polynomial in phi^2 within +-TableLimit_rad, error below 1e-10 of G_across(0); beyond,
/// each call integrates anew (exact, about 100 us).
class WindingsWrench {
public:
    static constexpr double TableLimit_rad = 0.05;

    /// The first `orders` harmonics of the field, 1 ... 3.
    explicit WindingsWrench(const PlanarGeometry& geometry, int orders = MatrixOrderCount);

    CoilWrench at(const PlanarPose& pose) const;

    /// Flux linkage of each coil, Wb, when everything is lifted by `lift_m`.
    Eigen::Matrix<double, CoilCount, 1> linkage_Wb(const PlanarPose& pose, double lift_m = 0.0) const;

private:
    /// Shape integrals and their slopes of one order at one heading.
    struct Shape {
        double along = 0.0;
        double across = 0.0;
        double alongSlope = 0.0;
        double acrossSlope = 0.0;
    };
    static constexpr int Terms = 5;
    using Polynomial = Eigen::Matrix<double, Terms, 1>; ///< in (phi/TableLimit)^2

    Shape shape(std::size_t order, double angle_rad) const;
    Shape integratedShape(std::size_t order, double angle_rad) const;
    void fitTable();

    PlanarGeometry m_geometry;
    std::size_t m_orders;
    std::array<PlanarCoil, CoilCount> m_coils;
    std::array<double, MatrixOrderCount> m_scale_T{}; ///< C_n without the sense, per square metre of shape
    std::array<Polynomial, MatrixOrderCount> m_along;
    std::array<Polynomial, MatrixOrderCount> m_across;
};

/// Force constant of order n at zero heading: -C_n n gamma G_across(0), N/A.
double windingsForceConstant_N_per_A(const PlanarGeometry& geometry, int order = 1);

} // namespace halbench::models
