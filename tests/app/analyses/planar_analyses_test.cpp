#include "app/analyses/registry/analyses.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halbench::app {

namespace {

JsonValue forces(const std::map<std::string, std::string>& texts) {
    const Analysis* analysis = findAnalysis("forces");
    const Result<AnalysisValues> values = parseAnalysisValues(*analysis, texts, {});
    EXPECT_TRUE(values) << values.error().message;
    const auto outcome = analysis->run(*values, nullptr, "", {});
    EXPECT_TRUE(outcome);
    return outcome ? outcome->body : JsonValue::object();
}

double figure(const JsonValue& body, const char* name) {
    const JsonValue* figures = body.find("figures");
    const JsonValue* value = figures == nullptr ? nullptr : figures->find(name);
    return value == nullptr ? std::nan("") : value->number();
}

double error(const JsonValue& body, std::size_t demand, const char* name) {
    return body.find("errors")->items()[demand].find(name)->number();
}

} // namespace

// resources/help/planar-theory.md sections 5 and 10, half of the last printed digit.
TEST(ForceAnalysis, recomputesThePublishedNumbers) {
    const JsonValue body = forces({{"points", "4"}});
    EXPECT_NEAR(figure(body, "published_force_constant_N_per_A"), -3.09772, 5e-6);
    EXPECT_NEAR(figure(body, "windings_force_constant_N_per_A"), -3.52301, 5e-6);
    EXPECT_NEAR(figure(body, "largest_set_force_N"), 4.381, 5e-4);
    EXPECT_NEAR(figure(body, "peak_field_fundamental_T"), 0.70368, 5e-6);
    EXPECT_NEAR(figure(body, "peak_field_T"), 0.66781, 5e-6);
    EXPECT_NEAR(figure(body, "tilt_about_x_urad"), 7.41, 5e-3);
    // div B = 0; with the other sign of the in-plane field its two parts add to twice the vertical one.
    EXPECT_NEAR(figure(body, "divergence_ratio"), 0.0, 1e-9);
    EXPECT_NEAR(figure(body, "divergence_printed_sign_ratio"), 2.0, 1e-9);
}

// Without heading the forces of one array do not depend on the other axis: what a demand along x does along
// y comes from the corners alone, and prisms, which have none, do nothing there (section 5.4).
TEST(ForceAnalysis, prismsHaveNoCrossForceWithoutHeading) {
    const JsonValue prisms = forces({{"device", "prism"}, {"points", "20"}});
    EXPECT_NEAR(error(prisms, 0, "error_y_N"), 0.0, 1e-12);
    EXPECT_NEAR(error(prisms, 1, "error_x_N"), 0.0, 1e-12);
    const JsonValue windings = forces({{"device", "windings"}, {"points", "20"}});
    EXPECT_NEAR(error(windings, 0, "error_y_N"), 2.9e-3, 0.15e-3);
    const JsonValue turned = forces({{"device", "windings"}, {"points", "20"}, {"heading_mrad", "10"}});
    EXPECT_GT(error(turned, 0, "error_y_N"), error(windings, 0, "error_y_N"));
}

TEST(ForceAnalysis, refusesAHeadingBeyondTheTravel) {
    const Analysis* analysis = findAnalysis("forces");
    ASSERT_NE(analysis, nullptr);
    EXPECT_FALSE(parseAnalysisValues(*analysis, {{"heading_mrad", "60"}}, {}));
}

} // namespace halbench::app
