#include "app/procedures/identify/identify_physics.h"
#include "app/procedures/tune/analyse.h"
#include "control/base/units.h"
#include "devices/open/open_device.h"
#include "tests/control/identify/motion_records.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace halbench::app {
namespace {

const Finding* findingOf(const IdentifyResult& result, const std::string& code) {
    const auto found = std::find_if(result.quality.findings.begin(), result.quality.findings.end(),
                                    [&code](const Finding& finding) { return finding.code == code; });
    return found == result.quality.findings.end() ? nullptr : &*found;
}

std::string messagesOf(const IdentifyResult& result) {
    std::string all;
    for (const Finding& finding : result.quality.findings) {
        all += finding.code + ": " + finding.message + "\n";
    }
    return all;
}

// Run-ups, plateaus and coast-downs of the published motor with 1 mrad of noise.
control::RecordMaker goodRecord(const control::RecordRatios& ratios = {}) {
    control::RecordErrors errors;
    errors.noise_rad = 1e-3;
    errors.friction_ratio = ratios.friction_rad_s2 > 0.0 ? 0.01 : 0.0;
    control::RecordMaker record(ratios, errors, 11);
    record.run(0.0, 0.3);
    for (const double current : {2.0, 3.0, 2.5, 3.5, 0.0, 3.0, 0.0, 2.0, 2.5, 3.5, 0.0}) {
        record.run(current, current == 0.0 ? 1.5 : 4.5);
    }
    return record;
}

using Change = std::function<double(const control::RecordMaker&, std::size_t row)>;

Recording recordingOf(const control::RecordMaker& record, const Change& angle, const Change& current) {
    auto layout = std::make_shared<StreamLayout>();
    layout->columns = {{"position", "rad"}, {"current_command", "A"}};
    Recording recording;
    recording.layout = layout;
    recording.time_s = record.time_s;
    for (std::size_t row = 0; row < record.time_s.size(); ++row) {
        recording.values.insert(recording.values.end(), {angle(record, row), current(record, row)});
    }
    return recording;
}

double angleOf(const control::RecordMaker& record, std::size_t row) {
    return record.angle_rad[row];
}

double currentOf(const control::RecordMaker& record, std::size_t row) {
    return record.current_column_A[row];
}

IdentifyConfig withInertia() {
    IdentifyConfig config;
    config.given.inertia_kg_m2 = 5.5e-4;
    return config;
}

IdentifyResult identify(const control::RecordMaker& record, const Change& angle, const Change& current,
                        const IdentifyConfig& config = withInertia()) {
    const auto result = identifyRecording(recordingOf(record, angle, current), config);
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result.value_or(IdentifyResult{});
}

void expectNoValue(const IdentifyResult& result) {
    EXPECT_FALSE(result.torqueConstant.value);
    EXPECT_FALSE(result.viscousDamping.value);
    EXPECT_FALSE(result.coulombFriction.value);
    for (const auto& [name, ratio] : result.ratios) {
        EXPECT_FALSE(ratio.value) << name;
    }
    EXPECT_TRUE(result.covarianceNames.empty());
}

TEST(IdentifyPhysics, aSoundRecordHasNoSuchFinding) {
    const IdentifyResult result = identify(goodRecord(), angleOf, currentOf);
    EXPECT_NE(result.quality.verdict, Verdict::Refused) << messagesOf(result);
    ASSERT_TRUE(result.torqueConstant.interval95);
    EXPECT_LE(result.torqueConstant.interval95->first, 1.43e-2);
    EXPECT_GE(result.torqueConstant.interval95->second, 1.43e-2);
    for (const char* code : {"sign_reversed", "angle_wraps", "speed_as_angle", "friction_below_zero",
                             "damping_below_zero", "interval_reaches_zero"}) {
        EXPECT_EQ(findingOf(result, code), nullptr) << code;
    }
}

// A column in mA that is called A; any factor that is too large for the board that recorded it.
TEST(IdentifyPhysics, doubtsCurrentsThatCannotHaveFlowed) {
    const auto times = [](double factor) {
        return [factor](const control::RecordMaker& record, std::size_t row) {
            return factor * record.current_column_A[row];
        };
    };
    const auto record = goodRecord(); // up to 3.5 A
    const IdentifyResult milli = identify(record, angleOf, times(1000.0));
    EXPECT_EQ(milli.quality.verdict, Verdict::Doubtful) << messagesOf(milli);
    EXPECT_NE(findingOf(milli, "current_implausible"), nullptr) << messagesOf(milli);
    IdentifyConfig known = withInertia();
    known.recordedLimit_A = 4.0;
    for (const double factor : {-10.0, 1.5, 10.0, 1000.0}) {
        const IdentifyResult result = identify(record, angleOf, times(factor), known);
        EXPECT_GE(result.quality.verdict, Verdict::Doubtful) << factor;
        EXPECT_EQ(findingOf(result, "current_above_limit") != nullptr, factor > 0.0) << factor;
    }
    known.recordedLimit_A = 3.5;
    EXPECT_EQ(findingOf(identify(record, angleOf, currentOf, known), "current_above_limit"), nullptr);
    EXPECT_EQ(findingOf(identify(record, angleOf, currentOf), "current_implausible"), nullptr);
}

TEST(IdentifyPhysics, refusesAReversedSignOfCurrentOrAngle) {
    const Change backwards = [](const auto& record, std::size_t row) { return -record.angle_rad[row]; };
    const Change reversed = [](const auto& record, std::size_t row) { return -record.current_column_A[row]; };
    for (const auto& [angle, current] :
         {std::pair<Change, Change>{angleOf, reversed}, {backwards, currentOf}}) {
        for (const IdentifyConfig& config : {withInertia(), IdentifyConfig{}}) {
            const IdentifyResult result = identify(goodRecord(), angle, current, config);
            EXPECT_EQ(result.quality.verdict, Verdict::Refused);
            const Finding* finding = findingOf(result, "sign_reversed");
            ASSERT_NE(finding, nullptr);
            EXPECT_NE(finding->message.find("sign of current or angle"), std::string::npos);
            EXPECT_EQ(findingOf(result, "plateaus_stopped"), nullptr); // nothing stopped
            expectNoValue(result);
        }
    }
    // Without plateaus of two seconds only the run-ups and coast-downs show it.
    control::RecordMaker bursts({}, {}, 5);
    for (int i = 0; i < 6; ++i) {
        bursts.run(i % 2 == 0 ? 4.0 : 3.0, 1.0);
        bursts.run(0.0, 1.0);
    }
    const IdentifyResult result = identify(bursts, angleOf, reversed);
    EXPECT_EQ(result.quality.verdict, Verdict::Refused);
    EXPECT_NE(findingOf(result, "sign_reversed"), nullptr);
    expectNoValue(result);
}

TEST(IdentifyPhysics, refusesASpeedInTheColumnOfTheAngle) {
    const Change speed = [](const auto& record, std::size_t row) {
        return row == 0 ? 0.0 : (record.angle_rad[row] - record.angle_rad[row - 1]) / 0.01;
    };
    const Change turnsPerMinute = [&speed](const auto& record, std::size_t row) {
        return 60.0 / (2.0 * Pi) * speed(record, row);
    };
    const Change backwards = [&speed](const auto& record, std::size_t row) { return -speed(record, row); };
    for (const Change& column : {speed, turnsPerMinute, backwards}) {
        const IdentifyResult result = identify(goodRecord(), column, currentOf);
        EXPECT_EQ(result.quality.verdict, Verdict::Refused);
        EXPECT_NE(findingOf(result, "speed_as_angle"), nullptr);
        expectNoValue(result);
    }
}

TEST(IdentifyPhysics, usesEveryPlateauOfAnAngleThatWrapsAndSaysSo) {
    const IdentifyResult whole = identify(goodRecord(), angleOf, currentOf);
    for (const double low_rad : {0.0, -Pi}) {
        const Change wrapped = [low_rad](const auto& record, std::size_t row) {
            const double angle = record.angle_rad[row];
            return angle - 2.0 * Pi * std::floor((angle - low_rad) / (2.0 * Pi));
        };
        const IdentifyResult result = identify(goodRecord(), wrapped, currentOf);
        const Finding* finding = findingOf(result, "angle_wraps");
        ASSERT_NE(finding, nullptr);
        EXPECT_NE(finding->message.find("angle wraps"), std::string::npos);
        EXPECT_EQ(findingOf(result, "plateaus_stopped"), nullptr);
        ASSERT_EQ(result.points.size(), whole.points.size());
        for (std::size_t i = 0; i < whole.points.size(); ++i) {
            EXPECT_EQ(result.points[i].isUsed, whole.points[i].isUsed);
        }
        // the same angle up to a constant: rounding of 1e-15 of the angle, grown by the fit
        EXPECT_NEAR(*result.torqueConstant.value / *whole.torqueConstant.value, 1.0, 1e-6);
    }
}

TEST(IdentifyPhysics, refusesFrictionBelowZero) {
    // Something else drives the rotor: as if friction pushed. 2 rad/s^2 against 26 per ampere.
    control::RecordRatios driven;
    driven.friction_rad_s2 = -10.0;
    control::RecordErrors errors;
    errors.noise_rad = 1e-3;
    control::RecordMaker record(driven, errors, 7);
    for (const double current : {1.0, 2.0, 1.5, 0.5, 1.0, 2.0, 1.5, 0.5}) {
        record.run(current, 4.0);
    }
    const IdentifyResult result = identify(record, angleOf, currentOf);
    EXPECT_EQ(result.quality.verdict, Verdict::Refused);
    EXPECT_NE(findingOf(result, "friction_below_zero"), nullptr);
    expectNoValue(result);
}

TEST(IdentifyPhysics, refusesDampingBelowZero) {
    control::RecordRatios driven;
    driven.damping_per_s = -0.5;
    control::RecordErrors errors;
    errors.noise_rad = 1e-3;
    control::RecordMaker record(driven, errors, 7);
    for (const double current : {2.0, 0.0, 2.5, 0.0, 2.0, 0.0, 2.5, 0.0}) {
        record.run(current, current > 0.0 ? 1.0 : 0.4);
    }
    const IdentifyResult result = identify(record, angleOf, currentOf);
    EXPECT_EQ(result.quality.verdict, Verdict::Refused);
    // so short a record tells the two losses apart poorly: one of them comes out below zero
    EXPECT_TRUE(findingOf(result, "damping_below_zero") || findingOf(result, "friction_below_zero"))
        << messagesOf(result);
    expectNoValue(result);
}

control::Estimate identified(double value, double low, double high) {
    control::Estimate estimate;
    estimate.value = value;
    estimate.interval95 = std::pair(low, high);
    estimate.source = control::EstimateSource::Identified;
    return estimate;
}

// J = c / (c/J): a given damping and a rotor that something drives have only a negative inertia in common.
TEST(IdentifyPhysics, refusesInertiaBelowZero) {
    for (const double inertia_kg_m2 : {-5.5e-4, -1e-9, 0.0}) {
        IdentifyResult result;
        result.torqueConstant = identified(1.43e-2, 1.4e-2, 1.46e-2);
        result.inertia = identified(inertia_kg_m2, inertia_kg_m2 - 1e-4, inertia_kg_m2 + 1e-4);
        judgePhysics(result, {});
        EXPECT_EQ(result.quality.verdict, Verdict::Refused) << inertia_kg_m2;
        EXPECT_NE(findingOf(result, "inertia_below_zero"), nullptr) << inertia_kg_m2;
        EXPECT_FALSE(result.inertia.value);
        expectNoValue(result);
    }
}

TEST(IdentifyPhysics, doubtsAnIntervalThatReachesZero) {
    struct Case {
        std::pair<double, double> inertia, torque;
        bool isDoubted;
    };
    for (const Case& one :
         {Case{{5e-4, 6e-4}, {1.4e-2, 1.5e-2}, false}, Case{{5e-4, 6e-4}, {-1e-3, 3e-2}, true},
          Case{{5e-4, 6e-4}, {0.0, 3e-2}, true}, Case{{-1e-4, 1e-3}, {1.4e-2, 1.5e-2}, true},
          Case{{1e-9, 1e-3}, {1e-9, 3e-2}, false}}) {
        IdentifyResult result;
        const auto middle = [](const std::pair<double, double>& interval) {
            return identified(0.5 * (interval.first + interval.second), interval.first, interval.second);
        };
        result.inertia = middle(one.inertia);
        result.torqueConstant = middle(one.torque);
        judgePhysics(result, {});
        EXPECT_EQ(findingOf(result, "interval_reaches_zero") != nullptr, one.isDoubted) << messagesOf(result);
        EXPECT_EQ(result.quality.verdict == Verdict::Doubtful, one.isDoubted) << messagesOf(result);
    }
}

TEST(IdentifyPhysics, aFrictionlessMotorHasNoFrictionAndCanBeTuned) {
    for (const char* uri : {"sim:htm?imperfections=off&Kf=0", "sim:htm?chain=ideal&Kf=0",
                            "sim:htm?imperfections=off&Kf=0&J=3e-4&c=2e-3"}) {
        const auto device = devices::openDevice(uri, {});
        ASSERT_TRUE(device);
        IdentifyConfig config;
        config.sweep = {0.2, 1.4, 0.2}; // 4 A would be faster than the sensors follow
        config.given.torqueConstant_Nm_per_A = 1.43e-2;
        const auto result = runIdentify(**device, config, {});
        ASSERT_TRUE(result) << uri << ": " << result.error().message;
        ASSERT_TRUE(result->coulombFriction.value && result->coulombFriction.interval95) << uri;
        EXPECT_GE(*result->coulombFriction.value, 0.0) << uri;
        EXPECT_GE(result->coulombFriction.interval95->first, 0.0) << uri;
        EXPECT_LT(*result->coulombFriction.value, 1e-4) << uri; // 0.5 % of the published motor's
        EXPECT_NE(result->quality.verdict, Verdict::Refused) << uri;
        EXPECT_TRUE(plantFromEstimate(motorEstimate(*result))) << uri;
        EXPECT_TRUE(uncertainPlantFromEstimate(motorEstimate(*result))) << uri;
    }
}

TEST(IdentifyPhysics, aModelWithFrictionJustBelowZeroIsAMotorWithoutFriction) {
    MotorEstimate estimate;
    estimate.values = {{"J", 5.5e-4}, {"c", 1.23e-3}, {"Kf", -2e-7}, {"phi", 1.43e-2}};
    const auto plant = plantFromEstimate(estimate);
    ASSERT_TRUE(plant) << plant.error().message;
    EXPECT_EQ(plant->breakawayCurrent_A, 0.0);
    estimate.values["Kf"] = -2e-3;
    EXPECT_FALSE(plantFromEstimate(estimate));
}

} // namespace
} // namespace halbench::app
