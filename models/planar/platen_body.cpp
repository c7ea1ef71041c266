#include "models/planar/platen_body.h"

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

using Eigen::Vector2d;

Vector2d turned(const Vector2d& vector, double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return {c * vector.x() - s * vector.y(), s * vector.x() + c * vector.y()};
}

Vector2d quarterTurned(const Vector2d& vector) {
    return {-vector.y(), vector.x()};
}

double cross(const Vector2d& arm, const Vector2d& force) {
    return arm.x() * force.y() - arm.y() * force.x();
}

// The motion of the centre of mass.
struct Motion {
    Vector2d place_m;
    Vector2d speed_m_s;
    double angle_rad = 0.0;
    double turning_rad_s = 0.0;

    void drift(double t) {
        place_m += t * speed_m_s;
        angle_rad += t * turning_rad_s;
    }
};

Motion motionOf(const PlatenConfig& config, const PlatenState& state) {
    const Vector2d arm_m = turned(config.massCentre_m, state.pose.angle_rad);
    return {Vector2d(state.pose.x_m, state.pose.y_m) + arm_m,
            Vector2d(state.velocity.x_m_s, state.velocity.y_m_s) +
                state.velocity.angle_rad_s * quarterTurned(arm_m),
            state.pose.angle_rad, state.velocity.angle_rad_s};
}

PlatenState stateOf(const PlatenConfig& config, const Motion& motion) {
    const Vector2d arm_m = turned(config.massCentre_m, motion.angle_rad);
    const Vector2d place_m = motion.place_m - arm_m;
    const Vector2d speed_m_s = motion.speed_m_s - motion.turning_rad_s * quarterTurned(arm_m);
    return {{place_m.x(), place_m.y(), motion.angle_rad},
            {speed_m_s.x(), speed_m_s.y(), motion.turning_rad_s}};
}

double beyond(double place, double travel) {
    return place - std::clamp(place, -travel, travel);
}

// A stop pushes, it never pulls.
double stopForce(double place, double speed, double travel, double stiffness, double damping) {
    const double depth = beyond(place, travel);
    const double force = -stiffness * depth - damping * speed;
    return depth > 0.0 ? std::min(force, 0.0) : depth < 0.0 ? std::max(force, 0.0) : 0.0;
}

Vector2d anchorTravel_m(const PlatenConfig& config, const PlanarPose& pose) {
    return Vector2d(pose.x_m, pose.y_m) + turned(config.anchor_m, pose.angle_rad) - config.anchor_m;
}

// Speed after t under a constant acceleration and damping of this rate.
template <typename Value>
Value damped(const Value& speed, const Value& acceleration, double rate_1_s, double t) {
    const double x = rate_1_s * t;
    const double mean = x > 0.0 ? -std::expm1(-x) / x : 1.0;
    return std::exp(-x) * speed + (t * mean) * acceleration;
}

} // namespace

PlanarPose middlePose(const PlatenConfig& config, const PlatenState& state, double step_s) {
    Motion motion = motionOf(config, state);
    motion.drift(0.5 * step_s);
    return stateOf(config, motion).pose;
}

void stepPlaten(const PlatenConfig& config, PlatenState& state, const PlanarWrench& coils,
                const Vector2d& slowForce_N, double step_s) {
    Motion motion = motionOf(config, state);
    motion.drift(0.5 * step_s);
    const PlatenState middle = stateOf(config, motion);
    const PlanarPose& pose = middle.pose;
    const Vector2d arm_m = turned(config.massCentre_m, pose.angle_rad);

    Vector2d origin_N(coils.forceX_N, coils.forceY_N); // forces that act at C
    origin_N.x() += stopForce(pose.x_m, middle.velocity.x_m_s, config.travel_m, config.stopStiffness_N_per_m,
                              config.stopDamping_Ns_per_m);
    origin_N.y() += stopForce(pose.y_m, middle.velocity.y_m_s, config.travel_m, config.stopStiffness_N_per_m,
                              config.stopDamping_Ns_per_m);
    const Vector2d cable_N = slowForce_N - config.cableStiffness_N_per_m * anchorTravel_m(config, pose);
    const Vector2d anchorArm_m = turned(config.anchor_m, pose.angle_rad) - arm_m;
    const double torque_Nm = coils.torque_Nm - cross(arm_m, origin_N) + cross(anchorArm_m, cable_N) -
                             config.cableTorsion_Nm_per_rad * pose.angle_rad +
                             stopForce(pose.angle_rad, middle.velocity.angle_rad_s, config.travel_rad,
                                       config.stopStiffness_Nm_per_rad, config.stopDamping_Nms_per_rad);

    motion.speed_m_s = damped<Vector2d>(motion.speed_m_s, (origin_N + cable_N) / config.mass_kg,
                                        config.damping_Ns_per_m / config.mass_kg, step_s);
    motion.turning_rad_s = damped(motion.turning_rad_s, torque_Nm / config.inertia_kg_m2,
                                  config.damping_Nms_per_rad / config.inertia_kg_m2, step_s);
    motion.drift(0.5 * step_s);
    state = stateOf(config, motion);
}

double kineticEnergy_J(const PlatenConfig& config, const PlatenState& state) {
    const Motion motion = motionOf(config, state);
    return 0.5 * config.mass_kg * motion.speed_m_s.squaredNorm() +
           0.5 * config.inertia_kg_m2 * motion.turning_rad_s * motion.turning_rad_s;
}

double springEnergy_J(const PlatenConfig& config, const PlatenState& state) {
    const double x_m = beyond(state.pose.x_m, config.travel_m);
    const double y_m = beyond(state.pose.y_m, config.travel_m);
    const double angle_rad = beyond(state.pose.angle_rad, config.travel_rad);
    return 0.5 * config.cableStiffness_N_per_m * anchorTravel_m(config, state.pose).squaredNorm() +
           0.5 * config.cableTorsion_Nm_per_rad * state.pose.angle_rad * state.pose.angle_rad +
           0.5 * config.stopStiffness_N_per_m * (x_m * x_m + y_m * y_m) +
           0.5 * config.stopStiffness_Nm_per_rad * angle_rad * angle_rad;
}

} // namespace halbench::models
