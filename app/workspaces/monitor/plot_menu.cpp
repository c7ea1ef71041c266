#include "app/workspaces/monitor/plot_menu.h"

#include "app/workspaces/monitor/monitor_panel.h"
#include "widgets/live_plot/live_plot_stack.h"

#include <QMenu>

#include <initializer_list>

namespace halbench::app {

namespace {

using Command = widgets::LivePlotStack::Command;

void add(QMenu& menu, const widgets::LivePlotStack& stack, std::initializer_list<Command> commands) {
    for (const Command command : commands) {
        menu.addAction(stack.action(command));
    }
}

} // namespace

QMenu* makePlotMenu(widgets::LivePlotStack& stack, const PlotExports& exports) {
    auto* menu = new QMenu(&stack);
    add(*menu, stack, {Command::Fit, Command::Follow, Command::Pause});
    menu->addSeparator();
    add(*menu, stack, {Command::AddSignals});
    add(*menu->addMenu(MonitorPanel::tr("Cursors")), stack,
        {Command::Cursors, Command::CursorA, Command::CursorB, Command::NewPair, Command::RemovePair,
         Command::NextPair, Command::PreviousPair, Command::NamePair, Command::ShowPair, Command::PairHere});
    add(*menu->addMenu(MonitorPanel::tr("Markers")), stack,
        {Command::Marker, Command::MarkerNote, Command::NextMarker, Command::PreviousMarker,
         Command::RemoveMarker, Command::ListMarkers});
    menu->addSeparator();
    add(*menu->addMenu(MonitorPanel::tr("View")), stack,
        {Command::ZoomBack, Command::ShowAll, Command::ZoomIn, Command::ZoomOut, Command::ScrollBack,
         Command::ScrollOn, Command::ZoomValuesIn, Command::ZoomValuesOut, Command::FitValues});
    QMenu* plot = menu->addMenu(MonitorPanel::tr("Plot"));
    add(*plot, stack,
        {Command::OwnTime, Command::OneTimeAxis, Command::KeepReference, Command::RemoveReference,
         Command::PlotRight, Command::PlotLeft, Command::NewBeside, Command::RemovePlot});
    add(*plot->addMenu(MonitorPanel::tr("Size")), stack,
        {Command::Taller, Command::Shorter, Command::Wider, Command::Narrower, Command::EqualSizes});
    menu->addSeparator();
    menu->addMenu(MonitorPanel::tr("Copy"))->addActions(exports.copy);
    menu->addMenu(MonitorPanel::tr("Save"))->addActions(exports.save);
    return menu;
}

} // namespace halbench::app
