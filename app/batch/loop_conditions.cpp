#include "app/batch/loop_conditions.h"

#include "app/batch/model_file.h"
#include "devices/profile.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

LoopConditions fromConstants(const std::map<std::string, double>& constants) {
    const auto constant = [&](const char* name) -> std::optional<double> {
        const auto found = constants.find(name);
        return found == constants.end() ? std::nullopt : std::optional<double>(found->second);
    };
    LoopConditions conditions;
    conditions.timing.period_s = constant("T_s").value_or(conditions.timing.period_s);
    conditions.currentLimit_A = constant("I_max").value_or(conditions.currentLimit_A);
    if (const std::optional<double> field = constant("B_0")) {
        StrayField stray;
        stray.amplitude_T = *field;
        stray.coefficient_T_per_A = constant("k_s").value_or(0.0);
        conditions.stray = stray;
    }
    return conditions;
}

} // namespace

Result<LoopConditions> loopConditionsOf(const std::string& model) {
    const Result<std::optional<devices::Profile>> profile = devices::findProfile(model);
    if (!profile) {
        return failure(profile.error());
    }
    return fromConstants(*profile ? (*profile)->constants : std::map<std::string, double>{});
}

Result<LoopConditions> loopConditionsOf(devices::Device& device) {
    LoopConditions conditions = fromConstants(device.catalogue().knownConstants);
    const auto read = [&](const char* role) -> Result<std::optional<double>> {
        const std::string name = device.catalogue().parameterForRole(role);
        if (name.empty()) {
            return std::optional<double>{};
        }
        const std::vector<std::string> names{name};
        const Result<std::vector<double>> values = device.readParameters(names);
        return values ? Result<std::optional<double>>(values->front()) : failure(values.error());
    };
    const Result<std::optional<double>> delay = read("delay.samples");
    const Result<std::optional<double>> limit = read("limit.current");
    const Result<std::optional<double>> isCompensated = read("stray.enabled");
    const Result<std::optional<double>> coefficient = read("stray.coefficient");
    for (const auto* value : {&delay, &limit, &isCompensated, &coefficient}) {
        if (!*value) {
            return failure(value->error());
        }
    }
    conditions.timing.delay_samples = static_cast<int>(delay->value_or(0.0));
    conditions.currentLimit_A = limit->value_or(conditions.currentLimit_A);
    if (conditions.stray) {
        conditions.stray->isCompensated = isCompensated->value_or(1.0) != 0.0;
        conditions.stray->coefficient_T_per_A = coefficient->value_or(conditions.stray->coefficient_T_per_A);
    }
    return conditions;
}

std::optional<std::pair<double, double>> strayInterval(const CalibrateResult& calibration) {
    for (const CalibrationFigure& figure : calibration.figures) {
        if (figure.name == "stray.coefficient") {
            return figure.estimate.interval95;
        }
    }
    return std::nullopt;
}

void takeStrayInterval(LoopConditions& conditions,
                       const std::optional<std::pair<double, double>>& interval95_T_per_A) {
    if (conditions.stray && interval95_T_per_A) {
        const double used_T_per_A = conditions.stray->coefficient_T_per_A;
        conditions.stray->error_T_per_A = std::max(std::abs(used_T_per_A - interval95_T_per_A->first),
                                                   std::abs(used_T_per_A - interval95_T_per_A->second));
    }
}

Result<void> takeCalibration(LoopConditions& conditions, const std::string& path) {
    if (path.empty()) {
        return {};
    }
    const Result<CalibrationFile> file = readCalibrationFile(path);
    if (!file) {
        return failure(file.error());
    }
    if (!file->stray95_T_per_A) {
        return failure(ErrorCode::Refused, path + ": holds no stray coefficient",
                       "calibrate with 'stray' or 'all'");
    }
    if (conditions.stray && file->isApplied) {
        conditions.stray->coefficient_T_per_A = file->stray_T_per_A;
    }
    takeStrayInterval(conditions, file->stray95_T_per_A);
    return {};
}

} // namespace halbench::app
