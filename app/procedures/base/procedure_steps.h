#pragma once

#include "app/procedures/base/procedure.h"
#include "devices/acquisition/guard.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// Enters a state: tells the observer, then asks it whether to go on. Errors: what checkAbort says.
Result<void> enterState(const ProcedureObserver& observer, ProcedureState state);

/// Lets device time pass in pieces, asking the observer between them and telling it how far
/// `from ... to` of the whole is done. Errors: of the clock, of checkAbort.
Result<void> waitObserved(devices::Device& device, const ProcedureObserver& observer, double duration_s,
                          double from = 0.0, double to = 1.0, const std::string& text = {});

/// Takes the rows of a stream one block after the other. An error ends the stream's use.
using RowSink = std::function<Result<void>(const SampleBlock&)>;

/// A stream kept in memory for the life of a procedure, or handed on instead. Stops the stream on
/// destruction. Thread: the procedure's.
class StreamRecorder {
public:
    /// With a sink the rows go there and nowhere else.
    StreamRecorder(devices::Device& device, const ProcedureObserver& observer, RowSink sink = nullptr);
    ~StreamRecorder();
    StreamRecorder(const StreamRecorder&) = delete;
    StreamRecorder& operator=(const StreamRecorder&) = delete;

    /// Before start(): the host's own limits, beside the board's. A value outside stops the device at once.
    void guardBy(std::vector<devices::GuardLimit> limits);
    /// Signals the device does not have are left out. Errors: of the device.
    Result<void> start(const std::vector<std::string>& signals, double rate_Hz);
    /// Errors: SafetyStop of the guard; NotFinite when a sample was no number, naming the signal and the
    /// time; of the sink.
    Result<void> check() const;
    /// Why a procedure ended: the guard's reason rather than what its stop caused.
    Error causeOf(const Error& error) const;
    std::size_t rows() const { return m_rows; }
    /// Stops the stream and gives what came. Errors: as of check().
    Result<Recording> finish();

private:
    void take(const SampleBlockPtr& block);
    void checkFinite(const SampleBlock& block);

    devices::Device& m_device;
    const ProcedureObserver& m_observer;
    RowSink m_sink;
    std::optional<devices::Guard> m_guard;
    Recording m_recording;
    std::size_t m_rows = 0;
    std::optional<Error> m_error;
    bool m_isRunning = false;
};

} // namespace halbench::app
