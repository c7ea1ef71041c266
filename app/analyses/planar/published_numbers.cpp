#include "app/analyses/planar/published_numbers.h"

#include "models/planar/published_wrench.h"
#include "models/planar/windings_wrench.h"

#include <Eigen/Core>
#include <cmath>

namespace halbench::app {
namespace {

using Numbers = std::vector<PublishedNumber>;

// Section 3: published constants that the models do not need.
constexpr double Current_A = 1.0;
constexpr double Resistance_Ohm = 1.98;
constexpr double BearingStiffness_N_per_m = 1.7e7;
constexpr double PrintedForce_N = 4.4;
constexpr double Mass_kg = 0.64;
constexpr double CoilMass_kg = 0.042;
constexpr double OutlineX_m = 0.1854;
constexpr double OutlineY_m = 0.1579;

void addForces(const models::PlanarGeometry& geometry, Numbers& numbers) {
    const double published = models::publishedForceConstant_N_per_A(geometry);
    const double windings = models::windingsForceConstant_N_per_A(geometry);
    const auto percent = [&](auto constant, int order) {
        return 100.0 * std::fabs(constant(geometry, order) / constant(geometry, 1));
    };
    numbers.push_back({"published_force_constant_N_per_A", published});
    numbers.push_back({"windings_force_constant_N_per_A", windings});
    numbers.push_back({"corners_force_percent", 100.0 * (windings / published - 1.0)});
    numbers.push_back(
        {"published_fifth_percent", percent(models::publishedForceConstant_N_per_A, 5), "0.950"});
    numbers.push_back(
        {"published_ninth_percent", percent(models::publishedForceConstant_N_per_A, 9), "0.010"});
    numbers.push_back({"windings_fifth_percent", percent(models::windingsForceConstant_N_per_A, 5)});
    numbers.push_back({"windings_ninth_percent", percent(models::windingsForceConstant_N_per_A, 9)});
    // Two phases in quadrature, each with the largest current, where both push evenly.
    numbers.push_back({"largest_set_force_N", std::sqrt(2.0) * std::fabs(published) * Current_A, "4.4"});
}

/// What the printed subscripts would make of the forces: harmonics with the amplitude of the fundamental, a
/// commutation that takes the pose for the base coordinate of coil 1.
void addSubscripts(const models::PlanarGeometry& geometry, Numbers& numbers) {
    constexpr int Fifth = 5;
    constexpr double Surface_m = 0.0;
    const double amplitude = models::harmonicAmplitude_T(geometry.matrix, 1, Surface_m) /
                             models::harmonicAmplitude_T(geometry.matrix, Fifth, Surface_m);
    const double fifth = models::publishedForceConstant_N_per_A(geometry, Fifth) /
                         models::publishedForceConstant_N_per_A(geometry, 1);
    const double base_rad = models::waveNumber_per_m(geometry.matrix) * geometry.coils().front().centre_m.y();
    numbers.push_back({"fifth_of_one_amplitude_percent", 100.0 * std::fabs(amplitude * fifth), "0.950"});
    numbers.push_back({"force_without_base_percent", 100.0 * std::cos(base_rad)});
}

/// The inner corner of a coil's window, in platen axes: the base point of its phase.
Eigen::Vector2d basePoint_m(const models::PlanarGeometry& geometry, const models::PlanarCoil& coil) {
    const double pitch_m = geometry.matrix.pitch_m;
    const double along_m = -0.5 * (pitch_m - geometry.winding.width_m);
    const double across_m = -0.5 * (0.5 * pitch_m - geometry.winding.width_m);
    const Eigen::Vector2d corner_m =
        coil.isAcross ? Eigen::Vector2d(-across_m, along_m) : Eigen::Vector2d(along_m, across_m);
    return coil.centre_m + corner_m;
}

/// The printed distances between the coils, from base point to base point.
void addBasePoints(const models::PlanarGeometry& geometry, Numbers& numbers) {
    const auto coils = geometry.coils();
    const double pitch_m = geometry.matrix.pitch_m;
    const auto base_m = [&](std::size_t coil) { return basePoint_m(geometry, coils[coil - 1]); };
    numbers.push_back({"base_points_6_1_pitches", (base_m(6).x() - base_m(1).x()) / pitch_m, "3/4"});
    numbers.push_back({"base_points_5_6_pitches", (base_m(5).x() - base_m(6).x()) / pitch_m, "5/4"});
    numbers.push_back({"base_points_1_2_pitches", (base_m(1).y() - base_m(2).y()) / pitch_m, "3/4"});
    numbers.push_back(
        {"centres_6_1_pitches", (coils[5].centre_m.x() - coils[0].centre_m.x()) / pitch_m, "3/4"});
}

/// Force and torque of one coil by the field at its middle and by the arm from there, N/A and N m/A.
Eigen::Vector2d coilAtItsPlace(const models::PlanarGeometry& geometry, const models::PlanarCoil& coil,
                               const models::PlanarPose& pose) {
    const double at_m = coil.isAcross ? pose.x_m + coil.centre_m.x() : pose.y_m + coil.centre_m.y();
    const double arm_m = coil.isAcross ? -coil.centre_m.y() : coil.centre_m.x();
    const double force_N_per_A = coil.sense * models::publishedForceConstant_N_per_A(geometry) *
                                 std::sin(models::waveNumber_per_m(geometry.matrix) * at_m);
    return {force_N_per_A, arm_m * force_N_per_A};
}

/// The printed phases and torque signs against the places of the coils: largest difference over a cell.
void addChain(const models::PlanarGeometry& geometry, Numbers& numbers) {
    constexpr int Points = 16;
    const auto coils = geometry.coils();
    const models::PublishedWrench published(geometry);
    const double step_m = geometry.matrix.pitch_m / Points;
    Eigen::Vector2d largest = Eigen::Vector2d::Zero();
    for (int i = 0; i < Points * Points; ++i) {
        const models::PlanarPose pose{step_m * (i % Points), step_m * (i / Points), 0.0};
        const auto printed = published.at(pose).wrench;
        for (int k = 0; k < models::CoilCount; ++k) {
            const models::PlanarCoil& coil = coils[static_cast<std::size_t>(k)];
            const Eigen::Vector2d given(printed(coil.isAcross ? 0 : 1, k), printed(2, k));
            largest = largest.cwiseMax((given - coilAtItsPlace(geometry, coil, pose)).cwiseAbs());
        }
    }
    numbers.push_back({"phase_chain_N_per_A", largest.x()});
    numbers.push_back({"torque_signs_Nm_per_A", largest.y()});
}

/// Of the printed bound of the eddy currents' field at the chips.
void addEddyField(const models::PlanarGeometry& geometry, Numbers& numbers) {
    constexpr double Eddy_T = 0.06e-3;
    constexpr double Chip_T = 20e-3;
    numbers.push_back({"eddy_field_percent", 100.0 * Eddy_T / Chip_T});
    numbers.push_back(
        {"eddy_position_um", 1e6 * Eddy_T / (models::waveNumber_per_m(geometry.matrix) * Chip_T)});
}

/// Over the gradient of Bz: zero with the signs of the potential, and with the printed sign of the in-plane
/// field.
void addField(const models::PlanarGeometry& geometry, Numbers& numbers) {
    const Eigen::Vector3d above{0.0, 0.0, 3e-3};
    numbers.push_back(
        {"peak_field_fundamental_T", models::matrixField_T(geometry.matrix, above, 1).z(), "0.7"});
    constexpr int AllOrders = 20; // the last one has e^-27 of the field
    numbers.push_back({"peak_field_T", models::matrixField_T(geometry.matrix, above, AllOrders).z(), "0.7"});
    const Eigen::Matrix3d gradient =
        models::matrixFieldGradient_T_per_m(geometry.matrix, {4e-3, -9e-3, 5e-3});
    const double inPlane = gradient(0, 0) + gradient(1, 1);
    const double vertical = gradient(2, 2);
    numbers.push_back({"divergence_ratio", std::fabs((vertical + inPlane) / vertical)});
    numbers.push_back({"divergence_printed_sign_ratio", std::fabs((vertical - inPlane) / vertical)});
}

void addBearings(const models::PlanarGeometry& geometry, Numbers& numbers) {
    const double sink_m = PrintedForce_N / BearingStiffness_N_per_m;
    const auto coils = geometry.coils();
    const double arm_m = 0.75 * geometry.matrix.pitch_m;
    // From the middle of the pair that pushes along x to that of the pairs that push along y.
    const double across_m = geometry.arm56_m - 0.5 * (coils[0].centre_m.y() + coils[1].centre_m.y());
    numbers.push_back({"bearing_deflection_um", 1e6 * sink_m, "0.26"});
    numbers.push_back({"tilt_about_y_urad", 1e6 * sink_m / arm_m, "6.8"});
    numbers.push_back({"tilt_about_x_urad", 1e6 * 2.0 * sink_m / across_m, "7.4"});
}

void addPower(Numbers& numbers) {
    const double direct_W = models::CoilCount * Resistance_Ohm * Current_A * Current_A;
    numbers.push_back({"power_sinusoidal_W", 0.5 * direct_W, "5.94"});
    numbers.push_back({"power_direct_W", direct_W});
}

void addSpeeds(Numbers& numbers) {
    numbers.push_back({"ramp_speed_x_m_s", 0.438 * 0.24, "0.105"});
    numbers.push_back({"ramp_speed_y_m_s", 0.956 * 0.17, "0.163"});
}

/// Of the coils alone, less than the whole: frames of their mean turn, L by L/2, about whose middle the mass
/// has 3 L^2/16. Of the platen as an even plate.
void addInertia(const models::PlanarGeometry& geometry, Numbers& numbers) {
    const double pitch_m = geometry.matrix.pitch_m;
    double coils = 0.0;
    for (const models::PlanarCoil& coil : geometry.coils()) {
        coils += CoilMass_kg * (coil.centre_m.squaredNorm() + 3.0 / 16.0 * pitch_m * pitch_m);
    }
    const double plate = Mass_kg * (OutlineX_m * OutlineX_m + OutlineY_m * OutlineY_m) / 12.0;
    numbers.push_back({"coils_inertia_kg_m2", coils, "0.001 of the whole"});
    numbers.push_back({"plate_inertia_kg_m2", plate, "0.001 of the whole"});
}

} // namespace

std::vector<PublishedNumber> publishedNumbers(const models::PlanarGeometry& geometry) {
    Numbers numbers;
    addForces(geometry, numbers);
    addSubscripts(geometry, numbers);
    addBasePoints(geometry, numbers);
    addChain(geometry, numbers);
    addField(geometry, numbers);
    addBearings(geometry, numbers);
    addPower(numbers);
    addSpeeds(numbers);
    addInertia(geometry, numbers);
    addEddyField(geometry, numbers);
    return numbers;
}

} // namespace halbench::app
