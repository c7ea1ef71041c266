// The menu of the plots by right click.
#include "tests/app/workspaces/monitor/monitor_fixture.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QMenu>

#include <algorithm>

namespace halbench::app {
namespace {

class PlotMenuTest : public MonitorTest {
protected:
    QMenu* menu() {
        for (auto* found : stack().findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly)) {
            if (found->actions().contains(stack().action(widgets::LivePlotStack::Command::Fit))) {
                return found;
            }
        }
        return nullptr;
    }
    /// Of this menu and those below it; each with at most ten entries.
    static void collect(const QMenu& menu, QList<QAction*>& leaves) {
        int entries = 0;
        for (QAction* action : menu.actions()) {
            entries += action->isSeparator() ? 0 : 1;
            if (action->menu() != nullptr) {
                collect(*action->menu(), leaves);
            } else if (!action->isSeparator()) {
                leaves << action;
            }
        }
        EXPECT_LE(entries, 10) << menu.title().toStdString();
        EXPECT_GT(entries, 0) << menu.title().toStdString();
    }
};

TEST_F(PlotMenuTest, hasEveryCommandOfThePlotsOnceAndNoLevelOfMoreThanTenEntries) {
    ASSERT_NE(menu(), nullptr);
    QList<QAction*> leaves;
    collect(*menu(), leaves);
    for (QAction* action : stack().actions()) {
        EXPECT_EQ(leaves.count(action), 1) << action->text().toStdString();
    }
    EXPECT_EQ(leaves.size(), stack().actions().size());
}

TEST_F(PlotMenuTest, comesByRightClickOnAPlot) {
    connectTo("sim:htm", 5.0);
    auto* canvas = panel->findChild<widgets::LivePlot*>()->canvas();
    const QPoint place = canvas->rect().center();
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, canvas->mapToGlobal(place));
    QApplication::sendEvent(canvas, &event);
    EXPECT_TRUE(menu()->isVisible());
    menu()->hide();
}

} // namespace
} // namespace halbench::app
