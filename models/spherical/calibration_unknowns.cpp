#include "models/spherical/calibration_unknowns.h"

#include "control/base/units.h"
#include "models/fields/spherical_harmonic_rotor.h"
#include "models/spherical/orientation.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

namespace halbench::models {
namespace {

constexpr std::array<const char*, 3> Channels = {"R", "Theta", "Phi"};
constexpr std::array<const char*, 3> Pairs = {"R-Theta", "R-Phi", "Theta-Phi"};
constexpr std::array<const char*, 3> Axes = {"x", "y", "z"};
constexpr std::array<const char*, 3> Directions = {"1", "2", ""};

// Plausible errors of parts and assembly.
constexpr double Gain_ratio = 0.05;
constexpr double Skew_ratio = 0.03;
constexpr double Offset_T = 5e-3;
constexpr double Angle_rad = 5.0 * Pi / 180.0;
constexpr double Harmonic_T = 5e-3;
constexpr double Strength_ratio = 0.1;
constexpr double Drift_per_K = 2e-3;
constexpr double Coil_T_per_A = 1e-3;

struct PerSensor {
    bool isFitted;
    CalibrationKind kind;
    int components;
    double plausible;
    fmt::string_view name; ///< with the component and the sensor filled in
    const std::array<const char*, 3>& parts;
};

/// The two directions in which a place can move on its sphere.
Eigen::Vector3d acrossRadius(const Eigen::Vector3d& position, int component) {
    const Eigen::Vector3d first = position.unitOrthogonal();
    return component == 0 ? first : position.normalized().cross(first);
}

Eigen::Matrix3d skewBasis(int component) {
    Eigen::Matrix3d basis = Eigen::Matrix3d::Zero();
    const int row = component == 2 ? 1 : 0;
    const int column = component == 0 ? 1 : 2;
    basis(row, column) = basis(column, row) = 1.0;
    return basis;
}

} // namespace

bool CalibrationSelection::hasReading(CalibrationKind kind, int sensor, int component) const {
    const auto first = static_cast<std::size_t>(3 * sensor);
    if (kind == CalibrationKind::Gain || kind == CalibrationKind::Offset || kind == CalibrationKind::Coil) {
        return channels[first + static_cast<std::size_t>(component)];
    }
    if (kind == CalibrationKind::Skew) { // between two channels; of one alone it is a turn of the frame
        const auto other = static_cast<std::size_t>(2 - component);
        const auto without = [&](std::size_t k) { return k == other || channels[first + k]; };
        return without(0) && without(1) && without(2);
    }
    return channels[first] || channels[first + 1] || channels[first + 2];
}

std::vector<CalibrationUnknown> calibrationUnknowns(const CalibrationSelection& selection,
                                                    const SphericalCalibration& nominal) {
    std::vector<CalibrationUnknown> unknowns;
    if (selection.strength) {
        unknowns.push_back({CalibrationKind::Strength, 0, 0, Strength_ratio * nominal.field.strength_T,
                            fmt::format("field strength {}", "q")});
    }
    if (selection.drift) {
        unknowns.push_back(
            {CalibrationKind::Drift, 0, 0, Drift_per_K, fmt::format("drift of {} with temperature", "q")});
    }
    for (std::size_t k = 0; selection.harmonics && k < nominal.field.harmonics.size(); ++k) {
        const SphericalHarmonicTerm& term = nominal.field.harmonics[k];
        unknowns.push_back({CalibrationKind::Harmonic, 0, static_cast<int>(k), Harmonic_T,
                            fmt::format("harmonic ({},{})", term.degree, term.order)});
    }
    const std::array parts = {
        PerSensor{selection.gains, CalibrationKind::Gain, 3, Gain_ratio, "gain {} of sensor {}", Channels},
        PerSensor{selection.skews, CalibrationKind::Skew, 3, Skew_ratio, "skew {} of sensor {}", Pairs},
        PerSensor{selection.offsets, CalibrationKind::Offset, 3, Offset_T, "offset {} of sensor {}",
                  Channels},
        PerSensor{selection.turns, CalibrationKind::Turn, 3, Angle_rad, "frame about {} of sensor {}", Axes},
        PerSensor{selection.directions, CalibrationKind::Direction, 2, Angle_rad,
                  "place along {} of sensor {}", Directions},
        PerSensor{selection.coil, CalibrationKind::Coil, 3, Coil_T_per_A, "coil field {} of sensor {}",
                  Channels}};
    for (int sensor = 0; sensor < 3; ++sensor) {
        for (const PerSensor& part : parts) {
            for (int k = 0; part.isFitted && k < part.components; ++k) {
                if (!selection.hasReading(part.kind, sensor, k)) {
                    continue;
                }
                unknowns.push_back(
                    {part.kind, sensor, k, part.plausible,
                     fmt::format(fmt::runtime(part.name), part.parts[static_cast<std::size_t>(k)], sensor)});
            }
        }
    }
    return unknowns;
}

SphericalCalibration steppedCalibration(const SphericalCalibration& calibration,
                                        const std::vector<CalibrationUnknown>& unknowns,
                                        const Eigen::VectorXd& step) {
    SphericalCalibration next = calibration;
    std::array<Eigen::Vector3d, 3> turn_rad{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                            Eigen::Vector3d::Zero()};
    for (std::size_t k = 0; k < unknowns.size(); ++k) {
        const CalibrationUnknown& unknown = unknowns[k];
        const double by = step[static_cast<Eigen::Index>(k)];
        SensorCalibration& sensor = next.sensors[static_cast<std::size_t>(unknown.sensor)];
        switch (unknown.kind) {
        case CalibrationKind::Strength:
            next.field.strength_T += by;
            break;
        case CalibrationKind::Harmonic:
            next.field.harmonics[static_cast<std::size_t>(unknown.component)].amplitude_T += by;
            break;
        case CalibrationKind::Gain:
            sensor.gain_ratio[unknown.component] += by;
            break;
        case CalibrationKind::Skew:
            sensor.skew_ratio[unknown.component] += by;
            break;
        case CalibrationKind::Offset:
            sensor.offset_T[unknown.component] += by;
            break;
        case CalibrationKind::Turn:
            turn_rad[static_cast<std::size_t>(unknown.sensor)][unknown.component] += by;
            break;
        case CalibrationKind::Direction: {
            const Eigen::Vector3d& place =
                calibration.sensors[static_cast<std::size_t>(unknown.sensor)].pose.position_m;
            sensor.pose.position_m =
                rotationOfVector(by * acrossRadius(place, unknown.component)) * sensor.pose.position_m;
            break;
        }
        case CalibrationKind::Drift:
            next.drift_per_K += by;
            break;
        case CalibrationKind::Coil:
            next.coil_T_per_A[3 * unknown.sensor + unknown.component] += by;
            break;
        }
    }
    for (std::size_t i = 0; i < turn_rad.size(); ++i) {
        next.sensors[i].pose.axes = rotationOfVector(turn_rad[i]) * next.sensors[i].pose.axes;
    }
    return next;
}

CalibrationModel::CalibrationModel(const SphericalCalibration& calibration,
                                   const std::vector<CalibrationUnknown>& unknowns)
    : m_calibration(calibration), m_unknowns(unknowns), m_field(calibration.field),
      m_harmonics(calibration.field.harmonics, calibration.field.referenceRadius_m) {
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        m_places[i] = {calibration.sensors[i].pose.position_m, Eigen::Matrix3d::Identity()};
    }
}

/// Change of the field itself with an unknown of the rotor.
Eigen::Vector3d CalibrationModel::fieldChange(const CalibrationUnknown& unknown,
                                              const Eigen::Matrix3d& rotation, int sensor) const {
    const Eigen::Vector3d& place = m_places[static_cast<std::size_t>(sensor)].position_m;
    if (unknown.kind == CalibrationKind::Strength) {
        return tensorField_T(rotorTensor_T(1.0, rotation), m_calibration.field.referenceRadius_m, place);
    }
    return rotation *
           m_harmonics.unitField(static_cast<std::size_t>(unknown.component), rotation.transpose() * place);
}

CalibrationPrediction CalibrationModel::at(const Eigen::Matrix3d& rotation,
                                           const CalibrationSample& sample) const {
    const double warmer_K = sample.temperature_degC - m_calibration.referenceTemperature_degC;
    const double scale = 1.0 + m_calibration.drift_per_K * warmer_K;
    CalibrationPrediction prediction;
    OrientationJacobian slope;
    const SphericalReadings plain_T = m_field.readingsAndJacobian(rotation, m_places, slope);
    prediction.readings_T = sample.coilCurrent_A * m_calibration.coil_T_per_A;
    prediction.byUnknown.setZero(9, static_cast<Eigen::Index>(m_unknowns.size()));
    for (int i = 0; i < 3; ++i) {
        const SensorCalibration& sensor = m_calibration.sensors[static_cast<std::size_t>(i)];
        const Eigen::Matrix3d sensitivity = sensor.sensitivity();
        const Eigen::Matrix3d seen = sensitivity * sensor.pose.axes.transpose();
        const Eigen::Vector3d field_T = scale * plain_T.segment<3>(3 * i);
        const Eigen::Matrix3d turned = scale * slope.middleRows<3>(3 * i);
        const Eigen::Vector3d own_T = sensor.pose.axes.transpose() * field_T;
        prediction.readings_T.segment<3>(3 * i) += sensitivity * own_T + sensor.offset_T;
        prediction.byRotation.middleRows<3>(3 * i) = seen * turned;
        for (std::size_t k = 0; k < m_unknowns.size(); ++k) {
            const CalibrationUnknown& unknown = m_unknowns[k];
            const bool isOfRotor = unknown.kind == CalibrationKind::Strength ||
                                   unknown.kind == CalibrationKind::Harmonic ||
                                   unknown.kind == CalibrationKind::Drift;
            if (!isOfRotor && unknown.sensor != i) {
                continue;
            }
            auto change = prediction.byUnknown.block<3, 1>(3 * i, static_cast<Eigen::Index>(k));
            const int c = unknown.component;
            switch (unknown.kind) {
            case CalibrationKind::Strength:
            case CalibrationKind::Harmonic:
                change = scale * seen * fieldChange(unknown, rotation, i);
                break;
            case CalibrationKind::Drift:
                change = warmer_K * seen * plain_T.segment<3>(3 * i);
                break;
            case CalibrationKind::Gain:
                change = sensitivity.col(c) * (own_T[c] / sensor.gain_ratio[c]);
                break;
            case CalibrationKind::Skew:
                change = skewBasis(c) * sensor.gain_ratio.cwiseProduct(own_T);
                break;
            case CalibrationKind::Offset:
                change[c] = 1.0;
                break;
            case CalibrationKind::Turn:
                change = -seen * Eigen::Vector3d::Unit(c).cross(field_T);
                break;
            case CalibrationKind::Direction: {
                // The field at a turned place is the turned field of the rotor turned back.
                const Eigen::Vector3d about = acrossRadius(sensor.pose.position_m, c);
                change = seen * (about.cross(field_T) - turned * about);
                break;
            }
            case CalibrationKind::Coil:
                change[c] = sample.coilCurrent_A;
                break;
            }
        }
    }
    return prediction;
}

} // namespace halbench::models
