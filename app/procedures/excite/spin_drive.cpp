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

// Waits until the generator is through; ends it early when the rotor gets too fast.
Result<void> waitForEnd(devices::Device& device, const ProcedureObserver& observer, const PlateauRun& run,
                        const SpeedWatch& watch) {
    constexpr double Piece_s = 0.1;
    const double end_s = device.clock().now_s() + run.duration_s();
    while (device.clock().now_s() < end_s) {
        const double piece_s = std::min(Piece_s, end_s - device.clock().now_s() + 1e-3);
        const double done = 1.0 - (end_s - device.clock().now_s()) / run.duration_s();
        if (auto waited = waitObserved(device, observer, piece_s, done, done, run.text); !waited) {
            return waited;
        }
        if (watch.highest_rad_s() > run.mayReach_rad_s) {
            const ParameterValue stop[] = {{"reference.start", 0.0}};
            if (auto stopped = device.writeParameters(stop); !stopped) {
                return stopped;
            }
            constexpr double CoastDown_s = 1.5;
            return waitObserved(device, observer, CoastDown_s, done, 1.0, run.text);
        }
    }
    return {};
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

Result<void> runPlateaus(devices::Device& device, const ProcedureObserver& observer, const PlateauRun& run,
                         const HeatLimits& heat, SpeedWatch& watch) {
    HB_ASSERT(!run.currents_A.empty() && run.currents_A.size() <= 32 && run.dwell_s > 0.0);
    const double start_degC = admissibleStart_degC(device, run, heat);
    if (auto admitted =
            admitHeat(device, observer, run.meanSquare_A2(), run.duration_s(), start_degC, heat.refuse_degC);
        !admitted) {
        return failure(admitted.error());
    }
    if (auto armed = device.arm(); !armed) {
        return armed;
    }
    watch.reset();
    if (auto started = device.writeParameters(generatorValues(run)); !started) {
        return started;
    }
    if (auto ended = waitForEnd(device, observer, run, watch); !ended) {
        return ended;
    }
    return device.disarm();
}

} // namespace halbench::app
