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

// Contradiction 3: the amplitudes of a Halbach array of height Delta go with (1 - e^(-n gamma Delta))/n, and
// gamma Delta = pi/2; with that of the fundamental for all the fifth would be
// 0.950 % 5 (1 - e^(-pi/2))/(1 - e^(-5 pi/2)). Coil 1 stands 6.4 mm off the middle of the platen.
TEST(ForceAnalysis, showsWhatThePrintedSubscriptsWouldGive) {
    const JsonValue body = forces({{"points", "4"}});
    const double ratio = 5.0 * (1.0 - std::exp(-M_PI / 2.0)) / (1.0 - std::exp(-2.5 * M_PI));
    EXPECT_NEAR(figure(body, "fifth_of_one_amplitude_percent"), 0.9500 * ratio, 5e-5 * ratio);
    EXPECT_NEAR(figure(body, "force_without_base_percent"), 100.0 * std::cos(2.0 * M_PI / 50.8 * 6.4), 1e-9);
}

// Contradiction 4: the printed chain of phases and torques holds from inner corner to inner corner of the
// coil windows; from centre to centre coil 6 is a winding's width away from where it would have to be.
TEST(ForceAnalysis, findsTheChainOfPhasesAndTorquesConsistent) {
    const JsonValue body = forces({{"points", "4"}});
    EXPECT_NEAR(figure(body, "base_points_6_1_pitches"), 0.75, 1e-12);
    EXPECT_NEAR(figure(body, "base_points_5_6_pitches"), 1.25, 1e-12);
    EXPECT_NEAR(figure(body, "base_points_1_2_pitches"), 0.75, 1e-12);
    EXPECT_NEAR(figure(body, "centres_6_1_pitches"), 6.096 / 50.8, 1e-12);
    EXPECT_NEAR(figure(body, "phase_chain_N_per_A"), 0.0, 1e-12);
    EXPECT_NEAR(figure(body, "torque_signs_Nm_per_A"), 0.0, 1e-12);
}

// Contradiction 14: 0.06 mT of 20 mT, and what that is in position where the slope is largest.
TEST(ForceAnalysis, saysHowMuchTheEddyFieldWouldBe) {
    const JsonValue body = forces({{"points", "4"}});
    EXPECT_NEAR(figure(body, "eddy_field_percent"), 0.3, 1e-12);
    EXPECT_NEAR(figure(body, "eddy_position_um"), 1e6 * 0.003 / 123.68475, 1e-3);
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
