#include "app/workspaces/parts/preflight.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halbench::app {
namespace {

PreflightFacts ready() {
    PreflightFacts facts;
    facts.state = SessionState::Connected;
    facts.isSimulated = true;
    facts.temperature_degC = 25.0;
    facts.forecast_degC = 41.0;
    return facts;
}

bool isPassed(const PreflightFacts& facts) {
    const auto items = preflightItems(facts);
    return std::all_of(items.begin(), items.end(), [](const PreflightItem& item) { return item.isPassed; });
}

TEST(Preflight, passesAConnectedCoolFreeSimulatedMotor) {
    EXPECT_TRUE(isPassed(ready()));
}

TEST(Preflight, warmCoilsOnlyForbidWhatWouldBeTooWarmFromTheColdToo) {
    PreflightFacts facts = ready();
    facts.temperature_degC = 63.0;
    facts.forecast_degC = 96.0;
    facts.coldForecast_degC = 62.0; // the procedure waits for that
    EXPECT_TRUE(isPassed(facts));
    facts.coldForecast_degC = 75.0;
    EXPECT_FALSE(isPassed(facts));
}

TEST(Preflight, everythingThatForbidsMotionIsSaidWithItsRemedy) {
    std::vector<PreflightFacts> wrong(10, ready());
    wrong[0].state = SessionState::Lost;
    wrong[1].isBusy = true;
    wrong[2].board.fault = 3;
    wrong[3].board.isStopLatched = true;
    wrong[4].board.isArmed = true;
    wrong[5].forecast_degC = 70.0;
    wrong[6].isSimulated = false;
    wrong[7].state = SessionState::Reconnecting;
    wrong[8].isMotorKnown = false;
    wrong[9].isJustReleased = true;
    for (const PreflightFacts& facts : wrong) {
        EXPECT_FALSE(isPassed(facts));
        for (const PreflightItem& item : preflightItems(facts)) {
            EXPECT_EQ(item.remedy.isEmpty(), item.isPassed) << item.text.toStdString();
        }
    }
    wrong[6].hasConsent = true;
    EXPECT_TRUE(isPassed(wrong[6]));
}

TEST(Preflight, aDeviceThatOnlySensesNeedsNoConsentAndHasNoCoils) {
    PreflightFacts facts = ready();
    facts.isSimulated = false;
    facts.isDriven = false;
    EXPECT_TRUE(isPassed(facts));
    EXPECT_EQ(preflightItems(facts).size(), 2U);
    facts.board.fault = 7;
    EXPECT_FALSE(isPassed(facts));
}

TEST(Preflight, aLatchedStopNamesTheButtonThatReleasesIt) {
    PreflightFacts facts = ready();
    facts.board.isStopLatched = true;
    const std::vector<PreflightItem> items = preflightItems(facts);
    EXPECT_EQ(items.at(1).remedy, "Press Release next to the state at the top"); // STOP only stops
}

TEST(Preflight, whatAProcedureArmedIsNotArmedByHand) {
    PreflightFacts facts = ready();
    facts.isBusy = true;
    facts.board.isArmed = true;
    EXPECT_EQ(preflightItems(facts).at(0).text, "Another procedure is running");
    facts.running = "Verification running";
    const std::vector<PreflightItem> items = preflightItems(facts);
    EXPECT_EQ(items.at(0).text, "Verification running");
    EXPECT_FALSE(items.at(0).isPassed); // nothing is started beside it
    for (const PreflightItem& item : items) {
        EXPECT_FALSE(item.text.contains("manually") || item.text.contains("Another"))
            << item.text.toStdString();
    }
}

TEST(Preflight, aDeviceThatIsLookedForIsNotOneThatWasNeverConnected) {
    PreflightFacts facts = ready();
    facts.state = SessionState::Reconnecting;
    EXPECT_TRUE(preflightItems(facts).front().text.contains("reconnecting"));
    facts.state = SessionState::Disconnected;
    EXPECT_EQ(preflightItems(facts).front().text, "No device is connected");
}

} // namespace
} // namespace halbench::app
