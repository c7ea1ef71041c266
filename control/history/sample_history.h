#pragma once

#include "control/base/page_store.h"
#include "control/base/sample_block.h"
#include "control/history/sample_track.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace halbench::control {

struct TimeRange {
    double begin_s = 0.0;
    double end_s = 0.0;

    double length_s() const { return end_s - begin_s; }
    bool operator==(const TimeRange&) const = default;
};

struct TimedValue {
    double time_s = 0.0;
    double value = 0.0; ///< NaN where the device gave none
    bool isAfterGap = false;
};

/// What one pixel column shows of a signal.
struct HistoryColumn {
    Extremes extremes;       ///< empty where the signal has no value
    bool isAfterGap = false; ///< the line from the column before is interrupted
};

class SampleHistory;

/// The columns of a view that goes on with its data, with what tells which of them a next look need not
/// compute again. One for each curve; only SampleHistory writes it.
struct KeptColumns {
    /// Where the columns came from, one for each stream that has the signal.
    struct Source {
        std::size_t stream = 0;
        std::size_t column = 0;
        std::uint64_t firstRow = 0; ///< that the stream held
        std::uint64_t endRow = 0;
        std::uint64_t snap = 1;          ///< rows to which the edges are rounded
        double last_s = 0.0;             ///< time of the last row
        std::vector<std::uint64_t> rows; ///< at the edges of the columns
    };

    std::vector<HistoryColumn> columns;     ///< the answer
    const SampleHistory* history = nullptr; ///< none: nothing may be kept
    std::string signal;
    TimeRange range;
    std::vector<Source> sources;

    /// Forgets the first columns.
    void skip(std::size_t count);
};

/// What a signal did in a stretch of time.
struct SampleStatistics {
    Extremes extremes;
    Moments moments;
    std::size_t gaps = 0; ///< places where its line is interrupted by missing rows
};

/// The past of all signals for showing it: bounded in memory, oldest rows go first, and any stretch of it is
/// asked for in time proportional to the pixels, not to the samples. With a store the oldest rows go there
/// before memory is full, and are read back where somebody looks closely; what the store has no room for, or
/// fails to keep, is dropped from the oldest on. Blocks of different layouts (other
/// signals, another rate) may follow each other; a signal keeps its name. Each such change, lost rows and a
/// jump of the device's clock are gaps; a value that is not finite is a break.
///
/// Time is the device's. Where its clock starts again (a new stream counts from zero), the rows continue
/// after the newest ones, as much later as the host saw them arrive, so that time never runs back.
///
/// Belongs to one thread, normally that of the window: devices/acquisition/display_inbox.h brings the blocks
/// there.
class SampleHistory {
public:
    explicit SampleHistory(std::size_t budget_bytes);
    ~SampleHistory();
    SampleHistory(SampleHistory&&) = default;
    SampleHistory& operator=(SampleHistory&&) = default;

    /// Where the oldest rows go from now on; nullptr: nowhere. Forgets everything.
    void setStore(std::shared_ptr<PageStore> store);
    /// `columns`: what is written for it beside its own values.
    void append(const SampleBlock& block, const BlockColumns& columns = {});
    void clear();
    /// The samples of one signal go, e.g. because its name now means something else; the others stay.
    void forget(const std::string& signal);

    /// Rises with every change; a view that has drawn this revision need not draw again.
    std::uint64_t revision() const { return m_revision; }
    std::size_t bytes() const;
    std::size_t budget_bytes() const { return m_budget_bytes; }
    /// Rows that are only in the store, times their columns and the time column, in bytes.
    std::uint64_t pagedBytes() const;
    /// What was asked of the store and could not be read back.
    std::uint64_t damagedParts() const { return m_pages ? m_pages->damagedParts() : 0; }
    /// Takes over what the store did meanwhile, as append() does, and what a glance asked for.
    void settle();
    /// Whether rows came faster than the store takes them: somebody who can wait should.
    bool isBusy() const;
    /// Rows said to be lost by the blocks.
    std::uint64_t lostRows() const { return m_lostRows; }

    /// Names in the order in which they first came.
    const std::vector<std::string>& signals() const { return m_names; }
    bool contains(const std::string& signal) const { return m_places.count(signal) > 0; }
    /// SI unit symbol as the stream gave it; empty when the signal is unknown.
    std::string unit(const std::string& signal) const;

    /// From the oldest to the newest row held; nothing when there is none.
    std::optional<TimeRange> range() const;
    std::optional<TimeRange> range(const std::string& signal) const;
    std::optional<TimedValue> latest(const std::string& signal) const;
    /// The sample nearest to a time; nothing farther away than one and a half sampling periods, nor NaN.
    std::optional<TimedValue> valueAt(const std::string& signal, double time_s) const;
    /// Extremes of a stretch of time, both ends included. O(log rows).
    Extremes extremes(const std::string& signal, TimeRange range) const;

    /// Of a stretch of time, both ends included: a step for every 4096 rows.
    SampleStatistics statistics(const std::string& signal, TimeRange range) const;

    /// Rows of the signal in a stretch of time: what decides between samples() and columns().
    std::size_t rowsIn(const std::string& signal, TimeRange range) const;
    /// The samples in a stretch of time and one beyond each of its ends, so that lines reach the frame.
    /// False, and some have no value: in a glance they were not at hand.
    bool samples(const std::string& signal, TimeRange range, std::vector<TimedValue>& result) const;
    /// `count` equal columns of the stretch. A sample may be counted one eighth of a column off; none is
    /// lost.
    void columns(const std::string& signal, TimeRange range, std::size_t count,
                 std::vector<HistoryColumn>& result) const;
    /// The same for a view that is asked for frame by frame. When it has gone on by whole columns, only those
    /// are computed that new rows may have changed: the cost is that of the news, not of the view.
    void columns(const std::string& signal, TimeRange range, std::size_t count, KeptColumns& kept) const;

    class Glance;

private:
    struct Stream {
        std::shared_ptr<const StreamLayout> layout;
        SampleTrack track;
        double offset_s = 0.0; ///< of the history's time from the device's
        double period_s = 0.0;
    };
    struct Place {
        std::size_t stream;
        std::size_t column;
    };
    struct Edges { ///< rows at the column edges of the last question, which all signals of a stream share
        std::size_t stream = 0;
        std::uint64_t endRow = 0;
        TimeRange range;
        bool isExact = true; ///< from the times themselves, not from those between the marks (Glance)
        std::uint64_t snap = 1;
        std::vector<std::uint64_t> rows;
    };

    Stream& streamFor(const std::shared_ptr<const StreamLayout>& layout, bool& isRestart);
    void registerColumns(const StreamLayout& layout, std::size_t stream);
    double offsetFor(const SampleBlock& block, double period_s) const;
    void addRows(Stream& stream, std::span<const ColumnSource> columns, bool isAfterGap);
    void keepBudget();
    void putOldest();
    bool dropOldest(bool isPagedOnly);
    std::size_t pagedMemory() const;
    const std::vector<std::uint64_t>& edges(std::size_t stream, TimeRange range, std::size_t count) const;
    std::size_t stillTrue(const std::vector<Place>& places, TimeRange range, const KeptColumns& kept) const;
    void addColumns(const Place& place, const std::vector<std::uint64_t>& rows, std::size_t from,
                    std::vector<HistoryColumn>& result) const;

    std::size_t m_budget_bytes;
    std::shared_ptr<PageCache> m_pages; ///< outlives the chunks in the streams
    std::uint64_t m_revision = 0;
    std::uint64_t m_lostRows = 0;
    double m_hostArrival_s = 0.0;
    std::vector<std::string> m_names;
    std::map<std::string, std::vector<Place>> m_places;
    std::map<std::size_t, Stream> m_streams; ///< by number, in the order of time
    std::size_t m_nextStream = 0;
    std::vector<double> m_time_s; ///< of the rows that are being added
    mutable Edges m_edges;
};

/// While one lives, no question to the history waits for the disk: what is not in memory is asked for, and
/// answered by more than there is (columns, extremes: the groups of 256 rows) or not at all (values). Once it
/// has come, revision() rises with the next settle(). For drawing; numbers that are told need isWhole().
class SampleHistory::Glance {
public:
    explicit Glance(const SampleHistory& history);
    ~Glance();
    Glance(const Glance&) = delete;
    Glance& operator=(const Glance&) = delete;

    /// Whether all answers so far are exact.
    bool isWhole() const { return m_pages == nullptr || m_pages->isGlanceWhole(); }

private:
    std::shared_ptr<PageCache> m_pages; ///< none: all is in memory
    bool m_isOutermost = false;
};

} // namespace halbench::control
