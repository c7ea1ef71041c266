#pragma once

#include "control/base/random.h"
#include "control/base/result.h"
#include "models/spherical/orientation.h"

#include <array>
#include <string_view>
#include <vector>

namespace halbench::models {

/// Shaft of the published trajectories at sample k = 1 ... 25 (and between): 1: Phi 0, Theta 3k degrees; 2:
/// Phi 90, Theta 3k; 3: Theta 45, Phi 12k; 4: Theta 3k, Phi 12k. Trajectory 1 ... 4.
constexpr int PublishedSamples = 25;
ShaftDirection publishedShaft(int trajectory, double sample);

/// Whether a pose lies in the published workspace: |alpha|, |beta| < 45 degrees, |gamma| <= 90 degrees.
bool isInWorkspace(const OrientationAngles& angles);

enum class MotionKind {
    SetPoint,   ///< turns to the target on the shortest way, at most at the given rate
    Published1, ///< along the samples and back, the shaft's angles linear between them
    Published2,
    Published3, ///< round and round
    Published4,
    Tumble,     ///< alpha, beta = tilt sin(2 pi f t) with two frequencies, gamma at a constant rate
    RandomWalk, ///< diffusion on the rotations; the shaft stays within the tilt
    Table,      ///< poses by time, on the shortest way between them, the last one held
};
inline constexpr std::array<std::string_view, 8> MotionNames = {
    "setpoint", "published1", "published2", "published3", "published4", "tumble", "walk", "table"};

struct TimedOrientation {
    double time_s = 0.0;
    OrientationAngles angles;
};

struct RotorMotionConfig {
    MotionKind kind = MotionKind::SetPoint;
    OrientationAngles start;         ///< first target; start of the random walk
    double rate_rad_s = 1.0;         ///< largest rate towards a set-point; spin of the tumbling motion
    double spin_rad = 0.0;           ///< gamma of the published trajectories, which do not give it
    double sampleTime_s = 0.1;       ///< between two published samples
    double tilt_rad = 0.6981317;     ///< 40 degrees
    double tumbleFrequency_Hz = 0.2; ///< of alpha; beta has the golden ratio of it
    double walk_rad_per_rootS = 0.5; ///< rms of each axis after one second
    std::vector<TimedOrientation> table;
};

/// OutOfRange or NotFinite: rates, times or a tilt that are not positive, a table that is empty or whose
/// times do not rise.
Result<void> checkRotorMotion(const RotorMotionConfig& config);

/// Prescribed motion of the rotor: nothing drives it, it is where it is told to be. Same configuration and
/// seed give the same motion. Source: resources/help/spherical-theory.md sections 2 and 9.
class RotorMotion {
public:
    /// The configuration is checked.
    RotorMotion(const RotorMotionConfig& config, std::uint64_t seed);

    const Eigen::Matrix3d& rotation() const { return m_rotation; }
    /// Mean over the last step, stator frame.
    const Eigen::Vector3d& rate_rad_s() const { return m_rate_rad_s; }
    double time_s() const { return m_time_s; }
    /// From now on, whatever the motion was: towards the target, at most at the rate (positive).
    void turnTo(const OrientationAngles& target, double rate_rad_s);
    /// Largest rate towards a set-point (positive), now or later; another motion goes on as it is.
    void setRate(double rate_rad_s);
    void advance(double step_s);

private:
    Eigen::Matrix3d at(double time_s) const;
    Eigen::Matrix3d published(double time_s) const;
    Eigen::Matrix3d tabled(double time_s) const;
    Eigen::Matrix3d towardsTarget(double step_s) const;
    Eigen::Matrix3d walked(double step_s);

    RotorMotionConfig m_config;
    Random m_random;
    double m_time_s = 0.0;
    Eigen::Matrix3d m_target;
    Eigen::Matrix3d m_rotation;
    Eigen::Vector3d m_rate_rad_s = Eigen::Vector3d::Zero();
};

} // namespace halbench::models
