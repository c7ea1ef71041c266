#include "control/base/units.h"
#include "control/lti/discretize.h"
#include "control/lti/realization.h"
#include "control/lti/state_response.h"
#include "control/lti/zero_pole_gain.h"
#include "tests/control/random_systems.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;
const TimeBase Continuous = TimeBase::continuous();

double relative(Complex a, Complex b) {
    return std::abs(a - b) / std::abs(b);
}

ZeroPoleGain make(ZeroPoleGain::Roots zeros, ZeroPoleGain::Roots poles, double gain) {
    return *ZeroPoleGain::make(std::move(zeros), std::move(poles), gain, Continuous);
}

TEST(ZeroPoleGain, refusesWhatIsNoRealSystem) {
    EXPECT_EQ(ZeroPoleGain::make({}, {{-1.0, 2.0}}, 1.0, Continuous).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(ZeroPoleGain::make({{1.0, 0.0}}, {}, 1.0, Continuous).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(ZeroPoleGain::make({}, {}, std::nan(""), Continuous).error().code, ErrorCode::NotFinite);
}

TEST(ZeroPoleGain, goesThroughEveryDescriptionAndBack) {
    Random random(1);
    for (int round = 0; round < 100; ++round) {
        const auto system =
            randomSystem(random, 1 + static_cast<int>(random.below(6)), false, round % 4 == 0);
        const ZeroPoleGain factors = toZeroPoleGain(system);
        const auto back = toTransferFunction(factors);
        const StateSpace states = toStateSpace(factors);
        const auto throughStates = toTransferFunction(states);
        const auto factorsOfStates = toZeroPoleGain(states);
        ASSERT_TRUE(back && throughStates && factorsOfStates);
        ASSERT_EQ(factorsOfStates->zeros().size(), factors.zeros().size()) << round;
        for (const double w : {0.05, 1.3, 20.0}) {
            const Complex expected = system.atFrequency(w);
            EXPECT_LT(relative(factors.atFrequency(w), expected), 1e-9);
            EXPECT_LT(relative(back->atFrequency(w), expected), 1e-9);
            EXPECT_LT(relative(throughStates->atFrequency(w), expected), 1e-9);
            EXPECT_LT(relative(factorsOfStates->atFrequency(w), expected), 1e-9);
        }
    }
}

TEST(ZeroPoleGain, combinesAsTheValuesDo) {
    Random random(2);
    for (int round = 0; round < 50; ++round) {
        const auto first = toZeroPoleGain(randomSystem(random, 3));
        const auto second = toZeroPoleGain(randomSystem(random, 2, true, true));
        const Complex s(0.2, 2.7);
        const Complex a = first.at(s);
        const Complex b = second.at(s);
        EXPECT_LT(relative(series(first, second)->at(s), a * b), 1e-12);
        EXPECT_LT(relative(parallel(first, second)->at(s), a + b), 1e-9);
        EXPECT_LT(relative(feedback(first, second)->at(s), a / (1.0 + a * b)), 1e-9);
    }
    const auto sampled = *ZeroPoleGain::make({}, {{0.5, 0.0}}, 1.0, TimeBase::sampled(0.1));
    EXPECT_EQ(series(make({}, {}, 1.0), sampled).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(feedback(make({}, {}, -1.0), make({}, {}, 1.0)).error().code, ErrorCode::InvalidInput);
}

TEST(ZeroPoleGain, dcGainIsTheValueAtRest) {
    EXPECT_DOUBLE_EQ(make({{-2.0, 0.0}}, {{-1.0, 3.0}, {-1.0, -3.0}}, 5.0).dcGain(), 1.0);
    EXPECT_EQ(make({}, {{0.0, 0.0}}, 1.0).dcGain(), std::numeric_limits<double>::infinity());
}

TEST(ZeroPoleGain, aCancelledPairLeavesAndAnotherStays) {
    const auto full = make({{-1.0, 2.0}, {-1.0, -2.0}, {-7.0, 0.0}},
                           {{-1.0, 2.0}, {-1.0, -2.0}, {-3.0, 0.0}, {-7.1, 0.0}}, 2.0);
    const auto small = minimalRealization(full);
    EXPECT_EQ(small.zeros().size(), 1u);
    EXPECT_EQ(small.poles().size(), 2u);
    EXPECT_LT(relative(small.at({0.3, 0.4}), full.at({0.3, 0.4})), 1e-14);
}

TEST(StateSpaces, combineAsTheValuesDo) {
    Random random(6);
    for (int round = 0; round < 50; ++round) {
        const auto a = randomSystem(random, 3, true, round % 2 == 0);
        const auto b = randomSystem(random, 2, true, round % 3 == 0);
        const StateSpace first = toStateSpace(a);
        const StateSpace second = toStateSpace(b);
        const Complex s(0.2, 2.7);
        const auto value = [&s](const Result<StateSpace>& system) { return StatePath(*system).at(s); };
        EXPECT_LT(relative(value(series(first, second)), a.at(s) * b.at(s)), 1e-10);
        EXPECT_LT(relative(value(parallel(first, second)), a.at(s) + b.at(s)), 1e-10);
        EXPECT_LT(relative(value(feedback(first, second)), a.at(s) / (1.0 + a.at(s) * b.at(s))), 1e-10);
    }
}

TEST(StateSpaces, refuseWhatCannotBeConnected) {
    const StateSpace one = toStateSpace(*TransferFunction::make({1.0}, {1.0, 1.0}, Continuous));
    StateSpace two = one;
    two.B = Eigen::MatrixXd::Ones(1, 2);
    two.D = Eigen::MatrixXd::Zero(1, 2);
    EXPECT_EQ(series(one, two).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(parallel(one, two).error().code, ErrorCode::InvalidInput);
    EXPECT_EQ(feedback(one, two).error().code, ErrorCode::InvalidInput);
    const StateSpace minus = toStateSpace(TransferFunction::gain(-1.0, Continuous));
    const StateSpace plus = toStateSpace(TransferFunction::gain(1.0, Continuous));
    EXPECT_EQ(feedback(minus, plus).error().code, ErrorCode::InvalidInput);
}

TEST(StateSpaces, dcGainIsThatOfTheTransferFunction) {
    const auto system = *TransferFunction::make({2.0, 3.0}, {1.0, 4.0, 6.0}, Continuous);
    EXPECT_NEAR(dcGain(toStateSpace(system))(0, 0), 0.5, 1e-14);
    const auto sampled = *discretize(system, 0.1, Hold::Zoh{});
    EXPECT_NEAR(dcGain(toStateSpace(sampled))(0, 0), 0.5, 1e-12);
    const auto integrator = *TransferFunction::make({1.0}, {1.0, 0.0}, Continuous);
    EXPECT_TRUE(std::isinf(dcGain(toStateSpace(integrator))(0, 0)));
}

// A motor seen through an observer that doubles its states: half of them are not reached.
TEST(Realization, minimalDropsWhatIsNotReachedOrNotSeen) {
    Random random(8);
    for (int round = 0; round < 30; ++round) {
        const auto system = randomSystem(random, 3);
        const auto other = randomSystem(random, 2);
        // G - H + G + H: H is there twice with opposite signs, G twice with the same.
        const StateSpace G = toStateSpace(system);
        const StateSpace H = toStateSpace(other);
        StateSpace minusH = H;
        minusH.C = -minusH.C;
        const StateSpace sum = *parallel(*parallel(G, H), *parallel(G, minusH));
        ASSERT_EQ(sum.states(), 10);
        const StateSpace small = minimalRealization(sum);
        EXPECT_EQ(small.states(), 3) << round;
        for (const double w : {0.1, 2.0, 15.0}) {
            EXPECT_LT(relative(StatePath(small).atFrequency(w), 2.0 * system.atFrequency(w)), 1e-9);
        }
    }
}

// With several inputs and outputs: two motors, the second not driven.
TEST(Realization, minimalWorksOnSeveralInputsAndOutputs) {
    const StateSpace system = *makeStateSpace(Eigen::Vector4d(-1.0, -2.0, -3.0, -4.0).asDiagonal(),
                                              (Eigen::MatrixXd(4, 2) << 1, 0, 0, 1, 0, 0, 1, 1).finished(),
                                              (Eigen::MatrixXd(2, 4) << 1, 1, 1, 0, 0, 1, 1, 0).finished(),
                                              Eigen::MatrixXd::Zero(2, 2), Continuous);
    EXPECT_EQ(minimalRealization(system).states(), 2); // -3 is not reached, -4 not seen
}

TEST(Realization, zerosAreTheRootsOfTheNumerator) {
    Random random(12);
    for (int round = 0; round < 100; ++round) {
        const auto system = randomSystem(random, 2 + static_cast<int>(random.below(5)), true, round % 4 == 0);
        const auto expected = zeros(system);
        const auto found = zeros(toStateSpace(toZeroPoleGain(system)));
        ASSERT_EQ(found.size(), expected.size()) << round;
        for (const Complex& zero : expected) {
            double nearest = HUGE_VAL;
            for (const Complex& candidate : found) {
                nearest = std::min(nearest, relative(candidate, zero));
            }
            EXPECT_LT(nearest, 1e-6) << round; // zeros that lie close together share their digits
        }
    }
}

TEST(Realization, aPathThatCarriesNothingHasNoGain) {
    const StateSpace apart =
        *makeStateSpace(Eigen::Vector2d(-1.0, -2.0).asDiagonal(), Eigen::Vector2d(1.0, 0.0),
                        Eigen::RowVector2d(0.0, 1.0), Eigen::MatrixXd::Zero(1, 1), Continuous);
    EXPECT_EQ(pathZeros(apart).gain, 0.0);
    EXPECT_EQ(StatePath(apart).at({0.0, 1.0}), Complex(0.0, 0.0));
}

// Rates over eight decades in a companion form: the plain eigenvalues of A would lose the slow ones.
TEST(Realization, prescalingKeepsTheSlowPolesOfACompanionForm) {
    const ZeroPoleGain::Roots rates = {{-1e-3, 0.0}, {-0.1, 0.0}, {-10.0, 0.0}, {-1e3, 0.0}, {-1e5, 0.0}};
    const StateSpace companion = toStateSpace(*TransferFunction::make({1.0}, fromRoots(rates), Continuous));
    const auto found = poles(prescaled(companion));
    for (const Complex& rate : rates) {
        double nearest = HUGE_VAL;
        for (const Complex& candidate : found) {
            nearest = std::min(nearest, relative(candidate, rate));
        }
        EXPECT_LT(nearest, 1e-9);
    }
}

// 1.2e6 (s+30)/((s+1)(s+5)(s^2+4s+400)(s^2+36s+3600)), the example that control packages agree on.
TEST(StateResponse, ofTheSixthOrderExampleIsTheFactoredForm) {
    const auto factors = make({{-30.0, 0.0}},
                              {{-1.0, 0.0},
                               {-5.0, 0.0},
                               {-2.0, std::sqrt(396.0)},
                               {-2.0, -std::sqrt(396.0)},
                               {-18.0, std::sqrt(3276.0)},
                               {-18.0, -std::sqrt(3276.0)}},
                              1.2e6);
    const StateSpace companion = toStateSpace(*toTransferFunction(factors));
    const auto frequencies = logarithmicFrequencies(0.01, 1e4, 1000);
    const auto response = frequencyResponse(companion, frequencies);
    ASSERT_TRUE(response.has_value());
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        EXPECT_LT(relative(response->value[i], factors.atFrequency(frequencies[i])), 1e-12) << frequencies[i];
    }
}

// Rates over six decades and up to 40 states, as a chain of sections. The factored form is exact to rounding;
// the matrix carries rounding of its largest entry, 1e-16 x 1e3/1e-3, into the slowest pole.
TEST(StateResponse, staysAccurateForBadlyScaledAndHighOrderSystems) {
    Random random(14);
    for (const int order : {10, 20, 40}) {
        ZeroPoleGain::Roots poles;
        ZeroPoleGain::Roots zeros;
        double dc = 1.0;
        for (int i = 0; i < order / 2; ++i) {
            const double w = 1e-3 * std::pow(1e6, (i + 0.5) * 2.0 / order);
            const double zeta = 0.02 + 0.9 * random.uniform();
            poles.emplace_back(-zeta * w, w * std::sqrt(1.0 - zeta * zeta));
            poles.push_back(std::conj(poles.back()));
            if (i % 2 == 0) {
                zeros.emplace_back(-1.3 * w, 0.0);
                dc *= w / 1.3;
            } else {
                dc *= w * w;
            }
        }
        const auto factors = make(zeros, poles, dc);
        const auto frequencies = logarithmicFrequencies(1e-4, 1e3, 400);
        const auto response = frequencyResponse(toStateSpace(factors), frequencies);
        ASSERT_TRUE(response.has_value());
        double worst = 0.0;
        for (std::size_t i = 0; i < frequencies.size(); ++i) {
            worst = std::max(worst, relative(response->value[i], factors.atFrequency(frequencies[i])));
        }
        EXPECT_LT(worst, 1e-9) << order;
    }
}

// Second route: the definition, D + C (z - A)^-1 B by LU, for dense random matrices of one of several paths.
TEST(StateResponse, agreesWithTheDefinitionOnRandomMatrices) {
    Random random(15);
    for (int round = 0; round < 40; ++round) {
        const Eigen::Index n = 1 + static_cast<Eigen::Index>(random.below(80));
        const auto matrix = [&random](Eigen::Index rows, Eigen::Index cols) {
            Eigen::MatrixXd result(rows, cols);
            for (double& value : result.reshaped()) {
                value = random.gaussian();
            }
            return result;
        };
        const StateSpace system{0.3 * matrix(n, n), matrix(n, 2), matrix(2, n), matrix(2, 2),
                                TimeBase::sampled(0.1)};
        const StatePath path(system, 1, 0);
        for (const double w : {0.5, 11.0, 30.0}) {
            const Complex z = std::polar(1.0, 0.1 * w);
            const Eigen::MatrixXcd inner = z * Eigen::MatrixXcd::Identity(n, n) - system.A;
            const Eigen::VectorXcd x = inner.fullPivLu().solve(system.B.col(0).cast<Complex>());
            const Complex expected = system.D(1, 0) + (system.C.row(1).cast<Complex>() * x)(0);
            // Of the states: both eliminations lose what the matrix is near to singular there.
            EXPECT_LT(std::abs(path.atFrequency(w) - expected), 1e-9 * (1.0 + x.norm())) << n;
        }
    }
}

TEST(StateResponse, refusesPathsAndFrequenciesThatDoNotExist) {
    const StateSpace system =
        toStateSpace(*TransferFunction::make({1.0}, {1.0, -0.5}, TimeBase::sampled(0.01)));
    EXPECT_EQ(frequencyResponse(system, {400.0}).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(frequencyResponse(system, {1.0}, 1, 0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(toZeroPoleGain(system, 0, 1).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(frequencyResponse(make({}, {}, 1.0), {0.0}).error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control
