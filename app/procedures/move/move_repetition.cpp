#include "app/procedures/move/move_repetition.h"

#include "app/procedures/base/axis_choice.h"
#include "app/procedures/excite/table_reference.h"
#include "app/procedures/excite/travel_reference.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace halbench::app {

namespace {

double firstPosition(const devices::Catalogue& catalogue, const MoveResult& result) {
    const Recording& recording = result.recording;
    const std::vector<double> truth = recording.column(signalOf(catalogue, result.axis.roles.truePosition));
    return truth.empty() ? recording.column(signalOf(catalogue, result.axis.roles.position)).front()
                         : truth.front();
}

/// The same motion the other way.
MoveConfig reversed(MoveConfig config) {
    MoveReference& reference = config.reference;
    reference.amplitude = -reference.amplitude;
    reference.rate = isTravel(reference) ? reference.rate : -reference.rate; // a travel has a speed limit
    reference.base = -reference.base;
    return config;
}

void add(MoveRepetition& repetition, const devices::Catalogue& catalogue, const MoveResult& result) {
    const MoveFigures& figures = result.figures();
    repetition.start.push_back(firstPosition(catalogue, result));
    repetition.maxError.push_back(figures.maxError);
    repetition.peakToPeak.push_back(figures.peakToPeak);
    repetition.windowTime_s.push_back(figures.windowTime_s);
}

} // namespace

std::optional<double> MoveRepetition::settled_ratio() const {
    if (!config.settled || maxError.empty()) {
        return std::nullopt;
    }
    std::ptrdiff_t settled = 0;
    if (settlesAfterWay) {
        settled = std::count_if(windowTime_s.begin(), windowTime_s.end(),
                                [](const std::optional<double>& time_s) { return time_s.has_value(); });
    } else {
        settled = std::count_if(maxError.begin(), maxError.end(),
                                [this](double error) { return error <= *config.settled; });
    }
    return static_cast<double>(settled) / static_cast<double>(maxError.size());
}

std::optional<SettlingTimes> MoveRepetition::settlingTimes() const {
    std::vector<double> times_s;
    for (const std::optional<double>& time_s : windowTime_s) {
        if (time_s) {
            times_s.push_back(*time_s);
        }
    }
    if (times_s.empty()) {
        return std::nullopt;
    }
    std::sort(times_s.begin(), times_s.end());
    const std::size_t count = times_s.size();
    SettlingTimes result;
    result.count = static_cast<int>(count);
    result.least_s = times_s.front();
    result.largest_s = times_s.back();
    result.median_s = 0.5 * (times_s[(count - 1) / 2] + times_s[count / 2]);
    result.mean_s = std::accumulate(times_s.begin(), times_s.end(), 0.0) / static_cast<double>(count);
    double square_s2 = 0.0;
    for (const double time_s : times_s) {
        square_s2 += (time_s - result.mean_s) * (time_s - result.mean_s);
    }
    result.deviation_s = count > 1 ? std::sqrt(square_s2 / static_cast<double>(count - 1)) : 0.0;
    return result;
}

Result<RepeatedMove> runRepeatedMove(devices::Device& device, const MoveConfig& config,
                                     const RepeatConfig& repeat, const ProcedureObserver& observer) {
    if (repeat.alternates && movesSeveralAxes(config.reference)) {
        return failure(ErrorCode::InvalidInput, "a path does not alternate its direction",
                       "repeat it as it is: it ends where its last line ends");
    }
    RepeatedMove all;
    all.repetition.config = repeat;
    all.repetition.settlesAfterWay = isTravel(config.reference);
    MoveConfig forth = config;
    forth.settlingWindow = repeat.settled;
    forth.settlingUnit = repeat.settledUnit;
    const MoveConfig back = reversed(forth);
    DataQuality quality;
    for (int run = 0; run < repeat.count; ++run) {
        const bool goesBack = repeat.alternates && run % 2 == 1;
        Result<MoveResult> result = runMove(device, goesBack ? back : forth, observer);
        if (!result) {
            return failure(result.error());
        }
        quality.verdict = std::max(quality.verdict, result->quality.verdict);
        quality.findings.insert(quality.findings.end(), result->quality.findings.begin(),
                                result->quality.findings.end());
        add(all.repetition, device.catalogue(), *result);
        all.last = *std::move(result);
    }
    all.last.quality = std::move(quality);
    return all;
}

} // namespace halbench::app
