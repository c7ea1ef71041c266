#include "control/design/optimal_designs.h"

#include "control/base/units.h"
#include "control/design/design_methods.h"
#include "control/design/riccati.h"
#include "control/lti/discretize.h"
#include "control/lti/responses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace halbench::control {

namespace {

bool isPositive(double value) {
    return std::isfinite(value) && value > 0.0;
}

tl::unexpected<Error> noTargets() {
    return failure(ErrorCode::OutOfRange,
                   "the targets of this design are not possible: they must be positive, Ms above 1");
}

Result<ProvenDesign> proven(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                            double currentLimit_A) {
    auto proof = proveDesign(plant, gains, timing, currentLimit_A);
    if (!proof) {
        return failure(proof.error());
    }
    if (!proof->isStable) {
        return failure(ErrorCode::Refused, "the design is unstable in the sampled loop",
                       "ask for less speed, or shorten the computing delay");
    }
    return ProvenDesign{gains, std::move(*proof)};
}

/// Angle, speed and integral of the error over one period of held current.
struct HeldMotor {
    Eigen::MatrixXd A;
    Eigen::MatrixXd B;
};

HeldMotor heldMotor(const PositionPlant& plant, double period_s, bool hasIntegral) {
    const StateSpace motor{(Eigen::Matrix2d() << 0.0, 1.0, 0.0, -plant.dampingRate_1_s).finished(),
                           Eigen::Vector2d(0.0, plant.accelerationGain_rad_s2_A),
                           Eigen::RowVector2d(1.0, 0.0), Eigen::MatrixXd::Zero(1, 1), TimeBase::continuous()};
    const StateSpace sampled = *discretize(motor, period_s, Hold::Zoh{});
    const Eigen::Index n = hasIntegral ? 3 : 2;
    HeldMotor held{Eigen::MatrixXd::Identity(n, n), Eigen::MatrixXd::Zero(n, 1)};
    held.A.topLeftCorner(2, 2) = sampled.A;
    held.B.topRows(2) = sampled.B;
    if (hasIntegral) {
        held.A(2, 0) = period_s; // of the angle: minus the error
    }
    return held;
}

using Simplex = std::array<std::array<double, 3>, 4>;

/// Nelder, Mead (1965) in three dimensions with the usual coefficients.
class DirectSearch {
public:
    explicit DirectSearch(std::function<double(const std::array<double, 3>&)> cost)
        : m_cost(std::move(cost)) {}

    std::array<double, 3> from(const std::array<double, 3>& start, double size) {
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            m_points[i] = start;
            if (i > 0) {
                m_points[i][i - 1] += size;
            }
            m_values[i] = m_cost(m_points[i]);
        }
        constexpr int MostRounds = 200;
        for (int round = 0; round < MostRounds; ++round) {
            sort();
            if (m_values[3] - m_values[0] <= 1e-6 * std::abs(m_values[0]) && std::isfinite(m_values[3])) {
                break;
            }
            improve();
        }
        sort();
        return m_points[0];
    }

    double best() const { return m_values[0]; }

private:
    std::array<double, 3> between(double share) const {
        std::array<double, 3> point{};
        for (std::size_t j = 0; j < 3; ++j) {
            const double middle = (m_points[0][j] + m_points[1][j] + m_points[2][j]) / 3.0;
            point[j] = middle + share * (m_points[3][j] - middle);
        }
        return point;
    }

    void improve() {
        const auto reflected = between(-1.0);
        const double value = m_cost(reflected);
        if (value < m_values[0]) {
            const auto expanded = between(-2.0);
            const double farther = m_cost(expanded);
            farther < value ? replace(expanded, farther) : replace(reflected, value);
            return;
        }
        if (value < m_values[2]) {
            replace(reflected, value);
            return;
        }
        const auto contracted = between(value < m_values[3] ? -0.5 : 0.5);
        const double nearer = m_cost(contracted);
        if (nearer < std::min(value, m_values[3])) {
            replace(contracted, nearer);
            return;
        }
        for (std::size_t i = 1; i < m_points.size(); ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                m_points[i][j] = 0.5 * (m_points[i][j] + m_points[0][j]);
            }
            m_values[i] = m_cost(m_points[i]);
        }
    }

    void replace(const std::array<double, 3>& point, double value) {
        m_points[3] = point;
        m_values[3] = value;
    }

    void sort() {
        std::array<std::size_t, 4> order = {0, 1, 2, 3};
        std::sort(order.begin(), order.end(), [this](auto a, auto b) { return m_values[a] < m_values[b]; });
        const Simplex points = m_points;
        const std::array<double, 4> values = m_values;
        for (std::size_t i = 0; i < order.size(); ++i) {
            m_points[i] = points[order[i]];
            m_values[i] = values[order[i]];
        }
    }

    std::function<double(const std::array<double, 3>&)> m_cost;
    Simplex m_points{};
    std::array<double, 4> m_values{};
};

PidGains gainsFrom(const std::array<double, 3>& logarithms) {
    PidGains gains;
    gains.proportional = std::exp(logarithms[0]);
    gains.integral = std::exp(logarithms[1]);
    gains.derivative = std::exp(logarithms[2]);
    return gains;
}

/// The measure, raised steeply by what a constraint is exceeded; infinite for an unstable loop.
double cost(const PositionPlant& plant, const LoopTiming& timing, const LeastErrorTargets& targets,
            double currentLimit_A, double duration_s, const PidGains& gains) {
    const auto loop = sampledOpenLoop(plant, gains, timing);
    if (!loop || poleRadius(*loop) >= 1.0) {
        return HUGE_VAL;
    }
    double excess = std::max(0.0, sensitivityPeaks(*loop).Ms_ratio / targets.mostMs_ratio - 1.0);
    if (targets.step_rad) {
        // The law takes the difference of the angle, not of the error: a step asks for K_P first of all.
        excess += std::max(0.0, gains.proportional * *targets.step_rad / currentLimit_A - 1.0);
    }
    const auto error = loadError(plant, gains, timing, targets.measure, duration_s);
    return error ? *error * (1.0 + 1e3 * excess) : HUGE_VAL;
}

} // namespace

Result<ProvenDesign> designRegulator(const PositionPlant& plant, const LoopTiming& timing,
                                     const RegulatorTargets& targets, double currentLimit_A) {
    for (const auto& valid : {checkPlant(plant), checkTiming(timing)}) {
        if (!valid) {
            return failure(valid.error());
        }
    }
    const bool hasIntegral = targets.integral_rad_s.has_value();
    if (!isPositive(targets.angle_rad) || !isPositive(targets.current_A) ||
        !isPositive(targets.integral_rad_s.value_or(1.0))) {
        return noTargets();
    }
    const HeldMotor motor = heldMotor(plant, timing.period_s, hasIntegral);
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(motor.A.rows());
    weight(0) = 1.0 / (targets.angle_rad * targets.angle_rad);
    if (hasIntegral) {
        weight(2) = 1.0 / (*targets.integral_rad_s * *targets.integral_rad_s);
    }
    const Eigen::MatrixXd R = Eigen::MatrixXd::Constant(1, 1, 1.0 / (targets.current_A * targets.current_A));
    const auto gain = regulatorGain(motor.A, motor.B, weight.asDiagonal(), R);
    if (!gain) {
        return failure(gain.error());
    }
    PidGains gains;
    gains.proportional = (*gain)(0, 0);
    gains.derivative = (*gain)(0, 1);
    gains.integral = hasIntegral ? (*gain)(0, 2) : 0.0;
    return proven(plant, gains, timing, currentLimit_A);
}

Result<double> loadError(const PositionPlant& plant, const PidGains& gains, const LoopTiming& timing,
                         ErrorMeasure measure, double duration_s) {
    const auto controller = sampledController(gains, timing.period_s);
    if (!controller) {
        return failure(controller.error());
    }
    const auto back = series(*controller, TransferFunction::delay(timing.delay_samples, timing.period_s));
    const auto fromLoad = back ? feedback(sampledPlant(plant, timing.period_s), *back) : back;
    const auto response =
        fromLoad ? stepResponse(*fromLoad, duration_s, timing.period_s) : failure(fromLoad.error());
    if (!response) {
        return failure(response.error());
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < response->value.size(); ++k) {
        sum += std::abs(response->value[k]) * (measure == ErrorMeasure::Itae ? response->time_s[k] : 1.0);
    }
    return sum * timing.period_s;
}

Result<ProvenDesign> designLeastError(const PositionPlant& plant, const LoopTiming& timing,
                                      const LeastErrorTargets& targets, double currentLimit_A) {
    const auto start = designLaw("recommended", plant, timing, {});
    if (!start) {
        return failure(start.error());
    }
    if (!(std::isfinite(targets.mostMs_ratio) && targets.mostMs_ratio > 1.0) ||
        !isPositive(targets.step_rad.value_or(1.0)) || !isPositive(currentLimit_A)) {
        return noTargets();
    }
    const double speed_rad_s = std::sqrt(start->gains.proportional * plant.accelerationGain_rad_s2_A);
    const double duration_s = 200.0 / speed_rad_s; // 200 radians of the loop: the integral has come to rest
    DirectSearch search([&](const std::array<double, 3>& point) {
        return cost(plant, timing, targets, currentLimit_A, duration_s, gainsFrom(point));
    });
    // A quarter of the recommended speed is stable and calm everywhere.
    std::array<double, 3> point = {std::log(start->gains.proportional / 16.0),
                                   std::log(start->gains.integral / 64.0 + 1e-9),
                                   std::log(start->gains.derivative / 4.0 + 1e-9)};
    double before = HUGE_VAL;
    constexpr int MostRestarts = 12;
    for (int i = 0; i < MostRestarts; ++i) {
        point = search.from(point, i % 2 == 0 ? 0.5 : -0.3);
        if (search.best() > 0.999 * before) {
            break;
        }
        before = search.best();
    }
    auto design = proven(plant, gainsFrom(point), timing, currentLimit_A);
    if (design && design->proof.peaks.Ms_ratio > 1.01 * targets.mostMs_ratio) {
        return failure(ErrorCode::Refused, "no gains of this motor meet the asked sensitivity",
                       "allow a larger Ms, or shorten the computing delay");
    }
    return design;
}

} // namespace halbench::control
