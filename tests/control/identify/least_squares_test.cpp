#include "control/base/random.h"
#include "control/identify/adequacy.h"
#include "control/identify/least_squares.h"
#include "control/identify/resampling.h"
#include "control/identify/robust_fit.h"
#include "control/identify/scatter_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace halbench::control {
namespace {

Eigen::MatrixXd line(const std::vector<double>& x) {
    Eigen::MatrixXd design(static_cast<Eigen::Index>(x.size()), 2);
    for (std::size_t i = 0; i < x.size(); ++i) {
        design.row(static_cast<Eigen::Index>(i)) << x[i], 1.0;
    }
    return design;
}

Eigen::VectorXd column(const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

FitQuantity identity() {
    return [](const Eigen::VectorXd& coefficients) { return coefficients; };
}

TEST(LeastSquares, meetsTheHandCalculationOfAStraightLine) {
    // x = 0 1 2 3, y = 1 3 4 8: slope 11/5 (Sxy/Sxx = 11/5), intercept 4 - 2.2*1.5 = 0.7,
    // residuals 0.3 0.1 -1.1 0.7: sum of squares 1.8, s^2 = 0.9, var(slope) = 0.9/5
    const auto fit = fitLinear(line({0, 1, 2, 3}), column({1, 3, 4, 8}));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->coefficients(0), 2.2, 1e-13);
    EXPECT_NEAR(fit->coefficients(1), 0.7, 1e-13);
    EXPECT_NEAR(fit->residualVariance, 0.9, 1e-13);
    EXPECT_NEAR(fit->covariance(0, 0), 0.18, 1e-13);
    EXPECT_NEAR(fit->covariance(1, 1), 0.9 * (0.25 + 2.25 / 5.0), 1e-13);
    EXPECT_NEAR(fit->covariance(0, 1), -0.9 * 1.5 / 5.0, 1e-13);
    EXPECT_NEAR(fit->leverage.sum(), 2.0, 1e-13); // trace of the hat matrix = number of coefficients
    EXPECT_EQ(fit->freedom, 2);
}

TEST(LeastSquares, meanIsTheSumOverTheCount) {
    const std::vector<double> values = {1.0, 2.0, 6.0};
    EXPECT_EQ(mean(values), 3.0);
    EXPECT_EQ(mean(std::span(values).first(1)), 1.0);
}

TEST(LeastSquares, aPointOfDoubleWeightCountsTwice) {
    const auto weighted = fitLinear(line({0, 1, 3}), column({1, 2, 5}), column({1, 2, 1}));
    const auto repeated = fitLinear(line({0, 1, 1, 3}), column({1, 2, 2, 5}));
    ASSERT_TRUE(weighted && repeated);
    EXPECT_LT((weighted->coefficients - repeated->coefficients).norm(), 1e-13);
    EXPECT_LT((weighted->unscaled - repeated->unscaled).norm(), 1e-13);
}

TEST(LeastSquares, refusesColumnsThatCannotBeToldApart) {
    const auto fit = fitLinear(line({2, 2, 2}), column({1, 2, 3}));
    ASSERT_FALSE(fit);
    EXPECT_EQ(fit.error().code, ErrorCode::Refused);
    EXPECT_FALSE(fitLinear(line({2}), column({1})));
    const auto broken = fitLinear(line({0, 1, 2}), column({1, NAN, 3}));
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().code, ErrorCode::NotFinite);
}

TEST(LeastSquares, unitsDoNotDecideTheRank) {
    Eigen::MatrixXd design = line({0, 1, 2, 3});
    design.col(0) *= 1e-9;
    const auto fit = fitLinear(design, column({1, 3, 4, 8}));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->coefficients(0), 2.2e9, 1e-3);
}

TEST(RobustFit, ignoresOneWildPointWhereTheOrdinaryFitFollowsIt) {
    std::vector<double> x;
    std::vector<double> y;
    Random random(3);
    for (int i = 0; i < 20; ++i) {
        x.push_back(i);
        y.push_back(2.0 * i + 1.0 + 0.1 * random.gaussian());
    }
    y[18] += 30.0;
    for (const RobustLoss loss : {RobustLoss::Huber, RobustLoss::Bisquare}) {
        const auto fit = fitRobust(line(x), column(y), Eigen::VectorXd::Ones(20), loss);
        ASSERT_TRUE(fit);
        // slope error of 20 clean points: 0.1/sqrt(665) = 0.004; Huber still leans a little on the outlier
        EXPECT_NEAR(fit->fit.coefficients(0), 2.0, 0.02);
        EXPECT_GT(std::fabs(fit->ordinary.coefficients(0) - 2.0), 0.3);
        EXPECT_TRUE(fit->differsFromOrdinary);
        EXPECT_LT(fit->weights(18), 0.02);
    }
    EXPECT_EQ(fitRobust(line(x), column(y), Eigen::VectorXd::Ones(20), RobustLoss::Bisquare)->weights(18),
              0.0);
}

TEST(RobustFit, isQuietOnCleanData) {
    std::vector<double> x;
    std::vector<double> y;
    Random random(4);
    for (int i = 0; i < 40; ++i) {
        x.push_back(i);
        y.push_back(2.0 * i + 1.0 + random.gaussian());
    }
    const auto fit = fitRobust(line(x), column(y), Eigen::VectorXd::Ones(40));
    ASSERT_TRUE(fit);
    EXPECT_FALSE(fit->differsFromOrdinary);
    // 95 % efficiency: standard errors agree within their own scatter, 1/sqrt(2*38) = 11 %, three sigma
    EXPECT_NEAR(std::sqrt(fit->fit.covariance(0, 0) / fit->ordinary.covariance(0, 0)), 1.0, 0.33);
}

TEST(RobustFit, leavesExactDataExact) {
    const auto fit = fitRobust(line({0, 1, 2, 3}), column({1, 3, 5, 7}), Eigen::VectorXd::Ones(4));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->fit.coefficients(0), 2.0, 1e-12);
    EXPECT_FALSE(fit->differsFromOrdinary);
}

TEST(Bootstrap, agreesWithTheAnalyticIntervalAndRepeatsForASeed) {
    std::vector<double> x;
    std::vector<double> y;
    Random random(5);
    for (int i = 0; i < 60; ++i) {
        x.push_back(i % 10);
        y.push_back(0.5 * (i % 10) + random.gaussian());
    }
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(60);
    const auto first = bootstrapPairs(line(x), column(y), ones, identity(), 7);
    const auto second = bootstrapPairs(line(x), column(y), ones, identity(), 7);
    const auto fit = fitLinear(line(x), column(y));
    ASSERT_TRUE(first && second && fit);
    EXPECT_EQ(first->draws, 2000);
    EXPECT_EQ(first->interval95[0], second->interval95[0]);
    const double half = 0.5 * (first->interval95[0].second - first->interval95[0].first);
    // width of a percentile interval from 2000 draws: 3 %; pairs against the analytic error at n = 60: 10 %
    EXPECT_NEAR(half / (1.96 * std::sqrt(fit->covariance(0, 0))), 1.0, 0.25);
}

TEST(LeaveOneOut, namesThePointThatCarriesTheSlope) {
    const std::vector<double> x{0, 0.1, 0.2, 0.1, 0.0, 10};
    const std::vector<double> y{0, 0.3, 0.1, -0.1, 0.1, 20};
    const auto fit = fitLinear(line(x), column(y));
    ASSERT_TRUE(fit);
    const Eigen::VectorXd sigma = fit->covariance.diagonal().cwiseSqrt();
    const Eigen::MatrixXd influence =
        leaveOneOut(line(x), column(y), Eigen::VectorXd::Ones(6), identity(), sigma);
    EXPECT_EQ(
        [&] {
            Eigen::Index row = 0;
            influence.col(0).cwiseAbs().maxCoeff(&row);
            return row;
        }(),
        5);
    EXPECT_GT(std::fabs(influence(5, 0)), 3.0);
}

TEST(ScatterFit, splitsMeasuringErrorFromCommonScatter) {
    std::vector<double> x;
    std::vector<double> y;
    Eigen::VectorXd variance(400);
    Random random(6);
    for (int i = 0; i < 400; ++i) {
        const double measuring = i % 2 == 0 ? 0.1 : 2.0;
        variance(i) = measuring * measuring;
        x.push_back(i % 20);
        y.push_back(3.0 * (i % 20) + 1.0 * random.gaussian() + measuring * random.gaussian());
    }
    const auto fit = fitWithScatter(line(x), column(y), variance);
    ASSERT_TRUE(fit);
    // the good half alone gives the common variance to sqrt(2/200) = 10 %; three sigma
    EXPECT_NEAR(fit->commonVariance, 1.0, 0.3);
    EXPECT_NEAR(fit->fit.residualVariance, 1.0, 1e-6); // by construction of the moment estimate
}

TEST(Adequacy, findsCurvatureByRepeatsAndByRuns) {
    std::vector<double> level;
    std::vector<double> curved;
    std::vector<double> straight;
    Random random(8);
    for (int i = 0; i < 24; ++i) {
        const double x = i / 2;
        level.push_back(x);
        straight.push_back(random.gaussian());
        curved.push_back(0.2 * ((x - 5.5) * (x - 5.5) - 12.0) + 0.3 * random.gaussian());
    }
    const auto good = testLackOfFit(level, straight, 2);
    const auto bad = testLackOfFit(level, curved, 2);
    ASSERT_TRUE(good && bad);
    EXPECT_EQ(good->pureFreedom, 12);
    EXPECT_EQ(good->lackFreedom, 10);
    EXPECT_GT(good->probability, 0.01);
    EXPECT_LT(bad->probability, 1e-6);
    EXPECT_LT(testRuns(curved).probability, 0.001);
    EXPECT_GT(testRuns(straight).probability, 0.01);
    EXPECT_FALSE(testLackOfFit(std::vector<double>{1, 2, 3}, std::vector<double>{0, 0, 0}, 2));
}

} // namespace
} // namespace halbench::control
