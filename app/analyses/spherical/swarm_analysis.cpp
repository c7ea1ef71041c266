#include "app/analyses/spherical/swarm_analysis.h"

#include "app/analyses/spherical/placement_choice.h"
#include "app/analyses/spherical/swarm_settings.h"
#include "control/base/units.h"
#include "models/spherical/orientation.h"
#include "models/spherical/rotor_motion.h"
#include "models/spherical/swarm_estimator.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace halbench::app {

namespace {

/// Fitness at which the second stage begins, one search each unless another is given, T^2.
constexpr std::array StartLevels_T2 = {1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4};
constexpr double Solved_rad = 0.0017453292519943296; ///< 0.1 degrees

/// One search with its own level.
struct Search {
    double level_T2 = 0.0;
    models::SwarmEstimate estimate;
    double shaftError_rad = 0.0;
    int evaluations = 0; ///< of the model
};

struct Convergence {
    PlacementChoice choice;
    models::SwarmConfig config;
    std::vector<double> levels_T2;
    std::vector<std::vector<double>> fitness_T2; ///< pose by pose, after each iteration of the swarm
    std::vector<Search> searches;
};

std::vector<AnalysisKey> swarmKeys() {
    using enum AnalysisKeyType;
    std::vector<AnalysisKey> keys = placementKeys();
    keys.push_back({"trajectory", Integer, 1, 4, "", "published trajectory of 25 poses; default 3"});
    keys.push_back({"spin_deg", Number, -180, 180, "", "spin along it; default 20"});
    for (AnalysisKey key : swarmSettingKeys()) {
        if (key.name == "swarm_stop_T2") {
            key.help =
                "swarm: fitness at which the projection begins, T^2; default one search for each of seven";
        }
        keys.push_back(key);
    }
    keys.push_back({"rng_seed", Integer, 0, 4294967295.0, "", "random numbers of the swarm; default 1"});
    return keys;
}

Result<Convergence> setupOf(const AnalysisValues& values) {
    const Result<PlacementChoice> choice = placementChoice(values);
    if (!choice) {
        return failure(choice.error());
    }
    Convergence work{*choice, swarmSettings(values), {StartLevels_T2.begin(), StartLevels_T2.end()}, {}, {}};
    if (values.number("swarm_stop_T2")) {
        work.levels_T2 = {work.config.swarmStop_T2};
    }
    return work;
}

double shaftError_rad(const models::OrientationAngles& found, const Eigen::Matrix3d& truth) {
    const Eigen::Vector3d shaft = models::nearestImage(models::rotationOf(found), truth).col(2);
    return std::atan2(shaft.cross(truth.col(2)).norm(), shaft.dot(truth.col(2)));
}

models::SphericalReadings readingsOf(const PlacementChoice& choice, const Eigen::Matrix3d& rotation) {
    return choice.coverageModel().readings_T(models::anglesOf(rotation));
}

/// All searches of one pose: the swarm to its end, then one search a level.
void searchPose(const models::AngleModel& model, const Eigen::Matrix3d& truth, Random& random,
                Convergence& work) {
    const models::SphericalReadings readings_T = readingsOf(work.choice, truth);
    models::SwarmConfig config = work.config;
    config.swarmStop_T2 = 0.0; // it is watched to its last iteration
    config.projectionSteps = 0;
    std::vector<double>& fitness = work.fitness_T2.emplace_back();
    models::estimateBySwarm(model, config, readings_T, random,
                            [&fitness](double best_T2) { fitness.push_back(best_T2); });
    config = work.config;
    for (const double level_T2 : work.levels_T2) {
        config.swarmStop_T2 = level_T2;
        Search search;
        search.level_T2 = level_T2;
        search.estimate = models::estimateBySwarm(model, config, readings_T, random);
        search.shaftError_rad = shaftError_rad(search.estimate.angles, truth);
        search.evaluations =
            config.particles * (1 + search.estimate.swarmIterations) + 2 * search.estimate.projectionSteps;
        work.searches.push_back(search);
    }
}

Result<void> searchAll(const AnalysisValues& values, const AnalysisControl& control, Convergence& work) {
    const models::AngleModel model =
        models::angleModel(models::additiveModelOf(work.choice.device, work.choice.placement));
    Random random(static_cast<std::uint64_t>(values.numberOr("rng_seed", 1.0)));
    const auto trajectory = static_cast<int>(values.numberOr("trajectory", 3.0));
    const double spin_rad = degreesToRadians(values.numberOr("spin_deg", 20.0));
    for (int i = 1; i <= models::PublishedSamples; ++i) {
        if (control.isStopped && control.isStopped()) {
            return failure(ErrorCode::Interrupted, "The search was stopped.");
        }
        if (control.onProgress) {
            control.onProgress((i - 1.0) / models::PublishedSamples);
        }
        const models::ShaftDirection shaft = models::publishedShaft(trajectory, i);
        searchPose(model, models::rotationOf(models::anglesForShaft(shaft, spin_rad)), random, work);
    }
    return {};
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// What all poses have after one iteration.
std::vector<double> afterIteration(const Convergence& work, std::size_t iteration) {
    std::vector<double> fitness_T2;
    for (const std::vector<double>& pose : work.fitness_T2) {
        fitness_T2.push_back(pose[iteration]);
    }
    return fitness_T2;
}

template <typename Value>
std::vector<double> ofLevel(const Convergence& work, double level_T2, Value value) {
    std::vector<double> values;
    for (const Search& search : work.searches) {
        if (search.level_T2 == level_T2) {
            values.push_back(value(search));
        }
    }
    return values;
}

JsonValue iterationsJson(const Convergence& work) {
    JsonValue rows = JsonValue::array();
    for (std::size_t i = 0; i < work.fitness_T2.front().size(); ++i) {
        const std::vector<double> fitness_T2 = afterIteration(work, i);
        JsonValue row = JsonValue::object();
        row.set("iteration", static_cast<std::uint64_t>(i + 1)).set("median_T2", median(fitness_T2));
        row.set("lowest_T2", *std::min_element(fitness_T2.begin(), fitness_T2.end()));
        rows.push(row.set("highest_T2", *std::max_element(fitness_T2.begin(), fitness_T2.end())));
    }
    return rows;
}

double solvedRatio(const Convergence& work, double level_T2) {
    const auto errors = ofLevel(work, level_T2, [](const Search& search) { return search.shaftError_rad; });
    const auto solved =
        std::count_if(errors.begin(), errors.end(), [](double error) { return error < Solved_rad; });
    return static_cast<double>(solved) / static_cast<double>(errors.size());
}

double medianWork(const Convergence& work, double level_T2) {
    return median(ofLevel(work, level_T2,
                          [](const Search& search) { return static_cast<double>(search.evaluations); }));
}

JsonValue levelsJson(const Convergence& work) {
    JsonValue rows = JsonValue::array();
    for (const double level_T2 : work.levels_T2) {
        JsonValue row = JsonValue::object();
        row.set("start_level_T2", level_T2).set("median_evaluations", medianWork(work, level_T2));
        rows.push(row.set("solved_ratio", solvedRatio(work, level_T2)));
    }
    return rows;
}

AnalysisTable tableOf(const Convergence& work) {
    AnalysisTable table;
    table.columns = {
        "pose",        "start_level_T2", "start_fitness_T2", "swarm_iterations", "projection_steps",
        "evaluations", "fitness_T2",     "shaft_error_rad"};
    for (std::size_t i = 0; i < work.searches.size(); ++i) {
        const Search& search = work.searches[i];
        table.values.insert(table.values.end(), {static_cast<double>(i / work.levels_T2.size() + 1),
                                                 search.level_T2, search.estimate.startFitness_T2,
                                                 static_cast<double>(search.estimate.swarmIterations),
                                                 static_cast<double>(search.estimate.projectionSteps),
                                                 static_cast<double>(search.evaluations),
                                                 search.estimate.fitness_T2, search.shaftError_rad});
    }
    return table;
}

/// Figure 9 of the publication, with evaluations in place of the time.
AnalysisPlot workPlot(const Convergence& work) {
    AnalysisCurve solved{"shaft found within 0.1 deg", {}, {}, true};
    AnalysisCurve missed{"not found", {}, {}, true};
    for (const Search& search : work.searches) {
        AnalysisCurve& curve = search.shaftError_rad < Solved_rad ? solved : missed;
        curve.x.push_back(search.estimate.startFitness_T2);
        curve.y.push_back(search.evaluations);
    }
    return {"Work of the search over the fitness where its second stage begins",
            {"fitness at the start of the gradient projection", "T^2", true},
            {{{"evaluations of the model", "", true}, {solved, missed}}},
            "One point a pose and start level; the time of a search is in proportion to its evaluations."};
}

/// Figure 10.
AnalysisPlot iterationPlot(const Convergence& work) {
    std::array<AnalysisCurve, 3> curves = {AnalysisCurve{"highest", {}, {}}, AnalysisCurve{"median", {}, {}},
                                           AnalysisCurve{"lowest", {}, {}}};
    for (std::size_t i = 0; i < work.fitness_T2.front().size(); ++i) {
        const std::vector<double> fitness_T2 = afterIteration(work, i);
        const std::array values = {*std::max_element(fitness_T2.begin(), fitness_T2.end()),
                                   median(fitness_T2),
                                   *std::min_element(fitness_T2.begin(), fitness_T2.end())};
        for (std::size_t c = 0; c < curves.size(); ++c) {
            curves[c].x.push_back(static_cast<double>(i + 1));
            curves[c].y.push_back(values[c]);
        }
    }
    return {"Best fitness of the swarm over its iterations",
            {"iteration", ""},
            {{{"fitness", "T^2", true}, {curves.begin(), curves.end()}}},
            "Over the 25 poses of the trajectory."};
}

std::string summaryOf(const Convergence& work) {
    std::string text =
        fmt::format("particle swarm and gradient projection, {} poses\n  {:>14} {:>12} {:>10}\n",
                    work.fitness_T2.size(), "start at T^2", "evaluations", "found");
    for (const double level_T2 : work.levels_T2) {
        text += fmt::format("  {:>14g} {:>12g} {:>8.0f} %\n", level_T2, medianWork(work, level_T2),
                            100.0 * solvedRatio(work, level_T2));
    }
    return text + fmt::format("  the swarm alone reaches {:.3g} T^2 in {} iterations (median)\n",
                              median(afterIteration(work, work.fitness_T2.front().size() - 1)),
                              work.fitness_T2.front().size());
}

Result<AnalysisOutcome> runSwarm(const AnalysisValues& values, const devices::RecordedFile*,
                                 const std::string&, const AnalysisControl& control) {
    Result<Convergence> work = setupOf(values);
    if (!work) {
        return failure(work.error());
    }
    if (const Result<void> done = searchAll(values, control, *work); !done) {
        return failure(done.error());
    }
    AnalysisOutcome outcome;
    outcome.body.set("placement", placementJson(work->choice.device, work->choice.placement));
    outcome.body.set("trajectory", static_cast<std::int64_t>(values.numberOr("trajectory", 3.0)));
    outcome.body.set("poses", static_cast<std::uint64_t>(work->fitness_T2.size()));
    JsonValue search = swarmJson(work->config);
    if (!values.number("swarm_stop_T2")) {
        search.set("swarm_stop_T2", JsonValue()); // each of by_start_level
    }
    outcome.body.set("particles", work->config.particles).set("search", std::move(search));
    outcome.body.set("by_iteration", iterationsJson(*work)).set("by_start_level", levelsJson(*work));
    outcome.summary = summaryOf(*work);
    outcome.table = tableOf(*work);
    outcome.plots = {workPlot(*work), iterationPlot(*work)};
    return outcome;
}

} // namespace

Analysis swarmAnalysis() {
    return {"swarm",
            "halbench.swarm/1",
            "Convergence of the published search for a spherical rotor's orientation",
            RecordingUse::None,
            true,
            swarmKeys(),
            runSwarm,
            sensingDevice()};
}

} // namespace halbench::app
