#include "app/documents/axis_loop_documents.h"
#include "app/documents/axis_model_file.h"
#include "app/documents/calibration_file.h"
#include "app/documents/document_limits.h"
#include "app/documents/document_units.h"
#include "app/documents/frequency_file.h"
#include "app/documents/identification_file.h"
#include "app/documents/model_file.h"
#include "app/documents/relay_document.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

struct Case {
    const char* text;
    const char* key;
};

TEST(DocumentLimitsTest, impossibleValuesAreRefusedNamingTheKey) {
    for (const Case& one : {
             Case{R"({"r_squared": 1.2})", "\"r_squared\""},
             Case{R"({"r_squared": -0.1})", "\"r_squared\""},
             Case{R"({"asymmetry": {"value": 1.5, "unit": "", "ci95": [1.4, 1.6]}})", "asymmetry.value"},
             Case{R"({"asymmetry": {"value": -1.01, "unit": ""}})", "asymmetry.value"},
             Case{R"({"residual_rms_rad_s": -1})", "residual_rms_rad_s"},
             Case{R"({"sample_period_s": 0})", "sample_period_s"},
             Case{R"({"sample_period_s": -0.01})", "sample_period_s"},
             Case{R"({"delay_samples": 0.5})", "delay_samples"},
             Case{R"({"delay_samples": -1})", "delay_samples"},
             Case{R"({"delay_samples": 3})", "delay_samples"},
             Case{R"({"points": [{"coherence": 0.9}, {"coherence": 1.1}]})", "points[1].coherence"},
             Case{R"({"points": [{"coherence": [0.9, -0.1]}]})", "points[0].coherence[1]"},
             Case{R"({"points": [{"weight": -1}]})", "points[0].weight"},
             Case{R"({"points": [{"plant": {"re": 1, "im": 1, "radius": -1}}]})", "points[0].plant.radius"},
             Case{R"({"cycle": {"blocks": 1.5}})", "cycle.blocks"},
             Case{R"({"ultimate_period": {"value": -0.3, "unit": "s"}})", "ultimate_period.value"},
             Case{R"({"robust": {"unstable_fraction": 1.01}})", "robust.unstable_fraction"},
             Case{R"({"targets": {"phase_margin_deg": 200}})", "targets.phase_margin_deg"},
             Case{R"({"targets": {"max_sensitivity": 0.9}})", "targets.max_sensitivity"},
             Case{R"({"gains": {"filter_s": {"value": -1, "unit": "ms"}}})", "gains.filter_s.value"},
             Case{R"({"gains": {"feedforward_inertia": {"value": -1, "unit": "A*s^2/rad"}}})",
                  "gains.feedforward_inertia.value"},
             Case{R"({"figures": {"hall.quadrature": {"value": 100, "unit": "deg"}}})",
                  "figures.hall.quadrature.value"},
             Case{R"({"figures": {"hall.gain_ratio": {"value": -1, "unit": ""}}})", "hall.gain_ratio.value"},
             Case{R"({"proposed": [{"name": "hall.amplitude", "value": 0}]})", "proposed[0].value"},
             Case{R"({"proposed": [{"name": "errormap.cos3", "value": 4}]})", "proposed[0].value"},
             Case{R"({"highest_temperature_degC": -300})", "highest_temperature_degC"},
         }) {
        const auto root = parseDocument(one.text, "x.json");
        ASSERT_FALSE(root) << one.text;
        EXPECT_EQ(root.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(root.error().message.find(one.key), std::string::npos) << root.error().message;
    }
}

TEST(DocumentLimitsTest, possibleValuesPassWithTheirEnds) {
    for (const char* text : {
             R"({"r_squared": 1})",
             R"({"r_squared": 1.0000000000000002})", // rounding of a perfect line
             R"({"r_squared": null, "residual_rms_rad_s": 0, "delay_samples": 2})",
             R"({"asymmetry": {"value": -1, "unit": "", "ci95": [-1, 0.2]}})",
             R"({"points": [{"coherence": 0, "weight": 0}]})",
             R"({"figures": {"hall.quadrature": {"value": -89, "unit": "deg"}}})",
             R"({"before": [{"name": "errormap.enabled", "value": 1}, {"name": "gain.kp", "value": -1}]})",
             R"({"gains": {"kp": {"value": -1, "unit": "A/rad"}}})", // unstable, but a number that can be
                                                                     // meant
         }) {
        const auto root = parseDocument(text, "x.json");
        EXPECT_TRUE(root) << root.error().message;
    }
}

TEST(DocumentLimitsTest, covariancesOfNoDistributionAreRefused) {
    const auto checked = [](const std::string& matrix) {
        const auto root =
            parseJson(R"({"covariance": {"names": ["a", "b"], "matrix": )" + matrix + "}}", "x");
        return checkCovarianceLimits(*root, "x.json");
    };
    EXPECT_TRUE(checked("[[4, -2], [-2, 1]]")); // correlation -1: one follows from the other
    EXPECT_TRUE(checked("[[0, 0], [0, 1]]"));
    for (const Case& one :
         {Case{"[[-1, 0], [0, 1]]", "matrix[0][0]"}, Case{"[[1, 0], [0, -1e-9]]", "matrix[1][1]"},
          Case{"[[1, 0.5], [0.4, 1]]", "matrix[1][0]"}, Case{"[[1, 2], [2, 1]]", "matrix[1][0]"},
          Case{"[[0, 0.1], [0.1, 1]]", "matrix[1][0]"}}) {
        const auto valid = checked(one.text);
        ASSERT_FALSE(valid) << one.text;
        EXPECT_NE(valid.error().message.find(one.key), std::string::npos) << valid.error().message;
    }
}

TEST(DocumentLimitsTest, everyReaderRefusesThem) {
    const auto refused = [](const auto& read, const char* key) {
        return !read && read.error().message.find(key) != std::string::npos;
    };
    const std::string model = R"({"schema": "halbench.identification/1", "r_squared": 1.5})";
    EXPECT_TRUE(refused(parseModel(model, "m"), "r_squared"));
    EXPECT_TRUE(refused(parseIdentification(model, "m"), "r_squared"));
    const std::string gains = R"({"schema": "halbench.gains/1", "sample_period_s": 0})";
    EXPECT_TRUE(refused(parseGains(gains, "g"), "sample_period_s"));
    EXPECT_TRUE(
        refused(parseCalibration(R"({"figures": {"hall.amplitude": {"value": -1, "unit": "T"}}})", "c"),
                "hall.amplitude"));
    EXPECT_TRUE(
        refused(parseCalibrationRecord(R"({"residual_before_deg": -1})", "c"), "residual_before_deg"));
    EXPECT_TRUE(
        refused(parseRelay(R"({"schema": "halbench.relay/1", "delay_samples": 0.6})", "r"), "delay_samples"));
    EXPECT_TRUE(refused(parseFrequency(R"({"points": [{"coherence": 2}]})", "f"), "coherence"));
    EXPECT_TRUE(refused(
        parseAxisModel(
            R"({"schema": "halbench.axis-model/1", "axes": [{"axis": "x", "sample_period_s": -1}]})", "a"),
        "sample_period_s"));
    EXPECT_TRUE(
        refused(parseAxisGains(
                    R"({"schema": "halbench.gains/1", "axes": [{"axis": "x", "delay_samples": 0.2}]})", "a"),
                "delay_samples"));
}

TEST(DocumentLimitsTest, targetsLieBelowHalfTheRate) {
    const auto read = [](const std::string& targets) {
        return parseGains(R"json({"schema": "halbench.gains/1", "form": "parallel", "sample_period_s": 0.01,
            "targets": )json" +
                              targets + R"json(, "gains": {"kp": {"value": 10, "unit": "A/rad"},
            "ki": {"value": 0.1, "unit": "A/(rad*s)"}, "kd": {"value": 0, "unit": "A*s/rad"}}})json",
                          "g.json");
    };
    EXPECT_TRUE(read(R"({"bandwidth_hz": 49})"));
    for (const Case& one : {Case{R"({"bandwidth_hz": 50})", "targets.bandwidth_hz"},
                            Case{R"({"omega_rad_s": 315})", "targets.omega_rad_s"}}) { // pi/T = 314.16
        const auto gains = read(one.text);
        ASSERT_FALSE(gains) << one.text;
        EXPECT_NE(gains.error().message.find(one.key), std::string::npos) << gains.error().message;
    }
}

} // namespace
} // namespace halbench::app
