#include "models/planar/pose_estimator.h"

#include "control/base/units.h"
#include "models/planar/planar_parameters.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

constexpr double Lever_m = 50e-3; ///< makes a length of an angle
constexpr double LeastInformation_ratio = 0.01;
constexpr int IterationLimit = 12;

// Phase of one axis from sin(g x) cos(g x_j) + cos(g x) sin(g x_j) = value_j; empty without quadrature.
std::optional<double> phaseOf(const Eigen::Vector3d& value, const Eigen::Vector3d& phase_rad,
                              const ChipMask& used) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (int j = 0; j < ChipCount; ++j) {
        if (used[static_cast<std::size_t>(j)]) {
            const Eigen::Vector2d row(std::cos(phase_rad(j)), std::sin(phase_rad(j)));
            normal += row * row.transpose();
            right += value(j) * row;
        }
    }
    if (normal.determinant() < LeastInformation_ratio) {
        return std::nullopt;
    }
    const Eigen::Vector2d solution = normal.inverse() * right;
    return std::atan2(solution(0), solution(1));
}

// Normal equations of the chips in use at a pose, angle scaled to a length.
struct Normal {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double square_T2 = 0.0; ///< sum of squared residuals
};

Normal normalAt(const PoseSensing& sensing, const ChipFields_T& field_T, const PlanarPose& pose,
                const ChipMask& used) {
    Normal normal;
    for (std::size_t j = 0; j < used.size(); ++j) {
        if (!used[j]) {
            continue;
        }
        ChipFieldSlope model =
            chipFieldSlope(sensing.waveNumber_per_m, sensing.amplitude_T[j], sensing.place_m[j], pose);
        model.slope.col(2) /= Lever_m;
        const Eigen::Vector2d residual = field_T.segment<2>(2 * static_cast<Eigen::Index>(j)) - model.field_T;
        normal.matrix += model.slope.transpose() * model.slope;
        normal.right += model.slope.transpose() * residual;
        normal.square_T2 += residual.squaredNorm();
    }
    return normal;
}

double distance_m(const PlanarPose& a, const PlanarPose& b) {
    return Eigen::Vector3d(a.x_m - b.x_m, a.y_m - b.y_m, Lever_m * (a.angle_rad - b.angle_rad)).norm();
}

int countOf(const ChipMask& used) {
    return static_cast<int>(std::count(used.begin(), used.end(), true));
}

// The covariance and whether the readings determine all three coordinates.
void judge(const PoseSensing& sensing, const Normal& normal, PoseEstimate& estimate) {
    const double amplitude_T = *std::max_element(sensing.amplitude_T.begin(), sensing.amplitude_T.end());
    const double slope_T_per_m = sensing.waveNumber_per_m * amplitude_T;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
    eigen.computeDirect(normal.matrix, Eigen::EigenvaluesOnly);
    if (eigen.eigenvalues()(0) < LeastInformation_ratio * slope_T_per_m * slope_T_per_m) {
        estimate.verdict = PoseVerdict::NotDetermined;
        return;
    }
    const Eigen::Vector3d scale(1.0, 1.0, 1.0 / Lever_m);
    estimate.covariance = sensing.deviation_T * sensing.deviation_T *
                          (scale.asDiagonal() * normal.matrix.inverse() * scale.asDiagonal());
    estimate.verdict = PoseVerdict::Determined;
}

} // namespace

double PoseSensing::pitch_m() const {
    return 2.0 * Pi / waveNumber_per_m;
}

PoseSensing nominalSensing(const PlanarParameters& parameters) {
    PoseSensing sensing;
    sensing.waveNumber_per_m = waveNumber_per_m(parameters.geometry.matrix);
    sensing.amplitude_T.fill(parameters.hallField_T);
    sensing.deviation_T = parameters.hallNoise_T;
    for (std::size_t j = 0; j < sensing.place_m.size(); ++j) {
        sensing.place_m[j] = {parameters.chipX_m[j], parameters.chipY_m[j]};
        sensing.sensitivity[j].setIdentity();
        sensing.offset_T[j].setZero();
    }
    return sensing;
}

ChipFields_T correctedFields_T(const PoseSensing& sensing, const ChipFields_T& reading_T,
                               const CoilCurrents_A& current_A) {
    ChipFields_T field_T = reading_T - sensing.crosstalk_T_per_A * current_A;
    for (std::size_t j = 0; j < sensing.sensitivity.size(); ++j) {
        const auto row = 2 * static_cast<Eigen::Index>(j);
        const Eigen::Vector2d away_T = field_T.segment<2>(row) - sensing.offset_T[j];
        field_T.segment<2>(row) = sensing.sensitivity[j].inverse() * away_T;
    }
    return field_T;
}

std::optional<PlanarPose> startPose(const PoseSensing& sensing, const ChipFields_T& field_T,
                                    const ChipMask& used) {
    Eigen::Matrix<double, ChipCount, 2> value;
    Eigen::Matrix<double, ChipCount, 2> phase_rad;
    for (int j = 0; j < ChipCount; ++j) {
        const auto chip = static_cast<std::size_t>(j);
        value.row(j) = field_T.segment<2>(2 * j).transpose() / sensing.amplitude_T[chip];
        phase_rad.row(j) = sensing.waveNumber_per_m * sensing.place_m[chip].transpose();
    }
    const auto x_rad = phaseOf(value.col(0), phase_rad.col(0), used);
    const auto y_rad = phaseOf(value.col(1), phase_rad.col(1), used);
    if (!x_rad || !y_rad) {
        return std::nullopt;
    }
    return PlanarPose{*x_rad / sensing.waveNumber_per_m, *y_rad / sensing.waveNumber_per_m, 0.0};
}

PlanarPose inNearestCell(const PlanarPose& pose, const PlanarPose& near, double pitch_m) {
    return {pose.x_m + pitch_m * std::round((near.x_m - pose.x_m) / pitch_m),
            pose.y_m + pitch_m * std::round((near.y_m - pose.y_m) / pitch_m), pose.angle_rad};
}

PoseEstimate estimatePose(const PoseSensing& sensing, const ChipFields_T& field_T, const PlanarPose& start,
                          const ChipMask& used) {
    // Gauss-Newton: the error after a step is its square times gamma, or a thousandth of it where noise
    // leaves residuals. After one of 10 nm it is far below any noise.
    constexpr double StepLimit_m = 1e-8;
    constexpr double Reach_m = 20e-3;
    PoseEstimate estimate;
    estimate.pose = start;
    estimate.freedom = 2 * countOf(used) - 3;
    if (estimate.freedom < 0) {
        estimate.verdict = PoseVerdict::NotDetermined;
        return estimate;
    }
    for (; estimate.iterations < IterationLimit; ++estimate.iterations) {
        const Normal normal = normalAt(sensing, field_T, estimate.pose, used);
        estimate.chiSquare = normal.square_T2 / (sensing.deviation_T * sensing.deviation_T);
        const Eigen::LDLT<Eigen::Matrix3d> solver(normal.matrix);
        const Eigen::Vector3d step = solver.solve(normal.right);
        if (!step.allFinite() || solver.vectorD().minCoeff() <= 0.0) {
            estimate.verdict = PoseVerdict::NotDetermined;
            return estimate;
        }
        estimate.pose.x_m += step(0);
        estimate.pose.y_m += step(1);
        estimate.pose.angle_rad += step(2) / Lever_m;
        if (step.norm() <= StepLimit_m) {
            judge(sensing, normal, estimate);
            return estimate;
        }
        if (distance_m(estimate.pose, start) > Reach_m) {
            break;
        }
    }
    estimate.verdict = PoseVerdict::NotConverged;
    return estimate;
}

CheckedPose estimateChecked(const PoseSensing& sensing, const ChipFields_T& field_T,
                            const PlanarPose& predicted, const ChipCheck& check, const ChipMask& trusted) {
    const auto isBelieved = [&](const PoseEstimate& estimate) {
        const double limit = estimate.freedom > 1 ? check.limitOfThree : check.limitOfTwo;
        return estimate.verdict == PoseVerdict::Determined && estimate.chiSquare <= limit &&
               distance_m(estimate.pose, predicted) <= check.jump_m;
    };
    CheckedPose result;
    result.used = trusted;
    result.estimate = estimatePose(sensing, field_T, predicted, trusted);
    if (isBelieved(result.estimate)) {
        result.verdict = trusted == AllChips ? ChipVerdict::AllUsed : ChipVerdict::OneLeftOut;
        return result;
    }
    if (trusted != AllChips) {
        return result;
    }
    const PoseEstimate ofAll = result.estimate;
    int candidates = 0;
    for (std::size_t j = 0; j < trusted.size(); ++j) {
        ChipMask used = AllChips;
        used[j] = false;
        const PoseEstimate estimate = estimatePose(sensing, field_T, predicted, used);
        if (isBelieved(estimate)) {
            ++candidates;
            result = {ChipVerdict::OneLeftOut, estimate, used};
        }
    }
    if (candidates > 1) {
        result = {ChipVerdict::Ambiguous, ofAll, AllChips};
    }
    return result;
}

} // namespace halbench::models
