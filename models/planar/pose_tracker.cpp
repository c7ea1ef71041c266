#include "models/planar/pose_tracker.h"

#include <Eigen/Cholesky>

namespace halbench::models {
namespace {

using Matrix9 = Eigen::Matrix<double, 9, 9>;

Eigen::Vector3d square(const Eigen::Vector3d& vector) {
    return vector.cwiseProduct(vector);
}

} // namespace

PoseTrackerState startTracker(const PoseTrackerConfig& config, const PoseEstimate& estimate) {
    // Nothing is known of the motion: 0.2 m/s and 2 rad/s; the disturbance as after a second of its walk.
    PoseTrackerState state;
    state.mean.head<3>() << estimate.pose.x_m, estimate.pose.y_m, estimate.pose.angle_rad;
    state.covariance.topLeftCorner<3, 3>() = estimate.covariance;
    state.covariance.diagonal().segment<3>(3) = square({0.2, 0.2, 2.0});
    state.covariance.diagonal().tail<3>() =
        square({config.disturbance_m_s2_per_rts, config.disturbance_m_s2_per_rts,
                config.disturbance_rad_s2_per_rts});
    return state;
}

void predict(const PoseTrackerConfig& config, PoseTrackerState& state, const Eigen::Vector3d& acceleration) {
    const double T = config.period_s;
    const double half = 0.5 * T * T;
    const Eigen::Vector3d total = acceleration + state.mean.tail<3>();
    state.mean.head<3>() += T * state.mean.segment<3>(3) + half * total;
    state.mean.segment<3>(3) += T * total;

    Matrix9 F = Matrix9::Identity();
    F.block<3, 3>(0, 3).diagonal().setConstant(T);
    F.block<3, 3>(0, 6).diagonal().setConstant(half);
    F.block<3, 3>(3, 6).diagonal().setConstant(T);
    state.covariance = F * state.covariance * F.transpose();
    const Eigen::Vector3d white =
        square({config.acceleration_m_s2, config.acceleration_m_s2, config.acceleration_rad_s2});
    const Eigen::Vector3d walk = square({config.disturbance_m_s2_per_rts, config.disturbance_m_s2_per_rts,
                                         config.disturbance_rad_s2_per_rts});
    state.covariance.block<3, 3>(0, 0).diagonal() += half * half * white;
    state.covariance.block<3, 3>(0, 3).diagonal() += half * T * white;
    state.covariance.block<3, 3>(3, 0).diagonal() += half * T * white;
    state.covariance.block<3, 3>(3, 3).diagonal() += T * T * white;
    state.covariance.block<3, 3>(6, 6).diagonal() += T * walk;
}

PoseInnovation update(const PoseSensing& sensing, PoseTrackerState& state, const ChipFields_T& field_T,
                      const ChipMask& used) {
    Eigen::Matrix<double, FieldCount, 3> J = Eigen::Matrix<double, FieldCount, 3>::Zero();
    ChipFields_T innovation = ChipFields_T::Zero();
    PoseInnovation result;
    for (std::size_t j = 0; j < used.size(); ++j) {
        if (used[j]) {
            const auto row = 2 * static_cast<Eigen::Index>(j);
            const ChipFieldSlope model = chipFieldSlope(sensing.waveNumber_per_m, sensing.amplitude_T[j],
                                                        sensing.place_m[j], state.pose());
            J.middleRows<2>(row) = model.slope;
            innovation.segment<2>(row) = field_T.segment<2>(row) - model.field_T;
            result.freedom += 2;
        }
    }
    // A chip left out has a row of zeros: its variance stays that of the noise, its gain zero.
    const double variance_T2 = sensing.deviation_T * sensing.deviation_T;
    Eigen::Matrix<double, FieldCount, FieldCount> S =
        J * state.covariance.topLeftCorner<3, 3>() * J.transpose();
    S.diagonal().array() += variance_T2;
    const Eigen::LLT<Eigen::Matrix<double, FieldCount, FieldCount>> solver(S);
    const Eigen::Matrix<double, 9, FieldCount> cross = state.covariance.leftCols<3>() * J.transpose();
    const Eigen::Matrix<double, 9, FieldCount> K = solver.solve(cross.transpose()).transpose();
    state.mean += K * innovation;
    Matrix9 kept = Matrix9::Identity();
    kept.leftCols<3>() -= K * J;
    state.covariance = (kept * state.covariance * kept.transpose() + variance_T2 * K * K.transpose()).eval();
    result.chiSquare = innovation.dot(solver.solve(innovation));
    return result;
}

} // namespace halbench::models
