#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/step_list.h"

#include <QSignalSpy>
#include <QtTest/QTest>

namespace halbench::widgets {
namespace {

class StepListTest : public GuiTest {
protected:
    void fill(StepList& list) {
        list.setSteps({QStringLiteral("Prepare"), QStringLiteral("Sweep"), QStringLiteral("Assess")});
    }
};

TEST_F(StepListTest, saysEachStateAsSymbolAndInWords) {
    StepList list;
    fill(list);
    list.setStepState(0, StepState::Done);
    list.setStepState(1, StepState::Failed, QStringLiteral("Coil B is too warm."));
    EXPECT_EQ(list.item(0)->text(), QStringLiteral("1. Prepare"));
    EXPECT_EQ(list.item(0)->data(Qt::AccessibleTextRole).toString(),
              QStringLiteral("Step 1 of 3, Prepare, done"));
    EXPECT_TRUE(list.item(1)->toolTip().contains(QStringLiteral("failed. Coil B is too warm.")));
    EXPECT_EQ(list.stepState(2), StepState::Waiting);
    for (const StepState state : {StepState::Waiting, StepState::Current, StepState::Running, StepState::Done,
                                  StepState::Warning, StepState::Failed, StepState::Skipped}) {
        list.setStepState(2, state);
        EXPECT_FALSE(list.item(2)->icon().isNull());
    }
}

TEST_F(StepListTest, goesOnlyToStepsThatCanBeReached) {
    StepList list;
    fill(list);
    list.setReachable(2, false);
    QSignalSpy chosen(&list, &StepList::stepChosen);
    list.setCurrentStep(0);
    EXPECT_EQ(chosen.count(), 0); // the program turned the page, not the user
    QTest::keyClick(&list, Qt::Key_Down);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen[0][0].toInt(), 1);
    QTest::keyClick(&list, Qt::Key_Down);
    EXPECT_EQ(chosen.count(), 1);
}

} // namespace
} // namespace halbench::widgets
