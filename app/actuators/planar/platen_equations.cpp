#include "app/actuators/planar/platen_equations.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>
#include <cmath>

namespace halbench::app {
namespace {

using namespace platen;
using models::CoilCount;

constexpr int SmallestCount = 30;
constexpr int Passes = 6;

struct Equations {
    Eigen::Vector3d residual;
    Eigen::Matrix<double, 3, Count> jacobian = Eigen::Matrix<double, 3, Count>::Zero();
};

// Of acceleration, speed and place in the three equations.
struct MotionFactors {
    Eigen::Matrix3d acceleration, speed, place;
};

MotionFactors motionFactors(const PlatenVector& p) {
    const double cx = p(CentreX), cy = p(CentreY);
    MotionFactors f;
    f.acceleration << 1.0, 0.0, -cy, 0.0, 1.0, cx, 0.0, 0.0, p(Inertia);
    f.speed << p(DampingX), 0.0, p(DampingXphi) - cy * p(DampingX), 0.0, p(DampingY),
        p(DampingYphi) + cx * p(DampingY), p(DampingMomentX), p(DampingMomentY), p(DampingPhi);
    f.place << p(StiffnessX), 0.0, p(StiffnessXphi), 0.0, p(StiffnessY), p(StiffnessYphi), p(MomentX),
        p(MomentY), p(StiffnessPhi);
    return f;
}

Equations equationsOf(const Moments& m, const PlatenVector& p) {
    Equations e;
    const auto gains = p.segment<CoilCount>(Gain1);
    const Eigen::Matrix<double, 3, CoilCount> late = m.force - p(Delay) * m.forceRate;
    const Eigen::Vector3d wrench = late * gains;
    const Eigen::Vector3d rate = m.forceRate * gains;
    const double cx = p(CentreX), cy = p(CentreY);
    const Eigen::Vector3d &a = m.acceleration, &v = m.speed, &q = m.place;

    const MotionFactors factors = motionFactors(p);
    e.residual = factors.acceleration * a + factors.speed * v + factors.place * q - wrench;
    e.residual += Eigen::Vector3d(p(FrictionX), p(FrictionY), p(FrictionPhi)).cwiseProduct(m.sign);
    e.residual += m.one * Eigen::Vector3d(p(OffsetX), p(OffsetY), p(OffsetPhi));
    e.residual.z() += cx * wrench.y() - cy * wrench.x();

    auto& j = e.jacobian;
    j.block<2, CoilCount>(0, Gain1) = -late.topRows<2>();
    j.block<1, CoilCount>(2, Gain1) = -(late.row(2) - cx * late.row(1) + cy * late.row(0));
    j(0, DampingX) = v.x() - cy * v.z();
    j(0, DampingXphi) = j(1, DampingYphi) = v.z();
    j(2, DampingMomentX) = v.x();
    j(2, DampingMomentY) = v.y();
    j(0, StiffnessX) = q.x();
    j(0, StiffnessXphi) = j(1, StiffnessYphi) = q.z();
    j(0, FrictionX) = m.sign.x();
    j(0, OffsetX) = j(1, OffsetY) = j(2, OffsetPhi) = m.one;
    j(1, DampingY) = v.y() + cx * v.z();
    j(1, StiffnessY) = q.y();
    j(1, FrictionY) = m.sign.y();
    j(2, Inertia) = a.z();
    j(2, DampingPhi) = v.z();
    j(2, StiffnessPhi) = q.z();
    j(2, MomentX) = q.x();
    j(2, MomentY) = q.y();
    j(2, FrictionPhi) = m.sign.z();
    j.block<2, 1>(0, Delay) = rate.head<2>();
    j(2, Delay) = rate.z() - cx * rate.y() + cy * rate.x();
    j(1, CentreX) = a.z() + p(DampingY) * v.z();
    j(2, CentreX) = wrench.y();
    j(0, CentreY) = -a.z() - p(DampingX) * v.z();
    j(2, CentreY) = -wrench.x();
    return e;
}

constexpr int Frequencies = WindowHarmonics + 1;
using Whitening = std::array<Eigen::Matrix3d, Frequencies>;

// From the scatter of the three residuals at each frequency.
Whitening whitening(const std::vector<Window>& windows, const PlatenVector& p) {
    std::array<Eigen::Matrix3d, Frequencies> scatter;
    std::array<double, Frequencies> count{};
    scatter.fill(Eigen::Matrix3d::Zero());
    for (const Window& window : windows) {
        for (int f = 0; f < WindowFunctions; ++f) {
            const auto l = static_cast<std::size_t>(harmonicOf(f));
            const Eigen::Vector3d r = equationsOf(window.moments[static_cast<std::size_t>(f)], p).residual;
            scatter[l] += r * r.transpose();
            count[l] += 1.0;
        }
    }
    Whitening result;
    for (std::size_t l = 0; l < Frequencies; ++l) {
        Eigen::Matrix3d mean = scatter[l] / count[l];
        // A simulation without noise has none to weigh by.
        for (int i = 0; i < 3; ++i) {
            mean(i, i) += i < 2 ? 1e-16 : 1e-24;
        }
        result[l] = mean.llt().matrixL().solve(Eigen::Matrix3d::Identity());
    }
    return result;
}

// First weights: noise of the readings, that grows with the frequency, and slow forces, in orders.
Whitening firstWhitening() {
    Whitening result;
    for (int l = 0; l < Frequencies; ++l) {
        const double weight = 1e4 / (1.0 + l * l);
        result[static_cast<std::size_t>(l)] = Eigen::Vector3d(weight, weight, 50.0 * weight).asDiagonal();
    }
    return result;
}

using Stack = Eigen::Matrix<double, 3 * WindowFunctions, Count>;
using Residuals = Eigen::Matrix<double, 3 * WindowFunctions, 1>;

void stack(const Window& window, const PlatenVector& p, const Whitening& white, Stack& jacobian,
           Residuals& residual) {
    for (int f = 0; f < WindowFunctions; ++f) {
        const Equations e = equationsOf(window.moments[static_cast<std::size_t>(f)], p);
        const Eigen::Matrix3d& w = white[static_cast<std::size_t>(harmonicOf(f))];
        jacobian.middleRows<3>(3 * f) = w * e.jacobian;
        residual.segment<3>(3 * f) = w * e.residual;
    }
}

// Information with unit diagonal, its scale and the gradient.
struct Normal {
    PlatenMatrix information = PlatenMatrix::Zero();
    PlatenVector gradient = PlatenVector::Zero();

    Result<PlatenMatrix> inverse() const {
        const PlatenVector scale = information.diagonal().cwiseSqrt().cwiseInverse();
        if (!scale.allFinite()) {
            return failure(ErrorCode::Refused, "the motion does not excite every axis",
                           "Give it more room, or check that the currents flow.");
        }
        const Eigen::LDLT<PlatenMatrix> solver(
            (scale.asDiagonal() * information * scale.asDiagonal()).eval());
        if (solver.vectorD().minCoeff() < 1e-10) {
            return failure(ErrorCode::Refused, "the motion does not tell the constants apart",
                           "Give it more room, or check that the currents flow.");
        }
        return PlatenMatrix(scale.asDiagonal() * solver.solve(PlatenMatrix::Identity()) * scale.asDiagonal());
    }
};

Normal normalOf(const std::vector<Window>& windows, const PlatenVector& p, const Whitening& white) {
    Normal normal;
    Stack jacobian;
    Residuals residual;
    for (const Window& window : windows) {
        stack(window, p, white, jacobian, residual);
        normal.information += jacobian.transpose() * jacobian;
        normal.gradient -= jacobian.transpose() * residual;
    }
    return normal;
}

// CR3: what each window would change when it was left out.
PlatenMatrix jackknife(const std::vector<Window>& windows, const PlatenVector& p, const Whitening& white,
                       const PlatenMatrix& inverse) {
    PlatenMatrix meat = PlatenMatrix::Zero();
    Stack jacobian;
    Residuals residual;
    using Square = Eigen::Matrix<double, 3 * WindowFunctions, 3 * WindowFunctions>;
    for (const Window& window : windows) {
        stack(window, p, white, jacobian, residual);
        const Square rest = Square::Identity() - jacobian * inverse * jacobian.transpose();
        const PlatenVector score = jacobian.transpose() * rest.partialPivLu().solve(residual);
        meat += score * score.transpose();
    }
    const double count = static_cast<double>(windows.size());
    return (count - 1.0) / count * inverse * meat * inverse;
}

// Errors of the calibration move all windows together, which their scatter does not show.
PlatenMatrix commonCovariance(const std::vector<Window>& windows, const PlatenVector& p,
                              const Whitening& white, const PlatenMatrix& inverse,
                              const Eigen::MatrixXd& calibration) {
    if (windows.front().errors.empty()) {
        return PlatenMatrix::Zero();
    }
    const MotionFactors factors = motionFactors(p);
    Eigen::Matrix<double, Count, ChipUnknowns> score = Eigen::Matrix<double, Count, ChipUnknowns>::Zero();
    for (const Window& window : windows) {
        for (int f = 0; f < WindowFunctions; ++f) {
            const ErrorMoments& m = window.errors[static_cast<std::size_t>(f)];
            const Eigen::Matrix3d& w = white[static_cast<std::size_t>(harmonicOf(f))];
            const PoseSensitivity residual =
                factors.acceleration * m.acceleration + factors.speed * m.speed + factors.place * m.place;
            const auto jacobian = equationsOf(window.moments[static_cast<std::size_t>(f)], p).jacobian;
            score += (w * jacobian).transpose() * (w * residual);
        }
    }
    const Eigen::Matrix<double, Count, ChipUnknowns> change = inverse * score;
    return change * calibration * change.transpose();
}

} // namespace

Result<PlatenFit> fitPlaten(const PlatenMotion& motion, const std::vector<models::PlanarPose>& poses,
                            const models::PlanarGeometry& geometry, const PoseErrors& errors) {
    const MotionWindows integrated = integrateWindows(motion, poses, geometry, errors);
    const std::vector<Window>& windows = integrated.windows;
    PlatenFit fit;
    fit.windows = static_cast<int>(windows.size());
    fit.leftOut = integrated.leftOut;
    if (fit.windows < SmallestCount) {
        const Error tooFew{ErrorCode::Refused,
                           fmt::format("{} whole windows of motion are too few, {} had missing rows",
                                       fit.windows, fit.leftOut),
                           "measure again"};
        return failure(fit.leftOut > 0 ? withCause(tooFew, motion.loss) : tooFew);
    }
    PlatenVector& p = fit.value;
    p.segment<CoilCount>(Gain1).setConstant(1.5);
    p(Inertia) = 2e-3;
    Whitening white = firstWhitening();
    for (int pass = 0; pass < Passes; ++pass) {
        const Normal normal = normalOf(windows, p, white);
        const auto inverse = normal.inverse();
        if (!inverse) {
            return failure(inverse.error());
        }
        p += *inverse * normal.gradient;
        if (!p.allFinite()) {
            return failure(ErrorCode::NotFinite, "the equations of motion have no solution",
                           "Check that the signals are those of a platen.");
        }
        white = whitening(windows, p);
    }
    const auto inverse = normalOf(windows, p, white).inverse();
    if (!inverse) {
        return failure(inverse.error());
    }
    fit.covariance = jackknife(windows, p, white, *inverse) +
                     commonCovariance(windows, p, white, *inverse, errors.covariance);
    fit.freedom = static_cast<double>(fit.windows) - 1.0;
    for (const Window& window : windows) {
        fit.residualRms += equationsOf(window.moments[0], p).residual.cwiseAbs2();
    }
    const double mean = windows.front().moments[0].one; // of the window itself
    fit.residualRms = (fit.residualRms / static_cast<double>(fit.windows)).cwiseSqrt() / mean;
    return fit;
}

} // namespace halbench::app
