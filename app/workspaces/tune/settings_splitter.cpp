#include "app/workspaces/tune/settings_splitter.h"

namespace halbench::app {

SettingsSplitter::SettingsSplitter(QWidget* settings, QWidget* pictures, QWidget* parent)
    : QSplitter(Qt::Horizontal, parent) {
    setChildrenCollapsible(false);
    addWidget(settings);
    addWidget(pictures);
    connect(this, &QSplitter::splitterMoved, this, [this] { m_isMoved = true; });
}

/// Later, once the splitter has given its parts their places: docks that are arranged set its stretch.
void SettingsSplitter::resizeEvent(QResizeEvent* event) {
    QSplitter::resizeEvent(event);
    QMetaObject::invokeMethod(this, &SettingsSplitter::shareWidth, Qt::QueuedConnection);
}

void SettingsSplitter::shareWidth() {
    if (!m_isMoved) {
        setSizes({widget(0)->minimumWidth(), width()});
    }
}

} // namespace halbench::app
