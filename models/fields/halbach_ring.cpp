#include "models/fields/halbach_ring.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <array>
#include <cmath>

namespace halbench::models {
namespace {

using Corners = std::array<Eigen::Vector2d, 4>;

Corners cornersOf(const CuboidMagnet& magnet) {
    const Eigen::Vector2d along(std::cos(magnet.angle_rad), std::sin(magnet.angle_rad));
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::Vector2d a = magnet.halfSize_m.x() * along;
    const Eigen::Vector2d b = magnet.halfSize_m.y() * across;
    const Eigen::Vector2d centre = magnet.centre_m.head<2>();
    return {centre + a + b, centre + a - b, centre - a + b, centre - a - b};
}

/// Whether the shadows of both corner sets on a direction leave a gap.
bool isSeparatedAlong(const Eigen::Vector2d& direction, const Corners& first, const Corners& second) {
    double firstLow = direction.dot(first[0]);
    double firstHigh = firstLow;
    double secondLow = direction.dot(second[0]);
    double secondHigh = secondLow;
    for (std::size_t i = 1; i < 4; ++i) {
        firstLow = std::fmin(firstLow, direction.dot(first[i]));
        firstHigh = std::fmax(firstHigh, direction.dot(first[i]));
        secondLow = std::fmin(secondLow, direction.dot(second[i]));
        secondHigh = std::fmax(secondHigh, direction.dot(second[i]));
    }
    return firstHigh < secondLow || secondHigh < firstLow;
}

/// Separating-axis theorem for two rectangles: their four edge directions suffice.
bool overlap(const CuboidMagnet& first, const CuboidMagnet& second) {
    const Corners a = cornersOf(first);
    const Corners b = cornersOf(second);
    for (const double angle_rad : {first.angle_rad, second.angle_rad}) {
        const Eigen::Vector2d along(std::cos(angle_rad), std::sin(angle_rad));
        if (isSeparatedAlong(along, a, b) || isSeparatedAlong(Eigen::Vector2d(-along.y(), along.x()), a, b)) {
            return false;
        }
    }
    return true;
}

} // namespace

HalbachRing scatteredRing(const HalbachRing& nominal, const RingScatter& scatter, Random& random) {
    HalbachRing ring = nominal;
    ring.deviations.resize(static_cast<std::size_t>(ring.bars));
    for (BarDeviation& deviation : ring.deviations) {
        deviation.remanence_ratio = scatter.remanence_ratio * random.gaussian();
        deviation.angle_rad = scatter.angle_rad * random.gaussian();
    }
    return ring;
}

std::vector<CuboidMagnet> ringMagnets(const HalbachRing& ring, double psi_rad) {
    HB_ASSERT(ring.bars > 0);
    HB_ASSERT(ring.deviations.empty() || ring.deviations.size() == static_cast<std::size_t>(ring.bars));
    std::vector<CuboidMagnet> magnets(static_cast<std::size_t>(ring.bars));
    for (std::size_t j = 0; j < magnets.size(); ++j) {
        const BarDeviation deviation = ring.deviations.empty() ? BarDeviation{} : ring.deviations[j];
        const double theta_rad = 2.0 * Pi * static_cast<double>(j) / ring.bars;
        const double place_rad = theta_rad + psi_rad;
        magnets[j].centre_m = ring.radius_m * Eigen::Vector3d(std::cos(place_rad), std::sin(place_rad), 0.0);
        magnets[j].halfSize_m = ring.halfSize_m;
        magnets[j].angle_rad = 2.0 * theta_rad + psi_rad + deviation.angle_rad;
        magnets[j].remanence_T = ring.remanence_T * (1.0 + deviation.remanence_ratio);
    }
    return magnets;
}

Eigen::Vector3d magnetsField_T(const std::vector<CuboidMagnet>& magnets, const Eigen::Vector3d& point_m) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const CuboidMagnet& magnet : magnets) {
        sum += magnetField_T(magnet, point_m);
    }
    return sum;
}

Eigen::Vector2d longBarsField_T(const std::vector<CuboidMagnet>& magnets, const Eigen::Vector2d& point_m) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const CuboidMagnet& magnet : magnets) {
        sum += longBarField_T(magnet, point_m);
    }
    return sum;
}

double rodsCentreField_T(const HalbachRing& ring) {
    const double section_m2 = 4.0 * ring.halfSize_m.x() * ring.halfSize_m.y();
    return ring.bars * ring.remanence_T * section_m2 / (2.0 * Pi * ring.radius_m * ring.radius_m);
}

double idealCylinderField_T(double averageRemanence_T, double outerRadius_m, double innerRadius_m) {
    return averageRemanence_T * std::log(outerRadius_m / innerRadius_m);
}

double magnetAreaFraction(const HalbachRing& ring, double outerRadius_m, double innerRadius_m) {
    const double section_m2 = 4.0 * ring.halfSize_m.x() * ring.halfSize_m.y();
    return ring.bars * section_m2 / (Pi * (outerRadius_m * outerRadius_m - innerRadius_m * innerRadius_m));
}

bool doBarsOverlap(const HalbachRing& ring) {
    const std::vector<CuboidMagnet> magnets = ringMagnets(ring, 0.0);
    for (std::size_t j = 0; j < magnets.size(); ++j) {
        if (overlap(magnets[j], magnets[(j + 1) % magnets.size()])) {
            return true;
        }
    }
    return false;
}

} // namespace halbench::models
