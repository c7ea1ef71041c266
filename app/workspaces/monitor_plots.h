#pragma once

#include "devices/device.h"
#include "widgets/live_plot_spec.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace halbench::app {

/// Temperatures from which the plots warn, as the device's profile and its limit say.
struct TemperatureBands {
    std::optional<double> warn_degC;
    std::optional<double> bad_degC;
};
TemperatureBands temperatureBands(const devices::Catalogue& catalogue, std::optional<double> limit_degC);

/// A signal as the plots show it: words, display unit, decimals.
widgets::PlotCurve curveFor(const SignalSpec& spec);

/// What the Monitor shows of a device at first: Hall sensors, angle with reference, speed, currents, coil
/// temperatures with their bands; for a device without these roles its first signals, by unit.
std::vector<widgets::PlotSpec> defaultPlots(const devices::Catalogue& catalogue,
                                            const TemperatureBands& bands);

/// A plot for one more signal.
widgets::PlotSpec plotFor(const SignalSpec& spec, const TemperatureBands& bands);

/// Names of all signals in the plots.
std::set<std::string> plottedSignals(const std::vector<widgets::PlotSpec>& plots);

} // namespace halbench::app
