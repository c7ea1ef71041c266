// Elements, rules and equations of control/design with random numbers, each against its definition written
// out another way.
#include "control/assess/friction_cycles.h"
#include "control/base/units.h"
#include "control/design/crossover_design.h"
#include "control/design/tuning_rules.h"
#include "control/law/filters.h"
#include "control/law/sampled_axis.h"
#include "control/lti/riccati.h"
#include "tests/control/random_systems.h"
#include "tests/control/routes/own_loop.h"
#include "tests/control/routes/state_routes.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/KroneckerProduct>

namespace halbench::control {
namespace {

using Complex = std::complex<double>;

double between(Random& random, double low, double high) {
    return low * std::pow(high / low, random.uniform());
}

Eigen::MatrixXd randomMatrix(Random& random, Eigen::Index rows, Eigen::Index cols) {
    Eigen::MatrixXd result(rows, cols);
    for (double& value : result.reshaped()) {
        value = random.gaussian();
    }
    return result;
}

TEST(RuleRoutes, filtersAreTheFormulasOfTheirHeader) {
    Random random(401);
    for (int round = 0; round < 100; ++round) {
        const double w = between(random, 0.1, 1e3);
        const double phase_deg = 170.0 * random.uniform() - 85.0;
        const double ratio = between(random, 1.1, 100.0);
        const double depth = random.uniform();
        const double zeta = between(random, 0.01, 1.0);
        const double sine = std::sin(degreesToRadians(phase_deg));
        const double r = (1.0 + sine) / (1.0 - sine);
        for (const double share : {0.03, 0.9, 7.0}) {
            const Complex s(0.0, share * w);
            const std::pair<Result<TransferFunction>, Complex> pairs[] = {
                {leadFilter(w, phase_deg),
                 (1.0 + std::sqrt(r) * s / w) / (1.0 + s / (std::sqrt(r) * w)) / std::sqrt(r)},
                {lagFilter(w, ratio), (s + w) / (s + w / ratio)},
                {notchFilter(w, depth, zeta),
                 (s * s + 2.0 * depth * zeta * w * s + w * w) / (s * s + 2.0 * zeta * w * s + w * w)},
                {lowPassFilter(w, 1), w / (s + w)},
                {lowPassFilter(w, 2), w * w / (s * s + std::sqrt(2.0) * w * s + w * w)}};
            for (const auto& [filter, expected] : pairs) {
                ASSERT_TRUE(filter.has_value()) << round;
                EXPECT_LT(std::abs(filter->at(s) - expected), 1e-12 * std::abs(expected)) << round;
            }
        }
    }
}

TEST(RuleRoutes, everyFormOfAControllerHasTheSameResponse) {
    Random random(402);
    for (int round = 0; round < 100; ++round) {
        PidGains series;
        series.form = PidForm::Series;
        series.unit = round % 2 == 0 ? GainUnit::PerRadian : GainUnit::PerDegree;
        series.proportional = between(random, 0.1, 100.0);
        series.integral = between(random, 0.01, 10.0);
        series.derivative = between(random, 1e-3, 1.0);
        series.filter_s = 0.2 * std::min(series.derivative, series.integral);
        const double unit = round % 2 == 0 ? 1.0 : 180.0 / Pi;
        for (const PidForm form : {PidForm::Parallel, PidForm::Standard, PidForm::Series}) {
            for (const GainUnit other : {GainUnit::PerRadian, GainUnit::PerDegree}) {
                const auto there = convert(series, form, other);
                // Back to a series form only where its zeros are real, which a filter may prevent.
                ASSERT_TRUE(there.has_value() || form == PidForm::Series) << round;
                if (!there) {
                    continue;
                }
                const auto controller = continuousController(*there);
                ASSERT_TRUE(controller.has_value());
                for (const double w : {0.05, 3.0, 200.0}) {
                    const Complex s(0.0, w);
                    const Complex filtered = s / (1.0 + *series.filter_s * s);
                    const Complex expected = unit * series.proportional *
                                             (1.0 + 1.0 / (series.integral * s)) *
                                             (1.0 + series.derivative * filtered);
                    EXPECT_LT(std::abs(controller->atFrequency(w) / expected - 1.0), 1e-9) << round;
                }
            }
        }
    }
}

// The matrix exponential of the motor instead of its closed form.
TEST(RuleRoutes, theHeldRotorMovesAsItsMatrixExponential) {
    Random random(403);
    for (int round = 0; round < 100; ++round) {
        const OwnLoop own{
            {round % 5 == 0 ? 0.0 : between(random, 1e-6, 50.0), between(random, 1.0, 500.0), 0.0}, {}, {}};
        const Eigen::Vector3d from(random.gaussian(), 10.0 * random.gaussian(), random.gaussian());
        const double time_s = between(random, 1e-5, 0.5);
        const Eigen::Vector3d expected = own.motion(time_s) * from;
        const RotorState to = advance(own.plant, {from(0), from(1)}, from(2), time_s);
        const double size = 1.0 + from.cwiseAbs().maxCoeff() + expected.cwiseAbs().maxCoeff();
        EXPECT_NEAR(to.angle_rad, expected(0), 1e-13 * size) << round;
        EXPECT_NEAR(to.speed_rad_s, expected(1), 1e-13 * size) << round;
    }
}

// X = A X A' + Q as one linear system.
TEST(RuleRoutes, lyapunovsSolutionIsThatOfTheLinearSystem) {
    Random random(404);
    for (int round = 0; round < 40; ++round) {
        const auto n = 1 + static_cast<Eigen::Index>(random.below(5));
        Eigen::MatrixXd A = randomMatrix(random, n, n);
        A *= 0.95 / Eigen::EigenSolver<Eigen::MatrixXd>(A, false).eigenvalues().cwiseAbs().maxCoeff();
        const Eigen::MatrixXd root = randomMatrix(random, n, n);
        const Eigen::MatrixXd Q = root * root.transpose();
        const Eigen::MatrixXd whole =
            Eigen::MatrixXd::Identity(n * n, n * n) - Eigen::kroneckerProduct(A, A).eval();
        const Eigen::VectorXd stacked = whole.fullPivLu().solve(Eigen::VectorXd(Q.reshaped()));
        const Eigen::MatrixXd expected = stacked.reshaped(n, n);
        EXPECT_LT((solveLyapunov(A, Q) - expected).norm(), 1e-10 * expected.norm()) << round;
    }
}

// The stable invariant subspace of the symplectic matrix instead of doubling.
TEST(RuleRoutes, riccatisSolutionIsThatOfTheStableSubspace) {
    Random random(405);
    for (int round = 0; round < 40; ++round) {
        const auto n = 1 + static_cast<Eigen::Index>(random.below(4));
        const Eigen::MatrixXd A = randomMatrix(random, n, n);
        const Eigen::MatrixXd B = randomMatrix(random, n, 1);
        const Eigen::MatrixXd root = randomMatrix(random, n, n);
        const Eigen::MatrixXd Q = root * root.transpose();
        const Eigen::MatrixXd R = Eigen::MatrixXd::Constant(1, 1, between(random, 0.1, 10.0));
        const Eigen::MatrixXd G = B * R.inverse() * B.transpose();
        const Eigen::MatrixXd back = A.transpose().inverse();
        Eigen::MatrixXd symplectic(2 * n, 2 * n);
        symplectic << A + G * back * Q, -G * back, -back * Q, back;
        const Eigen::EigenSolver<Eigen::MatrixXd> modes(symplectic);
        Eigen::MatrixXcd stable(2 * n, n);
        Eigen::Index found = 0;
        for (Eigen::Index i = 0; i < 2 * n && found < n; ++i) {
            if (std::abs(modes.eigenvalues()(i)) < 1.0) {
                stable.col(found++) = modes.eigenvectors().col(i);
            }
        }
        ASSERT_EQ(found, n) << round;
        const Eigen::MatrixXd expected =
            (stable.bottomRows(n) * stable.topRows(n).fullPivLu().inverse()).real();
        const auto X = solveRiccati(A, B, Q, R);
        ASSERT_TRUE(X.has_value()) << round;
        // Eigenvectors of a random matrix of eight rows keep some eleven digits, and A is inverted.
        const double condition = A.norm() * back.norm();
        EXPECT_LT((*X - expected).norm(), 1e-11 * condition * condition * expected.norm()) << round;
    }
}

// 1 + N(A |C|) C(z) z^-d G(z) = 0 with the friction as damping in the motor's matrix exponential.
TEST(RuleRoutesSeeds, frictionCyclesBalanceTheLoopOfTheStates) {
    Random random(406);
    int checked = 0;
    for (int round = 0; round < 150; ++round) {
        OwnLoop own = randomStableLoop(random);
        own.gains.proportional *= 4.0; // beyond its limit, where a cycle is to be expected
        own.plant.breakawayCurrent_A = between(random, 0.01, 1.0);
        constexpr double Limit_A = 4.0;
        const auto cycles = frictionCycles(own.plant, own.gains, own.timing, Limit_A);
        ASSERT_TRUE(cycles.has_value()) << round;
        for (const LimitCycle& cycle : *cycles) {
            const double w = cycle.frequency_rad_s;
            const double T = own.timing.period_s;
            OwnLoop damped = own;
            damped.plant.dampingRate_1_s += 4.0 * own.plant.breakawayCurrent_A *
                                            own.plant.accelerationGain_rad_s2_A / (Pi * cycle.amplitude * w);
            const Eigen::Matrix3d M = damped.motion(T);
            const Complex z = std::polar(1.0, w * T);
            const Complex law = own.gains.proportional + T * own.gains.integral / (z - 1.0) +
                                own.gains.derivative / T * (z - 1.0) / z;
            const Complex motor = (M(0, 2) + M(0, 1) * M(1, 2) / (z - M(1, 1))) / (z - 1.0);
            const double r = std::min(1.0, Limit_A / (cycle.amplitude * std::abs(law)));
            const double N = 2.0 / Pi * (std::asin(r) + r * std::sqrt(1.0 - r * r));
            const Complex rest = 1.0 + N * law * motor * std::pow(z, -own.timing.delay_samples);
            // The frequency is bisected to its rounding and the amplitude follows from a difference of two
            // dampings, of which the larger may be a thousand times the smaller.
            EXPECT_LT(std::abs(rest), 1e-7) << round << " at " << w;
            ++checked;
        }
    }
    EXPECT_GT(checked, 50);
}

// Random motors: the loop of the states, closed over the turned gain, has a pole at the crossover.
TEST(RuleRoutesSeeds, aDesignedCrossoverIsThatOfTheStates) {
    Random random(407);
    int met = 0;
    for (int round = 0; round < 100; ++round) {
        OwnLoop own = randomStableLoop(random);
        const CrossoverAim aim{between(random, 0.02, 0.3) /
                                   (own.timing.period_s * (1 + own.timing.delay_samples)),
                               35.0 + 20.0 * random.uniform(), 0.03};
        const auto design = designCrossover(own.plant, own.timing, aim, CrossoverPriority::Margin);
        if (!design || design->limit != CrossoverLimit::None) {
            continue;
        }
        own.gains = design->gains;
        const Complex turn = std::polar(1.0, -degreesToRadians(aim.phaseMargin_deg));
        const Complex place = std::polar(1.0, aim.crossover_rad_s * own.timing.period_s);
        EXPECT_LT(distanceTo(closedPoles(own.open(), turn), place), 1e-9) << round;
        EXPECT_LT(own.poleRadius(), 1.0) << round;
        ++met;
    }
    EXPECT_GT(met, 30);
}

// The gain at which the eigenvalues of the loop reach the axis, and the turn they have there.
TEST(RuleRoutes, theUltimatePointIsWhereTheEigenvaluesReachTheAxis) {
    Random random(408);
    int found = 0;
    for (int round = 0; round < 100; ++round) {
        const auto plant = randomSystem(random, 3 + static_cast<int>(random.below(3)), true);
        const auto ultimate = ultimatePoint(plant);
        if (!ultimate) {
            continue;
        }
        const StateSpace states = sectionsOf(plant);
        const double w = 2.0 * Pi / ultimate->period_s;
        EXPECT_LT(distanceTo(closedPoles(states, ultimate->gain), {0.0, w}), 1e-8 * (1.0 + w)) << round;
        ++found;
    }
    EXPECT_GT(found, 30);
}

// Of random lags: what is cancelled leaves the loop 1/(lambda s) behind the dead time (Dahlin).
TEST(RuleRoutes, lambdaLeavesAnIntegratorBehindTheDeadTime) {
    Random random(409);
    for (int round = 0; round < 60; ++round) {
        const LaggedProcess process{between(random, 0.1, 10.0), between(random, 0.1, 10.0), 0.0,
                                    between(random, 0.01, 1.0), false};
        const double lambda_s = between(random, 0.05, 5.0);
        const auto tuned = lambdaGains(process, lambda_s);
        ASSERT_TRUE(tuned.has_value());
        const PidGains pi = *convert(*tuned, PidForm::Parallel, GainUnit::PerRadian);
        for (const double w : {0.1, 1.0, 10.0}) {
            const Complex s(0.0, w);
            const Complex loop =
                (pi.proportional + pi.integral / s) * process.gain / (process.timeConstant_s * s + 1.0);
            const Complex expected = 1.0 / (s * (lambda_s + process.deadTime_s));
            EXPECT_LT(std::abs(loop / expected - 1.0), 1e-12) << round;
        }
    }
}

// Walked outwards: the largest error at which the law stays below the breakaway current.
TEST(RuleRoutes, theFrictionBandOfRandomLawsIsTheLargestErrorThatRests) {
    Random random(410);
    for (int round = 0; round < 60; ++round) {
        const PositionPlant plant{2.0, 26.0, between(random, 0.05, 3.0)};
        PositionLaw law;
        law.gains.proportional = between(random, 1.0, 500.0);
        law.stictionCurrent_A = round % 3 == 0 ? 0.0 : 1.2 * random.uniform() * plant.breakawayCurrent_A;
        law.stictionThreshold_rad = between(random, 1e-3, 0.1);
        const double most_rad = plant.breakawayCurrent_A / law.gains.proportional;
        double rests_rad = 0.0;
        for (int i = 0; i <= 100000; ++i) {
            const double error_rad = 1.1 * most_rad * i / 100000;
            const double assist_A = error_rad > law.stictionThreshold_rad ? law.stictionCurrent_A : 0.0;
            const double asked_A = law.gains.proportional * error_rad + assist_A;
            rests_rad = asked_A <= plant.breakawayCurrent_A ? error_rad : rests_rad;
        }
        EXPECT_NEAR(frictionBand_rad(plant, law), rests_rad, 2.2e-5 * most_rad) << round; // two strides
    }
}

} // namespace
} // namespace halbench::control
