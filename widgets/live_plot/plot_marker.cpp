#include "widgets/live_plot/plot_marker.h"

#include "widgets/language/display_units.h"
#include "widgets/language/time_decimals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace halbench::widgets {

std::vector<std::size_t> inTime(const std::vector<PlotMarker>& markers) {
    std::vector<std::size_t> order(markers.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
        return markers[one].time_s < markers[other].time_s;
    });
    return order;
}

std::optional<std::size_t> nearestMarker(const std::vector<PlotMarker>& markers, double time_s,
                                         double reach_s) {
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < markers.size(); ++i) {
        const double away_s = std::abs(markers[i].time_s - time_s);
        if (away_s <= reach_s && (!nearest || away_s < std::abs(markers[*nearest].time_s - time_s))) {
            nearest = i;
        }
    }
    return nearest;
}

std::optional<std::size_t> markerBeside(const std::vector<PlotMarker>& markers,
                                        std::optional<std::size_t> from, int by) {
    if (markers.empty()) {
        return std::nullopt;
    }
    const std::vector<std::size_t> order = inTime(markers);
    const auto found = from ? std::find(order.begin(), order.end(), *from) : order.end();
    if (found == order.end()) {
        return by > 0 ? order.front() : order.back();
    }
    const auto count = static_cast<std::ptrdiff_t>(order.size());
    const std::ptrdiff_t place = ((found - order.begin() + by) % count + count) % count;
    return order[static_cast<std::size_t>(place)];
}

QString freeMarkerNumber(const std::vector<PlotMarker>& markers) {
    for (std::size_t number = markers.size() + 1;; ++number) {
        const QString text = QString::number(number);
        const bool isTaken = std::any_of(markers.begin(), markers.end(),
                                         [&](const PlotMarker& marker) { return marker.text == text; });
        if (!isTaken) {
            return text;
        }
    }
}

QString markerWords(const PlotMarker& marker, double span_s) {
    return QStringLiteral("%1 s  %2").arg(fixedText(marker.time_s, timeDecimals(span_s, {})), marker.text);
}

} // namespace halbench::widgets
