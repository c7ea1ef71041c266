#include "app/tuning/axis_conditions.h"

#include "app/procedures/tune/loop_axis.h"
#include "app/tuning/loop_conditions.h"
#include "devices/profile.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace halbench::app {
namespace {

/// Of an axis that no profile describes.
LoopAxis unknownAxis(const IdentifiedAxis& axis) {
    return {axis.axis, axis.positionUnit, axis.effortUnit, 0.0, LoopAxis::usualStep(axis.positionUnit)};
}

double effortLimitOf(const devices::AxisSpec& spec, double current_ratio) {
    return spec.effortLimit > 0.0 ? current_ratio * spec.effortLimit : UnknownEffortLimit;
}

} // namespace

Result<AxisConditions> axisConditionsOf(const AxisModelFile& model, const std::vector<std::string>& axes) {
    const std::string name = model.header.device ? model.header.device->model : "";
    const Result<std::optional<devices::Profile>> profile = devices::findProfile(name);
    const Result<LoopConditions> common = loopConditionsOf(name);
    if (!profile || !common) {
        return failure(!profile ? profile.error() : common.error());
    }
    const std::vector<devices::AxisSpec> specs =
        *profile ? (*profile)->axes : std::vector<devices::AxisSpec>{};
    AxisConditions result;
    for (const std::string& id : axes) {
        const IdentifiedAxis& axis = *model.model.find(id);
        const auto spec =
            std::find_if(specs.begin(), specs.end(), [&](const auto& known) { return known.id == id; });
        LoopConditions conditions;
        conditions.timing = timingOr(axis.timing, common->timing);
        conditions.currentLimit_A = spec == specs.end() ? UnknownEffortLimit : effortLimitOf(*spec, 1.0);
        conditions.axis = spec == specs.end() ? unknownAxis(axis) : loopAxisOf(*spec);
        result.push_back(std::move(conditions));
    }
    return result;
}

namespace {

Result<AxisConditions> conditionsOf(const devices::Catalogue& catalogue, const LoopConditions& common,
                                    const std::vector<std::string>& axes) {
    const auto largest = catalogue.knownConstants.find("I_max");
    const double current_ratio =
        largest == catalogue.knownConstants.end() ? 1.0 : common.currentLimit_A / largest->second;
    AxisConditions result;
    for (const std::string& id : axes) {
        const devices::AxisSpec* spec = catalogue.findAxis(id);
        if (spec == nullptr) {
            std::vector<std::string> names;
            for (const devices::AxisSpec& known : catalogue.axes) {
                names.push_back(known.id);
            }
            return failure(ErrorCode::UnknownName, fmt::format("the device has no axis '{}'", id),
                           names.empty() ? "it has a single loop: give the model of that"
                                         : fmt::format("its axes are {}", fmt::join(names, ", ")));
        }
        LoopConditions conditions;
        conditions.timing = common.timing;
        conditions.currentLimit_A = effortLimitOf(*spec, current_ratio);
        conditions.axis = loopAxisOf(*spec);
        result.push_back(std::move(conditions));
    }
    return result;
}

} // namespace

Result<AxisConditions> axisConditionsOf(devices::Device& device, const std::vector<std::string>& axes) {
    const Result<LoopConditions> common = loopConditionsOf(device);
    return common ? conditionsOf(device.catalogue(), *common, axes) : failure(common.error());
}

Result<AxisConditions> axisConditionsOf(const devices::Catalogue& catalogue,
                                        const std::map<std::string, double>& values,
                                        const std::vector<std::string>& axes) {
    return conditionsOf(catalogue, loopConditionsOf(catalogue, values), axes);
}

Result<AxisLaws> lawsOf(const AxisGainsFile& file, const std::vector<std::string>& axes) {
    AxisLaws result;
    for (const std::string& id : axes) {
        const auto found = std::find(file.axes.begin(), file.axes.end(), id);
        if (found == file.axes.end()) {
            return failure(ErrorCode::UnknownName, fmt::format("the gains have no axis '{}'", id),
                           fmt::format("they are of {}: name one with --axis", fmt::join(file.axes, ", ")));
        }
        const GainsFile& gains = file.gains[static_cast<std::size_t>(found - file.axes.begin())];
        result.laws.push_back(gains.loopLaw());
        result.timings.push_back(gains.timing);
        result.methods.push_back(gains.method.empty() ? "file" : gains.method);
    }
    return result;
}

} // namespace halbench::app
