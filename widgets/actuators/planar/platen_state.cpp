#include "widgets/actuators/planar/platen_state.h"

#include "control/base/units.h"
#include "models/planar/planar_parameters.h"
#include "models/planar/published_wrench.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <utility>

namespace halbench::widgets {

namespace {

using models::ChipCount;
using models::ChipFields_T;
using models::CoilCount;
using models::CoilCurrents_A;
using models::PlanarPose;

constexpr double PositionMode = 2.0; ///< choice of hb.mode
constexpr double ArmedStatus = 1.0;  ///< choice of the board's status

std::optional<PlanarPose> poseOf(const ActuatorValues& values, const std::string& role) {
    const auto x = values.signal(role + ".x");
    const auto y = values.signal(role + ".y");
    const auto phi = values.signal(role + ".phi");
    return x && y && phi ? std::optional(PlanarPose{*x, *y, *phi}) : std::nullopt;
}

models::PoseSensing sensingOf(const ActuatorValues& values, double pitch_m) {
    models::PoseSensing sensing = models::nominalSensing(models::PlanarParameters());
    sensing.waveNumber_per_m = 2.0 * Pi / pitch_m;
    for (std::size_t j = 0; j < ChipCount; ++j) {
        const std::string number = std::to_string(j + 1);
        const auto value = [&](const char* name, double otherwise) {
            return values.parameter("chip." + std::string(name) + "_" + number).value_or(otherwise);
        };
        sensing.amplitude_T[j] = value("amplitude", sensing.amplitude_T[j]);
        sensing.place_m[j] = {value("place_x", sensing.place_m[j].x()),
                              value("place_y", sensing.place_m[j].y())};
        sensing.sensitivity[j] << 1.0 + value("gain_x", 0.0), value("cross_xy", 0.0), value("cross_yx", 0.0),
            1.0 + value("gain_y", 0.0);
        sensing.offset_T[j] = {value("offset_x", 0.0), value("offset_y", 0.0)};
    }
    for (int row = 0; row < models::FieldCount; ++row) {
        for (int coil = 0; coil < CoilCount; ++coil) {
            const std::string number = std::to_string(row * CoilCount + coil + 1);
            sensing.crosstalk_T_per_A(row, coil) = values.parameter("chip.crosstalk_" + number).value_or(0.0);
        }
    }
    return sensing;
}

} // namespace

PlatenSettings platenSettings(const ActuatorValues& values) {
    PlatenSettings settings;
    const auto set = [&](double& value, const char* name) { value = values.parameter(name).value_or(value); };
    set(settings.geometry.matrix.pitch_m, "coil.pitch");
    set(settings.geometry.winding.width_m, "coil.width");
    set(settings.geometry.arm56_m, "coil.arm");
    set(settings.forceConstant_N_per_A, "coil.force_constant");
    set(settings.massCentre_m.x(), "platen.centre_x");
    set(settings.massCentre_m.y(), "platen.centre_y");
    set(settings.currentLimit_A, "limit.current");
    set(settings.temperatureLimit_degC, "limit.temperature");
    set(settings.liftLimit_N, "limit.lift");
    settings.sensing = sensingOf(values, settings.geometry.matrix.pitch_m);
    const auto x = values.parameter("window.x");
    const auto y = values.parameter("window.y");
    const auto phi = values.parameter("window.phi");
    if (x && y && phi && values.parameter("window.position_enabled").value_or(0.0) > 0.5) {
        settings.window = Eigen::Vector3d(*x, *y, *phi);
    }
    settings.isPositionMode = values.parameter("hb.mode") == PositionMode;
    return settings;
}

PlatenReadings platenReadings(const ActuatorValues& values, const PlatenSettings& settings) {
    PlatenReadings readings;
    readings.pose = poseOf(values, "position");
    readings.truth = poseOf(values, "truth.position");
    readings.isArmed = values.signal("status") == ArmedStatus;
    const std::optional<PlanarPose> reference = poseOf(values, "reference");
    // Exactly zero is what the board sends before it controls a position.
    const bool isSet =
        reference && (reference->x_m != 0.0 || reference->y_m != 0.0 || reference->angle_rad != 0.0);
    if (readings.isArmed && settings.isPositionMode && isSet) {
        readings.reference = reference;
    }
    CoilCurrents_A current_A;
    bool areKnown = true;
    for (int k = 0; k < CoilCount; ++k) {
        const std::string coil = ".coil" + std::to_string(k + 1);
        const auto current = values.signal("current" + coil);
        areKnown = areKnown && current;
        current_A(k) = current.value_or(0.0);
        readings.temperature_degC[static_cast<std::size_t>(k)] = values.signal("coil_temperature" + coil);
    }
    readings.current_A = areKnown ? std::optional(current_A) : std::nullopt;
    ChipFields_T field_T;
    areKnown = true;
    const int leftOut = static_cast<int>(values.signal("chips_left_out").value_or(0.0));
    for (int j = 0; j < ChipCount; ++j) {
        const std::string number = std::to_string(j + 1);
        const auto x = values.signal("hall.x" + number);
        const auto y = values.signal("hall.y" + number);
        areKnown = areKnown && x && y;
        field_T.segment<2>(2 * j) << x.value_or(0.0), y.value_or(0.0);
        readings.used[static_cast<std::size_t>(j)] = (leftOut >> j) % 2 == 0;
    }
    readings.field_T = areKnown ? std::optional(field_T) : std::nullopt;
    readings.lift_N = values.signal("lift");
    readings.chiSquare = values.signal("chi_square");
    readings.currentScale = values.signal("current_scale");
    readings.isHomed = values.signal("homed").value_or(0.0) > 0.5;
    return readings;
}

Eigen::Vector2d inLattice_m(const PlanarPose& pose, const Eigen::Vector2d& place_m) {
    return Eigen::Vector2d(pose.x_m, pose.y_m) + Eigen::Rotation2Dd(pose.angle_rad) * place_m;
}

PlatenForces platenForces(const PlatenSettings& settings, const PlanarPose& pose,
                          const CoilCurrents_A& current_A) {
    const models::PublishedWrench model(settings.geometry, settings.forceConstant_N_per_A);
    const models::CoilWrench perAmpere = model.at(pose);
    const auto coils = settings.geometry.coils();
    PlatenForces forces;
    for (std::size_t set = 0; set < forces.sets.size(); ++set) {
        const auto first = 2 * static_cast<Eigen::Index>(set);
        const Eigen::Vector2d middle_m = 0.5 * (coils[2 * set].centre_m + coils[2 * set + 1].centre_m);
        forces.sets[set].place_m = inLattice_m(pose, middle_m);
        forces.sets[set].force_N = perAmpere.wrench.block<2, 2>(0, first) * current_A.segment<2>(first);
        forces.sum.force_N += forces.sets[set].force_N;
    }
    forces.sum.place_m = inLattice_m(pose, settings.massCentre_m);
    forces.torque_Nm = perAmpere.wrench.row(2).dot(current_A);
    return forces;
}

ChipFields_T fieldResidual_T(const PlatenSettings& settings, const PlanarPose& pose,
                             const ChipFields_T& field_T, const CoilCurrents_A& current_A) {
    ChipFields_T residual_T = models::correctedFields_T(settings.sensing, field_T, current_A);
    for (int j = 0; j < ChipCount; ++j) {
        const auto chip = static_cast<std::size_t>(j);
        residual_T.segment<2>(2 * j) -=
            models::chipField_T(settings.sensing.waveNumber_per_m, settings.sensing.amplitude_T[chip],
                                settings.sensing.place_m[chip], pose);
    }
    return residual_T;
}

std::array<int, 2> pitchCell(const PlanarPose& pose, double pitch_m) {
    return {static_cast<int>(std::lround(pose.x_m / pitch_m)),
            static_cast<int>(std::lround(pose.y_m / pitch_m))};
}

PlatenReach reachLeft(const Eigen::Vector3d& window, const PlanarPose& origin, const PlanarPose& pose) {
    const Eigen::Vector3d away(pose.x_m - origin.x_m, pose.y_m - origin.y_m,
                               pose.angle_rad - origin.angle_rad);
    return {window + away, window - away};
}

Eigen::Vector3d blockDirection(int column, int row) {
    constexpr std::array<double, 4> Cosine = {1.0, 0.0, -1.0, 0.0};
    constexpr std::array<double, 4> Sine = {0.0, 1.0, 0.0, -1.0};
    const auto i = static_cast<std::size_t>((column % 4 + 4) % 4);
    const auto j = static_cast<std::size_t>((row % 4 + 4) % 4);
    const Eigen::Vector3d sum(-Sine[i], -Sine[j], Cosine[i] + Cosine[j]);
    return sum.norm() > 0.5 ? Eigen::Vector3d(sum.normalized()) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

} // namespace halbench::widgets
