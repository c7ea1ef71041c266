#include "models/spherical/coverage/difference_function.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <algorithm>
#include <cmath>

namespace halbench::models {
namespace {

struct Reducer {
    double sum = 0.0;
    double largest = 0.0;
    double least = HUGE_VAL;

    void add(double value) {
        sum += value;
        largest = std::fmax(largest, value);
        least = std::fmin(least, value);
    }
};

struct Signed {
    static double of(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).squaredNorm(); }
};
struct Absolute {
    static double of(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return (a.cwiseAbs() - b.cwiseAbs()).squaredNorm();
    }
};

/// Readings of the sensors in place and of the one to be placed.
struct Three {
    Eigen::Vector3d main_T;
    Eigen::Vector3d first_T;
    Eigen::Vector3d placed_T;

    template <typename Difference>
    double value(DifferenceFunction function) const {
        const double alone = Difference::of(placed_T, main_T);
        return function == DifferenceFunction::First ? alone : alone + Difference::of(placed_T, first_T);
    }
};

/// Sensors 0, 1 (fixed) and the placed one at one tilt.
struct TiltReadings {
    PlacedSensor::Tilt tilt;
    SensorSpin main;
    SensorSpin first;
};

} // namespace

PoseGrid placementLattice(double step_rad) {
    const int tilts = static_cast<int>(std::round(0.5 * Pi / step_rad)) + 1;
    const int spins = static_cast<int>(std::round(Pi / step_rad)) + 1;
    return {{-0.25 * Pi, step_rad, tilts}, {-0.25 * Pi, step_rad, tilts}, {-0.5 * Pi, step_rad, spins}};
}

PlacementAngles placementAt(const PoseGrid& lattice, std::size_t index) {
    const auto gammas = static_cast<std::size_t>(lattice.gamma.count);
    const auto betas = static_cast<std::size_t>(lattice.beta.count);
    return {lattice.alpha.at(static_cast<int>(index / (gammas * betas))),
            lattice.beta.at(static_cast<int>(index / gammas % betas)),
            lattice.gamma.at(static_cast<int>(index % gammas))};
}

Result<std::vector<DifferenceValues>> differenceValues(const PlacementDevice& device,
                                                       DifferenceFunction function,
                                                       const PlacementAngles& first, const PoseGrid& lattice,
                                                       const PoseGrid& poses, const WorkControl& control) {
    for (const PoseGrid& grid : {lattice, poses}) {
        if (auto checked = checkPoseGrid(grid); !checked) {
            return failure(checked.error());
        }
    }
    const PlacedSensor main(device, {});
    const PlacedSensor second(device, first);
    std::vector<TiltReadings> tilts;
    for (int a = 0; a < poses.alpha.count; ++a) {
        for (int b = 0; b < poses.beta.count; ++b) {
            const auto tilt = PlacedSensor::tiltOf(poses.alpha.at(a), poses.beta.at(b));
            tilts.push_back({tilt, main.spin(tilt), second.spin(tilt)});
        }
    }
    std::vector<Eigen::Vector2d> spins;
    for (int g = 0; g < poses.gamma.count; ++g) {
        spins.emplace_back(std::cos(2.0 * poses.gamma.at(g)), std::sin(2.0 * poses.gamma.at(g)));
    }
    const auto home = PlacedSensor::tiltOf(0.0, 0.0);
    std::vector<DifferenceValues> values(lattice.size());
    const auto worked = forEachInParallel(values.size(), control, [&](std::size_t index) {
        const PlacedSensor placed(device, placementAt(lattice, index));
        Reducer plain;
        Reducer magnitudes;
        for (const TiltReadings& tilt : tilts) {
            const SensorSpin own = placed.spin(tilt.tilt);
            for (const Eigen::Vector2d& spin : spins) {
                const Three three{tilt.main.cosine_T * spin[0] + tilt.main.sine_T * spin[1],
                                  tilt.first.cosine_T * spin[0] + tilt.first.sine_T * spin[1],
                                  own.cosine_T * spin[0] + own.sine_T * spin[1]};
                plain.add(three.value<Signed>(function));
                magnitudes.add(three.value<Absolute>(function));
            }
        }
        const Three upright{main.spin(home).cosine_T, second.spin(home).cosine_T, placed.spin(home).cosine_T};
        const auto count = static_cast<double>(poses.size());
        values[index].signed_T2 = {plain.sum / count, plain.largest, plain.least,
                                   upright.value<Signed>(function)};
        values[index].absolute_T2 = {magnitudes.sum / count, magnitudes.largest, magnitudes.least,
                                     upright.value<Absolute>(function)};
    });
    if (!worked) {
        return failure(worked.error());
    }
    return values;
}

Result<DifferenceRanking> rankDifference(const std::vector<DifferenceValues>& values, const PoseGrid& lattice,
                                         bool isAbsolute, DifferenceReduction reduction,
                                         const PlacementAngles& claimed) {
    HB_ASSERT(values.size() == lattice.size());
    const auto which = static_cast<std::size_t>(reduction);
    const auto valueAt = [&](std::size_t i) {
        return isAbsolute ? values[i].absolute_T2[which] : values[i].signed_T2[which];
    };
    DifferenceRanking ranking;
    std::size_t claimedIndex = values.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const PlacementAngles at = placementAt(lattice, i);
        if (std::abs(at.alpha_rad - claimed.alpha_rad) + std::abs(at.beta_rad - claimed.beta_rad) +
                std::abs(at.gamma_rad - claimed.gamma_rad) <
            1e-9) {
            claimedIndex = i;
        }
        ranking.best_T2 = std::max(ranking.best_T2, valueAt(i));
    }
    if (claimedIndex == values.size()) {
        return failure(ErrorCode::OutOfRange, "The claimed placement is not on the lattice.");
    }
    const double tie_T2 = 1e-9 * ranking.best_T2;
    ranking.claimed_T2 = valueAt(claimedIndex);
    ranking.rank = 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        ranking.rank += valueAt(i) > ranking.claimed_T2 + tie_T2;
        if (valueAt(i) >= ranking.best_T2 - tie_T2) {
            ranking.bestAt.push_back(placementAt(lattice, i));
        }
    }
    return ranking;
}

} // namespace halbench::models
