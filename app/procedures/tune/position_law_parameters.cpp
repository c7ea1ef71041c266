#include "app/procedures/tune/position_law_parameters.h"

#include <array>
#include <cmath>

namespace halbench::app {
namespace {

struct Role {
    const char* role;
    double models::PositionLaw::*member;
};

constexpr std::array Roles = {
    Role{"gain.kp", &models::PositionLaw::kp_A_per_rad},
    Role{"gain.ki", &models::PositionLaw::ki_A_per_rad_s},
    Role{"gain.kd", &models::PositionLaw::kd_As_per_rad},
    Role{"feedforward.inertia", &models::PositionLaw::inertia_As2_per_rad},
    Role{"feedforward.viscous", &models::PositionLaw::viscous_As_per_rad},
    Role{"feedforward.coulomb", &models::PositionLaw::coulomb_A},
    Role{"feedforward.coulomb_speed", &models::PositionLaw::coulombSpeed_rad_s},
    Role{"stiction.current", &models::PositionLaw::stiction_A},
    Role{"stiction.threshold", &models::PositionLaw::stictionThreshold_rad},
    Role{"stiction.speed", &models::PositionLaw::stictionSpeed_rad_s},
    Role{"limit.current", &models::PositionLaw::limit_A},
};

} // namespace

Result<models::PositionLaw> readPositionLaw(devices::Device& device) {
    std::vector<std::string> names;
    std::vector<double models::PositionLaw::*> members;
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
    models::PositionLaw law;
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
                                              const models::PositionLaw& law) {
    std::vector<ParameterValue> values;
    for (const Role& role : Roles) {
        const std::string name = catalogue.parameterForRole(role.role);
        if (!name.empty() && role.member != &models::PositionLaw::limit_A) {
            values.push_back({name, law.*role.member});
        }
    }
    return values;
}

} // namespace halbench::app
