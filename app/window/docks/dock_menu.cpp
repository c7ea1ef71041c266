#include "app/window/docks/dock_menu.h"

#include "app/window/docks/dock_layout.h"

#include <QApplication>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>

namespace halbench::app {

namespace {

void giveKey(QAction& action, const char* key, const QString& what) {
    action.setShortcut(QKeySequence(QLatin1String(key)));
    action.setToolTip(
        QStringLiteral("%1 (%2)").arg(what, action.shortcut().toString(QKeySequence::NativeText)));
}

ads::DockWidgetArea edgeOf(PanelArea area) {
    switch (area) {
    case PanelArea::Left:
        return ads::LeftDockWidgetArea;
    case PanelArea::Right:
        return ads::RightDockWidgetArea;
    case PanelArea::Bottom:
        return ads::BottomDockWidgetArea;
    case PanelArea::Centre:
        break;
    }
    return ads::TopDockWidgetArea;
}

} // namespace

DockMenu::DockMenu(DockLayout& docks, QWidget* parent)
    : QMenu(parent), m_docks(docks), m_manager(docks.widget()),
      m_moves(*static_cast<ads::CDockManager*>(docks.widget())) {
    setToolTipsVisible(true);
    m_float = addAction(QString(), this, &DockMenu::toggleFloating);
    giveKey(*m_float, "Ctrl+Shift+F", tr("Move the panel to its own window with STOP, or dock it again"));
    addSeparator();
    addTabs();
    addSeparator();
    addSides();
    refresh();
    connect(this, &QMenu::aboutToShow, this, &DockMenu::refresh);
    connect(qobject_cast<QMenu*>(parent), &QMenu::aboutToShow, this, &DockMenu::refresh);
    connect(qApp, &QApplication::focusChanged, this,
            [this](QWidget*, QWidget* focused) { noteFocus(focused); });
    noteFocus(QApplication::focusWidget());
}

void DockMenu::addTabs() {
    const QString what = tr("Brings the tab beside it to the front, with the focus");
    giveKey(*addAction(tr("Ne&xt tab"), this, [this] { chooseTab(1); }), "Ctrl+PgDown", what);
    giveKey(*addAction(tr("&Previous tab"), this, [this] { chooseTab(-1); }), "Ctrl+PgUp", what);
}

/// In the panel's area, round and round.
void DockMenu::chooseTab(int by) {
    const ads::CDockWidget* panel = dock();
    const ads::CDockAreaWidget* area = panel == nullptr ? nullptr : panel->dockAreaWidget();
    if (area == nullptr) {
        return;
    }
    const QList<ads::CDockWidget*> tabs = area->openedDockWidgets();
    const int count = static_cast<int>(tabs.size());
    const int now = static_cast<int>(tabs.indexOf(area->currentDockWidget()));
    m_docks.raise(tabs[(now + by + count) % count]->objectName());
}

void DockMenu::addSides() {
    struct Row {
        QString text;
        const char* key;
        Side side;
    };
    const auto add = [this](const Row& row, const QString& what, auto act) {
        QAction* action = addAction(row.text, this, [this, act, side = row.side] {
            if (ads::CDockWidget* panel = dock()) {
                (m_moves.*act)(*panel, side);
            }
        });
        giveKey(*action, row.key, what);
    };
    const QString move = tr("Move the panel to the next place on that side or edge");
    for (const Row& row : {Row{tr("Move &left"), "Alt+Shift+Left", Side::Left},
                           Row{tr("Move &right"), "Alt+Shift+Right", Side::Right},
                           Row{tr("Move &up"), "Alt+Shift+Up", Side::Up},
                           Row{tr("Move &down"), "Alt+Shift+Down", Side::Down}}) {
        add(row, move, &DockMoves::move);
    }
    addSeparator();
    const QString resize = tr("Change the panel's size; neighbouring panels adjust");
    for (const Row& row :
         {Row{tr("&Wider"), "Alt+Shift+End", Side::Right}, Row{tr("&Narrower"), "Alt+Shift+Home", Side::Left},
          Row{tr("&Taller"), "Alt+Shift+PgDown", Side::Down},
          Row{tr("&Shorter"), "Alt+Shift+PgUp", Side::Up}}) {
        add(row, resize, &DockMoves::resize);
    }
}

/// From the widget up: while a window goes, the focus wanders through panels that are going too.
void DockMenu::noteFocus(const QWidget* focused) {
    for (const QWidget* one = focused; one != nullptr; one = one->parentWidget()) {
        const auto* panel = qobject_cast<const ads::CDockWidget*>(one);
        if (panel != nullptr && panel->dockManager() == m_manager) { // not one of another window
            m_id = panel->objectName();
        }
    }
}

ads::CDockWidget* DockMenu::dock() const {
    ads::CDockWidget* panel = m_docks.docks().value(m_id);
    return panel == nullptr || panel->isClosed() ? nullptr : panel;
}

/// Says which panel is meant; the keys stay alive whatever it says.
void DockMenu::refresh() {
    const ads::CDockWidget* panel = dock();
    setTitle(panel == nullptr ? tr("P&anel layout") : tr("P&anel layout “%1”").arg(panel->windowTitle()));
    const bool isAfloat = panel != nullptr && panel->isInFloatingContainer();
    m_float->setText(isAfloat ? tr("Dock it &back") : tr("&Float in its own window"));
}

void DockMenu::toggleFloating() {
    ads::CDockWidget* panel = dock();
    if (panel == nullptr) {
        return;
    }
    const std::vector<PanelSpec> specs = panelSpecs();
    const auto own =
        std::find_if(specs.begin(), specs.end(), [&](const PanelSpec& spec) { return spec.id == m_id; });
    QStringList home;
    for (const PanelSpec& spec : specs) {
        if (spec.area == own->area && spec.id != m_id) {
            home << spec.id;
        }
    }
    m_moves.toggleFloating(*panel, home, edgeOf(own->area));
}

} // namespace halbench::app
