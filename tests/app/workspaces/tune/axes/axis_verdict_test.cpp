#include "app/workspaces/tune/axes/axis_verdict.h"
#include "tests/widgets/gui_fixture.h"

namespace halbench::app {
namespace {

class AxisVerdictTest : public widgets::GuiTest {
protected:
    static TuneResult loopOf(const char* axis, Verdict verdict) {
        TuneResult loop;
        loop.conditions.axis.emplace();
        loop.conditions.axis->id = axis;
        loop.quality.verdict = verdict;
        return loop;
    }
    QString shown(const Result<TuneAxesResult>& result, bool isWaiting = false) {
        showAxesVerdict(view, result, isWaiting);
        return view.text();
    }

    widgets::VerdictView view;
};

TEST_F(AxisVerdictTest, axesThatAreAllGoodHaveOneVerdict) {
    TuneAxesResult result;
    result.axes = {loopOf("x", Verdict::Good), loopOf("phi", Verdict::Good)};
    EXPECT_EQ(shown(result), "All axes: Good: robustly stable");
}

TEST_F(AxisVerdictTest, worstAxisIsNamedWithItsRemarks) {
    TuneAxesResult result;
    result.axes = {loopOf("x", Verdict::Doubtful), loopOf("y", Verdict::Refused),
                   loopOf("phi", Verdict::Good)};
    result.quality.verdict = Verdict::Refused;
    result.quality.findings = {{"unstable", "y: the loop is unstable", "Lower the gains."}};
    const QString text = shown(result);
    EXPECT_TRUE(text.startsWith("Axis y: Rejected: this loop is unstable")) << text.toStdString();
    EXPECT_TRUE(text.contains("Lower the gains.")) << text.toStdString();
}

TEST_F(AxisVerdictTest, goodLoopsNearTheLimitAreNotCalledGood) {
    TuneAxesResult result;
    result.axes = {loopOf("x", Verdict::Good)};
    result.axes[0].warnings = {{"small_margin", "x: little phase margin", "Ask for more."}};
    EXPECT_EQ(shown(result), "All axes: Stable with little reserve: check the warnings");
}

TEST_F(AxisVerdictTest, missingResultIsAnErrorUnlessItIsComputed) {
    const Result<TuneAxesResult> none = failure(ErrorCode::Refused, "axis x: no gains", "Choose a method.");
    EXPECT_EQ(shown(none, true), "Computing the loops");
    const QString text = shown(none);
    EXPECT_TRUE(text.startsWith("axis x: no gains")) << text.toStdString();
    EXPECT_TRUE(text.contains("Choose a method.")) << text.toStdString();
}

} // namespace
} // namespace halbench::app
