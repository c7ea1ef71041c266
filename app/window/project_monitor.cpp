#include "app/window/project_monitor.h"

#include "app/window/project_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {

namespace {

constexpr int MostColumns = 100; ///< more than a screen has room for

/// As files name them, in the order of the enumerations.
constexpr std::array<const char*, 3> Modes{"auto", "normal", "single"};
constexpr std::array<const char*, 3> Slopes{"rising", "falling", "either"};

toml::table triggerTable(const TriggerChoice& trigger) {
    toml::table table{{"on", trigger.isOn},
                      {"source", projectValue(trigger.source)},
                      {"mode", Modes[static_cast<std::size_t>(trigger.mode)]},
                      {"slope", Slopes[static_cast<std::size_t>(trigger.slope)]},
                      {"level", trigger.level},
                      {"hysteresis", trigger.hysteresis},
                      {"window_s", trigger.window_s},
                      {"pre_trigger_ratio", trigger.preTrigger_ratio},
                      {"hold_off_s", trigger.holdOff_s}};
    if (trigger.isBoard) { // an older version does not know the key
        table.insert("board", true);
    }
    return table;
}

template <typename Choice>
void readName(ProjectReader& reader, const ConfigNode& node, const std::array<const char*, 3>& names,
              Choice& target) {
    const auto found = std::find(names.begin(), names.end(), node.text);
    if (node.kind != ConfigNode::Kind::Text || found == names.end()) {
        reader.refuse(node, fmt::format("must be '{}', '{}' or '{}'", names[0], names[1], names[2]));
        return;
    }
    target = static_cast<Choice>(found - names.begin());
}

void readTriggerKey(ProjectReader& reader, const std::string& key, const ConfigNode& value,
                    TriggerChoice& trigger) {
    if (key == "on") {
        trigger.isOn = reader.flag(value, key);
    } else if (key == "board") {
        trigger.isBoard = reader.flag(value, key);
    } else if (key == "source") {
        reader.text(value, key, trigger.source);
    } else if (key == "mode") {
        readName(reader, value, Modes, trigger.mode);
    } else if (key == "slope") {
        readName(reader, value, Slopes, trigger.slope);
    } else if (key == "level") {
        trigger.level = reader.number(value, key);
    } else if (key == "hysteresis") {
        trigger.hysteresis = reader.number(value, key);
    } else if (key == "window_s") {
        trigger.window_s = reader.number(value, key);
    } else if (key == "pre_trigger_ratio") {
        trigger.preTrigger_ratio = reader.number(value, key);
    } else if (key == "hold_off_s") {
        trigger.holdOff_s = reader.number(value, key);
    } else {
        reader.refuse(value, fmt::format("unknown key '{}'; [monitor.trigger] has on, source, mode, slope, "
                                         "level, hysteresis, window_s, pre_trigger_ratio, hold_off_s, board",
                                         key));
    }
}

void readTrigger(ProjectReader& reader, const ConfigNode& node, TriggerChoice& trigger) {
    if (node.kind != ConfigNode::Kind::Table) {
        reader.refuse(node, "'trigger' must be a table, [monitor.trigger]");
    }
    for (const auto& [key, value] : node.members) {
        readTriggerKey(reader, key, value, trigger);
    }
    if (trigger.hysteresis < 0.0 || trigger.holdOff_s < 0.0 || trigger.window_s <= 0.0 ||
        trigger.preTrigger_ratio < 0.0 || trigger.preTrigger_ratio > 1.0) {
        reader.refuse(node, "of a trigger window_s is more than 0, hysteresis and hold_off_s are not "
                            "negative, pre_trigger_ratio is from 0 to 1");
    }
}

void readSignals(ProjectReader& reader, const ConfigNode& node, const std::string& key,
                 std::vector<std::string>& target) {
    if (node.kind != ConfigNode::Kind::List) {
        reader.refuse(node, fmt::format("'{}' must be a list of texts", key));
    }
    for (const ConfigNode& item : node.items) {
        reader.text(item, key, target.emplace_back());
    }
}

/// The two ends of an axis that the user holds: both or neither.
struct HeldAxis {
    widgets::ValueRange range;
    int ends = 0;

    void take(ProjectReader& reader, const std::string& key, const ConfigNode& value, bool isHigh) {
        (isHigh ? range.high : range.low) = reader.number(value, key);
        ++ends;
    }
    bool isWrong() const { return ends == 1 || (ends == 2 && !(range.low < range.high)); }
    std::optional<widgets::ValueRange> held() const {
        return ends == 2 ? std::optional(range) : std::nullopt;
    }
};

/// Counted from 1 in the file, as a reader does.
int readColumn(ProjectReader& reader, const ConfigNode& node) {
    const double column = reader.number(node, "column");
    if (column < 1.0 || column > MostColumns || column != std::floor(column)) {
        reader.refuse(node, fmt::format("'column' must be a whole number from 1 to {}", MostColumns));
        return 0;
    }
    return static_cast<int>(column) - 1;
}

void readPlot(ProjectReader& reader, const ConfigNode& node, PlotChoice& plot) {
    HeldAxis left;
    HeldAxis right;
    std::optional<bool> follows;
    for (const auto& [key, value] : node.members) {
        if (key == "signals" || key == "right") {
            readSignals(reader, value, key, key == "right" ? plot.rightNames : plot.signalNames);
        } else if (key == "unit" || key == "right_unit") {
            reader.text(value, key, key == "unit" ? plot.unit : plot.rightUnit);
        } else if (key == "min" || key == "max") {
            left.take(reader, key, value, key == "max");
        } else if (key == "right_min" || key == "right_max") {
            right.take(reader, key, value, key == "right_max");
        } else if (key == "own_span_s") {
            plot.ownTime = widgets::OwnTime{reader.number(value, key), true};
        } else if (key == "own_follow") {
            follows = reader.flag(value, key);
        } else if (key == "column") {
            plot.column = readColumn(reader, value);
        } else if (key != "units") {
            reader.refuse(
                value, fmt::format("unknown key '{}'; a [[plot]] has signals, min, max, unit, right, "
                                   "right_min, right_max, right_unit, own_span_s, own_follow, column, units",
                                   key));
        }
    }
    if (const ConfigNode* units = node.find("units")) {
        readUnits(reader, *units, plot);
    }
    if (left.isWrong() || right.isWrong()) {
        reader.refuse(node, "a [[plot]] has both min and max, or neither; min is less than max");
    }
    if (plot.ownTime ? !(plot.ownTime->span_s > 0.0) : follows.has_value()) {
        reader.refuse(node, "a [[plot]] with its own time axis has own_span_s, which is more than 0");
    }
    if (plot.ownTime) {
        plot.ownTime->isFollowing = follows.value_or(true);
    }
    plot.range = left.held();
    plot.rightRange = right.held();
}

toml::array namesArray(const std::vector<std::string>& list) {
    toml::array names;
    for (const std::string& name : list) {
        names.push_back(projectValue(name));
    }
    return names;
}

} // namespace

toml::array projectPlots(const std::vector<PlotChoice>& list) {
    toml::array array;
    for (const PlotChoice& plot : list) {
        toml::table table{{"signals", namesArray(plot.signalNames)}};
        if (plot.range) {
            table.insert("min", plot.range->low);
            table.insert("max", plot.range->high);
            table.insert("unit", projectValue(plot.unit));
        }
        if (!plot.rightNames.empty()) { // an older version does not know the keys
            table.insert("right", namesArray(plot.rightNames));
        }
        if (plot.rightRange) {
            table.insert("right_min", plot.rightRange->low);
            table.insert("right_max", plot.rightRange->high);
            table.insert("right_unit", projectValue(plot.rightUnit));
        }
        if (plot.ownTime) {
            table.insert("own_span_s", plot.ownTime->span_s);
        }
        if (plot.ownTime && !plot.ownTime->isFollowing) {
            table.insert("own_follow", false);
        }
        if (plot.column > 0) {
            table.insert("column", plot.column + 1);
        }
        if (!plot.units.empty()) {
            table.insert("units", projectUnits(plot));
        }
        array.push_back(table);
    }
    return array;
}

toml::table projectMonitor(const MonitorView& view) {
    toml::table table{{"follow", view.isFollowing}};
    if (view.areCursorsShown) { // an older version does not know the key
        table.insert("cursors", true);
    }
    if (view.span_s) {
        table.insert("span_s", *view.span_s);
    }
    if (view.rate_Hz > 0.0) { // likewise
        table.insert("rate_hz", view.rate_Hz);
    }
    if (view.trigger != TriggerChoice{}) {
        table.insert("trigger", triggerTable(view.trigger));
    }
    return table;
}

void readPlots(ProjectReader& reader, const ConfigNode& node, std::vector<PlotChoice>& plots) {
    if (node.kind != ConfigNode::Kind::List) {
        reader.refuse(node, "'plot' must be a list of tables, [[plot]]");
    }
    for (const ConfigNode& item : node.items) {
        if (item.kind != ConfigNode::Kind::Table) {
            reader.refuse(item, "'plot' must be a list of tables, [[plot]]");
        }
        readPlot(reader, item, plots.emplace_back());
    }
}

void readMonitor(ProjectReader& reader, const ConfigNode& node, MonitorView& view) {
    if (node.kind != ConfigNode::Kind::Table) {
        reader.refuse(node, "'monitor' must be a table");
    }
    for (const auto& [key, value] : node.members) {
        if (key == "follow" && value.kind == ConfigNode::Kind::Boolean) {
            view.isFollowing = value.boolean;
        } else if (key == "span_s") {
            view.span_s = reader.number(value, key);
        } else if (key == "cursors") {
            view.areCursorsShown = reader.flag(value, key);
        } else if (key == "rate_hz") {
            view.rate_Hz = reader.number(value, key);
        } else if (key == "trigger") {
            readTrigger(reader, value, view.trigger);
        } else {
            reader.refuse(value,
                          "[monitor] has follow and cursors (true or false), span_s, rate_hz and trigger");
        }
    }
    if (view.rate_Hz < 0.0) {
        reader.refuse(node, "'rate_hz' must not be negative");
    }
    if (view.span_s && *view.span_s <= 0.0) {
        reader.refuse(node, "'span_s' must be more than 0");
    }
}

toml::table projectFurtherMonitor(const MonitorView& view) {
    toml::table table = projectMonitor(view);
    table.insert("plot", projectPlots(view.plots));
    return table;
}

void readFurtherMonitor(ProjectReader& reader, const ConfigNode& node, MonitorView& view) {
    ConfigNode rest = node;
    std::erase_if(rest.members, [](const ConfigNode::Member& member) { return member.first == "plot"; });
    readMonitor(reader, rest, view);
    if (const ConfigNode* plots = node.find("plot")) {
        readPlots(reader, *plots, view.plots);
    }
}

toml::array projectDerived(const std::vector<devices::DerivedSignal>& list) {
    toml::array array;
    for (const devices::DerivedSignal& derived : list) {
        array.push_back(toml::table{{"name", projectValue(derived.name)},
                                    {"expression", projectValue(derived.expression)},
                                    {"unit", projectValue(derived.unit)}});
    }
    return array;
}

void readDerived(ProjectReader& reader, const ConfigNode& node, std::vector<devices::DerivedSignal>& list) {
    if (node.kind != ConfigNode::Kind::List) {
        reader.refuse(node, "'derived' must be a list of tables, [[derived]]");
    }
    for (const ConfigNode& item : node.items) {
        devices::DerivedSignal& derived = list.emplace_back();
        for (const auto& [key, value] : item.members) {
            std::string* target = key == "name"         ? &derived.name
                                  : key == "expression" ? &derived.expression
                                  : key == "unit"       ? &derived.unit
                                                        : nullptr;
            if (target != nullptr) {
                reader.text(value, key, *target);
            } else {
                reader.refuse(value,
                              fmt::format("unknown key '{}'; a [[derived]] has name, expression, unit", key));
            }
        }
        if (derived.name.empty() || derived.expression.empty()) {
            reader.refuse(item, "a [[derived]] has a name and an expression");
        }
        if (std::count_if(list.begin(), list.end(),
                          [&](const auto& one) { return one.name == derived.name; }) > 1) {
            reader.refuse(item, fmt::format("there is a [[derived]] named '{}' already", derived.name));
        }
    }
}

} // namespace halbench::app
