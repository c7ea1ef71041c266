#include "control/identify/motion_shape.h"

#include <array>
#include <cmath>

namespace halbench::control {
namespace {

// Sum over n of weight(n) (-x)^n / (n + 2)!; 20 terms leave nothing for x < 1.
template <typename Weight>
double series(double x, const Weight& weight) {
    double term = 0.5;
    double sum = 0.0;
    for (int n = 0; n < 20; ++n) {
        sum += weight(n) * term;
        term *= -x / (n + 3);
    }
    return sum;
}

constexpr double SeriesLimit = 0.5;

// (e^-x - 1 + x)/x^2
double bend(double x) {
    return std::fabs(x) < SeriesLimit ? series(x, [](int) { return 1.0; }) : (std::expm1(-x) + x) / (x * x);
}

// Its derivative: -1/6 + x/12 - ...
double bendSlope(double x) {
    if (std::fabs(x) < SeriesLimit) {
        return -series(x, [](int n) { return (n + 1.0) / (n + 3.0); });
    }
    return (-std::expm1(-x) - 2.0 * (std::expm1(-x) + x) / x) / (x * x);
}

Eigen::Index rowsOf(const MotionSegment& segment) {
    return static_cast<Eigen::Index>(segment.time_s.size());
}

double since(const MotionSegment& segment, Eigen::Index row) {
    return segment.time_s[static_cast<std::size_t>(row)] - segment.time_s.front();
}

} // namespace

Eigen::MatrixXd localShape(const MotionSegment& segment, double damping_per_s) {
    Eigen::MatrixXd shape(rowsOf(segment), 3);
    for (Eigen::Index i = 0; i < shape.rows(); ++i) {
        const double t = since(segment, i);
        shape(i, 0) = 1.0;
        shape(i, 1) = t;
        shape(i, 2) = t * t * bend(damping_per_s * t);
    }
    return shape;
}

Eigen::VectorXd dampingShape(const MotionSegment& segment, double damping_per_s) {
    Eigen::VectorXd shape(rowsOf(segment));
    for (Eigen::Index i = 0; i < shape.size(); ++i) {
        const double t = since(segment, i);
        shape(i) = t * t * t * bendSlope(damping_per_s * t);
    }
    return shape;
}

Eigen::MatrixXd angleErrorShape(const MotionSegment& segment, int orders) {
    Eigen::MatrixXd shape(rowsOf(segment), 2 * orders);
    for (Eigen::Index i = 0; i < shape.rows(); ++i) {
        const double angle = segment.angle_rad[static_cast<std::size_t>(i)];
        const double c1 = std::cos(angle);
        const double s1 = std::sin(angle);
        double c = 1.0;
        double s = 0.0;
        for (Eigen::Index k = 0; k < orders; ++k) {
            const double next = c * c1 - s * s1;
            s = s * c1 + c * s1;
            c = next;
            shape(i, 2 * k) = c;
            shape(i, 2 * k + 1) = s;
        }
    }
    return shape;
}

Eigen::MatrixXd rippleShape(const MotionSegment& segment, double damping_per_s) {
    constexpr int Columns = 6;
    Eigen::MatrixXd shape = Eigen::MatrixXd::Zero(rowsOf(segment), Columns);
    const double s = segment.direction;
    const auto force = [&](Eigen::Index row) {
        const double angle = segment.angle_rad[static_cast<std::size_t>(row)];
        const double c1 = std::cos(angle);
        const double s1 = std::sin(angle);
        return Eigen::Array<double, Columns, 1>{c1,
                                                s1,
                                                s * c1,
                                                s * s1,
                                                segment.current_A * (c1 * c1 - s1 * s1),
                                                segment.current_A * 2.0 * s1 * c1};
    };
    Eigen::Array<double, Columns, 1> speed = Eigen::Array<double, Columns, 1>::Zero();
    Eigen::Array<double, Columns, 1> before = force(0);
    for (Eigen::Index i = 1; i < shape.rows(); ++i) {
        const double step = since(segment, i) - since(segment, i - 1);
        const double decay = std::exp(-damping_per_s * step);
        const auto now = force(i);
        const Eigen::Array<double, Columns, 1> next = decay * speed + 0.5 * step * (decay * before + now);
        shape.row(i) = shape.row(i - 1) + (0.5 * step * (speed + next)).matrix().transpose();
        speed = next;
        before = now;
    }
    return shape;
}

Eigen::VectorXd forceShape(const MotionSegment& segment, double damping_per_s, const SpeedCourse& course,
                           const std::function<double(double)>& force_rad_s2) {
    const auto forceAt = [&](double t) {
        const double x = damping_per_s * t;
        const double lag = std::fabs(x) < 1e-9 ? t : -std::expm1(-x) / damping_per_s;
        return force_rad_s2(course.speed_rad_s + course.acceleration_rad_s2 * lag);
    };
    Eigen::VectorXd forces(rowsOf(segment));
    for (Eigen::Index i = 0; i < forces.size(); ++i) {
        forces(i) = forceAt(since(segment, i));
    }
    return forceResponse(segment, damping_per_s, forces).angle;
}

ForceResponse forceResponse(const MotionSegment& segment, double damping_per_s,
                            const Eigen::VectorXd& force_rad_s2) {
    const Eigen::Index rows = rowsOf(segment);
    ForceResponse response{Eigen::VectorXd::Zero(rows), Eigen::VectorXd::Zero(rows)};
    for (Eigen::Index i = 1; i < rows; ++i) {
        const double step = since(segment, i) - since(segment, i - 1);
        const double decay = std::exp(-damping_per_s * step);
        const double speed = response.speed(i - 1);
        response.speed(i) = decay * speed + 0.5 * step * (decay * force_rad_s2(i - 1) + force_rad_s2(i));
        response.angle(i) = response.angle(i - 1) + 0.5 * step * (speed + response.speed(i));
    }
    return response;
}

} // namespace halbench::control
