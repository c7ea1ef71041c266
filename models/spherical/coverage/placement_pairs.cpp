#include "models/spherical/coverage/placement_pairs.h"

#include "control/base/units.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>

namespace halbench::models {
namespace {

constexpr double CoarseStep_rad = 9.0 * Pi / 180.0;
/// No placement is expected to reach this share of q; levels begin there.
constexpr double FirstLevel_ratio = 0.6;
constexpr double LevelFall_ratio = 0.93;
constexpr double LastLevel_ratio = 1e-3;

/// Magnitudes at the poses and components where the main sensor stays below the first level, each line one of
/// those, its columns the candidates.
struct WeakPoses {
    std::vector<float> main_T;
    std::vector<std::vector<float>> candidate_T;
    std::vector<std::size_t> order; ///< those that the fewest candidates help first
};

WeakPoses weakPoses(const PlacementDevice& device, const std::vector<PlacementAngles>& candidates,
                    double level_T) {
    const PoseGrid grid = workspaceGrid(CoarseStep_rad);
    std::vector<PlacedSensor> placed;
    placed.reserve(candidates.size());
    for (const PlacementAngles& candidate : candidates) {
        placed.emplace_back(device, candidate);
    }
    const PlacedSensor main(device, {});
    WeakPoses weak;
    std::vector<SensorSpin> spins(candidates.size());
    for (int a = 0; a < grid.alpha.count; ++a) {
        for (int b = 0; b < grid.beta.count; ++b) {
            const auto tilt = PlacedSensor::tiltOf(grid.alpha.at(a), grid.beta.at(b));
            const SensorSpin own = main.spin(tilt);
            std::transform(placed.begin(), placed.end(), spins.begin(),
                           [&](const PlacedSensor& sensor) { return sensor.spin(tilt); });
            for (int g = 0; g < grid.gamma.count; ++g) {
                const double c = std::cos(2.0 * grid.gamma.at(g));
                const double s = std::sin(2.0 * grid.gamma.at(g));
                for (int k = 0; k < ComponentCount; ++k) {
                    const double main_T = std::fabs(own.cosine_T[k] * c + own.sine_T[k] * s);
                    if (main_T >= level_T) {
                        continue;
                    }
                    weak.main_T.push_back(static_cast<float>(main_T));
                    std::vector<float>& line = weak.candidate_T.emplace_back();
                    line.reserve(spins.size());
                    for (const SensorSpin& spin : spins) {
                        line.push_back(
                            static_cast<float>(std::fabs(spin.cosine_T[k] * c + spin.sine_T[k] * s)));
                    }
                }
            }
        }
    }
    return weak;
}

void sortByHelp(WeakPoses& weak, double level_T) {
    std::vector<std::ptrdiff_t> help;
    for (const std::vector<float>& line : weak.candidate_T) {
        help.push_back(std::count_if(line.begin(), line.end(), [level_T](float value) {
            return static_cast<double>(value) >= level_T;
        }));
    }
    weak.order.resize(help.size());
    std::iota(weak.order.begin(), weak.order.end(), std::size_t{0});
    std::stable_sort(weak.order.begin(), weak.order.end(),
                     [&help](std::size_t a, std::size_t b) { return help[a] < help[b]; });
}

double leastTogether_T(const WeakPoses& weak, std::size_t first, std::size_t second, double cap_T) {
    double least_T = cap_T;
    for (std::size_t e = 0; e < weak.main_T.size(); ++e) {
        const float largest =
            std::max({weak.main_T[e], weak.candidate_T[e][first], weak.candidate_T[e][second]});
        least_T = std::min(least_T, static_cast<double>(largest));
    }
    return least_T;
}

/// Candidates after `first` that reach the level at every pose where neither it nor the main sensor does.
std::vector<std::size_t> partners(const WeakPoses& weak, std::size_t first, std::size_t candidates,
                                  double level_T) {
    const auto level = static_cast<float>(level_T);
    std::vector<std::size_t> alive;
    bool isFresh = true;
    for (const std::size_t e : weak.order) {
        const std::vector<float>& line = weak.candidate_T[e];
        if (weak.main_T[e] >= level || line[first] >= level) {
            continue;
        }
        if (isFresh) {
            for (std::size_t j = first + 1; j < candidates; ++j) {
                if (line[j] >= level) {
                    alive.push_back(j);
                }
            }
            isFresh = false;
        } else {
            std::erase_if(alive, [&line, level](std::size_t j) { return line[j] < level; });
        }
        if (alive.empty()) {
            return alive;
        }
    }
    if (isFresh) {
        alive.resize(candidates - first - 1);
        std::iota(alive.begin(), alive.end(), first + 1);
    }
    return alive;
}

} // namespace

Result<std::vector<PlacementPair>>
pairsByLeastReading(const PlacementDevice& device, const std::vector<PlacementAngles>& candidates,
                    const std::function<bool(std::size_t, std::size_t)>& isAllowed, std::size_t wanted,
                    const WorkControl& control) {
    const double strength_T = device.strength_T * std::pow(0.05 / device.radius_m, 4);
    const double first_T = FirstLevel_ratio * strength_T;
    WeakPoses weak = weakPoses(device, candidates, first_T);
    std::vector<PlacementPair> pairs;
    for (double level_T = first_T; pairs.size() < wanted && level_T > LastLevel_ratio * strength_T;
         level_T *= LevelFall_ratio) {
        pairs.clear();
        sortByHelp(weak, level_T);
        std::mutex collecting;
        const auto worked = forEachInParallel(candidates.size(), control, [&](std::size_t i) {
            for (const std::size_t j : partners(weak, i, candidates.size(), level_T)) {
                if (isAllowed(i, j)) {
                    const PlacementPair pair{i, j, leastTogether_T(weak, i, j, first_T)};
                    const std::lock_guard lock(collecting);
                    pairs.push_back(pair);
                }
            }
        });
        if (!worked) {
            return failure(worked.error());
        }
    }
    // Threads found them in any order.
    std::sort(pairs.begin(), pairs.end(), [](const PlacementPair& a, const PlacementPair& b) {
        return a.value != b.value ? a.value > b.value
                                  : std::pair(a.first, a.second) < std::pair(b.first, b.second);
    });
    pairs.resize(std::min(pairs.size(), wanted));
    return pairs;
}

} // namespace halbench::models
