#include "devices/open/simulation_options.h"

#include "devices/simulated/registry/simulated_device.h"
#include "devices/simulated/registry/simulated_models.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices {

std::optional<SimulationOptions> SimulationOptions::of(const std::string& address) {
    const auto uri = parseDeviceUri(address);
    const SimulatedModel* model = uri && uri->scheme == "sim" ? findSimulatedModel(uri->address) : nullptr;
    if (model == nullptr || model->keys.empty()) {
        return std::nullopt;
    }
    SimulationOptions options;
    options.m_device = "sim:" + uri->address;
    for (const OverrideSpec& spec : model->keys) {
        options.m_rows.push_back({spec, {}});
    }
    for (const auto& [key, value] : uri->options) {
        const auto row = std::find_if(options.m_rows.begin(), options.m_rows.end(),
                                      [&key = key](const Row& each) { return each.spec.key == key; });
        if (row != options.m_rows.end()) {
            row->value = value;
        } else {
            OverrideSpec other;
            other.key = key;
            other.isText = true;
            options.m_rows.push_back({other, value});
        }
    }
    return options;
}

void SimulationOptions::set(std::size_t row, const std::string& value) {
    m_rows.at(row).value = value;
}

void SimulationOptions::clear() {
    for (Row& row : m_rows) {
        row.value.clear();
    }
}

std::string SimulationOptions::address() const {
    std::string text = m_device;
    char mark = '?';
    for (const Row& row : m_rows) {
        if (!row.value.empty()) {
            text += mark + row.spec.key + "=" + row.value;
            mark = '&';
        }
    }
    return text;
}

Result<void> SimulationOptions::check() const {
    for (const Row& row : m_rows) {
        if (row.value.find_first_of("&?#") != std::string::npos) {
            return failure(
                ErrorCode::InvalidInput,
                fmt::format("{}={} has a character that divides an address", row.spec.key, row.value),
                "Leave out & ? #.");
        }
    }
    const auto uri = parseDeviceUri(address());
    if (!uri) {
        return failure(uri.error());
    }
    const auto setup = parseSimulatedAddress(*uri, std::nullopt);
    return setup ? Result<void>() : failure(setup.error());
}

} // namespace halbench::devices
