#include "tests/control/routes/own_loop.h"

#include "control/design/design_methods.h"
#include "tests/control/routes/state_routes.h"

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace halbench::control {

Eigen::Matrix3d OwnLoop::motion(double time_s) const {
    Eigen::Matrix3d rates = Eigen::Matrix3d::Zero();
    rates(0, 1) = 1.0;
    rates(1, 1) = -plant.dampingRate_1_s;
    rates(1, 2) = plant.accelerationGain_rad_s2_A;
    return (rates * time_s).exp();
}

StateSpace OwnLoop::open() const {
    const int d = timing.delay_samples;
    const Eigen::Index n = 4 + d;
    const Eigen::Matrix3d M = motion(timing.period_s);
    const double T = timing.period_s;
    StateSpace system{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, 1), Eigen::MatrixXd::Zero(1, n),
                      Eigen::MatrixXd::Zero(1, 1), TimeBase::sampled(T)};
    system.A.topLeftCorner(2, 2) = M.topLeftCorner(2, 2);
    system.A(2, 2) = 1.0;
    system.B(2, 0) = T * gains.integral;
    system.B(3, 0) = 1.0;
    // u = (K_P + K_D/T) e + x - K_D/T e_last, given now or into the queue.
    Eigen::RowVectorXd law = Eigen::RowVectorXd::Zero(n);
    law(2) = 1.0;
    law(3) = -gains.derivative / T;
    const double direct = gains.proportional + gains.derivative / T;
    const Eigen::Vector2d pushed = M.topRightCorner(2, 1);
    if (d == 0) {
        system.A.topRows(2) += pushed * law;
        system.B.topRows(2) = pushed * direct;
    } else {
        system.A.block(0, 4, 2, 1) = pushed;
        for (int i = 0; i + 1 < d; ++i) {
            system.A(4 + i, 5 + i) = 1.0;
        }
        system.A.row(n - 1) = law;
        system.B(n - 1, 0) = direct;
    }
    system.C(0, 0) = 1.0;
    return system;
}

double OwnLoop::poleRadius() const {
    return closedPoles(open(), 1.0).cwiseAbs().maxCoeff();
}

OwnLoop::Run OwnLoop::run(double reference_rad, double load_A, int samples, int points) const {
    const Eigen::Matrix3d part = motion(timing.period_s / points);
    Run result;
    Eigen::Vector3d state = Eigen::Vector3d::Zero();
    double integral_A = 0.0;
    double last_rad = 0.0;
    std::vector<double> queue(static_cast<std::size_t>(timing.delay_samples), 0.0);
    for (int k = 0; k < samples; ++k) {
        const double error = reference_rad - state(0);
        queue.push_back(gains.proportional * error + integral_A -
                        gains.derivative * (state(0) - last_rad) / timing.period_s);
        integral_A += timing.period_s * gains.integral * error;
        last_rad = state(0);
        const double current_A = queue.front();
        queue.erase(queue.begin());
        result.sample_rad.push_back(state(0));
        for (int i = 0; i < points; ++i) {
            result.angle_rad.push_back(state(0));
            result.current_A.push_back(current_A);
            state(2) = current_A + load_A;
            state = (part * state).eval();
        }
    }
    return result;
}

OwnLoop randomStableLoop(Random& random) {
    for (;;) {
        OwnLoop loop;
        loop.plant = {10.0 * random.uniform(), 5.0 * std::pow(40.0, random.uniform()), random.uniform()};
        loop.timing = {0.001 * std::pow(20.0, random.uniform()), static_cast<int>(random.below(3))};
        const auto law = designLaw("recommended", loop.plant, loop.timing, {});
        if (!law) {
            continue;
        }
        loop.gains = law->gains;
        loop.gains.proportional *= 0.5 + 0.7 * random.uniform();
        loop.gains.integral *= random.below(4) == 0 ? 0.0 : 0.5 + random.uniform();
        loop.gains.derivative *= 0.7 + 0.5 * random.uniform();
        if (loop.poleRadius() < 1.0 - 1e-4) {
            return loop;
        }
    }
}

} // namespace halbench::control
