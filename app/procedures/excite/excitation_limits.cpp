#include "app/procedures/excite/excitation_limits.h"

#include <algorithm>

namespace halbench::app {
namespace {

constexpr double Margin_ratio = 1.25; // a stop takes a few cycles; the rotor goes on until friction holds it
constexpr double Margin_degC = 2.0;
constexpr double DefaultLimit_degC = 80.0;
constexpr double Coldest_degC = -100.0; // below it a sensor is broken

void watch(const devices::Catalogue& catalogue, std::vector<devices::GuardLimit>& limits, const char* role,
           double min, double max, bool isFromStart = false) {
    if (const std::string signal = catalogue.signalForRole(role); !signal.empty()) {
        limits.push_back({signal, min, max, isFromStart});
    }
}

} // namespace

std::vector<devices::GuardLimit> excitationLimits(const devices::Catalogue& catalogue,
                                                  double speedLimit_rad_s,
                                                  std::optional<double> positionWindow_rad) {
    std::vector<devices::GuardLimit> limits;
    const double speed_rad_s = Margin_ratio * speedLimit_rad_s;
    watch(catalogue, limits, "speed", -speed_rad_s, speed_rad_s);
    if (positionWindow_rad) {
        const double window_rad = Margin_ratio * *positionWindow_rad;
        watch(catalogue, limits, "position", -window_rad, window_rad, true);
    }
    const auto limit = catalogue.knownConstants.find("T_limit_degC");
    const double hottest_degC =
        (limit == catalogue.knownConstants.end() ? DefaultLimit_degC : limit->second) + Margin_degC;
    for (const char* role : {"coil_temperature.a", "coil_temperature.b"}) {
        watch(catalogue, limits, role, Coldest_degC, hottest_degC);
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
