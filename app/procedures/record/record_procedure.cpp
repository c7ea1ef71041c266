#include "app/procedures/record/record_procedure.h"

#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/row_loss.h"
#include "devices/acquisition/stream_rate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace halbench::app {
namespace {

constexpr double MaxRows = 2e7; // some gigabytes

std::vector<std::string> recordedSignals(const devices::Catalogue& catalogue, const RecordConfig& config) {
    std::vector<std::string> names = config.signals.empty() ? catalogue.defaultSignals : config.signals;
    const std::string source = config.trigger ? config.trigger->event.signal : std::string();
    if (!source.empty() && std::find(names.begin(), names.end(), source) == names.end()) {
        names.push_back(source);
    }
    return names;
}

Result<void> checkRecord(const devices::DeviceInfo& info, const devices::Catalogue& catalogue,
                         const RecordConfig& config) {
    if (!std::isfinite(config.duration_s) || config.duration_s <= 0.0) {
        return failure(ErrorCode::OutOfRange, "the duration must be more than zero seconds",
                       "Give e.g. --duration 10.");
    }
    if (!std::isfinite(config.rate_Hz) || config.rate_Hz <= 0.0) {
        return failure(ErrorCode::OutOfRange, "the rate must be more than zero", "Give e.g. --rate 100.");
    }
    const double length_s = config.duration_s + (config.trigger ? config.trigger->preTrigger_s : 0.0);
    if (length_s * config.rate_Hz > MaxRows) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a duration of {} s at {} Hz is more than {} rows", length_s,
                                   config.rate_Hz, MaxRows),
                       "Record in pieces or at a lower rate.");
    }
    for (const std::string& name : recordedSignals(catalogue, config)) {
        if (catalogue.findSignal(name) == nullptr) {
            return failure(ErrorCode::UnknownName, fmt::format("the device has no signal '{}'", name),
                           "`halbench describe` lists the signals.");
        }
        if (std::count(config.signals.begin(), config.signals.end(), name) > 1) {
            return failure(ErrorCode::Usage, fmt::format("the signal '{}' is named twice", name),
                           "Name every signal once.");
        }
    }
    return devices::checkStreamRate(info, catalogue, recordedSignals(catalogue, config), config.rate_Hz);
}

/// Takes the rows of one recording and counts them. Rows behind the end, waited for because others were lost
/// or on their way when the wait ended, are left out.
class RowTaker {
public:
    RowTaker(const RecordConfig& config, const RecordOutlet* outlet)
        : m_outlet(outlet), m_rate_Hz(config.rate_Hz), m_end_s(config.duration_s - 0.5 / config.rate_Hz) {}

    /// In the recording's time.
    void setEnd(double end_s) { m_end_s = end_s; }

    Result<void> take(const SampleBlock& block) {
        m_seen_s = block.time_s.empty() ? m_seen_s : block.time_s.back();
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
        m_isBroken = m_isBroken || wanted.isBreak;
        if (m_outlet != nullptr) {
            return m_outlet->append(wanted);
        }
        m_recording.append(wanted);
        return {};
    }

    bool isBroken() const { return m_isBroken; }
    /// The last row before the end came, or one behind it.
    bool hasEnd(double end_s) const {
        constexpr double Rounding_ratio = 1e-6; // of the period
        return m_seen_s && *m_seen_s + (1.0 + Rounding_ratio) / m_rate_Hz >= end_s;
    }
    RecordResult result() {
        return {std::move(m_recording),
                m_rows,
                m_lostRows,
                m_gaps,
                static_cast<double>(m_lostRows) / m_rate_Hz,
                {},
                {}};
    }

private:
    const RecordOutlet* m_outlet;
    double m_rate_Hz;
    double m_end_s;
    std::optional<double> m_seen_s; ///< time of the last row that came
    Recording m_recording;
    std::size_t m_rows = 0;
    std::uint64_t m_lostRows = 0;
    std::uint64_t m_gaps = 0;
    bool m_isBroken = false; ///< the board's clock started again
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
Result<DataQuality> judgeRows(std::size_t found, std::size_t expected, const RowLossCause& cause) {
    DataQuality quality;
    if (2 * found < expected) {
        std::string message = fmt::format("only {} of {} samples arrived", found, expected);
        message += cause.words.empty() ? "" : ": " + cause.words;
        return failure(ErrorCode::DeviceLost, message, cause.remedy);
    }
    if (found < expected) {
        quality.verdict = Verdict::Doubtful;
        quality.findings.push_back(
            {"rows_lost", fmt::format("{} of {} rows are missing", expected - found, expected), ""});
        nameRowLoss(quality, cause);
    }
    return quality;
}

// Waits for the rows, then for those on their way: a device that stood still is behind the host's clock, and
// what it still sends is not lost. A recording that cannot be kept ends early.
Result<void> collect(devices::Device& device, const ProcedureObserver& observer,
                     const StreamRecorder& recorder, const std::function<bool()>& isComplete,
                     const RecordConfig& config) {
    ProcedureObserver watching = observer;
    watching.checkAbort = [&]() -> Result<void> {
        const Result<void> goOn = observer.checkAbort ? observer.checkAbort() : Result<void>();
        return goOn ? recorder.check() : goOn;
    };
    if (auto waited = waitObserved(device, watching, config.duration_s, 0.0, 1.0, "records"); !waited) {
        return waited;
    }
    constexpr double Patience_s = 0.2;                                    // while no row comes,
    const double patience_s = std::max(Patience_s, 2.0 / config.rate_Hz); // which may be rare
    constexpr double Piece_s = 0.01;
    const double behind_s = config.duration_s + patience_s; // a device at half the pace
    std::size_t rows = recorder.rows();
    double silent_s = 0.0;
    for (double late_s = 0.0; !isComplete() && silent_s < patience_s && late_s < behind_s;
         late_s += Piece_s) {
        if (auto waited = waitObserved(device, watching, Piece_s, 1.0, 1.0, "records"); !waited) {
            return waited;
        }
        silent_s = recorder.rows() > rows ? 0.0 : silent_s + Piece_s;
        rows = recorder.rows();
    }
    return recorder.check();
}

/// Device time passes until the event comes.
Result<void> awaitEvent(devices::Device& device, const ProcedureObserver& observer,
                        const StreamRecorder& recorder, const TriggeredRows& rows, double patience_s) {
    constexpr double Piece_s = 0.05;
    for (double waited_s = 0.0; !rows.hasEvent(); waited_s += Piece_s) {
        if (waited_s > patience_s) {
            return failure(ErrorCode::Refused,
                           fmt::format("the trigger did not come within {} s", patience_s),
                           "wait longer (--wait; wait_s of a step), or choose another trigger");
        }
        if (auto waited = waitObserved(device, observer, Piece_s, 0.0, 0.0, "waiting for the trigger");
            !waited) {
            return waited;
        }
        if (auto checked = recorder.check(); !checked) {
            return checked;
        }
    }
    return {};
}

/// Rows at 0, 1/R, ... < end; an end that is a whole number of periods up to rounding counts as such.
std::size_t rowsBefore(double end_s, double rate_Hz) {
    return static_cast<std::size_t>(std::ceil(end_s * rate_Hz - 1e-6));
}

/// What goes between the stream and the file, and how far it has come.
class Recorded {
public:
    Recorded(const RecordConfig& config, const RecordOutlet* outlet)
        : m_config(config), m_taker(config, outlet) {}

    Result<void> prepare() {
        if (!m_config.trigger) {
            return {};
        }
        auto rows = TriggeredRows::create(*m_config.trigger, [this](const SampleBlock& block) {
            m_taker.setEnd(endOfStretch_s() - 0.5e-9);
            return m_taker.take(block);
        });
        if (!rows) {
            return failure(rows.error());
        }
        m_triggered.emplace(*std::move(rows));
        return {};
    }
    Result<void> take(const SampleBlock& block) {
        return m_triggered ? m_triggered->take(block) : m_taker.take(block);
    }
    Result<void> collectAll(devices::Device& device, const ProcedureObserver& observer,
                            const StreamRecorder& recorder) {
        Result<void> done =
            m_triggered ? awaitEvent(device, observer, recorder, *m_triggered, m_config.trigger->patience_s)
                        : Result<void>();
        const auto isComplete = [this, &recorder] {
            return recorder.rows() >= firstRow() + expectedRows() || m_taker.hasEnd(endOfStretch_s());
        };
        return done ? collect(device, observer, recorder, isComplete, m_config) : done;
    }
    Result<RecordResult> result(const RowLossCause& cause) {
        RecordResult result = m_taker.result();
        auto quality = judgeRows(result.rows, expectedRows(), cause);
        if (!quality) {
            return failure(quality.error());
        }
        result.quality = *std::move(quality);
        if (m_taker.isBroken()) {
            result.quality.verdict = Verdict::Doubtful;
            result.quality.findings.push_back(
                {"clock_restarted", "the device clock restarted: the time before this row is unknown",
                 "check whether the device was reset; the recording has a gap here"});
        }
        result.trigger_s = m_triggered ? std::optional(m_triggered->trigger_s()) : std::nullopt;
        return result;
    }

private:
    double endOfStretch_s() const {
        return m_config.duration_s + (m_triggered ? m_triggered->trigger_s() : 0.0);
    }
    /// Of the stream's.
    std::size_t firstRow() const {
        return m_triggered ? static_cast<std::size_t>(std::lround(m_triggered->first_s() * m_config.rate_Hz))
                           : 0;
    }
    std::size_t expectedRows() const { return rowsBefore(endOfStretch_s(), m_config.rate_Hz); }

    const RecordConfig& m_config;
    RowTaker m_taker;
    std::optional<TriggeredRows> m_triggered;
};

} // namespace

Result<RecordResult> runRecord(devices::Device& device, const RecordConfig& config,
                               const ProcedureObserver& observer, const RecordOutlet* outlet) {
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    Recorded recorded(config, outlet);
    Result<void> done = checkRecord(device.info(), device.catalogue(), config);
    done = done ? recorded.prepare() : done;
    if (!done) {
        return failure(done.error());
    }
    const std::vector<std::string> signals = recordedSignals(device.catalogue(), config);
    StreamRecorder recorder(device, observer, [&](const SampleBlock& block) { return recorded.take(block); });
    done = enterState(observer, ProcedureState::Record);
    if (done && outlet != nullptr) { // a disk that is slow to begin holds up the stream before it runs, and
        done = outlet->begin(layoutOf(device.catalogue(), signals, config.rate_Hz)); // no row
    }
    const devices::LinkStatistics before = device.statistics();
    done = done ? recorder.start(signals, config.rate_Hz) : done;
    done = done ? recorded.collectAll(device, observer, recorder) : done;
    if (!done) {
        return failure(done.error());
    }
    if (const Result<Recording> ended = recorder.finish(); !ended) {
        return failure(ended.error());
    }
    Result<RecordResult> result = recorded.result(causeOfRowLoss(before, device.statistics()));
    if (!result) {
        return result;
    }
    if (auto entered = enterState(observer, ProcedureState::Done); !entered) {
        return failure(entered.error());
    }
    return result;
}

} // namespace halbench::app
