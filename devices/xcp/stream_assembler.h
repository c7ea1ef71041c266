#pragma once

#include "control/base/row_grid.h"
#include "control/base/sample_block.h"
#include "devices/xcp/sampling_plan.h"

#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace halbench::devices::xcp {

/// Makes SampleBlocks of the packets of one stream: time axis from the device's clock alone (3.9), lost rows
/// by what the transport counted and by the rows that lie between the stamps (RowGrid), single rows whose
/// time steps back or far ahead dropped. A clock that goes on from elsewhere has started again: a break is
/// marked there, with a gap as long as the host's clock says, as far as it is longer than rows were late
/// anyway.
class StreamAssembler {
public:
    StreamAssembler(SamplingPlan plan, const DaqAbility& ability, DtoDecoder decoder);

    /// The host's time before the board was told to start: no sample is older, however late the first one is
    /// read. Otherwise the arrival of the first one counts.
    void noteStart(double host_s) { m_origin_s = host_s; }
    /// `packetsLost`: of the transport so far.
    void feed(Octets packet, double arrival_s, std::uint64_t packetsLost = 0);
    /// True when enough rows wait for a block (10 ms of them, or a gap).
    bool isBlockDue() const;
    /// No more packets come: rows that waited for the next ones are placed by their own stamps.
    void finish() { settle(true); }
    /// All complete rows as blocks, oldest first.
    std::vector<SampleBlockPtr> takeBlocks();

    double lastArrival_s() const { return m_lastArrival_s; }
    double boardPeriod_s() const { return m_plan.boardPeriod_s; }
    std::uint64_t clockRestarts() const { return m_clockRestarts; }
    /// Incomplete samples, samples out of time, packets of no list of ours.
    std::uint64_t dropped() const {
        return m_decoder.incompleteSamples() + m_decoder.foreignPackets() + m_misplaced;
    }
    std::uint64_t incomplete() const { return m_decoder.incompleteSamples(); }

private:
    struct Row {
        double time_s; ///< on the axis of the stream
        double arrival_s;
        std::span<const double> values;
    };
    struct StoredRow {
        double time_s;
        double arrival_s;
        std::vector<double> values;
    };

    bool isPlausible(double time_s, double arrival_s) const;
    void addRow(double clock_s, double arrival_s);
    void addStray(double time_s, double arrival_s);
    void restartClock();
    void takeRow(const Row& row, bool isLossSure);
    void settle(bool isEnd);
    void placeRow(const Row& row, std::uint64_t missing);
    void storeRow(const Row& row);
    void closeBlock();

    SamplingPlan m_plan;
    DaqAbility m_ability;
    DtoDecoder m_decoder;
    std::optional<TickUnwrapper> m_unwrapper;
    double m_rowsPerBlock;
    RowGrid m_grid;
    std::size_t m_lookAhead;
    std::int64_t m_nextIndex = 0;     ///< board samples since the first
    std::optional<double> m_origin_s; ///< host's time of device time 0, as late as it can be
    double m_earliest_s = std::numeric_limits<double>::infinity(); ///< arrival less time, least of the rows
    double m_latest_s = -std::numeric_limits<double>::infinity();  ///< and largest
    double m_lastArrival_s = 0.0;
    std::optional<double> m_lastTime_s; ///< of the last row that was taken
    double m_lastRowArrival_s = 0.0;
    double m_clockShift_s = 0.0; ///< from the board's clock, which may have started again, to the axis
    std::uint64_t m_clockRestarts = 0;
    bool m_isBreak = false;                     ///< and no block tells of it yet
    std::optional<std::uint64_t> m_packetsLost; ///< of the transport, at the last row
    bool m_isLossSure = false;                  ///< the transport missed packets before this row
    std::deque<StoredRow> m_waiting; ///< the first may be late or behind a loss: the next rows tell
    std::vector<StoredRow> m_strays; ///< misplaced, one behind the other
    std::uint64_t m_lostBefore = 0;
    std::uint64_t m_misplaced = 0;
    std::shared_ptr<SampleBlock> m_open;
    std::vector<SampleBlockPtr> m_ready;
};

} // namespace halbench::devices::xcp
