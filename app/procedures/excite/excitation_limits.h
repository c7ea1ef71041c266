#pragma once

#include "devices/acquisition/guard.h"

#include <optional>
#include <string>
#include <vector>

namespace halbench::app {

/// The host's second line beside the board's own windows and temperature limit
/// (resources/help/architecture.md, threads and data): wider than those by a quarter of a window and 2 K, so
/// that a board that does its work is never overtaken, and one that does not is stopped from here. Signals
/// are found by the roles of the axis, whose units speed and window have; what the device does not have or
/// the stream does not carry is not watched.
std::vector<devices::GuardLimit> excitationLimits(const devices::Catalogue& catalogue, double speedLimit,
                                                  std::optional<double> positionWindow = std::nullopt,
                                                  const devices::AxisSpec& axis = {});

/// Signals of a measurement and, behind them, those that its limits watch.
std::vector<std::string> withWatchedSignals(const devices::Catalogue& catalogue,
                                            std::vector<std::string> measured);

} // namespace halbench::app
