#include "app/experiments/run_outcome.h"

#include <gtest/gtest.h>

#include <limits>

namespace halbench::app {
namespace {

JsonValue sweepBody() {
    return parseJson(R"({"r_squared": 0.99, "rise_time_s": 0.16, "stable": true, "settling_time_s": null,
        "parameters": {"inertia": {"value": 5.5e-4, "unit": "kg*m^2", "ci95": [5e-4, 6e-4]},
                       "coulomb_friction": {"value": null, "unit": "N*m", "ci95": null}},
        "checks": {"gain.kp": 40}, "points": [{"speed_rad_s": 7.5}]})",
                     "test")
        .value();
}

TEST(RunChecks, quantitiesAreFoundByTheirPath) {
    const JsonValue body = sweepBody();
    EXPECT_EQ(findQuantity(body, "r_squared"), 0.99);
    EXPECT_EQ(findQuantity(body, "parameters.inertia.value"), 5.5e-4);
    EXPECT_EQ(findQuantity(body, "parameters.J.value"), 5.5e-4); // the book's letter for the long name
    EXPECT_EQ(findQuantity(body, "parameters.J.ci95_lo"), 5e-4);
    EXPECT_EQ(findQuantity(body, "parameters.J.ci95_hi"), 6e-4);
    EXPECT_EQ(findQuantity(body, "points.0.speed_rad_s"), 7.5);
    EXPECT_EQ(findQuantity(body, "checks.gain.kp"), 40.0); // a name with a dot in it
    EXPECT_EQ(findQuantity(body, "stable"), 1.0);
}

TEST(RunChecks, whatIsNoNumberIsNoQuantity) {
    const JsonValue body = sweepBody();
    for (const char* path : {"", "none", "parameters", "parameters.Kf.value", "parameters.Kf.ci95_lo",
                             "points.1.speed_rad_s", "points.x", "settling_time_s", "r_squared.value"}) {
        EXPECT_FALSE(findQuantity(body, path).has_value()) << path;
    }
}

TEST(RunChecks, unitsComeFromBesideTheValueOrFromTheName) {
    const JsonValue body = sweepBody();
    EXPECT_EQ(quantityUnit(body, "parameters.J.value"), "kg*m^2");
    EXPECT_EQ(quantityUnit(body, "parameters.J.ci95_hi"), "kg*m^2");
    EXPECT_EQ(quantityUnit(body, "rise_time_s"), "s");
    EXPECT_EQ(quantityUnit(body, "points.0.speed_rad_s"), "rad/s");
    EXPECT_EQ(quantityUnit(body, "r_squared"), "");
}

CheckOutcome judged(const std::string& step, const std::string& quantity, std::optional<double> min,
                    std::optional<double> max) {
    StepOutcome sweep;
    sweep.name = "sweep";
    sweep.body = sweepBody();
    const std::vector<CheckOutcome> outcomes =
        judgeChecks({ExperimentCheck{step, quantity, min, max, "because"}}, {sweep});
    return outcomes.at(0);
}

TEST(RunChecks, limitsAreInclusive) {
    EXPECT_TRUE(judged("sweep", "r_squared", 0.99, 0.99).passed);
    EXPECT_TRUE(judged("sweep", "r_squared", 0.9, std::nullopt).passed);
    EXPECT_FALSE(judged("sweep", "r_squared", 0.995, std::nullopt).passed);
    EXPECT_FALSE(judged("sweep", "r_squared", std::nullopt, 0.98).passed);
}

TEST(RunChecks, missingOrUndefinedQuantitiesFail) {
    EXPECT_FALSE(judged("sweep", "none", std::nullopt, 1e9).passed);
    EXPECT_FALSE(judged("other", "r_squared", std::nullopt, 1e9).passed);
    const CheckOutcome undefined = judged("sweep", "settling_time_s", std::nullopt, 1e9);
    EXPECT_FALSE(undefined.passed);
    EXPECT_FALSE(undefined.value.has_value());
    EXPECT_EQ(undefined.quantity, "sweep.settling_time_s");
    EXPECT_EQ(undefined.reason, "because");
}

} // namespace
} // namespace halbench::app
