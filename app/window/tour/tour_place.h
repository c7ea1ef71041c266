#pragma once

#include <QRect>

namespace halbench::app {

/// Place of the tour's card in `room`: below `target` where there is room, else the corner where it covers
/// least of it, the lower left one where several do. Never over `stop`: a corner that would be is left out,
/// and the card moved clear of it in a room too small for another. Everything in the same coordinates.
QRect cardPlace(const QRect& room, const QRect& target, const QRect& stop, const QSize& card);

} // namespace halbench::app
