#include "app/analyses/registry/analyses.h"
#include "app/analyses/spherical/estimator_comparison.h"
#include "app/analyses/spherical/orientation_readings.h"
#include "app/analyses/spherical/proof_json.h"
#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "models/spherical/rotor_field.h"
#include "tests/app/analyses/recorded_poses.h"

#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace halbench::app {

// spherical-theory.md section 7: 0.0286 degrees rms at 100 uT with a known strength. 3000 poses have a
// standard error of the rms of about 1 %; the workspace without its outermost degree and the poses' own
// spread add one.
TEST(OrientationAnalysisTest, errorsAreThoseOfTheNoise) {
    const devices::RecordedFile file = recordedPoses(3000, Noise_T);
    const auto result = run("orient", {}, {{"truth", true}, {"known_strength", true}}, &file);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(number(result->body, {"determined"}), 3000.0);
    EXPECT_NEAR(number(result->body, {"truth", "rms_deg"}), 0.0286, 0.03 * 0.0286);
    EXPECT_EQ(number(result->body, {"truth", "wrong_branches"}), 0.0);
    // Nine readings, three angles: six degrees of freedom, standard error sqrt(12 / 3000) = 0.06.
    EXPECT_NEAR(number(result->body, {"chi_square", "mean"}), 6.0, 0.2);
    EXPECT_EQ(result->quality.verdict, Verdict::Good);
}

// The same recording as other tools write it: a unit behind the name or beside it, angles in degrees.
TEST(OrientationAnalysisTest, readingsAndAnglesInOtherUnitsAreTheSame) {
    const devices::RecordedFile file = recordedPoses(200, Noise_T);
    devices::RecordedFile other = file;
    auto layout = std::make_shared<StreamLayout>(*file.recording.layout);
    std::array<double, 12> perUnit{};
    const std::array<std::pair<const char*, double>, 3> fields{
        {{"field.0.r [mT]", 1e3}, {"field_0_theta_uT", 1e6}, {"field_0_phi_G", 1e4}}};
    for (std::size_t i = 0; i < perUnit.size(); ++i) {
        perUnit[i] = i < fields.size() ? fields[i].second : i < 9 ? 1e3 : 180.0 / Pi;
        layout->columns[i] = i < fields.size()
                                 ? StreamLayout::Column{fields[i].first, ""}
                                 : StreamLayout::Column{layout->columns[i].name, i < 9 ? "mT" : "deg"};
    }
    other.recording.layout = layout;
    for (std::size_t i = 0; i < other.recording.values.size(); ++i) {
        other.recording.values[i] *= perUnit[i % perUnit.size()];
    }
    const auto expected = run("orient", {}, {{"truth", true}}, &file);
    const auto result = run("orient", {}, {{"truth", true}}, &other);
    ASSERT_TRUE(expected);
    ASSERT_TRUE(result) << result.error().message;
    // Scaled and scaled back, a reading differs by a few last digits.
    EXPECT_NEAR(number(result->body, {"truth", "rms_deg"}), number(expected->body, {"truth", "rms_deg"}),
                1e-9);
    EXPECT_EQ(number(result->body, {"determined"}), 200.0);
}

TEST(OrientationAnalysisTest, currentInAnotherUnitIsConvertedAndOneInNoneRefused) {
    devices::RecordedFile file = recordedPoses(20, Noise_T);
    const auto withCurrent = [&file](const char* name, const char* unit, double value) {
        devices::RecordedFile more = file;
        auto layout = std::make_shared<StreamLayout>(*file.recording.layout);
        layout->columns.push_back({name, unit});
        more.recording.layout = layout;
        more.recording.values.clear();
        for (std::size_t row = 0; row < file.recording.time_s.size(); ++row) {
            const auto begin = file.recording.values.begin() + static_cast<std::ptrdiff_t>(12 * row);
            more.recording.values.insert(more.recording.values.end(), begin, begin + 12);
            more.recording.values.push_back(value);
        }
        return more;
    };
    const auto readings = [](const devices::RecordedFile& recorded) {
        const auto values = parseAnalysisValues(*findAnalysis("orient"), {}, {});
        return orientationReadings(*values, recorded, "motion.csv");
    };
    const auto milliamperes = readings(withCurrent("coil_current_mA", "", 500.0));
    ASSERT_TRUE(milliamperes) << milliamperes.error().message;
    EXPECT_DOUBLE_EQ(milliamperes->coilCurrent_A[0], 0.5);
    const auto volts = readings(withCurrent("coil.current", "V", 0.5));
    ASSERT_FALSE(volts) << "not taken for no current";
    EXPECT_THAT(volts.error().message, testing::HasSubstr("'coil.current' is not in A"));
    const auto another = readings(withCurrent("coil_current_set_V", "", 0.5));
    ASSERT_TRUE(another) << another.error().message;
    EXPECT_EQ(another->coilCurrent_A[0], 0.0);
}

// 95 % of the true angles lie within their intervals: binomial, 3 sigma of 3000 poses are 1.2 %.
TEST(OrientationAnalysisTest, intervalsHoldTheTruth) {
    const devices::RecordedFile file = recordedPoses(3000, Noise_T);
    const auto result = run("orient", {{"tolerance", "none"}}, {{"truth", true}}, &file);
    ASSERT_TRUE(result);
    const AnalysisTable& table = *result->table;
    const std::size_t width = table.columns.size();
    const auto column = [&](const char* name) {
        return static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), name) -
                                        table.columns.begin());
    };
    for (std::size_t angle = 0; angle < 3; ++angle) {
        int held = 0;
        for (std::size_t row = 0; row < 3000; ++row) {
            const double truth = file.recording.values[row * 12 + 9 + angle];
            const double value = table.values[row * width + column("alpha_rad") + angle];
            held += std::abs(value - truth) <= table.values[row * width + column("alpha_half95_rad") + angle];
        }
        EXPECT_NEAR(held / 3000.0, 0.95, 0.012) << table.columns[column("alpha_rad") + angle];
    }
}

// Readings of specimens as assembled: gains, offsets, frames, cross-axis shares and places within the stated
// tolerance. Cut Gaussians: intervals of 95 % hold at least 95 % of them; poses of one specimen belong
// together.
TEST(OrientationAnalysisTest, intervalsHoldTheErrorsOfSensorsThatWereNeverCalibrated) {
    const devices::RecordedFile file = recordedSpecimens();
    const auto result = run("orient", {}, {{"truth", true}}, &file);
    ASSERT_TRUE(result);
    const AnalysisTable& table = *result->table;
    const std::size_t width = table.columns.size();
    const auto column = [&](const char* name) {
        return static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), name) -
                                        table.columns.begin());
    };
    EXPECT_GT(number(result->body, {"truth", "rms_deg"}), 0.8); // far more than the noise alone, 0.03
    for (std::size_t angle = 0; angle < 3; ++angle) {
        int held = 0;
        for (std::size_t row = 0; row < 3000; ++row) {
            const double truth = file.recording.values[row * 12 + 9 + angle];
            const double value = table.values[row * width + column("alpha_rad") + angle];
            held += std::abs(value - truth) <= table.values[row * width + column("alpha_half95_rad") + angle];
        }
        EXPECT_GE(held / 3000.0, 0.92) << table.columns[column("alpha_rad") + angle];
        EXPECT_LE(held / 3000.0, 0.995) << table.columns[column("alpha_rad") + angle];
    }
}

// Sensors that clip at 100 mT leave 37 % of the poses without a tensor (section 4). With errors of gains,
// frames and offsets the readings of the true pose fit worse than the noise allows, and those of a wrong one
// may fit better: what is not certain is ambiguous. The search has a finite number of starts, and one of a
// few hundred poses has a reading farther off than the tolerance: less than 1 % of the given poses may be
// wrong.
TEST(OrientationAnalysisTest, clippedReadingsOfSensorsAsAssembledAreAmbiguousWhereTheyAreNotCertain) {
    devices::RecordedFile file = recordedSpecimens();
    for (std::size_t row = 0; row < 3000; ++row) {
        for (std::size_t i = 0; i < 9; ++i) {
            double& reading_T = file.recording.values[12 * row + i];
            reading_T = std::fmin(0.1, std::fmax(-0.1, reading_T));
        }
    }
    const auto result = run("orient", {{"range_mT", "100"}}, {{"truth", true}}, &file);
    ASSERT_TRUE(result) << result.error().message;
    const double given = number(result->body, {"determined"}) + number(result->body, {"reduced"});
    EXPECT_GT(given, 1500.0);
    EXPECT_LT(number(result->body, {"truth", "wrong_branches"}), 0.01 * given);
    EXPECT_GT(number(result->body, {"ambiguous"}), 0.0);
    EXPECT_EQ(number(result->body, {"not_converged"}), 0.0);
}

TEST(OrientationAnalysisTest, theFitTakesSensorsAsAssembled) {
    const devices::RecordedFile file = recordedSpecimens();
    const auto result = run("orient", {{"estimator", "lm"}}, {{"truth", true}}, &file);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(number(result->body, {"determined"}), 3000.0);
    EXPECT_EQ(number(result->body, {"truth", "wrong_branches"}), 0.0);
}

TEST(OrientationAnalysisTest, aCalibrationCorrectsTheReadingsAndItsToleranceRemains) {
    devices::RecordedFile file = recordedPoses(500, Noise_T);
    for (std::size_t row = 0; row < 500; ++row) {
        file.recording.values[12 * row] *= 1.03;     // R of sensor 0
        file.recording.values[12 * row + 4] += 3e-3; // Theta of sensor 1
    }
    const std::string path = testing::TempDir() + "orient_calibration.json";
    std::ofstream(path)
        << R"({"schema": "halbench.calibration/1", "figures": {}, "before": [], "applied": false,
        "proposed": [{"name": "sensor.gain_1", "value": 0.03}, {"name": "sensor.offset_5", "value": 0.003},
                     {"name": "sensor.deviation", "value": 1e-4}, {"name": "sensor.tolerance", "value": 5e-4}],
        "data_quality": {"verdict": "good", "findings": []}})";
    const auto plain = run("orient", {}, {{"truth", true}}, &file);
    const auto calibrated = run("orient", {{"calibration", path}}, {{"truth", true}}, &file);
    ASSERT_TRUE(plain);
    ASSERT_TRUE(calibrated) << calibrated.error().message;
    EXPECT_GT(number(plain->body, {"truth", "rms_deg"}), 0.2);
    // The noise alone, with a free strength 3 % more than section 7; one reading's noise is scaled by 1.03.
    EXPECT_NEAR(number(calibrated->body, {"truth", "rms_deg"}), 0.0295, 0.06 * 0.0295);
    // Tolerance five times the noise: the cone is sqrt(26) times that of the noise, 2.3 sigma of 0.02
    // degrees.
    EXPECT_NEAR(number(calibrated->body, {"cone95_deg", "median"}), 0.06 * std::sqrt(26.0), 0.08);
    EXPECT_EQ(run("orient", {{"calibration", path}, {"harmonics", "h1"}}, {}, &file).error().code,
              ErrorCode::Usage);
    std::ofstream(path)
        << R"({"schema": "halbench.calibration/1", "figures": {}, "before": [], "proposed": [],
        "applied": false, "data_quality": {"verdict": "good", "findings": []}})";
    EXPECT_EQ(run("orient", {{"calibration", path}}, {}, &file).error().code, ErrorCode::InvalidInput);
    std::remove(path.c_str());
}

// spherical-theory.md section 6: at home T1 has its maximum 0.35417 T^2 at |dg| = 90 degrees and 0.12789 at
// the published place; both are on any lattice that divides 45 degrees.
TEST(DifferencesAnalysisTest, ranksThePublishedPlace) {
    const auto result =
        run("differences", {{"device", "paper"}, {"step_deg", "45"}, {"pose_step_deg", "45"}});
    ASSERT_TRUE(result) << result.error().message;
    const JsonValue* rows = result->body.find("rows");
    ASSERT_NE(rows, nullptr);
    ASSERT_EQ(rows->items().size(), 8U);
    const JsonValue& home = rows->items()[3];
    EXPECT_NEAR(home.find("best_T2")->number(), 0.35417, 2e-4);
    EXPECT_NEAR(home.find("claimed_T2")->number(), 0.12789, 2e-4);
    EXPECT_GT(home.find("claimed_rank")->number(), 1.0);
    EXPECT_EQ(run("differences", {{"step_deg", "7"}}).error().code, ErrorCode::Usage);
}

// The rotor has a radius of 45.6 mm.
TEST(PlacementChoiceTest, sensorsInsideTheRotorAreRefusedEverywhere) {
    for (const char* name : {"coverage", "place", "readings", "estimators", "differences"}) {
        for (const char* radius_mm : {"40", "45.6"}) {
            const auto result = run(name, {{"radius_mm", radius_mm}});
            ASSERT_FALSE(result) << name;
            EXPECT_EQ(result.error().code, ErrorCode::OutOfRange);
            EXPECT_THAT(result.error().message, testing::HasSubstr("inside the rotor of 45.6 mm")) << name;
        }
    }
}

TEST(OrientationAnalysisTest, aMissingChannelIsLeftOutAndSaid) {
    devices::RecordedFile file = recordedPoses(50, 0.0);
    for (std::size_t row = 0; row < 50; ++row) {
        file.recording.values[row * 12 + 4] = NAN;
    }
    const auto result = run("orient", {}, {{"truth", true}}, &file);
    ASSERT_TRUE(result);
    EXPECT_EQ(number(result->body, {"determined"}), 50.0);
    EXPECT_LT(number(result->body, {"truth", "worst_deg"}), 1e-6); // eight exact readings still determine it
    ASSERT_FALSE(result->quality.findings.empty());
    EXPECT_THAT(result->quality.findings.front().message,
                testing::HasSubstr("field.1.theta: 50 values missing"));
}

TEST(OrientationAnalysisTest, withoutAnyChannelItIsRefused) {
    const devices::RecordedFile file = recordedPoses(20, 0.0);
    const auto result = run("orient", {{"range_mT", "1"}}, {}, &file);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->quality.verdict, Verdict::Refused);
    EXPECT_EQ(number(result->body, {"determined"}), 0.0);
}

TEST(OrientationAnalysisTest, wrongInputIsRefusedWithItsName) {
    devices::RecordedFile file = recordedPoses(5, 0.0);
    const auto message = [&](const std::map<std::string, std::string>& texts) {
        const auto result = run("orient", texts, {{"truth", true}}, &file);
        return result ? std::string("accepted") : result.error().message;
    };
    EXPECT_THAT(message({{"q_T", "-0.1"}}), testing::HasSubstr("not positive"));
    EXPECT_THAT(message({{"estimator", "guess"}}), testing::HasSubstr("--estimator: 'guess'"));
    EXPECT_THAT(message({{"readings", "a,b"}}), testing::HasSubstr("2 names, not 9"));
    EXPECT_THAT(message({{"placement", "0,0,0,0,0,0,45,45,-90"}}),
                testing::HasSubstr("Sensors 0 and 1 lie at the same place"));
    EXPECT_THAT(message({{"radius_mm", "40"}}), testing::HasSubstr("rotor"));
    auto layout = std::make_shared<StreamLayout>(*file.recording.layout);
    layout->columns[2].unit = "A";
    file.recording.layout = layout;
    EXPECT_THAT(message({}), testing::HasSubstr("'field.0.phi' is not in T"));
    layout->columns[2].name = "other";
    EXPECT_THAT(message({}), testing::HasSubstr("there is no signal 'field.0.phi'"));
}

TEST(OrientationAnalysisTest, readingsInAnotherUnitAreRefused) {
    devices::RecordedFile file = recordedPoses(5, 0.0);
    for (double& value : file.recording.values) {
        value *= 1e3;
    }
    const auto result = run("orient", {}, {}, &file);
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, testing::HasSubstr("another unit"));
}

// spherical-theory.md section 6: gamma = 0.5 atan(sqrt(1/2)) = 17.6322 degrees, and 90 degrees less.
TEST(CoverageAnalysisTest, findsTheCounterexampleOfThePublishedPlacement) {
    const auto result = run("coverage", {{"step_deg", "5"}});
    ASSERT_TRUE(result) << result.error().message;
    const JsonValue* proof = result->body.find("proof");
    EXPECT_EQ(proof->find("verdict")->text(), "refuted");
    const JsonValue& theta = proof->find("components")->items()[1];
    const double gamma_deg = number(theta, {"least_at", "gamma_deg"});
    const double expected_deg = 0.5 * radiansToDegrees(std::atan(std::sqrt(0.5)));
    EXPECT_NEAR(std::remainder(gamma_deg - expected_deg, 90.0), 0.0, 1e-6);
    EXPECT_NEAR(number(theta, {"least_at", "alpha_deg"}), 0.0, 1e-6);
    EXPECT_NEAR(number(theta, {"least_at", "beta_deg"}), 0.0, 1e-6);
}

// spherical-theory.md section 2: the order stands beside the angles of poses and of sensors.
TEST(CoverageAnalysisTest, orderOfRotationsStandsBesideTheAngles) {
    const auto coverage = run("coverage", {{"step_deg", "45"}, {"map_step_deg", "45"}, {"frames", "xyz"}});
    ASSERT_TRUE(coverage) << coverage.error().message;
    const char* poses = "poses are (alpha, beta, gamma): gamma about Z first, then beta about Y, then alpha";
    EXPECT_THAT(coverage->summary, testing::HasSubstr(poses));
    EXPECT_THAT(coverage->summary, testing::HasSubstr("sensors at (0, 0, 0), (0, 0, 45), (45, 45, -90) deg"));
    EXPECT_THAT(coverage->summary, testing::HasSubstr("(xyz) by (alpha, beta, gamma): gamma about Z first"));
    EXPECT_THAT(coverage->summary, testing::HasSubstr("the largest 0.00 mT")); // as "at least 10.48 mT"
    const auto place = run("place", {{"step_deg", "45"}});
    ASSERT_TRUE(place);
    EXPECT_THAT(place->summary, testing::HasSubstr(poses));
    EXPECT_THAT(place->summary, testing::HasSubstr("(zyx) by (alpha, beta, gamma): alpha about X first"));
}

// Section 6: at zero tilt no sensor reads Theta at a spin of -72.37 or 17.63 degrees; R and Phi are covered.
TEST(CoverageAnalysisTest, pictureHasTheHolesOfTheSpin) {
    const auto result = run("coverage", {{"step_deg", "45"}, {"map_step_deg", "9"}});
    ASSERT_TRUE(result) << result.error().message;
    ASSERT_EQ(result->plots.size(), 1U);
    const std::vector<AnalysisPanel>& panels = result->plots[0].panels;
    ASSERT_EQ(panels.size(), 3U);
    EXPECT_EQ(panels[1].limit, 10.0);
    for (std::size_t component = 0; component < panels.size(); ++component) {
        const AnalysisCurve& curve = panels[component].curves.front();
        ASSERT_EQ(curve.x.size(), 180U);
        const auto least = std::min_element(curve.y.begin(), curve.y.end());
        EXPECT_EQ(*least < 10.0, component == 1) << component;
        if (component == 1) {
            const double at_deg = curve.x[static_cast<std::size_t>(least - curve.y.begin())];
            EXPECT_NEAR(std::remainder(at_deg - 17.63, 90.0), 0.0, 1.0); // the next degree
        }
    }
    EXPECT_EQ(panels[1].curves.back().name, "counterexample");
}

TEST(CoverageAnalysisTest, readingsHaveTheDecimalsThatTellThemFromTheLimit) {
    EXPECT_EQ(decimalsBelow(0.0, 0.01), 2);
    EXPECT_EQ(decimalsBelow(9.98e-3, 0.01), 2);
    EXPECT_EQ(decimalsBelow(9.997e-3, 0.01), 3); // 10.00 with two
    EXPECT_EQ(decimalsBelow(0.01, 0.01), 6);     // not below it
}

// Section 6: 0.0306 % of the 0.5-degree grid are 3568 poses; the 1-degree grid has an eighth of them, to the
// extent that the border of a small hole allows.
TEST(CoverageAnalysisTest, recommendedPlacementIsProven) {
    const auto result = run("coverage", {{"step_deg", "5"}, {"placement", "recommended"}});
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(number(result->body, {"proof", "proven_components"}), 3.0);
    EXPECT_NEAR(number(result->body, {"conditioning"}), 1.846, 5e-4);
    EXPECT_EQ(number(result->body, {"count", "uncovered"}), 0.0);
    EXPECT_EQ(result->table->values.size(), 4u * 19 * 19 * 36); // 5 degrees: 19, 19 and 36 angles
}

// A placement file says for which device it was made; what is written out counts before it.
TEST(CoverageAnalysisTest, aPlacementFileBringsItsDevice) {
    const std::string path = testing::TempDir() + "placement.json";
    const auto write = [&path](const std::string& device) {
        std::ofstream(path) << R"({"placement": {)" << device << R"("sensors": [
            {"alpha_deg": 0, "beta_deg": 0, "gamma_deg": 0}, {"alpha_deg": 45, "beta_deg": 30, "gamma_deg": -30},
            {"alpha_deg": 45, "beta_deg": 30, "gamma_deg": 30}]}})";
    };
    const char* const angles = "0,0,0,45,30,-30,45,30,30";
    const auto least = [](const std::map<std::string, std::string>& values) {
        std::map<std::string, std::string> all = values;
        all["step_deg"] = "15";
        const auto result = run("coverage", all);
        EXPECT_TRUE(result) << result.error().message;
        return result ? number(result->body, {"proof", "bound_T"}) : 0.0;
    };
    write(R"("frames": "nat", "radius_m": 0.06, "strength_T": 0.09, )");
    EXPECT_EQ(least({{"placement", path}}),
              least({{"placement", angles}, {"frames", "nat"}, {"radius_mm", "60"}, {"q_T", "0.09"}}));
    EXPECT_EQ(least({{"placement", path}, {"frames", "zyx"}, {"radius_mm", "50"}}),
              least({{"placement", angles}, {"q_T", "0.09"}}));
    EXPECT_NE(least({{"placement", path}}), least({{"placement", angles}}));
    write("");
    EXPECT_EQ(least({{"placement", path}}), least({{"placement", angles}}));
    for (const char* wrong :
         {R"("frames": "abc", )", R"("radius_m": -1, )", R"("strength_T": "x", )", R"("device": 3, )"}) {
        write(wrong);
        const auto result = run("coverage", {{"placement", path}});
        ASSERT_FALSE(result) << wrong;
        EXPECT_EQ(result.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(result.error().message.find("placement."), std::string::npos) << result.error().message;
    }
    std::remove(path.c_str());
}

TEST(OrientationAnalysisTest, settingsThatMeanNothingToAnEstimatorAreRefused) {
    const devices::RecordedFile file = recordedPoses(20, Noise_T);
    for (const char* estimator : {"closed", "closed-fitted", "swarm"}) {
        EXPECT_EQ(run("orient", {{"estimator", estimator}}, {{"stray", true}}, &file).error().code,
                  ErrorCode::Usage);
        for (const auto& [key, value] : {std::pair{"passes", "3"}, {"harmonics", "h1"}}) {
            const auto result = run("orient", {{"estimator", estimator}, {key, value}}, {}, &file);
            ASSERT_FALSE(result) << estimator << " " << key;
            EXPECT_EQ(result.error().code, ErrorCode::Usage);
            EXPECT_NE(result.error().message.find(key), std::string::npos) << result.error().message;
        }
    }
}

TEST(CoverageAnalysisTest, stopsWhenAsked) {
    AnalysisControl control;
    control.isStopped = [] { return true; };
    const auto result = run("coverage", {}, {}, nullptr, control);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Interrupted);
}

// A coarse lattice that holds the published places: the winner can only be better.
TEST(PlacementAnalysisTest, winnerIsProvenAndOfThePareto) {
    double progress = 0.0;
    AnalysisControl control;
    control.onProgress = [&](double share) { progress = std::max(progress, share); };
    const auto result =
        run("place", {{"step_deg", "45"}, {"objective", "conditioning"}}, {}, nullptr, control);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_LE(number(result->body, {"conditioning"}), 2.158); // of the published one, section 5.1
    EXPECT_FALSE(result->body.find("pareto")->items().empty());
    ASSERT_EQ(result->plots.size(), 1U);
    EXPECT_EQ(result->plots[0].panels[0].curves[1].y, // the winner
              std::vector<double>{number(result->body, {"conditioning"})});
    EXPECT_GT(progress, 0.5);
}

// What is refused says what to give instead, in the words of the options.
TEST(PlacementAnalysisTest, everyRefusalHasARemedy) {
    const std::map<std::string, std::string> wrong[] = {
        {{"step_deg", "7"}},
        {{"step_deg", "0.5"}},
        {{"theta_deg", "-10:50"}},
        {{"phi_deg", "90"}},
        {{"objective", "reading"}},
        {{"objective", "error"}, {"device", "paper"}, {"step_deg", "45"}},
        {{"range_mT", "250"}, {"step_deg", "45"}},
        {{"range_mT", "0"}},
        {{"distance_mm", "200"}, {"step_deg", "45"}},
        {{"radius_mm", "40"}},
        {{"q_T", "-0.1"}},
        {{"noise_uT", "0"}}};
    for (const auto& texts : wrong) {
        const auto result = run("place", texts);
        ASSERT_FALSE(result) << texts.begin()->second;
        EXPECT_FALSE(result.error().hint.empty()) << result.error().message;
    }
    EXPECT_THAT(run("place", {{"objective", "conditioning"}, {"device", "paper"}}).error().hint,
                testing::HasSubstr("objective coverage"));
}

// The largest reading of sensor 0 is 3 q = 297.56 mT at 50 mm; it falls with the fourth power of the radius.
TEST(PlacementAnalysisTest, aRangeThatTheMainSensorExceedsIsRefusedWithTheOneThatWillDo) {
    const auto small = run("place", {{"range_mT", "200"}, {"step_deg", "45"}});
    ASSERT_FALSE(small);
    EXPECT_THAT(small.error().message, testing::HasSubstr("Sensor 0"));
    EXPECT_THAT(small.error().hint, testing::HasSubstr("at least 298 mT"));
    EXPECT_THAT(small.error().hint, testing::HasSubstr("55.3 mm")); // 50 (297.56/200)^(1/4) = 55.22
    EXPECT_TRUE(run("place", {{"range_mT", "298"}, {"step_deg", "45"}}));
    EXPECT_TRUE(run("place", {{"range_mT", "200"}, {"radius_mm", "55.3"}, {"step_deg", "45"}}));
}

TEST(PlacementAnalysisTest, regionIsRefusedWhenItIsNone) {
    for (const char* region : {"90", "120:60", "0:400", "a:b"}) {
        const auto result = run("place", {{"step_deg", "45"}, {"theta_deg", region}});
        ASSERT_FALSE(result) << region;
        EXPECT_THAT(result.error().message, testing::HasSubstr(region));
    }
}

// Section 10, figure 4: Theta of the main sensor 0.0991 T at beta = 45 degrees, of sensor 1 below the
// threshold, of sensor 2 0.0725 T at beta = 0; last printed digit.
TEST(ReadingsAnalysisTest, showsThePublishedFigure) {
    const auto result = run("readings", {{"device", "paper"}, {"alpha_deg", "2"}, {"gamma_deg", "90"}});
    ASSERT_TRUE(result) << result.error().message;
    const AnalysisTable& table = *result->table;
    const auto reading = [&](std::size_t row, std::size_t channel) {
        return std::abs(table.values[row * table.columns.size() + 1 + channel]);
    };
    EXPECT_EQ(table.values.size(), 91u * 10u);
    EXPECT_NEAR(reading(0, 1), 0.0991, 5e-5);
    EXPECT_NEAR(reading(45, 1), 0.0, 5e-5);
    EXPECT_NEAR(reading(0, 4), 0.0049, 5e-5);
    EXPECT_NEAR(reading(45, 4), 0.0069, 5e-5);
    EXPECT_NEAR(reading(45, 7), 0.0725, 5e-5);
}

// Sections 4 and 9: the additive inverse errs by 18.9 degrees rms on the physical device; 10 of 25 poses of
// the first trajectory lie outside the workspace.
TEST(EstimatorAnalysisTest, modelsAreCrossed) {
    const auto crossed = run("estimators", {{"only", "closed"}, {"count", "5000"}});
    ASSERT_TRUE(crossed) << crossed.error().message;
    const JsonValue& closed = crossed->body.find("estimators")->items().front();
    EXPECT_NEAR(number(closed, {"rms_deg"}), 18.9, 0.02 * 18.9);
    const auto own = run("estimators", {{"only", "closed"}, {"device", "paper"}, {"poses", "trajectory1"}});
    ASSERT_TRUE(own);
    EXPECT_EQ(number(own->body, {"in_workspace"}), 15.0);
    EXPECT_LT(number(own->body.find("estimators")->items().front(), {"worst_deg"}), 1e-9);
}

EstimatorComparisonConfig noisyComparison() {
    EstimatorComparisonConfig config;
    config.count = 3000;
    config.noise_T = 100e-6;
    config.isStrengthFree = false;
    return config;
}

// spherical-theory.md section 7: rms at 100 uT. 3000 poses of three noises each scatter by about 1 %.
TEST(EstimatorComparisonTest, errorsAreThoseOfTheTheory) {
    const auto comparison = compareEstimators(noisyComparison(), {});
    ASSERT_TRUE(comparison) << comparison.error().message;
    ASSERT_EQ(comparison->estimators.size(), models::EstimatorNames.size());
    const auto rms_deg = [&](std::size_t row) {
        return radiansToDegrees(comparison->estimators[row].errors->rms_rad);
    };
    EXPECT_NEAR(rms_deg(0), 0.0299, 0.03 * 0.0299);
    EXPECT_NEAR(rms_deg(1), 0.0309, 0.03 * 0.0309);
    EXPECT_NEAR(rms_deg(2), 0.0286, 0.03 * 0.0286);
    EXPECT_NEAR(rms_deg(3), 0.0286, 0.03 * 0.0286);
    for (const ComparedEstimator& row : comparison->estimators) {
        EXPECT_FALSE(row.timePerPose_s);
    }
}

// Each look at the stopwatch is a second later: two looks an estimator, one second for all poses.
TEST(EstimatorComparisonTest, timeIsThatOfTheStopWatchOverAllPoses) {
    EstimatorComparisonConfig config = noisyComparison();
    config.count = 100;
    double now_s = 0.0;
    const auto comparison = compareEstimators(config, {}, [&now_s] { return now_s += 1.0; });
    ASSERT_TRUE(comparison);
    for (const ComparedEstimator& row : comparison->estimators) {
        ASSERT_TRUE(row.timePerPose_s);
        EXPECT_DOUBLE_EQ(*row.timePerPose_s, 0.01);
    }
}

TEST(EstimatorComparisonTest, tellsItsProgressAndStopsWhenAsked) {
    std::vector<double> shares;
    AnalysisControl control;
    control.onProgress = [&](double share) { shares.push_back(share); };
    ASSERT_TRUE(compareEstimators(noisyComparison(), control));
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.front(), 0.0);
    EXPECT_GT(shares.back(), 0.9);
    EXPECT_LE(shares.back(), 1.0);
    control.isStopped = [&] { return shares.back() > 0.5; };
    const auto stopped = compareEstimators(noisyComparison(), control);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, ErrorCode::Interrupted);
}

// Section 7: 0.0295 degrees rms at 100 uT with a free strength; 1000 rows scatter by 2 %.
TEST(EstimatorAnalysisTest, comparesOnRecordedRowsAgainstTheirTrueAngles) {
    const devices::RecordedFile file = recordedPoses(3000, Noise_T);
    const auto result = run("estimators", {{"count", "1000"}, {"failure_deg", "1"}}, {}, &file);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->body.find("poses")->text(), "recording");
    EXPECT_EQ(result->body.find("compared_with")->text(), "truth");
    EXPECT_EQ(number(result->body, {"count"}), 1000.0);
    const JsonValue& refined = result->body.find("estimators")->items()[2];
    EXPECT_NEAR(number(refined, {"rms_deg"}), 0.0295, 0.06 * 0.0295);
    EXPECT_EQ(number(refined, {"failures"}), 0.0);
}

TEST(EstimatorAnalysisTest, incompleteRowsAreLeftOutAndNoneLeftIsRefused) {
    devices::RecordedFile file = recordedPoses(100, Noise_T);
    for (std::size_t row = 0; row < 40; ++row) {
        file.recording.values[12 * row + 4] = NAN;
    }
    const auto result = run("estimators", {{"only", "tensor"}}, {}, &file);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(number(result->body, {"count"}), 60.0);
    EXPECT_THAT(result->summary, testing::HasSubstr("40 without all readings left out"));
    for (std::size_t row = 40; row < 100; ++row) {
        file.recording.values[12 * row + 4] = NAN;
    }
    EXPECT_EQ(run("estimators", {}, {}, &file).error().code, ErrorCode::InvalidInput);
}

TEST(EstimatorAnalysisTest, theClosedFormIsNotForOtherPlaces) {
    const auto result =
        run("estimators", {{"only", "closed"}, {"placement", "recommended"}, {"count", "10"}});
    ASSERT_TRUE(result);
    const JsonValue& row = result->body.find("estimators")->items().front();
    EXPECT_FALSE(row.find("suits")->boolean());
    EXPECT_TRUE(row.find("rms_deg")->isNull());
}

} // namespace halbench::app
