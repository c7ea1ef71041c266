#include "models/planar/prism_wrench.h"

#include "control/base/assert.h"

#include <cmath>

namespace halbench::models {
namespace {

using Eigen::Vector2d;

// S(k, l): integral of cos(k t) over -l/2 ... l/2.
double cosineIntegral(double k, double length) {
    const double x = 0.5 * k * length;
    // Below 1e-4 the next term of the series is 1e-18 of the sum.
    return std::fabs(x) < 1e-4 ? length * (1.0 - x * x / 6.0) : length * std::sin(x) / x;
}

// T(k, l): integral of t sin(k t) over -l/2 ... l/2.
double sineMoment(double k, double length) {
    const double x = 0.5 * k * length;
    // (sin x - x cos x)/x^2 cancels for small x; below 0.02 two terms leave 1e-9 of the moment, which is
    // itself below 1e-2 of the product it is added to.
    const double shape = std::fabs(x) < 0.02 ? x * (1.0 / 3.0 - x * x * (1.0 / 30.0 - x * x / 840.0))
                                             : (std::sin(x) - x * std::cos(x)) / (x * x);
    return 0.5 * length * length * shape;
}

struct Prism {
    Vector2d centre; ///< in the coil's axes, as multiples of the pitch
    bool isLong;     ///< a side along u: size p x a, otherwise a x q
    double current;  ///< along +u or +v
};

constexpr double Quarter = 0.25;
constexpr double Half = 0.5;

const std::array<Prism, 4>& prismsOfCoil() {
    static const std::array<Prism, 4> prisms = {{{{0.0, -Quarter}, true, 1.0},
                                                 {{Half, 0.0}, false, 1.0},
                                                 {{0.0, Quarter}, true, -1.0},
                                                 {{-Half, 0.0}, false, -1.0}}};
    return prisms;
}

// Field integrals of one order over one prism: of cos, its first moments, and of sin.
struct FieldIntegral {
    double cosine = 0.0;
    double momentU = 0.0;
    double momentV = 0.0;
    double sine = 0.0;
};

// Of cos(P + A u + B v), with sizes lu x lv.
FieldIntegral fieldIntegral(double P, double A, double B, const Vector2d& size_m) {
    const double su = cosineIntegral(A, size_m.x());
    const double sv = cosineIntegral(B, size_m.y());
    return {std::cos(P) * su * sv, -std::sin(P) * sineMoment(A, size_m.x()) * sv,
            -std::sin(P) * su * sineMoment(B, size_m.y()), std::sin(P) * su * sv};
}

} // namespace

PrismWrench::PrismWrench(const PlanarGeometry& geometry, int orders)
    : m_geometry(geometry), m_coils(geometry.coils()) {
    HB_ASSERT(orders >= 1 && orders <= MatrixOrderCount);
    for (std::size_t i = 0; i < static_cast<std::size_t>(orders); ++i) {
        m_density_N_per_A_m2[i] = geometry.winding.turnsPerWidth_1_m * geometry.winding.layersPerHeight_1_m *
                                  coilHeightIntegral_Tm(geometry, MatrixOrders[i]);
    }
}

CoilWrench PrismWrench::at(const PlanarPose& pose) const {
    CoilWrench result;
    const double pitch_m = m_geometry.matrix.pitch_m;
    const double width_m = m_geometry.winding.width_m;
    const Vector2d longSize_m(m_geometry.longStraight_m(), width_m);
    const Vector2d shortSize_m(width_m, m_geometry.shortStraight_m());
    for (int k = 0; k < CoilCount; ++k) {
        const PlanarCoil& coil = m_coils[static_cast<std::size_t>(k)];
        const double heading_rad = pose.angle_rad + (coil.isAcross ? 0.5 * M_PI : 0.0);
        const double c = std::cos(heading_rad);
        const double s = std::sin(heading_rad);
        // The coil's centre relative to the platen's origin, in the coil's axes.
        const Vector2d arm_m =
            coil.isAcross ? Vector2d(coil.centre_m.y(), -coil.centre_m.x()) : coil.centre_m;
        double forceU = 0.0;
        double forceV = 0.0;
        for (const Prism& prism : prismsOfCoil()) {
            const Vector2d rho_m = arm_m + pitch_m * prism.centre;
            const Vector2d centre_m(pose.x_m + c * rho_m.x() - s * rho_m.y(),
                                    pose.y_m + s * rho_m.x() + c * rho_m.y());
            const Vector2d& size_m = prism.isLong ? longSize_m : shortSize_m;
            const double Ju = prism.isLong ? prism.current : 0.0;
            const double Jv = prism.isLong ? 0.0 : prism.current;
            for (std::size_t i = 0; i < m_density_N_per_A_m2.size(); ++i) {
                const double D = coil.sense * m_density_N_per_A_m2[i];
                const double g = MatrixOrders[i] * waveNumber_per_m(m_geometry.matrix);
                const FieldIntegral x = fieldIntegral(g * centre_m.x(), g * c, -g * s, size_m);
                const FieldIntegral y = fieldIntegral(g * centre_m.y(), g * s, g * c, size_m);
                const double I0 = x.cosine + y.cosine;
                forceU += D * Jv * I0;
                forceV -= D * Ju * I0;
                result.wrench(2, k) -= D * (Ju * (rho_m.x() * I0 + x.momentU + y.momentU) +
                                            Jv * (rho_m.y() * I0 + x.momentV + y.momentV));
                result.lift_N_per_A(k) +=
                    D * (Ju * (-x.sine * s + y.sine * c) - Jv * (x.sine * c + y.sine * s));
            }
        }
        result.wrench(0, k) = c * forceU - s * forceV;
        result.wrench(1, k) = s * forceU + c * forceV;
    }
    return result;
}

} // namespace halbench::models
