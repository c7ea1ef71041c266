#include "app/wizards/identify_text.h"
#include "app/workbench/wall_clock.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

TEST(IdentifyWords, theOutlookIsThatOfThePublishedMotor) {
    const IdentifyConfig config;
    const SweepOutlook outlook = sweepOutlook(config, 25.0);
    EXPECT_NEAR(outlook.largestSpeed_rad_s, (26.0 * 4.0 - 37.2727) / 2.236364, 0.01); // htm-theory.md 2
    EXPECT_EQ(outlook.prediction.peakCurrent_A, 4.0);
    // Half of the dwell at the middle current of 2.8 A, 15.9 rad/s: the right order, no more.
    EXPECT_GT(outlook.turns, 100.0);
    EXPECT_LT(outlook.turns, 1500.0);
    IdentifyConfig forward = config;
    forward.directions = SweepDirections::Forward;
    EXPECT_NEAR(sweepOutlook(forward, 25.0).turns, 0.5 * outlook.turns, 1e-9);
    EXPECT_TRUE(outlookText(forward, sweepOutlook(forward, 25.0), {}).contains("forward"));
}

// htm-theory.md 7.1: speed against current gives quotients alone; J or phi makes constants of them, c and K_f
// do not tell the torque of a current.
TEST(IdentifyWords, theOutlookSaysBeforeTheRunWhatItCannotFind) {
    const auto outlook = [](const IdentifyConfig& config) {
        return outlookText(config, sweepOutlook(config, 25.0), {});
    };
    IdentifyConfig config;
    EXPECT_TRUE(outlook(config).contains("ratios"));
    for (const char* symbol : {"J", "phi"}) {
        IdentifyConfig given;
        ASSERT_TRUE(setGivenConstant(given.given, symbol, 0.01));
        EXPECT_FALSE(outlook(given).contains("ratios")) << symbol;
    }
}

// 40 rad/s are 382 r/min: each speed in the unit that the user prefers, and in no other.
TEST(IdentifyWords, theOutlookHasOneUnitOfSpeed) {
    const IdentifyConfig config;
    DisplayUnits units;
    EXPECT_TRUE(outlookText(config, sweepOutlook(config, 25.0), units).contains("stops at 382 r/min"));
    EXPECT_FALSE(outlookText(config, sweepOutlook(config, 25.0), units).contains("rad/s"));
    units.speed = SpeedUnit::RadiansPerSecond;
    EXPECT_TRUE(outlookText(config, sweepOutlook(config, 25.0), units).contains("stops at 40 rad/s"));
    EXPECT_FALSE(outlookText(config, sweepOutlook(config, 25.0), units).contains("r/min"));
}

TEST(IdentifyWords, aGoodResultThatIsRemarkedOnDoesNotSayThatNothingSpeaksAgainstIt) {
    DataQuality quality;
    quality.verdict = Verdict::Good;
    EXPECT_TRUE(verdictTitle(quality).contains("the model fits"));
    quality.findings.push_back({"calibration_unknown", "the sensors were not calibrated", "calibrate first"});
    EXPECT_FALSE(verdictTitle(quality).contains("the model fits"));
    EXPECT_TRUE(verdictTitle(quality).startsWith("Good"));
}

TEST(IdentifyWords, saysWhatSuppliesEachMissingConstant) {
    IdentifyResult result; // nothing identified, steady plateaus only
    EXPECT_TRUE(missingText(result).contains("run-ups and coast-downs"));
    result.ratios["c_over_J"].value = 2.2;
    EXPECT_TRUE(missingText(result).contains("part of known inertia"));
    const control::Estimate known{1.0, {}, control::EstimateSource::Given, ""};
    result.inertia = result.viscousDamping = result.coulombFriction = result.torqueConstant = known;
    EXPECT_TRUE(missingText(result).isEmpty());
}

TEST(IdentifyWords, aGivenConstantHasNoInterval) {
    IdentifyResult result;
    result.inertia = {5.5e-4, std::pair(5.5e-4, 5.5e-4), control::EstimateSource::Given, "kg*m^2"};
    const auto rows = estimateRows(result);
    EXPECT_FALSE(rows.at(3).low95);
    EXPECT_EQ(rows.at(3).unit, "kg\u00b7m\u00b2");
    EXPECT_FALSE(rows.at(0).value);
    EXPECT_FALSE(rows.at(0).remark.isEmpty());
}

TEST(IdentifyWords, provenanceNamesDeviceOverridesAndSeed) {
    ResultHeader header;
    header.device = devices::DeviceInfo{"", "htm", "sim-htm-7", "FW1", "", true, {{"c", "0.002"}}};
    header.seed = 7;
    header.started = "2026-05-04T03:02:01Z";
    const QString text = provenanceText(header, 245.0, 48.2);
    for (const char* part : {"sim-htm-7", "FW1", "c=0.002", "seed 7", HALBENCH_VERSION, "started ",
                             "4:05 minutes of device time", "48.2"}) {
        EXPECT_TRUE(text.contains(part)) << part << " in " << text.toStdString();
    }
    EXPECT_TRUE(text.contains(localDate(header.started))) << text.toStdString();
    EXPECT_FALSE(text.contains("T03:02:01Z")) << text.toStdString();
}

TEST(IdentifyWords, virtualTimeHasNoDate) {
    const QString text = provenanceText(ResultHeader(), 0.0, std::nullopt);
    EXPECT_FALSE(text.contains("1970")) << text.toStdString();
    EXPECT_TRUE(text.contains("virtual time"));
    EXPECT_FALSE(text.contains("minutes")); // an old file does not say it
}

TEST(IdentifyWords, saysThatFrictionWhileMovingIsNotTheBreakawayCurrent) {
    IdentifyResult result;
    EXPECT_TRUE(frictionNote(result).isEmpty());
    result.ratios["Kf_over_phi"].value = 1.43;
    EXPECT_TRUE(frictionNote(result).contains("from rest"));
    EXPECT_TRUE(frictionNote(result).contains("identification.md#62-two-currents-of-friction"));
}

} // namespace
} // namespace halbench::app
