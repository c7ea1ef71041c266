// Random systems in every description: what is combined, cancelled, scaled or read off one of them is what
// another one says.
#include "control/base/units.h"
#include "control/lti/dead_time.h"
#include "control/lti/eigenvalues.h"
#include "control/lti/realization.h"
#include "control/lti/responses.h"
#include "control/lti/state_response.h"
#include "tests/control/routes/random_loops.h"
#include "tests/control/routes/state_routes.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

Eigen::MatrixXd randomMatrix(Random& random, Eigen::Index rows, Eigen::Index cols) {
    Eigen::MatrixXd result(rows, cols);
    for (double& value : result.reshaped()) {
        value = random.gaussian();
    }
    return result;
}

// 1e-9 of the value and what the polynomials lose there.
TEST(DescriptionRoutes, polynomialsCombineAsTheMatricesDo) {
    Random random(211);
    for (int round = 0; round < 100; ++round) {
        const bool isSampled = round % 2 == 1;
        const auto draw = [&](bool isProper) {
            const auto system = randomSystem(random, 1 + static_cast<int>(random.below(4)), false, isProper);
            return isSampled ? *discretize(system, 0.05, Hold::Zoh{}) : system;
        };
        const TransferFunction a = draw(round % 4 == 0);
        const TransferFunction b = draw(round % 3 == 0);
        const StateSpace A = sectionsOf(a);
        const StateSpace B = sectionsOf(b);
        const std::pair<TransferFunction, StateSpace> pairs[] = {{*series(a, b), *series(A, B)},
                                                                 {*parallel(a, b), *parallel(A, B)},
                                                                 {*feedback(a, b), *feedback(A, B)}};
        for (const double w : {0.5, 3.0, 20.0}) {
            for (const auto& [rational, states] : pairs) {
                const Complex expected = valueAt(states, boundaryPoint(states.timeBase, w));
                EXPECT_LT(std::abs(rational.atFrequency(w) - expected),
                          (1e-9 + 100.0 * roundingOf(rational, w)) * std::abs(expected))
                    << round << " at " << w;
            }
        }
    }
}

TEST(DescriptionRoutes, gainAtRestIsTheSameAndTheEndOfTheStep) {
    Random random(212);
    for (int round = 0; round < 80; ++round) {
        const auto continuous =
            randomSystem(random, 1 + static_cast<int>(random.below(5)), true, round % 4 == 0);
        const auto system = round % 2 == 0 ? continuous : *discretize(continuous, 0.1, Hold::Zoh{});
        const double gain = system.dcGain();
        // At z = 1 the coefficients of a sampled system cancel.
        const double tolerance = 1e-9 + 100.0 * roundingOf(system, 0.0);
        EXPECT_NEAR(toZeroPoleGain(system).dcGain() / gain, 1.0, tolerance) << round;
        EXPECT_NEAR(dcGain(sectionsOf(system))(0, 0) / gain, 1.0, tolerance) << round;
        double slowest = HUGE_VAL;
        for (const Complex& pole : poles(continuous)) {
            slowest = std::min(slowest, -pole.real());
        }
        const auto step = stepResponse(system, 40.0 / slowest, 1.0 / slowest); // exp(-40) is left
        EXPECT_NEAR(step->value.back() / gain, 1.0, tolerance) << round;
    }
}

// w (-zeta +- j sqrt(1 - zeta^2)) is the pole again, sampled exp of it times T.
TEST(DescriptionRoutes, dampingGivesItsPolesBack) {
    Random random(213);
    for (int round = 0; round < 80; ++round) {
        const auto [system, states] = randomLoop(random, round, 3);
        const bool isSampled = system.timeBase().isSampled();
        const auto modes = damping(system);
        for (const Damping& mode : modes) {
            if (std::abs(mode.pole) < 1e-12 ||
                (isSampled && mode.pole.imag() == 0.0 && mode.pole.real() < 0.0)) {
                continue; // at rest, or without a continuous image
            }
            const double share = std::sqrt(std::max(0.0, 1.0 - mode.damping_ratio * mode.damping_ratio));
            Complex s = mode.naturalFrequency_rad_s * Complex(-mode.damping_ratio, share);
            s = mode.pole.imag() < 0.0 ? std::conj(s) : s;
            const Complex pole = isSampled ? std::exp(s * system.timeBase().period_s()) : s;
            // Near a damping of one the root above has half of the digits.
            EXPECT_LT(std::abs(pole - mode.pole), 2e-8 * (1.0 + std::abs(mode.pole))) << round;
        }
    }
}

TEST(DescriptionRoutes, eigenvaluesAreThoseOfAnotherSolverOnAScaledMatrix) {
    Random random(214);
    for (int round = 0; round < 60; ++round) {
        const auto n = 1 + static_cast<Eigen::Index>(random.below(8));
        const Eigen::MatrixXd A = randomMatrix(random, n, n);
        Eigen::VectorXd scale(n);
        for (double& value : scale) {
            value = std::exp2(std::round(10.0 * random.gaussian()));
        }
        const Eigen::MatrixXd bad = scale.asDiagonal() * A * scale.cwiseInverse().asDiagonal(); // exact
        const auto found = eigenvalues(bad);
        const Eigen::VectorXcd expected = Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(A, false).eigenvalues();
        ASSERT_EQ(found.size(), static_cast<std::size_t>(n));
        for (const Complex& value : found) {
            // Of order one, none of them closer than some thousandth to another: three digits.
            EXPECT_LT(distanceTo(expected, value), 1e-10 * A.norm()) << round;
        }
    }
}

// lambda B x = A x with an invertible B is B^-1 A; a B of less rank loses as many.
TEST(DescriptionRoutes, generalizedEigenvaluesAreThoseOfTheQuotient) {
    Random random(215);
    for (int round = 0; round < 60; ++round) {
        const auto n = 2 + static_cast<Eigen::Index>(random.below(5));
        const Eigen::MatrixXd A = randomMatrix(random, n, n);
        const Eigen::MatrixXd B = randomMatrix(random, n, n);
        const Eigen::VectorXcd expected =
            Eigen::EigenSolver<Eigen::MatrixXd>(B.fullPivLu().solve(A), false).eigenvalues();
        const auto singular = Eigen::JacobiSVD<Eigen::MatrixXd>(B).singularValues();
        const double condition = singular(0) / singular(n - 1);
        const auto found = generalizedEigenvalues(A, B);
        ASSERT_EQ(found.size(), static_cast<std::size_t>(n)) << round;
        for (const Complex& value : found) {
            EXPECT_LT(distanceTo(expected, value), 1e-12 * condition * (1.0 + std::norm(value))) << round;
        }
        Eigen::MatrixXd less = B;
        less.row(0).setZero();
        EXPECT_EQ(generalizedEigenvalues(A, less).size(), static_cast<std::size_t>(n - 1)) << round;
    }
}

// A system beside one whose zeros cancel poles, in factors and in states: the same smaller one.
TEST(DescriptionRoutes, whatCancelsLeavesBothDescriptions) {
    Random random(216);
    for (int round = 0; round < 60; ++round) {
        const auto system = randomSystem(random, 1 + static_cast<int>(random.below(4)), true);
        const auto extra = randomRoots(random, 2, true);
        ZeroPoleGain small = toZeroPoleGain(system);
        auto zeros = small.zeros();
        auto poles = small.poles();
        for (const Complex& root : extra) {
            zeros.push_back(root);
            poles.push_back(root);
        }
        const auto full = *ZeroPoleGain::make(zeros, poles, small.gain(), TimeBase::continuous());
        const ZeroPoleGain ofFactors = minimalRealization(full);
        const StateSpace ofStates = minimalRealization(toStateSpace(full));
        EXPECT_EQ(ofFactors.poles().size(), small.poles().size()) << round;
        EXPECT_EQ(ofStates.states(), static_cast<Eigen::Index>(small.poles().size())) << round;
        for (const double w : {0.4, 3.0, 30.0}) {
            const Complex expected = system.atFrequency(w);
            EXPECT_LT(std::abs(ofFactors.atFrequency(w) / expected - 1.0), 1e-9) << round;
            EXPECT_LT(std::abs(StatePath(ofStates).atFrequency(w) / expected - 1.0), 1e-9) << round;
        }
    }
}

// Each root turns the phase by the angle of jw - root, which runs from one end to the other without a jump.
TEST(DescriptionRoutes, theUnwrappedPhaseIsTheSumOfTheAnglesOfTheRoots) {
    Random random(217);
    for (int round = 0; round < 80; ++round) {
        const auto system =
            randomSystem(random, 1 + static_cast<int>(random.below(6)), false, round % 4 == 0);
        const auto response = *frequencyResponse(system, logarithmicFrequencies(0.01, 1000.0, 3000));
        const auto unwrapped = phase_deg(response);
        const auto sum_deg = [&system](double w) {
            double sum_rad = system.numerator().front() / system.denominator().front() < 0.0 ? Pi : 0.0;
            // A root on the right is passed on its other side: its angle starts at 180 degrees and falls.
            const auto angle = [w](Complex root) {
                const double from_left = std::atan2(w - root.imag(), std::abs(root.real()));
                return root.real() < 0.0 ? from_left : Pi - from_left;
            };
            for (const Complex& zero : zeros(system)) {
                sum_rad += angle(zero);
            }
            for (const Complex& pole : poles(system)) {
                sum_rad -= angle(pole);
            }
            return radiansToDegrees(sum_rad);
        };
        const double offset = unwrapped.front() - sum_deg(response.frequency_rad_s.front());
        EXPECT_NEAR(offset / 360.0, std::round(offset / 360.0), 1e-9) << round;
        EXPECT_GT(unwrapped.front(), -360.0);
        EXPECT_LE(unwrapped.front(), 1e-9);
        for (std::size_t i = 0; i < unwrapped.size(); i += 50) {
            EXPECT_NEAR(unwrapped[i], sum_deg(response.frequency_rad_s[i]) + offset, 1e-8) << round;
        }
    }
}

// The error of the approximation of order n is 2 (n!)^2 x^(2n+1)/((2n)! (2n+1)!) at x = w deadTime.
TEST(DescriptionRoutes, deadTimesCombineAndApproximateAsTheirValues) {
    Random random(218);
    for (int round = 0; round < 40; ++round) {
        const auto first = *DeadTimeSystem::make(randomSystem(random, 3), 0.2 * random.uniform());
        const auto second = *DeadTimeSystem::make(randomSystem(random, 2), 0.2 * random.uniform());
        const auto both = *series(first, second);
        const int order = 3 + static_cast<int>(random.below(4));
        const auto rational = *withPade(first, order);
        const auto closed = feedbackResponse(first, second, {0.5, 2.0, 6.0});
        ASSERT_TRUE(closed.has_value());
        for (std::size_t i = 0; i < 3; ++i) {
            const double w = closed->frequency_rad_s[i];
            const Complex a = StatePath(sectionsOf(first.rational())).atFrequency(w) *
                              std::polar(1.0, -w * first.deadTime_s());
            const Complex b = StatePath(sectionsOf(second.rational())).atFrequency(w) *
                              std::polar(1.0, -w * second.deadTime_s());
            EXPECT_LT(std::abs(both.atFrequency(w) - a * b), 1e-9 * std::abs(a * b));
            const Complex expected = a / (1.0 + a * b);
            const double near = 1.0 / std::min(1.0, std::abs(1.0 + a * b)); // close to -1 digits are lost
            EXPECT_LT(std::abs(closed->value[i] - expected), 1e-9 * near * std::abs(expected));
            const double x = w * first.deadTime_s();
            const double left = 2.0 * std::pow(std::tgamma(order + 1.0), 2) * std::pow(x, 2 * order + 1) /
                                (std::tgamma(2.0 * order + 1.0) * std::tgamma(2.0 * order + 2.0));
            EXPECT_LT(std::abs(rational.atFrequency(w) - a), (2.0 * left + 1e-9) * std::abs(a)) << order;
        }
    }
}

} // namespace
} // namespace halbench::control
