#include "devices/device.h"

#include <algorithm>

namespace halbench::devices {

namespace {

template <typename Spec, typename Value>
const Spec* find(const std::vector<Spec>& specs, Value Spec::*member, const Value& wanted) {
    const auto found =
        std::find_if(specs.begin(), specs.end(), [&](const Spec& spec) { return spec.*member == wanted; });
    return found == specs.end() ? nullptr : &*found;
}

} // namespace

const SignalSpec* Catalogue::findSignal(const std::string& name) const {
    return find(signals, &SignalSpec::name, name);
}

const ParameterSpec* Catalogue::findParameter(const std::string& name) const {
    return find(parameters, &ParameterSpec::name, name);
}

const AxisSpec* Catalogue::findAxis(const std::string& id) const {
    return find(axes, &AxisSpec::id, id);
}

std::string Catalogue::signalForRole(const std::string& role) const {
    const SignalSpec* spec = find(signals, &SignalSpec::role, role);
    return spec ? spec->name : std::string{};
}

std::string Catalogue::parameterForRole(const std::string& role) const {
    const ParameterSpec* spec = find(parameters, &ParameterSpec::role, role);
    return spec ? spec->name : std::string{};
}

bool Catalogue::hasProcedure(const std::string& name) const {
    return std::find(procedures.begin(), procedures.end(), name) != procedures.end();
}

} // namespace halbench::devices
