#include "widgets/actuators/htm/rotor_field_lines.h"

#include "control/base/assert.h"
#include "control/base/units.h"

#include <algorithm>
#include <cmath>

namespace halbench::widgets {
namespace {

constexpr double Step_m = 0.75e-3;
constexpr int MostSteps = 1200;         ///< 0.6 m, three times round the longest loop
constexpr double Tolerance_m = 0.04e-3; ///< a quarter of a pixel at 500 px
constexpr int PointsPerArc = 48;
constexpr double LargestSeed_ratio = 0.96; ///< of the bore: beyond it a line only skirts the magnets

/// Heights of lines with equal flux between neighbours in a uniform field, symmetric about the axis.
std::vector<double> seeds_m(const RotorGeometry& geometry, int lines) {
    HB_ASSERT(lines >= 2 && lines % 2 == 0); // none on the axis, which never closes
    const double reach_m = LargestSeed_ratio * geometry.boreRadius_m();
    std::vector<double> seeds;
    for (int i = 0; i < lines; ++i) {
        seeds.push_back(reach_m * (2.0 * (i + 0.5) / lines - 1.0));
    }
    return seeds;
}

double distanceToChord_m(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d chord = b - a;
    const double length2 = chord.squaredNorm();
    const double along = length2 > 0.0 ? std::clamp((point - a).dot(chord) / length2, 0.0, 1.0) : 0.0;
    return (point - a - along * chord).norm();
}

/// Douglas and Peucker: the fewest of the points that stay within the tolerance of all.
void keepNeeded(const FieldLine& line, std::size_t first, std::size_t last, std::vector<bool>& keep) {
    std::size_t farthest = first;
    double distance_m = Tolerance_m;
    for (std::size_t i = first + 1; i < last; ++i) {
        const double here_m = distanceToChord_m(line[i], line[first], line[last]);
        if (here_m > distance_m) {
            distance_m = here_m;
            farthest = i;
        }
    }
    if (farthest != first) {
        keep[farthest] = true;
        keepNeeded(line, first, farthest, keep);
        keepNeeded(line, farthest, last, keep);
    }
}

FieldLine simplified(const FieldLine& line) {
    std::vector<bool> keep(line.size(), false);
    keep.front() = keep.back() = true;
    keepNeeded(line, 0, line.size() - 1, keep);
    FieldLine few;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (keep[i]) {
            few.push_back(line[i]);
        }
    }
    return few;
}

/// A loop from its quarter right of and above the middle, the other three being its mirror images.
FieldLine wholeLoop(const FieldLine& quarter, bool isUpper) {
    FieldLine loop(quarter);
    for (auto point = quarter.rbegin(); point != quarter.rend(); ++point) {
        loop.emplace_back(-point->x(), point->y());
    }
    if (!isUpper) {
        for (Eigen::Vector2d& point : loop) {
            point.y() = -point.y();
        }
    }
    return simplified(loop);
}

/// The ideal line that crosses the middle of the bore at height y > 0.
FieldLine idealQuarter(const RotorGeometry& geometry, double y_m) {
    const double inner_m = geometry.boreRadius_m();
    const double outer_m = geometry.outerRadius_m();
    const double level_m = y_m * std::log(outer_m / inner_m); // A/B_r of the line
    const double start_rad = std::asin(y_m / inner_m);
    FieldLine quarter{{0.0, y_m}};
    for (int i = 0; i <= PointsPerArc; ++i) {
        const double theta_rad = start_rad + (Pi / 2.0 - start_rad) * i / PointsPerArc;
        // r ln(R_o/r) falls with r beyond R_o/e, which lies inside the bore: r is unique.
        double low_m = inner_m;
        double high_m = outer_m;
        for (int halving = 0; halving < 40; ++halving) {
            const double r_m = 0.5 * (low_m + high_m);
            (r_m * std::log(outer_m / r_m) * std::sin(theta_rad) > level_m ? low_m : high_m) = r_m;
        }
        quarter.emplace_back(low_m * std::cos(theta_rad), low_m * std::sin(theta_rad));
    }
    return quarter;
}

Eigen::Vector2d direction(const std::vector<models::CuboidMagnet>& magnets, const Eigen::Vector2d& point_m) {
    const Eigen::Vector2d field = models::longBarsField_T(magnets, point_m);
    return field / std::max(field.norm(), 1e-12);
}

/// Midpoint rule in the arc length; long steps where the field is nearly uniform. Near the bars a line bends
/// within 3 mm at most: h^3/(24 r^2) = 2 micrometres per step.
Eigen::Vector2d stepAlong(const std::vector<models::CuboidMagnet>& magnets, const Eigen::Vector2d& at_m,
                          double quiet_m) {
    const double step_m = at_m.norm() < quiet_m ? 4.0 * Step_m : Step_m;
    return at_m + step_m * direction(magnets, at_m + 0.5 * step_m * direction(magnets, at_m));
}

/// The line through the bars from height y > 0 to where it crosses the middle plane again. Rings with an
/// even number of equal bars are their own mirror image.
FieldLine followedQuarter(const RotorGeometry& geometry, const std::vector<models::CuboidMagnet>& magnets,
                          double y_m) {
    FieldLine quarter{{0.0, y_m}};
    for (int i = 0; i < MostSteps; ++i) {
        const Eigen::Vector2d next = stepAlong(magnets, quarter.back(), 0.75 * geometry.boreRadius_m());
        if (next.x() <= 0.0 || next.norm() > geometry.housingRadius_m) {
            break;
        }
        quarter.push_back(next);
    }
    return quarter;
}

} // namespace

double RotorGeometry::outerRadius_m() const {
    return ring.radius_m + ring.halfSize_m.head<2>().norm();
}

double RotorGeometry::boreRadius_m() const {
    return ring.radius_m - ring.halfSize_m.head<2>().norm();
}

std::vector<FieldLine> idealFieldLines(const RotorGeometry& geometry, int lines) {
    std::vector<FieldLine> result;
    for (const double y_m : seeds_m(geometry, lines)) {
        result.push_back(wholeLoop(idealQuarter(geometry, std::abs(y_m)), y_m > 0.0));
    }
    return result;
}

std::vector<FieldLine> segmentedFieldLines(const RotorGeometry& geometry, int lines) {
    HB_ASSERT(geometry.ring.bars % 2 == 0 && geometry.ring.deviations.empty());
    const auto magnets = models::ringMagnets(geometry.ring, 0.0);
    std::vector<FieldLine> result;
    for (const double y_m : seeds_m(geometry, lines)) {
        if (y_m > 0.0) {
            const FieldLine quarter = followedQuarter(geometry, magnets, y_m);
            result.push_back(wholeLoop(quarter, true));
            result.push_back(wholeLoop(quarter, false));
        }
    }
    return result;
}

std::vector<FieldLine> uniformFieldLines(const RotorGeometry& geometry, int lines) {
    std::vector<FieldLine> result;
    const double radius_m = geometry.boreRadius_m();
    for (const double y_m : seeds_m(geometry, lines)) {
        const double x_m = std::sqrt(radius_m * radius_m - y_m * y_m);
        result.push_back({{-x_m, y_m}, {x_m, y_m}});
    }
    return result;
}

} // namespace halbench::widgets
