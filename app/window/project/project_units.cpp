#include "app/window/project/project_units.h"

#include "app/workspaces/parts/signal_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace halbench::app {

namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace

toml::table projectUnits(const PlotChoice& plot) {
    toml::table table;
    for (const auto& [name, unit] : plot.units) {
        table.insert(name, projectValue(unit));
    }
    table.is_inline(true);
    return table;
}

/// Whether a unit fits its signal is known when there is a device; that it is one, and whose, is known now.
void readUnits(ProjectReader& reader, const ConfigNode& node, PlotChoice& plot) {
    if (node.kind != ConfigNode::Kind::Table) {
        reader.reset(node, "'units' must be a table of signals with their units, units.position = \"mrad\"");
    }
    for (const auto& [name, value] : node.members) {
        if (value.kind != ConfigNode::Kind::Text) {
            reader.reset(value, fmt::format("'{}' must be a text", "units." + name));
        } else if (!isDisplayUnit(value.text)) {
            reader.reset(value, fmt::format("'{}' is not a display unit of this signal; available: {}",
                                            value.text, displayUnitNames()));
        } else if (!has(plot.signalNames, name) && !has(plot.rightNames, name)) {
            reader.reset(value, fmt::format("'units' names '{}', which this [[plot]] does not show", name));
        } else {
            plot.units[name] = value.text;
        }
    }
}

} // namespace halbench::app
