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

Result<devices::AxisSpec> chosenAxis(const devices::Catalogue& catalogue, const std::string& name) {
    const std::vector<devices::AxisSpec> axes =
        catalogue.axes.empty() ? std::vector{devices::AxisSpec{}} : catalogue.axes;
    if (name.empty() && axes.size() == 1) {
        return axes.front();
    }
    if (name.empty()) {
        return failure(ErrorCode::Usage, "the device has several axes and none is named",
                       listOf(axes) + "; name one with --axis, in an experiment with the key 'axis'");
    }
    for (const devices::AxisSpec& axis : axes) {
        if (axis.id == name) {
            return axis;
        }
    }
    if (name == "all") {
        return failure(ErrorCode::Usage, "only one axis moves at a time, not all",
                       listOf(axes) + "; move one after the other");
    }
    return failure(ErrorCode::UnknownName, fmt::format("the device has no axis '{}'", name), listOf(axes));
}

std::string signalOf(const devices::Catalogue& catalogue, const std::string& role) {
    return nameOr(catalogue.signalForRole(role), role);
}

std::string parameterOf(const devices::Catalogue& catalogue, const std::string& role) {
    return nameOr(catalogue.parameterForRole(role), role);
}

} // namespace halbench::app
