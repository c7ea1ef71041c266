#include "app/window/docks/dock_moves.h"

#include <QApplication>
#include <QPointer>
#include <QScreen>
#include <QSplitter>
#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockContainerWidget.h>
#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockWidget.h>
#include <qtadvanceddocking/FloatingDockContainer.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace halbench::app {

namespace {

/// Of a key press: small enough to aim with, large enough to be seen.
constexpr int Step_px = 32;

/// The focus goes along with its panel: what is taken out of a window loses it.
class KeptFocus {
public:
    explicit KeptFocus(ads::CDockWidget& dock)
        : m_dock(dock),
          m_focus(dock.isAncestorOf(QApplication::focusWidget()) ? QApplication::focusWidget() : nullptr) {}
    ~KeptFocus() {
        m_dock.setAsCurrentTab();
        if (m_focus != nullptr) {
            m_focus->window()->activateWindow();
            m_focus->setFocus(Qt::OtherFocusReason);
        }
    }
    KeptFocus(const KeptFocus&) = delete;
    KeptFocus& operator=(const KeptFocus&) = delete;

private:
    ads::CDockWidget& m_dock;
    QPointer<QWidget> m_focus;
};

bool isAcross(Side side) {
    return side == Side::Left || side == Side::Right;
}

ads::DockWidgetArea edgeOf(Side side) {
    switch (side) {
    case Side::Left:
        return ads::LeftDockWidgetArea;
    case Side::Right:
        return ads::RightDockWidgetArea;
    case Side::Up:
        return ads::TopDockWidgetArea;
    case Side::Down:
        break;
    }
    return ads::BottomDockWidgetArea;
}

QRect placeIn(const QWidget& widget, const QWidget& container) {
    return {widget.mapTo(&container, QPoint()), widget.size()};
}

/// How far the other lies beyond this side; nothing when it does not or is not level with it.
std::optional<int> distance(const QRect& from, const QRect& to, Side side) {
    const bool isLevel = isAcross(side) ? from.top() <= to.bottom() && to.top() <= from.bottom()
                                        : from.left() <= to.right() && to.left() <= from.right();
    int beyond_px = 0;
    switch (side) {
    case Side::Left:
        beyond_px = from.left() - to.right();
        break;
    case Side::Right:
        beyond_px = to.left() - from.right();
        break;
    case Side::Up:
        beyond_px = from.top() - to.bottom();
        break;
    case Side::Down:
        beyond_px = to.top() - from.bottom();
        break;
    }
    return isLevel && beyond_px > 0 ? std::optional<int>(beyond_px) : std::nullopt;
}

/// How much of their sides lies opposite each other.
int shared(const QRect& from, const QRect& to, Side side) {
    return isAcross(side) ? std::min(from.bottom(), to.bottom()) - std::max(from.top(), to.top())
                          : std::min(from.right(), to.right()) - std::max(from.left(), to.left());
}

/// The nearest area on that side; of several as near the one that lies opposite most of it.
ads::CDockAreaWidget* neighbour(const ads::CDockAreaWidget& area, Side side) {
    const ads::CDockContainerWidget& container = *area.dockContainer();
    const QRect from = placeIn(area, container);
    ads::CDockAreaWidget* best = nullptr;
    int nearest_px = std::numeric_limits<int>::max();
    for (ads::CDockAreaWidget* other : container.openedDockAreas()) {
        const QRect to = placeIn(*other, container);
        const std::optional<int> away_px = distance(from, to, side);
        const bool isNearer = away_px && *away_px < nearest_px;
        const bool isAsNear = away_px && *away_px == nearest_px;
        if (isNearer ||
            (isAsNear && shared(from, to, side) > shared(from, placeIn(*best, container), side))) {
            best = other;
            nearest_px = *away_px;
        }
    }
    return best;
}

/// All of that edge is its own already.
bool fillsEdge(const ads::CDockAreaWidget& area, Side side) {
    const QWidget& container = *area.dockContainer();
    const QSize whole = container.size();
    const QSize own = area.size();
    const bool isWhole =
        isAcross(side) ? own.height() >= whole.height() - Step_px : own.width() >= whole.width() - Step_px;
    return isWhole && area.openDockWidgetsCount() == 1;
}

void moveWindow(QWidget& window, const QPoint& step_px) {
    const QRect room = window.screen()->availableGeometry();
    const QPoint to = window.pos() + step_px;
    window.move(std::clamp(to.x(), room.left(), std::max(room.left(), room.right() + 1 - window.width())),
                std::clamp(to.y(), room.top(), std::max(room.top(), room.bottom() + 1 - window.height())));
}

QPoint stepOf(Side side) {
    return {side == Side::Left    ? -Step_px
            : side == Side::Right ? Step_px
                                  : 0,
            side == Side::Up     ? -Step_px
            : side == Side::Down ? Step_px
                                 : 0};
}

/// Gives the part so much more, from the part after it or else from the one before. Whether it could.
bool grow(QSplitter& splitter, int part, int more_px) {
    QList<int> sizes = splitter.sizes();
    const auto isThere = [&](int i) {
        return i >= 0 && i < splitter.count() && !splitter.widget(i)->isHidden();
    };
    for (const int direction : {1, -1}) {
        int other = part + direction;
        while (other >= 0 && other < splitter.count() && !isThere(other)) {
            other += direction;
        }
        if (!isThere(other)) {
            continue;
        }
        QList<int> wished = sizes;
        wished[part] += more_px;
        wished[other] -= more_px;
        splitter.setSizes(wished);
        if (splitter.sizes()[part] != sizes[part]) {
            return true;
        }
        splitter.setSizes(sizes);
    }
    return false;
}

QList<QList<int>> sizesAround(const QWidget& area) {
    QList<QList<int>> sizes;
    for (const QWidget* above = area.parentWidget(); above != nullptr; above = above->parentWidget()) {
        if (const auto* splitter = qobject_cast<const QSplitter*>(above)) {
            sizes << splitter->sizes();
        }
    }
    return sizes;
}

/// As far as they have as many parts as they had then.
void setSizesAround(const QWidget& area, QList<QList<int>> sizes) {
    for (QWidget* above = area.parentWidget(); above != nullptr && !sizes.isEmpty();
         above = above->parentWidget()) {
        if (auto* splitter = qobject_cast<QSplitter*>(above)) {
            const QList<int> known = sizes.takeFirst();
            if (known.size() == splitter->count()) {
                splitter->setSizes(known);
            }
        }
    }
}

QStringList openIn(const ads::CDockAreaWidget& area) {
    QStringList ids;
    for (const ads::CDockWidget* dock : area.openedDockWidgets()) {
        ids << dock->objectName();
    }
    return ids;
}

} // namespace

void DockMoves::toggleFloating(ads::CDockWidget& dock, const QStringList& home,
                               ads::DockWidgetArea homeEdge) {
    const KeptFocus focus(dock);
    if (dock.isInFloatingContainer()) {
        dockBack(dock, home, homeEdge);
    } else {
        m_places[dock.objectName()] = placeOf(*dock.dockAreaWidget(), dock);
        dock.setFloating();
    }
}

DockMoves::Place DockMoves::placeOf(ads::CDockAreaWidget& area, const ads::CDockWidget& dock) const {
    Place place;
    place.behind = openIn(area);
    place.behind.removeAll(dock.objectName());
    auto* splitter = qobject_cast<QSplitter*>(area.parentWidget());
    if (splitter == nullptr) {
        return place;
    }
    place.sizes = sizesAround(area);
    const bool isAcross = splitter->orientation() == Qt::Horizontal;
    const int at = splitter->indexOf(&area);
    for (const int direction : {1, -1}) {
        const QWidget* next = splitter->widget(at + direction);
        if (next == nullptr || next->isHidden() || !place.beside.isEmpty()) {
            continue;
        }
        const auto* whole = qobject_cast<const ads::CDockAreaWidget*>(next);
        place.beside = whole != nullptr ? openIn(*whole) : QStringList();
        place.side = direction > 0 ? (isAcross ? ads::LeftDockWidgetArea : ads::TopDockWidgetArea)
                                   : (isAcross ? ads::RightDockWidgetArea : ads::BottomDockWidgetArea);
    }
    return place;
}

ads::CDockAreaWidget* DockMoves::areaOfAny(const QStringList& ids) const {
    for (const QString& id : ids) {
        const ads::CDockWidget* dock = m_manager.findDockWidget(id);
        if (dock != nullptr && !dock->isClosed() && !dock->isInFloatingContainer()) {
            return dock->dockAreaWidget();
        }
    }
    return nullptr;
}

void DockMoves::dockBack(ads::CDockWidget& dock, const QStringList& home, ads::DockWidgetArea homeEdge) {
    const Place place = m_places.take(dock.objectName());
    if (ads::CDockAreaWidget* behind = areaOfAny(place.behind)) {
        m_manager.addDockWidgetTabToArea(&dock, behind);
        return;
    }
    ads::CDockAreaWidget* beside = areaOfAny(place.beside);
    if (beside != nullptr || place.side != ads::InvalidDockWidgetArea) {
        ads::CDockAreaWidget* area = m_manager.addDockWidget(place.side, &dock, beside);
        setSizesAround(*area, place.sizes);
        return;
    }
    if (ads::CDockAreaWidget* first = areaOfAny(home)) {
        m_manager.addDockWidgetTabToArea(&dock, first);
    } else {
        m_manager.addDockWidget(homeEdge, &dock);
    }
}

void DockMoves::move(ads::CDockWidget& dock, Side side) {
    if (dock.isInFloatingContainer()) {
        return moveWindow(*dock.floatingDockContainer(), stepOf(side));
    }
    ads::CDockAreaWidget& area = *dock.dockAreaWidget();
    const KeptFocus focus(dock);
    if (ads::CDockAreaWidget* next = neighbour(area, side)) {
        m_manager.addDockWidgetTabToArea(&dock, next);
    } else if (!fillsEdge(area, side)) {
        m_manager.addDockWidget(edgeOf(side), &dock);
    }
}

void DockMoves::resize(ads::CDockWidget& dock, Side side) {
    const QPoint step_px = stepOf(side);
    if (dock.isInFloatingContainer()) {
        QWidget& window = *dock.floatingDockContainer();
        const QSize wished = window.size() + QSize(step_px.x(), step_px.y());
        window.resize(
            wished.boundedTo(window.screen()->availableGeometry().size().expandedTo(window.size())));
        return;
    }
    QWidget* part = dock.dockAreaWidget();
    for (QWidget* above = part->parentWidget(); above != nullptr;
         part = above, above = part->parentWidget()) {
        auto* splitter = qobject_cast<QSplitter*>(above);
        const bool isThisWay =
            splitter != nullptr && (splitter->orientation() == Qt::Horizontal) == isAcross(side);
        if (isThisWay && grow(*splitter, splitter->indexOf(part), step_px.x() + step_px.y())) {
            return;
        }
    }
}

} // namespace halbench::app
