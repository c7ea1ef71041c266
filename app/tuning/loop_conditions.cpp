#include "app/tuning/loop_conditions.h"

#include "app/procedures/base/doubtful_source.h"
#include "devices/profile.h"

#include <algorithm>
#include <cmath>

namespace halbench::app {

namespace {

/// What a device can say itself.
constexpr const char* ReadRoles[] = {"delay.samples", "limit.current", "stray.enabled", "stray.coefficient"};

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
        stray.sensorTemperature_per_K = constant("S_TC").value_or(0.0);
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

Result<LoopConditions> loopConditionsOf(const ModelFile& model) {
    Result<LoopConditions> conditions = loopConditionsOf(model.device ? model.device->model : "");
    if (conditions) {
        conditions->timing = timingOr(model.estimate.timing, conditions->timing);
    }
    return conditions;
}

LoopConditions loopConditionsOf(const devices::Catalogue& catalogue,
                                const std::map<std::string, double>& values) {
    LoopConditions conditions = fromConstants(catalogue.knownConstants);
    const auto value = [&](const char* role, double otherwise) {
        const auto found = values.find(catalogue.parameterForRole(role));
        return found == values.end() ? otherwise : found->second;
    };
    conditions.timing.delay_samples = static_cast<int>(value("delay.samples", 0.0));
    conditions.currentLimit_A = value("limit.current", conditions.currentLimit_A);
    if (conditions.stray) {
        conditions.stray->isCompensated = value("stray.enabled", 1.0) != 0.0;
        conditions.stray->coefficient_T_per_A =
            value("stray.coefficient", conditions.stray->coefficient_T_per_A);
    }
    return conditions;
}

Result<LoopConditions> loopConditionsOf(devices::Device& device) {
    std::vector<std::string> names;
    for (const char* role : ReadRoles) {
        if (std::string name = device.catalogue().parameterForRole(role); !name.empty()) {
            names.push_back(std::move(name));
        }
    }
    const Result<std::vector<double>> read = device.readParameters(names);
    if (!read) {
        return failure(read.error());
    }
    std::map<std::string, double> values;
    for (std::size_t i = 0; i < names.size(); ++i) {
        values[names[i]] = (*read)[i];
    }
    return loopConditionsOf(device.catalogue(), values);
}

std::optional<std::pair<double, double>> strayInterval(const CalibrateResult& calibration) {
    for (const CalibrationFigure& figure : calibration.figures) {
        if (figure.name == "stray.coefficient") {
            return figure.estimate.interval95;
        }
    }
    return std::nullopt;
}

std::vector<Finding> calibrationDoubts(const CalibrateResult& calibration) {
    return doubtsOfCalibration(calibration.quality);
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
    if (file->quality.verdict == Verdict::Refused) {
        return failure(ErrorCode::Refused, path + ": this calibration was refused",
                       "see its findings, then calibrate again");
    }
    conditions.doubts = doubtsOfCalibration(file->quality);
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
