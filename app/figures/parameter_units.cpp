#include "app/figures/parameter_units.h"

#include <array>
#include <string_view>
#include <utility>

namespace halbench::app {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 18> Units = {{
    {"gain.kp", "A/rad"},
    {"gain.ki", "A/(rad*s)"},
    {"gain.kd", "A*s/rad"},
    {"gain.derivative_filter", "s"},
    {"feedforward.inertia", "A*s^2/rad"},
    {"feedforward.viscous", "A*s/rad"},
    {"feedforward.coulomb", "A"},
    {"feedforward.coulomb_speed", "rad/s"},
    {"stiction.current", "A"},
    {"stiction.threshold", "rad"},
    {"stiction.speed", "rad/s"},
    {"limit.current", "A"},
    {"limit.temperature", "degC"},
    {"stray.coefficient", "T/A"},
    {"hall.offset_a", "T"},
    {"hall.offset_b", "T"},
    {"hall.quadrature", "rad"},
    {"hall.amplitude", "T"},
}};

} // namespace

std::string parameterUnit(const std::string& name) {
    for (const auto& [known, unit] : Units) {
        if (known == name) {
            return std::string(unit);
        }
    }
    return {};
}

} // namespace halbench::app
