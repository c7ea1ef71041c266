#include "app/documents/document_parts.h"
#include "app/documents/document_units.h"
#include "app/documents/model_file.h"
#include "control/base/units.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

JsonValue parsed(const std::string& text) {
    const auto root = parseDocument(text, "x.json");
    EXPECT_TRUE(root) << root.error().message;
    return root.value_or(JsonValue());
}

TEST(DocumentUnitsTest, valuesAndIntervalsAreConverted) {
    const JsonValue root =
        parsed(R"({"parameters": {"inertia": {"value": 5500, "unit": "g*cm^2", "ci95": [5000, 6000]}}})");
    const control::Estimate inertia = estimateOf(member(member(&root, "parameters"), "inertia"));
    EXPECT_DOUBLE_EQ(*inertia.value, 5.5e-4); // 1 g cm^2 is 1e-7 kg m^2
    EXPECT_DOUBLE_EQ(inertia.interval95->second, 6e-4);
    EXPECT_EQ(inertia.unit, "kg*m^2");
}

TEST(DocumentUnitsTest, listsNameTheirValues) {
    const JsonValue root =
        parsed(R"({"proposed": [{"name": "stray.coefficient", "value": 3, "unit": "mT/A"}]})");
    EXPECT_DOUBLE_EQ(*numberIn(&itemsIn(&root, "proposed")[0], "value"), 3e-3);
}

TEST(DocumentUnitsTest, anotherQuantityIsRefusedNamingTheKey) {
    struct Case {
        const char* text;
        const char* place;
    };
    for (const Case& one :
         {Case{R"({"gains": {"kp": {"value": 1, "unit": "A"}}})", "gains.kp.unit"},
          Case{R"({"gains": {"kd": {"value": 1, "unit": "A/deg"}}})", "gains.kd.unit"},
          Case{R"({"ratios": {"c_over_J": {"value": null, "unit": "s"}}})", "ratios.c_over_J.unit"},
          Case{R"({"figures": {"stray.coefficient": {"value": 1, "unit": "T"}}})",
               "figures.stray.coefficient"},
          Case{R"({"asymmetry": {"value": 1, "unit": "A"}})", "asymmetry.unit"},
          Case{R"({"gains": {"kp": {"value": 1, "unit": 7}}})", "gains.kp.unit"},
          Case{R"({"gains": {"kp": {"value": 1, "unit": "furlong"}}})", "gains.kp.unit"}}) {
        const auto root = parseDocument(one.text, "x.json");
        ASSERT_FALSE(root) << one.text;
        EXPECT_EQ(root.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(root.error().message.find(one.place), std::string::npos) << root.error().message;
    }
}

TEST(DocumentUnitsTest, gainsPerDegreeAreReadAsWritten) {
    const auto gains = parseGains(
        R"json({"schema": "halbench.gains/1", "form": "parallel", "sample_period_s": 0.01,
            "gains": {"kp": {"value": 10, "unit": "A/deg"}, "ki": {"value": 0.1, "unit": "A/(deg*s)"},
                      "kd": {"value": 0.02, "unit": "A*s/deg"}}})json",
        "g.json");
    ASSERT_TRUE(gains) << gains.error().message;
    // 180/pi, with a few roundings
    EXPECT_NEAR(gains->law.gains.proportional, 1800.0 / Pi, 1e-10);
    EXPECT_NEAR(gains->law.gains.integral, 18.0 / Pi, 1e-12);
    EXPECT_NEAR(gains->law.gains.derivative, 3.6 / Pi, 1e-12);
}

std::string modelWith(const std::string& inertia, const std::string& torque) {
    return R"({"schema": "halbench.identification/1", "seed": 7,
      "device": {"model": "htm", "id": "x", "firmware": "x", "simulated": true, "overrides": {}},
      "data_quality": {"verdict": "good", "findings": []},
      "parameters": {"viscous_damping": {"value": 1.23e-3, "unit": "N*m*s/rad"},
                     "coulomb_friction": {"value": 2.07e-2, "unit": "N*m"},
                     "torque_constant": )" +
           torque + R"(, "inertia": )" + inertia + R"(},
      "ratios": {"c_over_J": {"value": 2.236}, "Kf_over_J": {"value": 37.64}, "phi_over_J": {"value": 26.0},
                 "c_over_phi": {"value": 0.08601}, "Kf_over_phi": {"value": 1.4476}},
      "covariance": {"names": [], "matrix": []}})";
}

TEST(DocumentUnitsTest, aModelThatContradictsItselfIsRefused) {
    const std::string torque = R"({"value": 14.3, "unit": "mN*m/A"})";
    const auto whole = parseModel(modelWith(R"({"value": 5.5e-4, "unit": "kg*m^2"})", torque), "m.json");
    ASSERT_TRUE(whole) << whole.error().message;
    EXPECT_NEAR(whole->estimate.values.at("phi"), 14.3e-3, 1e-15);
    for (const auto& [inertia, phi] : {std::pair<std::string, std::string>{R"({"value": 6.5e-4})", torque},
                                       {R"({"value": 5.5, "unit": "kg*m^2"})", torque},
                                       {R"({"value": 5.5e-4})", R"({"value": 13e-3})"}}) {
        const auto model = parseModel(modelWith(inertia, phi), "m.json");
        ASSERT_FALSE(model) << inertia;
        EXPECT_NE(model.error().message.find("\"ratios."), std::string::npos) << model.error().message;
    }
    const auto negative = parseModel(modelWith(R"({"value": -5.5e-4})", torque), "m.json");
    ASSERT_FALSE(negative);
    EXPECT_NE(negative.error().message.find("\"parameters.inertia"), std::string::npos);
}

} // namespace
} // namespace halbench::app
