#pragma once

#include "app/window/docks/dock_moves.h"

#include <QMenu>

namespace halbench::app {

class DockLayout;

/// Arranges by key or menu the panel that has the focus, or had it last: what the mouse does by dragging.
/// Thread: GUI.
class DockMenu : public QMenu {
    Q_OBJECT

public:
    /// After the panels are there.
    DockMenu(DockLayout& docks, QWidget* parent);

private:
    ads::CDockWidget* dock() const; ///< null: no panel had the focus, or it is closed
    void toggleFloating();
    void addSides();
    void addTabs();
    void chooseTab(int by);
    void refresh();
    void noteFocus(const QWidget* focused);

    DockLayout& m_docks;
    const QWidget* m_manager; ///< only compared: it goes before the menu
    DockMoves m_moves;
    QAction* m_float = nullptr;
    QString m_id; ///< of the panel
};

} // namespace halbench::app
