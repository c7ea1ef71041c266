#pragma once

#include <QHash>
#include <QStringList>
#include <qtadvanceddocking/ads_globals.h>

class QSplitter;

namespace ads {
class CDockAreaWidget;
class CDockManager;
class CDockWidget;
} // namespace ads

namespace halbench::app {

enum class Side { Left, Right, Up, Down };

/// What the mouse does with a panel by dragging, in steps: floats it and docks it where it was, moves it into
/// the next area, makes it wider or taller. The focus stays where it was in the panel. Thread: GUI.
class DockMoves {
public:
    explicit DockMoves(ads::CDockManager& manager) : m_manager(manager) {}

    /// Afloat, or back beside the panels it left; without those it goes beside `home`, the panels of its
    /// first place, and without those to the edge `homeEdge`.
    void toggleFloating(ads::CDockWidget& dock, const QStringList& home, ads::DockWidgetArea homeEdge);
    /// Behind the next area on that side as its tab in front; where none is, along that edge of the window. A
    /// panel afloat: its window goes a step.
    void move(ads::CDockWidget& dock, Side side);
    /// Right: wider, Left: narrower, Down: taller, Up: shorter; the part beside it gives or takes the room.
    void resize(ads::CDockWidget& dock, Side side);

private:
    /// Where a panel was docked.
    struct Place {
        QStringList behind;                                    ///< panels of the same area
        QStringList beside;                                    ///< of the area next to it
        ads::DockWidgetArea side = ads::InvalidDockWidgetArea; ///< of those
        QList<QList<int>> sizes; ///< of the splitters around it, inner ones first
    };

    Place placeOf(ads::CDockAreaWidget& area, const ads::CDockWidget& dock) const;
    void dockBack(ads::CDockWidget& dock, const QStringList& home, ads::DockWidgetArea homeEdge);
    ads::CDockAreaWidget* areaOfAny(const QStringList& ids) const;

    ads::CDockManager& m_manager;
    QHash<QString, Place> m_places; ///< of panels afloat
};

} // namespace halbench::app
