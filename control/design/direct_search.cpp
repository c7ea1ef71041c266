#include "control/design/direct_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace halbench::control {

DirectSearch::Point DirectSearch::from(const Point& start, double size) {
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        m_points[i] = start;
        if (i > 0) {
            m_points[i][i - 1] += size;
        }
        m_values[i] = m_cost(m_points[i]);
    }
    constexpr int MostRounds = 200;
    for (int round = 0; round < MostRounds; ++round) {
        sort();
        if (m_values[3] - m_values[0] <= 1e-6 * std::abs(m_values[0]) && std::isfinite(m_values[3])) {
            break;
        }
        improve();
    }
    sort();
    return m_points[0];
}

DirectSearch::Point DirectSearch::between(double share) const {
    Point point{};
    for (std::size_t j = 0; j < point.size(); ++j) {
        const double middle = (m_points[0][j] + m_points[1][j] + m_points[2][j]) / 3.0;
        point[j] = middle + share * (m_points[3][j] - middle);
    }
    return point;
}

void DirectSearch::improve() {
    const Point reflected = between(-1.0);
    const double value = m_cost(reflected);
    if (value < m_values[0]) {
        const Point expanded = between(-2.0);
        const double farther = m_cost(expanded);
        farther < value ? replace(expanded, farther) : replace(reflected, value);
        return;
    }
    if (value < m_values[2]) {
        replace(reflected, value);
        return;
    }
    const Point contracted = between(value < m_values[3] ? -0.5 : 0.5);
    const double nearer = m_cost(contracted);
    if (nearer < std::min(value, m_values[3])) {
        replace(contracted, nearer);
        return;
    }
    shrink();
}

void DirectSearch::shrink() {
    for (std::size_t i = 1; i < m_points.size(); ++i) {
        for (std::size_t j = 0; j < m_points[i].size(); ++j) {
            m_points[i][j] = 0.5 * (m_points[i][j] + m_points[0][j]);
        }
        m_values[i] = m_cost(m_points[i]);
    }
}

void DirectSearch::replace(const Point& point, double value) {
    m_points[3] = point;
    m_values[3] = value;
}

void DirectSearch::sort() {
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    std::sort(order.begin(), order.end(), [this](auto a, auto b) { return m_values[a] < m_values[b]; });
    const auto points = m_points;
    const auto values = m_values;
    for (std::size_t i = 0; i < order.size(); ++i) {
        m_points[i] = points[order[i]];
        m_values[i] = values[order[i]];
    }
}

DirectSearch::Point polished(const std::function<double(const DirectSearch::Point&)>& cost,
                             DirectSearch::Point point, double size, double least) {
    constexpr int Directions = 27; // the middle one is the point itself
    double best = cost(point);
    while (size >= least) {
        bool isBetter = false;
        for (int i = 0; i < Directions; ++i) {
            const DirectSearch::Point near = {point[0] + size * (i % 3 - 1),
                                              point[1] + size * (i / 3 % 3 - 1),
                                              point[2] + size * (i / 9 - 1)};
            const double value = i == Directions / 2 ? best : cost(near);
            if (value < best) {
                best = value;
                point = near;
                isBetter = true;
            }
        }
        size *= isBetter ? 1.0 : 0.5;
    }
    return point;
}

} // namespace halbench::control
