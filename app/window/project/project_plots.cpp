#include "app/window/project/project_plots.h"

#include "app/window/project/project_units.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

namespace halbench::app {

namespace {

constexpr int MostColumns = 100; ///< more than a screen has room for
constexpr int MostShare_percent = 10000;

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

/// From 1 on; `usual` where it is none.
int readCount(ProjectReader& reader, const ConfigNode& node, const std::string& key, int most, int usual) {
    const double count = reader.numberOrReset(node, key).value_or(usual);
    if (count < 1.0 || count > most || count != std::floor(count)) {
        reader.reset(node, fmt::format("'{}' must be a whole number from 1 to {}", key, most));
        return usual;
    }
    return static_cast<int>(count);
}

/// A plot's part of the room, to the mean of those that share it.
double readShare(ProjectReader& reader, const ConfigNode& node, const std::string& key) {
    return readCount(reader, node, key, MostShare_percent, 100) / 100.0;
}

void putShare(toml::table& table, const char* key, double share_ratio) {
    const auto percent = static_cast<int>(std::lround(100.0 * share_ratio));
    if (percent != 100) {
        table.insert(key, percent);
    }
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
            plot.column = readCount(reader, value, key, MostColumns, 1) - 1; // as a reader counts
        } else if (key == "height_percent") {
            plot.height_ratio = readShare(reader, value, key);
        } else if (key == "width_percent") {
            plot.width_ratio = readShare(reader, value, key);
        } else if (key != "units") {
            reader.refuse(value,
                          fmt::format("unknown key '{}'; a [[plot]] has signals, min, max, unit, right, "
                                      "right_min, right_max, right_unit, own_span_s, own_follow, column, "
                                      "height_percent, width_percent, units",
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
        putShare(table, "height_percent", plot.height_ratio);
        putShare(table, "width_percent", plot.width_ratio);
        if (!plot.units.empty()) {
            table.insert("units", projectUnits(plot));
        }
        array.push_back(table);
    }
    return array;
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

} // namespace halbench::app
