#include "models/spherical/rotor_motion.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

constexpr double GoldenRatio = 1.6180339887498949;

Eigen::Matrix3d between(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to, double share) {
    return rotationOfVector(share * vectorOfRotation(to * from.transpose())) * from;
}

} // namespace

ShaftDirection publishedShaft(int trajectory, double sample) {
    HB_ASSERT(trajectory >= 1 && trajectory <= 4);
    const double turned_rad = std::fmod(degreesToRadians(12.0 * sample), 2.0 * Pi);
    const double tilted_rad = degreesToRadians(3.0 * sample);
    switch (trajectory) {
    case 1:
        return {tilted_rad, 0.0};
    case 2:
        return {tilted_rad, 0.5 * Pi};
    case 3:
        return {0.25 * Pi, turned_rad};
    default:
        return {tilted_rad, turned_rad};
    }
}

bool isInWorkspace(const OrientationAngles& angles) {
    // The border belongs to it: trajectory 3 touches beta = -45 degrees up to rounding.
    constexpr double Tilt = 0.25 * Pi + 1e-12;
    return std::abs(angles.alpha_rad) <= Tilt && std::abs(angles.beta_rad) <= Tilt &&
           std::abs(angles.gamma_rad) <= 0.5 * Pi + 1e-12;
}

Result<void> checkRotorMotion(const RotorMotionConfig& config) {
    const auto isFinite = [](const OrientationAngles& angles) {
        return std::isfinite(angles.alpha_rad + angles.beta_rad + angles.gamma_rad);
    };
    if (!isFinite(config.start) || !std::isfinite(config.rate_rad_s) || !std::isfinite(config.spin_rad) ||
        !std::isfinite(config.sampleTime_s) || !std::isfinite(config.tilt_rad) ||
        !std::isfinite(config.tumbleFrequency_Hz) || !std::isfinite(config.walk_rad_per_rootS)) {
        return failure(ErrorCode::NotFinite, "A number of the rotor's motion is not finite.");
    }
    if (config.rate_rad_s <= 0.0 || config.sampleTime_s <= 0.0 || config.tilt_rad <= 0.0 ||
        config.tilt_rad > Pi || config.tumbleFrequency_Hz < 0.0 || config.walk_rad_per_rootS < 0.0) {
        return failure(
            ErrorCode::OutOfRange,
            "The rotor's motion needs a positive rate, sample time and tilt of at most 180 degrees.");
    }
    if (config.kind == MotionKind::Table && config.table.empty()) {
        return failure(ErrorCode::OutOfRange, "The table of poses is empty.");
    }
    for (std::size_t i = 0; i < config.table.size(); ++i) {
        if (!isFinite(config.table[i].angles) || !std::isfinite(config.table[i].time_s)) {
            return failure(ErrorCode::NotFinite,
                           fmt::format("Row {} of the table of poses is not finite.", i + 1));
        }
        if (i > 0 && config.table[i].time_s <= config.table[i - 1].time_s) {
            return failure(ErrorCode::OutOfRange,
                           fmt::format("The time does not increase in row {} of the table of poses.", i + 1));
        }
    }
    return {};
}

RotorMotion::RotorMotion(const RotorMotionConfig& config, std::uint64_t seed)
    : m_config(config), m_random(seed), m_target(rotationOf(config.start)), m_rotation(m_target) {
    m_rotation = at(0.0);
}

Eigen::Matrix3d RotorMotion::published(double time_s) const {
    const int trajectory = static_cast<int>(m_config.kind) - static_cast<int>(MotionKind::Published1) + 1;
    double sample = 1.0 + time_s / m_config.sampleTime_s;
    if (m_config.kind != MotionKind::Published3) { // there and back again; 3 closes by itself
        constexpr double Way = PublishedSamples - 1.0;
        const double along = std::fmod(sample - 1.0, 2.0 * Way);
        sample = 1.0 + (along > Way ? 2.0 * Way - along : along);
    }
    return rotationOf(anglesForShaft(publishedShaft(trajectory, sample), m_config.spin_rad));
}

Eigen::Matrix3d RotorMotion::tabled(double time_s) const {
    const auto& table = m_config.table;
    const auto next = std::upper_bound(table.begin(), table.end(), time_s,
                                       [](double time, const auto& row) { return time < row.time_s; });
    if (next == table.begin()) {
        return rotationOf(table.front().angles);
    }
    if (next == table.end()) {
        return rotationOf(table.back().angles);
    }
    const auto& last = *(next - 1);
    const double share = (time_s - last.time_s) / (next->time_s - last.time_s);
    return between(rotationOf(last.angles), rotationOf(next->angles), share);
}

Eigen::Matrix3d RotorMotion::at(double time_s) const {
    switch (m_config.kind) {
    case MotionKind::Published1:
    case MotionKind::Published2:
    case MotionKind::Published3:
    case MotionKind::Published4:
        return published(time_s);
    case MotionKind::Tumble: {
        const double phase_rad = 2.0 * Pi * m_config.tumbleFrequency_Hz * time_s;
        return rotationOf({m_config.tilt_rad * std::sin(phase_rad),
                           m_config.tilt_rad * std::sin(GoldenRatio * phase_rad),
                           m_config.rate_rad_s * time_s});
    }
    case MotionKind::Table:
        return tabled(time_s);
    case MotionKind::SetPoint:
    case MotionKind::RandomWalk:
        break;
    }
    return m_rotation;
}

Eigen::Matrix3d RotorMotion::towardsTarget(double step_s) const {
    const Eigen::Vector3d way_rad = vectorOfRotation(m_target * m_rotation.transpose());
    const double reach_rad = m_config.rate_rad_s * step_s;
    if (way_rad.norm() <= reach_rad) {
        return m_target;
    }
    return rotationOfVector(reach_rad * way_rad.normalized()) * m_rotation;
}

Eigen::Matrix3d RotorMotion::walked(double step_s) {
    Eigen::Vector3d turn_rad;
    for (double& entry : turn_rad) {
        entry = m_config.walk_rad_per_rootS * std::sqrt(step_s) * m_random.gaussian();
    }
    const Eigen::Matrix3d next = rotationOfVector(turn_rad) * m_rotation;
    // Beyond the tilt only steps that lead back are made.
    return next(2, 2) >= std::min(std::cos(m_config.tilt_rad), m_rotation(2, 2)) ? next : m_rotation;
}

void RotorMotion::turnTo(const OrientationAngles& target, double rate_rad_s) {
    HB_ASSERT(rate_rad_s > 0.0);
    m_config.kind = MotionKind::SetPoint;
    m_config.rate_rad_s = rate_rad_s;
    m_target = rotationOf(target);
}

void RotorMotion::setRate(double rate_rad_s) {
    HB_ASSERT(rate_rad_s > 0.0);
    if (m_config.kind == MotionKind::SetPoint) {
        m_config.rate_rad_s = rate_rad_s;
    }
}

void RotorMotion::advance(double step_s) {
    const Eigen::Matrix3d before = m_rotation;
    m_time_s += step_s;
    if (m_config.kind == MotionKind::SetPoint) {
        m_rotation = towardsTarget(step_s);
    } else if (m_config.kind == MotionKind::RandomWalk) {
        m_rotation = walked(step_s);
    } else {
        m_rotation = at(m_time_s);
    }
    // Many products of rotations drift: back to a rotation by the next one's first order.
    m_rotation = 0.5 * m_rotation * (3.0 * Eigen::Matrix3d::Identity() - m_rotation.transpose() * m_rotation);
    m_rate_rad_s = vectorOfRotation(m_rotation * before.transpose()) / step_s;
}

} // namespace halbench::models
