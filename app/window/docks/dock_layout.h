#pragma once

#include "app/window/docks/dock_sizes.h"
#include "app/window/docks/kept_arrangement.h"
#include "app/window/docks/panels.h"
#include "app/window/docks/withheld_panels.h"

#include <QByteArray>
#include <QHash>
#include <QObject>

#include <optional>

namespace ads {
class CDockAreaWidget;
class CDockManager;
class CDockWidget;
class CFloatingDockContainer;
} // namespace ads

namespace halbench::app {

/// The docked panels and their five arrangements. Each arrangement is kept as the user left it; `reset` gives
/// the first one back. Thread: GUI.
class DockLayout : public QObject {
    Q_OBJECT

public:
    /// Without panels until furnish().
    explicit DockLayout(QWidget* container);

    /// Makes the panels and arranges them. Once; before it only the perspective can be chosen.
    void furnish(Workbench& bench);

    QWidget* widget() const;
    /// The panel with this id; null before furnish(). One behind another tab has no parent: the window's
    /// findChild() misses it.
    QWidget* panel(const QString& id) const;
    Perspective perspective() const { return m_perspective; }
    void setPerspective(Perspective perspective);
    /// The same on the user's wish: the focus goes into its main panel, so that Tab and F1 act there.
    void enterPerspective(Perspective perspective);
    void reset();

    /// Panels that the open device has no use for are closed and cannot be opened; a perspective whose main
    /// panel is among them is left for Monitor.
    void setAbsent(const QSet<QString>& absent);
    bool isOffered(const QString& panel) const { return !m_withheld.isAbsent(panel); }
    bool isOffered(Perspective perspective) const;
    /// Opens the panel where it was last, brings it to the front and gives it the focus.
    void raise(const QString& panel);
    /// Opens it without the focus.
    void unfold(const QString& panel);
    /// The perspective's main panel and nothing beside it, and back. Choosing a perspective ends it.
    void setMainOnly(bool isOnly);
    bool isMainOnly() const { return !m_beforeMainOnly.isEmpty(); }
    /// The list of devices is the start page; with a device the plots are in front of it.
    void setDeviceOpen(bool isOpen);

    /// Name of the panel that holds the widget; empty when none does.
    QString helpAddressOf(const QWidget* widget) const;
    const QHash<QString, ads::CDockWidget*>& docks() const { return m_docks; }

    /// Arrangements by perspectiveId(). One that cannot be shown stays among them under another name.
    QHash<QString, QByteArray> arrangements();
    /// Shows the perspective as these have it; without one, that which is shown now.
    void setArrangements(const QHash<QString, QByteArray>& arrangements,
                         std::optional<Perspective> perspective = {});

Q_SIGNALS:
    void perspectiveChanged();
    void offerChanged(); ///< of panels and perspectives
    void mainOnlyChanged();
    /// The kept arrangement could not be shown, the first one is; it is among arrangements() as `keptAs`.
    void arrangementUnread(Perspective perspective, ArrangementFault fault, const QString& keptAs);
    void stopRequested(); ///< by the small STOP that every floating dock carries

private:
    void addPanel(const PanelSpec& spec, Workbench& bench);
    bool hasRightNeighbour(const PanelSpec& spec) const;
    void arrange(Perspective perspective);
    void leaveStartPage();
    QString shownMain(Perspective perspective) const;
    QByteArray shownArrangement() const;
    bool restoreKept();
    void addStop(ads::CFloatingDockContainer& window);
    void keepFocus(QWidget* before);
    void focusCentre();
    static void focusFirst(QWidget& content);
    void watchTabs(ads::CDockAreaWidget* area);

    std::vector<PanelSpec> m_specs;
    ads::CDockManager* m_manager = nullptr;
    bool m_isDeviceOpen = false;
    bool m_hadFocus = false; ///< the area whose tab is being changed
    QHash<QString, ads::CDockWidget*> m_docks;
    DockSizes m_sizes{m_specs, m_docks};
    WithheldPanels m_withheld{m_docks};
    QHash<QString, QByteArray> m_arrangements;
    QByteArray m_beforeMainOnly; ///< the arrangement, while the main panel stands alone
    QByteArray m_first;          ///< every panel at its first place
    Perspective m_perspective = Perspective::Monitor;
};

} // namespace halbench::app
