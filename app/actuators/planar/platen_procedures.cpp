#include "app/actuators/planar/platen_procedures.h"

#include "app/actuators/planar/platen_calibrate.h"
#include "app/actuators/planar/platen_identify.h"

#include <array>

namespace halbench::app {
namespace {

constexpr std::array PlatenConstants = {KnownConstant{"m", "kg", "Moving mass"},
                                        KnownConstant{"Iz", "kg*m^2", "Inertia about the vertical"}};

} // namespace

Actuator platenActuator() {
    return {"planar",
            "Planar six-coil positioner",
            {setPlatenConstant, checkPlatenIdentify, predictPlatenIdentify, identifyPlaten},
            {nullptr, checkPlatenCalibrate, predictPlatenCalibrate, calibratePlaten},
            nullptr,
            {},
            PlatenConstants};
}

} // namespace halbench::app
