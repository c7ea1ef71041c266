#pragma once

#include "devices/device.h"
#include "devices/xcp/board_description.h"
#include "devices/xcp/stream_assembler.h"
#include "devices/xcp/xcp_master.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace halbench::devices::xcp {

/// The stream of samples of a board: chosen, started, put together into blocks, watched for silence and
/// ended. All that it is given outlives it. Thread: the connection's.
class DaqStream {
public:
    using MessageSink = std::function<void(const std::string&)>; ///< never empty

    DaqStream(XcpMaster& master, XcpLink& link, const BoardDescription& board, MessageSink onMessage);

    /// Ends the stream before and starts another. Errors: UnknownName and InvalidInput of the request, those
    /// of the link.
    Result<void> start(const DaqAbility& ability, const StreamRequest& request, BlockSink sink);
    void stop() noexcept;
    bool isRunning() const { return m_stream != nullptr; }

    /// A packet of samples; of no stream of ours it is dropped.
    void feed(Octets packet);
    bool isBlockDue() const { return m_stream && m_stream->isBlockDue(); }
    void deliverBlocks();
    /// No further packet will come.
    void finish();
    /// DeviceLost when the board sends no samples although it was told to.
    Result<void> checkHeartbeat();

    std::uint64_t dropped() const;    ///< samples incomplete or misplaced, of this stream and those before
    std::uint64_t incomplete() const; ///< of these

private:
    double now_s() const { return m_link->transport().now_s(); }
    void remarkOn(const SamplingPlan& sampling, const DaqPlan& plan) const;

    XcpMaster* m_master;
    XcpLink* m_link;
    const BoardDescription* m_board;
    MessageSink m_onMessage;
    std::unique_ptr<StreamAssembler> m_stream;
    BlockSink m_sink;
    double m_started_s = 0.0;
    std::uint64_t m_dropped = 0; ///< of streams that ended
    std::uint64_t m_incomplete = 0;
};

} // namespace halbench::devices::xcp
