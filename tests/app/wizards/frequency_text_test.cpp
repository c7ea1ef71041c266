#include "app/procedures/frequency/frequency_board.h"
#include "app/wizards/frequency_text.h"
#include "tests/widgets/gui_fixture.h"

#include <cmath>

namespace halbench::app {
namespace {

class FrequencyWordsTest : public widgets::GuiTest {};

TEST_F(FrequencyWordsTest, aMarginThatIsWithheldHasNoNumberAndSaysWhy) {
    FrequencyResult result;
    result.margins.phase_deg = {control::MeasuredMargin::Withheld::No, 20.0, 37.0, std::pair(36.0, 38.0)};
    result.margins.gain_dB = {
        control::MeasuredMargin::Withheld::Uncertain, 60.0, {}, std::pair(-INFINITY, INFINITY)};
    const auto rows = frequencyRows(result);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].value, 37.0);
    EXPECT_EQ(rows[0].low95, 36.0);
    EXPECT_FALSE(rows[1].value || rows[1].low95 || rows[1].high95); // no infinity on the screen
    EXPECT_EQ(rows[1].source, "not given: too uncertain");
    result.margins.gain_dB.withheld = control::MeasuredMargin::Withheld::Gap;
    EXPECT_EQ(frequencyRows(result)[1].source, "not given: crossover in a gap");
    result.margins.gain_dB.withheld = control::MeasuredMargin::Withheld::NoCrossing;
    EXPECT_EQ(frequencyRows(result)[1].source, "not given: no crossover");
}

TEST_F(FrequencyWordsTest, theLoopThatWouldBeMeasuredIsThatOfTheDevice) {
    devices::Catalogue catalogue;
    const auto published = frequencyOutlookMargins(catalogue, {});
    EXPECT_EQ(published.law.kp_A_per_rad, 10.0);
    EXPECT_EQ(published.period_s, 0.01);
}

TEST_F(FrequencyWordsTest, theOutlookTellsTimeAndTurnsOfThePlan) {
    const FrequencyConfig config;
    const FrequencyMargins margins = frequencyMargins({}, {});
    const auto plan = planFrequency(config, margins);
    ASSERT_TRUE(plan);
    const QString text = frequencyOutlook(config, *plan, 44.0);
    EXPECT_TRUE(text.contains("3:44 minutes")) << text.toStdString(); // 8 s and three times 9 periods of 8 s
    EXPECT_TRUE(text.contains("coil temperature 44\u00a0\u00b0C")) << text.toStdString();
    EXPECT_TRUE(text.contains("stops at 40\u00a0rad/s"));
}

TEST_F(FrequencyWordsTest, bandsAreToldWithTheirAmplitude) {
    FrequencyResult result;
    result.bands = {{0.5, 2.0, 14, M_PI / 180.0}, {3.0, 3.0, 1, 0.1}};
    const QString text = frequencyUse(result);
    EXPECT_TRUE(text.contains("0.50 to 2.00 Hz: amplitude 1.000\u00b0")) << text.toStdString();
    EXPECT_FALSE(text.contains("3.00 to 3.00")); // a single line is no band
}

} // namespace
} // namespace halbench::app
