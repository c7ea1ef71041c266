#pragma once

#include "control/base/units.h"
#include "control/lti/discretize.h"
#include "models/planar/current_allocation.h"
#include "models/planar/planar_parameters.h"
#include "models/planar/windings_wrench.h"

#include <Eigen/LU>
#include <complex>

namespace halbench::app {

/// The platen, its cable, its coils and amplifiers at one pose as a linear state space, the command held over
/// each millisecond (resources/help/planar-theory.md sections 5.3, 6 and 8): another route than the stepped
/// simulation and its board. The command is the board's, about the origin of the platen frame, turned into
/// currents set by set with the board's force constant.
class PlatenPlant {
public:
    static constexpr double Period_s = 1e-3;

    PlatenPlant(const models::PlanarParameters& p, double forceConstant_N_per_A) {
        const models::PlanarPose pose{p.initialX_m, p.initialY_m, p.initialAngle_rad};
        const Eigen::Matrix<double, 3, 6> coils = models::WindingsWrench(p.geometry).at(pose).wrench;
        const models::PublishedWrench model(p.geometry, forceConstant_N_per_A);
        Eigen::Matrix<double, 6, 3> currents;
        currents.col(0) = models::setWiseCurrents_A(model, pose, {1.0, 0.0, 0.0});
        currents.col(1) = models::setWiseCurrents_A(model, pose, {0.0, 1.0, 0.0});
        currents.col(2) = models::setWiseCurrents_A(model, pose, {0.0, 0.0, 1.0});
        const Eigen::Matrix<double, 6, 1> gain =
            Eigen::Map<const Eigen::Matrix<double, 6, 1>>(p.coilGain_ratio.data());
        const Eigen::Matrix3d wrench = coils * gain.asDiagonal() * currents;
        // The back-EMF K^T q' takes its share of the output conductance off each current.
        const Eigen::Matrix3d eddy = coils * coils.transpose() / p.amplifierOutput_Ohm;
        m_sampled = *control::discretize(*control::makeStateSpace(dynamics(p, eddy), input(p), output(p),
                                                                  Eigen::MatrixXd::Zero(3, 3),
                                                                  control::TimeBase::continuous()),
                                         Period_s, control::Hold::Zoh{});
        m_wrench = wrench;
    }

    /// Command to position.
    Eigen::Matrix3cd at(double frequency_rad_s) const {
        const std::complex<double> z = std::polar(1.0, frequency_rad_s * Period_s);
        const Eigen::Index n = m_sampled.states();
        const Eigen::MatrixXcd dynamics =
            z * Eigen::MatrixXcd::Identity(n, n) - m_sampled.A.cast<std::complex<double>>();
        const Eigen::MatrixXcd states =
            dynamics.partialPivLu().solve((m_sampled.B * m_wrench).cast<std::complex<double>>());
        return m_sampled.C.cast<std::complex<double>>() * states;
    }

private:
    // States: place of the centre of mass and angle, their rates, the wrench behind the amplifiers.
    static Eigen::MatrixXd dynamics(const models::PlanarParameters& p, const Eigen::Matrix3d& eddy) {
        const Eigen::Matrix3d toOrigin = placeOfOrigin(p);
        const Eigen::Matrix3d toCentre = toOrigin.transpose(); // wrench about the centre of mass
        Eigen::Matrix<double, 2, 3> anchor; // travel of the cable's end, from the pose of the origin
        anchor << 1.0, 0.0, -p.cableY_m, 0.0, 1.0, p.cableX_m;
        Eigen::Matrix3d stiffness = anchor.transpose() * p.cableStiffness_N_per_m * anchor;
        stiffness(2, 2) += p.cableTorsion_Nm_per_rad;
        Eigen::Matrix3d damping = toCentre * eddy * toOrigin;
        damping.diagonal() += Eigen::Vector3d(p.damping_Ns_per_m, p.damping_Ns_per_m, p.damping_Nms_per_rad);
        const Eigen::Vector3d inertia(p.mass_kg, p.mass_kg, p.inertia_kg_m2);
        const Eigen::Matrix3d perInertia = inertia.cwiseInverse().asDiagonal();
        const double lag_1_s = 2.0 * Pi * p.amplifierBandwidth_Hz;
        Eigen::MatrixXd A = Eigen::MatrixXd::Zero(9, 9);
        A.block<3, 3>(0, 3).setIdentity();
        A.block<3, 3>(3, 0) = -perInertia * toCentre * stiffness * toOrigin;
        A.block<3, 3>(3, 3) = -perInertia * damping;
        A.block<3, 3>(3, 6) = perInertia * toCentre;
        A.block<3, 3>(6, 6) = -lag_1_s * Eigen::Matrix3d::Identity();
        return A;
    }
    static Eigen::MatrixXd input(const models::PlanarParameters& p) {
        Eigen::MatrixXd B = Eigen::MatrixXd::Zero(9, 3);
        B.bottomRows<3>() = 2.0 * Pi * p.amplifierBandwidth_Hz * Eigen::Matrix3d::Identity();
        return B;
    }
    static Eigen::MatrixXd output(const models::PlanarParameters& p) {
        Eigen::MatrixXd C = Eigen::MatrixXd::Zero(3, 9);
        C.leftCols<3>() = placeOfOrigin(p);
        return C;
    }
    /// C = G - R r_G for small angles.
    static Eigen::Matrix3d placeOfOrigin(const models::PlanarParameters& p) {
        Eigen::Matrix3d toOrigin = Eigen::Matrix3d::Identity();
        toOrigin(0, 2) = p.massCentreY_m;
        toOrigin(1, 2) = -p.massCentreX_m;
        return toOrigin;
    }

    control::StateSpace m_sampled;
    Eigen::Matrix3d m_wrench;
};

/// The board's law of section 9 with its filter of 2 ms, one sample late:
///   v[k] = D v[k-1] + (1 - D) (y[k] - y[k-1])/T,  D = e^(-T/2 ms),   I behind the command of its sample.
inline std::complex<double> lateLaw(double kp, double ki, double kd, double frequency_rad_s) {
    const double T = PlatenPlant::Period_s;
    const double D = std::exp(-T / 2e-3);
    const std::complex<double> back = std::polar(1.0, -frequency_rad_s * T);
    const std::complex<double> rate = (1.0 - D) * (1.0 - back) / (T * (1.0 - D * back));
    return back * (kp + ki * T * back / (1.0 - back) + kd * rate);
}

} // namespace halbench::app
