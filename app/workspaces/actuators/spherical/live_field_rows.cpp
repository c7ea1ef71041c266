#include "app/workspaces/actuators/spherical/live_field_rows.h"

#include "app/actuators/spherical/sensing_board.h"
#include "app/workbench/drive_ability.h"
#include "app/workbench/signals/last_rows.h"

#include <memory>

namespace halbench::app {

namespace {

constexpr std::size_t MostRows = std::size_t{1} << 15;

std::vector<std::string> rolesOf(const devices::Catalogue& catalogue) {
    std::vector<std::string> roles = fieldSignals();
    for (const char* role : {"coil.current", "truth.alpha", "truth.beta", "truth.gamma"}) {
        if (catalogue.findSignal(signalOfRole(catalogue, role)) != nullptr) {
            roles.emplace_back(role);
        }
    }
    return roles;
}

} // namespace

std::vector<std::string> liveFieldSignals(const devices::Catalogue& catalogue) {
    std::vector<std::string> names;
    for (const std::string& role : rolesOf(catalogue)) {
        names.push_back(signalOfRole(catalogue, role));
    }
    return names;
}

devices::RecordedFile liveFieldRows(Workbench& bench, double length_s) {
    const devices::Catalogue& catalogue = bench.session().catalogue();
    std::vector<std::string> roles;
    std::vector<std::string> names;
    for (const std::string& role : rolesOf(catalogue)) {
        const std::string name = signalOfRole(catalogue, role);
        const bool isField = role.starts_with("field.");
        if (isField || bench.history().contains(name)) {
            roles.push_back(role);
            names.push_back(name);
        }
    }
    devices::RecordedFile file;
    file.recording = lastRows(bench.history(), names, length_s, MostRows);
    auto layout = std::make_shared<StreamLayout>(*file.recording.layout);
    for (std::size_t i = 0; i < roles.size(); ++i) {
        layout->columns[i].name = roles[i];
    }
    file.recording.layout = layout;
    return file;
}

} // namespace halbench::app
