#include "app/procedures/tune/tune_axes.h"

#include "app/procedures/tune/loop_axis.h"
#include "control/assess/filtered_loop.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace halbench::app {
namespace {

Error ofAxis(const std::string& axis, const Error& error) {
    return {error.code, fmt::format("axis {}: {}", axis, error.message), error.hint};
}

Result<const IdentifiedAxis*> axisOf(const AxisModel& model, const std::string& name) {
    if (const IdentifiedAxis* axis = model.find(name)) {
        return axis;
    }
    std::vector<std::string> names;
    for (const IdentifiedAxis& axis : model.axes) {
        names.push_back(axis.axis);
    }
    return failure(ErrorCode::UnknownName, fmt::format("the model has no axis '{}'", name),
                   fmt::format("its axes are {}", fmt::join(names, ", ")));
}

TuneConfig configOf(const LoopConditions& conditions, const TuneAxesConfig& config) {
    constexpr double Load_ratio = 0.1;
    const double limit = conditions.currentLimit_A;
    TuneConfig single;
    single.method = config.method;
    single.targets = config.targets;
    single.conditions = conditions;
    single.draws = config.draws;
    single.seed = config.seed;
    single.load_A = config.load.value_or(limit < UnknownEffortLimit ? Load_ratio * limit : 1.0);
    return single;
}

/// All axes of a draw from one vector of the joint normal distribution: the same seed draws the same vectors
/// for each of them.
control::UncertainPlant jointPlant(const AxisModel& model, const IdentifiedAxis& axis) {
    const auto size = static_cast<Eigen::Index>(model.covarianceNames.size());
    control::UncertainPlant plant;
    plant.mean = Eigen::VectorXd::Zero(size);
    plant.covariance = Eigen::MatrixXd::Zero(size, size);
    std::array<Eigen::Index, 3> places = {-1, -1, -1}; // of this axis, in the order of the values below
    for (Eigen::Index i = 0; i < size; ++i) {
        for (Eigen::Index j = 0; j < size; ++j) {
            plant.covariance(i, j) =
                model.covariance[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        }
        const std::string& name = model.covarianceNames[static_cast<std::size_t>(i)];
        for (const IdentifiedAxis& any : model.axes) {
            const std::array values = {std::pair(".damping_rate", any.dampingRate.value),
                                       std::pair(".acceleration_gain", any.accelerationGain.value),
                                       std::pair(".breakaway_effort", any.breakawayEffort.value)};
            for (std::size_t k = 0; k < values.size(); ++k) {
                if (name == any.axis + values[k].first) {
                    plant.mean(i) = values[k].second.value_or(0.0);
                    places[k] = any.axis == axis.axis ? i : places[k];
                }
            }
        }
    }
    const std::array known = {axis.dampingRate.value.value_or(0.0), axis.accelerationGain.value.value_or(0.0),
                              axis.breakawayEffort.value.value_or(0.0)};
    plant.toPlant = [places, known](const Eigen::VectorXd& draw) {
        const auto value = [&](std::size_t k) { return places[k] < 0 ? known[k] : draw(places[k]); };
        return control::PositionPlant{std::max(value(0), 0.0), value(1), std::max(value(2), 0.0)};
    };
    return plant;
}

Result<std::optional<JointRobustness>> jointly(const AxisModel& model, const std::vector<TuneResult>& axes,
                                               const TuneAxesConfig& config) {
    if (model.covarianceNames.empty()) {
        return std::optional<JointRobustness>();
    }
    std::vector<bool> isUnstable(static_cast<std::size_t>(config.draws), false);
    for (const TuneResult& result : axes) {
        const auto joint = jointPlant(model, *model.find(result.conditions.axis->id));
        const auto plants = control::drawPlants(joint, config.draws, Random(config.seed));
        if (!plants) {
            return failure(ofAxis(result.conditions.axis->id, plants.error()));
        }
        const control::FilteredLaw law = asFiltered(LoopLaw(result.law, result.filtered));
        for (std::size_t i = 0; i < plants->size(); ++i) {
            const auto radius = control::filteredPoleRadius((*plants)[i], law, result.conditions.timing);
            isUnstable[i] = isUnstable[i] || !radius || *radius >= 1.0;
        }
    }
    const auto unstable = std::count(isUnstable.begin(), isUnstable.end(), true);
    return std::optional(JointRobustness{config.draws, static_cast<double>(unstable) / config.draws});
}

void addQuality(DataQuality& quality, const TuneResult& result) {
    quality.verdict = std::max(quality.verdict, result.quality.verdict);
    for (const Finding& finding : result.quality.findings) {
        quality.findings.push_back({finding.code,
                                    fmt::format("axis {}: {}", result.conditions.axis->id, finding.message),
                                    finding.hint});
    }
}

using Judge = std::function<Result<TuneResult>(const MotorEstimate&, const TuneConfig&, std::size_t)>;

Result<TuneAxesResult> forEachAxis(const AxisModel& model, const AxisConditions& conditions,
                                   const TuneAxesConfig& config, const Judge& judge) {
    if (const auto valid = checkAxisModel(model); !valid) {
        return failure(valid.error());
    }
    TuneAxesResult all;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
        const std::string& name = conditions[i].axis.value().id;
        const auto axis = axisOf(model, name);
        if (!axis) {
            return failure(axis.error());
        }
        auto result = judge(estimateOfAxis(model, **axis), configOf(conditions[i], config), i);
        if (!result) {
            return failure(ofAxis(name, result.error()));
        }
        addQuality(all.quality, *result);
        all.axes.push_back(*std::move(result));
    }
    auto joint = jointly(model, all.axes, config);
    if (!joint) {
        return failure(joint.error());
    }
    all.joint = *joint;
    return all;
}

} // namespace

Result<std::vector<std::string>> chosenAxesOf(const AxisModel& model, const std::string& name) {
    if (!name.empty() && name != "all") {
        const auto axis = axisOf(model, name);
        return axis ? Result<std::vector<std::string>>({(*axis)->axis}) : failure(axis.error());
    }
    std::vector<std::string> names;
    for (const IdentifiedAxis& axis : model.axes) {
        names.push_back(axis.axis);
    }
    return names;
}

Result<TuneAxesResult> tuneAxes(const AxisModel& model, const AxisConditions& conditions,
                                const TuneAxesConfig& config) {
    return forEachAxis(model, conditions, config,
                       [](const MotorEstimate& estimate, const TuneConfig& single, std::size_t) {
                           return runTune(estimate, single);
                       });
}

Result<TuneAxesResult> judgeAxes(const AxisModel& model, const AxisConditions& conditions,
                                 const std::vector<LoopLaw>& laws, const std::vector<std::string>& methods,
                                 const TuneAxesConfig& config) {
    return forEachAxis(model, conditions, config,
                       [&](const MotorEstimate& estimate, TuneConfig single, std::size_t i) {
                           single.method = methods.at(i);
                           return judgeLaw(estimate, laws.at(i), single);
                       });
}

} // namespace halbench::app
