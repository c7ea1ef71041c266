#include "app/procedures/record_procedure.h"

#include "app/procedures/procedure_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double MaxRows = 2e7; // held in memory until written: some gigabytes

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

// Rows up to the duration; when some were lost, those waited for too long lie behind it.
void trimRows(Recording& recording, double duration_s, double period_s) {
    if (recording.rows() == 0) { // nothing came, not even a layout
        return;
    }
    const double end_s = duration_s - 0.5 * period_s;
    while (!recording.time_s.empty() && recording.time_s.back() > end_s) {
        recording.time_s.pop_back();
    }
    recording.values.resize(recording.rows() * recording.layout->columns.size());
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

// Waits for the rows, with some patience for those on their way.
Result<void> collect(devices::Device& device, const ProcedureObserver& observer,
                     const StreamRecorder& recorder, std::size_t rows, double duration_s) {
    if (auto waited = waitObserved(device, observer, duration_s, 0.0, 1.0, "records"); !waited) {
        return waited;
    }
    constexpr double Patience_s = 0.2;
    constexpr double Piece_s = 0.01;
    for (double late_s = 0.0; recorder.rows() < rows && late_s < Patience_s; late_s += Piece_s) {
        if (auto waited = device.clock().waitFor(Piece_s); !waited) {
            return waited;
        }
    }
    return {};
}

} // namespace

Result<RecordResult> runRecord(devices::Device& device, const RecordConfig& config,
                               const ProcedureObserver& observer) {
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    if (auto checked = checkRecord(device.catalogue(), config); !checked) {
        return failure(checked.error());
    }
    const auto& signals = config.signals.empty() ? device.catalogue().defaultSignals : config.signals;
    // rows at 0, 1/R, ... < S; a duration that is a whole number of periods up to rounding counts as such
    const auto rows = static_cast<std::size_t>(std::ceil(config.duration_s * config.rate_Hz - 1e-6));
    StreamRecorder recorder(device, observer);
    if (auto started = recorder.start(signals, config.rate_Hz); !started) {
        return failure(started.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Record); !entered) {
        return failure(entered.error());
    }
    if (auto collected = collect(device, observer, recorder, rows, config.duration_s); !collected) {
        return failure(collected.error());
    }
    if (auto finite = recorder.check(); !finite) {
        return failure(finite.error());
    }
    RecordResult result;
    result.recording = recorder.finish();
    trimRows(result.recording, config.duration_s, 1.0 / config.rate_Hz);
    auto quality = judgeRows(result.recording.rows(), rows);
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
