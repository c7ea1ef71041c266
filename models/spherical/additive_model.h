#pragma once

#include "models/spherical/orientation.h"
#include "models/spherical/rotor_field.h"

namespace halbench::models {

/// The published sensor model with additive angles ("paper"), A = alpha - da, B = beta - db, G = gamma - dg:
///   R     = 3 q cos 2G cos^2 B
///   Theta = -q cos 2G sin 2B cos A + 2 q sin 2G cos B sin A
///   Phi   = -q cos 2G sin 2B sin A - 2 q sin 2G cos B cos A
/// Exact for the main sensor (0, 0, 0). For any other it is no physical sensor: no fixed rotation makes the
/// angles subtract. Kept for reproduction and crossed comparisons.
/// Source: resources/help/spherical-theory.md section 4.
struct AdditiveModel {
    double strength_T = 0.0991864782; ///< q, at the sensors' radius
    SensorTriple placement = publishedPlacement();
};

SphericalReadings additiveReadings_T(const AdditiveModel& model, const OrientationAngles& angles);

/// Readings and their derivatives with respect to (alpha, beta, gamma), T/rad.
SphericalReadings additiveReadingsAndJacobian(const AdditiveModel& model, const OrientationAngles& angles,
                                              OrientationJacobian& jacobian_T_per_rad);

} // namespace halbench::models
