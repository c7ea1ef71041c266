#include "widgets/live_plot/signal_colours.h"

#include <set>

namespace halbench::widgets {
namespace {

int lowestFree(const std::set<int>& taken) {
    int place = 0;
    while (taken.count(place) > 0) {
        ++place;
    }
    return place;
}

} // namespace

void SignalColours::update(const std::vector<PlotSpec>& plots, const CurveLooks& looks) {
    std::map<std::string, int> shown;
    std::set<int> taken;
    std::vector<std::string> arrived;
    for (const PlotSpec& plot : plots) {
        for (const PlotCurve& curve : plot.curves) {
            const auto look = looks.find(curve.signal);
            if (look != looks.end() && look->second.place) {
                shown[curve.signal] = *look->second.place;
                taken.insert(*look->second.place);
            } else if (const auto kept = m_shown.find(curve.signal); kept != m_shown.end()) {
                shown.insert(*kept);
                taken.insert(kept->second);
            } else {
                arrived.push_back(curve.signal);
            }
        }
    }
    for (const std::string& signal : arrived) {
        const auto before = m_places.find(signal);
        const bool isFree = before != m_places.end() && taken.count(before->second) == 0;
        const auto [entry, isNew] = shown.emplace(signal, isFree ? before->second : lowestFree(taken));
        if (isNew) {
            taken.insert(entry->second);
            m_places[signal] = entry->second;
        }
    }
    m_shown = std::move(shown);
}

int SignalColours::placeOf(const std::string& signal, int otherwise) const {
    const auto found = m_shown.find(signal);
    return found == m_shown.end() ? otherwise : found->second;
}

} // namespace halbench::widgets
