#pragma once

#include "app/analyses/spherical/orientation_readings.h"
#include "app/analyses/spherical/placement_choice.h"
#include "models/spherical/calibration_remainder.h"
#include "models/spherical/orientation_estimator.h"

#include <optional>

namespace halbench::app {

/// Calibration of the sensors and the uncertainty of the orientation that its errors leave: the setting
/// `calibration` names the result of a calibration, whose values correct the readings and whose tolerance
/// remains; so do those of the connected device; without either `tolerance` says whether the sensors are as
/// assembled or exact.
class OrientationConfidence {
public:
    /// Errors: FileSystem, InvalidInput (no calibration of this device), Usage (a calibration beside a
    /// placement or harmonics).
    static Result<OrientationConfidence> make(const AnalysisValues& values, const PlacementChoice& choice);

    /// Sensors and field that the estimator takes; `deviation_T` of every channel.
    models::SphericalSensing sensing(double deviation_T) const;
    double deviation_T() const { return m_deviation_T; }
    /// Variance of the errors that sensors keep beside their noise, over that of the noise.
    double errorShare() const;
    models::SphericalReadings corrected_T(models::SphericalReadings readings_T,
                                          const models::ChannelMask& used, double coilCurrent_A) const;

    /// Noise, the tolerance of the sensors, and the excess of chi-square beyond its 99 % quantile over what
    /// both explain.
    Eigen::Matrix3d covariance_rad2(const models::OrientationEstimate& estimate) const;

private:
    explicit OrientationConfidence(models::SphericalCalibration calibration)
        : m_calibration(std::move(calibration)) {}
    static OrientationConfidence ofBoard(const AnalysisValues& values, const SensingBoard& board);

    models::SphericalCalibration m_calibration;
    std::optional<models::RemainingError> m_remaining; ///< of the assembly
    double m_deviation_T = 100e-6;
    double m_tolerance_T = 0.0; ///< the same in each reading
};

/// Settings `noise_uT`, `tolerance`, `calibration`.
std::vector<AnalysisKey> confidenceKeys();

} // namespace halbench::app
