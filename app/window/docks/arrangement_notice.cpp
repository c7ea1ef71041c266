#include "app/window/docks/arrangement_notice.h"

#include "app/window/docks/dock_layout.h"

namespace halbench::app {

ArrangementNotice::ArrangementNotice(DockLayout& docks, QWidget* parent) : MessageBar(parent) {
    connect(&docks, &DockLayout::arrangementUnread, this, &ArrangementNotice::say);
}

void ArrangementNotice::say(Perspective perspective, ArrangementFault fault, const QString& keptAs) {
    const QString title = perspectiveTitle(perspective).replace(QLatin1String("&&"), QLatin1String("&"));
    QString text;
    switch (fault) {
    case ArrangementFault::Damaged:
        text = tr("The arrangement of the panels in %1 is damaged; the first one is shown.");
        break;
    case ArrangementFault::Newer:
        text = tr("The arrangement of the panels in %1 is from a newer version; the first one is shown.");
        break;
    case ArrangementFault::Older:
        text = tr("The arrangement of the panels in %1 is from an older version; the first one is shown.");
        break;
    }
    showMessage({widgets::Severity::Warning,
                 text.arg(title),
                 tr("Nothing of it is lost: it stays in the file under the name %1.").arg(keptAs),
                 {}});
}

} // namespace halbench::app
