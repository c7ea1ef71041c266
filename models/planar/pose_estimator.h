#pragma once

#include "models/planar/hall_chip.h"

#include <Eigen/Core>
#include <array>
#include <optional>

namespace halbench::models {

/// Readings or fields in the order Bx'1, By'1, Bx'2, ... By'3, T.
using ChipFields_T = Eigen::Matrix<double, FieldCount, 1>;
using ChipMask = std::array<bool, ChipCount>;
constexpr ChipMask AllChips = {true, true, true};

/// What the controller believes about its chips: reading = sensitivity B + offset + crosstalk i + noise.
struct PoseSensing {
    double waveNumber_per_m = 123.68475;
    std::array<Eigen::Vector2d, ChipCount> place_m{};
    std::array<double, ChipCount> amplitude_T{20e-3, 20e-3, 20e-3};
    std::array<Eigen::Matrix2d, ChipCount> sensitivity{};
    std::array<Eigen::Vector2d, ChipCount> offset_T{};
    Eigen::Matrix<double, FieldCount, CoilCount> crosstalk_T_per_A =
        Eigen::Matrix<double, FieldCount, CoilCount>::Zero();
    double deviation_T = 18e-6; ///< of a reading from the model: noise and what calibration leaves

    double pitch_m() const;
};

struct PlanarParameters;

/// Perfect chips at their nominal places.
PoseSensing nominalSensing(const PlanarParameters& parameters);

/// B = sensitivity^-1 (reading - crosstalk i - offset).
ChipFields_T correctedFields_T(const PoseSensing& sensing, const ChipFields_T& reading_T,
                               const CoilCurrents_A& current_A);

/// Pose modulo the pitch for small rotations, in closed form: both phases by linear least squares of
///   Bx'_j/b_j = sin(gamma x) cos(gamma x'_j) + cos(gamma x) sin(gamma x'_j)   and likewise in y,
/// which for the usual layout are the two arctangents of resources/help/planar-theory.md section 7. Empty
/// where the chips in use have no quadrature in x or y.
std::optional<PlanarPose> startPose(const PoseSensing& sensing, const ChipFields_T& field_T,
                                    const ChipMask& used = AllChips);

/// The pose moved by whole pitches so that x and y lie nearest to those of `near`: counts pitches.
PlanarPose inNearestCell(const PlanarPose& pose, const PlanarPose& near, double pitch_m);

enum class PoseVerdict {
    Determined,
    NotDetermined, ///< the chips in use leave a direction open at this pose
    NotConverged   ///< no pose near the start explains the readings
};

struct PoseEstimate {
    PoseVerdict verdict = PoseVerdict::NotConverged;
    PlanarPose pose;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< of x, y, angle: m^2, m rad, rad^2
    double chiSquare = 0.0;                               ///< sum of squared residuals over their deviation
    int freedom = 0;                                      ///< degrees of freedom of chiSquare: readings - 3
    int iterations = 0;
};

/// Weighted least squares for (x, y, angle) from the chips in use, by Gauss-Newton from `start` (within a
/// fifth of a pitch and 0.2 rad). Covariance: deviation^2 (J^T J)^-1. Not determined when the scaled
/// information (angle times 50 mm) has an eigenvalue below 1 % of (gamma b)^2: deviation above ten times that
/// of one reading.
PoseEstimate estimatePose(const PoseSensing& sensing, const ChipFields_T& field_T, const PlanarPose& start,
                          const ChipMask& used = AllChips);

/// When a chip contradicts the others. Limits of chi-square: 1e-9 of healthy readings exceed them.
struct ChipCheck {
    double limitOfThree = 45.0; ///< all chips: 3 degrees of freedom
    double limitOfTwo = 37.3;   ///< one left out: 1 degree of freedom
    double jump_m = 0.5e-3;     ///< farther from the predicted pose (angle times 50 mm) no pose is believed
};

enum class ChipVerdict {
    AllUsed,
    OneLeftOut, ///< one chip contradicts the two others, which determine the pose
    Ambiguous,  ///< a chip contradicts, but more than one could be the wrong one
    NoPose      ///< nothing determines a pose near the predicted one
};

struct CheckedPose {
    ChipVerdict verdict = ChipVerdict::NoPose;
    PoseEstimate estimate; ///< of the chips in use; of all three when ambiguous
    ChipMask used = AllChips;
};

/// Estimates from all chips; when they contradict each other, from each two that determine the pose. A chip
/// that is known to be bad is left out from the start (`trusted` false).
CheckedPose estimateChecked(const PoseSensing& sensing, const ChipFields_T& field_T,
                            const PlanarPose& predicted, const ChipCheck& check = {},
                            const ChipMask& trusted = AllChips);

} // namespace halbench::models
