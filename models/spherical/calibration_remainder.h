#pragma once

#include "models/spherical/calibration_unknowns.h"

namespace halbench::models {

/// What the parts and the assembly of a device that was never calibrated leave open, rms of each value: the
/// tolerances of the specification (resources/help/spherical-theory.md section 8).
struct AssemblyTolerance {
    double gain_ratio = 0.01;
    double skew_ratio = 2e-3;
    double offset_T = 1e-3;
    double turn_rad = 0.01745329251994329577;
    double place_m = 1e-4; ///< each way
};

/// Errors that a calibration still has: which unknowns, and their covariance, SI.
struct CalibrationRemainder {
    std::vector<CalibrationUnknown> unknowns;
    Eigen::MatrixXd covariance;
};

/// Of a device with nominal values only. A radial error of a place counts as one of all gains of its sensor:
/// the field falls with the fourth power.
CalibrationRemainder assemblyRemainder(const SphericalCalibration& nominal,
                                       const AssemblyTolerance& tolerance);

/// Effect of a remainder on the orientation that all nine channels give with a free strength. To first order
/// the rotation errs by -G J e, e the errors of the unknowns, J the readings' derivative by them, G the
/// pseudo-inverse of their derivative by rotation and strength, and by a uniform field where that is unknown
/// too: three more unknowns for the same nine readings, so that each error counts for much more.
class RemainingError {
public:
    RemainingError(const SphericalCalibration& calibration, CalibrationRemainder remainder,
                   bool hasUniformField = false);

    /// G J C J^T G^T: of the rotation vector in stator axes.
    Eigen::Matrix3d covariance_rad2(const Eigen::Matrix3d& rotation) const;
    /// Deviation of uncorrelated errors of the readings that tilt the shaft as much, rms over the published
    /// workspace.
    double readingDeviation_T() const;

private:
    Eigen::Matrix<double, 3, 9> sensitivity(const CalibrationPrediction& prediction,
                                            const Eigen::Matrix3d& rotation) const;

    SphericalCalibration m_calibration;
    CalibrationRemainder m_remainder;
    bool m_hasUniformField = false;
};

} // namespace halbench::models
