#include "app/procedures/base/coil_forecast.h"
#include "app/procedures/base/procedure_steps.h"
#include "app/procedures/calibrate/calibrate_runs.h"
#include "app/procedures/excite/excitation_limits.h"
#include "control/base/distributions.h"
#include "control/identify/calibration_fits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace halbench::app {
namespace {

constexpr double ShapeStep = 1.0;
constexpr double ShapeRamp = 2.0;
constexpr double ShapePlateaus = 7.0;
constexpr double Pause_degC = 60.0;
constexpr double Refuse_degC = 70.0;

Result<void> drive(devices::Device& device, const ProcedureObserver& observer,
                   std::vector<ParameterValue> values, devices::BoardMode mode, double duration_s,
                   const char* text) {
    if (auto armed = device.arm(); !armed) {
        return armed;
    }
    values.insert(values.begin(), {{"reference.start", 0.0},
                                   {"hb.setpoint", 0.0},
                                   {"hb.mode", static_cast<double>(mode)},
                                   {"reference.base", 0.0}});
    values.push_back({"reference.start", 1.0});
    if (auto started = device.writeParameters(values); !started) {
        return started;
    }
    return waitObserved(device, observer, duration_s, 0.0, 1.0, text);
}

Result<void> startGuarded(StreamRecorder& recorder, const devices::Device& device,
                          const CalibrateConfig& config, std::vector<std::string> measured) {
    recorder.guardBy(excitationLimits(device.catalogue(), config.speedLimit_rad_s));
    return recorder.start(withWatchedSignals(device.catalogue(), std::move(measured)), 100.0);
}

/// The way a rotor has gone since the first sample, from the stream.
class TravelWatch {
public:
    void take(const SampleBlock& block) {
        const int column = block.layout->indexOf("position");
        for (std::size_t row = 0; column >= 0 && row < block.rows(); ++row) {
            const double angle_rad = block.value(row, static_cast<std::size_t>(column));
            m_first_rad = m_first_rad.value_or(angle_rad);
            m_travel_rad = std::max(m_travel_rad, std::fabs(angle_rad - *m_first_rad));
        }
    }
    double travel_rad() const { return m_travel_rad; }

private:
    std::optional<double> m_first_rad;
    double m_travel_rad = 0.0;
};

ProcedureObserver watched(const ProcedureObserver& observer, TravelWatch& watch) {
    return listeningIn(observer, [&watch](const SampleBlock& block) { watch.take(block); });
}

// Short pushes, so that the next measurement stands at another angle: each twice as long as the one before,
// until the rotor has turned, so that a lively motor stays slow.
Result<void> nudge(devices::Device& device, const CalibrateConfig& config,
                   const ProcedureObserver& observer) {
    TravelWatch watch;
    const ProcedureObserver listening = watched(observer, watch);
    StreamRecorder recorder(device, listening);
    if (auto started = startGuarded(recorder, device, config, {"position"}); !started) {
        return started;
    }
    for (const double push_s : standstill::Pushes_s) {
        if (watch.travel_rad() > standstill::PushEnd_rad) {
            break;
        }
        if (auto driven = drive(device, listening,
                                {{"reference.shape", ShapeStep},
                                 {"reference.amplitude", config.frictionCurrent_A},
                                 {"reference.duration", push_s}},
                                devices::BoardMode::Current, push_s + standstill::PushRest_s,
                                "turning to the next angle");
            !driven) {
            return failure(recorder.causeOf(driven.error()));
        }
    }
    return recorder.check() ? device.disarm() : recorder.check();
}

// Levels 0, +1/8, -1/8, ... +1, -1 of the largest current, then zero.
std::vector<ParameterValue> dAxisLevels(double largest_A, double dwell_s) {
    std::vector<double> levels{0.0};
    for (int i = 1; i <= 8; ++i) {
        levels.push_back(largest_A * i / 8.0);
        levels.push_back(-largest_A * i / 8.0);
    }
    std::vector<ParameterValue> values{{"reference.shape", ShapePlateaus},
                                       {"plateau.dwell", dwell_s},
                                       {"plateau.count", static_cast<double>(levels.size())}};
    for (std::size_t i = 0; i < levels.size(); ++i) {
        values.push_back({fmt::format("plateau.current_{}", i + 1), levels[i]});
    }
    return values;
}

control::StrayRecord strayRecord(const Recording& recording, std::size_t firstRow) {
    const auto from = [&](const char* name) {
        std::vector<double> column = recording.column(name);
        column.erase(column.begin(),
                     column.begin() + static_cast<std::ptrdiff_t>(std::min(firstRow, column.size())));
        return column;
    };
    control::StrayRecord all{from("hall.a"), from("hall.b"), from("current.a"), from("current.b")};
    // A row directly after a change of current may hold the old field or the old current: left out.
    control::StrayRecord settled;
    for (std::size_t i = 1; i + 1 < all.hallA_T.size(); ++i) {
        const auto same = [i](const std::vector<double>& current) {
            constexpr double SameCurrent_A = 5e-3;
            return std::fabs(current[i] - current[i - 1]) < SameCurrent_A &&
                   std::fabs(current[i] - current[i + 1]) < SameCurrent_A;
        };
        if (same(all.currentA_A) && same(all.currentB_A)) {
            settled.hallA_T.push_back(all.hallA_T[i]);
            settled.hallB_T.push_back(all.hallB_T[i]);
            settled.currentA_A.push_back(all.currentA_A[i]);
            settled.currentB_A.push_back(all.currentB_A[i]);
        }
    }
    return settled;
}

void refuse(CalibrateResult& result, const char* code, const Error& error) {
    result.quality.verdict = std::max(result.quality.verdict, Verdict::Refused);
    result.quality.findings.push_back({code, error.message, error.hint});
}

Result<Recording> recordAt(devices::Device& device, const CalibrateConfig& config,
                           const ProcedureObserver& observer, const std::vector<ParameterValue>& values,
                           double duration_s) {
    StreamRecorder recorder(device, observer);
    if (auto started =
            startGuarded(recorder, device, config,
                         {"position", "current_command", "hall.a", "hall.b", "current.a", "current.b"});
        !started) {
        return failure(started.error());
    }
    if (auto driven = drive(device, observer, values, devices::BoardMode::DAxis, duration_s,
                            "d-axis current at standstill");
        !driven) {
        return failure(recorder.causeOf(driven.error()));
    }
    if (auto disarmed = device.disarm(); !disarmed) {
        return failure(disarmed.error());
    }
    return recorder.finish();
}

// One ramp; ends as soon as the rotor is surely off.
Result<Recording> rampOnce(devices::Device& device, const CalibrateConfig& config,
                           const ProcedureObserver& observer, double end_A) {
    using standstill::RampRate_A_per_s;
    TravelWatch watch;
    const ProcedureObserver listening = watched(observer, watch);
    StreamRecorder recorder(device, listening);
    if (auto started = startGuarded(recorder, device, config, {"position", "current_command"}); !started) {
        return failure(started.error());
    }
    const double duration_s = std::fabs(end_A) / RampRate_A_per_s;
    if (auto driven = drive(device, listening,
                            {{"reference.shape", ShapeRamp},
                             {"reference.amplitude", end_A},
                             {"reference.rate", std::copysign(RampRate_A_per_s, end_A)},
                             {"reference.duration", duration_s}},
                            devices::BoardMode::Current, 0.1, "current ramp from rest");
        !driven) {
        return failure(recorder.causeOf(driven.error()));
    }
    for (double passed_s = 0.1; passed_s < duration_s && watch.travel_rad() < standstill::RampEnd_rad;
         passed_s += 0.05) {
        if (auto waited = waitObserved(device, listening, 0.05, 0.0, 1.0, "current ramp from rest");
            !waited) {
            return failure(recorder.causeOf(waited.error()));
        }
    }
    if (auto disarmed = device.disarm(); !disarmed) {
        return failure(disarmed.error());
    }
    Result<Recording> recording = recorder.finish();
    if (!recording) {
        return recording;
    }
    if (auto waited = waitObserved(device, observer, standstill::RampRest_s); !waited) {
        return failure(waited.error());
    }
    return recording;
}

void addStaticFriction(CalibrateResult& result) {
    const auto count = static_cast<double>(result.staticFriction.size());
    double mean = 0.0;
    double squares = 0.0;
    for (const StaticFrictionPoint& point : result.staticFriction) {
        mean += std::fabs(point.current_A) / count;
    }
    for (const StaticFrictionPoint& point : result.staticFriction) {
        squares += (std::fabs(point.current_A) - mean) * (std::fabs(point.current_A) - mean);
    }
    const double half =
        control::studentQuantile(0.975, count - 1.0) * std::sqrt(squares / (count - 1.0) / count);
    result.figures.push_back({"static_friction.current", "A",
                              control::Estimate{mean, std::pair(mean - half, mean + half),
                                                control::EstimateSource::Identified, "A"}});
}

} // namespace

Result<void> calibrateStray(devices::Device& device, const CalibrateConfig& config,
                            const ProcedureObserver& observer, CalibrateResult& result) {
    using namespace standstill;
    // One phase may carry all of it.
    const double meanSquare_A2 = StrayMeanSquare_ratio * config.strayCurrent_A * config.strayCurrent_A;
    if (auto admitted = admitHeat(device, observer, meanSquare_A2, StrayAngles * StrayDuration_s, Pause_degC,
                                  Refuse_degC);
        !admitted) {
        return failure(admitted.error());
    }
    const auto before_K = readSensorExcess_K(device);
    if (!before_K) {
        return failure(before_K.error());
    }
    std::vector<control::StrayRecord> records;
    for (int i = 0; i < StrayAngles; ++i) {
        auto recording = recordAt(device, config, observer, dAxisLevels(config.strayCurrent_A, StrayDwell_s),
                                  StrayDuration_s);
        if (!recording) {
            return failure(recording.error());
        }
        records.push_back(strayRecord(*recording, 0));
        if (auto moved = nudge(device, config, observer); !moved) {
            return moved;
        }
    }
    const auto fit = control::fitStray(records);
    if (!fit) {
        refuse(result, "stray_not_calibrated", fit.error());
        return {};
    }
    const auto after_K = readSensorExcess_K(device);
    if (!after_K) {
        return failure(after_K.error());
    }
    // Warm coils change the scale of the readings, which the angle does not feel but this coefficient does.
    const double heat_ratio = sensorTemperature_per_K(device.catalogue()) * std::max(*before_K, *after_K);
    const double value = fit->coefficient_T_per_A;
    const double half =
        control::studentQuantile(0.975, fit->freedom) * fit->error_T_per_A + heat_ratio * std::fabs(value);
    result.figures.push_back({"stray.coefficient", "T/A",
                              control::Estimate{value, std::pair(value - half, value + half),
                                                control::EstimateSource::Identified, "T/A"}});
    result.proposed.push_back({"stray.coefficient", value});
    return {};
}

Result<void> calibrateStaticFriction(devices::Device& device, const CalibrateConfig& config,
                                     const ProcedureObserver& observer, CalibrateResult& result) {
    const double meanSquare_A2 = config.frictionCurrent_A * config.frictionCurrent_A / 3.0;
    if (auto admitted =
            admitHeat(device, observer, meanSquare_A2, 10.0 * config.frictionStarts, Pause_degC, Refuse_degC);
        !admitted) {
        return failure(admitted.error());
    }
    // First all starts of one direction: each goes on where the last one came to rest, more than 0.8 rad
    // further, so that they spread over the turn. The other direction turns all of it back.
    for (int i = 0; i < 2 * config.frictionStarts; ++i) {
        const double sign = i < config.frictionStarts ? 1.0 : -1.0;
        const auto recording = rampOnce(device, config, observer, sign * config.frictionCurrent_A);
        if (!recording) {
            return failure(recording.error());
        }
        const std::vector<double> angle = recording->column("position");
        const auto start =
            control::findBreakaway(recording->time_s, angle, recording->column("current_command"));
        if (start) {
            result.staticFriction.push_back({angle.front(), start->current_A});
        }
    }
    constexpr std::size_t FewestStarts = 3;
    if (result.staticFriction.size() < FewestStarts) {
        refuse(result, "static_friction_not_found",
               Error{ErrorCode::Refused, "the rotor broke away in too few ramps", "use a higher current"});
        return {};
    }
    addStaticFriction(result);
    return {};
}

} // namespace halbench::app
