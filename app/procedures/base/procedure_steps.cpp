#include "app/procedures/base/procedure_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

Result<void> enterState(const ProcedureObserver& observer, ProcedureState state) {
    if (observer.onState) {
        observer.onState(state);
    }
    return observer.checkAbort ? observer.checkAbort() : Result<void>();
}

Result<void> waitObserved(devices::Device& device, const ProcedureObserver& observer, double duration_s,
                          double from, double to, const std::string& text) {
    constexpr double Piece_s = 0.1;
    const double start_s = device.clock().now_s();
    const double end_s = start_s + duration_s;
    while (device.clock().now_s() < end_s - 1e-9) {
        if (observer.checkAbort) {
            if (auto goOn = observer.checkAbort(); !goOn) {
                return goOn;
            }
        }
        if (auto waited = device.clock().waitFor(std::min(Piece_s, end_s - device.clock().now_s()));
            !waited) {
            return waited;
        }
        if (observer.onProgress) {
            const double part = (device.clock().now_s() - start_s) / duration_s;
            observer.onProgress(from + (to - from) * std::min(part, 1.0), text);
        }
    }
    return {};
}

StreamRecorder::StreamRecorder(devices::Device& device, const ProcedureObserver& observer, RowSink sink)
    : m_device(device), m_observer(observer), m_sink(std::move(sink)) {}

StreamRecorder::~StreamRecorder() {
    if (m_isRunning) {
        m_device.stopStream();
    }
}

Result<void> StreamRecorder::start(const std::vector<std::string>& signals, double rate_Hz) {
    devices::StreamRequest request;
    request.rate_Hz = rate_Hz;
    for (const std::string& name : signals) {
        if (m_device.catalogue().findSignal(name) != nullptr) {
            request.signals.push_back(name);
        }
    }
    devices::BlockSink sink = [this](const SampleBlockPtr& block) { take(block); };
    auto started =
        m_device.startStream(request, m_guard ? m_guard->watching(std::move(sink)) : std::move(sink));
    m_isRunning = started.has_value();
    return started;
}

void StreamRecorder::take(const SampleBlockPtr& block) {
    checkFinite(*block);
    m_rows += block->rows();
    if (!m_sink) {
        m_recording.append(*block);
    } else if (!m_error) {
        if (const Result<void> taken = m_sink(*block); !taken) {
            m_error = taken.error();
        }
    }
    if (m_observer.onBlock) {
        m_observer.onBlock(block);
    }
}

void StreamRecorder::checkFinite(const SampleBlock& block) {
    for (std::size_t row = 0; row < block.rows() && !m_error; ++row) {
        for (std::size_t column = 0; column < block.layout->columns.size(); ++column) {
            if (!std::isfinite(block.value(row, column))) {
                m_error = Error{ErrorCode::NotFinite,
                                fmt::format("{} is not a number at {:.3f} s",
                                            block.layout->columns[column].name, block.time_s[row]),
                                "Damaged values from the device or the link; no result."};
                break;
            }
        }
    }
}

void StreamRecorder::guardBy(std::vector<devices::GuardLimit> limits) {
    m_guard.emplace(m_device, std::move(limits));
}

Error StreamRecorder::causeOf(const Error& error) const {
    return m_guard && m_guard->tripped() ? *m_guard->tripped() : error;
}

Result<void> StreamRecorder::check() const {
    if (m_guard && m_guard->tripped()) {
        return failure(*m_guard->tripped());
    }
    return m_error ? Result<void>(failure(*m_error)) : Result<void>();
}

Result<Recording> StreamRecorder::finish() {
    m_device.stopStream();
    m_isRunning = false;
    if (const Result<void> checked = check(); !checked) {
        return failure(checked.error());
    }
    return std::move(m_recording);
}

} // namespace halbench::app
