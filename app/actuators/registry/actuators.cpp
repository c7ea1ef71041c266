#include "app/actuators/actuator.h"
#include "app/actuators/htm/motor_procedures.h"
#include "app/actuators/planar/platen_procedures.h"
#include "app/actuators/spherical/sensing_needs.h"
#include "app/actuators/spherical/sensing_procedures.h"

#include <algorithm>
#include <array>

namespace halbench::app {

std::span<const Actuator> actuators() {
    static const std::array Rows = {motorActuator(), platenActuator(), sensingActuator()};
    return Rows;
}

const Actuator& actuatorOf(std::string_view model) {
    const std::span<const Actuator> rows = actuators();
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const Actuator& row) { return row.model == model; });
    return found == rows.end() ? rows.front() : *found;
}

MotionNeedsFunction motionNeedsOf(std::string_view model) {
    return model == sensingActuator().model ? sensingNeeds : nullptr;
}

} // namespace halbench::app
