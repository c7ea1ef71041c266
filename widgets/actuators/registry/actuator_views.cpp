#include "widgets/actuators/registry/actuator_views.h"

#include "widgets/actuators/htm/rotor_picture.h"
#include "widgets/actuators/planar/platen_view.h"
#include "widgets/actuators/spherical/sphere_picture.h"

#include <algorithm>

namespace halbench::widgets {
namespace {

std::deque<ActuatorView>& table() {
    static std::deque<ActuatorView> views{rotorActuatorView(), platenActuatorView(), sphereActuatorView()};
    return views;
}

} // namespace

const std::deque<ActuatorView>& actuatorViews() {
    return table();
}

void addActuatorView(ActuatorView view) {
    const auto known = std::find_if(table().begin(), table().end(),
                                    [&](const ActuatorView& row) { return row.id == view.id; });
    if (known != table().end()) {
        *known = std::move(view);
    } else {
        table().push_back(std::move(view));
    }
}

const ActuatorView* actuatorViewFor(const std::function<bool(const std::string& role)>& plays) {
    const auto found = std::find_if(table().begin(), table().end(), [&](const ActuatorView& view) {
        return std::all_of(view.needed.begin(), view.needed.end(), plays);
    });
    return found == table().end() ? nullptr : &*found;
}

} // namespace halbench::widgets
