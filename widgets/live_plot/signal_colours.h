#pragma once

#include "widgets/live_plot/curve_look.h"
#include "widgets/live_plot/live_plot_spec.h"

#include <map>
#include <string>
#include <vector>

namespace halbench::widgets {

/// One colour and line pattern for each signal over all plots of a stack: its place 0 ... 31, eight colours
/// in each of four patterns. A signal gets the lowest place that no shown signal has, keeps it while it is
/// shown, and gets it back when it returns and the place is still free.
class SignalColours {
public:
    /// A place that the user chose is the signal's, whatever others have; none of the others takes it anew.
    void update(const std::vector<PlotSpec>& plots, const CurveLooks& looks = {});
    /// Nothing is known of the signal: `otherwise`.
    int placeOf(const std::string& signal, int otherwise) const;

private:
    std::map<std::string, int> m_places; ///< of the signals shown now and of those that were
    std::map<std::string, int> m_shown;
};

} // namespace halbench::widgets
