#include "devices/simulated/registry/simulated_models.h"

#include "devices/simulated/htm/simulated_htm.h"
#include "devices/simulated/planar/simulated_planar.h"
#include "devices/simulated/spherical/simulated_spherical.h"

#include <algorithm>

namespace halbench::devices {
namespace {

// A deque, since devices keep pointers to their row while tests add others.
std::deque<SimulatedModel>& table() {
    static std::deque<SimulatedModel> models{htmModel(), planarModel(), sphericalModel()};
    return models;
}

} // namespace

const std::deque<SimulatedModel>& simulatedModels() {
    return table();
}

void addSimulatedModel(SimulatedModel model) {
    const auto known = std::find_if(table().begin(), table().end(),
                                    [&](const SimulatedModel& row) { return row.name == model.name; });
    if (known != table().end()) {
        *known = std::move(model);
    } else {
        table().push_back(std::move(model));
    }
}

const SimulatedModel* findSimulatedModel(const std::string& name) {
    const auto found = std::find_if(table().begin(), table().end(),
                                    [&](const SimulatedModel& row) { return row.name == name; });
    return found == table().end() ? nullptr : &*found;
}

} // namespace halbench::devices
