#include "app/actuators/planar/chip_fit.h"

#include "control/base/units.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

using models::ChipCount;
using models::CoilCount;
using models::FieldCount;
using models::PlanarPose;

// The fit's own parameters, linear where they can be: four factors of the unit field, two offsets, two
// places, twelve of crosstalk.
constexpr int Factors = 4, Offsets = 4, Places = 6, Own = 8, Stray = 2 * CoilCount;
constexpr int PerChip = Own + Stray;
constexpr int Unknowns = ChipCount * PerChip;
constexpr double Lever_m = 0.05; // scales angles to lengths
constexpr double GaugeWeight = 1e6;
constexpr int LargestIterations = 12;

using Vector = Eigen::Matrix<double, Unknowns, 1>;
using Matrix = Eigen::Matrix<double, Unknowns, Unknowns>;
using Pose = Eigen::Vector3d; // x, y, angle times the lever, m

Pose scaled(const PlanarPose& pose) {
    return {pose.x_m, pose.y_m, Lever_m * pose.angle_rad};
}

PlanarPose poseOf(const Pose& pose) {
    return {pose.x(), pose.y(), pose.z() / Lever_m};
}

// 1 sigma of what is not known before, see the header.
Vector priors(const Vector& start) {
    Vector sigma;
    for (int j = 0; j < ChipCount; ++j) {
        const double amplitude_T = start(j * PerChip);
        sigma.segment<Factors>(j * PerChip).setConstant(0.05 * amplitude_T);
        sigma.segment<2>(j * PerChip + Offsets).setConstant(2e-3);
        sigma.segment<2>(j * PerChip + Places).setConstant(1e-3);
        sigma.segment<Stray>(j * PerChip + Own).setConstant(1e-3);
    }
    return sigma;
}

Vector unknownsOf(const ChipCalibration& chips) {
    Vector p;
    for (std::size_t j = 0; j < ChipCount; ++j) {
        const auto at = static_cast<int>(j) * PerChip;
        const double b = chips.amplitude_T[j];
        p.segment<Factors>(at) << b * (1.0 + chips.gain[j].x()), b * chips.cross[j].x(),
            b * chips.cross[j].y(), b * (1.0 + chips.gain[j].y());
        p.segment<2>(at + Offsets) = chips.offset_T[j];
        p.segment<2>(at + Places) = chips.place_m[j];
        p.segment<CoilCount>(at + Own) = chips.crosstalk_T_per_A.row(2 * static_cast<int>(j)).transpose();
        p.segment<CoilCount>(at + Own + CoilCount) =
            chips.crosstalk_T_per_A.row(2 * static_cast<int>(j) + 1).transpose();
    }
    return p;
}

ChipCalibration calibrationOf(const Vector& p) {
    ChipCalibration chips;
    for (std::size_t j = 0; j < ChipCount; ++j) {
        const auto at = static_cast<int>(j) * PerChip;
        const double b = 0.5 * (p(at) + p(at + 3));
        chips.amplitude_T[j] = b;
        chips.gain[j] = {p(at) / b - 1.0, p(at + 3) / b - 1.0};
        chips.cross[j] = {p(at + 1) / b, p(at + 2) / b};
        chips.offset_T[j] = p.segment<2>(at + Offsets);
        chips.place_m[j] = p.segment<2>(at + Places);
        chips.crosstalk_T_per_A.row(2 * static_cast<int>(j)) = p.segment<CoilCount>(at + Own).transpose();
        chips.crosstalk_T_per_A.row(2 * static_cast<int>(j) + 1) =
            p.segment<CoilCount>(at + Own + CoilCount).transpose();
    }
    return chips;
}

// d(board's form)/d(fit's form), for the covariance.
Eigen::MatrixXd boardForm(const Vector& p) {
    Eigen::MatrixXd map = Eigen::MatrixXd::Zero(ChipFitParameters, Unknowns);
    for (int j = 0; j < ChipCount; ++j) {
        const int at = j * PerChip;
        const int to = j * ChipParameters;
        const double b = 0.5 * (p(at) + p(at + 3));
        map(to, at) = map(to, at + 3) = 0.5;
        const std::array<int, Factors> source = {0, 3, 1, 2}; // gain x', gain y', cross xy, cross yx
        for (int i = 0; i < Factors; ++i) {
            const int from = at + source[static_cast<std::size_t>(i)];
            map(to + 1 + i, from) += 1.0 / b;
            map(to + 1 + i, at) -= 0.5 * p(from) / (b * b);
            map(to + 1 + i, at + 3) -= 0.5 * p(from) / (b * b);
        }
        map.block<4, 4>(to + 5, at + Offsets).setIdentity();
        for (int i = 0; i < Stray; ++i) {
            map(ChipCount * ChipParameters + j * Stray + i, at + Own + i) = 1.0;
        }
    }
    return map;
}

// Readings of one chip and their derivatives by the pose (scaled) and by the chip's unknowns.
struct ChipReading {
    Eigen::Vector2d reading_T;
    Eigen::Matrix<double, 2, 3> byPose;
    Eigen::Matrix<double, 2, PerChip> byChip;
};

ChipReading chipReading(const Vector& p, int chip, double gamma, const Pose& pose,
                        const models::CoilCurrents_A& current_A) {
    const auto own = p.segment<PerChip>(chip * PerChip);
    const double c = std::cos(pose.z() / Lever_m);
    const double s = std::sin(pose.z() / Lever_m);
    const Eigen::Vector2d place = own.segment<2>(Places);
    const double armX = c * place.x() - s * place.y();
    const double armY = s * place.x() + c * place.y();
    const double sinX = std::sin(gamma * (pose.x() + armX));
    const double sinY = std::sin(gamma * (pose.y() + armY));
    const double slopeX = gamma * std::cos(gamma * (pose.x() + armX));
    const double slopeY = gamma * std::cos(gamma * (pose.y() + armY));
    const Eigen::Vector2d unit(sinX * c + sinY * s, -sinX * s + sinY * c);
    Eigen::Matrix2d byPlaceXY; // of the unit field, by X and Y
    byPlaceXY << slopeX * c, slopeY * s, -slopeX * s, slopeY * c;
    Eigen::Matrix2d turn;
    turn << c, -s, s, c;
    Eigen::Matrix2d factors;
    factors << own(0), own(1), own(2), own(3);

    ChipReading result;
    result.reading_T = factors * unit + own.segment<2>(Offsets);
    result.reading_T.x() += own.segment<CoilCount>(Own).dot(current_A);
    result.reading_T.y() += own.segment<CoilCount>(Own + CoilCount).dot(current_A);
    const Eigen::Matrix2d byXY = factors * byPlaceXY;
    const Eigen::Vector2d turned(unit.y(), -unit.x());
    result.byPose.leftCols<2>() = byXY;
    result.byPose.col(2) = (byXY * Eigen::Vector2d(-armY, armX) + factors * turned) / Lever_m;
    result.byChip.setZero();
    result.byChip(0, 0) = result.byChip(1, 2) = unit.x();
    result.byChip(0, 1) = result.byChip(1, 3) = unit.y();
    result.byChip(0, Offsets) = result.byChip(1, Offsets + 1) = 1.0;
    result.byChip.block<2, 2>(0, Places) = byXY * turn;
    result.byChip.block<1, CoilCount>(0, Own) = current_A.transpose();
    result.byChip.block<1, CoilCount>(1, Own + CoilCount) = current_A.transpose();
    return result;
}

Pose refined(const Vector& p, double gamma, const ChipSample& sample, Pose pose) {
    for (int iteration = 0; iteration < 6; ++iteration) {
        Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
        for (int j = 0; j < ChipCount; ++j) {
            const ChipReading chip = chipReading(p, j, gamma, pose, sample.current_A);
            information += chip.byPose.transpose() * chip.byPose;
            gradient += chip.byPose.transpose() * (sample.reading_T.segment<2>(2 * j) - chip.reading_T);
        }
        const Pose step = information.ldlt().solve(gradient);
        pose += step;
        if (step.norm() < 1e-10) {
            break;
        }
    }
    return pose;
}

struct Normal {
    Matrix information = Matrix::Zero();
    Vector gradient = Vector::Zero();
    double squares = 0.0;
    // Schur terms of the last samples: one product over 64 samples costs less than 64 products.
    static constexpr int Kept = 64;
    Eigen::MatrixXd mixed = Eigen::MatrixXd::Zero(3 * Kept, Unknowns);
    Eigen::MatrixXd share = Eigen::MatrixXd::Zero(3 * Kept, Unknowns);
    int kept = 0;
};

void subtractPoseTerms(Normal& normal) {
    const Eigen::Index rows = 3 * normal.kept;
    normal.information.noalias() -= normal.mixed.topRows(rows).transpose() * normal.share.topRows(rows);
    normal.kept = 0;
}

// One sample with its pose eliminated.
void accumulate(Normal& normal, const Vector& p, double gamma, const ChipSample& sample, const Pose& pose) {
    Eigen::Matrix3d byPoses = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, Unknowns> mixed = Eigen::Matrix<double, 3, Unknowns>::Zero();
    Eigen::Vector3d poseGradient = Eigen::Vector3d::Zero();
    for (int j = 0; j < ChipCount; ++j) {
        const ChipReading chip = chipReading(p, j, gamma, pose, sample.current_A);
        const Eigen::Vector2d residual = sample.reading_T.segment<2>(2 * j) - chip.reading_T;
        byPoses += chip.byPose.transpose() * chip.byPose;
        mixed.middleCols<PerChip>(j * PerChip) = chip.byPose.transpose() * chip.byChip;
        poseGradient += chip.byPose.transpose() * residual;
        normal.information.block<PerChip, PerChip>(j * PerChip, j * PerChip) +=
            chip.byChip.transpose() * chip.byChip;
        normal.gradient.segment<PerChip>(j * PerChip) += chip.byChip.transpose() * residual;
        normal.squares += residual.squaredNorm();
    }
    const Eigen::LDLT<Eigen::Matrix3d> inverse = byPoses.ldlt();
    const Eigen::Matrix<double, 3, Unknowns> share = inverse.solve(mixed);
    normal.mixed.middleRows<3>(3 * normal.kept) = mixed;
    normal.share.middleRows<3>(3 * normal.kept) = share;
    normal.gradient -= share.transpose() * poseGradient;
    if (++normal.kept == Normal::Kept) {
        subtractPoseTerms(normal);
    }
}

// Rows that hold what no motion shows: mean place, rotation of all places about it.
Eigen::Matrix<double, 3, Unknowns> gauge(const Vector& start) {
    Eigen::Matrix<double, 3, Unknowns> rows = Eigen::Matrix<double, 3, Unknowns>::Zero();
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (int j = 0; j < ChipCount; ++j) {
        mean += start.segment<2>(j * PerChip + Places) / ChipCount;
    }
    for (int j = 0; j < ChipCount; ++j) {
        const Eigen::Vector2d arm = start.segment<2>(j * PerChip + Places) - mean;
        rows(0, j * PerChip + Places) = rows(1, j * PerChip + Places + 1) = 1.0;
        rows(2, j * PerChip + Places) = -arm.y() / Lever_m;
        rows(2, j * PerChip + Places + 1) = arm.x() / Lever_m;
    }
    return rows;
}

Result<void> checkSpan(const std::vector<ChipSample>& samples, double pitch_m) {
    const auto [lowX, highX] = std::minmax_element(samples.begin(), samples.end(),
                                                   [](auto& a, auto& b) { return a.pose.x_m < b.pose.x_m; });
    const auto [lowY, highY] = std::minmax_element(samples.begin(), samples.end(),
                                                   [](auto& a, auto& b) { return a.pose.y_m < b.pose.y_m; });
    const double span_m = std::min(highX->pose.x_m - lowX->pose.x_m, highY->pose.y_m - lowY->pose.y_m);
    if (span_m >= 0.99 * pitch_m) { // noise and errors of the poses
        return {};
    }
    return failure(ErrorCode::Refused,
                   fmt::format("the motion covers {:.1f} mm, less than the pitch of {:.1f} mm", 1e3 * span_m,
                               1e3 * pitch_m),
                   "Start nearer to the middle, or widen window.x and window.y.");
}

} // namespace

Result<ChipFit> fitChips(const std::vector<ChipSample>& samples, const ChipCalibration& present,
                         double waveNumber_per_m) {
    if (samples.size() < 200) {
        return failure(ErrorCode::InvalidInput, fmt::format("{} samples are too few", samples.size()),
                       "Record at least 200.");
    }
    if (auto spanned = checkSpan(samples, 2.0 * Pi / waveNumber_per_m); !spanned) {
        return failure(spanned.error());
    }
    const Vector start = unknownsOf(present);
    const Vector sigma = priors(start);
    const Eigen::Matrix<double, 3, Unknowns> fixed = gauge(start);
    Vector p = start;
    std::vector<Pose> poses;
    for (const ChipSample& sample : samples) {
        poses.push_back(scaled(sample.pose));
    }
    ChipFit fit;
    double noise_T = 2e-4; // of a first calibration; the residuals say better
    Matrix information;
    const double freedom = 3.0 * static_cast<double>(samples.size()) - ChipFitParameters;
    for (bool isDone = false; !isDone; ++fit.iterations) {
        if (fit.iterations == LargestIterations) {
            return failure(ErrorCode::Refused, "the calibration of the chips does not converge",
                           "Check the chips: one may be dead, stuck or clipped.");
        }
        Normal normal;
        for (std::size_t n = 0; n < samples.size(); ++n) {
            poses[n] = refined(p, waveNumber_per_m, samples[n], poses[n]);
            accumulate(normal, p, waveNumber_per_m, samples[n], poses[n]);
        }
        subtractPoseTerms(normal);
        noise_T = std::sqrt(normal.squares / freedom);
        information = normal.information / (noise_T * noise_T);
        Vector gradient = normal.gradient / (noise_T * noise_T);
        information.diagonal() += sigma.cwiseAbs2().cwiseInverse();
        gradient -= (p - start).cwiseQuotient(sigma.cwiseAbs2());
        const Eigen::Matrix<double, 3, Unknowns> held = fixed * (GaugeWeight / 1e-3);
        information += held.transpose() * held;
        gradient -= held.transpose() * (held * (p - start));
        // Of unit diagonal: place and crosstalk differ by orders of magnitude.
        const Vector scale = information.diagonal().cwiseSqrt().cwiseInverse();
        const Eigen::LDLT<Matrix> solver((scale.asDiagonal() * information * scale.asDiagonal()).eval());
        const Vector step = scale.cwiseProduct(solver.solve(scale.cwiseProduct(gradient)));
        if (!step.allFinite()) {
            return failure(ErrorCode::NotFinite, "the calibration of the chips is not determined",
                           "Check the chips and the motion.");
        }
        p += step;
        isDone = step.cwiseQuotient(sigma).cwiseAbs().maxCoeff() < 1e-5;
        if (isDone) {
            const Matrix inverse = scale.asDiagonal() * solver.solve(Matrix::Identity()) * scale.asDiagonal();
            const Eigen::MatrixXd map = boardForm(p);
            fit.covariance = map * inverse * map.transpose();
            fit.ownCovariance = inverse;
        }
    }
    fit.calibration = calibrationOf(p);
    fit.noise_T = noise_T;
    for (const Pose& pose : poses) {
        fit.poses.push_back(poseOf(pose));
    }
    return fit;
}

PlanarPose poseFrom(const ChipCalibration& calibration, double waveNumber_per_m, const ChipSample& sample,
                    const PlanarPose& start) {
    return poseOf(refined(unknownsOf(calibration), waveNumber_per_m, sample, scaled(start)));
}

PoseSensitivity poseSensitivity(const ChipCalibration& calibration, double waveNumber_per_m,
                                const ChipSample& sample, const PlanarPose& pose) {
    static_assert(ChipUnknowns == Unknowns);
    const Vector p = unknownsOf(calibration);
    Eigen::Matrix3d byPoses = Eigen::Matrix3d::Zero();
    PoseSensitivity mixed;
    for (int j = 0; j < ChipCount; ++j) {
        const ChipReading chip = chipReading(p, j, waveNumber_per_m, scaled(pose), sample.current_A);
        byPoses += chip.byPose.transpose() * chip.byPose;
        mixed.middleCols<PerChip>(j * PerChip) = chip.byPose.transpose() * chip.byChip;
    }
    PoseSensitivity result = -byPoses.ldlt().solve(mixed);
    result.row(2) /= Lever_m;
    return result;
}

models::ChipFields_T readingsAt(const ChipCalibration& calibration, double waveNumber_per_m,
                                const PlanarPose& pose) {
    const Vector p = unknownsOf(calibration);
    models::ChipFields_T reading_T;
    for (int j = 0; j < ChipCount; ++j) {
        reading_T.segment<2>(2 * j) =
            chipReading(p, j, waveNumber_per_m, scaled(pose), models::CoilCurrents_A::Zero()).reading_T;
    }
    return reading_T;
}

Eigen::Vector3d periodicError(const ChipCalibration& real, const ChipCalibration& used,
                              double waveNumber_per_m) {
    constexpr int Steps = 16;
    const double step_m = 2.0 * Pi / waveNumber_per_m / Steps;
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9);
    Eigen::Vector3d high = -low;
    for (int i = 0; i < Steps * Steps; ++i) {
        const PlanarPose pose{step_m * (i % Steps), step_m * (i / Steps), 0.0};
        const ChipSample sample{readingsAt(real, waveNumber_per_m, pose), models::CoilCurrents_A::Zero(),
                                pose};
        const PlanarPose found = poseFrom(used, waveNumber_per_m, sample, pose);
        const Eigen::Vector3d error(found.x_m - pose.x_m, found.y_m - pose.y_m, found.angle_rad);
        low = low.cwiseMin(error);
        high = high.cwiseMax(error);
    }
    return high - low;
}

} // namespace halbench::app
