#include "tests/widgets/gui_fixture.h"
#include "widgets/controls/action_button.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QSignalSpy>

namespace halbench::widgets {
namespace {

using ActionButtonTest = GuiTest;

TEST_F(ActionButtonTest, followsItsActionAndTriggersIt) {
    QAction action(themedIcon(QStringLiteral("undo")), QStringLiteral("Undo"));
    action.setToolTip(QStringLiteral("Undo the last edit (Ctrl+Z)"));
    ActionButton button(action, ActionButton::Shape::IconAndText);
    ActionButton small(action, ActionButton::Shape::IconOnly);
    EXPECT_EQ(button.text(), QStringLiteral("Undo"));
    EXPECT_TRUE(small.text().isEmpty());
    EXPECT_EQ(small.accessibleName(), QStringLiteral("Undo"));
    EXPECT_EQ(small.toolTip(), action.toolTip());
    QSignalSpy triggered(&action, &QAction::triggered);
    button.click();
    EXPECT_EQ(triggered.count(), 1);
    action.setEnabled(false);
    EXPECT_FALSE(button.isEnabled());
}

TEST_F(ActionButtonTest, showsWhetherACheckableActionIsOn) {
    QAction action(QStringLiteral("Follow"));
    action.setCheckable(true);
    ActionButton button(action, ActionButton::Shape::IconAndText);
    button.click();
    EXPECT_TRUE(action.isChecked());
    EXPECT_TRUE(button.isChecked());
    action.setChecked(false);
    EXPECT_FALSE(button.isChecked());
}

} // namespace
} // namespace halbench::widgets
