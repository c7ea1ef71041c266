#pragma once

#include "control/base/sample_block.h"
#include "devices/xcp/sampling_plan.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace halbench::devices::xcp {

/// Makes SampleBlocks of the packets of one stream: time axis from the device's clock alone (3.9), lost rows
/// counted from the gaps in it, rows whose time steps back or far ahead dropped.
class StreamAssembler {
public:
    StreamAssembler(SamplingPlan plan, const DaqAbility& ability, DtoDecoder decoder);

    void feed(Octets packet, double arrival_s);
    /// True when enough rows wait for a block (10 ms of them, or a gap).
    bool isBlockDue() const;
    /// All complete rows as blocks, oldest first.
    std::vector<SampleBlockPtr> takeBlocks();

    double lastArrival_s() const { return m_lastArrival_s; }
    double boardPeriod_s() const { return m_plan.boardPeriod_s; }
    /// Incomplete samples, samples out of time, packets of no list of ours.
    std::uint64_t dropped() const {
        return m_decoder.incompleteSamples() + m_decoder.foreignPackets() + m_misplaced;
    }

private:
    void addRow(double time_s, double arrival_s);
    void storeRow(double time_s, double arrival_s);
    void closeBlock();

    SamplingPlan m_plan;
    DaqAbility m_ability;
    DtoDecoder m_decoder;
    std::optional<TickUnwrapper> m_unwrapper;
    double m_rowsPerBlock;
    std::int64_t m_nextIndex = 0; ///< board samples since the first
    double m_firstArrival_s = 0.0;
    double m_lastArrival_s = 0.0;
    double m_lastTime_s = 0.0;
    std::uint64_t m_lostBefore = 0;
    std::uint64_t m_misplaced = 0;
    std::shared_ptr<SampleBlock> m_open;
    std::vector<SampleBlockPtr> m_ready;
};

} // namespace halbench::devices::xcp
