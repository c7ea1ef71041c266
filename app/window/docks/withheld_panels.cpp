#include "app/window/docks/withheld_panels.h"

#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockWidget.h>

#include <utility>

namespace halbench::app {

namespace {

/// Makes the panel the current tab of its area in a state of the docking library: the panel's own element
/// stands at `at`, inside the element of its area.
void bringToFront(QByteArray& state, const QByteArray& panel, int at) {
    const int area = at < 0 ? -1 : state.lastIndexOf("<Area ", at);
    const QByteArray current = "Current=\"";
    const int begin = area < 0 ? -1 : state.indexOf(current, area) + current.size();
    if (begin >= current.size() && begin < at) {
        state.replace(begin, state.indexOf('"', begin) - begin, panel);
    }
}

} // namespace

bool WithheldPanels::setAbsent(QSet<QString> absent) {
    if (absent == m_absent) {
        return false;
    }
    m_absent = std::move(absent);
    const QHash<QString, bool> closed = std::exchange(m_closed, {});
    for (auto panel = closed.begin(); panel != closed.end(); ++panel) {
        if (isAbsent(panel.key())) {
            m_closed.insert(panel.key(), panel.value());
        } else {
            open(panel.key(), panel.value());
        }
    }
    close();
    return true;
}

void WithheldPanels::close() {
    for (const QString& id : m_absent) {
        ads::CDockWidget* dock = m_docks.value(id);
        if (dock != nullptr && !dock->isClosed()) {
            const ads::CDockAreaWidget* area = dock->dockAreaWidget();
            m_closed.insert(id, area != nullptr && area->currentDockWidget() == dock);
            dock->toggleView(false);
        }
    }
}

/// The docking library brings what it opens to the front.
void WithheldPanels::open(const QString& id, bool isInFront) {
    ads::CDockWidget* dock = m_docks.value(id);
    const ads::CDockAreaWidget* area = dock->dockAreaWidget();
    ads::CDockWidget* front = area == nullptr ? nullptr : area->currentDockWidget();
    dock->toggleView(true);
    if (!isInFront && front != nullptr && !front->isClosed()) {
        front->setAsCurrentTab();
    }
}

QByteArray WithheldPanels::opened(QByteArray state) const {
    for (auto panel = m_closed.begin(); panel != m_closed.end(); ++panel) {
        const QByteArray name = "Name=\"" + panel.key().toUtf8() + "\" Closed=\"";
        if (panel.value()) {
            bringToFront(state, panel.key().toUtf8(), state.indexOf(name));
        }
        state.replace(name + "1\"", name + "0\"");
    }
    return state;
}

} // namespace halbench::app
