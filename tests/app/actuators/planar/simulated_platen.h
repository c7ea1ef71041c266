#pragma once

#include "app/actuators/actuator.h"
#include "devices/open/open_device.h"
#include "models/planar/planar_specimen.h"
#include "models/planar/windings_wrench.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

namespace halbench::app {

inline std::unique_ptr<devices::Device> openPlaten(const std::string& query) {
    auto device = devices::openDevice(query.empty() ? "sim:planar" : "sim:planar?" + query, {});
    EXPECT_TRUE(device) << device.error().message;
    return device ? std::move(*device) : nullptr;
}

inline AxesIdentifyResult identified(devices::Device& device, const IdentifyConfig& config) {
    const auto result = actuatorOf("planar").identify.run(device, config, {});
    EXPECT_TRUE(result) << result.error().message << " " << result.error().hint;
    return result ? std::get<AxesIdentifyResult>(*result) : AxesIdentifyResult{};
}

inline IdentifyConfig givenMass(double mass_kg) {
    IdentifyConfig config;
    EXPECT_TRUE(actuatorOf("planar").identify.setGiven(config, "m", mass_kg));
    return config;
}

inline const control::Estimate* estimateIn(const std::vector<NamedEstimate>& list, const std::string& name) {
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const NamedEstimate& each) { return each.name == name; });
    return found == list.end() ? nullptr : &found->estimate;
}

inline bool holds(const control::Estimate& estimate, double truth) {
    return estimate.interval95 && estimate.interval95->first <= truth && truth <= estimate.interval95->second;
}

inline bool hasFinding(const DataQuality& quality, const std::string& code) {
    return std::any_of(quality.findings.begin(), quality.findings.end(),
                       [&](const Finding& finding) { return finding.code == code; });
}

/// What the identification must find of a machine with these parameters: forces by the windings
/// (resources/help/planar-theory.md 5.3) times the gain of each coil; damping of the air films and of the
/// currents that the back-EMF K q' takes off the amplifiers' outputs, K^2/R_out in each set.
struct PlatenTruth {
    explicit PlatenTruth(const models::PlanarParameters& p) {
        const double b = -models::windingsForceConstant_N_per_A(p.geometry);
        const auto& g = p.coilGain_ratio;
        set12_N_per_A = 0.5 * b * (g[0] + g[1]);
        set34_N_per_A = 0.5 * b * (g[2] + g[3]);
        set56_N_per_A = 0.5 * b * (g[4] + g[5]);
        const double eddy = b * b / p.amplifierOutput_Ohm; // N s/m, of one set
        dampingX_Ns_per_m = p.damping_Ns_per_m + eddy;
        dampingY_Ns_per_m = p.damping_Ns_per_m + 2.0 * eddy;
        // Arms of the sets: 3L/4 for the first four coils, c56 for the others.
        const double arm_m = 0.75 * p.geometry.matrix.pitch_m;
        dampingPhi_Nms =
            p.damping_Nms_per_rad + eddy * (2.0 * arm_m * arm_m + p.geometry.arm56_m * p.geometry.arm56_m);
        mass_kg = p.mass_kg;
        inertia_kg_m2 = p.inertia_kg_m2;
        centreX_m = p.massCentreX_m;
        centreY_m = p.massCentreY_m;
        stiffness_N_per_m = p.cableStiffness_N_per_m;
    }
    double set12_N_per_A, set34_N_per_A, set56_N_per_A;
    double dampingX_Ns_per_m, dampingY_Ns_per_m, dampingPhi_Nms;
    double mass_kg, inertia_kg_m2, centreX_m, centreY_m, stiffness_N_per_m;
};

} // namespace halbench::app
