#pragma once

#include "models/planar/planar_geometry.h"
#include "widgets/theme/theme.h"

#include <QImage>
#include <QPointF>
#include <QSize>

#include <Eigen/Core>

namespace halbench::widgets {

/// Places in the lattice frame to logical pixels, y upwards.
struct MapScale {
    QPointF origin_px;            ///< of the lattice's origin
    double pixels_per_m = 1000.0; ///< positive

    QPointF at(const Eigen::Vector2d& place_m) const {
        return {origin_px.x() + pixels_per_m * place_m.x(), origin_px.y() - pixels_per_m * place_m.y()};
    }
    Eigen::Vector2d placeOf_m(const QPointF& point_px) const {
        return {(point_px.x() - origin_px.x()) / pixels_per_m, (origin_px.y() - point_px.y()) / pixels_per_m};
    }
    bool operator==(const MapScale&) const = default;
};

constexpr double MatrixEdge_pitches = 6.0; ///< of the magnet matrix, published machine

/// Height of the coil plane, the middle of the windings.
double coilPlane_m(const models::PlanarGeometry& geometry);

/// Largest B_z in the coil plane: full colour of the map.
double largestField_T(const models::PlanarGeometry& geometry);

/// Colour of B_z as a share of the largest, -1 to 1.
QColor fieldColour(const Theme& theme, double share);

/// Colour map of B_z in the coil plane with the blocks of the magnet matrix and their directions, kept as an
/// image until scale, size or colours change. Thread: GUI.
class LatticeMap {
public:
    /// `size_px` in logical pixels, `ratio` device pixels to one of these.
    const QImage& image(const models::PlanarGeometry& geometry, const MapScale& scale, const QSize& size_px,
                        double ratio, const Theme& theme);

private:
    void paintField(const models::PlanarGeometry& geometry, const Theme& theme);
    void paintBlocks(const models::PlanarGeometry& geometry, const Theme& theme);

    MapScale m_scale;
    double m_pitch_m = 0.0;
    QColor m_background;
    QImage m_image;
};

} // namespace halbench::widgets
