#include "app/workspaces/monitor/monitor_plots.h"

#include "app/workspaces/parts/signal_units.h"
#include "widgets/live_plot/curve_units.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace halbench::app {

namespace {

constexpr std::size_t FirstSignals = 8;
constexpr std::size_t MostMore = 4; ///< that complete a group, as the four parts of a quaternion

/// Of a fresh start; more would be too low to be read on a small screen.
constexpr std::size_t FirstPlots = 3;

/// Roles of what stands in one plot, what matters most first. One that ends with a dot stands for those of
/// all coils or sensors, `current.`.
std::vector<std::vector<std::string>> defaultRoles(const devices::Catalogue& catalogue) {
    std::vector<std::string> positions;
    std::vector<std::string> speeds;
    for (const devices::AxisSpec& axis : catalogue.axes) {
        positions.push_back(axis.roles.position);
        positions.push_back(axis.roles.reference);
        speeds.push_back(axis.roles.speed);
    }
    if (catalogue.axes.empty()) { // it only senses
        positions = {"position", "reference"};
        speeds = {"speed"};
    }
    return {positions, speeds, {"current_command", "current."}, {"hall."}, {"coil_temperature."}};
}

bool plays(const SignalSpec& spec, const std::string& role) {
    return !role.empty() && (role.back() == '.' ? spec.role.rfind(role, 0) == 0 : spec.role == role);
}

bool isSensor(const SignalSpec& spec) {
    const auto begins = [&spec](const char* role) { return spec.role.rfind(role, 0) == 0; };
    return begins("position") || begins("hall.") || begins("coil_temperature.");
}

/// Into the plot of its unit from that one on, else into one of its own.
void addToOwnUnit(std::vector<widgets::PlotSpec>& plots, std::size_t from, widgets::PlotSpec wanted) {
    const auto begin = plots.begin() + static_cast<std::ptrdiff_t>(from);
    const auto same = std::find_if(
        begin, plots.end(), [&wanted](const widgets::PlotSpec& plot) { return plot.unit == wanted.unit; });
    if (same == plots.end()) {
        plots.push_back(std::move(wanted));
    } else {
        same->curves.push_back(wanted.curves.front());
    }
}

std::optional<double> constant(const devices::Catalogue& catalogue, const char* name) {
    const auto found = catalogue.knownConstants.find(name);
    return found == catalogue.knownConstants.end() ? std::nullopt : std::optional(found->second);
}

/// For a device that no profile knows.
std::vector<widgets::PlotSpec> firstSignals(const devices::Catalogue& catalogue,
                                            const TemperatureBands& bands, const DisplayUnits& units) {
    std::vector<widgets::PlotSpec> plots;
    const std::size_t most = std::min(FirstSignals + MostMore, catalogue.signals.size());
    const auto areAlike = [](const widgets::PlotSpec& one, const widgets::PlotSpec& other) {
        return one.unit == other.unit && one.quantity == other.quantity;
    };
    for (std::size_t i = 0; i < most; ++i) {
        const widgets::PlotSpec wanted = plotFor(catalogue.signals[i], bands, units);
        if (i >= FirstSignals && !areAlike(wanted, plotFor(catalogue.signals[i - 1], bands, units))) {
            break;
        }
        const auto same = std::find_if(plots.begin(), plots.end(),
                                       [&](const widgets::PlotSpec& plot) { return areAlike(plot, wanted); });
        if (same == plots.end()) {
            plots.push_back(wanted);
        } else {
            same->curves.push_back(wanted.curves.front());
        }
    }
    plots.resize(std::min(plots.size(), FirstPlots));
    return plots;
}

struct Shown {
    const devices::Catalogue& catalogue;
    const TemperatureBands& bands;
    const DisplayUnits& units;
};

/// A unit that does not fit the signal is as none.
void takeOwnUnit(widgets::PlotSpec& own, const std::string& unit) {
    if (!unit.empty()) {
        widgets::showIn(own, own.curves.front().signal, unit);
    }
}

std::string ownUnitOf(const PlotChoice& choice, const std::string& name) {
    const auto found = choice.units.find(name);
    return found == choice.units.end() ? std::string() : found->second;
}

/// On the axis that was chosen; the first one says what the axis shows.
void addChosen(widgets::PlotSpec& plot, const PlotChoice& choice, const std::string& name, bool isRight,
               const Shown& shown, QStringList& missing) {
    const SignalSpec* spec = shown.catalogue.findSignal(name);
    if (spec == nullptr) {
        missing << QString::fromStdString(name);
        return;
    }
    widgets::PlotSpec own = plotFor(*spec, shown.bands, shown.units);
    takeOwnUnit(own, ownUnitOf(choice, name));
    own.curves.front().isRight = isRight;
    if (isRight && !widgets::hasRightAxis(plot)) {
        plot.right = {own.quantity, own.unit, {}};
    } else if (!isRight && plot.curves.empty()) {
        plot.quantity = own.quantity;
        plot.unit = own.unit;
        plot.bands = own.bands;
    }
    plot.curves.push_back(own.curves.front());
}

/// As its first plot says, which this device may have no signal for.
double widthOf(const std::vector<PlotChoice>& choices, int column) {
    const auto first = std::find_if(choices.begin(), choices.end(),
                                    [column](const PlotChoice& choice) { return choice.column == column; });
    return first->width_ratio;
}

} // namespace

TemperatureBands temperatureBands(const devices::Catalogue& catalogue, std::optional<double> limit_degC) {
    return {constant(catalogue, "T_pause_degC"),
            limit_degC ? limit_degC : constant(catalogue, "T_limit_degC")};
}

widgets::PlotCurve curveFor(const SignalSpec& spec, const DisplayUnits& units) {
    const DisplayQuantity shown = signalQuantity(spec, units);
    widgets::PlotCurve curve{spec.name, signalWords(spec.name), shown.unit, shown.factor, shown.decimals};
    curve.unitChoices = unitChoices(spec.unit, units);
    curve.isSensor = isSensor(spec);
    return curve;
}

widgets::PlotSpec plotFor(const SignalSpec& spec, const TemperatureBands& bands, const DisplayUnits& units) {
    const DisplayQuantity shown = signalQuantity(spec, units);
    widgets::PlotSpec plot;
    plot.quantity = shown.quantity.isEmpty() ? signalWords(spec.name) : shown.quantity;
    plot.unit = shown.unit;
    plot.curves.push_back(curveFor(spec, units));
    if (spec.unit != "degC") {
        return plot;
    }
    constexpr double Open = std::numeric_limits<double>::infinity();
    if (bands.warn_degC) {
        plot.bands.push_back(
            {*bands.warn_degC, bands.bad_degC.value_or(Open), widgets::LimitBand::Role::Warn});
    }
    if (bands.bad_degC) {
        plot.bands.push_back({*bands.bad_degC, Open, widgets::LimitBand::Role::Bad});
    }
    return plot;
}

std::vector<widgets::PlotSpec> defaultPlots(const devices::Catalogue& catalogue,
                                            const TemperatureBands& bands, const DisplayUnits& units) {
    std::vector<widgets::PlotSpec> plots;
    for (const std::vector<std::string>& roles : defaultRoles(catalogue)) {
        const std::size_t first = plots.size();
        for (const std::string& role : roles) {
            for (const SignalSpec& spec : catalogue.signals) {
                if (plays(spec, role)) {
                    addToOwnUnit(plots, first, plotFor(spec, bands, units));
                }
            }
        }
    }
    plots.resize(std::min(plots.size(), FirstPlots));
    return plots.empty() ? firstSignals(catalogue, bands, units) : plots;
}

std::vector<widgets::PlotSpec> inUnits(std::vector<widgets::PlotSpec> plots,
                                       const devices::Catalogue& catalogue, const TemperatureBands& bands,
                                       const DisplayUnits& units) {
    for (widgets::PlotSpec& plot : plots) {
        for (widgets::PlotCurve& curve : plot.curves) {
            const SignalSpec* spec = catalogue.findSignal(curve.signal);
            if (spec == nullptr) {
                continue; // of another device: it keeps what it says
            }
            widgets::PlotSpec fresh = plotFor(*spec, bands, units);
            takeOwnUnit(fresh, curve.ownUnit);
            if (!curve.isRight) {
                plot.bands = fresh.bands;
            }
            const bool isRight = curve.isRight;
            curve = fresh.curves.front();
            curve.isRight = isRight;
        }
    }
    return plots;
}

std::vector<widgets::PlotSpec> chosenPlots(const std::vector<PlotChoice>& choices,
                                           const devices::Catalogue& catalogue, const TemperatureBands& bands,
                                           const DisplayUnits& units, QStringList& missing) {
    std::vector<widgets::PlotSpec> plots;
    for (const PlotChoice& choice : choices) {
        widgets::PlotSpec plot;
        for (const std::string& name : choice.signalNames) {
            addChosen(plot, choice, name, false, {catalogue, bands, units}, missing);
        }
        for (const std::string& name : choice.rightNames) {
            addChosen(plot, choice, name, true, {catalogue, bands, units}, missing);
        }
        if (!plot.curves.empty()) {
            plot.fixedRange = choice.unit == plot.unit.toStdString() ? choice.range : std::nullopt;
            plot.right.fixedRange =
                choice.rightUnit == plot.right.unit.toStdString() ? choice.rightRange : std::nullopt;
            plot.ownTime = choice.ownTime;
            plot.column = choice.column;
            plot.height_ratio = choice.height_ratio;
            plot.width_ratio = widthOf(choices, choice.column);
            widgets::settleAxes(plot);
            plots.push_back(std::move(plot));
        }
    }
    widgets::settleUnits(plots);
    missing.removeDuplicates();
    return plots;
}

QStringList unfitUnits(const std::vector<PlotChoice>& choices, const devices::Catalogue& catalogue) {
    QStringList unfit;
    for (const PlotChoice& choice : choices) {
        for (const auto& [name, unit] : choice.units) {
            const SignalSpec* spec = catalogue.findSignal(name);
            const bool isFit = spec == nullptr || widgets::findChoice(curveFor(*spec, {}), unit) != nullptr;
            if (!isFit) {
                unfit << QStringLiteral("%1 [%2]").arg(QString::fromStdString(name),
                                                       QString::fromStdString(unit));
            }
        }
    }
    unfit.removeDuplicates();
    return unfit;
}

widgets::CursorPairs cursorPairs(const MonitorView& view) {
    std::vector<widgets::NamedPair> pairs;
    std::size_t measuring = 0;
    for (const CursorChoice& choice : view.cursors) {
        measuring = choice.isMeasuring ? pairs.size() : measuring;
        pairs.push_back({QString::fromStdString(choice.name), choice.a_s, choice.b_s});
    }
    widgets::CursorPairs kept(std::move(pairs), measuring);
    kept.setVisible(view.areCursorsShown);
    return kept;
}

void keepCursors(const widgets::CursorPairs& pairs, MonitorView& view) {
    view.cursors.clear();
    view.areCursorsShown = pairs.areKept() && pairs.cursors().isVisible;
    for (std::size_t i = 0; pairs.areKept() && i < pairs.list().size(); ++i) {
        const widgets::NamedPair& pair = pairs.list()[i];
        view.cursors.push_back({pair.name.toStdString(), pair.a_s, pair.b_s, i == pairs.chosen()});
    }
}

std::set<std::string> plottedSignals(const std::vector<widgets::PlotSpec>& plots) {
    std::set<std::string> names;
    for (const widgets::PlotSpec& plot : plots) {
        for (const widgets::PlotCurve& curve : plot.curves) {
            names.insert(curve.signal);
        }
    }
    return names;
}

} // namespace halbench::app
