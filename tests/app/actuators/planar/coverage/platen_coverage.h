#pragma once

#include "tests/app/actuators/planar/simulated_platen.h"

#include <map>
#include <string>

namespace halbench::app {

/// How often the 95 % interval of each constant holds the machine's own value, with all imperfections, the
/// mass given.
struct PlatenCoverage {
    std::map<std::string, int> covered;
    int runs = 0;
    int refused = 0;
};

inline PlatenCoverage countPlatenCoverage(int firstSeed, int lastSeed, const std::string& query,
                                          const models::PlanarParameters& machine) {
    const PlatenTruth truth(machine);
    const std::map<std::string, double> expected = {{"force_constant_12", truth.set12_N_per_A},
                                                    {"force_constant_34", truth.set34_N_per_A},
                                                    {"force_constant_56", truth.set56_N_per_A},
                                                    {"inertia", truth.inertia_kg_m2},
                                                    {"damping_x", truth.dampingX_Ns_per_m},
                                                    {"damping_y", truth.dampingY_Ns_per_m},
                                                    {"damping_phi", truth.dampingPhi_Nms},
                                                    {"stiffness_x", truth.stiffness_N_per_m},
                                                    {"stiffness_y", truth.stiffness_N_per_m},
                                                    {"friction_x", 0.0},
                                                    {"friction_y", 0.0},
                                                    {"friction_phi", 0.0},
                                                    {"centre_x", truth.centreX_m},
                                                    {"centre_y", truth.centreY_m}};
    PlatenCoverage coverage;
    for (int seed = firstSeed; seed <= lastSeed; ++seed) {
        const auto device = openPlaten(fmt::format("seed={}{}", seed, query));
        if (device == nullptr) {
            return coverage;
        }
        const AxesIdentifyResult result = identified(*device, givenMass(machine.mass_kg));
        ++coverage.runs;
        if (result.quality.verdict == Verdict::Refused) {
            ++coverage.refused;
            continue;
        }
        for (const auto& [name, value] : expected) {
            const control::Estimate* estimate = estimateIn(result.constants, name);
            coverage.covered[name] += estimate != nullptr && holds(*estimate, value);
        }
    }
    return coverage;
}

/// Machines that differ from the published one as the acceptance of the identification asks.
inline models::PlanarParameters heavyMachine() {
    models::PlanarParameters machine;
    machine.mass_kg = 0.9;
    return machine;
}
inline models::PlanarParameters realisticInertia() {
    models::PlanarParameters machine;
    machine.inertia_kg_m2 = 2.7e-3;
    return machine;
}
inline models::PlanarParameters strongMagnets() {
    models::PlanarParameters machine;
    machine.geometry.matrix.magnetisation_T *= 1.15;
    return machine;
}

} // namespace halbench::app
