#pragma once

#include <QString>

class QAction;
class QKeySequence;

namespace halbench::app {

class DockLayout;

/// Action of a panel beside the plots: brings it to the front, or closes it when it is there; checked while
/// it is open, hidden while the device has no use for it. The layout owns it.
QAction* makePanelToggle(DockLayout& docks, const QString& panel, const QKeySequence& key);

} // namespace halbench::app
