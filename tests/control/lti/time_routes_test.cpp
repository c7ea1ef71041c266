// Answers in time of random systems against sums of exponentials; every rule of discretisation against what
// it promises, from the polynomial and from the states.
#include "control/lti/discretize.h"
#include "control/lti/hold_matrices.h"
#include "control/lti/responses.h"
#include "control/lti/state_response.h"
#include "tests/control/random_systems.h"
#include "tests/control/routes/partial_fractions.h"
#include "tests/control/routes/state_routes.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

TransferFunction drawn(Random& random, int round, bool isProper) {
    return randomSystem(random, 1 + static_cast<int>(random.below(5)), round % 7 != 0, isProper);
}

// 1e-10 of the magnitudes that are added: residues of neighbouring poles are large and cancel.
TEST(TimeRoutes, stepImpulseAndRampAreSumsOfExponentials) {
    Random random(201);
    for (int round = 0; round < 120; ++round) {
        const TransferFunction system = drawn(random, round, round % 4 == 0);
        const PartialFractions exact(system);
        const auto step = stepResponse(system, 2.0, 0.05);
        const auto ramp = rampResponse(system, 2.0, 0.05);
        const auto impulse = impulseResponse(system, 2.0, 0.05);
        ASSERT_TRUE(step && ramp);
        ASSERT_EQ(impulse.has_value(), round % 4 != 0);
        for (std::size_t i = 0; i < step->time_s.size(); ++i) {
            const double t = step->time_s[i];
            double growth = 1.0;
            for (const Complex& pole : exact.poles()) {
                growth = std::max(growth, std::exp(pole.real() * t));
            }
            const double tolerance = 1e-10 * growth * exact.size();
            EXPECT_NEAR(step->value[i], exact.step(t), tolerance) << round;
            EXPECT_NEAR(ramp->value[i], exact.ramp(t), tolerance) << round;
            if (impulse) {
                EXPECT_NEAR(impulse->value[i], exact.impulse(t), tolerance) << round;
            }
        }
    }
}

// Powers of the poles against the recurrence of the states.
TEST(TimeRoutes, sampledImpulsesAreSumsOfPowers) {
    Random random(202);
    for (int round = 0; round < 120; ++round) {
        const auto continuous =
            randomSystem(random, 1 + static_cast<int>(random.below(4)), true, round % 3 == 0);
        const auto system = *discretize(continuous, 0.2, Hold::Zoh{});
        const PartialFractions exact(system);
        const auto impulse = impulseResponse(system, 8.0, 1.0);
        ASSERT_TRUE(impulse.has_value());
        for (std::size_t k = 0; k < impulse->value.size(); ++k) {
            // A sample of 1/T.
            EXPECT_NEAR(impulse->value[k], exact.sample(static_cast<int>(k)) / 0.2,
                        1e-10 * exact.size() / 0.2)
                << round << " at " << k;
        }
    }
}

struct Sampled {
    TransferFunction rational;
    StateSpace states;
};

Sampled sampledBy(const TransferFunction& system, double period_s, const HoldMethod& rule) {
    return {*discretize(system, period_s, rule), *discretize(sectionsOf(system), period_s, rule)};
}

// By polynomial and by states: one sampled system, for every rule.
TEST(TimeRoutes, everyRuleIsTheSameOnPolynomialsAndOnStates) {
    Random random(203);
    const HoldMethod rules[] = {Hold::Zoh{},       Hold::Foh{},     Hold::Tustin{},
                                Hold::Tustin{9.0}, Hold::Impulse{}, Hold::Matched{}};
    for (int round = 0; round < 80; ++round) {
        const TransferFunction system = drawn(random, round, false);
        for (const HoldMethod& rule : rules) {
            const Sampled both = sampledBy(system, 0.1, rule);
            for (const double w : {0.7, 4.0, 25.0}) {
                const Complex expected = StatePath(both.states).atFrequency(w);
                EXPECT_LT(std::abs(both.rational.atFrequency(w) - expected),
                          (1e-9 + 100.0 * roundingOf(both.rational, w)) * std::abs(expected))
                    << round << " rule " << rule.index();
            }
        }
    }
}

// What each rule keeps at the samples, in time: the step of ZOH, the ramp of FOH, the impulse response.
TEST(TimeRoutes, heldRulesKeepTheirAnswerAtTheSamples) {
    Random random(204);
    const double T = 0.1;
    for (int round = 0; round < 80; ++round) {
        const auto system = randomSystem(random, 1 + static_cast<int>(random.below(5)), true);
        const PartialFractions exact(system);
        std::vector<double> ramp;
        std::vector<double> impulse(40, 0.0);
        impulse.front() = 1.0;
        for (int k = 0; k < 40; ++k) {
            ramp.push_back(T * k);
        }
        const StateSpace states = sectionsOf(system);
        const auto ofZoh = simulate(*discretize(states, T, Hold::Zoh{}), std::vector<double>(40, 1.0));
        const auto ofFoh = simulate(*discretize(states, T, Hold::Foh{}), ramp);
        const auto ofImpulse = simulate(*discretize(states, T, Hold::Impulse{}), impulse);
        for (int k = 0; k < 40; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const double tolerance = 1e-10 * exact.size();
            EXPECT_NEAR(ofZoh[i], exact.step(T * k), tolerance) << round;
            EXPECT_NEAR(ofFoh[i], exact.ramp(T * k), tolerance) << round;
            EXPECT_NEAR(ofImpulse[i], T * exact.impulse(T * k), T * tolerance) << round;
        }
    }
}

// In frequency: Tustin is G at the warped frequency; matched has the exponentials of the poles and zeros.
TEST(TimeRoutes, tustinAndMatchedAreTheirMapsOfTheAxis) {
    Random random(205);
    const double T = 0.05;
    for (int round = 0; round < 80; ++round) {
        const auto system = randomSystem(random, 1 + static_cast<int>(random.below(5)), true, round % 3 == 0);
        const auto plain = sampledBy(system, T, Hold::Tustin{});
        const auto warped = sampledBy(system, T, Hold::Tustin{11.0});
        const auto matched = sampledBy(system, T, Hold::Matched{});
        for (const double w : {0.3, 11.0, 50.0}) {
            const double bent = std::tan(0.5 * w * T);
            const Complex ofPlain = system.at({0.0, 2.0 / T * bent});
            const Complex ofWarped = system.at({0.0, 11.0 / std::tan(5.5 * T) * bent});
            const Complex z = std::polar(1.0, w * T);
            Complex roots = 1.0;
            Complex rest = 1.0;
            for (const Complex& zero : zeros(system)) {
                roots *= (z - std::exp(zero * T)) / (Complex(0.0, w) - zero);
                rest *= (1.0 - std::exp(zero * T)) / -zero;
            }
            for (const Complex& pole : poles(system)) {
                roots /= (z - std::exp(pole * T)) / (Complex(0.0, w) - pole);
                rest /= (1.0 - std::exp(pole * T)) / -pole;
            }
            const int atInfinity = system.order() - degree(system.numerator());
            const Complex ones = std::pow(0.5 * (z + 1.0), std::max(0, atInfinity - 1));
            // No zero at rest in these systems: the gain there is kept.
            const Complex ofMatched = system.atFrequency(w) * roots / rest * ones;
            const auto expectBoth = [&](const Sampled& found, Complex expected) {
                const double tolerance = 1e-9 + 100.0 * roundingOf(found.rational, w);
                EXPECT_LT(std::abs(StatePath(found.states).atFrequency(w) / expected - 1.0), tolerance)
                    << round;
                EXPECT_LT(std::abs(found.rational.atFrequency(w) / expected - 1.0), tolerance) << round;
            };
            expectBoth(plain, ofPlain);
            expectBoth(warped, ofWarped);
            expectBoth(matched, ofMatched);
        }
    }
}

Eigen::MatrixXd randomMatrix(Random& random, Eigen::Index rows, Eigen::Index cols) {
    Eigen::MatrixXd result(rows, cols);
    for (double& value : result.reshaped()) {
        value = random.gaussian();
    }
    return result;
}

// exp(A T) by the eigenvectors; the integrals by their own equations: A constant = transition - 1 times B,
// and A T slope = constant - T B. Eigenvectors of a random matrix keep some thirteen digits.
TEST(TimeRoutes, heldInputsFollowFromTheEigenvectors) {
    Random random(206);
    for (int round = 0; round < 60; ++round) {
        const auto n = 1 + static_cast<Eigen::Index>(random.below(6));
        const Eigen::MatrixXd A = randomMatrix(random, n, n);
        const Eigen::MatrixXd B = randomMatrix(random, n, 2);
        const double T = 0.1 + random.uniform();
        const HeldInput held = heldInput(A, B, T);
        const Eigen::EigenSolver<Eigen::MatrixXd> modes(A);
        const Eigen::MatrixXcd V = modes.eigenvectors();
        const Eigen::MatrixXd expected =
            (V * (modes.eigenvalues() * T).array().exp().matrix().asDiagonal() * V.inverse()).real();
        const double condition = V.norm() * V.inverse().norm();
        EXPECT_LT((held.transition - expected).norm(), 1e-13 * condition * expected.norm()) << round;
        const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(n, n);
        const double size = (1.0 + A.norm()) * (held.constant.norm() + B.norm());
        EXPECT_LT((A * held.constant - (held.transition - I) * B).norm(), 1e-12 * size) << round;
        EXPECT_LT((A * T * held.slope - (held.constant - T * B)).norm(), 1e-12 * T * size) << round;
    }
}

// Eigenvalues within the strip of the principal logarithm come back.
TEST(TimeRoutes, theLogarithmOfAnExponentialIsItsMatrix) {
    Random random(207);
    for (int round = 0; round < 60; ++round) {
        const auto n = 1 + static_cast<Eigen::Index>(random.below(6));
        Eigen::MatrixXd A = randomMatrix(random, n, n);
        A *= 2.0 / (1.0 + A.norm()); // all within 2 < pi
        const auto back = matrixLogarithm(heldInput(A, Eigen::MatrixXd::Zero(n, 1), 1.0).transition);
        ASSERT_TRUE(back.has_value());
        EXPECT_LT((*back - A).norm(), 1e-11) << round; // exp(2) squared is the condition of the logarithm
    }
}

} // namespace
} // namespace halbench::control
