#include "app/procedures/base/axis_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace halbench::app {
namespace {

std::string nameOr(const std::string& name, const std::string& role) {
    return name.empty() ? role : name;
}

std::string listOf(const std::vector<devices::AxisSpec>& axes) {
    std::vector<std::string> names;
    for (const devices::AxisSpec& axis : axes) {
        names.push_back(axis.id);
    }
    return fmt::format("its axes are {}", fmt::join(names, ", "));
}

} // namespace

std::vector<devices::AxisSpec> axesOf(const devices::Catalogue& catalogue) {
    if (!catalogue.axes.empty()) {
        return catalogue.axes;
    }
    return {devices::AxisSpec{}};
}

Result<devices::AxisSpec> chosenAxis(const devices::Catalogue& catalogue, const std::string& name) {
    const std::vector<devices::AxisSpec> axes = axesOf(catalogue);
    if (name.empty() && axes.size() == 1) {
        return axes.front();
    }
    if (name.empty()) {
        return failure(ErrorCode::Usage, "the device has several axes; no axis selected",
                       listOf(axes) + "; choose one with --axis, in an experiment with the key 'axis'");
    }
    for (const devices::AxisSpec& axis : axes) {
        if (axis.id == name) {
            return axis;
        }
    }
    if (name == "all") {
        return failure(ErrorCode::Usage, "axes can be moved one at a time only",
                       listOf(axes) + "; move one axis at a time");
    }
    return failure(ErrorCode::UnknownName, fmt::format("the device has no axis '{}'", name), listOf(axes));
}

Result<std::vector<devices::AxisSpec>> chosenAxes(const devices::Catalogue& catalogue,
                                                  const std::string& name) {
    if (name.empty() || name == "all") {
        return axesOf(catalogue);
    }
    const auto axis = chosenAxis(catalogue, name);
    return axis ? Result<std::vector<devices::AxisSpec>>(std::vector{*axis}) : failure(axis.error());
}

devices::Catalogue catalogueOfAxis(const devices::Catalogue& catalogue, const devices::AxisSpec& axis) {
    devices::Catalogue own = catalogue;
    own.axes = {axis};
    const auto bare = [&](const std::string& role) {
        for (const devices::AxisSpec& other : catalogue.axes) {
            const std::string part = "." + other.id;
            const std::size_t at = role.find('.');
            if (at != std::string::npos && (role.compare(at, std::string::npos, part) == 0 ||
                                            role.compare(at, part.size() + 1, part + ".") == 0)) {
                return other.id == axis.id ? role.substr(0, at) + role.substr(at + part.size())
                                           : std::string();
            }
        }
        return role;
    };
    for (ParameterSpec& parameter : own.parameters) {
        parameter.role = bare(parameter.role);
    }
    for (SignalSpec& signal : own.signals) {
        signal.role = signal.role == axis.roles.effort ? "current_command" : bare(signal.role);
    }
    return own;
}

std::string signalOf(const devices::Catalogue& catalogue, const std::string& role) {
    return nameOr(catalogue.signalForRole(role), role);
}

std::string parameterOf(const devices::Catalogue& catalogue, const std::string& role) {
    return nameOr(catalogue.parameterForRole(role), role);
}

} // namespace halbench::app
