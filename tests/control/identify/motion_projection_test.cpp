#include "control/identify/motion_projection.h"
#include "control/identify/motion_shape.h"
#include "tests/control/identify/motion_records.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace halbench::control {
namespace {

std::vector<MotionSegment> someSegments() {
    RecordMaker maker({}, {0.03, 1e-3, 5e-3, 0.0}, 3);
    for (int i = 0; i < 12; ++i) {
        maker.run(4.0, 1.0);
        maker.run(0.0, 1.0);
    }
    const auto plateaus = findPlateaus(maker.time_s, maker.current_column_A, {}, {});
    return findMotion(maker.time_s, maker.angle_rad, *plateaus, {});
}

TEST(MotionProjection, leavesAResidualThatNoLinearUnknownExplains) {
    const auto segments = someSegments();
    MotionColumns columns;
    columns.orders = 2;
    const MotionSolution solution = solveMotion(segments, 2.2, columns);
    const double size = solution.rest.norm();
    EXPECT_LT((solution.columns.transpose() * solution.rest).norm(), 1e-8 * solution.columns.norm() * size);
    Eigen::Index row = 0;
    for (const ProjectedSegment& part : solution.parts) {
        const auto rest = solution.rest.segment(row, part.angle.size());
        EXPECT_LT((part.local.transpose() * rest).norm(), 1e-8 * part.local.norm() * size);
        row += part.angle.size();
    }
}

TEST(MotionProjection, knowsHowTheResidualMovesWithTheDamping) {
    const auto segments = someSegments();
    constexpr double Damping = 2.236;
    constexpr double Step = 1e-4;
    const MotionSolution middle = solveMotion(segments, Damping, {});
    const Eigen::VectorXd column = dampingColumn(segments, middle, Damping);
    const Eigen::VectorXd moved =
        solveMotion(segments, Damping + Step, {}).rest - solveMotion(segments, Damping - Step, {}).rest;
    // Kaufman: the residual moves by minus the projected derivative, up to terms of the residual itself
    // (1e-3 rad of noise against angles of tens of rad).
    EXPECT_LT((moved / (2.0 * Step) + column).norm(), 0.02 * column.norm());
}

TEST(MotionProjection, theSandwichAgreesWithIndependentNoiseWhenTheNoiseIsIndependent) {
    // With white noise the sandwich and s^2 (X'X)^-1 agree on the average: 24 clusters know it to some 30 %.
    const auto segments = someSegments();
    MotionColumns columns;
    columns.orders = 2;
    const MotionSolution solution = solveMotion(segments, 2.2364, columns);
    const Eigen::VectorXd damping = dampingColumn(segments, solution, 2.2364);
    const Eigen::MatrixXd covariance = sandwichCovariance(solution, damping);
    Eigen::MatrixXd all(damping.size(), 5);
    all << solution.columns, damping;
    const double noise = solution.squares / static_cast<double>(damping.size() - 3 * 24 - 5);
    const Eigen::MatrixXd plain = noise * (all.transpose() * all).inverse();
    for (Eigen::Index i = 0; i < 5; ++i) {
        EXPECT_NEAR(std::sqrt(covariance(i, i) / plain(i, i)), 1.0, 0.5);
    }
}

TEST(MotionShape, answersAForceThatDependsOnSpeed) {
    // At constant speed w the force w^2 is constant: delta = w^2 (t/a - (1 - e^-at)/a^2).
    MotionSegment segment;
    for (int i = 0; i <= 100; ++i) {
        segment.time_s.push_back(0.01 * i);
        segment.angle_rad.push_back(0.05 * i);
    }
    const Eigen::VectorXd shape =
        forceShape(segment, 2.0, {5.0, 0.0}, [](double speed) { return speed * speed; });
    // trapezoids of 10 ms: (0.01)^2/12 relative
    EXPECT_NEAR(shape(100), 25.0 * (1.0 / 2.0 + std::expm1(-2.0) / 4.0), 2e-3);
}

TEST(MotionProjection, clustersOfOneColumnAreRaisedByTheirLeverage) {
    const auto segments = someSegments();
    const MotionSolution solution = solveMotion(segments, 2.2364, {});
    const Eigen::VectorXd column = dampingColumn(segments, solution, 2.2364);
    const auto fit = fitClusters(solution, column);
    ASSERT_TRUE(fit);
    // The definition of CR2 written out for one column, segment by segment.
    const double size = column.squaredNorm();
    const double value = column.dot(solution.rest) / size;
    const Eigen::VectorXd rest = solution.rest - value * column;
    double meat = 0.0;
    double squares = 0.0;
    Eigen::Index row = 0;
    for (const ProjectedSegment& part : solution.parts) {
        const auto here = column.segment(row, part.angle.size());
        const double leverage = here.squaredNorm() / size;
        const double score = here.dot(rest.segment(row, part.angle.size()));
        meat += score * score / (1.0 - leverage);
        squares += leverage * leverage;
        row += part.angle.size();
    }
    EXPECT_NEAR(fit->values(0), value, 1e-9 * std::fabs(value));
    EXPECT_NEAR(fit->covariance(0, 0), meat / (size * size), 1e-9 * meat / (size * size));
    EXPECT_NEAR(fit->freedom(0), 1.0 / squares - 1.0, 1e-6);
    EXPECT_LT(fit->freedom(0), static_cast<double>(segments.size()) - 1.0);
    Eigen::MatrixXd twice(column.size(), 2);
    twice << column, 2.0 * column;
    EXPECT_FALSE(fitClusters(solution, twice));
}

} // namespace
} // namespace halbench::control
