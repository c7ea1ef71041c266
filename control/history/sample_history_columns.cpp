// What the columns of a view show of the history.
#include "control/history/sample_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halbench::control {
namespace {

/// A view that moved by a whole number of columns up to this much shows the columns it had.
constexpr double SameColumn_ratio = 1e-6;

/// Largest group of the pyramid that is at most an eighth of a column.
std::uint64_t snapFor(std::uint64_t rows, std::size_t columns) {
    std::uint64_t snap = 1;
    while (4 * snap * 8 * columns <= rows) {
        snap *= 4;
    }
    return snap;
}

/// Columns by which a view has gone on, when all that is still in it lies where it lay.
std::optional<std::size_t> wholeShift(TimeRange before, TimeRange now, std::size_t count) {
    const double step_s = now.length_s() / static_cast<double>(count);
    const double shift = (now.begin_s - before.begin_s) / step_s;
    const double whole = std::round(shift);
    const bool isSameStep = std::abs(now.length_s() - before.length_s()) <= SameColumn_ratio * step_s;
    if (!isSameStep || !(std::abs(shift - whole) <= SameColumn_ratio) || whole < 0.0 ||
        whole >= static_cast<double>(count)) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(whole);
}

/// Whether the line is interrupted before a column, as the columns of the signal before it have it.
bool isGapBefore(const SampleTrack& track, std::size_t column, const std::vector<std::uint64_t>& rows,
                 std::size_t index) {
    while (index > 0 && rows[index - 1] == rows[index]) {
        --index;
    }
    return index == 0 || track.extremes(column, rows[index - 1], rows[index]).isEmpty();
}

/// Nothing comes before the first column of a view.
void interruptFirst(const SampleTrack& track, std::size_t column, const std::vector<std::uint64_t>& rows,
                    std::size_t known, std::vector<HistoryColumn>& result) {
    for (std::size_t i = 0; i < known; ++i) {
        if (rows[i] < rows[i + 1] && !track.extremes(column, rows[i], rows[i + 1]).isEmpty()) {
            result[i].isAfterGap = true;
            return;
        }
    }
}

/// The rows at the first `known` + 1 edges stay: none is lost or counted twice where old and new columns
/// meet.
void takeEdges(const std::vector<std::uint64_t>& edges, std::size_t known, std::vector<std::uint64_t>& rows) {
    rows.resize(edges.size());
    const std::size_t first = known > 0 ? known + 1 : 0;
    std::copy(edges.begin() + static_cast<std::ptrdiff_t>(first), edges.end(),
              rows.begin() + static_cast<std::ptrdiff_t>(first));
    for (std::size_t i = first; known > 0 && i < rows.size() && rows[i] < rows[known]; ++i) {
        rows[i] = rows[known];
    }
}

} // namespace

const std::vector<std::uint64_t>& SampleHistory::edges(std::size_t number, TimeRange range,
                                                       std::size_t count) const {
    const SampleTrack& track = m_streams.at(number).track;
    if (m_edges.isExact && m_edges.stream == number && m_edges.endRow == track.endRow() &&
        m_edges.range == range && m_edges.rows.size() == count + 1) {
        return m_edges.rows;
    }
    m_edges = {number, track.endRow(), range, true, 1, std::move(m_edges.rows)};
    m_edges.rows.resize(count + 1);
    const std::uint64_t first = track.rowAt(range.begin_s);
    m_edges.snap = snapFor(std::max(track.rowAt(range.end_s), first) - first, count);
    std::uint64_t row = first;
    for (std::size_t i = 0; i <= count; ++i) {
        const double time_s =
            range.begin_s + range.length_s() * static_cast<double>(i) / static_cast<double>(count);
        row =
            m_edges.snap >= SampleChunk::MarkRows ? track.markedRowAt(time_s) : track.rowAtFrom(row, time_s);
        m_edges.rows[i] = std::max(row - row % m_edges.snap, track.firstRow());
    }
    m_edges.isExact = !m_pages || !m_pages->isGlancing() || m_pages->isGlanceWhole();
    return m_edges.rows;
}

void SampleHistory::columns(const std::string& signal, TimeRange range, std::size_t count,
                            std::vector<HistoryColumn>& result) const {
    result.assign(count, {});
    if (const auto places = m_places.find(signal); places != m_places.end() && range.length_s() > 0.0) {
        for (const Place& place : places->second) {
            addColumns(place, edges(place.stream, range, count), 0, result);
        }
    }
}

void SampleHistory::columns(const std::string& signal, TimeRange range, std::size_t count,
                            KeptColumns& kept) const {
    const auto places = m_places.find(signal);
    if (places == m_places.end() || !(range.length_s() > 0.0) || count == 0) {
        kept = {};
        kept.columns.resize(count);
        return;
    }
    const bool isSame = kept.history == this && kept.signal == signal && kept.columns.size() == count;
    const auto shift = isSame ? wholeShift(kept.range, range, count) : std::nullopt;
    std::size_t known = shift ? std::min(stillTrue(places->second, range, kept), count - *shift) : 0;
    if (known > 0) {
        kept.skip(*shift);
    }
    std::fill(kept.columns.begin() + static_cast<std::ptrdiff_t>(std::min(known, kept.columns.size())),
              kept.columns.end(), HistoryColumn{});
    kept.columns.resize(count);
    kept.sources.resize(places->second.size());
    for (std::size_t i = 0; i < places->second.size(); ++i) {
        const Place& place = places->second[i];
        const SampleTrack& track = m_streams.at(place.stream).track;
        KeptColumns::Source& source = kept.sources[i];
        takeEdges(edges(place.stream, range, count), known, source.rows);
        interruptFirst(track, place.column, source.rows, known, kept.columns);
        addColumns(place, source.rows, known, kept.columns);
        source = {place.stream,          place.column, track.firstRow(),
                  track.endRow(),        m_edges.snap, track.time_s(track.endRow() - 1),
                  std::move(source.rows)};
    }
    kept.history = m_pages && m_pages->isGlancing() && !m_pages->isGlanceWhole() ? nullptr : this;
    kept.signal = signal;
    kept.range = range;
}

/// How many columns of the view, counted from its first, are what a new look would see.
std::size_t SampleHistory::stillTrue(const std::vector<Place>& places, TimeRange range,
                                     const KeptColumns& kept) const {
    if (places.size() != kept.sources.size()) {
        return 0;
    }
    const std::size_t count = kept.columns.size();
    double end_s = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const KeptColumns::Source& source = kept.sources[i];
        const SampleTrack& track = m_streams.at(places[i].stream).track;
        const bool isSame = places[i].stream == source.stream && places[i].column == source.column &&
                            source.endRow > track.firstRow() && source.endRow <= track.endRow() &&
                            track.time_s(source.endRow - 1) == source.last_s;
        const bool isGone = track.firstRow() != source.firstRow && track.begin_s() > range.begin_s;
        edges(places[i].stream, range, count);
        if (!isSame || isGone || m_edges.snap != source.snap) {
            return 0;
        }
        if (track.endRow() > source.endRow) {
            end_s = std::min(end_s, track.time_s(source.endRow - 1));
        }
    }
    const double step_s = range.length_s() / static_cast<double>(count);
    // One less: the edge behind the last rows was rounded to a group that had not been full.
    const double columns = std::floor((end_s - range.begin_s) / step_s) - 1.0;
    return static_cast<std::size_t>(std::clamp(columns, 0.0, static_cast<double>(count)));
}

void SampleHistory::addColumns(const Place& place, const std::vector<std::uint64_t>& rows, std::size_t from,
                               std::vector<HistoryColumn>& result) const {
    const SampleTrack& track = m_streams.at(place.stream).track;
    bool isAfterGap = isGapBefore(track, place.column, rows, from);
    for (std::size_t i = from; i < result.size(); ++i) {
        if (rows[i] == rows[i + 1]) {
            continue;
        }
        const Extremes extremes = track.extremes(place.column, rows[i], rows[i + 1]);
        isAfterGap = isAfterGap || track.hasGap(rows[i], rows[i + 1]);
        if (!extremes.isEmpty()) {
            result[i].extremes.add(extremes);
            result[i].isAfterGap = result[i].isAfterGap || isAfterGap;
        }
        isAfterGap = extremes.isEmpty();
    }
}

void KeptColumns::skip(std::size_t count) {
    const auto skipped = static_cast<std::ptrdiff_t>(count);
    std::move(columns.begin() + skipped, columns.end(), columns.begin());
    for (Source& source : sources) {
        std::move(source.rows.begin() + skipped, source.rows.end(), source.rows.begin());
    }
}

} // namespace halbench::control
