#pragma once

#include <QString>

#include <map>
#include <optional>
#include <string>

namespace halbench::widgets {

/// How the user wants the curves of one signal to look, in all plots of a stack.
struct CurveLook {
    std::optional<int> place = {}; ///< 0 ... 31, eight colours in each of four patterns; none: automatic
    QString name = {};             ///< empty: the one of the signal

    bool operator==(const CurveLook&) const = default;
};

/// By the signal's name in the history.
using CurveLooks = std::map<std::string, CurveLook>;

} // namespace halbench::widgets
