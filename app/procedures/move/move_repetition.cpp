#include "app/procedures/move/move_repetition.h"

#include "app/procedures/base/axis_choice.h"

#include <algorithm>

namespace halbench::app {

namespace {

double firstPosition(const devices::Catalogue& catalogue, const MoveResult& result) {
    const Recording& recording = result.recording;
    const std::vector<double> truth = recording.column(signalOf(catalogue, result.axis.roles.truePosition));
    return truth.empty() ? recording.column(signalOf(catalogue, result.axis.roles.position)).front()
                         : truth.front();
}

} // namespace

std::optional<double> MoveRepetition::settled_ratio() const {
    if (!config.settled_rad || maxError_rad.empty()) {
        return std::nullopt;
    }
    const auto settled = std::count_if(maxError_rad.begin(), maxError_rad.end(),
                                       [this](double error) { return error <= *config.settled_rad; });
    return static_cast<double>(settled) / static_cast<double>(maxError_rad.size());
}

Result<RepeatedMove> runRepeatedMove(devices::Device& device, const MoveConfig& config,
                                     const RepeatConfig& repeat, const ProcedureObserver& observer) {
    RepeatedMove all;
    all.repetition.config = repeat;
    DataQuality quality;
    for (int run = 0; run < repeat.count; ++run) {
        Result<MoveResult> result = runMove(device, config, observer);
        if (!result) {
            return failure(result.error());
        }
        quality.verdict = std::max(quality.verdict, result->quality.verdict);
        quality.findings.insert(quality.findings.end(), result->quality.findings.begin(),
                                result->quality.findings.end());
        all.repetition.start_rad.push_back(firstPosition(device.catalogue(), *result));
        all.repetition.maxError_rad.push_back(result->figures().maxError);
        all.repetition.peakToPeak_rad.push_back(result->figures().peakToPeak);
        all.last = *std::move(result);
    }
    all.last.quality = std::move(quality);
    return all;
}

} // namespace halbench::app
