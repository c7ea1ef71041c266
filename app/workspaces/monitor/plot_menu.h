#pragma once

#include <QList>

class QAction;
class QMenu;
class QWidget;

namespace halbench::widgets {
class LivePlotStack;
}

namespace halbench::app {

/// What the Monitor adds to the plots' own commands.
struct PlotExports {
    QList<QAction*> copy; ///< to the clipboard
    QList<QAction*> save; ///< into a file
};

/// The menu of the plots by right click or menu key: every command of the stack and of its exports once, no
/// level with more than ten entries. Owned by the stack.
QMenu* makePlotMenu(widgets::LivePlotStack& stack, const PlotExports& exports);

} // namespace halbench::app
