#pragma once

#include "app/window/docks/kept_arrangement.h"
#include "app/window/docks/panels.h"

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
    /// The kept arrangement could not be shown, the first one is; it is among arrangements() as `keptAs`.
    void arrangementUnread(Perspective perspective, ArrangementFault fault, const QString& keptAs);
    void stopRequested(); ///< by the small STOP that every floating dock carries

private:
    void addPanel(const PanelSpec& spec, Workbench& bench);
    bool hasRightNeighbour(const PanelSpec& spec) const;
    void arrange(Perspective perspective);
    bool restoreKept();
    ads::CDockAreaWidget* areaOf(PanelArea area) const; ///< null while all its panels are closed
    std::optional<int> firstLength(const QWidget& part, Qt::Orientation orientation) const;
    void shareSpace();
    void addStop(ads::CFloatingDockContainer& window);
    void growCentre();
    void keepFocus(QWidget* before);
    void focusCentre();
    static void focusFirst(QWidget& content);
    void watchTabs(ads::CDockAreaWidget* area);

    std::vector<PanelSpec> m_specs;
    ads::CDockManager* m_manager = nullptr;
    bool m_hadFocus = false; ///< the area whose tab is being changed
    QHash<QString, ads::CDockWidget*> m_docks;
    QHash<QString, QByteArray> m_arrangements;
    QByteArray m_first; ///< every panel at its first place
    Perspective m_perspective = Perspective::Monitor;
};

} // namespace halbench::app
