#include "app/procedures/tune/position_law_parameters.h"

#include <array>
#include <cmath>

namespace halbench::app {
namespace {

struct Role {
    const char* role;
    double control::SampledPositionLaw::*member;
};

constexpr std::array Roles = {
    Role{"gain.kp", &control::SampledPositionLaw::kp_A_per_rad},
    Role{"gain.ki", &control::SampledPositionLaw::ki_A_per_rad_s},
    Role{"gain.kd", &control::SampledPositionLaw::kd_As_per_rad},
    Role{"feedforward.inertia", &control::SampledPositionLaw::inertia_As2_per_rad},
    Role{"feedforward.viscous", &control::SampledPositionLaw::viscous_As_per_rad},
    Role{"feedforward.coulomb", &control::SampledPositionLaw::coulomb_A},
    Role{"feedforward.coulomb_speed", &control::SampledPositionLaw::coulombSpeed_rad_s},
    Role{"stiction.current", &control::SampledPositionLaw::stiction_A},
    Role{"stiction.threshold", &control::SampledPositionLaw::stictionThreshold_rad},
    Role{"stiction.speed", &control::SampledPositionLaw::stictionSpeed_rad_s},
    Role{"limit.current", &control::SampledPositionLaw::limit_A},
};

} // namespace

Result<control::SampledPositionLaw> readPositionLaw(devices::Device& device) {
    std::vector<std::string> names;
    std::vector<double control::SampledPositionLaw::*> members;
    for (const Role& role : Roles) {
        const std::string name = device.catalogue().parameterForRole(role.role);
        if (!name.empty()) {
            names.push_back(name);
            members.push_back(role.member);
        }
    }
    const std::string delay = device.catalogue().parameterForRole("delay.samples");
    if (!delay.empty()) {
        names.push_back(delay);
    }
    const auto values = device.readParameters(names);
    if (!values) {
        return failure(values.error());
    }
    control::SampledPositionLaw law;
    const auto& known = device.catalogue().knownConstants;
    if (const auto period = known.find("T_s"); period != known.end()) {
        law.period_s = period->second;
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
        law.*members[i] = (*values)[i];
    }
    if (!delay.empty()) {
        law.delaySamples = static_cast<int>(std::lround(values->back()));
    }
    return law;
}

std::vector<ParameterValue> positionLawValues(const devices::Catalogue& catalogue,
                                              const control::SampledPositionLaw& law) {
    std::vector<ParameterValue> values;
    for (const Role& role : Roles) {
        const std::string name = catalogue.parameterForRole(role.role);
        if (!name.empty() && role.member != &control::SampledPositionLaw::limit_A) {
            values.push_back({name, law.*role.member});
        }
    }
    return values;
}

} // namespace halbench::app
