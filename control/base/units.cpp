#include "control/base/units.h"

#include <array>

namespace halbench {

namespace {

constexpr std::array Table = {
    Unit{"", "", "count or state"},
    Unit{"rad", "rad", "angle"},
    Unit{"rad/s", "rad_s", "angular speed"},
    Unit{"rad/s^2", "rad_s2", "angular acceleration"},
    Unit{"deg", "deg", "angle"},
    Unit{"m", "m", "length"},
    Unit{"m/s", "m_s", "speed"},
    Unit{"s", "s", "time"},
    Unit{"ms", "ms", "time"},
    Unit{"Hz", "Hz", "frequency"},
    Unit{"A", "A", "current"},
    Unit{"V", "V", "voltage"},
    Unit{"A/V", "A_per_V", "transconductance"},
    Unit{"T", "T", "flux density"},
    Unit{"T/A", "T_per_A", "stray field per current"},
    Unit{"degC", "degC", "temperature"},
    Unit{"K", "K", "temperature difference"},
    Unit{"1/K", "per_K", "temperature coefficient"},
    Unit{"N*m", "Nm", "torque"},
    Unit{"N*m/A", "Nm_per_A", "torque constant"},
    Unit{"N*m*s/rad", "Nms_per_rad", "viscous damping"},
    Unit{"kg*m^2", "kgm2", "inertia"},
    Unit{"kg", "kg", "mass"},
    Unit{"N", "N", "force"},
    Unit{"N/A", "N_per_A", "force constant"},
    Unit{"N/m", "N_per_m", "proportional gain"},
    Unit{"N/(m*s)", "N_per_m_s", "integral gain"},
    Unit{"N*s/m", "Ns_per_m", "derivative gain"},
    Unit{"N*m/rad", "Nm_per_rad", "proportional gain"},
    Unit{"N*m/(rad*s)", "Nm_per_rad_s", "integral gain"},
    Unit{"1/s", "per_s", "rate"},
    Unit{"rad/s^2/A", "rad_s2_per_A", "acceleration per current"},
    Unit{"A/rad", "A_per_rad", "proportional gain"},
    Unit{"A/(rad*s)", "A_per_rad_s", "integral gain"},
    Unit{"A*s/rad", "As_per_rad", "derivative gain"},
    Unit{"A*s^2/rad", "As2_per_rad", "acceleration feed-forward"},
    Unit{"A/s", "A_per_s", "current slope"},
    Unit{"Ohm", "Ohm", "resistance"},
    Unit{"H", "H", "inductance"},
    Unit{"%", "percent", "ratio"},
    Unit{"dB", "dB", "ratio"},
};

} // namespace

std::span<const Unit> units() {
    return Table;
}

std::optional<Unit> findUnit(std::string_view symbol) {
    for (const Unit& unit : Table) {
        if (unit.symbol == symbol) {
            return unit;
        }
    }
    return std::nullopt;
}

} // namespace halbench
