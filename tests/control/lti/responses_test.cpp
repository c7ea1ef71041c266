#include "control/lti/discretize.h"
#include "control/lti/hold_matrices.h"
#include "control/lti/responses.h"
#include "tests/control/random_systems.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace halbench::control {
namespace {

TransferFunction continuous(Polynomial numerator, Polynomial denominator) {
    return *TransferFunction::make(std::move(numerator), std::move(denominator), TimeBase::continuous());
}

TEST(Responses, impulseOfALightlyDampedPairIsTheDampedSine) {
    const double w = 20.0;
    const double zeta = 0.01;
    const double wd = w * std::sqrt(1.0 - zeta * zeta);
    const auto response = impulseResponse(continuous({w * w}, {1.0, 2.0 * zeta * w, w * w}), 3.0, 0.01);
    ASSERT_TRUE(response.has_value());
    for (std::size_t i = 0; i < response->value.size(); ++i) {
        const double t = response->time_s[i];
        EXPECT_NEAR(response->value[i], w * w / wd * std::exp(-zeta * w * t) * std::sin(wd * t), 1e-10);
    }
    EXPECT_EQ(impulseResponse(continuous({1.0, 2.0}, {1.0, 1.0}), 1.0, 0.1).error().code,
              ErrorCode::InvalidInput);
}

TEST(Responses, rampOfALagTrailsByItsTimeConstant) {
    const auto response = rampResponse(continuous({1.0}, {0.5, 1.0}), 5.0, 0.1);
    ASSERT_TRUE(response.has_value());
    for (std::size_t i = 0; i < response->value.size(); ++i) {
        const double t = response->time_s[i];
        EXPECT_NEAR(response->value[i], t - 0.5 * (1.0 - std::exp(-2.0 * t)), 1e-13);
    }
}

TEST(Responses, sampledImpulseAndRampFollowTheDifferenceEquation) {
    const auto system = *TransferFunction::make({1.0}, {1.0, -0.5}, TimeBase::sampled(0.1));
    const auto impulse = impulseResponse(system, 1.0, 1.0);
    ASSERT_TRUE(impulse.has_value());
    EXPECT_EQ(impulse->value[0], 0.0);
    EXPECT_NEAR(impulse->value[4], 10.0 * 0.125, 1e-14);
    const auto ramp = rampResponse(system, 1.0, 1.0);
    double y = 0.0;
    for (std::size_t k = 0; k < ramp->value.size(); ++k) {
        EXPECT_NEAR(ramp->value[k], y, 1e-14);
        y = 0.5 * y + ramp->time_s[k];
    }
}

/// Second route: classical Runge-Kutta of order 4 with a thousandth of the interval.
std::vector<double> integrated(const StateSpace& system, const std::vector<double>& time_s,
                               const std::function<double(std::size_t, double)>& input) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(system.states());
    std::vector<double> output;
    for (std::size_t i = 0; i < time_s.size(); ++i) {
        output.push_back((system.C * x).value() + system.D(0, 0) * input(i, 0.0));
        constexpr int Steps = 1000;
        for (int k = 0; i + 1 < time_s.size() && k < Steps; ++k) {
            const double h = (time_s[i + 1] - time_s[i]) / Steps;
            const auto slope = [&](const Eigen::VectorXd& at, double share) -> Eigen::VectorXd {
                return system.A * at + system.B * input(i, (k + share) / Steps);
            };
            const Eigen::VectorXd k1 = slope(x, 0.0);
            const Eigen::VectorXd k2 = slope(x + 0.5 * h * k1, 0.5);
            const Eigen::VectorXd k3 = slope(x + 0.5 * h * k2, 0.5);
            const Eigen::VectorXd k4 = slope(x + h * k3, 1.0);
            x += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        }
    }
    return output;
}

TEST(Responses, toAnyInputAreThoseOfAnIndependentIntegrator) {
    Random random(41);
    for (int round = 0; round < 12; ++round) {
        const StateSpace system =
            toStateSpace(randomSystem(random, 1 + static_cast<int>(random.below(4)), true, round % 3 == 0));
        std::vector<double> time_s = {0.3};
        std::vector<double> u = {random.gaussian()};
        for (int i = 0; i < 12; ++i) {
            time_s.push_back(time_s.back() + (round % 2 == 0 ? 0.05 : 0.02 + 0.1 * random.uniform()));
            u.push_back(random.gaussian());
        }
        for (const InputShape shape : {InputShape::Held, InputShape::Straight}) {
            const auto expected = integrated(system, time_s, [&](std::size_t i, double share) {
                const bool isStraight = shape == InputShape::Straight && i + 1 < u.size();
                return isStraight ? u[i] + share * (u[i + 1] - u[i]) : u[i];
            });
            const auto found = respond(system, time_s, u, shape);
            ASSERT_TRUE(found.has_value());
            for (std::size_t i = 0; i < expected.size(); ++i) {
                // Runge-Kutta: (30/s x 1e-4 s)^4 is 1e-10, and some thousand roundings.
                EXPECT_NEAR(found->value[i], expected[i], 1e-9 * (1.0 + std::abs(expected[i]))) << round;
            }
        }
    }
}

// Time against frequency: a long sine's response settles on |G| sin(w t + arg G). Sampled finely on straight
// lines, whose fundamental is sinc^2(w T/2) of the sine.
TEST(Responses, ofASineSettleOnTheFrequencyResponse) {
    const auto system = continuous({2.0, 3.0}, {1.0, 3.0, 7.0});
    const double w = 4.0;
    const double T = 1e-3;
    std::vector<double> time_s;
    std::vector<double> u;
    for (int i = 0; i <= 30000; ++i) {
        time_s.push_back(i * T);
        u.push_back(std::sin(w * i * T));
    }
    const auto found = respond(toStateSpace(system), time_s, u, InputShape::Straight);
    ASSERT_TRUE(found.has_value());
    const auto G = system.atFrequency(w);
    const double share = std::pow(std::sin(0.5 * w * T) / (0.5 * w * T), 2);
    for (std::size_t i = 25000; i < found->value.size(); ++i) {
        EXPECT_NEAR(found->value[i], share * std::abs(G) * std::sin(w * time_s[i] + std::arg(G)), 1e-9);
    }
}

TEST(Responses, ofEverySizeFollowTheirMatrices) {
    Random random(43);
    for (Eigen::Index n = 0; n <= 10; ++n) {
        StateSpace system{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Ones(n, 1),
                          Eigen::MatrixXd::Ones(1, n), Eigen::MatrixXd::Constant(1, 1, 0.5),
                          TimeBase::sampled(0.1)};
        for (double& value : system.A.reshaped()) {
            value = 0.2 * random.gaussian();
        }
        std::vector<double> u(30);
        for (double& value : u) {
            value = random.gaussian();
        }
        const auto found = simulate(system, u);
        Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
        for (std::size_t k = 0; k < u.size(); ++k) {
            EXPECT_NEAR(found[k], x.sum() + 0.5 * u[k], 1e-12) << n;
            x = (system.A * x + system.B.col(0) * u[k]).eval();
        }
    }
}

TEST(Responses, refuseTimesThatDoNotAscendAndSystemsOfSeveralPaths) {
    const StateSpace lag = toStateSpace(continuous({1.0}, {1.0, 1.0}));
    EXPECT_EQ(respond(lag, {0.0, 0.0}, {1.0, 1.0}, InputShape::Held).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(respond(lag, {0.0, 1.0}, {1.0}, InputShape::Held).error().code, ErrorCode::InvalidInput);
    StateSpace wide = lag;
    wide.B = Eigen::MatrixXd::Ones(1, 2);
    wide.D = Eigen::MatrixXd::Zero(1, 2);
    EXPECT_EQ(respond(wide, {0.0, 1.0}, {1.0, 1.0}, InputShape::Held).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(
        respond(*discretize(lag, 0.1, Hold::Zoh{}), {0.0, 1.0}, {1.0, 1.0}, InputShape::Held).error().code,
        ErrorCode::InvalidInput);
}

TEST(HoldMatrices, theLogarithmUndoesTheExponential) {
    const Eigen::Matrix2d A{{-0.1, 2.0}, {-2.0, -0.1}};
    const auto e = heldInput(A, Eigen::MatrixXd::Identity(2, 2), 1.0).transition;
    EXPECT_LT((*matrixLogarithm(e) - A).norm(), 1e-13);
    EXPECT_FALSE(matrixLogarithm(-Eigen::MatrixXd::Identity(2, 2)).has_value());
    EXPECT_FALSE(matrixLogarithm(Eigen::MatrixXd::Zero(1, 1)).has_value());
}

} // namespace
} // namespace halbench::control
