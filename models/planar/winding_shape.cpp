#include "models/planar/winding_shape.h"

#include "control/base/units.h"

#include <cmath>
#include <vector>

namespace halbench::models {
namespace {

using Complex = std::complex<double>;

struct Node {
    double place = 0.0; ///< in 0 ... 1
    double weight = 0.0;
};

// Gauss-Legendre rule on 0 ... 1: roots of P_n by Newton's method from Chebyshev's guess.
std::vector<Node> gaussNodes(int count) {
    std::vector<Node> nodes;
    for (int i = 0; i < count; ++i) {
        double x = std::cos(Pi * (i + 0.75) / (count + 0.5));
        double slope = 1.0;
        for (int iteration = 0; iteration < 20; ++iteration) {
            double previous = 1.0;
            double value = x;
            for (int n = 2; n <= count; ++n) {
                const double next = ((2.0 * n - 1.0) * x * value - (n - 1.0) * previous) / n;
                previous = value;
                value = next;
            }
            slope = count * (x * value - previous) / (x * x - 1.0);
            x -= value / slope;
        }
        nodes.push_back({0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope)});
    }
    return nodes;
}

// sin(x)/x
Complex sinc(Complex x) {
    // Below 1e-4 the next term of the series is 1e-18 of the sum.
    return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

// Integral of cos(k t) over -l/2 ... l/2.
Complex strip(Complex k, double length_m) {
    return length_m * sinc(0.5 * k * length_m);
}

// The four corners of radius r about the corners of the window: integral of cos(A u) cos(B v). With
// u = p/2 + r sin t the integrand is smooth in t; the integral over v is closed.
Complex corners(const PlanarGeometry& geometry, Complex A, Complex B, double radius_m) {
    static const std::vector<Node> Nodes = gaussNodes(24);
    Complex sum = 0.0;
    for (const Node& node : Nodes) {
        const double t = 0.5 * Pi * node.place;
        const double along_m = radius_m * std::sin(t);
        const double height_m = radius_m * std::cos(t);
        const Complex column =
            height_m * std::cos(0.5 * B * (geometry.shortStraight_m() + height_m)) * sinc(0.5 * B * height_m);
        sum += 0.5 * Pi * node.weight * height_m * std::cos(A * (0.5 * geometry.longStraight_m() + along_m)) *
               column;
    }
    return 4.0 * sum;
}

} // namespace

Complex windingShape_m2(const PlanarGeometry& geometry, Complex A, Complex B) {
    static const std::vector<Node> Nodes = gaussNodes(12);
    const double p_m = geometry.longStraight_m();
    const double q_m = geometry.shortStraight_m();
    const Complex along = strip(A, p_m);
    const Complex across = strip(B, q_m);
    Complex sum = 0.0;
    for (const Node& node : Nodes) {
        const double r_m = geometry.winding.width_m * node.place;
        const Complex turn = along * strip(B, q_m + 2.0 * r_m) +
                             (strip(A, p_m + 2.0 * r_m) - along) * across + corners(geometry, A, B, r_m);
        sum += node.weight * turn;
    }
    return geometry.winding.turnsPerWidth_1_m * geometry.winding.width_m * sum;
}

} // namespace halbench::models
