#pragma once

#include "widgets/live_plot/history_curve.h"

#include <array>

namespace halbench::app {

/// Places of curves' looks as files say them: a colour, counted from 1, and the name of a line.
constexpr int LookColours = widgets::CurveColours;
constexpr std::array<const char*, widgets::LinePatterns> LookLines{"solid", "dash", "dot", "dash-dot"};

inline int colourOfLook(int place) {
    return place % widgets::CurveColours + 1;
}

inline const char* lineOfLook(int place) {
    return LookLines[static_cast<std::size_t>(widgets::patternAt(place))];
}

/// `line`: the position among LookLines.
inline int placeOfLook(int colour, int line) {
    return widgets::placeWith(colour - 1, static_cast<widgets::LinePattern>(line));
}

} // namespace halbench::app
