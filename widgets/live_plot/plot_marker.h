#pragma once

#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace halbench::widgets {

/// A moment with a note, dropped by key.
struct PlotMarker {
    double time_s = 0.0;
    QString text;
    bool operator==(const PlotMarker&) const = default;
};

/// Their places in the list, the earliest first.
std::vector<std::size_t> inTime(const std::vector<PlotMarker>& markers);

/// The nearest one that is at most so far away.
std::optional<std::size_t> nearestMarker(const std::vector<PlotMarker>& markers, double time_s,
                                         double reach_s);

/// The one `by` places on from that one, in a circle by time; from none: the first or the last. None: there
/// are no markers.
std::optional<std::size_t> markerBeside(const std::vector<PlotMarker>& markers,
                                        std::optional<std::size_t> from, int by);

/// "3", the next number that is no marker's note: what one is called that nobody named.
QString freeMarkerNumber(const std::vector<PlotMarker>& markers);

/// "12.345 s  knock": in a list, with as many decimals as tell neighbours apart on an axis this long.
QString markerWords(const PlotMarker& marker, double span_s);

} // namespace halbench::widgets
