#include "app/procedures/move/move_procedure.h"

#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/base/restored_result.h"
#include "app/procedures/base/row_loss.h"
#include "app/procedures/excite/excitation_limits.h"
#include "app/procedures/move/move_judgement.h"
#include "app/procedures/tune/position_law_parameters.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double Settle_s = 0.05; ///< armed and at rest before the reference starts: gives the origin
/// The board begins at its next position sample (10 ms); one more period for the last rows on their way.
constexpr double Tail_s = 0.03;

Result<void> checkMove(const MoveConfig& config) {
    if (auto complete = checkMoveReference(config.reference); !complete) {
        return complete;
    }
    constexpr double Longest_s = 3600.0;
    if (!std::isfinite(config.duration_s) || config.duration_s < 0.05 || config.duration_s > Longest_s) {
        return failure(ErrorCode::OutOfRange,
                       fmt::format("a move of {} s is out of range", config.duration_s),
                       "Allowed: 0.05 to 3600 s.");
    }
    return {};
}

// Room for overshoot without friction (68 % of the step, resources/help/htm-theory.md 8.1) and then some.
double excursionWindow_rad(const devices::Catalogue& catalogue, const MoveConfig& config) {
    const double asked_rad = referenceExcursion_rad(config.reference, config.duration_s);
    const ParameterSpec* spec = catalogue.findParameter("window.position");
    const double largest_rad = spec == nullptr ? 10000.0 : spec->max;
    return std::min(2.0 * asked_rad + Pi / 2.0, largest_rad);
}

Result<void> setWindows(devices::Device& device, const MoveConfig& config, const ProcedureObserver&) {
    const ParameterValue windows[] = {{"window.position", excursionWindow_rad(device.catalogue(), config)},
                                      {"window.position_enabled", 1.0},
                                      {"window.speed", config.speedLimit_rad_s},
                                      {"window.speed_enabled", 1.0}};
    return device.writeParameters(windows);
}

Result<void> setGenerator(devices::Device& device, const MoveConfig& config, const ProcedureObserver&) {
    std::vector<ParameterValue> values = generatorParameters(config.reference, config.duration_s);
    values.push_back({"hb.mode", static_cast<double>(devices::BoardMode::Position)});
    // A small board leaves out what only chirp and multisine need, and refuses these shapes.
    std::erase_if(values, [&device](const ParameterValue& value) {
        return value.name.starts_with("reference.") &&
               device.catalogue().findParameter(value.name) == nullptr;
    });
    return device.writeParameters(values);
}

std::vector<std::string> recordedSignals() {
    return {"position",
            "speed",
            "reference",
            "current_command",
            "current.a",
            "current.b",
            "hall.a",
            "hall.b",
            "coil_temperature.a",
            "coil_temperature.b",
            "status",
            "fault",
            "torn_count",
            "truth.position",
            "truth.speed",
            "reference.segment",
            "reference.running"};
}

// From arming to the last sample.
Result<void> follow(devices::Device& device, const MoveConfig& config, const ProcedureObserver& observer) {
    if (auto armed = device.arm(); !armed) {
        return armed;
    }
    if (auto settled = waitObserved(device, observer, Settle_s, 0.0, 0.0, "holds its position"); !settled) {
        return settled;
    }
    const ParameterValue start[] = {{"reference.start", 1.0}};
    if (auto started = device.writeParameters(start); !started) {
        return started;
    }
    if (auto entered = enterState(observer, ProcedureState::Record); !entered) {
        return entered;
    }
    if (auto moved = waitObserved(device, observer, config.duration_s + Tail_s, 0.05, 0.95, "makes the move");
        !moved) {
        return moved;
    }
    return device.disarm();
}

double loopPeriod_s(const devices::Catalogue& catalogue) {
    const auto found = catalogue.knownConstants.find("T_s");
    return found == catalogue.knownConstants.end() ? 0.01 : found->second;
}

struct Origin {
    std::size_t firstRow = 0; ///< of the reference
    double reference_rad = 0.0;
    double truth_rad = 0.0;
};

Result<Origin> findOrigin(const Recording& recording) {
    const std::vector<double> running = recording.column("reference.running");
    const std::vector<double> reference = recording.column("reference");
    const std::vector<double> truth = recording.column("truth.position");
    const auto first = std::find_if(running.begin(), running.end(), [](double value) { return value > 0.5; });
    if (first == running.begin() || first == running.end() || reference.empty()) {
        return failure(ErrorCode::Protocol, "the board did not start its reference", "Try again.");
    }
    Origin origin;
    origin.firstRow = static_cast<std::size_t>(first - running.begin());
    origin.reference_rad = reference[origin.firstRow - 1];
    origin.truth_rad = truth.empty() ? 0.0 : truth[origin.firstRow - 1];
    return origin;
}

// Keeps the rows of the reference and lets time begin with it.
void cut(Recording& recording, const Origin& origin, const MoveConfig& config) {
    const std::size_t columns = recording.layout->columns.size();
    const double start_s = recording.time_s[origin.firstRow];
    const double end_s = start_s + config.duration_s + 0.5 / config.rate_Hz; // not by count: rows may be lost
    const auto after = std::upper_bound(recording.time_s.begin(), recording.time_s.end(), end_s);
    const auto last = static_cast<std::size_t>(after - recording.time_s.begin());
    Recording part;
    part.layout = recording.layout;
    part.lostRows = recording.lostRows;
    for (std::size_t row = origin.firstRow; row < last; ++row) {
        // Whole milliseconds: the difference of two time stamps carries their rounding.
        part.time_s.push_back(std::round((recording.time_s[row] - start_s) * 1e6) / 1e6);
    }
    const auto begin = recording.values.begin();
    part.values.assign(begin + static_cast<std::ptrdiff_t>(origin.firstRow * columns),
                       begin + static_cast<std::ptrdiff_t>(last * columns));
    recording = std::move(part);
}

struct Column {
    const char* name;
    double origin_rad;
};

MoveResponse responseOf(const Recording& recording, const Column& column, double referenceOrigin_rad,
                        double rowsPerReference) {
    MoveResponse response;
    response.rowsPerReference = static_cast<std::size_t>(std::max(1.0, std::round(rowsPerReference)));
    response.time_s = recording.time_s;
    response.reference_rad = recording.column("reference");
    response.position_rad = recording.column(column.name);
    for (double& value : response.reference_rad) {
        value -= referenceOrigin_rad;
    }
    for (double& value : response.position_rad) {
        value -= column.origin_rad;
    }
    return response;
}

double largest(const std::vector<double>& values, bool ofMagnitude) {
    double result = 0.0;
    for (const double value : values) {
        result = std::max(result, ofMagnitude ? std::fabs(value) : value);
    }
    return result;
}

// A small board has no event as fast as that, and its line would not carry it: then once each position loop.
MoveConfig atPossibleRate(const devices::Device& device, MoveConfig config) {
    const SignalSpec* position = device.catalogue().findSignal("position");
    if (position != nullptr && position->maxRate_Hz < config.rate_Hz) {
        config.rate_Hz = 1.0 / loopPeriod_s(device.catalogue());
    }
    return config;
}

Result<MoveResult> judge(Recording recording, const MoveConfig& config, double period_s) {
    const auto origin = findOrigin(recording);
    if (!origin) {
        return failure(origin.error());
    }
    cut(recording, *origin, config);
    const auto responseIn = [&](const Column& column) {
        return responseOf(recording, column, origin->reference_rad, period_s * config.rate_Hz);
    };
    MoveResult result;
    result.lockThreshold_rad = config.lockThreshold_rad;
    const MoveResponse response = responseIn({"position", origin->reference_rad});
    const auto measured = measureMove(response, config);
    if (!measured) {
        return failure(measured.error());
    }
    result.measured = *measured;
    if (recording.layout->indexOf("truth.position") >= 0) {
        const auto truth = measureMove(responseIn({"truth.position", origin->truth_rad}), config);
        if (!truth) {
            return failure(truth.error());
        }
        result.truth = *truth;
    }
    result.peakCurrent_A = largest(recording.column("current_command"), true);
    result.highestTemperature_degC = std::max(largest(recording.column("coil_temperature.a"), false),
                                              largest(recording.column("coil_temperature.b"), false));
    result.recording = std::move(recording);
    result.quality = judgeMotion(response, config, result.recording.lostRows, origin->reference_rad);
    return result;
}

// A motor that is still coasting from its last move would give the reference a moving origin. One that does
// not stop (no friction) is taken as it is; the figures then speak for themselves.
Result<void> awaitRest(devices::Device& device, const ProcedureObserver& observer) {
    constexpr double Still_rad_s = 0.15; // one count that flickers looks like 0.11 rad/s
    constexpr double Patience_s = 10.0;
    constexpr double Piece_s = 0.1;
    const std::string names[] = {"speed"};
    if (device.catalogue().findSignal(names[0]) == nullptr) {
        return {};
    }
    int still = 0;
    for (double waited_s = 0.0; waited_s < Patience_s && still < 2; waited_s += Piece_s) {
        const auto speed_rad_s = device.readSignals(names);
        if (!speed_rad_s) {
            return failure(speed_rad_s.error());
        }
        still = std::fabs(speed_rad_s->front()) < Still_rad_s ? still + 1 : 0;
        if (still < 2) {
            if (auto waited = waitObserved(device, observer, Piece_s, 0.0, 0.0, "waits for standstill");
                !waited) {
                return waited;
            }
        }
    }
    return {};
}

Result<void> prepare(devices::Device& device, const MoveConfig& config, const ProcedureObserver& observer) {
    const auto law = readPositionLaw(device);
    if (!law) {
        return failure(law.error());
    }
    const MovePrediction prediction = predictMove(config, *law, models::RotorConfig{}, 1.43e-2);
    const auto heat = admitHeat(device, observer, prediction.meanSquare_A2, prediction.duration_s,
                                config.pauseTemperature_degC, config.refuseTemperature_degC);
    return heat ? awaitRest(device, observer) : Result<void>(failure(heat.error()));
}

Result<MoveResult> runGuarded(devices::Device& device, const MoveConfig& config,
                              const ProcedureObserver& observer) {
    if (auto entered = enterState(observer, ProcedureState::Prepare); !entered) {
        return failure(entered.error());
    }
    auto guard = RestoreGuard::take(device);
    if (!guard) {
        return failure(guard.error());
    }
    return restoredResult(*guard, performMove(device, config, observer));
}

} // namespace

MoveOutlook moveOutlook(const MoveConfig& config, const devices::Catalogue& catalogue) {
    return {referenceExcursion_rad(config.reference, config.duration_s),
            excursionWindow_rad(catalogue, config), config.speedLimit_rad_s,
            Settle_s + config.duration_s + Tail_s};
}

MovePrediction predictMove(const MoveConfig& config, const control::SampledPositionLaw& law,
                           const models::RotorConfig& motor, double torqueConstant_Nm_per_A) {
    constexpr double Margin_ratio =
        1.25; // of the current: friction scatter and a motor that is not quite this one
    const double limit_A = law.limit_A;
    const auto reference = idealReference(config.reference);
    if (!reference) {
        return {config.duration_s, limit_A, limit_A * limit_A};
    }
    models::IdealLoopConfig loop;
    loop.rotor = motor;
    loop.torqueConstant_Nm_per_A = torqueConstant_Nm_per_A;
    loop.law = law;
    loop.reference = *reference;
    loop.duration_s = config.duration_s;
    const models::IdealTrace trace = models::runIdealLoop(loop);
    double square = 0.0;
    for (const double current_A : trace.current_A) {
        square += current_A * current_A / static_cast<double>(trace.current_A.size());
    }
    const double withMargin = std::min(square * Margin_ratio * Margin_ratio, limit_A * limit_A);
    return {config.duration_s, largest(trace.current_A, true), withMargin};
}

Result<MoveResult> performMove(devices::Device& device, const MoveConfig& wanted,
                               const ProcedureObserver& observer) {
    const MoveConfig config = atPossibleRate(device, wanted);
    if (auto checked = checkMove(config); !checked) {
        return failure(checked.error());
    }
    for (auto* step : {&prepare, &setWindows, &setGenerator}) {
        if (auto done = (*step)(device, config, observer); !done) {
            return failure(done.error());
        }
    }
    if (auto entered = enterState(observer, ProcedureState::Excite); !entered) {
        return failure(entered.error());
    }
    const devices::LinkStatistics before = device.statistics();
    StreamRecorder recorder(device, observer);
    recorder.guardBy(excitationLimits(device.catalogue(), config.speedLimit_rad_s,
                                      excursionWindow_rad(device.catalogue(), config)));
    if (auto started = recorder.start(recordedSignals(), config.rate_Hz); !started) {
        return failure(started.error());
    }
    if (auto followed = follow(device, config, observer); !followed) {
        return failure(recorder.causeOf(followed.error()));
    }
    Result<Recording> recording = recorder.finish();
    if (!recording) {
        return failure(recording.error());
    }
    if (auto entered = enterState(observer, ProcedureState::Judge); !entered) {
        return failure(entered.error());
    }
    Result<MoveResult> result = judge(*std::move(recording), config, loopPeriod_s(device.catalogue()));
    if (result) {
        nameRowLoss(result->quality, causeOfRowLoss(before, device.statistics()));
    }
    return result;
}

Result<MoveResult> runMove(devices::Device& device, const MoveConfig& config,
                           const ProcedureObserver& observer) {
    Result<MoveResult> result = runGuarded(device, config, observer);
    const auto entered = enterState(observer, result ? ProcedureState::Done : ProcedureState::Restored);
    if (result && !entered) {
        return failure(entered.error());
    }
    return result;
}

} // namespace halbench::app
