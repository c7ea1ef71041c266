#pragma once

#include "models/fields/magnet_matrix.h"
#include "models/planar/planar_pose.h"

#include <Eigen/Core>
#include <array>

namespace halbench::models {

/// One flat coil: its local axes u (along the long sides) and v are the platen's, turned by the heading.
struct PlanarCoil {
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero(); ///< in platen axes
    bool isAcross = false; ///< false: heading 0, u = x'; true: heading 90 degrees, u = y', v = -x'
    double sense = 1.0;    ///< +1: positive current runs counter-clockwise seen from above, -1: clockwise
};

/// Winding of every coil: turns around a window, with corners rounded about those of the window.
struct PlanarWinding {
    double width_m = 6.096e-3;            ///< a: 12 turns
    double height_m = 7.5946e-3;          ///< d: 13 layers
    double turnsPerWidth_1_m = 1968.50;   ///< lambda
    double layersPerHeight_1_m = 1711.74; ///< beta
};

/// Magnets and coils of the planar positioner, SI. Source: resources/help/planar-theory.md sections 2 and 3.
struct PlanarGeometry {
    MagnetMatrix matrix;
    PlanarWinding winding;
    double gap_m = 3.025e-3;  ///< z1: from the magnets to the underside of the coils
    double arm56_m = 44.4e-3; ///< c56: y' of coils 5 and 6

    double longStraight_m() const { return matrix.pitch_m - winding.width_m; }        ///< p
    double shortStraight_m() const { return 0.5 * matrix.pitch_m - winding.width_m; } ///< q
    /// x' of coils 1 ... 4 is -+3L/4; all gaps between neighbouring coils are equal.
    std::array<PlanarCoil, CoilCount> coils() const;
};

/// Height integral of order n over a coil: (-1)^k b_n(z1) (1 - e^(-n gamma d))/(n gamma), T m.
double coilHeightIntegral_Tm(const PlanarGeometry& geometry, int order);

} // namespace halbench::models
