#include "app/procedures/record_procedure.h"

#include "app/procedures/procedure_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double MaxRows = 2e7; // some gigabytes

Result<void> checkRecord(const devices::Catalogue& catalogue, const RecordConfig& config) {
    if (!std::isfinite(config.duration_s) || config.duration_s <= 0.0) {
        return failure(ErrorCode::OutOfRange, "the duration must be more than zero seconds",
                       "Give e.g. --duration 10.");
    }
    if (!std::isfinite(config.rate_Hz) || config.rate_Hz <= 0.0) {
        return failure(ErrorCode::OutOfRange, "the rate must be more than zero", "Give e.g. --rate 100.");
    }
    if (config.duration_s * config.rate_Hz > MaxRows) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a duration of {} s at {} Hz is more than {} rows", config.duration_s,
                                   config.rate_Hz, MaxRows),
                       "Record in pieces or at a lower rate.");
    }
    for (const std::string& name : config.signals) {
        if (catalogue.findSignal(name) == nullptr) {
            return failure(ErrorCode::UnknownName, fmt::format("the device has no signal '{}'", name),
                           "`halbench describe` lists the signals.");
        }
        if (std::count(config.signals.begin(), config.signals.end(), name) > 1) {
            return failure(ErrorCode::Usage, fmt::format("the signal '{}' is named twice", name),
                           "Name every signal once.");
        }
    }
    return {};
}

/// Takes the rows of one recording and counts them. Rows behind the end, waited for because others were lost
/// or on their way when the wait ended, are left out.
class RowTaker {
public:
    RowTaker(const RecordConfig& config, const RecordOutlet* outlet)
        : m_outlet(outlet), m_rate_Hz(config.rate_Hz), m_end_s(config.duration_s - 0.5 / config.rate_Hz) {}

    Result<void> take(const SampleBlock& block) {
        SampleBlock wanted = block;
        while (!wanted.time_s.empty() && wanted.time_s.back() > m_end_s) {
            wanted.time_s.pop_back();
        }
        if (wanted.time_s.empty()) {
            return {};
        }
        wanted.values.resize(wanted.rows() * wanted.layout->columns.size());
        m_rows += wanted.rows();
        m_lostRows += wanted.lostRows;
        m_gaps += wanted.lostRows > 0 ? 1 : 0;
        if (m_outlet != nullptr) {
            return m_outlet->append(wanted);
        }
        m_recording.append(wanted);
        return {};
    }

    RecordResult result() {
        return {std::move(m_recording),
                m_rows,
                m_lostRows,
                m_gaps,
                static_cast<double>(m_lostRows) / m_rate_Hz,
                {}};
    }

private:
    const RecordOutlet* m_outlet;
    double m_rate_Hz;
    double m_end_s;
    Recording m_recording;
    std::size_t m_rows = 0;
    std::uint64_t m_lostRows = 0;
    std::uint64_t m_gaps = 0;
};

/// What the stream's blocks will look like.
StreamLayout layoutOf(const devices::Catalogue& catalogue, const std::vector<std::string>& signals,
                      double rate_Hz) {
    StreamLayout layout;
    layout.period_s = 1.0 / rate_Hz;
    for (const std::string& name : signals) {
        if (const SignalSpec* spec = catalogue.findSignal(name)) {
            layout.columns.push_back({name, spec->unit});
        }
    }
    return layout;
}

// A gap is shown; a stream that is mostly gap is no recording.
Result<DataQuality> judgeRows(std::size_t found, std::size_t expected) {
    DataQuality quality;
    if (2 * found < expected) {
        return failure(ErrorCode::DeviceLost, fmt::format("only {} of {} samples arrived", found, expected),
                       "check the link; record fewer signals or at a lower rate");
    }
    if (found < expected) {
        quality.verdict = Verdict::Doubtful;
        quality.findings.push_back({"rows_lost",
                                    fmt::format("{} of {} rows are missing", expected - found, expected),
                                    "Record fewer signals or at a lower rate."});
    }
    return quality;
}

// Waits for the rows, with some patience for those on their way. A recording that cannot be kept ends early.
Result<void> collect(devices::Device& device, const ProcedureObserver& observer,
                     const StreamRecorder& recorder, std::size_t rows, double duration_s) {
    ProcedureObserver watching = observer;
    watching.checkAbort = [&]() -> Result<void> {
        const Result<void> goOn = observer.checkAbort ? observer.checkAbort() : Result<void>();
        return goOn ? recorder.check() : goOn;
    };
    if (auto waited = waitObserved(device, watching, duration_s, 0.0, 1.0, "records"); !waited) {
        return waited;
    }
    constexpr double Patience_s = 0.2;
    constexpr double Piece_s = 0.01;
    for (double late_s = 0.0; recorder.rows() < rows && late_s < Patience_s; late_s += Piece_s) {
        if (auto waited = device.clock().waitFor(Piece_s); !waited) {
            return waited;
        }
    }
    return recorder.check();
}

} // namespace

Result<RecordResult> runRecord(devices::Device& device, const RecordConfig& config,
                               const ProcedureObserver& observer, const RecordOutlet* outlet) {
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    if (auto checked = checkRecord(device.catalogue(), config); !checked) {
        return failure(checked.error());
    }
    const auto& signals = config.signals.empty() ? device.catalogue().defaultSignals : config.signals;
    // rows at 0, 1/R, ... < S; a duration that is a whole number of periods up to rounding counts as such
    const auto rows = static_cast<std::size_t>(std::ceil(config.duration_s * config.rate_Hz - 1e-6));
    RowTaker taker(config, outlet);
    StreamRecorder recorder(device, observer, [&](const SampleBlock& block) { return taker.take(block); });
    Result<void> done = recorder.start(signals, config.rate_Hz);
    if (done && outlet != nullptr) {
        done = outlet->begin(layoutOf(device.catalogue(), signals, config.rate_Hz));
    }
    done = done ? enterState(observer, ProcedureState::Record) : done;
    done = done ? collect(device, observer, recorder, rows, config.duration_s) : done;
    if (!done) {
        return failure(done.error());
    }
    recorder.finish();
    RecordResult result = taker.result();
    auto quality = judgeRows(result.rows, rows);
    if (!quality) {
        return failure(quality.error());
    }
    result.quality = *std::move(quality);
    if (auto entered = enterState(observer, ProcedureState::Done); !entered) {
        return failure(entered.error());
    }
    return result;
}

} // namespace halbench::app
