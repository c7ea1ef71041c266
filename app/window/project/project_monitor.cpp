#include "app/window/project/project_monitor.h"

#include "app/window/project/project_plots.h"
#include "app/workspaces/monitor/look_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {

namespace {

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

toml::table looksTable(const widgets::CurveLooks& looks) {
    toml::table table;
    for (const auto& [signal, look] : looks) {
        toml::table entry;
        if (look.place) {
            entry.insert("colour", colourOfLook(*look.place));
            entry.insert("line", lineOfLook(*look.place));
        }
        if (!look.name.isEmpty()) {
            entry.insert("name", projectValue(look.name.toStdString()));
        }
        entry.is_inline(true);
        table.insert(signal, entry);
    }
    return table;
}

std::optional<int> readColour(ProjectReader& reader, const ConfigNode& node) {
    const double number = reader.numberOrReset(node, "colour").value_or(0.0);
    if (number < 1.0 || number > LookColours || number != std::floor(number)) {
        reader.reset(
            node, fmt::format("'{}' must be a whole number from 1 to {}", "colour", widgets::CurveColours));
        return std::nullopt;
    }
    return static_cast<int>(number);
}

int readLine(ProjectReader& reader, const ConfigNode& node) {
    const auto found = std::find(LookLines.begin(), LookLines.end(), node.text);
    if (node.kind != ConfigNode::Kind::Text || found == LookLines.end()) {
        reader.reset(node, "'line' must be 'solid', 'dash', 'dot' or 'dash-dot'");
        return 0;
    }
    return static_cast<int>(found - LookLines.begin());
}

widgets::CurveLook readLook(ProjectReader& reader, const ConfigNode& node) {
    widgets::CurveLook look;
    std::optional<int> colour;
    int line = 0;
    for (const auto& [key, value] : node.members) {
        if (key == "colour") {
            colour = readColour(reader, value);
        } else if (key == "line") {
            line = readLine(reader, value);
        } else if (key == "name") {
            std::string name;
            reader.text(value, key, name);
            look.name = QString::fromStdString(name);
        } else {
            reader.reset(value, fmt::format("unknown key '{}'; a curve has colour, line, name", key));
        }
    }
    if (colour) {
        look.place = placeOfLook(*colour, line);
    }
    return look;
}

/// Names of signals are no keys: what this device does not have waits for one that does.
void readLooks(ProjectReader& reader, const ConfigNode& node, widgets::CurveLooks& looks) {
    if (node.kind != ConfigNode::Kind::Table) {
        reader.reset(node, "'curves' must be a table of signals, [monitor.curves]");
    }
    for (const auto& [signal, value] : node.members) {
        const widgets::CurveLook look = readLook(reader, value);
        if (look != widgets::CurveLook{}) {
            looks[signal] = look;
        }
    }
}

/// As usual, where it is none.
double readRate_Hz(ProjectReader& reader, const ConfigNode& node) {
    const double rate_Hz = reader.numberOrReset(node, "rate_hz").value_or(0.0);
    if (rate_Hz < 0.0) {
        reader.reset(node, "'rate_hz' must not be negative");
        return 0.0;
    }
    return rate_Hz;
}

} // namespace

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
    if (!view.looks.empty()) { // likewise
        table.insert("curves", looksTable(view.looks));
    }
    if (view.trigger != TriggerChoice{}) {
        table.insert("trigger", triggerTable(view.trigger));
    }
    return table;
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
            view.rate_Hz = readRate_Hz(reader, value);
        } else if (key == "trigger") {
            readTrigger(reader, value, view.trigger);
        } else if (key == "curves") {
            readLooks(reader, value, view.looks);
        } else {
            reader.refuse(value, "[monitor] has follow and cursors (true or false), span_s, rate_hz, curves "
                                 "and trigger");
        }
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
