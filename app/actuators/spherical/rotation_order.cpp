#include "app/actuators/spherical/rotation_order.h"

namespace halbench::app {

std::string orientationOrder() {
    return "gamma about Z first, then beta about Y, then alpha about X";
}

std::string placementOrder(models::SensorFrames frames) {
    switch (frames) {
    case models::SensorFrames::Xyz:
        return orientationOrder();
    case models::SensorFrames::Natural:
        return "alpha about X first, then beta about Y, then gamma about Z, without the roll about the "
               "radius";
    case models::SensorFrames::Zyx:
        break;
    }
    return "alpha about X first, then beta about Y, then gamma about Z";
}

} // namespace halbench::app
