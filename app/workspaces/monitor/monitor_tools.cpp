#include "app/workspaces/monitor/monitor_tools.h"

#include "widgets/live_plot/live_plot_stack.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QToolBar>
#include <QToolButton>

namespace halbench::app {

namespace {

using Command = widgets::LivePlotStack::Command;

struct Tool {
    Command command;
    const char* icon;
    bool hasText = false;
};
constexpr Tool Tools[] = {{Command::Pause, "pause"},   {Command::Follow, "follow", true},
                          {Command::Fit, "fit"},       {Command::ShowAll, "whole"},
                          {Command::ZoomBack, "back"}, {Command::Cursors, "cursor"},
                          {Command::Marker, "note"},   {Command::AddSignals, "add"}};

} // namespace

void addPlotTools(QToolBar& bar, widgets::LivePlotStack& stack) {
    for (const Tool& tool : Tools) {
        QAction* action = stack.action(tool.command);
        action->setIcon(widgets::themedIcon(QLatin1String(tool.icon)));
        addTool(bar, *action, tool.hasText);
    }
}

void addTool(QToolBar& bar, QAction& action, bool hasText, QAction* before) {
    bar.insertAction(before, &action);
    auto* button = static_cast<QToolButton*>(bar.widgetForAction(&action));
    button->setAccessibleName(action.text());
    const Qt::ToolButtonStyle inWords =
        action.icon().isNull() ? Qt::ToolButtonTextOnly : Qt::ToolButtonTextBesideIcon;
    button->setToolButtonStyle(hasText ? inWords : Qt::ToolButtonIconOnly);
    button->setPopupMode(QToolButton::InstantPopup); // of one that has a menu
}

} // namespace halbench::app
