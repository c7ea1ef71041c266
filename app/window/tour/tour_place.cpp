#include "app/window/tour/tour_place.h"

#include <QSize>

#include <algorithm>
#include <array>
#include <limits>

namespace halbench::app {
namespace {

constexpr int Margin_px = 12;

int area(const QRect& rect) {
    return rect.isEmpty() ? 0 : rect.width() * rect.height();
}

} // namespace

QRect cardPlace(const QRect& room, const QRect& target, const QRect& stop, const QSize& card) {
    const QRect inside = room.marginsRemoved({Margin_px, Margin_px, Margin_px, Margin_px});
    const QSize size = card.boundedTo(room.size());
    const int left = std::max(room.left(), std::min(inside.left(), room.right() + 1 - size.width()));
    const int right = std::max(room.left(), inside.right() + 1 - size.width());
    const int top = std::max(room.top(), std::min(inside.top(), room.bottom() + 1 - size.height()));
    const int bottom = std::max(room.top(), inside.bottom() + 1 - size.height());
    if (!target.isEmpty()) {
        const QRect below({std::clamp(target.left(), left, std::max(left, right)),
                           std::max(target.bottom() + 1 + Margin_px, inside.top())},
                          size);
        if (inside.contains(below) && !below.intersects(stop)) {
            return below;
        }
    }
    const std::array corners{QPoint(left, bottom), QPoint(right, bottom), QPoint(left, top),
                             QPoint(right, top)};
    QRect best(corners.front(), size);
    int least = std::numeric_limits<int>::max();
    for (const QPoint& corner : corners) {
        const QRect place(corner, size);
        const int covered = area(place & target);
        if (!place.intersects(stop) && covered < least) {
            least = covered;
            best = place;
        }
    }
    if (best.intersects(stop)) { // no corner is clear
        best.moveRight(std::min(best.right(), stop.left() - 1));
    }
    return best;
}

} // namespace halbench::app
