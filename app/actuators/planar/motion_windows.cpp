#include "app/actuators/planar/motion_windows.h"

#include "control/base/units.h"
#include "models/planar/wrench_map.h"

#include <cmath>
#include <utility>

namespace halbench::app {
namespace {

using models::CoilCount;

constexpr std::size_t WindowRows = 400; // 0.4 s at 1 kHz
constexpr std::size_t ErrorStride = 4;
// Below these speeds the sign of a motion blurs into noise.
constexpr std::array<double, 3> SlowSpeeds = {5e-3, 5e-3, 10e-3};

// sin^2(pi s) times 1, cos 2 pi l s or sin 2 pi l s, with its derivatives.
struct TestFunction {
    double value, slope, curvature;
};

TestFunction testFunction(int index, double s, double length_s) {
    const double w = std::pow(std::sin(Pi * s), 2);
    const double w1 = Pi * std::sin(2.0 * Pi * s);
    const double w2 = 2.0 * Pi * Pi * std::cos(2.0 * Pi * s);
    const double omega = 2.0 * Pi * ((index + 1) / 2);
    const bool isSine = index % 2 == 0 && index > 0;
    const double v = isSine ? std::sin(omega * s) : std::cos(omega * s);
    const double v1 = omega * (isSine ? std::cos(omega * s) : -std::sin(omega * s));
    const double v2 = -omega * omega * v;
    return {w * v, (w1 * v + w * v1) / length_s, (w2 * v + 2.0 * w1 * v1 + w * v2) / (length_s * length_s)};
}

Eigen::Vector3d vectorOf(const models::PlanarPose& pose) {
    return {pose.x_m, pose.y_m, pose.angle_rad};
}

class Windows {
public:
    Windows(const PlatenMotion& motion, const std::vector<models::PlanarPose>& poses,
            const models::PlanarGeometry& geometry, const PoseErrors& errors)
        : m_motion(motion), m_errors(errors), m_map(models::WrenchModel::Windings, geometry) {
        for (const models::PlanarPose& pose : poses) {
            m_pose.push_back(vectorOf(pose));
        }
        build();
    }

    MotionWindows result() && { return {std::move(m_windows), m_leftOut}; }

private:
    double period_s() const { return m_motion.recording.layout->period_s; }

    bool isWhole(std::size_t first) const {
        const std::vector<double>& time_s = m_motion.recording.time_s;
        return std::fabs(time_s[first + WindowRows] - time_s[first] -
                         static_cast<double>(WindowRows) * period_s()) < 0.5 * period_s();
    }

    // Without current nothing is to be learnt of the coils, and a platen that is braked has other rules.
    bool isDriven(std::size_t first) const {
        for (std::size_t n = first; n <= first + WindowRows; ++n) {
            if (m_motion.current_A[n].cwiseAbs().maxCoeff() > 0.0) {
                return true;
            }
        }
        return false;
    }

    void build() {
        for (std::size_t first = 20; first + WindowRows + 20 < m_pose.size(); first += WindowRows) {
            if (!isWhole(first)) {
                ++m_leftOut;
            } else if (isDriven(first)) {
                m_windows.push_back(window(first));
                addErrors(m_windows.back(), first);
            }
        }
    }

    // Over 20 ms: the noise of one sample would hide the sign.
    Eigen::Vector3d speedAt(std::size_t n) const {
        constexpr std::size_t Half = 10;
        return (m_pose[n + Half] - m_pose[n - Half]) / (2.0 * static_cast<double>(Half) * period_s());
    }

    Window window(std::size_t first) const {
        const double dt = period_s();
        const double length_s = static_cast<double>(WindowRows) * dt;
        Window result;
        for (Moments& moments : result.moments) {
            moments.acceleration.setZero();
            moments.speed.setZero();
            moments.place.setZero();
            moments.sign.setZero();
            moments.force.setZero();
            moments.forceRate.setZero();
        }
        for (std::size_t n = 0; n < WindowRows; ++n) {
            const Eigen::Vector3d& pose = m_pose[first + n];
            const Eigen::Vector3d middle = 0.5 * (pose + m_pose[first + n + 1]);
            const Eigen::Vector3d speed = speedAt(first + n);
            Eigen::Matrix<double, 3, CoilCount> force = m_map.at({middle.x(), middle.y(), middle.z()}).wrench;
            for (int k = 0; k < CoilCount; ++k) {
                force.col(k) *= m_motion.current_A[first + n](k);
            }
            Eigen::Vector3d sign;
            for (int i = 0; i < 3; ++i) {
                sign(i) = std::tanh(speed(i) / SlowSpeeds[static_cast<std::size_t>(i)]);
            }
            for (int f = 0; f < WindowFunctions; ++f) {
                Moments& moments = result.moments[static_cast<std::size_t>(f)];
                const auto at = testFunction(f, static_cast<double>(n) / WindowRows, length_s);
                const auto mid = testFunction(f, (static_cast<double>(n) + 0.5) / WindowRows, length_s);
                // The curvature does not vanish at the ends: half of each belongs to the window.
                moments.acceleration +=
                    dt * at.curvature * (n == 0 ? 0.5 * (pose + m_pose[first + WindowRows]) : pose);
                moments.speed -= dt * at.slope * pose;
                moments.place += dt * at.value * pose;
                moments.sign += dt * at.value * sign;
                moments.one += dt * at.value;
                moments.force += dt * mid.value * force; // held from row to row
                moments.forceRate -= dt * mid.slope * force;
            }
        }
        return result;
    }

    void addErrors(Window& result, std::size_t first) const {
        if (!m_errors.sensitivity) {
            return;
        }
        const double dt = period_s();
        const double length_s = static_cast<double>(WindowRows) * dt;
        result.errors.resize(WindowFunctions);
        // Changes of the pose are smooth: every other row tells them.
        for (std::size_t n = 0; n <= WindowRows; n += ErrorStride) {
            const double share = static_cast<double>(ErrorStride) * (n == 0 || n == WindowRows ? 0.5 : 1.0);
            const PoseSensitivity change = (share * dt) * m_errors.sensitivity(first + n);
            for (int f = 0; f < WindowFunctions; ++f) {
                const auto at = testFunction(f, static_cast<double>(n) / WindowRows, length_s);
                ErrorMoments& moments = result.errors[static_cast<std::size_t>(f)];
                moments.acceleration += at.curvature * change;
                moments.speed -= at.slope * change;
                moments.place += at.value * change;
            }
        }
    }

    const PlatenMotion& m_motion;
    const PoseErrors& m_errors;
    models::WrenchMap m_map;
    std::vector<Eigen::Vector3d> m_pose;
    std::vector<Window> m_windows;
    int m_leftOut = 0;
};

} // namespace

MotionWindows integrateWindows(const PlatenMotion& motion, const std::vector<models::PlanarPose>& poses,
                               const models::PlanarGeometry& geometry, const PoseErrors& errors) {
    return std::move(Windows(motion, poses, geometry, errors)).result();
}

} // namespace halbench::app
