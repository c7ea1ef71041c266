#include "widgets/actuators/planar/lattice_map.h"

#include "widgets/actuators/planar/platen_state.h"
#include "widgets/theme/theme_style.h"

#include <QPainter>
#include <QVector>

#include <algorithm>
#include <cmath>
#include <vector>

namespace halbench::widgets {

namespace {

constexpr int Levels = 256;
constexpr double FullShare = 0.55;       ///< of the curve's colour at the largest field
constexpr double SmallestGlyph_px = 9.0; ///< blocks below this have no arrow
constexpr double HalfEdge = 0.5 * MatrixEdge_pitches;

/// B_z along one axis: the other array adds its own.
std::vector<float> fieldAlong(const models::PlanarGeometry& geometry, double first_m, double step_m,
                              int count) {
    std::vector<float> field_T(static_cast<std::size_t>(count));
    const double wave_per_m = models::waveNumber_per_m(geometry.matrix);
    for (const int order : models::MatrixOrders) {
        const double amplitude_T = models::harmonicAmplitude_T(geometry.matrix, order, coilPlane_m(geometry));
        for (std::size_t i = 0; i < field_T.size(); ++i) {
            const double place_m = first_m + step_m * static_cast<double>(i);
            field_T[i] += static_cast<float>(amplitude_T * std::cos(order * wave_per_m * place_m));
        }
    }
    return field_T;
}

/// First and one past the last index of a range of samples between -edge and edge.
std::pair<int, int> inside(double first_m, double step_m, int count, double edge_m) {
    const double low = (-edge_m - first_m) / step_m;
    const double high = (edge_m - first_m) / step_m;
    const auto index = [&](double value) {
        return static_cast<int>(std::clamp(std::ceil(value), 0.0, static_cast<double>(count)));
    };
    return {index(std::min(low, high)), index(std::max(low, high))};
}

/// An arrow of the magnetisation in the plane; a dot where it comes out of it, a cross where it goes in.
void addGlyph(const Eigen::Vector3d& direction, const QPointF& middle, double size, QVector<QLineF>& lines,
              QPainter& painter) {
    const Eigen::Vector2d flat = direction.head<2>();
    QPointF sign = middle;
    if (flat.norm() > 0.1) {
        const Eigen::Vector2d along = flat.normalized();
        const QPointF half(0.32 * size * along.x(), -0.32 * size * along.y());
        const QPointF side(-0.5 * half.y(), 0.5 * half.x());
        const QPointF tip = middle + half;
        lines << QLineF(middle - half, tip) << QLineF(tip, tip - 0.5 * half + side)
              << QLineF(tip, tip - 0.5 * half - side);
        sign = middle - half;
    }
    if (std::abs(direction.z()) < 0.1) {
        return;
    }
    const double radius = (flat.norm() > 0.1 ? 0.09 : 0.22) * size;
    if (direction.z() > 0.0) {
        painter.drawEllipse(sign, radius, radius);
    } else {
        lines << QLineF(sign - QPointF(radius, radius), sign + QPointF(radius, radius))
              << QLineF(sign - QPointF(radius, -radius), sign + QPointF(radius, -radius));
    }
}

} // namespace

double coilPlane_m(const models::PlanarGeometry& geometry) {
    return geometry.gap_m + 0.5 * geometry.winding.height_m;
}

double largestField_T(const models::PlanarGeometry& geometry) {
    return models::matrixField_T(geometry.matrix, {0.0, 0.0, coilPlane_m(geometry)}).z();
}

QColor fieldColour(const Theme& theme, double share) {
    return mixed(theme.plotBackground, theme.curves[share >= 0.0 ? 5 : 4],
                 FullShare * std::min(std::abs(share), 1.0));
}

const QImage& LatticeMap::image(const models::PlanarGeometry& geometry, const MapScale& scale,
                                const QSize& size_px, double ratio, const Theme& theme) {
    const QSize pixels = size_px * ratio;
    const bool isSame = m_image.size() == pixels && m_image.devicePixelRatio() == ratio && m_scale == scale &&
                        m_pitch_m == geometry.matrix.pitch_m && m_background == theme.plotBackground;
    if (isSame) {
        return m_image;
    }
    if (m_image.size() != pixels) {
        m_image = QImage(pixels, QImage::Format_RGB32);
    }
    m_image.setDevicePixelRatio(ratio);
    m_scale = scale;
    m_pitch_m = geometry.matrix.pitch_m;
    m_background = theme.plotBackground;
    paintField(geometry, theme);
    paintBlocks(geometry, theme);
    return m_image;
}

void LatticeMap::paintField(const models::PlanarGeometry& geometry, const Theme& theme) {
    m_image.fill(theme.plotBackground);
    std::array<QRgb, Levels + 1> colours{};
    for (int level = 0; level <= Levels; ++level) {
        colours[static_cast<std::size_t>(level)] = fieldColour(theme, 2.0 * level / Levels - 1.0).rgb();
    }
    const double ratio = m_image.devicePixelRatio();
    const double step_m = 1.0 / (m_scale.pixels_per_m * ratio);
    const Eigen::Vector2d corner_m = m_scale.placeOf_m({0.5 / ratio, 0.5 / ratio});
    const double edge_m = HalfEdge * m_pitch_m;
    const std::vector<float> along = fieldAlong(geometry, corner_m.x(), step_m, m_image.width());
    const std::vector<float> down = fieldAlong(geometry, corner_m.y(), -step_m, m_image.height());
    const auto [left, right] = inside(corner_m.x(), step_m, m_image.width(), edge_m);
    const auto [top, bottom] = inside(corner_m.y(), -step_m, m_image.height(), edge_m);
    const float scale = static_cast<float>(0.5 * Levels / largestField_T(geometry));
    for (int y = top; y < bottom; ++y) {
        auto* line = reinterpret_cast<QRgb*>(m_image.scanLine(y));
        const float row = scale * down[static_cast<std::size_t>(y)] + 0.5F * Levels + 0.5F;
        for (int x = left; x < right; ++x) {
            const float level = std::clamp(row + scale * along[static_cast<std::size_t>(x)], 0.0F,
                                           static_cast<float>(Levels));
            line[x] = colours[static_cast<std::size_t>(level)];
        }
    }
}

void LatticeMap::paintBlocks(const models::PlanarGeometry& geometry, const Theme& theme) {
    const double side_px = 0.25 * geometry.matrix.pitch_m * m_scale.pixels_per_m;
    if (side_px < SmallestGlyph_px) {
        return;
    }
    QPainter painter(&m_image);
    painter.setRenderHint(QPainter::Antialiasing, side_px > 16.0);
    painter.setBrush(Qt::NoBrush);
    const QSizeF size = QSizeF(m_image.size()) / m_image.devicePixelRatio();
    const QRectF shown(QPointF(), size);
    const int last = static_cast<int>(4.0 * HalfEdge) - 1; // whole blocks
    QVector<QLineF> arrows;
    QVector<QLineF> edges;
    painter.setPen(QPen(mixed(theme.plotBackground, theme.text, 0.55), 1.0));
    for (int column = -last; column <= last; ++column) {
        for (int row = -last; row <= last; ++row) {
            const Eigen::Vector2d middle_m = 0.25 * m_pitch_m * Eigen::Vector2d(column, row);
            const QPointF middle = m_scale.at(middle_m);
            const QPointF half(0.5 * side_px, 0.5 * side_px);
            const QRectF block(middle - half, middle + half);
            const Eigen::Vector3d direction = blockDirection(column, row);
            if (shown.intersects(block) && !direction.isZero()) {
                addGlyph(direction, middle, side_px, arrows, painter);
                edges << QLineF(block.topLeft(), block.topRight())
                      << QLineF(block.topLeft(), block.bottomLeft());
            }
        }
    }
    painter.drawLines(arrows);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(mixed(theme.plotBackground, theme.text, 0.12), 1.0));
    painter.drawLines(edges);
}

} // namespace halbench::widgets
