#include "app/window/docks/panel_toggle.h"

#include "app/window/docks/dock_layout.h"

#include <QAction>
#include <QKeySequence>
#include <qtadvanceddocking/DockWidget.h>

namespace halbench::app {

QAction* makePanelToggle(DockLayout& docks, const QString& panel, const QKeySequence& key) {
    ads::CDockWidget* dock = docks.docks().value(panel);
    auto* action = new QAction(dock->windowTitle(), &docks);
    action->setCheckable(true);
    action->setShortcut(key);
    action->setToolTip(
        DockLayout::tr("Show or hide this panel (%1)").arg(key.toString(QKeySequence::NativeText)));
    QObject::connect(action, &QAction::triggered, &docks, [&docks, action, dock, panel] {
        const bool isSeen = !dock->isClosed() && dock->widget()->isVisible();
        if (isSeen) {
            dock->toggleView(false);
        } else {
            docks.raise(panel);
        }
        action->setChecked(!dock->isClosed());
    });
    QObject::connect(dock, &ads::CDockWidget::viewToggled, action, &QAction::setChecked);
    QObject::connect(&docks, &DockLayout::offerChanged, action,
                     [&docks, action, panel] { action->setVisible(docks.isOffered(panel)); });
    action->setChecked(!dock->isClosed());
    return action;
}

} // namespace halbench::app
