#include "app/procedures/apply/gain_transaction.h"

#include "app/procedures/base/procedure_steps.h"
#include "control/base/assert.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halbench::app {

Result<void> checkValues(const devices::Catalogue& catalogue, const std::vector<ParameterValue>& values) {
    for (const ParameterValue& value : values) {
        const ParameterSpec* spec = catalogue.findParameter(value.name);
        if (spec == nullptr) {
            return failure(ErrorCode::UnknownName,
                           fmt::format("the device has no parameter '{}'", value.name),
                           "`halbench describe` lists the parameters.");
        }
        if (auto checked = checkParameterValue(*spec, value.value); !checked) {
            return checked;
        }
    }
    return {};
}

std::vector<std::string> namesOf(const std::vector<ParameterValue>& values) {
    std::vector<std::string> names;
    names.reserve(values.size());
    for (const ParameterValue& value : values) {
        names.push_back(value.name);
    }
    return names;
}

Result<std::vector<ParameterValue>> readBack(devices::Device& device,
                                             const std::vector<ParameterValue>& values) {
    const std::vector<std::string> names = namesOf(values);
    const auto read = device.readParameters(names);
    if (!read) {
        return failure(read.error());
    }
    std::vector<ParameterValue> result;
    for (std::size_t i = 0; i < names.size(); ++i) {
        result.push_back({names[i], (*read)[i]});
    }
    return result;
}

// The device keeps single precision: half a unit of its last place is 6e-8 of the value.
Result<void> compareValues(const std::vector<ParameterValue>& asked,
                           const std::vector<ParameterValue>& found) {
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (!(std::fabs(asked[i].value - found[i].value) <= 1e-6 * std::fabs(asked[i].value) + 1e-12)) {
            return failure(
                ErrorCode::DeviceRefused,
                fmt::format("{} reads {} after writing {}", asked[i].name, found[i].value, asked[i].value),
                "Old values restored. Check the device limits.");
        }
    }
    return {};
}

namespace {

/// Those of the snapshot that have the names of `values`, in their order.
std::vector<ParameterValue> beforeOf(const RestoreGuard& guard, const std::vector<ParameterValue>& values) {
    std::vector<ParameterValue> before;
    for (const ParameterValue& value : values) {
        const auto& snapshot = guard.snapshot();
        const auto old = std::find_if(snapshot.begin(), snapshot.end(),
                                      [&](const ParameterValue& each) { return each.name == value.name; });
        HB_ASSERT(old != snapshot.end());
        before.push_back(*old);
    }
    return before;
}

} // namespace

Result<ChangedValues> writeVerified(devices::Device& device, const RestoreGuard& guard,
                                    const std::vector<ParameterValue>& values,
                                    const ProcedureObserver& observer) {
    if (auto entered = enterState(observer, ProcedureState::Apply); !entered) {
        return failure(entered.error());
    }
    if (auto written = device.writeParameters(values); !written) {
        return failure(written.error());
    }
    auto after = readBack(device, values);
    if (!after) {
        return failure(after.error());
    }
    if (auto same = compareValues(values, *after); !same) {
        return failure(same.error());
    }
    return ChangedValues{beforeOf(guard, values), *std::move(after)};
}

Result<void> keepValues(devices::Device& device, const RestoreGuard& guard,
                        const std::vector<ParameterValue>& values) {
    std::vector<ParameterValue> others;
    for (const ParameterValue& old : guard.snapshot()) {
        const bool isNew = std::any_of(values.begin(), values.end(),
                                       [&](const ParameterValue& value) { return value.name == old.name; });
        if (!isNew) {
            others.push_back(old);
        }
    }
    return device.writeParameters(others);
}

} // namespace halbench::app
