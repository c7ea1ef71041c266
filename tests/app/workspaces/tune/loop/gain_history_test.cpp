#include "app/workspaces/tune/loop/gain_history.h"

#include <gtest/gtest.h>

namespace halbench::app {
namespace {

GainChoice edited(double proportional) {
    GainChoice choice{"edited"};
    choice.law.law.gains.proportional = proportional;
    return choice;
}

double gain(const GainChoice& choice) {
    return choice.law.law.gains.proportional;
}

TEST(GainHistory, whatWasDoneIsTakenBackAndDoneAgainInOrder) {
    GainHistory history;
    history.restart({"recommended"});
    EXPECT_FALSE(history.canUndo());
    history.record("a", {}, edited(1.0));
    history.record("b", {}, edited(2.0));
    EXPECT_EQ(history.undoName(), "b");
    EXPECT_EQ(gain(history.undo()), 1.0);
    EXPECT_EQ(history.redoName(), "b");
    EXPECT_EQ(history.undo().origin, "recommended");
    EXPECT_FALSE(history.canUndo());
    EXPECT_EQ(gain(history.redo()), 1.0);
    history.record("c", {}, edited(3.0)); // b can not be done again after something else
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(gain(history.undo()), 1.0);
}

TEST(GainHistory, changesOfOneKeyAreOneStepUntilSomethingIsTakenBack) {
    GainHistory history;
    history.restart(edited(1.0));
    history.record("edit", "kp", edited(2.0));
    history.record("edit", "kp", edited(3.0));
    EXPECT_EQ(gain(history.undo()), 1.0);
    EXPECT_EQ(gain(history.redo()), 3.0);
    history.record("edit", "kp", edited(4.0));
    EXPECT_EQ(gain(history.undo()), 3.0);
}

TEST(GainHistory, whatChangesNothingIsNoStep) {
    GainHistory history;
    history.restart(edited(1.0));
    history.record("edit", {}, edited(1.0));
    EXPECT_FALSE(history.canUndo());
    GainChoice other = edited(1.0);
    other.targets.zeta = 0.3;
    history.record("target", {}, other);
    EXPECT_TRUE(history.canUndo());
}

TEST(GainHistory, itForgetsTheOldestAndNotTheLast) {
    GainHistory history;
    history.restart(edited(0.0));
    for (int i = 1; i <= 1200; ++i) {
        history.record("edit", {}, edited(i));
    }
    EXPECT_EQ(gain(history.undo()), 1199.0);
    while (history.canUndo()) {
        history.undo();
    }
    EXPECT_EQ(gain(history.redo()), 701.0); // 500 of them
}

} // namespace
} // namespace halbench::app
