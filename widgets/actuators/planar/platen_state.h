#pragma once

#include "models/planar/planar_geometry.h"
#include "models/planar/planar_pose.h"
#include "models/planar/pose_estimator.h"
#include "widgets/actuators/actuator_view.h"

#include <Eigen/Core>
#include <array>
#include <optional>

namespace halbench::widgets {

/// Settings of the board that the picture of the platen depends on, SI; the published machine where the board
/// does not say. Source: resources/help/planar-theory.md section 3.
struct PlatenSettings {
    models::PlanarGeometry geometry;
    models::PoseSensing sensing; ///< calibration of the chips
    double forceConstant_N_per_A = -3.09772;
    Eigen::Vector2d massCentre_m = Eigen::Vector2d::Zero(); ///< platen axes
    double currentLimit_A = 1.0;
    double temperatureLimit_degC = 80.0;
    double liftLimit_N = 5.0;
    std::optional<Eigen::Vector3d> window; ///< +- x m, y m, phi rad from where a mode began; none: off
    bool isPositionMode = false;
};

PlatenSettings platenSettings(const ActuatorValues& values);

/// One set of latest readings; empty where the board sends none.
struct PlatenReadings {
    std::optional<models::PlanarPose> pose;
    std::optional<models::PlanarPose> reference; ///< while the board controls the position
    std::optional<models::PlanarPose> truth;     ///< of a simulation
    std::optional<models::CoilCurrents_A> current_A;
    std::array<std::optional<double>, models::CoilCount> temperature_degC;
    std::optional<models::ChipFields_T> field_T; ///< as the chips read it, before calibration
    models::ChipMask used = models::AllChips;
    std::optional<double> lift_N;
    std::optional<double> chiSquare;
    std::optional<double> currentScale; ///< below 1: the currents are at their limit
    bool isArmed = false;
    bool isHomed = false;
};

PlatenReadings platenReadings(const ActuatorValues& values, const PlatenSettings& settings);

/// A place of the platen in the lattice frame.
Eigen::Vector2d inLattice_m(const models::PlanarPose& pose, const Eigen::Vector2d& place_m);

/// A horizontal force and where it acts, lattice frame.
struct PlacedForce {
    Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d force_N = Eigen::Vector2d::Zero();
};

/// Forces of the sets of coils 1-2, 3-4 and 5-6, and their sum at the centre of mass, by the published model
/// with the board's force constant (resources/help/planar-theory.md section 5.1).
struct PlatenForces {
    std::array<PlacedForce, 3> sets;
    PlacedForce sum;
    double torque_Nm = 0.0; ///< about the platen's origin
};
PlatenForces platenForces(const PlatenSettings& settings, const models::PlanarPose& pose,
                          const models::CoilCurrents_A& current_A);

/// Calibrated readings minus the field that the pose predicts at the chips, platen axes.
models::ChipFields_T fieldResidual_T(const PlatenSettings& settings, const models::PlanarPose& pose,
                                     const models::ChipFields_T& field_T,
                                     const models::CoilCurrents_A& current_A);

/// Pitches from the cell of the lattice's origin; cells reach half a pitch to each side of a maximum of B_z.
std::array<int, 2> pitchCell(const models::PlanarPose& pose, double pitch_m);

/// Way that is left to the window's edges: x m, y m, phi rad, downwards and upwards, negative outside.
struct PlatenReach {
    Eigen::Vector3d down = Eigen::Vector3d::Zero();
    Eigen::Vector3d up = Eigen::Vector3d::Zero();
};
PlatenReach reachLeft(const Eigen::Vector3d& window, const models::PlanarPose& origin,
                      const models::PlanarPose& pose);

/// Direction in which the block of this column and row is magnetised, of length 1; zero: no block, both
/// arrays cancel. Blocks are a quarter of a pitch wide, (0, 0) lies at the lattice's origin:
///   M ~ (-sin(gamma x), -sin(gamma y), cos(gamma x) + cos(gamma y))
/// which has its field B_z = cos, B_x = sin on the upper side (resources/help/planar-theory.md section 4).
Eigen::Vector3d blockDirection(int column, int row);

} // namespace halbench::widgets
