#include "control/history/sample_history.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace halbench::control {
namespace {

/// A step of time this many periods long is a gap even when nobody counted lost rows.
constexpr double GapPeriods = 2.5;

bool isSameStream(const StreamLayout& left, const StreamLayout& right) {
    return left.period_s == right.period_s &&
           std::equal(left.columns.begin(), left.columns.end(), right.columns.begin(), right.columns.end(),
                      [](const auto& a, const auto& b) { return a.name == b.name && a.unit == b.unit; });
}

} // namespace

SampleHistory::SampleHistory(std::size_t budget_bytes) : m_budget_bytes(budget_bytes) {}

SampleHistory::~SampleHistory() = default;

void SampleHistory::clear() {
    m_names.clear();
    m_places.clear();
    m_streams.clear();
    if (m_pages) {
        m_pages->clear();
    }
    m_edges = {};
    m_lostRows = 0;
    m_hostArrival_s = 0.0;
    ++m_revision;
}

/// Its column loses its name, so that rows which come under it from now on begin another stream.
void SampleHistory::forget(const std::string& signal) {
    const auto places = m_places.find(signal);
    if (places == m_places.end()) {
        return;
    }
    for (const Place& place : places->second) {
        std::shared_ptr<const StreamLayout>& layout = m_streams.at(place.stream).layout;
        auto nameless = std::make_shared<StreamLayout>(*layout);
        nameless->columns[place.column].name.clear();
        layout = std::move(nameless);
    }
    m_places.erase(places);
    std::erase(m_names, signal);
    ++m_revision;
}

void SampleHistory::append(const SampleBlock& block, const BlockColumns& columns) {
    m_lostRows += block.lostRows;
    if (block.layout == nullptr || block.layout->columns.empty() || block.rows() == 0) {
        return;
    }
    m_time_s.resize(block.rows());
    std::transform(block.time_s.begin(), block.time_s.end(), m_time_s.begin(),
                   [&](double time_s) { return time_s + columns.shift_s; });
    bool isRestart = false;
    Stream& stream = streamFor(columns.layout ? columns.layout : block.layout, isRestart);
    if (isRestart) {
        stream.offset_s = offsetFor(block, stream.period_s);
    }
    addRows(stream, columns.sources(block), isRestart || block.lostRows > 0 || block.isBreak);
    m_hostArrival_s = block.hostArrival_s;
    keepBudget();
    ++m_revision;
}

/// Of the rows in m_time_s.
SampleHistory::Stream& SampleHistory::streamFor(const std::shared_ptr<const StreamLayout>& layout,
                                                bool& isRestart) {
    // Where another stream had its signals in between, rows that go on in an older one would stand before
    // those.
    const auto isNewest = [this](std::size_t number, const StreamLayout& held) {
        return std::all_of(held.columns.begin(), held.columns.end(), [&](const auto& column) {
            const auto places = m_places.find(column.name);
            return places == m_places.end() || places->second.empty() ||
                   places->second.back().stream == number;
        });
    };
    for (auto it = m_streams.rbegin(); it != m_streams.rend(); ++it) {
        Stream& stream = it->second;
        const bool isLast = it == m_streams.rbegin();
        const bool isSame = stream.layout == layout || (isLast && isSameStream(*stream.layout, *layout));
        if (isSame && isNewest(it->first, *stream.layout)) {
            const double newest_s = stream.track.time_s(stream.track.endRow() - 1) - stream.offset_s;
            isRestart = stream.layout != layout || m_time_s.front() <= newest_s;
            stream.layout = layout;
            return stream;
        }
    }
    isRestart = true;
    const std::size_t number = m_nextStream++;
    registerColumns(*layout, number);
    return m_streams
        .emplace(number, Stream{layout, SampleTrack(layout->columns.size()), 0.0, layout->period_s})
        .first->second;
}

void SampleHistory::registerColumns(const StreamLayout& layout, std::size_t stream) {
    for (std::size_t column = 0; column < layout.columns.size(); ++column) {
        const std::string& name = layout.columns[column].name;
        if (std::find(m_names.begin(), m_names.end(), name) == m_names.end()) {
            m_names.push_back(name);
        }
        m_places[name].push_back({stream, column});
    }
}

double SampleHistory::offsetFor(const SampleBlock& block, double period_s) const {
    const auto held = range();
    if (!held || m_time_s.front() > held->end_s) {
        return 0.0; // the clock went on
    }
    const double length_s = m_time_s.back() - m_time_s.front();
    const double waited_s = block.hostArrival_s - m_hostArrival_s - length_s;
    return held->end_s + std::max(period_s, waited_s) - m_time_s.front();
}

/// Those in m_time_s.
void SampleHistory::addRows(Stream& stream, std::span<const ColumnSource> columns, bool isAfterGap) {
    const double longest_s =
        stream.period_s > 0.0 ? GapPeriods * stream.period_s : std::numeric_limits<double>::infinity();
    for (double& time_s : m_time_s) {
        time_s += stream.offset_s;
    }
    const double before_s =
        stream.track.isEmpty() ? m_time_s.front() : stream.track.time_s(stream.track.endRow() - 1);
    if (isAfterGap || m_time_s.front() - before_s > longest_s) {
        stream.track.interrupt();
    }
    std::size_t begin = 0;
    for (std::size_t row = 1; row <= m_time_s.size(); ++row) { // a run for each stretch without a gap
        const bool isEnd = row == m_time_s.size();
        if (isEnd || m_time_s[row] - m_time_s[row - 1] > longest_s) {
            stream.track.add(std::span(m_time_s).subspan(begin, row - begin), columns, begin);
            begin = row;
            if (!isEnd) {
                stream.track.interrupt();
            }
        }
    }
}

std::string SampleHistory::unit(const std::string& signal) const {
    const auto places = m_places.find(signal);
    if (places == m_places.end() || places->second.empty()) {
        return {};
    }
    const Place& place = places->second.back();
    return m_streams.at(place.stream).layout->columns[place.column].unit;
}

std::optional<TimeRange> SampleHistory::range() const {
    std::optional<TimeRange> result;
    for (const auto& [number, stream] : m_streams) {
        if (stream.track.isEmpty()) {
            continue; // just made, its first block is being added
        }
        const double begin_s = stream.track.begin_s();
        const double end_s = stream.track.time_s(stream.track.endRow() - 1);
        result = result ? TimeRange{std::min(result->begin_s, begin_s), std::max(result->end_s, end_s)}
                        : TimeRange{begin_s, end_s};
    }
    return result;
}

} // namespace halbench::control
