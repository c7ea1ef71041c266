#include "models/spherical/calibration_remainder.h"

#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "models/spherical/tensor_system.h"

#include <Eigen/QR>
#include <cmath>

namespace halbench::models {
namespace {

constexpr double FallPower = 4.0; ///< of the tensor's field with the distance

double variance(double deviation) {
    return deviation * deviation;
}

} // namespace

CalibrationRemainder assemblyRemainder(const SphericalCalibration& nominal,
                                       const AssemblyTolerance& tolerance) {
    CalibrationRemainder remainder;
    CalibrationSelection selection;
    selection.strength = false; // the orientation does not depend on it
    selection.skews = selection.directions = true;
    remainder.unknowns = calibrationUnknowns(selection, nominal);
    const auto count = static_cast<Eigen::Index>(remainder.unknowns.size());
    remainder.covariance.setZero(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const CalibrationUnknown& unknown = remainder.unknowns[static_cast<std::size_t>(k)];
        const auto sensor = static_cast<std::size_t>(unknown.sensor);
        const double radius_m = nominal.sensors[sensor].pose.position_m.norm();
        double& own = remainder.covariance(k, k);
        switch (unknown.kind) {
        case CalibrationKind::Gain:
            own = variance(tolerance.gain_ratio);
            for (Eigen::Index j = 0; j < count; ++j) {
                const CalibrationUnknown& other = remainder.unknowns[static_cast<std::size_t>(j)];
                if (other.kind == CalibrationKind::Gain && other.sensor == unknown.sensor) {
                    remainder.covariance(k, j) += variance(FallPower * tolerance.place_m / radius_m);
                }
            }
            break;
        case CalibrationKind::Skew: // the mean of two shares of one size
            own = variance(tolerance.skew_ratio) / 2.0;
            break;
        case CalibrationKind::Offset:
            own = variance(tolerance.offset_T);
            break;
        case CalibrationKind::Turn: // half their difference acts as a turn
            own = variance(tolerance.turn_rad) + variance(tolerance.skew_ratio) / 2.0;
            break;
        case CalibrationKind::Direction:
            own = variance(tolerance.place_m / radius_m);
            break;
        default:
            break;
        }
    }
    return remainder;
}

RemainingError::RemainingError(const SphericalCalibration& calibration, CalibrationRemainder remainder,
                               bool hasUniformField)
    : m_calibration(calibration), m_remainder(std::move(remainder)), m_hasUniformField(hasUniformField) {}

Eigen::Matrix<double, 3, 9> RemainingError::sensitivity(const CalibrationPrediction& prediction,
                                                        const Eigen::Matrix3d& rotation) const {
    Eigen::Matrix<double, 9, 7> slope;
    slope.leftCols<3>() = prediction.byRotation;
    // With the strength the whole field grows.
    SphericalCalibration plain = m_calibration;
    for (SensorCalibration& sensor : plain.sensors) {
        sensor.offset_T.setZero();
    }
    plain.coil_T_per_A.setZero();
    slope.col(3) = CalibrationModel(plain, {}).at(rotation, {}).readings_T / plain.field.strength_T;
    slope.rightCols<3>().setZero();
    if (m_hasUniformField) {
        slope.rightCols<3>() = uniformFieldDesign(sensingOf(m_calibration, 1.0).poses);
    }
    const Eigen::Index unknowns = m_hasUniformField ? 7 : 4;
    return slope.leftCols(unknowns).completeOrthogonalDecomposition().pseudoInverse().topRows<3>();
}

Eigen::Matrix3d RemainingError::covariance_rad2(const Eigen::Matrix3d& rotation) const {
    const CalibrationPrediction prediction =
        CalibrationModel(m_calibration, m_remainder.unknowns).at(rotation, {});
    const Eigen::Matrix<double, 3, Eigen::Dynamic> effect =
        sensitivity(prediction, rotation) * prediction.byUnknown;
    return effect * m_remainder.covariance * effect.transpose();
}

double RemainingError::readingDeviation_T() const {
    constexpr double Tilt_rad = 0.25 * Pi, HalfTurn_rad = 0.5 * Pi;
    constexpr int Tilts = 5, Spins = 6;
    const auto at = [](int i, int count, double most_rad) {
        return most_rad * (2.0 * (i + 0.5) / count - 1.0);
    };
    const CalibrationModel model(m_calibration, m_remainder.unknowns);
    double sum_T2 = 0.0;
    for (int i = 0; i < Tilts; ++i) {
        for (int j = 0; j < Tilts; ++j) {
            for (int k = 0; k < Spins; ++k) {
                const Eigen::Matrix3d rotation =
                    rotationOf({at(i, Tilts, Tilt_rad), at(j, Tilts, Tilt_rad), at(k, Spins, HalfTurn_rad)});
                const CalibrationPrediction prediction = model.at(rotation, {});
                const Eigen::Matrix<double, 2, 9> tilt =
                    rotation.leftCols<2>().transpose() * sensitivity(prediction, rotation);
                const Eigen::Matrix<double, 2, Eigen::Dynamic> effect = tilt * prediction.byUnknown;
                sum_T2 += (effect * m_remainder.covariance * effect.transpose()).trace() /
                          (tilt * tilt.transpose()).trace();
            }
        }
    }
    return std::sqrt(sum_T2 / (Tilts * Tilts * Spins));
}

} // namespace halbench::models
