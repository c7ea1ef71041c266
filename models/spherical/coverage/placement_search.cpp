#include "models/spherical/coverage/placement_search.h"

#include "control/base/units.h"
#include "models/spherical/coverage/difference_function.h"
#include "models/spherical/coverage/placement_pairs.h"
#include "models/spherical/tensor_rotation.h"
#include "models/spherical/tensor_system.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

namespace halbench::models {
namespace {

using Information = Eigen::Matrix<double, 5, 5>;

/// Poses for the predicted error: it varies little, +-15 % over the workspace.
constexpr double ErrorStep_rad = 22.5 * Pi / 180.0;
constexpr double ReadingStep_rad = 2.5 * Pi / 180.0;

struct Candidate {
    PlacementAngles angles;
    SensorPose pose;
    Information information; ///< H^T H of this sensor alone
};

Information informationOf(const SensorPose& pose) {
    Eigen::Matrix<double, 3, 5> design;
    for (int k = 0; k < 5; ++k) {
        design.col(k) =
            pose.axes.transpose() * tensorField_T(tensorOf(TensorVector::Unit(k)), 0.05, pose.position_m);
    }
    return design.transpose() * design;
}

bool isInRegion(const PlacementConstraints& constraints, const Eigen::Vector3d& position) {
    constexpr double Slack = 1e-9; // lattice angles are rounded
    const double theta = std::atan2(std::hypot(position.x(), position.y()), position.z());
    const double phi = std::atan2(position.y(), position.x());
    return theta >= constraints.lowestTheta_rad - Slack && theta <= constraints.highestTheta_rad + Slack &&
           phi >= constraints.lowestPhi_rad - Slack && phi <= constraints.highestPhi_rad + Slack;
}

double largestReading_T(const PlacedSensor& sensor) {
    const PoseGrid grid = workspaceGrid(7.5 * Pi / 180.0);
    double largest_T = 0.0;
    for (int a = 0; a < grid.alpha.count; ++a) {
        for (int b = 0; b < grid.beta.count; ++b) {
            const SensorSpin spin = sensor.spin(PlacedSensor::tiltOf(grid.alpha.at(a), grid.beta.at(b)));
            // Amplitude over the spin, which takes a whole period.
            const Eigen::Vector3d square = spin.cosine_T.cwiseAbs2() + spin.sine_T.cwiseAbs2();
            largest_T = std::fmax(largest_T, std::sqrt(square.maxCoeff()));
        }
    }
    return largest_T;
}

/// The parts of a search that do not change.
class Search {
public:
    Search(const PlacementSearchConfig& config, const WorkControl& control)
        : m_config(config), m_control(control),
          m_main(sensorPose(Eigen::Matrix3d::Identity(), config.device.radius_m)),
          m_mainInformation(informationOf(m_main)) {
        const PoseGrid poses = workspaceGrid(ErrorStep_rad);
        for (int a = 0; a < poses.alpha.count; ++a) {
            for (int b = 0; b < poses.beta.count; ++b) {
                for (int g = 0; g < poses.gamma.count; ++g) {
                    m_turns.push_back(unitTensorDerivative(
                        rotationOf({poses.alpha.at(a), poses.beta.at(b), poses.gamma.at(g)})));
                }
            }
        }
    }

    void collectCandidates() {
        const PoseGrid lattice = placementLattice(m_config.latticeStep_rad);
        const PlacementConstraints& constraints = m_config.constraints;
        for (std::size_t i = 0; i < lattice.size(); ++i) {
            const PlacementAngles angles = placementAt(lattice, i);
            const SensorPose pose =
                sensorPose(placementRotation(angles, m_config.device.frames), m_config.device.radius_m);
            const bool isApart = (pose.position_m - m_main.position_m).norm() >= constraints.leastDistance_m;
            if (!isInRegion(constraints, pose.position_m) || !isApart) {
                continue;
            }
            if (constraints.sensorRange_T &&
                largestReading_T(PlacedSensor(m_config.device, angles)) > *constraints.sensorRange_T) {
                continue;
            }
            m_candidates.push_back({angles, pose, informationOf(pose)});
        }
    }

    const std::vector<Candidate>& candidates() const { return m_candidates; }

    Result<std::vector<PlacementPair>> byReading(std::size_t wanted) const {
        std::vector<PlacementAngles> angles;
        for (const Candidate& candidate : m_candidates) {
            angles.push_back(candidate.angles);
        }
        return pairsByLeastReading(
            m_config.device, angles, [this](std::size_t i, std::size_t j) { return areApart(i, j); }, wanted,
            m_control);
    }

    /// The best pairs of places by a criterion that no roll about the radius changes; smaller is better.
    Result<std::vector<PlacementPair>> byPlace(PlacementObjective objective) const {
        const std::vector<std::size_t> places = distinctPlaces();
        std::vector<std::vector<PlacementPair>> rows(places.size());
        const auto worked = forEachInParallel(places.size(), m_control, [&](std::size_t a) {
            for (std::size_t b = a + 1; b < places.size(); ++b) {
                const std::size_t i = places[a];
                const std::size_t j = places[b];
                if (areApart(i, j)) {
                    rows[a].push_back({i, j, criterion(objective, i, j)});
                }
            }
            keepSmallest(rows[a]);
        });
        if (!worked) {
            return failure(worked.error());
        }
        std::vector<PlacementPair> pairs;
        for (const auto& row : rows) {
            pairs.insert(pairs.end(), row.begin(), row.end());
        }
        keepSmallest(pairs);
        return pairs;
    }

    PlacementResult assess(const PlacementPair& pair) const {
        return assessPlacement(
            m_config.device,
            {PlacementAngles{}, m_candidates[pair.first].angles, m_candidates[pair.second].angles},
            m_config.noise_T);
    }

private:
    bool areApart(std::size_t i, std::size_t j) const {
        return (m_candidates[i].pose.position_m - m_candidates[j].pose.position_m).norm() >=
               m_config.constraints.leastDistance_m;
    }

    std::vector<std::size_t> distinctPlaces() const {
        std::map<std::array<long, 3>, std::size_t> seen;
        for (std::size_t i = 0; i < m_candidates.size(); ++i) {
            std::array<long, 3> key{};
            for (std::size_t k = 0; k < 3; ++k) {
                key[k] = std::lround(1e8 * m_candidates[i].pose.position_m[static_cast<Eigen::Index>(k)]);
            }
            // Of the rolls at one place the one without da stands for all.
            const auto [at, isNew] = seen.try_emplace(key, i);
            if (!isNew && std::abs(m_candidates[i].angles.alpha_rad) <
                              std::abs(m_candidates[at->second].angles.alpha_rad)) {
                at->second = i;
            }
        }
        std::vector<std::size_t> places;
        for (const auto& [key, index] : seen) {
            places.push_back(index);
        }
        std::sort(places.begin(), places.end());
        return places;
    }

    void keepSmallest(std::vector<PlacementPair>& pairs) const {
        std::sort(pairs.begin(), pairs.end(), [](const PlacementPair& a, const PlacementPair& b) {
            return a.value != b.value ? a.value < b.value
                                      : std::pair(a.first, a.second) < std::pair(b.first, b.second);
        });
        pairs.resize(std::min(pairs.size(), m_config.finalists));
    }

    double criterion(PlacementObjective objective, std::size_t i, std::size_t j) const {
        const Information whole =
            m_mainInformation + m_candidates[i].information + m_candidates[j].information;
        if (objective == PlacementObjective::Conditioning) {
            const Eigen::SelfAdjointEigenSolver<Information> eigen(whole, Eigen::EigenvaluesOnly);
            return eigen.eigenvalues()[4] / std::fmax(eigen.eigenvalues()[0], 1e-12);
        }
        double sum = 0.0;
        for (const Eigen::Matrix<double, 5, 3>& turn : m_turns) {
            const Eigen::Matrix3d normal = turn.transpose() * whole * turn;
            sum += normal.inverse().trace();
        }
        return sum;
    }

    const PlacementSearchConfig& m_config;
    const WorkControl& m_control;
    SensorPose m_main;
    Information m_mainInformation;
    std::vector<Eigen::Matrix<double, 5, 3>> m_turns;
    std::vector<Candidate> m_candidates;
};

double worstComponent_T(const CoverageModel& model, const Eigen::Vector3d& pose) {
    return coverageValue(model, CoverageQuantity::LeastComponent_T, 0.0, {pose[0], pose[1], pose[2]});
}

/// Compass search from a grid pose within the workspace: steps along the axes and the diagonals, halved when
/// none improves. The function is a largest of magnitudes and has edges.
double descended_T(const CoverageModel& model, Eigen::Vector3d pose) {
    const Eigen::Vector3d border(0.25 * Pi, 0.25 * Pi, 0.5 * Pi);
    double least_T = worstComponent_T(model, pose);
    for (double step_rad = 0.5 * ReadingStep_rad; step_rad > 1e-4;) {
        bool isBetter = false;
        for (int direction = 0; direction < 27 && !isBetter; ++direction) {
            const Eigen::Vector3d way(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1);
            const Eigen::Vector3d next = (pose + step_rad * way).cwiseMax(-border).cwiseMin(border);
            const double value_T = worstComponent_T(model, next);
            if (value_T < least_T) {
                least_T = value_T;
                pose = next;
                isBetter = true;
            }
        }
        step_rad = isBetter ? step_rad : 0.5 * step_rad;
    }
    return least_T;
}

struct LowPose {
    double reading_T = HUGE_VAL;
    Eigen::Vector3d pose = Eigen::Vector3d::Zero();
};

/// The lowest pose of each block of a grid: of the whole grid the lowest ones lie in one valley.
std::vector<LowPose> lowestOfBlocks(const CoverageModel& model) {
    constexpr int Block = 6; // 15 degrees
    const PoseGrid grid = workspaceGrid(ReadingStep_rad);
    const int betas = grid.beta.count / Block + 1;
    const int gammas = grid.gamma.count / Block + 1;
    std::vector<LowPose> lowest(static_cast<std::size_t>((grid.alpha.count / Block + 1) * betas * gammas));
    for (int a = 0; a < grid.alpha.count; ++a) {
        for (int b = 0; b < grid.beta.count; ++b) {
            const SpinReadings spin = model.spinReadings(grid.alpha.at(a), grid.beta.at(b));
            for (int g = 0; g < grid.gamma.count; ++g) {
                const double gamma_rad = grid.gamma.at(g);
                const SphericalReadings readings_T =
                    spin.at(std::cos(2.0 * gamma_rad), std::sin(2.0 * gamma_rad));
                const double worst_T =
                    std::min({largestOfComponent_T(readings_T, 0), largestOfComponent_T(readings_T, 1),
                              largestOfComponent_T(readings_T, 2)});
                LowPose& low =
                    lowest[static_cast<std::size_t>((a / Block * betas + b / Block) * gammas + g / Block)];
                if (worst_T < low.reading_T) {
                    low = {worst_T, {grid.alpha.at(a), grid.beta.at(b), gamma_rad}};
                }
            }
        }
    }
    return lowest;
}

/// Least of a grid, refined from its lowest valleys.
double leastReading_T(const CoverageModel& model) {
    constexpr std::ptrdiff_t Starts = 16;
    std::vector<LowPose> lowest = lowestOfBlocks(model);
    std::partial_sort(lowest.begin(), lowest.begin() + Starts, lowest.end(),
                      [](const LowPose& a, const LowPose& b) { return a.reading_T < b.reading_T; });
    double least_T = HUGE_VAL;
    for (auto low = lowest.begin(); low != lowest.begin() + Starts; ++low) {
        least_T = std::min(least_T, descended_T(model, low->pose));
    }
    return least_T;
}

bool isBetter(PlacementObjective objective, const PlacementResult& a, const PlacementResult& b) {
    switch (objective) {
    case PlacementObjective::Conditioning:
        return a.conditioning < b.conditioning;
    case PlacementObjective::PredictedError:
        return a.deviation_rad < b.deviation_rad;
    case PlacementObjective::LeastReading:
        break;
    }
    return a.least_T > b.least_T;
}

bool dominates(const PlacementResult& a, const PlacementResult& b) {
    const bool isNoWorse =
        a.least_T >= b.least_T && a.conditioning <= b.conditioning && a.deviation_rad <= b.deviation_rad;
    return isNoWorse &&
           (a.least_T > b.least_T || a.conditioning < b.conditioning || a.deviation_rad < b.deviation_rad);
}

std::vector<PlacementResult> paretoOf(std::vector<PlacementResult> all) {
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.least_T > b.least_T; });
    std::vector<PlacementResult> front;
    for (const PlacementResult& one : all) {
        const bool isBeaten = std::any_of(
            all.begin(), all.end(), [&one](const PlacementResult& other) { return dominates(other, one); });
        const bool isKnown = std::any_of(front.begin(), front.end(), [&one](const PlacementResult& other) {
            // Mirror images differ in the last digits only.
            return std::abs(other.least_T - one.least_T) < 1e-9 &&
                   std::abs(other.conditioning - one.conditioning) < 1e-9;
        });
        if (!isBeaten && !isKnown) {
            front.push_back(one);
        }
    }
    return front;
}

/// Sensor 0 is not searched for: a range that it exceeds leaves nothing to find.
Result<void> checkMainSensor(const PlacementSearchConfig& config) {
    if (!config.constraints.sensorRange_T) {
        return {};
    }
    constexpr double Milli = 1e-3;
    const double range_T = *config.constraints.sensorRange_T;
    const double largest_T = largestReading_T(PlacedSensor(config.device, {}));
    if (largest_T <= range_T) {
        return {};
    }
    const double radius_m = config.device.radius_m * std::pow(largest_T / range_T, 0.25);
    return failure(ErrorCode::OutOfRange,
                   fmt::format("Sensor 0, which stays on +X, reads up to {:.0f} mT: more than the range of "
                               "{:g} mT.",
                               largest_T / Milli, range_T / Milli),
                   fmt::format("Use a range of at least {:.0f} mT, or sensors {:.1f} mm or more from the "
                               "centre.",
                               std::ceil(largest_T / Milli), std::ceil(10.0 * radius_m / Milli) / 10.0));
}

Result<void> checkSearch(const PlacementSearchConfig& config) {
    const double parts = 0.25 * Pi / config.latticeStep_rad;
    if (!(config.latticeStep_rad >= Pi / 180.0) || std::abs(parts - std::round(parts)) > 1e-6) {
        return failure(ErrorCode::OutOfRange,
                       "The step of the placement lattice must divide 45 degrees and be at least 1 degree.",
                       "Use 1, 1.5, 2.5, 3, 4.5, 5, 7.5, 9, 15, 22.5 or 45 degrees.");
    }
    if (config.device.device == SphericalDevice::Additive &&
        config.objective != PlacementObjective::LeastReading) {
        return failure(ErrorCode::OutOfRange, "An additive device has no tensor condition.",
                       "Use the objective coverage, or the exact device.");
    }
    if (config.device.radius_m <= config.device.rotorRadius_m || config.device.strength_T <= 0.0 ||
        config.noise_T <= 0.0 || config.finalists < 1) {
        return failure(ErrorCode::OutOfRange,
                       "A placement needs sensors outside the rotor, a positive strength and noise, and at "
                       "least one finalist.",
                       "Check the radius of the sensors, the strength of the rotor and the noise.");
    }
    return checkMainSensor(config);
}

PlacementResult& bestOf(PlacementObjective objective, std::vector<PlacementResult>& results) {
    return *std::min_element(results.begin(), results.end(),
                             [objective](const auto& a, const auto& b) { return isBetter(objective, a, b); });
}

/// Proves the best placement and gives it the reading of the proof. Where that is less than the search found,
/// by more than what the proof leaves open, another one is the best and is proven too. Readings within that
/// count as equal: mirror images differ in the last digits.
Result<CoverageProof> proveBest(const PlacementSearchConfig& config, std::vector<PlacementResult>& results,
                                const WorkControl& control) {
    CoverageProofConfig proof;
    proof.threshold_T = config.threshold_T;
    proof.gap_T = 1e-4;
    proof.cellLimit = 3000000;
    while (true) {
        PlacementResult& best = bestOf(config.objective, results);
        auto proven = proveCoverage(coverageModelOf(config.device, best.placement), proof, control);
        if (!proven) {
            return failure(proven.error());
        }
        for (const ComponentProof& component : proven->component) {
            best.least_T = std::min(best.least_T, component.least_T);
        }
        const bool isByReading = config.objective == PlacementObjective::LeastReading;
        const double equal_T = best.least_T + (isByReading ? proof.gap_T : 0.0);
        if (isByReading && bestOf(config.objective, results).least_T > equal_T) {
            continue;
        }
        for (PlacementResult& other : results) {
            other.least_T = other.least_T <= equal_T ? std::min(other.least_T, best.least_T) : other.least_T;
        }
        std::swap(results.front(), best); // the proven one stands for its equals
        return *std::move(proven);
    }
}

} // namespace

PlacementResult assessPlacement(const PlacementDevice& device, const SensorTriple& placement,
                                double noise_T) {
    const CoverageModel model = coverageModelOf(device, placement);
    WorkControl alone;
    alone.threads = 1;
    PlacementResult result;
    result.placement = placement;
    result.least_T = leastReading_T(model);
    const auto deviations = *coverageMap(model, CoverageQuantity::PredictedDeviation_rad, noise_T,
                                         workspaceGrid(ErrorStep_rad), alone);
    double square = 0.0;
    for (const float deviation : deviations) {
        square += static_cast<double>(deviation) * static_cast<double>(deviation);
    }
    result.deviation_rad = std::sqrt(square / static_cast<double>(deviations.size()));
    if (device.device == SphericalDevice::Exact) {
        SphericalSensing sensing;
        sensing.poses = sensorPoses(placement, device.frames, device.radius_m);
        result.conditioning = TensorSystem(sensing).conditioning();
    }
    return result;
}

namespace {

/// Of the pairs from the index `first` on.
Result<std::vector<PlacementResult>> assessed(const Search& search, const std::vector<PlacementPair>& pairs,
                                              std::size_t first, const WorkControl& control) {
    std::vector<PlacementResult> results(pairs.size() - first);
    const auto worked = forEachInParallel(
        results.size(), control, [&](std::size_t i) { results[i] = search.assess(pairs[first + i]); });
    return worked ? Result<std::vector<PlacementResult>>(std::move(results)) : failure(worked.error());
}

/// Finalists by their worst reading over coarse poses, which is never less than over all poses. Where none of
/// them keeps the threshold, as on lattices whose best coarse pairs have zeros between those poses, more are
/// examined as long as one of the rest could.
Result<std::vector<PlacementResult>>
resultsByReading(const Search& search, const PlacementSearchConfig& config, const WorkControl& control) {
    constexpr int Rounds = 4;
    constexpr std::size_t Growth = 4;
    std::vector<PlacementResult> results;
    std::size_t wanted = config.finalists;
    for (int round = 0; round < Rounds; ++round, wanted *= Growth) {
        const auto pairs = search.byReading(wanted);
        const auto more = pairs ? assessed(search, *pairs, std::min(results.size(), pairs->size()), control)
                                : Result<std::vector<PlacementResult>>(failure(pairs.error()));
        if (!more) {
            return failure(more.error());
        }
        results.insert(results.end(), more->begin(), more->end());
        const bool isKept = std::any_of(results.begin(), results.end(), [&config](const auto& one) {
            return one.least_T >= config.threshold_T;
        });
        if (isKept || pairs->size() < wanted || pairs->back().value < config.threshold_T) {
            break;
        }
    }
    return results;
}

} // namespace

Result<PlacementSearch> searchPlacement(const PlacementSearchConfig& config, const WorkControl& control) {
    if (auto checked = checkSearch(config); !checked) {
        return failure(checked.error());
    }
    Search search(config, control);
    search.collectCandidates();
    auto byReading = resultsByReading(search, config, control);
    if (!byReading) {
        return failure(byReading.error());
    }
    std::vector<PlacementResult> results = *std::move(byReading);
    if (config.device.device == SphericalDevice::Exact) {
        for (const PlacementObjective objective :
             {PlacementObjective::Conditioning, PlacementObjective::PredictedError}) {
            const auto pairs = search.byPlace(objective);
            auto more = pairs ? assessed(search, *pairs, 0, control)
                              : Result<std::vector<PlacementResult>>(failure(pairs.error()));
            if (!more) {
                return failure(more.error());
            }
            results.insert(results.end(), more->begin(), more->end());
        }
    }
    if (results.empty()) {
        return failure(ErrorCode::OutOfRange, "The constraints leave no pair of places for the sensors.",
                       "Widen the region, reduce the distance or raise the range of the sensor.");
    }
    auto proof = proveBest(config, results, control);
    if (!proof) {
        return failure(proof.error());
    }
    PlacementSearch found;
    const std::uint64_t count = search.candidates().size();
    found.pairs = count * (count - 1) / 2;
    found.best = bestOf(config.objective, results);
    found.proof = *std::move(proof);
    found.pareto = paretoOf(std::move(results));
    return found;
}

} // namespace halbench::models
