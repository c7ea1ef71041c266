#include "app/cli/loop_tables.h"

#include "app/documents/text/numbers.h"
#include "app/documents/text/output_file.h"
#include "app/procedures/tune/disturbance.h"
#include "app/procedures/tune/loop_uncertainty.h"
#include "control/base/assert.h"
#include "control/base/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace halbench::app {

namespace {

Result<void> writeColumns(const std::string& path, const std::string& header,
                          const std::vector<const std::vector<double>*>& columns) {
    std::string text = header + "\n";
    for (std::size_t row = 0; row < columns.front()->size(); ++row) {
        for (std::size_t column = 0; column < columns.size(); ++column) {
            const double value = (*columns[column])[row];
            text += column == 0 ? "" : ",";
            text += std::isfinite(value) ? formatNumber(value) : std::string(); // a band that is not known
        }
        text += '\n';
    }
    return writeFile(path, text);
}

/// Closed loop: factor 1. A line each, so that any program can draw it.
Result<void> writePoles(const std::string& path, const AnalysisResult::Roots& roots) {
    std::string text = "kind,branch,gain_factor,real,imaginary\n";
    const auto add = [&text](const char* kind, std::size_t branch, double factor,
                             std::complex<double> place) {
        text += fmt::format("{},{},{},{},{}\n", kind, branch, formatNumber(factor),
                            formatNumber(place.real()), formatNumber(place.imag()));
    };
    const auto addAll = [&add](const char* kind, double factor,
                               const std::vector<std::complex<double>>& places) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            add(kind, i, factor, places[i]);
        }
    };
    addAll("zero", 0.0, roots.zeros);
    addAll("open", 0.0, roots.openLoop);
    addAll("closed", 1.0, roots.closedLoop);
    for (std::size_t branch = 0; branch < roots.locus.branch.size(); ++branch) {
        for (std::size_t i = 0; i < roots.locus.gain.size(); ++i) {
            add("locus", branch, roots.locus.gain[i], roots.locus.branch[branch][i]);
        }
    }
    return writeFile(path, text);
}

/// The columns of a band; empty cells where nothing is known of it.
control::Band columnsOf(const control::Band& band, std::size_t rows) {
    const std::vector<double> unknown(rows, std::numeric_limits<double>::quiet_NaN());
    const bool isKnown = band.p5.size() == rows;
    return isKnown ? band : control::Band{unknown, unknown};
}

using Motors = std::vector<control::PositionPlant>;

/// The motors that the uncertainty allows; none for a model without one.
Motors motorsOf(const TabledLoop& loop) {
    const auto plants = drawnPlants(loop.estimate, {TuneConfig().draws, loop.with.seed});
    return plants ? *plants : Motors();
}

/// The open loop with its bands.
Result<void> writeBode(const std::string& path, const AnalysisResult::Bode& bode, const TabledLoop& loop,
                       const Motors& motors) {
    std::vector<double> frequency_rad_s;
    for (const double frequency_Hz : bode.frequency_Hz) {
        frequency_rad_s.push_back(2.0 * Pi * frequency_Hz);
    }
    const std::size_t rows = bode.frequency_Hz.size();
    const auto bands = loopBandsOf(motors, loop.law, loop.conditions.timing, frequency_rad_s);
    const auto magnitude = columnsOf(bands ? bands->magnitude_dB : control::Band{}, rows);
    const auto phase = columnsOf(bands ? bands->phase_deg : control::Band{}, rows);
    return writeColumns(path,
                        "frequency_hz,magnitude_db,phase_deg,magnitude_p5_db,magnitude_p95_db,phase_p5_deg,"
                        "phase_p95_deg",
                        {&bode.frequency_Hz, &bode.magnitude_dB, &bode.phase_deg, &magnitude.p5,
                         &magnitude.p95, &phase.p5, &phase.p95});
}

/// "Nm" of "N*m": as columns of recordings are named.
std::string unitOfColumn(std::string unit) {
    std::erase(unit, '*');
    return unit;
}

std::string stepHeader(const LoopConditions& conditions) {
    if (!conditions.axis) {
        return "time_s,response_rad,current_A,load_angle_rad,load_current_A,response_p5_rad,"
               "response_p95_rad,load_angle_p5_rad,load_angle_p95_rad";
    }
    const std::string position = unitOfColumn(conditions.axis->positionUnit);
    const std::string effort = unitOfColumn(conditions.axis->effortUnit);
    return fmt::format("time_s,response_{0},effort_{1},load_position_{0},load_effort_{1},response_p5_{0},"
                       "response_p95_{0},load_position_p5_{0},load_position_p95_{0}",
                       position, effort);
}

/// A step of the reference by one unit, and beside it what a load does, on the same times, with their bands;
/// none of an unstable loop.
Result<void> writeStep(const std::string& path, const AnalysisResult& result, const TabledLoop& loop,
                       const Motors& motors) {
    const AnalysisResult::Step& step = result.stepCurve;
    const double load = loop.with.load_A;
    const control::LoadStep loaded =
        disturbanceStep(loop.estimate, loop.law, loop.conditions, result, load).value_or(control::LoadStep{});
    HB_ASSERT(loaded.time_s.size() == step.time_s.size());
    const std::size_t rows = step.time_s.size();
    const double end_s = rows > 0 ? step.time_s.back() : 0.0;
    const control::LoopTiming& timing = loop.conditions.timing;
    const auto answer = stepBandOf(motors, loop.law, timing, 1.0, {end_s, step.pointsPerSample});
    const auto under = disturbanceEnvelopeOf(motors, loop.law, timing, load, {end_s, step.pointsPerSample});
    const auto response = columnsOf(answer ? answer->response_rad : control::Band{}, rows);
    const auto angle = columnsOf(under ? under->angle_rad : control::Band{}, rows);
    return writeColumns(path, stepHeader(loop.conditions),
                        {&step.time_s, &step.response_rad, &step.current_A, &loaded.angle_rad,
                         &loaded.current_A, &response.p5, &response.p95, &angle.p5, &angle.p95});
}

} // namespace

Result<void> writeLoopTables(const LoopTableFiles& files, const TabledLoop& loop,
                             const AnalysisResult& result) {
    const bool needsMotors = !files.bode.empty() || !files.step.empty();
    const Motors motors = needsMotors ? motorsOf(loop) : Motors();
    Result<void> done;
    if (!files.bode.empty()) {
        done = writeBode(files.bode, result.bode, loop, motors);
    }
    if (done && !files.step.empty()) {
        done = writeStep(files.step, result, loop, motors);
    }
    return done && !files.poles.empty() ? writePoles(files.poles, result.roots) : done;
}

} // namespace halbench::app
