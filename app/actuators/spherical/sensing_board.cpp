#include "app/actuators/spherical/sensing_board.h"

#include "control/base/assert.h"
#include "models/fields/spherical_harmonic_rotor.h"
#include "models/spherical/orientation.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>

namespace halbench::app {
namespace {

constexpr int Sensors = 3;
constexpr int Channels = 9;
constexpr std::array<const char*, 4> Places = {"alpha", "beta", "gamma", "radius"};
constexpr std::array<const char*, 5> Lists = {"turn", "gain", "skew", "offset", "coil"};
constexpr std::array<const char*, 6> Singles = {"sensor.frames",  "sensor.deviation", "sensor.tolerance",
                                                "rotor.strength", "rotor.drift",      "rotor.reference"};
/// Harmonics that the board corrects, in its order.
constexpr std::array<std::pair<int, int>, 4> Shapes = {{{4, 2}, {6, 2}, {6, 6}, {10, 10}}};

} // namespace

std::vector<std::string> sensingParameters() {
    std::vector<std::string> names;
    for (int i = 0; i < Sensors; ++i) {
        for (const char* place : Places) {
            names.push_back(fmt::format("sensor.{}_{}", place, i));
        }
    }
    for (const char* list : Lists) {
        for (int c = 1; c <= Channels; ++c) {
            names.push_back(fmt::format("sensor.{}_{}", list, c));
        }
    }
    names.insert(names.end(), Singles.begin(), Singles.end());
    for (std::size_t k = 1; k <= Shapes.size(); ++k) {
        names.push_back(fmt::format("rotor.harmonic_{}", k));
    }
    return names;
}

SensingBoard sensingBoard(const std::vector<double>& values) {
    auto next = values.begin();
    const auto take = [&next] { return *next++; };
    HB_ASSERT(values.size() == sensingParameters().size());
    SensingBoard board;
    std::array<double, Sensors> radius_m{};
    for (std::size_t i = 0; i < Sensors; ++i) {
        board.placement[i] = {take(), take(), take()};
        radius_m[i] = take();
    }
    std::array<models::SphericalReadings, Lists.size()> lists;
    for (models::SphericalReadings& list : lists) {
        for (double& value : list) {
            value = take();
        }
    }
    board.frames = static_cast<models::SensorFrames>(std::lround(take()));
    board.deviation_T = take();
    board.tolerance_T = take();
    models::SphericalCalibration& calibration = board.calibration;
    calibration.field.strength_T = take();
    calibration.drift_per_K = take();
    calibration.referenceTemperature_degC = take();
    for (const auto& [degree, order] : Shapes) {
        calibration.field.harmonics.push_back({degree, order, take()});
    }
    const auto& [turn, gain, skew, offset, coil] = lists;
    for (std::size_t i = 0; i < Sensors; ++i) {
        const auto three = [i](const models::SphericalReadings& list) -> Eigen::Vector3d {
            return list.segment<3>(static_cast<Eigen::Index>(3 * i));
        };
        models::SensorCalibration& sensor = calibration.sensors[i];
        sensor.pose = models::displacedPose(
            models::sensorPose(models::placementRotation(board.placement[i], board.frames), radius_m[i]),
            three(turn), Eigen::Vector3d::Zero());
        sensor.gain_ratio = Eigen::Vector3d::Ones() + three(gain);
        sensor.skew_ratio = three(skew);
        sensor.offset_T = three(offset);
    }
    calibration.coil_T_per_A = coil;
    return board;
}

SensingBoard notedSensingBoard(const std::vector<ParameterValue>& noted) {
    std::map<std::string, double> values = {
        {"sensor.deviation", 100e-6},
        {"rotor.strength", models::tensorStrength_T(models::SphericalRotorMagnet{}, 0.05)},
        {"rotor.drift", -1.1e-3},
        {"rotor.reference", 25.0}};
    const models::SensorTriple places = models::publishedPlacement();
    for (std::size_t i = 0; i < Sensors; ++i) {
        const std::array angles = {places[i].alpha_rad, places[i].beta_rad, places[i].gamma_rad, 0.05};
        for (std::size_t k = 0; k < Places.size(); ++k) {
            values[fmt::format("sensor.{}_{}", Places[k], i)] = angles[k];
        }
    }
    for (const ParameterValue& value : noted) {
        values[value.name] = value.value;
    }
    std::vector<double> ordered;
    for (const std::string& name : sensingParameters()) {
        ordered.push_back(values[name]);
    }
    return sensingBoard(ordered);
}

double meanRadius_m(const SensingBoard& board) {
    double sum_m = 0.0;
    for (const models::SensorCalibration& sensor : board.calibration.sensors) {
        sum_m += sensor.pose.position_m.norm();
    }
    return sum_m / static_cast<double>(board.calibration.sensors.size());
}

Result<SensingBoard> readSensingBoard(devices::Device& device) {
    const auto values = device.readParameters(sensingParameters());
    return values ? Result<SensingBoard>(sensingBoard(*values)) : failure(values.error());
}

Result<void> checkSensorPlaces(devices::Device& device, std::span<const ParameterValue> values) {
    const std::vector<std::string> names = sensingParameters();
    const auto isPlace = [&names](const ParameterValue& value) {
        const auto end = names.begin() + Sensors * static_cast<std::ptrdiff_t>(Places.size());
        return std::find(names.begin(), end, value.name) != end || value.name == "sensor.frames";
    };
    if (std::none_of(values.begin(), values.end(), isPlace)) {
        return {};
    }
    auto board = device.readParameters(names);
    if (!board) {
        return failure(board.error());
    }
    for (const ParameterValue& value : values) {
        const auto found = std::find(names.begin(), names.end(), value.name);
        if (found != names.end()) {
            (*board)[static_cast<std::size_t>(found - names.begin())] = value.value;
        }
    }
    models::SensorPoses poses;
    const SensingBoard changed = sensingBoard(*board);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        poses[i] = changed.calibration.sensors[i].pose;
    }
    return models::checkSensorPoses(poses, 0.0); // the board does not know the rotor's radius
}

std::vector<std::string> fieldSignals() {
    std::vector<std::string> names;
    for (int i = 0; i < Sensors; ++i) {
        for (const char* channel : {"r", "theta", "phi"}) {
            names.push_back(fmt::format("field.{}.{}", i, channel));
        }
    }
    return names;
}

models::PlacementAngles placementTowards(const models::PlacementAngles& start, models::SensorFrames frames,
                                         const Eigen::Vector3d& direction) {
    constexpr int Steps = 20;
    constexpr double Difference_rad = 1e-6;
    const auto pointsTo = [frames](const models::PlacementAngles& angles) -> Eigen::Vector3d {
        return models::placementRotation(angles, frames).col(0);
    };
    models::PlacementAngles angles = start;
    const std::array<double*, 3> parts = {&angles.alpha_rad, &angles.beta_rad, &angles.gamma_rad};
    for (int step = 0; step < Steps; ++step) {
        Eigen::Matrix3d slope;
        for (std::size_t k = 0; k < parts.size(); ++k) {
            const double kept = *parts[k];
            *parts[k] = kept + Difference_rad;
            const Eigen::Vector3d ahead = pointsTo(angles);
            *parts[k] = kept - Difference_rad;
            slope.col(static_cast<Eigen::Index>(k)) = (ahead - pointsTo(angles)) / (2.0 * Difference_rad);
            *parts[k] = kept;
        }
        // Of the angles that point there the shortest change: a roll about the radius moves nothing.
        Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d> decomposition;
        decomposition.setThreshold(1e-6);
        decomposition.compute(slope);
        const Eigen::Vector3d change = decomposition.solve(direction.normalized() - pointsTo(angles));
        for (std::size_t k = 0; k < parts.size(); ++k) {
            *parts[k] += change[static_cast<Eigen::Index>(k)];
        }
    }
    return angles;
}

std::vector<ParameterValue> sensingValues(const SensingBoard& board,
                                          const models::SphericalCalibration& calibration) {
    std::vector<ParameterValue> values;
    std::array<models::SphericalReadings, 4> lists;
    for (std::size_t i = 0; i < Sensors; ++i) {
        const models::SensorCalibration& sensor = calibration.sensors[i];
        const models::PlacementAngles angles =
            placementTowards(board.placement[i], board.frames, sensor.pose.position_m);
        values.push_back({fmt::format("sensor.alpha_{}", i), angles.alpha_rad});
        values.push_back({fmt::format("sensor.beta_{}", i), angles.beta_rad});
        values.push_back({fmt::format("sensor.gamma_{}", i), angles.gamma_rad});
        values.push_back({fmt::format("sensor.radius_{}", i), sensor.pose.position_m.norm()});
        const Eigen::Matrix3d nominal =
            models::sensorPose(models::placementRotation(angles, board.frames), 1.0).axes;
        const auto at = static_cast<Eigen::Index>(3 * i);
        lists[0].segment<3>(at) = models::vectorOfRotation(sensor.pose.axes * nominal.transpose());
        lists[1].segment<3>(at) = sensor.gain_ratio - Eigen::Vector3d::Ones();
        lists[2].segment<3>(at) = sensor.skew_ratio;
        lists[3].segment<3>(at) = sensor.offset_T;
    }
    for (std::size_t list = 0; list < lists.size(); ++list) {
        for (Eigen::Index c = 0; c < Channels; ++c) {
            values.push_back({fmt::format("sensor.{}_{}", Lists[list], c + 1), lists[list][c]});
        }
    }
    values.push_back({"sensor.frames", static_cast<double>(board.frames)});
    values.push_back({"rotor.strength", calibration.field.strength_T});
    for (std::size_t k = 0; k < Shapes.size(); ++k) {
        values.push_back(
            {fmt::format("rotor.harmonic_{}", k + 1), calibration.field.harmonics[k].amplitude_T});
    }
    return values;
}

std::vector<ParameterValue> coilValues(const models::SphericalCalibration& calibration) {
    std::vector<ParameterValue> values;
    for (Eigen::Index c = 0; c < Channels; ++c) {
        values.push_back({fmt::format("sensor.coil_{}", c + 1), calibration.coil_T_per_A[c]});
    }
    return values;
}

} // namespace halbench::app
