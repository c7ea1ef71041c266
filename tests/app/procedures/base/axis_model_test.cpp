#include "app/procedures/base/axis_model.h"

#include <gtest/gtest.h>

#include <limits>

namespace halbench::app {
namespace {

using control::Estimate;
using control::EstimateSource;

Estimate exact(double value, const std::string& unit) {
    return {value, {}, EstimateSource::Given, unit};
}

AxisModel oneAxis() {
    AxisModel model;
    model.axes.push_back(
        {"x", "m", "N", exact(0.1, "1/s"), exact(1.5625, "m/(s^2*N)"), Estimate{}, {1e-3, 1}});
    model.covarianceNames = {"x.damping_rate", "x.acceleration_gain"};
    model.covariance = {{1e-4, 0.0}, {0.0, 1e-4}};
    return model;
}

ErrorCode refusal(const AxisModel& model, const std::string& word) {
    const auto checked = checkAxisModel(model);
    EXPECT_FALSE(checked);
    EXPECT_NE(checked.error().message.find(word), std::string::npos) << checked.error().message;
    return checked.error().code;
}

TEST(AxisModel, anAxisWithoutFrictionIsComplete) {
    EXPECT_TRUE(checkAxisModel(oneAxis()));
}

TEST(AxisModel, anAxisWithoutGainIsRefusedByName) {
    AxisModel model = oneAxis();
    model.axes[0].accelerationGain = Estimate{};
    EXPECT_EQ(refusal(model, "axis x: unknown acceleration gain"), ErrorCode::Refused);
}

TEST(AxisModel, valuesThatNoAxisHasAreRefused) {
    AxisModel model = oneAxis();
    model.axes[0].dampingRate = exact(-0.1, "1/s");
    EXPECT_EQ(refusal(model, "axis x: damping rate"), ErrorCode::OutOfRange);
    model = oneAxis();
    model.axes[0].accelerationGain = exact(std::numeric_limits<double>::infinity(), "m/(s^2*N)");
    EXPECT_EQ(refusal(model, "axis x: acceleration gain"), ErrorCode::NotFinite);
    model = oneAxis();
    model.axes[0].positionUnit = "mm";
    EXPECT_EQ(refusal(model, "\"mm\""), ErrorCode::InvalidInput);
    EXPECT_EQ(refusal(AxisModel{}, "no axis"), ErrorCode::InvalidInput);
}

TEST(AxisModel, aCovarianceHasARowForEachName) {
    AxisModel model = oneAxis();
    model.covariance.pop_back();
    EXPECT_EQ(refusal(model, "covariance"), ErrorCode::InvalidInput);
    model = oneAxis();
    model.covariance[0].pop_back();
    EXPECT_EQ(refusal(model, "covariance"), ErrorCode::InvalidInput);
    model = oneAxis();
    model.covarianceNames[1] = "x.damping_rate";
    EXPECT_EQ(refusal(model, "x.damping_rate"), ErrorCode::InvalidInput);
}

} // namespace
} // namespace halbench::app
