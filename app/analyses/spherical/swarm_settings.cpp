#include "app/analyses/spherical/swarm_settings.h"

#include "app/analyses/spherical/placement_choice.h"

#include <fmt/format.h>

namespace halbench::app {

std::vector<AnalysisKey> swarmSettingKeys() {
    using enum AnalysisKeyType;
    return {
        {"trigger", Choice, 0, 0, "signed|absolute",
         "swarm: when a reading of the main sensor is too small; default signed, as published"},
        {"rule", Choice, 0, 0, "largest|first|all",
         "swarm: residual that a component counts; default largest"},
        {"threshold_mT", Number, 0, 1e3, "", "swarm: reading below which a sensor is not used; default 10"},
        {"particles", Integer, 1, models::MaxParticles, "", "swarm: particles; default 30"},
        {"iterations", Integer, 1, 1000, "", "swarm: iterations at most; default 100"},
        {"inertia_first", Number, 0, 2, "", "swarm: inertia in the first iteration; default 0.9"},
        {"inertia_last", Number, 0, 2, "", "swarm: inertia in the last iteration; default 0.4"},
        {"c1", Number, 0, 10, "", "swarm: pull to the particle's own best place; default 2"},
        {"c2", Number, 0, 10, "", "swarm: pull to the best place of all; default 2"},
        {"velocity_clamp", Number, 1e-3, 2, "",
         "swarm: largest velocity over half the workspace; default 0.4"},
        {"swarm_stop_T2", Number, 0, 10, "",
         "swarm: fitness at which the projection begins, T^2; default 0.001"},
        {"projection_steps", Integer, 0, 10000, "", "swarm: steps of the projection at most; default 200"},
        {"projection_stop_T2", Number, 0, 10, "",
         "swarm: fitness at which the projection ends, T^2; default 1e-20"},
        {"step_limit_rad", Number, 1e-6, 3.2, "", "swarm: largest step of the projection; default 0.5"},
        {"k", Number, -1, 0, "", "swarm: gain in the null space of the projection; default -0.5"},
        {"cut", Number, 0, 0.5, "", "swarm: singular values left out, over the largest; default 0.0001"},
    };
}

models::SwarmConfig swarmSettings(const AnalysisValues& values) {
    models::SwarmConfig config;
    config.trigger =
        static_cast<models::SwarmTrigger>(choiceIndex(models::SwarmTriggerNames, values.text("trigger")));
    config.rule = static_cast<models::SwarmRule>(choiceIndex(models::SwarmRuleNames, values.text("rule")));
    const auto take = [&values](std::string_view key, auto& setting) {
        using Setting = std::decay_t<decltype(setting)>;
        setting = static_cast<Setting>(values.numberOr(key, static_cast<double>(setting)));
    };
    config.threshold_T = values.numberOr("threshold_mT", 1e3 * config.threshold_T) / 1e3;
    take("particles", config.particles);
    take("iterations", config.iterations);
    take("inertia_first", config.firstInertia);
    take("inertia_last", config.lastInertia);
    take("c1", config.ownPull);
    take("c2", config.commonPull);
    take("velocity_clamp", config.velocityLimit_ratio);
    take("swarm_stop_T2", config.swarmStop_T2);
    take("projection_steps", config.projectionSteps);
    take("projection_stop_T2", config.projectionStop_T2);
    take("step_limit_rad", config.stepLimit_rad);
    take("k", config.nullSpaceGain);
    take("cut", config.singularCut_ratio);
    return config;
}

Result<void> checkNoSwarmSettings(const AnalysisValues& values, const char* remedy) {
    for (const AnalysisKey& key : swarmSettingKeys()) {
        if (values.number(key.name) || !values.text(key.name).empty()) {
            return failure(ErrorCode::Usage,
                           fmt::format("{} is a setting of the estimator 'swarm'", optionOf(key)), remedy);
        }
    }
    return {};
}

JsonValue swarmJson(const models::SwarmConfig& config) {
    JsonValue settings = JsonValue::object();
    settings.set("trigger", models::SwarmTriggerNames[static_cast<std::size_t>(config.trigger)]);
    settings.set("rule", models::SwarmRuleNames[static_cast<std::size_t>(config.rule)]);
    settings.set("threshold_T", config.threshold_T).set("particles", config.particles);
    settings.set("iterations", config.iterations).set("first_inertia", config.firstInertia);
    settings.set("last_inertia", config.lastInertia).set("c1", config.ownPull).set("c2", config.commonPull);
    settings.set("velocity_clamp_ratio", config.velocityLimit_ratio);
    settings.set("swarm_stop_T2", config.swarmStop_T2).set("projection_steps", config.projectionSteps);
    settings.set("projection_stop_T2", config.projectionStop_T2).set("k", config.nullSpaceGain);
    settings.set("cut_ratio", config.singularCut_ratio);
    return settings.set("step_limit_rad", config.stepLimit_rad);
}

} // namespace halbench::app
