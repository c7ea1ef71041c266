#include "models/fields/coil_inductance.h"

#include <cmath>

namespace halbench::models {
namespace {

constexpr double Permeability_4Pi = 1e-7; ///< mu0/(4 pi), H/m

/// Two parallel straight filaments with a common middle, at a distance.
double parallelSides_H(double first_m, double second_m, double distance_m) {
    const auto primitive = [distance_m](double z_m) {
        return z_m * std::asinh(z_m / distance_m) - std::hypot(z_m, distance_m);
    };
    return 2.0 * Permeability_4Pi *
           (primitive(0.5 * (first_m + second_m)) - primitive(0.5 * (first_m - second_m)));
}

/// A closed rectangle as it lies in a plane x = const.
struct Rectangle {
    double x_m;
    double halfWidth_m;
    double halfLength_m;
    double turns;
};

/// The coil's filaments with real end turns: coilFilaments() puts them all at the ends of the active length,
/// where they would lie upon each other.
std::vector<Rectangle> rectanglesOf(const RadialCoil& coil, int sections) {
    std::vector<Rectangle> rectangles;
    for (const CoilFilament& filament : coilFilaments(coil, sections)) {
        const double outward_m = filament.halfWidth_m - 0.5 * coil.meanWidth_m;
        rectangles.push_back({filament.radius_m, filament.halfWidth_m,
                              filament.halfLength_m + 0.5 * coil.windowTangential_m + outward_m,
                              filament.turns});
    }
    return rectangles;
}

/// Coaxial rectangles whose near sides are `sides_m` and `ends_m` apart.
double rectangles_H(const Rectangle& a, const Rectangle& b, double sides_m, double ends_m) {
    const double apart_m = a.x_m - b.x_m;
    const double farSides_m = std::hypot(a.halfWidth_m + b.halfWidth_m, apart_m);
    const double farEnds_m = std::hypot(a.halfLength_m + b.halfLength_m, apart_m);
    const auto pair = [](double first_m, double second_m, double near_m, double far_m) {
        return 2.0 * (parallelSides_H(first_m, second_m, near_m) - parallelSides_H(first_m, second_m, far_m));
    };
    return pair(2.0 * a.halfLength_m, 2.0 * b.halfLength_m, sides_m, farSides_m) +
           pair(2.0 * a.halfWidth_m, 2.0 * b.halfWidth_m, ends_m, farEnds_m);
}

double rectangles_H(const Rectangle& a, const Rectangle& b) {
    const double apart_m = a.x_m - b.x_m;
    return rectangles_H(a, b, std::hypot(a.halfWidth_m - b.halfWidth_m, apart_m),
                        std::hypot(a.halfLength_m - b.halfLength_m, apart_m));
}

} // namespace

double coilInductance_H(const RadialCoil& coil, int sections) {
    const std::vector<Rectangle> rectangles = rectanglesOf(coil, sections);
    double sum_H = 0.0;
    for (std::size_t i = 0; i < rectangles.size(); ++i) {
        const Rectangle& own = rectangles[i];
        const double share = std::sqrt(own.turns / coil.turns);
        const double ownDistance_m = 0.2235 * share * (coil.windowTangential_m + coil.windowRadial_m);
        sum_H += own.turns * own.turns * rectangles_H(own, own, ownDistance_m, ownDistance_m);
        for (std::size_t j = 0; j < i; ++j) {
            sum_H += 2.0 * own.turns * rectangles[j].turns * rectangles_H(own, rectangles[j]);
        }
    }
    return sum_H;
}

double oppositeCoilInductance_H(const RadialCoil& coil, int sections) {
    const std::vector<Rectangle> rectangles = rectanglesOf(coil, sections);
    double sum_H = 0.0;
    for (const Rectangle& own : rectangles) {
        for (Rectangle other : rectangles) {
            other.x_m = -other.x_m;
            sum_H += own.turns * other.turns * rectangles_H(own, other);
        }
    }
    return sum_H;
}

} // namespace halbench::models
