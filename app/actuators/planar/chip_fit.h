#pragma once

#include "control/base/result.h"
#include "models/planar/pose_estimator.h"

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace halbench::app {

/// Calibration of the three Hall chips, in the form of the board: reading of chip j =
/// b_j [(1 + g) B + c B of the other axis] + offset + S i, B: unit sines of the lattice at the chip's place.
struct ChipCalibration {
    std::array<double, models::ChipCount> amplitude_T{};
    std::array<Eigen::Vector2d, models::ChipCount> gain{};  ///< errors along x' and y'
    std::array<Eigen::Vector2d, models::ChipCount> cross{}; ///< xy: share of y' in x'; yx
    std::array<Eigen::Vector2d, models::ChipCount> offset_T{};
    std::array<Eigen::Vector2d, models::ChipCount> place_m{};
    Eigen::Matrix<double, models::FieldCount, models::CoilCount> crosstalk_T_per_A =
        Eigen::Matrix<double, models::FieldCount, models::CoilCount>::Zero();
};

/// One sample of a motion: what the chips read, the currents that flowed meanwhile, and the pose that the
/// board believed, from which the fit starts.
struct ChipSample {
    models::ChipFields_T reading_T;
    models::CoilCurrents_A current_A;
    models::PlanarPose pose;
};

/// Parameters of one chip in the order of the covariance: amplitude, gain x', gain y', cross xy, cross yx,
/// offset x', offset y', place x', place y'; behind the three chips the crosstalk, row by row.
inline constexpr int ChipParameters = 9;
inline constexpr int ChipFitParameters =
    models::ChipCount * ChipParameters + models::FieldCount * models::CoilCount;

/// The fit's own unknowns: of each chip four factors of the unit field, offsets, place, crosstalk.
inline constexpr int ChipUnknowns = models::ChipCount * (8 + 2 * models::CoilCount);
/// Change of a pose (m, m, rad) by each of them.
using PoseSensitivity = Eigen::Matrix<double, 3, ChipUnknowns>;

struct ChipFit {
    ChipCalibration calibration;
    Eigen::MatrixXd ownCovariance; ///< of the own unknowns: what it leaves of errors common to all poses
    Eigen::MatrixXd covariance;    ///< ChipFitParameters squared
    std::vector<models::PlanarPose> poses; ///< of the samples, with the new calibration
    double noise_T = 0.0;                  ///< rms of a reading about the model
    int iterations = 0;
};

/// Calibration and all poses together by least squares: six readings a sample decide three coordinates, the
/// rest decides the calibration. Poses are eliminated sample by sample (Schur complement), the calibration is
/// found by Gauss-Newton from `present`.
///
/// The zero of the pose and the orientation of the platen axes cannot be seen from inside: the places keep
/// the mean of `present` and are not turned as a whole against it; the two gains of a chip are opposite, its
/// amplitude takes their mean. What the motion leaves open stays within weak priors: 5 % of amplitude and
/// cross-axis share, 2 mT of offset, 1 mm of place, 1 mT/A of crosstalk. A chip sees sines that repeat with
/// the pitch (resources/help/planar-theory.md section 7), so the motion must cover a pitch each way.
///
/// Errors: InvalidInput (fewer than 200 samples), Refused (no pitch covered, no convergence), NotFinite.
/// Complexity: samples times parameters squared.
Result<ChipFit> fitChips(const std::vector<ChipSample>& samples, const ChipCalibration& present,
                         double waveNumber_per_m);

/// Pose by this calibration; Gauss-Newton from `start`.
models::PlanarPose poseFrom(const ChipCalibration& calibration, double waveNumber_per_m,
                            const ChipSample& sample, const models::PlanarPose& start);

/// How the pose of a sample depends on the calibration.
PoseSensitivity poseSensitivity(const ChipCalibration& calibration, double waveNumber_per_m,
                                const ChipSample& sample, const models::PlanarPose& pose);

/// Readings without noise at a pose.
models::ChipFields_T readingsAt(const ChipCalibration& calibration, double waveNumber_per_m,
                                const models::PlanarPose& pose);

/// Peak-to-peak error over one cell of the lattice, constant parts left out, of poses that `used` finds from
/// what `real` reads: x, y in m, angle in rad.
Eigen::Vector3d periodicError(const ChipCalibration& real, const ChipCalibration& used,
                              double waveNumber_per_m);

} // namespace halbench::app
