#include "app/procedures/excite/excitation_limits.h"

#include <algorithm>

namespace halbench::app {
namespace {

constexpr double Margin_ratio = 1.25; // a stop takes a few cycles; the rotor goes on until friction holds it
constexpr double Margin_degC = 2.0;
constexpr double DefaultLimit_degC = 80.0;
constexpr double Coldest_degC = -100.0; // below it a sensor is broken

void watch(const devices::Catalogue& catalogue, std::vector<devices::GuardLimit>& limits,
           const std::string& role, double min, double max, bool isFromStart = false) {
    if (const std::string signal = catalogue.signalForRole(role); !signal.empty()) {
        limits.push_back({signal, min, max, isFromStart});
    }
}

} // namespace

std::vector<devices::GuardLimit> excitationLimits(const devices::Catalogue& catalogue, double speedLimit,
                                                  std::optional<double> positionWindow,
                                                  const devices::AxisSpec& axis) {
    std::vector<devices::GuardLimit> limits;
    const double speed = Margin_ratio * speedLimit;
    watch(catalogue, limits, axis.roles.speed, -speed, speed);
    if (positionWindow) {
        const double window = Margin_ratio * *positionWindow;
        watch(catalogue, limits, axis.roles.position, -window, window, true);
    }
    const auto limit = catalogue.knownConstants.find("T_limit_degC");
    const double hottest_degC =
        (limit == catalogue.knownConstants.end() ? DefaultLimit_degC : limit->second) + Margin_degC;
    for (const SignalSpec& signal : catalogue.signals) {
        if (signal.role.starts_with("coil_temperature.")) {
            limits.push_back({signal.name, Coldest_degC, hottest_degC});
        }
    }
    return limits;
}

std::vector<std::string> withWatchedSignals(const devices::Catalogue& catalogue,
                                            std::vector<std::string> measured) {
    for (const devices::GuardLimit& limit : excitationLimits(catalogue, 0.0, 0.0)) {
        if (std::find(measured.begin(), measured.end(), limit.signal) == measured.end()) {
            measured.push_back(limit.signal);
        }
    }
    return measured;
}

} // namespace halbench::app
