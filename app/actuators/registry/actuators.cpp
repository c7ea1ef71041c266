#include "app/actuators/actuator.h"
#include "app/actuators/htm/motor_procedures.h"
#include "app/actuators/planar/platen_procedures.h"
#include "app/actuators/spherical/sensing_needs.h"
#include "app/actuators/spherical/sensing_procedures.h"

#include <algorithm>
#include <vector>

namespace halbench::app {

namespace {

std::vector<Actuator>& table() {
    static std::vector<Actuator> rows{motorActuator(), platenActuator(), sensingActuator()};
    return rows;
}

} // namespace

std::span<const Actuator> actuators() {
    return table();
}

void addActuator(const Actuator& actuator) {
    const auto known = std::find_if(table().begin(), table().end(),
                                    [&](const Actuator& row) { return row.model == actuator.model; });
    if (known != table().end()) {
        *known = actuator;
    } else {
        table().push_back(actuator);
    }
}

const Actuator& actuatorOf(std::string_view model) {
    const std::span<const Actuator> rows = actuators();
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const Actuator& row) { return row.model == model; });
    return found == rows.end() ? rows.front() : *found;
}

Result<void> writeChosenValues(devices::Device& device, std::span<const ParameterValue> values) {
    const Actuator& actuator = actuatorOf(device.info().model);
    if (actuator.checkTogether != nullptr) {
        if (auto checked = actuator.checkTogether(device, values); !checked) {
            return checked;
        }
    }
    return device.writeParameters(values);
}

MotionNeedsFunction motionNeedsOf(std::string_view model) {
    return model == sensingActuator().model ? sensingNeeds : nullptr;
}

} // namespace halbench::app
