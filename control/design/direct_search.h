#pragma once

#include <array>
#include <functional>

namespace halbench::control {

/// Smallest value of a function of three variables that may have kinks and be infinite, without derivatives:
/// Nelder, Mead (1965) with the usual coefficients. Deterministic.
class DirectSearch {
public:
    using Point = std::array<double, 3>;

    explicit DirectSearch(std::function<double(const Point&)> cost) : m_cost(std::move(cost)) {}

    /// The best point of one search that begins with a simplex of this size.
    Point from(const Point& start, double size);
    /// Its value.
    double best() const { return m_values[0]; }

private:
    Point between(double share) const;
    void improve();
    void shrink();
    void replace(const Point& point, double value);
    void sort();

    std::function<double(const Point&)> m_cost;
    std::array<Point, 4> m_points{};
    std::array<double, 4> m_values{};
};

/// Goes on from a point where a simplex has collapsed along a kink: tries its neighbours in all 26
/// directions, with steps from `size` down to `least`, halved when none of them is better.
DirectSearch::Point polished(const std::function<double(const DirectSearch::Point&)>& cost,
                             DirectSearch::Point point, double size, double least);

} // namespace halbench::control
