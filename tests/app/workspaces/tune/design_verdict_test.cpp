#include "app/workspaces/tune/design_verdict.h"
#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/verdict_view.h"

namespace halbench::app {
namespace {

class DesignVerdictTest : public widgets::GuiTest {
protected:
    QString shown(const std::optional<Finding>& foreign = std::nullopt) {
        showDesignVerdict(view, result, foreign);
        return view.text();
    }

    TuneResult result;
    widgets::VerdictView view;
};

TEST_F(DesignVerdictTest, goodDesignIsCalledGood) {
    EXPECT_EQ(shown(), "Good: robustly stable");
}

TEST_F(DesignVerdictTest, designNearTheLimitIsNotCalledGood) {
    result.warnings = {{"small_margin", "little phase margin", "Ask for more."}};
    const QString text = shown();
    EXPECT_TRUE(text.startsWith("Stable with little reserve: check the warnings")) << text.toStdString();
    EXPECT_TRUE(text.contains("Ask for more.")) << text.toStdString();
}

TEST_F(DesignVerdictTest, designForAnotherMotorIsDoubtfulFirst) {
    result.warnings = {{"slow", "the loop is slow", "Ask for more."}};
    const QString text =
        shown(Finding{"foreign_motor", "identified on another device", "Identify this one."});
    EXPECT_FALSE(text.startsWith("Good")) << text.toStdString();
    EXPECT_LT(text.indexOf("another device"), text.indexOf("the loop is slow")) << text.toStdString();
}

TEST_F(DesignVerdictTest, problemIsTheVerdictWithItsHint) {
    showDesignProblem(view, {ErrorCode::Refused, "no stable loop", "Choose another method."});
    EXPECT_TRUE(view.text().contains("no stable loop")) << view.text().toStdString();
    EXPECT_TRUE(view.text().contains("Choose another method.")) << view.text().toStdString();
}

} // namespace
} // namespace halbench::app
