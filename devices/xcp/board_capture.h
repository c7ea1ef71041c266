#pragma once

#include "devices/xcp/board_description.h"
#include "devices/xcp/xcp_master.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace halbench::devices::xcp {

/// Reads the board's own capture (up to 4 signals x 4096 samples at loop rate) as a recording whose time is
/// measured from the trigger, negative before it. The board names the signals by their measurement number in
/// `capture.signal_1` ... (3.16). Piece by piece: on a serial line the whole takes seconds, in which nothing
/// else would be served. Thread: the connection's.
class BoardCapture {
public:
    /// The next piece; the recording with the last one. Empty before, and while the capture is not full. One
    /// that was started again meanwhile is read from its begin.
    /// Errors: DeviceRefused (a board without capture), those of the link.
    Result<Recording> read(Device& device, const BoardDescription& board, XcpMaster& master);

private:
    /// Of what is being read: another one is another capture.
    struct Settings {
        std::vector<std::pair<std::size_t, const A2lMeasurement*>> channels; ///< place in the data, signal
        double period_s = 0.0;
        double pretrigger = 0.0; ///< rows before the trigger
        double time_s = 0.0;     ///< of the trigger, by the board's clock

        bool operator==(const Settings&) const = default;
    };

    static Result<Settings> readSettings(Device& device, const BoardDescription& board);
    void begin(Settings settings);
    Result<void> readRows(const A2lCharacteristic& data, XcpMaster& master);

    Settings m_settings;
    Recording m_recording; ///< as far as it is read; no layout: nothing is being read
};

} // namespace halbench::devices::xcp
