#include "models/planar/windings_wrench.h"

#include "control/base/assert.h"
#include "control/base/units.h"
#include "models/planar/winding_shape.h"

#include <Eigen/LU>
#include <cmath>
#include <complex>

namespace halbench::models {
namespace {

// cos(n t) and sin(n t) for the orders 1, 5, 9 from one pair of functions.
struct Waves {
    std::array<std::complex<double>, MatrixOrderCount> order;

    explicit Waves(double angle_rad) {
        const std::complex<double> first(std::cos(angle_rad), std::sin(angle_rad));
        const std::complex<double> second = first * first;
        const std::complex<double> fourth = second * second;
        order = {first, first * fourth, first * fourth * fourth};
    }
};

} // namespace

double windingsForceConstant_N_per_A(const PlanarGeometry& geometry, int order) {
    const double g = order * waveNumber_per_m(geometry.matrix);
    return -geometry.winding.layersPerHeight_1_m * coilHeightIntegral_Tm(geometry, order) * g *
           windingShape_m2(geometry, 0.0, g).real();
}

WindingsWrench::WindingsWrench(const PlanarGeometry& geometry, int orders)
    : m_geometry(geometry), m_orders(static_cast<std::size_t>(orders)), m_coils(geometry.coils()) {
    HB_ASSERT(orders >= 1 && orders <= MatrixOrderCount);
    for (std::size_t i = 0; i < m_orders; ++i) {
        m_scale_T[i] =
            geometry.winding.layersPerHeight_1_m * coilHeightIntegral_Tm(geometry, MatrixOrders[i]);
    }
    fitTable();
}

void WindingsWrench::fitTable() {
    // Chebyshev's nodes in t = (phi/limit)^2 keep the error of the interpolation even over the range.
    Eigen::Matrix<double, Terms, Terms> powers;
    std::array<double, Terms> angle_rad{};
    for (int i = 0; i < Terms; ++i) {
        const double t = 0.5 * (1.0 - std::cos(Pi * (i + 0.5) / Terms));
        angle_rad[static_cast<std::size_t>(i)] = TableLimit_rad * std::sqrt(t);
        for (int j = 0; j < Terms; ++j) {
            powers(i, j) = std::pow(t, j);
        }
    }
    const Eigen::PartialPivLU<Eigen::Matrix<double, Terms, Terms>> solver(powers);
    for (std::size_t order = 0; order < m_orders; ++order) {
        Polynomial along;
        Polynomial across;
        for (int i = 0; i < Terms; ++i) {
            const Shape exact = integratedShape(order, angle_rad[static_cast<std::size_t>(i)]);
            along(i) = exact.along;
            across(i) = exact.across;
        }
        m_along[order] = solver.solve(along);
        m_across[order] = solver.solve(across);
    }
}

WindingsWrench::Shape WindingsWrench::integratedShape(std::size_t order, double angle_rad) const {
    // Derivative by a complex step: no cancellation at any step.
    constexpr double Step = 1e-20;
    const double g = MatrixOrders[order] * waveNumber_per_m(m_geometry.matrix);
    const double c = g * std::cos(angle_rad);
    const double s = g * std::sin(angle_rad);
    const std::complex<double> cosine(c, -Step * s);
    const std::complex<double> sine(s, Step * c);
    const std::complex<double> along = windingShape_m2(m_geometry, cosine, sine);
    const std::complex<double> across = windingShape_m2(m_geometry, sine, cosine);
    return {along.real(), across.real(), along.imag() / Step, across.imag() / Step};
}

WindingsWrench::Shape WindingsWrench::shape(std::size_t order, double angle_rad) const {
    const double ratio = angle_rad / TableLimit_rad;
    const double t = ratio * ratio;
    if (!(t <= 1.0)) {
        return integratedShape(order, angle_rad);
    }
    const auto evaluate = [t](const Polynomial& p, double& value, double& slope) {
        value = p(Terms - 1);
        slope = 0.0;
        for (int i = Terms - 2; i >= 0; --i) {
            slope = slope * t + value;
            value = value * t + p(i);
        }
    };
    Shape result;
    evaluate(m_along[order], result.along, result.alongSlope);
    evaluate(m_across[order], result.across, result.acrossSlope);
    const double chain_1_rad = 2.0 * ratio / TableLimit_rad; // dt/dphi
    result.alongSlope *= chain_1_rad;
    result.acrossSlope *= chain_1_rad;
    return result;
}

CoilWrench WindingsWrench::at(const PlanarPose& pose) const {
    CoilWrench result;
    std::array<Shape, MatrixOrderCount> shapes;
    for (std::size_t i = 0; i < m_orders; ++i) {
        shapes[i] = shape(i, pose.angle_rad);
    }
    const double gamma = waveNumber_per_m(m_geometry.matrix);
    const double c = std::cos(pose.angle_rad);
    const double s = std::sin(pose.angle_rad);
    for (int k = 0; k < CoilCount; ++k) {
        const PlanarCoil& coil = m_coils[static_cast<std::size_t>(k)];
        const double armX_m = c * coil.centre_m.x() - s * coil.centre_m.y();
        const double armY_m = s * coil.centre_m.x() + c * coil.centre_m.y();
        const Waves x(gamma * (pose.x_m + armX_m));
        const Waves y(gamma * (pose.y_m + armY_m));
        double forceX = 0.0;
        double forceY = 0.0;
        double turning = 0.0;
        double lift = 0.0;
        for (std::size_t i = 0; i < m_orders; ++i) {
            const double g = MatrixOrders[i] * gamma;
            const double C = coil.sense * m_scale_T[i];
            const Shape& G = shapes[i];
            const double Gx = coil.isAcross ? G.across : G.along;
            const double Gy = coil.isAcross ? G.along : G.across;
            const double slopeX = coil.isAcross ? G.acrossSlope : G.alongSlope;
            const double slopeY = coil.isAcross ? G.alongSlope : G.acrossSlope;
            forceX -= C * g * Gx * x.order[i].imag();
            forceY -= C * g * Gy * y.order[i].imag();
            turning += C * (slopeX * x.order[i].real() + slopeY * y.order[i].real());
            lift -= C * g * (Gx * x.order[i].real() + Gy * y.order[i].real());
        }
        // dX_k/dphi = -(Y_k - y), dY_k/dphi = X_k - x
        result.wrench.col(k) << forceX, forceY, turning - armY_m * forceX + armX_m * forceY;
        result.lift_N_per_A(k) = lift;
    }
    return result;
}

Eigen::Matrix<double, CoilCount, 1> WindingsWrench::linkage_Wb(const PlanarPose& pose, double lift_m) const {
    Eigen::Matrix<double, CoilCount, 1> result = Eigen::Matrix<double, CoilCount, 1>::Zero();
    const double c = std::cos(pose.angle_rad);
    const double s = std::sin(pose.angle_rad);
    for (std::size_t i = 0; i < m_orders; ++i) {
        const Shape G = shape(i, pose.angle_rad);
        const double g = MatrixOrders[i] * waveNumber_per_m(m_geometry.matrix);
        for (int k = 0; k < CoilCount; ++k) {
            const PlanarCoil& coil = m_coils[static_cast<std::size_t>(k)];
            const double X_m = pose.x_m + c * coil.centre_m.x() - s * coil.centre_m.y();
            const double Y_m = pose.y_m + s * coil.centre_m.x() + c * coil.centre_m.y();
            result(k) += coil.sense * m_scale_T[i] * std::exp(-g * lift_m) *
                         (std::cos(g * X_m) * (coil.isAcross ? G.across : G.along) +
                          std::cos(g * Y_m) * (coil.isAcross ? G.along : G.across));
        }
    }
    return result;
}

} // namespace halbench::models
