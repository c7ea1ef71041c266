#pragma once

#include "widgets/actuators/planar/lattice_map.h"
#include "widgets/actuators/planar/platen_state.h"
#include "widgets/theme/theme.h"

#include <QRectF>

#include <Eigen/Core>
#include <vector>

class QPainter;

namespace halbench::widgets {

/// Parts of the picture of the platen over the magnet matrix, each painted where `scale` says.
struct PlatenDrawing {
    QPainter& painter;
    const Theme& theme;
    MapScale scale;
    const PlatenSettings& settings;
    bool isStale = false;

    /// Body, and coils inked by current with arrows of its direction; `current_A` may be unknown.
    void platen(const PlatenReadings& readings) const;
    /// Outline of the platen at another pose: its reference.
    void ghost(const models::PlanarPose& pose) const;
    /// True place of the platen's origin in a simulation.
    void truth(const models::PlanarPose& pose) const;
    /// Chips with the field that they read and, magnified, what of it the pose does not explain.
    void chips(const PlatenReadings& readings) const;
    /// Force of each set and the sum.
    void forces(const PlatenForces& forces) const;
    /// Pitch cell that the platen's origin is in.
    void cell(const models::PlanarPose& pose) const;
    /// Window of the platen's origin about where the mode began.
    void window(const models::PlanarPose& origin) const;
    void path(const std::vector<Eigen::Vector2d>& places_m) const;
};

/// Factor of the residual's arrow over that of the field.
constexpr double ResidualMagnification = 50.0;
/// Factor of the inset over the map.
constexpr double ErrorMagnification = 1000.0;

/// Errors of the position loop, reference minus pose: x m, y m, phi rad.
struct ErrorInset {
    std::optional<Eigen::Vector3d> error; ///< none: nothing is controlled
    std::vector<Eigen::Vector3d> recent;
    double pixels_per_m = 1000.0; ///< of the map
};

/// The error of the pose about its reference, a thousand times as large as on the map; turned likewise.
void drawErrorInset(QPainter& painter, const Theme& theme, const QRectF& place, const ErrorInset& inset,
                    bool isStale);

/// A length of 1, 2 or 5 times a power of ten that is at most this long.
double roundLength(double longest);

/// Meaning of the arrows and lines, at the upper right of a place; nothing where that is too small.
void drawMapKey(QPainter& painter, const Theme& theme, const QRectF& place, const PlatenReadings& readings);

/// Scale of lengths and of colours at the lower left of the map.
void drawMapLegend(QPainter& painter, const Theme& theme, const QRectF& map, const MapScale& scale,
                   const models::PlanarGeometry& geometry);

} // namespace halbench::widgets
