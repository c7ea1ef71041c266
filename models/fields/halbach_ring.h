#pragma once

#include "control/base/random.h"
#include "models/fields/cuboid_magnet.h"

#include <vector>

namespace halbench::models {

/// How one bar differs from its nominal self.
struct BarDeviation {
    double remanence_ratio = 0.0; ///< relative
    double angle_rad = 0.0;       ///< turned about its own axis
};

/// Two-pole Halbach cylinder of equal bars: bar j sits at theta_j = 2 pi j/N on radius R_m, turned and
/// magnetised to 2 theta_j, which makes the inner field point along +x. Turning the rotor by psi turns
/// everything by psi. Source: resources/help/htm-theory.md sections 2, 4.2 and 4.3.
struct HalbachRing {
    int bars = 20;
    double radius_m = 33.71e-3; ///< nominal: corners of the bars inside diameter 76.4 mm
    Eigen::Vector3d halfSize_m{3.175e-3, 3.175e-3, 19.05e-3};
    double remanence_T = 1.0;
    std::vector<BarDeviation> deviations; ///< empty: all bars perfect; otherwise one for each bar
};

/// Scatter of manufacture, one standard deviation; 2 % and 1 degree are usual for stock bars in printed
/// slots.
struct RingScatter {
    double remanence_ratio = 0.02;
    double angle_rad = 0.017453292519943295;
};

/// The ring with newly drawn deviations.
HalbachRing scatteredRing(const HalbachRing& nominal, const RingScatter& scatter, Random& random);

/// The bars of the rotor at angle psi.
std::vector<CuboidMagnet> ringMagnets(const HalbachRing& ring, double psi_rad);

Eigen::Vector3d magnetsField_T(const std::vector<CuboidMagnet>& magnets, const Eigen::Vector3d& point_m);
Eigen::Vector2d longBarsField_T(const std::vector<CuboidMagnet>& magnets, const Eigen::Vector2d& point_m);

/// Centre field of N infinitely long thin rods of the bars' cross-section A: N B_r A / (2 pi R_m^2).
double rodsCentreField_T(const HalbachRing& ring);

/// Uniform field inside the ideal two-dimensional cylinder: B = B_re ln(R_o / R_i). For a ring of separate
/// bars B_re is the remanence averaged over the whole annulus.
double idealCylinderField_T(double averageRemanence_T, double outerRadius_m, double innerRadius_m);

/// Share of the annulus R_i ... R_o that the bars fill.
double magnetAreaFraction(const HalbachRing& ring, double outerRadius_m, double innerRadius_m);

/// Whether neighbouring bars would occupy the same space.
bool doBarsOverlap(const HalbachRing& ring);

} // namespace halbench::models
