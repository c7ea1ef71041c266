#include "widgets/raster/curve_mask.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace halbench::widgets {
namespace {

constexpr int Full = 255;

// No value here is below zero, where this would be wrong; std::lround would be a call per pixel.
int rounded(double value) {
    return static_cast<int>(value + 0.5); // NOLINT(bugprone-incorrect-roundings)
}

/// Integral of clamp(s, 0, 1) from 0 to t.
double rampIntegral(double t) {
    return t <= 0.0 ? 0.0 : t < 1.0 ? 0.5 * t * t : t - 0.5;
}

/// Mean of clamp(edge - cell, 0, 1) while an edge goes straight from `a` to `b`: how much of the cell
/// [cell, cell + 1] lies below the edge.
double meanBelow(double a, double b, double cell) {
    if (std::abs(b - a) < 1e-6) {
        return std::clamp(a - cell, 0.0, 1.0);
    }
    return (rampIntegral(b - cell) - rampIntegral(a - cell)) / (b - a);
}

std::uint32_t blended(std::uint32_t under, std::uint32_t over, std::uint32_t alpha) {
    const std::uint32_t weight =
        alpha + (alpha >> 7); // 255 counts as 256: full coverage is the colour itself
    const std::uint32_t rest = 256U - weight;
    const std::uint32_t redBlue = ((over & 0xff00ffU) * weight + (under & 0xff00ffU) * rest) >> 8;
    const std::uint32_t green = ((over & 0xff00U) * weight + (under & 0xff00U) * rest) >> 8;
    return 0xff000000U | (redBlue & 0xff00ffU) | (green & 0xff00U);
}

} // namespace

void CurveMask::begin(int columns, int rows) {
    if (columns != m_columns || rows != m_rows) {
        m_columns = columns;
        m_rows = rows;
        m_coverage.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
    } else { // most of it was never touched
        for (int column = 0; column < columns; ++column) {
            const Rows& touched = m_touched[static_cast<std::size_t>(column)];
            std::fill(pixelsOf(column) + touched.first,
                      pixelsOf(column) + std::max(touched.first, touched.end), std::uint8_t{0});
        }
    }
    m_touched.assign(static_cast<std::size_t>(columns), Rows{rows, 0});
}

const std::uint8_t* CurveMask::pixelsOf(int column) const {
    return m_coverage.data() + static_cast<std::size_t>(column) * static_cast<std::size_t>(m_rows);
}

std::uint8_t* CurveMask::pixelsOf(int column) {
    return m_coverage.data() + static_cast<std::size_t>(column) * static_cast<std::size_t>(m_rows);
}

void CurveMask::touch(int column, int first, int end) {
    Rows& touched = m_touched[static_cast<std::size_t>(column)];
    touched.first = std::min(touched.first, first);
    touched.end = std::max(touched.end, end);
}

void CurveMask::add(int column, int row, double coverage) {
    if (column < 0 || column >= m_columns || row < 0 || row >= m_rows || coverage <= 0.0) {
        return;
    }
    std::uint8_t& pixel = pixelsOf(column)[row];
    pixel = static_cast<std::uint8_t>(std::min(Full, pixel + rounded(Full * coverage)));
    touch(column, row, row + 1);
}

void CurveMask::setPen(double width) {
    const double half = 0.5 * width;
    const int reach = static_cast<int>(std::ceil(half - 0.5)); // columns beside that the pen touches
    m_pen.clear();
    for (int away = 0; away <= reach; ++away) {
        m_pen.push_back({std::clamp(half + 0.5 - away, 0.0, 1.0),
                         std::sqrt(std::max(half * half - away * away, 0.0))}); // the pen is round
    }
    m_penWidth = width;
}

void CurveMask::addBox(int column, double top, double bottom, double width) {
    if (width != m_penWidth) { // a curve has thousands of boxes and one pen
        setPen(width);
    }
    raise(column, top - m_pen[0].beyond, bottom + m_pen[0].beyond, m_pen[0].covered);
    for (int away = 1; away < static_cast<int>(m_pen.size()); ++away) {
        const PenColumn& pen = m_pen[static_cast<std::size_t>(away)];
        raise(column - away, top - pen.beyond, bottom + pen.beyond, pen.covered);
        raise(column + away, top - pen.beyond, bottom + pen.beyond, pen.covered);
    }
}

void CurveMask::raise(int column, double top, double bottom, double covered) {
    top = std::max(top, 0.0);
    bottom = std::min(bottom, static_cast<double>(m_rows));
    if (column < 0 || column >= m_columns || bottom <= top) {
        return;
    }
    const int first = static_cast<int>(top);
    const int last = std::min(static_cast<int>(bottom), m_rows - 1);
    std::uint8_t* pixels = pixelsOf(column);
    const auto raiseTo = [pixels](int row, double coverage) {
        pixels[row] = std::max(pixels[row], static_cast<std::uint8_t>(rounded(Full * coverage)));
    };
    if (first == last) {
        raiseTo(first, covered * (bottom - top));
    } else {
        raiseTo(first, covered * (first + 1 - top));
        raiseTo(last, covered * (bottom - last));
        const auto whole = static_cast<std::uint8_t>(rounded(Full * covered));
        for (int row = first + 1; row < last; ++row) {
            pixels[row] = std::max(pixels[row], whole);
        }
    }
    touch(column, first, last + 1);
}

void CurveMask::addLine(PixelPoint from, PixelPoint to, double width) {
    const double dx = std::abs(to.x - from.x);
    const double dy = std::abs(to.y - from.y);
    if (dx == 0.0 && dy == 0.0) {
        return;
    }
    const double length = std::hypot(dx, dy);
    if (dy <= dx) {
        addFlatLine(from, to, 0.5 * width * length / dx);
    } else {
        addSteepLine(from, to, 0.5 * width * length / dy);
    }
}

void CurveMask::addFlatLine(PixelPoint from, PixelPoint to, double halfHeight) {
    const double slope = (to.y - from.y) / (to.x - from.x);
    const int first = std::max(0, static_cast<int>(std::floor(from.x)));
    const int last = std::min(m_columns - 1, static_cast<int>(std::ceil(to.x)) - 1);
    for (int column = first; column <= last; ++column) {
        const double left = std::max(from.x, static_cast<double>(column));
        const double right = std::min(to.x, column + 1.0);
        const double a = from.y + slope * (left - from.x);
        const double b = from.y + slope * (right - from.x);
        const int top = std::max(0, static_cast<int>(std::floor(std::min(a, b) - halfHeight)));
        const int bottom = std::min(m_rows - 1, static_cast<int>(std::floor(std::max(a, b) + halfHeight)));
        for (int row = top; row <= bottom; ++row) {
            add(column, row,
                (right - left) * (meanBelow(a + halfHeight, b + halfHeight, row) -
                                  meanBelow(a - halfHeight, b - halfHeight, row)));
        }
    }
}

void CurveMask::addSteepLine(PixelPoint from, PixelPoint to, double halfWidth) {
    if (from.y > to.y) {
        std::swap(from, to);
    }
    const double slope = (to.x - from.x) / (to.y - from.y);
    const int first = std::max(0, static_cast<int>(std::floor(from.y)));
    const int last = std::min(m_rows - 1, static_cast<int>(std::ceil(to.y)) - 1);
    for (int row = first; row <= last; ++row) {
        const double above = std::max(from.y, static_cast<double>(row));
        const double below = std::min(to.y, row + 1.0);
        const double a = from.x + slope * (above - from.y);
        const double b = from.x + slope * (below - from.y);
        const int left = static_cast<int>(std::floor(std::min(a, b) - halfWidth));
        const int right = static_cast<int>(std::floor(std::max(a, b) + halfWidth));
        for (int column = left; column <= right; ++column) {
            add(column, row,
                (below - above) * (meanBelow(a + halfWidth, b + halfWidth, column) -
                                   meanBelow(a - halfWidth, b - halfWidth, column)));
        }
    }
}

void CurveMask::addDot(PixelPoint centre, double diameter) {
    const double radius = 0.5 * diameter;
    const int reach = static_cast<int>(std::ceil(radius)) + 1;
    const int middleColumn = static_cast<int>(std::floor(centre.x));
    const int middleRow = static_cast<int>(std::floor(centre.y));
    for (int column = middleColumn - reach; column <= middleColumn + reach; ++column) {
        for (int row = middleRow - reach; row <= middleRow + reach; ++row) {
            const double distance = std::hypot(column + 0.5 - centre.x, row + 0.5 - centre.y);
            add(column, row, std::clamp(radius + 0.5 - distance, 0.0, 1.0));
        }
    }
}

void CurveMask::paint(QImage& image, const QColor& colour, const std::function<bool(int)>& isInk) const {
    const std::uint32_t over = colour.rgb();
    const int stride = image.bytesPerLine() / static_cast<int>(sizeof(std::uint32_t));
    auto* pixels = reinterpret_cast<std::uint32_t*>(image.bits());
    const int columns = std::min(m_columns, image.width());
    const int rows = image.height();
    for (int column = 0; column < columns; ++column) {
        const Rows& touched = m_touched[static_cast<std::size_t>(column)];
        if (touched.end <= touched.first || (isInk && !isInk(column))) {
            continue;
        }
        const std::uint8_t* coverage = pixelsOf(column);
        const int end = std::min(touched.end, rows);
        std::uint32_t* pixel = pixels + static_cast<std::ptrdiff_t>(touched.first) * stride + column;
        for (int row = touched.first; row < end; ++row, pixel += stride) {
            if (coverage[row] == Full) {
                *pixel = over;
            } else if (coverage[row] != 0) {
                *pixel = blended(*pixel, over, coverage[row]);
            }
        }
    }
}

} // namespace halbench::widgets
