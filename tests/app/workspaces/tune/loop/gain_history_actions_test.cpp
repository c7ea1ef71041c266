#include "app/workspaces/tune/loop/gain_history_actions.h"
#include "tests/widgets/gui_fixture.h"

namespace halbench::app {
namespace {

GainChoice edited(double proportional) {
    GainChoice choice{"edited"};
    choice.law.law.gains.proportional = proportional;
    return choice;
}

class GainHistoryActionsTest : public widgets::GuiTest {
protected:
    GainHistoryActionsTest() {
        QObject::connect(&actions, &GainHistoryActions::chosen, &actions,
                         [this](const GainChoice& choice) { chosen = choice.law.law.gains.proportional; });
    }
    GainHistoryActions actions;
    double chosen = 0.0;
};

TEST_F(GainHistoryActionsTest, actionsAreNamedAfterTheChange) {
    actions.restart(edited(1.0));
    EXPECT_EQ(actions.undo().text(), "&Undo");
    EXPECT_FALSE(actions.undo().isEnabled());
    actions.record("Edit K_P", {}, edited(2.0));
    EXPECT_EQ(actions.undo().text(), "&Undo: Edit K_P");
    EXPECT_TRUE(actions.undo().isEnabled());
    EXPECT_FALSE(actions.redo().isEnabled());
    EXPECT_TRUE(actions.undo().toolTip().startsWith("Undo: Edit K_P (")) << "with its key";
}

TEST_F(GainHistoryActionsTest, undoAndRedoChooseTheGainsOfThen) {
    actions.restart(edited(1.0));
    actions.record("Edit K_P", {}, edited(2.0));
    actions.undo().trigger();
    EXPECT_EQ(chosen, 1.0);
    EXPECT_EQ(actions.redo().text(), "&Redo: Edit K_P");
    EXPECT_FALSE(actions.undo().isEnabled());
    actions.redo().trigger();
    EXPECT_EQ(chosen, 2.0);
    actions.restart(edited(5.0));
    EXPECT_FALSE(actions.undo().isEnabled());
}

} // namespace
} // namespace halbench::app
