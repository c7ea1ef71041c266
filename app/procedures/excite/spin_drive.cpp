#include "app/procedures/excite/spin_drive.h"

#include "app/procedures/base/coil_forecast.h"
#include "control/base/assert.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {
namespace {

constexpr double ShapePlateaus = 7.0;

void addIfKnown(const devices::Catalogue& catalogue, std::vector<ParameterValue>& values,
                const std::string& name, double value) {
    if (catalogue.findParameter(name) != nullptr) {
        values.push_back({name, value});
    }
}

std::vector<ParameterValue> generatorValues(const PlateauRun& run) {
    std::vector<ParameterValue> values{{"reference.start", 0.0},
                                       {"hb.setpoint", 0.0},
                                       {"hb.mode", static_cast<double>(devices::BoardMode::Current)},
                                       {"reference.shape", ShapePlateaus},
                                       {"reference.base", 0.0},
                                       {"plateau.dwell", run.dwell_s},
                                       {"plateau.count", static_cast<double>(run.currents_A.size())}};
    for (std::size_t i = 0; i < run.currents_A.size(); ++i) {
        values.push_back({fmt::format("plateau.current_{}", i + 1), run.currents_A[i]});
    }
    values.push_back({"reference.start", 1.0});
    return values;
}

// The warmest start from which the run stays below the limit.
double admissibleStart_degC(const devices::Device& device, const PlateauRun& run, const HeatLimits& heat) {
    const auto model = coilModel(device.catalogue());
    double start_degC = heat.pause_degC;
    while (start_degC > 20.0 && forecastCoil_degC(model, {start_degC, start_degC}, run.meanSquare_A2(),
                                                  run.duration_s()) > heat.refuse_degC) {
        start_degC -= 1.0;
    }
    return start_degC;
}

/// Foresees when a rotor gets too fast: its speed is seen late, and current drives it until the board is
/// told.
class SpeedGuard {
public:
    SpeedGuard(const SpeedWatch& watch, const PlateauRun& run) : m_watch(watch), m_run(run) {}

    /// Time until it has to be looked at again: ten times a second, more often where it gains speed so fast
    /// that it could reach the limit meanwhile.
    double nextLook_s() const {
        constexpr double Longest_s = 0.1;
        constexpr double Shortest_s = 0.02;
        const double room_rad_s = limit_rad_s() - m_seen_rad_s;
        const double half_s = m_gained_rad_s2 > 0.0 ? 0.5 * room_rad_s / m_gained_rad_s2 : Longest_s;
        return std::clamp(half_s, Shortest_s, Longest_s);
    }

    /// Whether it must end, `piece_s` after the last look.
    bool isDue(double piece_s) {
        constexpr double Reaction_s = 0.03; // a row of the stream, the link there and back
        m_gained_rad_s2 = (m_watch.highest_rad_s() - m_seen_rad_s) / piece_s;
        m_seen_rad_s = m_watch.highest_rad_s();
        return m_seen_rad_s > m_run.mayReach_rad_s ||
               m_seen_rad_s + Reaction_s * m_gained_rad_s2 > limit_rad_s();
    }

private:
    double limit_rad_s() const { return m_run.neverAbove_rad_s.value_or(m_run.mayReach_rad_s); }

    const SpeedWatch& m_watch;
    const PlateauRun& m_run;
    double m_seen_rad_s = 0.0;
    double m_gained_rad_s2 = 0.0; ///< since the last look
};

// Waits until the generator is through; ends it early before the rotor gets too fast.
Result<RunEnd> waitForEnd(devices::Device& device, const ProcedureObserver& observer, const PlateauRun& run,
                          const SpeedWatch& watch) {
    const double end_s = device.clock().now_s() + run.duration_s();
    SpeedGuard guard(watch, run);
    while (device.clock().now_s() < end_s) {
        const double piece_s = std::min(guard.nextLook_s(), end_s - device.clock().now_s() + 1e-3);
        const double done = 1.0 - (end_s - device.clock().now_s()) / run.duration_s();
        if (auto waited = waitObserved(device, observer, piece_s, done, done, run.text); !waited) {
            return failure(waited.error());
        }
        if (guard.isDue(piece_s)) {
            const ParameterValue stop[] = {{"reference.start", 0.0}};
            if (auto stopped = device.writeParameters(stop); !stopped) {
                return failure(stopped.error());
            }
            constexpr double CoastDown_s = 1.5;
            const auto rested = waitObserved(device, observer, CoastDown_s, done, 1.0, run.text);
            return rested ? Result<RunEnd>(RunEnd::TooFast) : failure(rested.error());
        }
    }
    return RunEnd::Complete;
}

} // namespace

double PlateauRun::meanSquare_A2() const {
    double sum = 0.0;
    for (const double current : currents_A) {
        sum += 0.5 * current * current;
    }
    return currents_A.empty() ? 0.0 : sum / static_cast<double>(currents_A.size());
}

void SpeedWatch::take(const SampleBlock& block) {
    const int column = block.layout->indexOf(m_signal);
    for (std::size_t row = 0; column >= 0 && row < block.rows(); ++row) {
        m_highest_rad_s =
            std::max(m_highest_rad_s, std::fabs(block.value(row, static_cast<std::size_t>(column))));
    }
}

Result<void> prepareSpinning(devices::Device& device, double speedLimit_rad_s) {
    std::vector<ParameterValue> values;
    const devices::Catalogue& catalogue = device.catalogue();
    addIfKnown(catalogue, values, "window.speed", speedLimit_rad_s);
    addIfKnown(catalogue, values, "window.speed_enabled", 1.0);
    addIfKnown(catalogue, values, "window.position_enabled", 0.0);
    addIfKnown(catalogue, values, "commutation.divider", 1.0);
    addIfKnown(catalogue, values, "commutation.advance", 0.0);
    addIfKnown(catalogue, values, "decode.method", 0.0);
    addIfKnown(catalogue, values, "stray.enabled", 1.0);
    return device.writeParameters(values);
}

Result<RunEnd> runPlateaus(devices::Device& device, const ProcedureObserver& observer, const PlateauRun& run,
                           const HeatLimits& heat, SpeedWatch& watch) {
    HB_ASSERT(!run.currents_A.empty() && run.currents_A.size() <= 32 && run.dwell_s > 0.0);
    const double start_degC = admissibleStart_degC(device, run, heat);
    if (auto admitted =
            admitHeat(device, observer, run.meanSquare_A2(), run.duration_s(), start_degC, heat.refuse_degC);
        !admitted) {
        return failure(admitted.error());
    }
    if (auto armed = device.arm(); !armed) {
        return failure(armed.error());
    }
    watch.reset();
    if (auto started = device.writeParameters(generatorValues(run)); !started) {
        return failure(started.error());
    }
    const auto ended = waitForEnd(device, observer, run, watch);
    if (!ended) {
        return ended;
    }
    const auto disarmed = device.disarm();
    return disarmed ? ended : failure(disarmed.error());
}

} // namespace halbench::app
