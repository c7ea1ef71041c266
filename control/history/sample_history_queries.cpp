#include "control/history/sample_history.h"

#include <algorithm>
#include <cmath>

namespace halbench::control {
namespace {

/// A lookup farther away than this many periods would show a value of another moment.
constexpr double NearPeriods = 1.5;

} // namespace

SampleHistory::Glance::Glance(const SampleHistory& history) : m_pages(history.m_pages) {
    m_isOutermost = m_pages != nullptr && !m_pages->isGlancing();
    if (m_isOutermost) {
        m_pages->beginGlance();
    }
}

SampleHistory::Glance::~Glance() {
    if (m_isOutermost) {
        m_pages->endGlance();
    }
}

std::optional<TimeRange> SampleHistory::range(const std::string& signal) const {
    const auto places = m_places.find(signal);
    if (places == m_places.end() || places->second.empty()) {
        return std::nullopt;
    }
    const SampleTrack& first = m_streams.at(places->second.front().stream).track;
    const SampleTrack& last = m_streams.at(places->second.back().stream).track;
    return TimeRange{first.begin_s(), last.time_s(last.endRow() - 1)};
}

std::optional<TimedValue> SampleHistory::latest(const std::string& signal) const {
    const auto places = m_places.find(signal);
    if (places == m_places.end() || places->second.empty()) {
        return std::nullopt;
    }
    const Place& place = places->second.back();
    const SampleTrack& track = m_streams.at(place.stream).track;
    const std::uint64_t row = track.endRow() - 1;
    return TimedValue{track.time_s(row), track.value(place.column, row)};
}

std::optional<TimedValue> SampleHistory::valueAt(const std::string& signal, double time_s) const {
    const auto places = m_places.find(signal);
    if (places == m_places.end()) {
        return std::nullopt;
    }
    std::optional<TimedValue> nearest;
    for (const Place& place : places->second) {
        const Stream& stream = m_streams.at(place.stream);
        const SampleTrack& track = stream.track;
        const std::uint64_t after = track.rowAt(time_s);
        for (std::uint64_t row = after > track.firstRow() ? after - 1 : after;
             row < std::min(after + 1, track.endRow()); ++row) {
            const double distance_s = std::abs(track.time_s(row) - time_s);
            const bool isNear = stream.period_s <= 0.0 || distance_s <= NearPeriods * stream.period_s;
            if (isNear && (!nearest || distance_s < std::abs(nearest->time_s - time_s))) {
                nearest = TimedValue{track.time_s(row), track.value(place.column, row)};
            }
        }
    }
    return nearest && std::isnan(nearest->value) ? std::nullopt : nearest;
}

Extremes SampleHistory::extremes(const std::string& signal, TimeRange range) const {
    Extremes result;
    const auto places = m_places.find(signal);
    if (places == m_places.end()) {
        return result;
    }
    for (const Place& place : places->second) {
        const SampleTrack& track = m_streams.at(place.stream).track;
        const double afterEnd_s = std::nextafter(range.end_s, std::numeric_limits<double>::infinity());
        result.add(track.extremes(place.column, track.rowAt(range.begin_s), track.rowAt(afterEnd_s)));
    }
    return result;
}

SampleStatistics SampleHistory::statistics(const std::string& signal, TimeRange range) const {
    SampleStatistics result;
    result.extremes = extremes(signal, range);
    const auto places = m_places.find(signal);
    if (places == m_places.end()) {
        return result;
    }
    for (const Place& place : places->second) {
        const SampleTrack& track = m_streams.at(place.stream).track;
        const std::uint64_t begin = track.rowAt(range.begin_s);
        const std::uint64_t end =
            track.rowAt(std::nextafter(range.end_s, std::numeric_limits<double>::infinity()));
        if (begin >= end) {
            continue;
        }
        const bool isFurther = result.moments.count() + result.moments.missing() > 0;
        result.moments.add(track.moments(place.column, begin, end));
        // A gap before the first row lies outside; one stream does not go on in the next.
        result.gaps += track.gaps(begin + 1, end) + (isFurther ? 1 : 0);
    }
    return result;
}

std::size_t SampleHistory::rowsIn(const std::string& signal, TimeRange range) const {
    std::size_t rows = 0;
    if (const auto places = m_places.find(signal); places != m_places.end()) {
        for (const Place& place : places->second) {
            const SampleTrack& track = m_streams.at(place.stream).track;
            const std::uint64_t begin = track.rowAt(range.begin_s);
            rows += static_cast<std::size_t>(std::max(track.rowAt(range.end_s), begin) - begin);
        }
    }
    return rows;
}

bool SampleHistory::samples(const std::string& signal, TimeRange range,
                            std::vector<TimedValue>& result) const {
    result.clear();
    const auto places = m_places.find(signal);
    if (places == m_places.end()) {
        return true;
    }
    bool areAll = true;
    for (const Place& place : places->second) {
        const SampleTrack& track = m_streams.at(place.stream).track;
        std::uint64_t row = track.rowAt(range.begin_s);
        row = row > track.firstRow() ? row - 1 : row;
        const std::uint64_t end = std::min(track.rowAt(range.end_s) + 1, track.endRow());
        areAll = track.areAtHand(place.column, std::min(row, end), end) && areAll;
        bool isFirst = true;
        for (bool isBeyond = false; row < track.endRow() && !isBeyond; ++row) {
            const double time_s = track.time_s(row);
            isBeyond = time_s > range.end_s;
            result.push_back({time_s, track.value(place.column, row), isFirst || track.hasGap(row, row + 1)});
            isFirst = false;
        }
    }
    return areAll;
}

} // namespace halbench::control
