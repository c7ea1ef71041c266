#pragma once

#include <Eigen/Core>
#include <array>

namespace halbench::models {

/// Flat matrix of permanent magnets: two Halbach arrays at right angles, one along x and one along y, in one
/// layer of blocks. Infinitely large: no edge effects. Frame: origin on the top face below a maximum of B_z,
/// x and y along the rows of blocks, z up. Source: resources/help/planar-theory.md sections 2 to 4.
struct MagnetMatrix {
    double pitch_m = 50.8e-3;       ///< L: period along x and along y
    double thickness_m = 12.7e-3;   ///< Delta: height of the blocks
    double magnetisation_T = 0.715; ///< mu_0 M_0: peak magnetisation of one array
};

/// Orders that matter for a coil: a Halbach array of four blocks a period has n = 4k + 1 only, and the height
/// of a winding averages the next one, 13, away.
constexpr std::array<int, 3> MatrixOrders = {1, 5, 9};
constexpr int MatrixOrderCount = static_cast<int>(MatrixOrders.size());

/// gamma = 2 pi/L
double waveNumber_per_m(const MagnetMatrix& matrix);

/// Amplitude of order n = 4k + 1 at height z >= 0, with its sign:
///   (-1)^k b_n(z),   b_n(z) = (2 sqrt(2) mu_0 M_0/(pi n)) (1 - e^(-n gamma Delta)) e^(-n gamma z).
double harmonicAmplitude_T(const MagnetMatrix& matrix, int order, double height_m);

/// B_z = sum (-1)^k b_n [cos(n gamma x) + cos(n gamma y)], B_x = sum (-1)^k b_n sin(n gamma x), B_y likewise
/// in y, over the first `count` orders 1, 5, 9, ... The plus signs follow from div B = 0 and curl B = 0.
Eigen::Vector3d matrixField_T(const MagnetMatrix& matrix, const Eigen::Vector3d& point_m,
                              int count = MatrixOrderCount);

/// Column j = dB/dx_j; symmetric and without trace, as a field without sources must be.
Eigen::Matrix3d matrixFieldGradient_T_per_m(const MagnetMatrix& matrix, const Eigen::Vector3d& point_m,
                                            int count = MatrixOrderCount);

} // namespace halbench::models
